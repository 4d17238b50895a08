// From ticks to a gamepad's motors, with gamepads that are SDL's own: what they are told, which of them, and
// that nothing stays on.
#include <cmath>
#include <numbers>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/rumble/virtual_pad.h"
#include "ui/rumble/rumble_link.h"

namespace test_rumble_link {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRate = 1000;

/// A hand that feels a sine as long as it is asked to: a frame's ticks each time.
class Felt {
public:
    Felt(RumbleLink& link, double frequency, double newtons)
        : link_(link), frequency_(frequency), newtons_(newtons) {}

    void frame(bool touching = true, double gain = 1) {
        std::vector<TracePoint> points(16);
        for (TracePoint& point : points) {
            point.t = double(++tick_) / kRate;
            const double shaking = newtons_ * std::sin(2 * std::numbers::pi * frequency_ * point.t);
            point.force = {shaking, 1, 0};
            point.touching = touching;
            point.gain = gain;
        }
        link_.play(points, kRate);
    }
    /// So that what follows is no impact.
    void settle() {
        for (int i = 0; i < 60; ++i)
            frame();
    }
    /// While it is felt, until the condition holds.
    template <class Condition> bool until(Condition condition) {
        return waitFor([&] {
            frame();
            return condition();
        });
    }

private:
    RumbleLink& link_;
    double frequency_, newtons_;
    std::uint64_t tick_ = 0;
};

bool found(const RumbleLink& link, std::size_t count) {
    return waitFor([&] { return link.pads().size() == count; });
}

bool turns(const VirtualPad& pad) {
    return pad.last().low > 0 || pad.last().high > 0;
}

bool stands(const VirtualPad& pad) {
    return waitFor([&] { return !pad.told().empty() && !turns(pad); });
}

double root(double newtons) {
    return std::sqrt(newtons);
}

} // namespace

class TestRumbleLink : public QObject {
    Q_OBJECT
private slots:
    void theMotorsAreToldTheStrengthOfASine_data() {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("newtons");
        QTest::addColumn<double>("strength");
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        // By Butterworth's formula: half of the power to each motor at 100 Hz, 1/17 to the other an octave
        // away.
        QTest::newRow("slow") << 50.0 << 0.25 << 1.0 << root(0.25 * 0.970 * 0.987)
                              << root(0.25 * 0.243 * 0.987);
        QTest::newRow("between") << 100.0 << 0.25 << 1.0 << root(0.25 * 0.7071) << root(0.25 * 0.7071);
        QTest::newRow("fast") << 200.0 << 0.25 << 1.0 << root(0.25 * 0.2) << root(0.25 * 0.98);
        QTest::newRow("stronger") << 200.0 << 0.1 << 4.0 << root(0.4 * 0.2) << root(0.4 * 0.98);
        QTest::newRow("beyond full") << 200.0 << 3.0 << 2.0 << 1.0 << 1.0;
    }
    void theMotorsAreToldTheStrengthOfASine() {
        QFETCH(double, frequency);
        QFETCH(double, newtons);
        QFETCH(double, strength);
        QFETCH(double, low);
        QFETCH(double, high);
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.setStrength(strength);
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, frequency, newtons);
        felt.settle();
        const std::size_t before = pad.told().size();
        QVERIFY(felt.until([&] { return pad.told().size() > before + 20 || (low == 1 && turns(pad)); }));
        double lowSum = 0, highSum = 0;
        const auto all = pad.told();
        const std::size_t from = std::min(before + 1, all.size() - 1);
        for (std::size_t i = from; i < all.size(); ++i) {
            lowSum += all[i].low;
            highSum += all[i].high;
        }
        COMPARE_NEAR(lowSum / double(all.size() - from), low, 0.04, "");
        COMPARE_NEAR(highSum / double(all.size() - from), high, 0.04, "");
    }

    void withoutTheSwitchNothingVibrates() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        Felt felt(link, 50, 1);
        for (int i = 0; i < 50; ++i)
            felt.frame();
        QVERIFY(link.pads().empty());
        link.setOn(true);
        QVERIFY(found(link, 1));
        QVERIFY(!turns(pad)); // what was felt before is over
        QVERIFY(felt.until([&] { return turns(pad); }));
        link.setOn(false);
        QVERIFY(!turns(pad)); // already
        const std::size_t told = pad.told().size();
        for (int i = 0; i < 50; ++i)
            felt.frame();
        QCOMPARE(pad.told().size(), told);
        QVERIFY(link.pads().empty());
    }

    void itEndsWithTheTouch() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(pad); }));
        // The force shakes on, as a device's own would; two frames without a touch are enough.
        felt.frame(false);
        felt.frame(false);
        QVERIFY(waitFor([&] {
            felt.frame(false);
            return !turns(pad);
        }));
        QVERIFY(felt.until([&] { return turns(pad); }));
    }

    void itEndsWithTheForce() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(pad); }));
        QVERIFY(waitFor([&] {
            felt.frame(true, 0);
            return !turns(pad);
        }));
    }

    void itEndsByItselfWhenTheWindowSaysNoMore() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(pad); }));
        QVERIFY(stands(pad));
        link.play({}, kRate); // a recording that is paused
        QVERIFY(!turns(pad));
    }

    void whileNobodyAttendsNothingVibrates() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(pad); }));
        link.setAttended(false);
        QVERIFY(felt.until([&] { return !turns(pad); }));
        link.setAttended(true);
        QVERIFY(felt.until([&] { return turns(pad); }));
    }

    void ofTwoTheChosenOneVibrates() {
        VirtualPad first("The first", 1), second("The second", 2);
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 2));
        QCOMPARE(link.used()->name, std::string("The first"));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(first); }));
        QVERIFY(second.told().empty() || !turns(second));
        link.choose(link.pads()[1].key);
        QVERIFY(felt.until([&] { return turns(second) && !turns(first); }));
        QCOMPARE(link.used()->name, std::string("The second"));
        // Never both: the one stands before the other turns.
        const auto told = second.told();
        const auto began =
            std::ranges::find_if(told, [](const VirtualPad::Told& each) { return each.low > 0; });
        QCOMPARE_LE(first.last().t, began->t);
        const std::size_t before = first.told().size();
        link.setOn(false);
        link.setOn(true);
        QVERIFY(found(link, 2));
        const std::size_t heard = second.told().size();
        QVERIFY(felt.until([&] { return second.told().size() > heard && turns(second); }));
        QCOMPARE(first.told().size(), before);
    }

    void twoOfOneKindHaveKeysOfTheirOwn() {
        VirtualPad first("Twin", 7), second("Twin", 7);
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 2));
        QVERIFY(link.pads()[0].key != link.pads()[1].key);
        link.choose(link.pads()[1].key);
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(first) || turns(second); }));
        QVERIFY(turns(second) && !turns(first));
    }

    void oneThatComesLaterVibrates() {
        RumbleLink link;
        QSignalSpy looked(&link, &RumbleLink::padsChanged);
        link.setOn(true);
        QVERIFY(waitFor([&] { return looked.count() > 0; })); // SDL is begun
        Felt felt(link, 50, 1);
        felt.settle();
        VirtualPad pad("Late");
        QVERIFY(found(link, 1));
        QVERIFY(felt.until([&] { return turns(pad); }));
    }

    void oneThatGoesWhileItVibratesIsNoError() {
        VirtualPad first("The first", 1), second("The second", 2);
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 2));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(first); }));
        first.unplug();
        QVERIFY(felt.until([&] { return link.pads().size() == 1; }));
        QVERIFY(felt.until([&] { return turns(second); }));
        second.unplug();
        QVERIFY(felt.until([&] { return link.pads().empty(); }));
        QVERIFY(!link.used());
        felt.settle();
        // Back again, the one that was chosen has its place.
        VirtualPad again("The first", 1);
        QVERIFY(found(link, 1));
        QVERIFY(felt.until([&] { return turns(again); }));
    }

    void aChosenOneThatIsNotThereLeavesTheOther() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        link.choose("of yesterday");
        link.setOn(true);
        QVERIFY(found(link, 1));
        Felt felt(link, 50, 1);
        QVERIFY(felt.until([&] { return turns(pad); }));
        QCOMPARE(link.chosen(), std::string("of yesterday"));
    }

    void aJoystickWithoutMotorsIsNoGamepadHere() {
        VirtualPad mute("A joystick", 1, false), pad("A gamepad", 2);
        RumbleLink link;
        link.setOn(true);
        QVERIFY(found(link, 1));
        QCOMPARE(link.used()->name, std::string("A gamepad"));
    }

    void itIsSwitchedManyTimes() {
        VirtualPad pad("A gamepad");
        RumbleLink link;
        for (int i = 0; i < 10; ++i) {
            link.setOn(true);
            if (i % 2 == 0) QVERIFY(found(link, 1));
            link.setOn(false);
            QVERIFY(link.pads().empty());
        }
        QTest::qWait(0); // what the threads of before said
        QVERIFY(link.pads().empty());
    }
};

TACTUM_TEST(TestRumbleLink)

} // namespace test_rumble_link

#include "test_rumble_link.moc"
