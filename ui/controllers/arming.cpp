#include "ui/controllers/arming.h"

#include <functional>

#include <QEvent>

#include "core/runtime/engine.h"
#include "ui/engine/device_link.h"
#include "ui/engine/guard_watch.h"
#include "ui/engine/health_words.h"
#include "ui/engine/held_key.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr int kHoldToStop = 500; // ms

QString armAgain() {
    return Arming::tr("Arm again");
}

QString openAgain() {
    return Arming::tr("Open again");
}

/// Does something when a dialog takes the mouse and the keys from a window.
class WhenBlocked : public QObject {
public:
    WhenBlocked(QObject& window, std::function<void()> act, QObject* parent)
        : QObject(parent), act_(std::move(act)) {
        window.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::WindowBlocked) act_();
        return false;
    }

private:
    std::function<void()> act_;
};

} // namespace

Arming::Arming(Engine& engine, Actions& actions, SceneView& view, NoticeBar& notice, GuardWatch& guard,
               DeviceLink& link, QObject* parent)
    : QObject(parent), hands_(engine), actions_(actions), view_(view), notice_(notice), guard_(guard),
      link_(link) {
    connect(&actions["armed"], &QAction::triggered, this, &Arming::set);
    connect(&actions["stop"], &QAction::triggered, this, [this] { set(false); });
    connect(new HeldKey(Qt::Key_Escape, kHoldToStop, this), &HeldKey::held, this, [this] { set(false); });
    new WhenBlocked(
        *parent, [this] { view_.endTouch(); }, this); // the button's release goes elsewhere
    connect(&guard, &GuardWatch::faulted, this, [this](InhibitReason why) {
        offer();
        if (why == InhibitReason::DeviceLost) link_.look(); // whether it is there at all
    });
    show();
}

bool Arming::faulty() const {
    return guard_.fault().has_value();
}

/// What its driver cannot get over by itself no arming brings back.
std::optional<std::size_t> Arming::brokenHand() const {
    const auto hand = guard_.faultyHand();
    const bool broken = hand && *guard_.fault() == InhibitReason::DeviceLost && link_.leadsItself(*hand) &&
                        !hands_.trouble(*hand).empty();
    return broken ? hand : std::nullopt;
}

QString Arming::again() const {
    return brokenHand() ? openAgain() : armAgain();
}

void Arming::set(bool armed) {
    const bool wasFaulty = faulty();
    if (armed) link_.letGoOfLost(); // what is not there would only be a fault again
    if (const auto broken = brokenHand(); armed && broken) {
        link_.choose(link_.idOf(*broken));
        return show();
    }
    if (armed)
        for (std::size_t hand = 0; hand < hands_.count(); ++hand)
            link_.stop(hand).pressed = false; // held still, it stops again at once
    if (!armed) view_.endTouch();
    guard_.setArmed(armed);
    show();
    if (!armed && !wasFaulty)
        notice_.showNote(tr("Stopped: the device gets no force. Device > Forces on goes on."));
    else if (armed && (wasFaulty || notice_.property("severity") == QLatin1String("note")))
        notice_.hide();
}

void Arming::switchOff() {
    guard_.setArmed(false);
    show();
}

void Arming::switchOn() {
    guard_.setArmed(true);
    show();
}

void Arming::show() {
    const bool armed = hands_.anyArmed();
    actions_["armed"].setChecked(armed);
    actions_["stop"].setEnabled(armed);
}

void Arming::offer(const QString& more) {
    show();
    const std::size_t hand = *guard_.faultyHand();
    const bool lost = *guard_.fault() == InhibitReason::DeviceLost;
    const QString trouble = lost ? QString::fromStdString(hands_.trouble(hand)) : QString();
    const QString text = QStringLiteral("%1 %2 %3").arg(guard_.faultSentences(), trouble, more).simplified();
    notice_.offer(text, QStringLiteral("error"), again(), [this] { set(true); });
}

void Arming::adoptDevice() {
    for (const QString& button : {armAgain(), openAgain(), tr("Arm")})
        notice_.withdraw(button);
    guard_.forget();
    show();
}

} // namespace tactum
