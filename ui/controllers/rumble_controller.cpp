#include "ui/controllers/rumble_controller.h"

#include <utility>

#include <QActionGroup>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "ui/base/mnemonics.h"
#include "ui/base/words.h"
#include "ui/controllers/kept_names.h"
#include "ui/rumble/rumble_link.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

const auto kOnKey = QStringLiteral("gamepad/on"), kPadKey = QStringLiteral("gamepad/pad");

} // namespace

RumbleController::RumbleController(const Workbench& bench, RumbleLink& link)
    : QObject(&bench.window), bench_(bench), rumble_(link) {
    auto* menu = bench.window.menuBar()->findChild<QMenu*>(QStringLiteral("Device/&Gamepad"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(*menu); });
    connect(&link, &RumbleLink::padsChanged, this, &RumbleController::tellPads);
    connect(qApp, &QGuiApplication::applicationStateChanged, this,
            [this](Qt::ApplicationState state) { rumble_.setAttended(state == Qt::ApplicationActive); });
    connect(&Preferences::instance(), &Preferences::changed, this, &RumbleController::follow);
    follow(Preferred::Vibration);
    const QSettings kept;
    link.choose(kept.value(kPadKey).toString().toStdString());
    QAction& command = bench.actions["rumble"];
    connect(&command, &QAction::toggled, this, &RumbleController::setOn);
    quiet_ = true;
    command.setChecked(kept.value(kOnKey).toBool());
    connect(&command, &QAction::triggered, this, [this] { quiet_ = false; });
}

void RumbleController::setOn(bool on) {
    QSettings().setValue(kOnKey, on);
    used_.reset();
    rumble_.setOn(on);
}

void RumbleController::follow(Preferred id) {
    if (id == Preferred::Vibration) rumble_.setStrength(Preferences::instance().value(id));
}

void RumbleController::choose(const Pad& pad) {
    QSettings().setValue(kPadKey, QString::fromStdString(pad.key));
    rumble_.choose(pad.key);
    tellPads();
}

// Anew each time: gamepads come and go.
void RumbleController::fill(QMenu& menu) {
    menu.clear();
    menu.addAction(&bench_.actions["rumble"]);
    menu.addSeparator();
    auto* group = new QActionGroup(&menu);
    const auto used = rumble_.used();
    for (const Pad& pad : rumble_.pads()) {
        QAction* entry = menu.addAction(inMenu(asIs(pad.name)), this, [this, pad] { choose(pad); });
        entry->setCheckable(true);
        entry->setChecked(pad == used);
        group->addAction(entry);
    }
    if (!used)
        menu.addAction(rumble_.on() ? tr("No gamepad that vibrates is connected")
                                    : tr("Gamepads are looked for while this is on"))
            ->setEnabled(false);
    giveMnemonics(menu);
}

void RumbleController::tellPads() {
    const auto before = std::exchange(used_, rumble_.used());
    if (std::exchange(quiet_, false) || (before && before == used_)) return;
    const QString gone = before ? asIs(before->name) : QString(), now = used_ ? asIs(used_->name) : QString();
    if (!used_)
        bench_.notice.showNote(
            before ? tr("%1 is gone: nothing vibrates until a gamepad is connected.").arg(gone)
                   : tr("No gamepad that vibrates is connected; one that is plugged in vibrates at once."));
    else
        bench_.notice.showNote(tr("%1 vibrates with what is felt.").arg(now));
}

} // namespace tactum
