// ForceGate and health in the window: what a fault does, and who may render above the ceiling.
#include <QSettings>

#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/health_words.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/inspector.h"
#include "ui/panels/status_strip.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

namespace tactum {

namespace {

constexpr int kFramesPerDisplay = 6; // more often nobody reads figures

QString armAgain() {
    return MainWindow::tr("Arm again");
}
QString openAgain() {
    return MainWindow::tr("Open again");
}

QString deadManKey() {
    return QStringLiteral("device/deadMan");
}

} // namespace

void MainWindow::connectHealth() {
    connect(guard_, &GuardWatch::faulted, this, [this](InhibitReason why) {
        offerToArm();
        if (why == InhibitReason::DeviceLost) link_->look(); // whether it is there at all
    });
    connect(guard_, &GuardWatch::happened, this, [this] {
        if (!playback_->active()) docks_.health->setEvents(guard_->events());
    });
    connect(status_, &StatusStrip::armPressed, this, [this] { setArmed(true); });
    connect(docks_.health, &HealthPanel::overrideAsked, this, &MainWindow::askToOverride);
    connect(&actions_["dead-man"], &QAction::triggered, this, &MainWindow::setDeadMan);
    restoreDeadMan();
    displayHealth();
}

void MainWindow::watchHealth() {
    guard_->frame();
    // Nobody arms while a recording is shown.
    const auto fault = playback_->active() ? std::nullopt : guard_->fault();
    status_->setFault(fault ? guardSentences(*fault) : QString());
    status_->setQuietNote(guard_->quietNote());
    if (++healthFrames_ < kFramesPerDisplay) return;
    healthFrames_ = 0;
    displayHealth();
}

void MainWindow::displayHealth() {
    if (playback_->active()) return displayRecordedHealth();
    const bool overridden = engine_.overridesCeiling();
    const CeilingNow& ceiling = guard_->ceiling();
    docks_.inspector->setCeiling(ceiling, overridden);
    if (docks_.health->visibleRegion().isEmpty()) return; // behind another tab, for instance
    docks_.health->display(engine_.servo(), engine_.proxy(), engine_.device());
    docks_.health->displayCeiling(ceiling, stiffestOf(document_.scene()), overridden);
}

void MainWindow::displayRecordedHealth() {
    Player& player = playback_->player();
    const DeviceInfo& device = player.run().device;
    const ServoRow* tick = player.servoRow();
    const bool overridden = tick && (tick->flags & ServoRow::Override) != 0;
    const CeilingNow ceiling = ceilingNow(player.servo(), device);
    docks_.inspector->setCeiling(ceiling, overridden);
    if (docks_.health->visibleRegion().isEmpty()) return;
    docks_.health->display(player.servo(), player.proxy(), device);
    const World* world = player.world();
    docks_.health->displayCeiling(ceiling, world ? stiffestOf(*world->scene) : Stiffest{}, overridden);
    docks_.health->setEvents(playback_->eventsSoFar());
}

/// Of what is played from now on, or of the loops again.
void MainWindow::showHealthOf(bool recording) {
    docks_.health->setRecorded(recording);
    if (!recording) docks_.health->setEvents(guard_->events());
    displayHealth();
}

// How a person wants to hold the device belongs to neither the scene nor its history.
void MainWindow::restoreDeadMan() {
    QAction& action = actions_["dead-man"];
    if (engine_.device().buttons == 0) {
        action.setEnabled(false);
        action.setToolTip(tr("This device has no button that could be held"));
        return;
    }
    action.setEnabled(true);
    action.setToolTip(
        tr("Force only while a button of the device is held. Of the simulated hand: while the mouse "
           "holds the finger"));
    action.setChecked(QSettings().value(deadManKey()).toBool());
    engine_.setDeadMan(action.isChecked());
}

void MainWindow::setDeadMan(bool on) {
    engine_.setDeadMan(on);
    QSettings().setValue(deadManKey(), on);
}

void MainWindow::offerToArm(const QString& more) {
    showArmed(false);
    const bool lost = *guard_->fault() == InhibitReason::DeviceLost;
    const QString trouble = lost ? QString::fromStdString(engine_.trouble()) : QString();
    const QString text =
        QStringLiteral("%1 %2 %3").arg(guardSentences(*guard_->fault()), trouble, more).simplified();
    // What its driver cannot get over by itself no arming brings back.
    if (!trouble.isEmpty() && link_->connected())
        notice_->offer(text, QStringLiteral("error"), openAgain(),
                       [this] { link_->choose(link_->current()); });
    else
        notice_->offer(text, QStringLiteral("error"), armAgain(), [this] { setArmed(true); });
}

/// Another device came or went: what is offered is of the one before.
void MainWindow::withdrawArming() {
    for (const QString& button : {armAgain(), openAgain(), tr("Arm")})
        notice_->withdraw(button);
}

void MainWindow::askToOverride(bool on) {
    if (!on || riskAccepted_) {
        engine_.setOverrideCeiling(on);
        return displayHealth();
    }
    notice_->offer(
        tr("Above the ceiling the device may shake or push your hand away. Hold it firmly, and keep "
           "Esc in reach: held for half a second it ends all force."),
        QStringLiteral("warning"), tr("I take the risk"), [this] {
            riskAccepted_ = true;
            engine_.setOverrideCeiling(true);
            displayHealth();
        });
}

} // namespace tactum
