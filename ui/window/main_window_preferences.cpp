// What a person prefers, brought to where it counts.
#include "ui/window/main_window.h"

#include <QActionGroup>

#include "ui/base/preferences.h"
#include "ui/document/journal.h"
#include "ui/document/recent_files.h"
#include "ui/panels/start_page.h"
#include "ui/view/scene_view.h"
#include "ui/window/preferences_dialog.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, ThemeChoice> kThemes[] = {{"theme-dark", ThemeChoice::Dark},
                                                           {"theme-light", ThemeChoice::Light},
                                                           {"theme-system", ThemeChoice::System}};

CameraManners preferredManners() {
    using Drag = CameraManners::Drag;
    const Preferences& of = Preferences::instance();
    const auto drag = of.choice<DragTurns>(Preferred::DragTurns);
    const bool away = of.choice<WheelAway>(Preferred::WheelAway) == WheelAway::Nearer;
    return {.middle = drag == DragTurns::MiddleTurns ? Drag::Orbit : Drag::Pan,
            .right = drag == DragTurns::RightTurns ? Drag::Orbit : Drag::None,
            .turnSpeed = of.value(Preferred::TurnSpeed),
            .zoomSpeed = (away ? 1 : -1) * of.value(Preferred::ZoomSpeed),
            .zoomToCursor = of.choice<ZoomTo>(Preferred::ZoomTo) == ZoomTo::Cursor,
            .flies = of.value(Preferred::Flight) == 0};
}

Journal::Pace preferredPace() {
    const Preferences& of = Preferences::instance();
    return {.milliseconds = int(1000 * of.value(Preferred::JournalTime)),
            .edits = int(of.value(Preferred::JournalEdits))};
}

} // namespace

void MainWindow::connectPreferences() {
    connect(&actions_["preferences"], &QAction::triggered, this, [this] { showPreferences(this); });
    connect(&Preferences::instance(), &Preferences::changed, this, &MainWindow::followPreference);
    for (const Preferred id : {Preferred::DragTurns, Preferred::JournalTime})
        followPreference(id);
}

void MainWindow::followPreference(Preferred id) {
    switch (id) {
    case Preferred::Theme:
        return setTheme(rememberedTheme());
    case Preferred::JournalTime:
    case Preferred::JournalEdits:
        return journal_->setPace(preferredPace());
    default:
        return view_->setManners(preferredManners());
    }
}

void MainWindow::connectTheme() {
    auto* group = new QActionGroup(this);
    for (const auto& [id, choice] : kThemes) {
        group->addAction(&actions_[id]);
        actions_[id].setChecked(choice == rememberedTheme());
        connect(&actions_[id], &QAction::triggered, this,
                [choice = choice] { Preferences::instance().set(Preferred::Theme, int(choice)); });
    }
}

void MainWindow::setTheme(ThemeChoice choice) {
    for (const auto& [id, each] : kThemes)
        actions_[id].setChecked(each == choice);
    applyTheme(choice);
    actions_.refreshIcons();
    start_->setRecent(recentFiles());
    view_->setTheme(theme().dark);
}

} // namespace tactum
