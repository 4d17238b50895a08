#include "ui/engine/guard_watch.h"

#include <algorithm>
#include <utility>

#include "core/safety/inhibit_words.h"
#include "core/safety/motor_heat.h"
#include "ui/base/numbers.h"
#include "ui/engine/hand_name.h"
#include "ui/engine/health_words.h"

namespace tactum {

namespace {

constexpr std::size_t kKeptFaults = 100; // events
constexpr qint64 kShown = 2000;          // ms; the pause itself may be over within a tick
constexpr double kWarning = 0.5 * kWarmMotors, kCooled = 0.25 * kWarmMotors; // of the heat that motors bear

/// Whether a counter has risen; counters begin at zero anew when the engine does.
bool rose(std::uint64_t& known, std::uint64_t now) {
    return std::exchange(known, now) < now;
}

QString standstillWords() {
    return GuardWatch::tr(
        "The servo stands still: the device does not come back. Look at its cable and its power.");
}

QString warmWords() {
    return GuardWatch::tr(
        "The motors are getting warm: if you press on as hard, the largest force falls within "
        "seconds to what they bear for ever. Press less, or let them rest.");
}

} // namespace

GuardWatch::GuardWatch(Engine& engine, QObject* parent)
    : QObject(parent), engine_(engine), hands_(engine), faults_(hands_.count()),
      stepsDown_(engine.proxy().stepsDown) {
    clock_.start();
    begin();
    watchCeiling();
}

/// With the hand that the engine speaks of now.
void GuardWatch::begin() {
    const ServoTelemetry& servo = engine_.servo();
    watched_ = hands_.chosen();
    unread_ = servo.invalidSamples;
    pauses_ = servo.pauses;
    oscillations_ = servo.oscillations;
}

void GuardWatch::forget() {
    faults_.assign(hands_.count(), std::nullopt);
    watched_ = hands_.chosen();
    ceiling_.forget();
}

void GuardWatch::frame() {
    faults_.resize(hands_.count());
    if (watched_ != hands_.chosen()) {
        begin();
        ceiling_.forget();
    }
    for (std::size_t hand = 0; hand < faults_.size(); ++hand)
        watchFault(hand);
    watchPauses();
    watchProxy();
    watchCeiling();
}

void GuardWatch::setArmed(bool armed) {
    if (armed) faults_.assign(hands_.count(), std::nullopt);
    hands_.setAllArmed(armed);
}

std::optional<std::size_t> GuardWatch::faultyHand() const {
    const auto found = std::ranges::find_if(faults_, [](const auto& fault) { return fault.has_value(); });
    if (found == faults_.end()) return std::nullopt;
    return std::size_t(found - faults_.begin());
}

std::optional<InhibitReason> GuardWatch::fault() const {
    const auto hand = faultyHand();
    return hand ? faults_[*hand] : std::nullopt;
}

QString GuardWatch::faultSentences() const {
    const auto hand = faultyHand();
    return hand ? namedOf(*hand, guardSentences(*faults_[*hand])) : QString();
}

QString GuardWatch::namedOf(std::size_t hand, const QString& words) const {
    if (hands_.count() == 1) return words;
    return QStringLiteral("%1: %2").arg(handName(hands_, hand), words);
}

// The guard itself keeps a fault until it is disarmed, so none passes between two frames.
void GuardWatch::watchFault(std::size_t hand) {
    const InhibitReason why = hands_.servo(hand).inhibit;
    if (!isFault(why) || faults_[hand]) return;
    hands_.setArmed(hand, false);
    faults_[hand] = why;
    add(true, namedOf(hand, tr(inhibitWords(why).what)), namedOf(hand, guardSentences(why)));
    emit faulted(why);
}

void GuardWatch::watchPauses() {
    const ServoTelemetry& servo = engine_.servo();
    if (rose(pauses_, servo.pauses)) {
        sincePause_.start();
        add(false, tr(inhibitWords(servo.lastPause).what), guardSentences(servo.lastPause));
    }
    const bool still = engine_.servoStandsStill();
    if (!std::exchange(standsStill_, still) && still) add(false, standstillWords(), standstillWords());
    if (rose(unread_, servo.invalidSamples)) sinceUnread_.start();
    watchHeat(servo);
    if (rose(oscillations_, servo.oscillations))
        add(false, tr("An oscillation was seen: the stiffness was halved."),
            tr("The device shook against a surface. The stiffness was halved, and comes back within seconds. "
               "Hold the handle more firmly, or lower the stiffness."));
}

// Before the limit begins to fall, and not again until they have cooled.
void GuardWatch::watchHeat(const ServoTelemetry& servo) {
    if (servo.heat < kCooled) warned_ = false;
    if (servo.heat < kWarning || warned_) return;
    warned_ = true;
    sinceWarm_.start();
    add(false, tr("The motors are getting warm."), warmWords());
}

void GuardWatch::watchProxy() {
    const ProxyTelemetry& proxy = engine_.proxy();
    if (rose(stepsDown_, proxy.stepsDown))
        add(false, fidelityWords(proxy.fidelity),
            tr("%1 What was left out comes back by itself when there is time for it. Hide objects, or close "
               "what else keeps the machine busy.")
                .arg(fidelityWords(proxy.fidelity)));
}

void GuardWatch::watchCeiling() {
    const double before = ceiling_.shown().value;
    const CeilingNow now = ceilingNow(engine_.servo(), engine_.device());
    if (!ceiling_.follow(now, 1e-3 * double(clock_.elapsed()))) return;
    const CeilingNow& shown = ceiling_.shown();
    moved_ = (shown.value < before ? tr("The stiffness ceiling fell from %1 to %2 N/m: %3.")
                                   : tr("The stiffness ceiling rose from %1 to %2 N/m: %3."))
                 .arg(numberText(before, 0), numberText(shown.value, 0), shown.reason);
    sinceMoved_.start();
    add(false, moved_, moved_);
}

QString GuardWatch::quietNote() const {
    const ServoTelemetry& servo = engine_.servo();
    const auto lately = [](const QElapsedTimer& since) {
        return since.isValid() && since.elapsed() < kShown;
    };
    if (!engine_.running() || fault()) return {};
    if (engine_.servoStandsStill()) return standstillWords();
    if (!engine_.armed())
        return lately(sinceUnread_) ? tr("The device does not answer. Look at its cable and its power.")
                                    : QString();
    // Before the first scene the proxy loop has nothing to say: that is no pause.
    const InhibitReason why = lately(sincePause_) ? servo.lastPause : servo.inhibit;
    const bool away =
        servo.inhibit != InhibitReason::ProxySilent || servo.lastPause == InhibitReason::ProxySilent;
    if (servo.gain < 1 && servo.inhibit != InhibitReason::NotArmed && away) return guardSentences(why);
    if (lately(sinceWarm_)) return warmWords();
    if (lately(sinceMoved_)) return moved_;
    if (engine_.proxy().fidelity != Fidelity::Full) return fidelityWords(engine_.proxy().fidelity);
    return {};
}

void GuardWatch::add(bool fault, const QString& what, const QString& sentences) {
    events_.push_front({QTime::currentTime(), fault, what, sentences});
    if (events_.size() > kKeptFaults) events_.pop_back();
    emit happened();
}

} // namespace tactum
