// Studies in the window: the dock and its commands, and the page that a participant sees instead of
// everything else.
#pragma once

#include <functional>
#include <vector>

#include <QObject>

#include "core/runtime/trace_point.h"
#include "ui/controllers/workbench.h"

namespace tactum {

class Arming;
class HandLink;
class Stage;
class StudyDesk;
class StudyPage;
class StudyPanel;
class StudySession;
struct StudyStart;

/// Thread: ui.
class StudyController : public QObject {
    Q_OBJECT
public:
    /// Adds the dock beside that of the health. The page lies over the centre of the window.
    StudyController(const Workbench& bench, Arming& arming, Stage& stage, HandLink& hand, StudyPage& page);

    StudyDesk& desk() { return *desk_; }
    StudySession& session() { return *study_; }
    bool running() const;
    /// Whether the window must not close yet; then it says why, and closes it when the person goes on.
    bool keepsOpen();
    /// Once a frame while running, instead of all else that is drawn.
    void frame();
    /// Brings the commands to what can be done now.
    void showCommands();

signals:
    /// A run is about to begin: nothing else may be felt.
    void begins();
    /// The author's scene is felt again.
    void ended();

private:
    void connectCommands();
    void connectPage();
    void connectSession();
    void leave(std::function<void()> goOn);
    void askForFile();
    void save(std::function<void()> after);
    void keepState();
    void edit();
    void askToRun();
    void begin(const StudyStart& start);
    void hideAll();
    void showAll();
    void end();
    void arm();
    void proceed();
    void showStep();

    Workbench bench_;
    Arming& arming_;
    Stage& stage_;
    HandLink& hand_;
    StudyPage& page_;
    StudyDesk* desk_;
    StudySession* study_;
    StudyPanel* panel_;
    std::vector<TracePoint> trace_; ///< of this frame
    std::vector<QAction*> off_;     ///< commands that come back when the run ends,
    std::vector<QWidget*> hid_;     ///< and bars
    bool hidPanels_ = false;        ///< the study did, not the person
    QString title_;                 ///< of the window, while a run shows none
};

} // namespace tactum
