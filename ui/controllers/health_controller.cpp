#include "ui/controllers/health_controller.h"

#include <QSettings>

#include "core/runtime/hands.h"
#include "ui/controllers/arming.h"
#include "ui/document/document.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/health_words.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/inspector.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr int kFramesPerDisplay = 6; // more often nobody reads figures

QString deadManKey() {
    return QStringLiteral("device/deadMan");
}

} // namespace

HealthController::HealthController(const Workbench& bench, Arming& arming, GuardWatch& guard,
                                   HealthPanel& panel, Inspector& inspector, StatusStrip& status)
    : QObject(&bench.window), bench_(bench), arming_(arming), guard_(guard), panel_(panel),
      inspector_(inspector), status_(status) {
    connect(&guard, &GuardWatch::happened, this, [this] {
        if (!bench_.playback.active()) panel_.setEvents(guard_.events());
    });
    connect(&status, &StatusStrip::armPressed, this, [this] { arming_.set(true); });
    connect(&status, &StatusStrip::stopPressed, this, [this] { arming_.set(false); });
    connect(&panel, &HealthPanel::overrideAsked, this, &HealthController::askToOverride);
    bench.on("dead-man", this, [this](bool on) { setDeadMan(on); });
    adoptDevice();
}

void HealthController::adoptDevice() {
    riskAccepted_ = false;
    restoreDeadMan();
    display();
}

void HealthController::frame() {
    guard_.frame();
    // Nobody arms while a recording is shown.
    const auto fault = bench_.playback.active() ? std::nullopt : guard_.fault();
    status_.setFault(fault ? guard_.faultSentences() : QString(), arming_.again());
    status_.setQuietNote(guard_.quietNote());
    if (++frames_ < kFramesPerDisplay) return;
    frames_ = 0;
    display();
}

void HealthController::display() {
    if (bench_.playback.active()) return displayRecorded();
    const bool overridden = bench_.engine.overridesCeiling();
    const CeilingNow& ceiling = guard_.ceiling();
    inspector_.setCeiling(ceiling, overridden);
    if (panel_.visibleRegion().isEmpty()) return; // behind another tab, for instance
    panel_.display(bench_.engine.servo(), bench_.engine.proxy(), bench_.engine.device());
    panel_.displayCeiling(ceiling, stiffestOf(bench_.document.scene()), overridden);
}

void HealthController::displayRecorded() {
    Player& player = bench_.playback.player();
    const std::size_t hand = bench_.playback.hand();
    const DeviceInfo& device = player.run().hand(hand).device;
    const ServoRow* tick = player.servoRow(hand);
    const bool overridden = tick && (tick->flags & ServoRow::Override) != 0;
    const CeilingNow ceiling = ceilingNow(player.servo(hand), device);
    inspector_.setCeiling(ceiling, overridden);
    if (panel_.visibleRegion().isEmpty()) return;
    panel_.display(player.servo(hand), player.proxy(), device);
    const World* world = player.world();
    panel_.displayCeiling(ceiling, world ? stiffestOf(*world->scene) : Stiffest{}, overridden);
    panel_.setEvents(bench_.playback.eventsSoFar());
}

/// Of what is played from now on, or of the loops again.
void HealthController::showOf(bool recording) {
    panel_.setRecorded(recording);
    if (!recording) panel_.setEvents(guard_.events());
    display();
}

// How a person wants to hold the device belongs to neither the scene nor its history.
void HealthController::restoreDeadMan() {
    QAction& action = bench_.actions["dead-man"];
    Hands hands(bench_.engine);
    int buttons = 0;
    for (std::size_t hand = 0; hand < hands.count(); ++hand)
        buttons += hands.device(hand).buttons;
    bench_.actions.allow("dead-man",
                         buttons > 0 ? QString() : tr("This device has no button that could be held."));
    if (buttons == 0) return;
    action.setChecked(QSettings().value(deadManKey()).toBool());
    hands.setDeadMan(action.isChecked());
}

void HealthController::setDeadMan(bool on) {
    Hands(bench_.engine).setDeadMan(on);
    QSettings().setValue(deadManKey(), on);
}

void HealthController::askToOverride(bool on) {
    if (!on || riskAccepted_) {
        bench_.engine.setOverrideCeiling(on);
        return display();
    }
    bench_.notice.offer(
        tr("Above the ceiling the device may shake or push your hand away. Hold it firmly, and keep "
           "Esc in reach: held for half a second it ends all force."),
        QStringLiteral("warning"), tr("I take the risk"), [this] {
            riskAccepted_ = true;
            bench_.engine.setOverrideCeiling(true);
            display();
        });
}

} // namespace tactum
