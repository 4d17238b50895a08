#include "ui/controllers/preference_controller.h"

#include <QActionGroup>

#include "ui/controllers/preferences_dialog.h"
#include "ui/document/journal.h"
#include "ui/view/scene_view.h"

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
            .flies = of.value(Preferred::Flight) == 0,
            .lags = of.value(Preferred::Lag) == 1};
}

Journal::Pace preferredPace() {
    const Preferences& of = Preferences::instance();
    return {.milliseconds = int(1000 * of.value(Preferred::JournalTime)),
            .edits = int(of.value(Preferred::JournalEdits))};
}

} // namespace

PreferenceController::PreferenceController(const Workbench& bench, Journal& journal)
    : QObject(&bench.window), bench_(bench), journal_(journal) {
    bench.on("preferences", this, [this] { showPreferences(&bench_.window); });
    connect(&Preferences::instance(), &Preferences::changed, this, &PreferenceController::follow);
    for (const Preferred id : {Preferred::DragTurns, Preferred::JournalTime})
        follow(id);
    connectTheme();
}

void PreferenceController::follow(Preferred id) {
    switch (id) {
    case Preferred::Theme:
        return setTheme(rememberedTheme());
    case Preferred::JournalTime:
    case Preferred::JournalEdits:
        return journal_.setPace(preferredPace());
    default:
        return bench_.view.setManners(preferredManners());
    }
}

void PreferenceController::connectTheme() {
    auto* group = new QActionGroup(this);
    for (const auto& [id, choice] : kThemes) {
        group->addAction(&bench_.actions[id]);
        bench_.actions[id].setChecked(choice == rememberedTheme());
        connect(&bench_.actions[id], &QAction::triggered, this,
                [choice = choice] { Preferences::instance().set(Preferred::Theme, int(choice)); });
    }
}

void PreferenceController::setTheme(ThemeChoice choice) {
    for (const auto& [id, each] : kThemes)
        bench_.actions[id].setChecked(each == choice);
    applyTheme(choice);
    bench_.actions.refreshIcons();
    bench_.view.setTheme(theme().dark);
    emit themeChanged();
}

} // namespace tactum
