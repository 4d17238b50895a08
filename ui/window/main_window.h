// The window: puts view, panels and commands together around a document and an engine.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QMainWindow>
#include <QTimer>

#include "core/port/hand_target.h"
#include "core/runtime/engine.h"
#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/controllers/docks.h"
#include "ui/controllers/workbench.h"
#include "ui/document/document.h"
#include "ui/engine/world_publisher.h"
#include "ui/view/scene_picker.h"

class QMenu;
class QStackedWidget;

namespace tactum {

class Arming;
class ArrangeTool;
class CamerasMenu;
class CompareController;
class Comparison;
class ConnectionBar;
class DeviceCatalogue;
class DeviceController;
class SelfTestController;
class DeviceLink;
class EditNotice;
class Folds;
class DevicePanel;
class FeltController;
class GuardWatch;
class HandLink;
class HealthController;
class ImportBar;
class Journal;
class LayerController;
class NoticeBar;
class PaintTool;
class PartsController;
class Playback;
class PlaybackBar;
class PresentationController;
class PresetController;
class RecordingSaver;
class SelectController;
class SelectionSetsMenu;
class ToolStrip;
class SharedLink;
class SharedScene;
class Recovery;
class RecoveryBar;
class RoomController;
class RumbleLink;
class SaveController;
class SceneView;
class SoundLink;
class Stage;
class StartPage;
class StatusStrip;
class StudyController;
class StudyDesk;
class StudyPage;
class StudySession;
class TrialController;
class TouchHint;

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
    StudyDesk& studyDesk();
    StudySession& study();
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
    void makeToolBars();
    void refreshMore();
    void makeMenus();
    void fillRecent(QMenu* menu);
    void connectFile();
    void connectEdit();
    void connectView();
    void makeControllers();
    void makeLive();
    void connectDocument();
    void restore();

    void follow(const SceneChange& change);
    void showOpened();
    void offerHint();
    void askForFile();
    void savePicture();
    void frame();
    void playFrame();
    void sayRecorded(const QString& file, bool afterFault);
    void showTouched(const World* world, const Scene& scene);
    void selectTouched();
    void connectSelecting();
    void pick(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    void showHovered();
    void connectParts();
    void connectToServer(); ///< main_window_shared.cpp
    void drawTrace();
    void playTouch(const std::vector<TracePoint>& points, double rate);
    std::optional<WithoutStyleSheet> plain_{std::in_place}; ///< until all of the window is made
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
    StudyPage* studyPage_;
    SoundLink* sound_;
    RumbleLink* rumble_;
    DeviceLink* link_;
    EditNotice* told_;
    Workbench bench_; ///< of the controllers below
    Arming* arming_;
    Stage* stage_;
    SaveController* save_;
    PartsController* parts_ = nullptr;
    RoomController* room_ = nullptr;
    StudyController* study_ = nullptr;
    TrialController* trial_ = nullptr;
    DeviceController* devices_ = nullptr;
    SelfTestController* selfTest_ = nullptr;
    HealthController* health_ = nullptr;
    LayerController* layers_ = nullptr;
    CompareController* compare_ = nullptr;
    PresetController* presets_ = nullptr;
    SelectController* selecting_ = nullptr;
    SelectionSetsMenu* sets_ = nullptr;
    CamerasMenu* cameras_ = nullptr;
    FeltController* felt_ = nullptr;
    PresentationController* presentation_ = nullptr;
    DevicePanel* devicePanel_ = nullptr;
    Docks docks_;
    QStringList samples_; ///< scenes to begin with, never written over
    Folds* folds_ = nullptr;
    std::uint64_t shownShape_ = 0;      ///< of the recorded scene in the view
    bool leaving_ = false;              ///< the person has agreed to close the window
    std::vector<TracePoint> trace_;     ///< of this frame
    std::optional<SurfaceRef> touched_; ///< last, of the document
    std::optional<SurfaceRef> hovered_; ///< under the mouse, of the document
    QString touchedName_;               ///< in this frame; empty: nothing is touched
    QTimer frames_;
};

} // namespace tactum
