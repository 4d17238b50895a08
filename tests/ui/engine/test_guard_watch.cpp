// What is said and done when the guard takes force away: of one hand, and of several.
//
// What would show that a test here is wrong: the engine only tells what is set, so nothing is seen that is
// not a rule of the watch; each event is expected beside what must bring none (a counter that stays, a hand
// that had its fault already).
#include <QSignalSpy>
#include <QTest>

#include "core/safety/inhibit_words.h"
#include "core/safety/motor_heat.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/told_engine.h"
#include "ui/engine/guard_watch.h"

namespace test_guard_watch {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Armed, at full force.
void makeWell(ToldEngine& engine) {
    for (HandReport& hand : engine.of) {
        hand.armed = true;
        hand.device.damping = 4;
        hand.servo.inhibit = InhibitReason::Nothing;
        hand.servo.gain = 1;
    }
}

QStringList saidBy(const GuardWatch& watch) {
    QStringList said;
    for (const HealthEvent& event : watch.events())
        said << event.what;
    return said;
}

} // namespace

class TestGuardWatch : public QObject {
    Q_OBJECT

private slots:
    void nothingIsSaidWhileAllIsWell() {
        ToldEngine engine(1);
        makeWell(engine);
        GuardWatch watch(engine);
        for (int i = 0; i < 3; ++i)
            watch.frame();
        QCOMPARE(saidBy(watch), QStringList());
        QCOMPARE(watch.quietNote(), QString());
        QCOMPARE(watch.faultSentences(), QString());
        QVERIFY(!watch.fault());
        QVERIFY(engine.armed());
    }

    void everyFaultSwitchesOffOnceAndUntilArmedAnew_data() {
        QTest::addColumn<int>("why");
        for (std::size_t i = 0; i < kInhibitReasons; ++i)
            QTest::newRow(kInhibitWords[i].brief) << int(i);
    }

    void everyFaultSwitchesOffOnceAndUntilArmedAnew() {
        QFETCH(int, why);
        const auto reason = InhibitReason(why);
        ToldEngine engine(1);
        engine.of[0].armed = true;
        GuardWatch watch(engine);
        const QSignalSpy faulted(&watch, &GuardWatch::faulted);
        engine.of[0].servo.inhibit = reason;
        for (int i = 0; i < 3; ++i)
            watch.frame();
        if (!isFault(reason)) {
            QVERIFY(engine.armed());
            QCOMPARE(faulted.size(), 0);
            QVERIFY(!watch.fault());
            return;
        }
        QVERIFY(!engine.armed());
        QCOMPARE(faulted.size(), 1);
        QCOMPARE(faulted[0][0].value<InhibitReason>(), reason);
        QCOMPARE(watch.fault(), std::optional(reason));
        QCOMPARE(watch.faultyHand(), std::optional<std::size_t>(0));
        const InhibitWords& words = inhibitWords(reason);
        QCOMPARE(watch.faultSentences(),
                 QStringLiteral("%1 %2 %3").arg(words.what, words.done, words.remedy));
        QCOMPARE(saidBy(watch), QStringList(QString::fromUtf8(words.what)));
        QVERIFY(watch.events()[0].fault);
        QCOMPARE(watch.events()[0].sentences, watch.faultSentences());
        QCOMPARE(watch.quietNote(), QString()); // the fault is said elsewhere
        // It stays when the guard has nothing more to say, and ends with the person's arming.
        engine.of[0].servo.inhibit = InhibitReason::NotArmed;
        watch.frame();
        QCOMPARE(watch.fault(), std::optional(reason));
        watch.setArmed(false);
        QCOMPARE(watch.fault(), std::optional(reason));
        watch.setArmed(true);
        QVERIFY(!watch.fault());
        QVERIFY(engine.armed());
        QCOMPARE(faulted.size(), 1);
        engine.of[0].servo.inhibit = reason; // once more, a second one
        watch.frame();
        QCOMPARE(faulted.size(), 2);
        QVERIFY(!engine.armed());
    }

    void ofSeveralHandsTheFaultyOneIsNamed() {
        ToldEngine engine(3);
        for (HandReport& hand : engine.of)
            hand.armed = true;
        engine.of[0].device.name = engine.of[2].device.name = "A wheel";
        engine.of[1].device.name = "An arm";
        GuardWatch watch(engine);
        engine.of[2].servo.inhibit = InhibitReason::TooFast;
        watch.frame();
        QCOMPARE(watch.faultyHand(), std::optional<std::size_t>(2));
        QVERIFY(engine.of[0].armed);
        QVERIFY(engine.of[1].armed);
        QVERIFY(!engine.of[2].armed);
        COMPARE_BEGINS(watch.faultSentences(), QStringLiteral("A wheel 3: The finger was faster"));
        // Another one after it: of several the first in their order.
        engine.of[1].servo.inhibit = InhibitReason::NotFinite;
        watch.frame();
        QVERIFY(!engine.of[1].armed);
        QCOMPARE(watch.faultyHand(), std::optional<std::size_t>(1));
        COMPARE_BEGINS(watch.faultSentences(), QStringLiteral("An arm: The scene asked"));
        QCOMPARE(watch.events().size(), std::size_t(2));
        COMPARE_BEGINS(watch.events()[0].what, QStringLiteral("An arm: ")); // the newest first
        COMPARE_BEGINS(watch.events()[1].what, QStringLiteral("A wheel 3: "));
        watch.setArmed(true);
        for (const HandReport& hand : engine.of)
            QVERIFY(hand.armed);
        watch.forget();
        QVERIFY(!watch.fault());
    }

    void whatRisesIsSaidOnce() {
        ToldEngine engine(1);
        makeWell(engine);
        ServoTelemetry& servo = engine.of[0].servo;
        servo.pauses = 7, servo.oscillations = 3; // before there was a window
        GuardWatch watch(engine);
        const QSignalSpy happened(&watch, &GuardWatch::happened);
        watch.frame();
        QCOMPARE(happened.size(), 0);
        servo.pauses = 9;
        servo.lastPause = InhibitReason::Stall;
        watch.frame();
        watch.frame();
        QCOMPARE(saidBy(watch), QStringList(QString::fromUtf8(inhibitWords(InhibitReason::Stall).what)));
        QVERIFY(!watch.events()[0].fault);
        servo.oscillations = 4;
        watch.frame();
        watch.frame();
        QCOMPARE(happened.size(), 2);
        COMPARE_CONTAINS(watch.events()[0].what, QStringLiteral("oscillation"));
        servo.pauses = 0, servo.oscillations = 0; // the engine began anew
        watch.frame();
        QCOMPARE(happened.size(), 2);
        servo.pauses = 1;
        watch.frame();
        QCOMPARE(happened.size(), 3);
    }

    void whatIsTakenAwayIsSaidWhileItIs() {
        ToldEngine engine(1);
        makeWell(engine);
        ServoTelemetry& servo = engine.of[0].servo;
        GuardWatch watch(engine);
        servo.gain = 0.4;
        servo.inhibit = InhibitReason::Rising;
        COMPARE_CONTAINS(watch.quietNote(), QString::fromUtf8(inhibitWords(InhibitReason::Rising).what));
        // For two seconds the reason of the pause, though it comes back already.
        servo.pauses = 1;
        servo.lastPause = InhibitReason::Stall;
        watch.frame();
        COMPARE_CONTAINS(watch.quietNote(), QString::fromUtf8(inhibitWords(InhibitReason::Stall).what));
        servo.gain = 1;
        servo.inhibit = InhibitReason::Nothing;
        QCOMPARE(watch.quietNote(), QString());
        // Before the first scene the proxy loop has nothing to say.
        servo = {};
        servo.inhibit = InhibitReason::ProxySilent;
        GuardWatch other(engine);
        QCOMPARE(other.quietNote(), QString());
        servo.lastPause = InhibitReason::ProxySilent;
        COMPARE_CONTAINS(other.quietNote(), QStringLiteral("proxy loop did not answer"));
        engine.runs = false;
        QCOMPARE(other.quietNote(), QString());
    }

    void aServoThatStandsStillIsSaid() {
        ToldEngine engine(1);
        makeWell(engine);
        GuardWatch watch(engine);
        engine.of[0].standsStill = true;
        watch.frame();
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(1));
        COMPARE_CONTAINS(watch.events()[0].what, QStringLiteral("stands still"));
        QCOMPARE(watch.quietNote(), watch.events()[0].what);
        engine.of[0].armed = false; // that it does is said without force too
        QCOMPARE(watch.quietNote(), watch.events()[0].what);
        engine.of[0].standsStill = false;
        watch.frame();
        QCOMPARE(watch.quietNote(), QString());
        engine.of[0].standsStill = true;
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(2));
    }

    void aSilentDeviceIsSaidWithForcesOff() {
        ToldEngine engine(1);
        makeWell(engine);
        GuardWatch watch(engine);
        engine.of[0].armed = false;
        watch.frame();
        QCOMPARE(watch.quietNote(), QString());
        ++engine.of[0].servo.invalidSamples;
        watch.frame();
        COMPARE_CONTAINS(watch.quietNote(), QStringLiteral("does not answer"));
        QCOMPARE(watch.events().size(), std::size_t(0)); // with forces the guard says more of it
    }

    void warmMotorsAreSaidOnceUntilTheyCooled() {
        ToldEngine engine(1);
        makeWell(engine);
        double& heat = engine.of[0].servo.heat;
        GuardWatch watch(engine);
        const auto eventsAt = [&](double part) {
            heat = part * kWarmMotors;
            watch.frame();
            return watch.events().size();
        };
        QCOMPARE(eventsAt(0.49), std::size_t(0));
        QCOMPARE(watch.quietNote(), QString());
        QCOMPARE(eventsAt(0.51), std::size_t(1));
        COMPARE_CONTAINS(watch.events()[0].what, QStringLiteral("getting warm"));
        COMPARE_CONTAINS(watch.quietNote(), QStringLiteral("Press less"));
        QCOMPARE(eventsAt(0.3), std::size_t(1)); // not cool enough to be said again
        QCOMPARE(eventsAt(0.9), std::size_t(1));
        QCOMPARE(eventsAt(0.24), std::size_t(1));
        QCOMPARE(eventsAt(0.6), std::size_t(2));
    }

    void detailThatIsLeftOutIsSaid() {
        ToldEngine engine(1);
        makeWell(engine);
        engine.proxyTold.stepsDown = 2;
        GuardWatch watch(engine);
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(0));
        engine.proxyTold.stepsDown = 3;
        engine.proxyTold.fidelity = Fidelity::NoTexture;
        watch.frame();
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(1));
        QCOMPARE(watch.events()[0].what, QStringLiteral("Textures are left out: the scene is too heavy."));
        COMPARE_BEGINS(watch.events()[0].sentences, watch.events()[0].what + u' ');
        QCOMPARE(watch.quietNote(), watch.events()[0].what);
        engine.proxyTold.fidelity = Fidelity::Full;
        watch.frame();
        QCOMPARE(watch.quietNote(), QString());
    }

    void anotherHandBringsNoNews() {
        ToldEngine engine(2);
        makeWell(engine);
        engine.of[1].servo.pauses = 5;
        engine.of[1].servo.oscillations = 5;
        engine.of[1].device.damping = 1;
        GuardWatch watch(engine);
        const double first = watch.ceiling().value;
        QCOMPARE_GT(first, 0);
        engine.chosen = 1;
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(0));
        QCOMPARE_LT(watch.ceiling().value, first); // at once: it is another device
        engine.of[1].servo.pauses = 6;
        watch.frame();
        QCOMPARE(watch.events().size(), std::size_t(1));
    }

    void theLastHundredAreKept() {
        ToldEngine engine(1);
        makeWell(engine);
        GuardWatch watch(engine);
        for (int i = 0; i < 130; ++i) {
            ++engine.of[0].servo.pauses;
            engine.of[0].servo.lastPause = i < 129 ? InhibitReason::Stall : InhibitReason::DeadMan;
            watch.frame();
        }
        QCOMPARE(watch.events().size(), std::size_t(100));
        QCOMPARE(watch.events().front().what, QString::fromUtf8(inhibitWords(InhibitReason::DeadMan).what));
        QCOMPARE(watch.events().back().what, QString::fromUtf8(inhibitWords(InhibitReason::Stall).what));
    }
};

TACTUM_TEST(TestGuardWatch)

} // namespace test_guard_watch

#include "test_guard_watch.moc"
