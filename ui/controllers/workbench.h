// What the controllers of the window work with: each has one concern, and none knows the window's class or
// another controller.
#pragma once

#include <utility>

#include <QAction>
#include <QMainWindow>

#include "ui/base/shortcuts.h"

class QBoxLayout;
class QDockWidget;

namespace tactum {

class Document;
class EditNotice;
class Engine;
class NoticeBar;
class Playback;
class SceneView;
class WorldPublisher;

/// Plain references, copied by who keeps them; what they lead to outlives every controller. Thread: ui.
struct Workbench {
    QMainWindow& window; ///< parent of dialogs, home of docks
    Document& document;
    Engine& engine;
    WorldPublisher& publisher;
    Actions& actions;
    SceneView& view;
    NoticeBar& notice;
    EditNotice& told;   ///< what the notices say of the last edit
    Playback& playback; ///< while it is active, a recording is seen in the document's place

    /// Does `act` whenever the command is chosen, as long as `whose` lives.
    template <class Act> void on(const char* command, QObject* whose, Act act) const {
        QObject::connect(&actions[command], &QAction::triggered, whose, std::move(act));
    }
    /// By its object name, "dock-health"; it must be there.
    QDockWidget& dock(const char* name) const;
    /// Where the rows of tools stand over the upper edge of the view.
    QBoxLayout& strips() const;
};

} // namespace tactum
