// The window: puts view, panels and commands together around a document and an engine.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QMainWindow>
#include <QPointer>
#include <QTimer>

#include "core/geometry/repair.h"
#include "core/port/hand_target.h"
#include "core/runtime/engine.h"
#include "ui/base/preferences.h"
#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/controllers/docks.h"
#include "ui/controllers/workbench.h"
#include "ui/document/document.h"
#include "ui/engine/device_settings.h"
#include "ui/engine/device_trial.h"
#include "ui/engine/world_publisher.h"
#include "ui/view/scene_picker.h"

class QDialog;
class QMenu;
class QStackedWidget;

namespace tactum {

class ArrangeTool;
class CompareController;
class Comparison;
class ConnectionBar;
class DeviceCatalogue;
class DeviceLink;
class Folds;
class DevicePanel;
class GuardWatch;
class HandLink;
class ImportBar;
class Journal;
class NoticeBar;
class PaintTool;
class Playback;
class PlaybackBar;
class Presentation;
class PresetController;
struct PaletteEntry;
class RecordingSaver;
class SelectController;
class SelectionSetsMenu;
class ToolStrip;
class SharedLink;
class SharedScene;
class Recovery;
class RecoveryBar;
class SceneView;
class SoundLink;
class StartPage;
class StatusStrip;
class StudyDesk;
class StudyPage;
class StudyPanel;
class StudySession;
struct StudyStart;
class TouchHint;
class UsbPermission;
class VideoRecorder;
struct Problem;

/// Thread: ui. Polls the engine sixty times a second. `hand` is empty for a device that leads itself.
class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// Document and engine outlive the window. `samples`: scenes for the start page.
    MainWindow(Document& document, Engine& engine, std::shared_ptr<HandTarget> hand,
               const QStringList& samples = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// What devices a person can choose from; it outlives the window. Without one the engine keeps its
    /// device.
    void setCatalogue(DeviceCatalogue& catalogue);
    /// The other side of an engine at a haptic server; it outlives the window.
    void setShared(SharedScene& shared);
    void open(const QString& file);
    /// One line above the view: what happened and how to go on.
    void showFault(const QString& sentence);
    SceneView& view() { return *view_; }
    Document& document() { return document_; }
    Journal& journal() { return *journal_; }
    Comparison& comparison();
    StudyDesk& studyDesk() { return *studyDesk_; }
    StudySession& study() { return *study_; }
    DeviceLink& devices() { return *link_; }
    /// Of a window that was never opened before, on a screen with so much room.
    static QSize firstSize(QSize room);
    const WorldPublisher& publisher() const { return publisher_; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeCentre();
    void makeToolBar();
    void makeMenus();
    void fillRecent(QMenu* menu);
    void connectTheme();
    void connectFile();
    void connectEdit();
    void connectView();
    void connectDevice();
    void connectMotion();
    void showColliders();
    void connectDocument();
    void connectProblems();
    void showPlace(ObjectId id, const Problem& problem);
    void restore();
    // Of what a person prefers: main_window_preferences.cpp.
    void connectPreferences();
    void followPreference(Preferred id);
    void setTheme(ThemeChoice choice);

    void follow(const SceneChange& change);
    void showOpened();
    void askForFile();
    void savePicture();
    // Of the room of the view: main_window_panels.cpp.
    void connectFolds();
    void restoreFolds();
    void saveFolds() const;
    void showPlots();
    void hidePanels(bool hidden);
    // Of showing a scene to others: main_window_showing.cpp.
    void connectShowing();
    void connectVideo();
    void recordVideo(bool on);
    void present(bool on);
    void writeReport(const QString& file);
    void setArmed(bool armed);
    void showArmed(bool armed);
    void frame();
    void showTouched(const World* world, const Scene& scene);
    void selectTouched();
    void connectSelecting();
    void pick(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    void showHovered();
    // Of moving, turning and scaling: main_window_arranging.cpp.
    void addPlaceDock();
    void connectArranging();
    void fillArrangeStrip();
    // Of surfaces and their normals: main_window_surfaces.cpp.
    void connectSurfaces();
    void setShading(const QString& text, const std::function<void(Shading&)>& change);
    void turnOverSelected();
    void repairSelected(const QString& text, Result<Repaired> (*how)(const SharedSoup&, const Progress&));
    // Of the brush: main_window_painting.cpp.
    void connectPainting();
    void fillPaintStrip(const QList<QAction*>& goals, const QList<QAction*>& modes);
    // Of texture layers: main_window_layers.cpp.
    void connectLayers();
    void connectMapping();
    void showLayerCommands();
    void showMapping();
    /// A picture that was dropped at a place of the window becomes a layer of what lies there.
    void dropPicture(const QString& file, QPointF place);
    // Of saving: main_window_saving.cpp.
    void connectSaving();
    void save();
    void saveAs();
    void askToOverwrite();
    void exportBundle();
    void exportReport();
    void showFile();
    /// Goes on when nothing would be lost by it, or when the person has saved or thrown away what would be.
    void leave(const QString& intent, std::function<void()> goOn);
    // Of what a file leaves open: main_window_import.cpp.
    void connectImport();
    std::optional<FileAxes> shownAxes() const;
    void takeOtherwise(const FileAxes& axes);
    void endAsking();
    void showImport();
    void keepFootFree();
    void showImportCommands(const TakenAs* taken);
    // Of objects that come, are doubled, and go: main_window_parts.cpp.
    void connectParts();
    void fillSamples(QMenu* menu);
    void askToAdd();
    void addFiles(const QStringList& files);
    void dropModels(const QStringList& files);
    void showAdded(const SceneAddition& addition);
    void removeSelected();
    void showObjectMenu(const QPoint& at, QWidget& over);
    // Of shapes that changed elsewhere: main_window_geometry.cpp.
    void connectGeometry();
    void askForGeometry();
    void updateGeometry(const std::filesystem::path& file);
    void offerUpdate();
    void showUpdated(const GeometryUpdate& update);
    void followTold(int step);
    void connectRecovery(); ///< main_window_recovery.cpp
    void connectToServer();
    void showCentre(); ///< main_window_shared.cpp
    // Of the command palette: main_window_palette.cpp.
    void connectPalette();
    void openPalette();
    QString whyNot(const QString& id) const;
    void addPanels(std::vector<PaletteEntry>& entries);
    void addSurfaces(std::vector<PaletteEntry>& entries);
    // Of studies: main_window_study.cpp.
    void addStudyDock();
    void connectStudy();
    void connectStudyPage();
    void showStudyCommands();
    void leaveStudy(std::function<void()> goOn);
    void askForStudy();
    void saveStudy(std::function<void()> after);
    void keepState();
    void editStudy();
    void askToRunStudy();
    void beginStudy(const StudyStart& start);
    void hideForStudy();
    void showAfterStudy();
    void endStudy();
    void armForStudy();
    void proceedStudy();
    void showStudyStep();
    void studyFrame();
    // Of recordings: main_window_playback.cpp.
    void connectRecordings();
    void saveRecording();
    void beginPlayback();
    void endPlayback();
    void setLive(bool live);
    void playFrame();
    // Of what is felt, seen and heard: main_window_felt.cpp.
    void connectFelt();
    void showFelt();
    void drawTrace();
    void exportPlot();
    void connectSound();
    void setSound(bool on);
    // Of guard and health: main_window_health.cpp.
    void connectHealth();
    void watchHealth();
    void displayHealth();
    void displayRecordedHealth();
    void showHealthOf(bool recording);
    void restoreDeadMan();
    void setDeadMan(bool on);
    void offerToArm(const QString& more = {});
    void withdrawArming();
    void askToOverride(bool on);
    // Of devices: main_window_device.cpp.
    void addDeviceDock();
    void connectDevices();
    void showDevicePage(int page);
    void adoptDevice();
    void setDeviceSettings(const DeviceSettings& settings);
    void showDeviceSettings();
    void setWorkspace(const Workspace& workspace);
    void centreWorkspace(bool fit);
    void watchDevice();
    void offerReady(const QString& name, bool back);
    void sayRequest();
    void sayAway(const QString& name, const QString& more = {});
    void showDeviceCommands();
    void switchOff();
    void beginTrial(Trial trial);
    void endTrial();
    void showOwnScene();
    void showTrial();

    Document& document_;
    Engine& engine_;
    WorldPublisher publisher_;
    Actions actions_;
    SceneView* view_;
    ToolStrip* selectStrip_;
    ArrangeTool* arranging_;
    ToolStrip* arrangeStrip_;
    PaintTool* painting_;
    ToolStrip* paintStrip_;
    NoticeBar* notice_;
    QStackedWidget* centre_;
    StartPage* start_;
    PlaybackBar* playbackBar_;
    ConnectionBar* connection_;
    ImportBar* importBar_;
    SharedLink* shared_ = nullptr; ///< null: the engine is here
    StatusStrip* status_;
    TouchHint* hint_;
    HandLink* hand_;
    GuardWatch* guard_;
    Playback* playback_;
    RecordingSaver* saver_;
    Journal* journal_;
    Recovery* recovery_;
    RecoveryBar* recoveryBar_;
    StudyDesk* studyDesk_;
    StudySession* study_;
    StudyPage* studyPage_;
    StudyPanel* studyPanel_ = nullptr;
    SoundLink* sound_;
    DeviceLink* link_;
    Workbench bench_; ///< of the controllers below
    CompareController* compare_ = nullptr;
    PresetController* presets_ = nullptr;
    SelectController* selecting_ = nullptr;
    SelectionSetsMenu* sets_ = nullptr;
    VideoRecorder* video_ = nullptr;
    Presentation* presentation_ = nullptr;
    bool panelsWereHidden_ = false; ///< before the presentation
    UsbPermission* permission_;
    DevicePanel* devicePanel_ = nullptr;
    DeviceSettings deviceSettings_; ///< of the device in the engine
    std::optional<Trial> trial_;    ///< that is felt instead of the document
    QString dropped_;               ///< the one model that is being added because it was dropped
    Docks docks_;
    std::optional<Feel> copied_; ///< to be pasted
    QStringList samples_;        ///< scenes to begin with, never written over
    QByteArray shownPanels_;     ///< the layout to come back to while all panels are hidden
    QStringList foldedPanels_;   ///< the same of what is folded
    Folds* folds_ = nullptr;
    /// Who says whether the plots are folded: nothing was felt yet, the hand is still there, they came by
    /// themselves, the person.
    enum class Plots { Empty, Due, Shown, AsDecided } plots_ = Plots::Empty;
    bool grabbed_ = false;              ///< the finger in the view
    std::uint64_t shownShape_ = 0;      ///< of the recorded scene in the view
    int healthFrames_ = 0;              ///< since the health was last displayed
    std::function<void()> afterSave_;   ///< what the person wanted to do next
    bool importSeen_ = false;           ///< the person has closed the import bar
    std::optional<FileAxes> asked_;     ///< as which the file is being read again
    QString fittedNote_;                ///< what was last noted of the document
    int toldStep_ = 0;                  ///< of the history after what is told of; 0: none
    QString told_;                      ///< what is told of it
    QPointer<QDialog> updateList_;      ///< what is not as before
    bool leaving_ = false;              ///< the person has agreed to close the window
    bool riskAccepted_ = false;         ///< of stiffness above the ceiling, until the program ends
    std::vector<TracePoint> trace_;     ///< of this frame
    std::optional<SurfaceRef> touched_; ///< last, of the document
    std::optional<SurfaceRef> hovered_; ///< under the mouse, of the document
    QString touchedName_;               ///< in this frame; empty: nothing is touched
    std::vector<QAction*> studyOff_;    ///< commands that come back when a study ends,
    std::vector<QWidget*> studyHid_;    ///< and bars
    bool studyHidPanels_ = false;       ///< the study did, not the person
    QTimer frames_;
};

} // namespace tactum
