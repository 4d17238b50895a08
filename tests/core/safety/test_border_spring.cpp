// The border of rate control: a spring in newtons, without a step, that gives no more than it took.
#include <deque>
#include <random>

#include <QTest>

#include "tests/core/safety/held_servo.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_border_spring {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kBorder = 0.03; // m

/// J that a device gave whose force follows the command `delay` ticks late, for a hand that goes as it likes.
struct Felt {
    explicit Felt(int delay, double resolution = 0) : spring(info(delay, resolution)), late(delay + 1) {}
    static DeviceInfo info(int delay, double resolution) {
        DeviceInfo device;
        device.maxForce = 8, device.delay = delay, device.positionResolution = resolution;
        return device;
    }
    void goTo(const Vec3& position) {
        onTheWay.push_back(force);
        if (onTheWay.size() > std::size_t(late)) onTheWay.pop_front();
        if (onTheWay.size() == std::size_t(late)) given += onTheWay.front().dot(position - at);
        at = position;
        force = spring(position, kBorder, 8, kTick);
        spring.commanded(force);
        most = std::max(most, given);
    }

    BorderSpring spring;
    int late;
    std::deque<Vec3> onTheWay;
    Vec3 at = Vec3::Zero(), force = Vec3::Zero();
    double given = 0, most = 0;
};

} // namespace

class TestBorderSpring : public QObject {
    Q_OBJECT

private slots:
    void atRestBeyondItTheForceIsThatOfASpring() {
        const Vec3 out = Vec3(2, -1, 2) / 3;
        for (const double excess : {1e-4, 1e-3, 5e-3, 0.01, 0.02}) {
            Held held;
            held.model.valid = true; // nothing is near
            held.border = kBorder;
            held.rest(0.02 * out);
            for (int i = 0; i <= 300; ++i)
                held.tick((0.02 + (kBorder + excess - 0.02) * i / 300) * out);
            held.rest((kBorder + excess) * out, 100);
            COMPARE_NEAR(held.output.force, Vec3(-kBorderStiffness * excess * out), 1e-9, "N");
        }
    }

    void withinItNothingChanges() {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> step(-1e-4, 1e-4);
        Held with, without;
        with.border = kBorder;
        with.model = without.model = wall(600, 0.4);
        Vec3 finger(0, 0, 0.005);
        with.rest(finger), without.rest(finger);
        for (int i = 0; i < 4000; ++i) {
            finger += Vec3(step(random), step(random), step(random));
            finger = finger.cwiseMax(-0.012).cwiseMin(0.012);
            QCOMPARE(with.tick(finger), without.tick(finger)); // bit for bit
        }
    }

    void theBorderIsNoStepOfTheForce() {
        Held held;
        held.model.valid = true; // nothing is near
        held.border = kBorder;
        held.rest({0.02, 0, 0});
        const double speed = 0.2; // m/s
        double largest = 0;
        Vec3 last = held.output.force;
        for (int i = 0; i < 600; ++i) { // out for 0.1 s, and back
            const double x = 0.025 + speed * kTick * (i < 100 ? i : std::max(0, 200 - i));
            const Vec3 force = held.tick({x, 0, 0});
            largest = std::max(largest, (force - last).norm());
            last = force;
        }
        QCOMPARE_LE(largest, 3.5 * kBorderStiffness * speed * kTick); // three times the spring's own change
        QCOMPARE(last, Vec3(Vec3::Zero()));
    }

    void itGivesNoMoreThanItTook_data() {
        QTest::addColumn<int>("delay");
        QTest::addColumn<double>("speed");
        for (const int delay : {0, 1, 2, 4})
            for (const double speed : {0.05, 0.3, 1.0})
                QTest::addRow("%d ticks, %g m/s", delay, speed) << delay << speed;
    }
    void itGivesNoMoreThanItTook() {
        QFETCH(int, delay);
        QFETCH(double, speed);
        Felt felt(delay);
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> any(-1, 1);
        double phase = 0;
        const double depth = 0.012;
        for (int i = 0; i < 20000; ++i) { // to and fro across the border, as a hand swings
            phase += speed * kTick / depth * (1 + 0.3 * any(random));
            felt.goTo({0, 0, kBorder + depth * std::sin(phase)});
        }
        QCOMPARE_LE(felt.most, 2e-6);
        QCOMPARE_LE(felt.given, 0.0);
    }

    void aReadingBetweenTwoCountsIsNoWork() {
        constexpr double kCount = 6e-5;
        Felt felt(2, kCount);
        for (int i = 0; i <= 100; ++i)
            felt.goTo({0, 0, kBorder + 1e-4 * i});
        const Vec3 place = felt.at;
        for (int i = 0; i < 20000; ++i)
            felt.goTo(place + Vec3(0, 0, i % 2 * kCount));
        COMPARE_NEAR(felt.force.norm(), kBorderStiffness * (place.z() + kCount - kBorder), 0.02, "N");
    }

    void aContactComesFirst() {
        Held with, without;
        with.border = kBorder;
        with.model = without.model = wall(1500);
        for (Held* held : {&with, &without}) {
            held->rest({0, 0, 0.01});
            held->go(0.01, -0.001);
        }
        // Along the wall out of the shell: the push of the wall stays what it is.
        for (int i = 0; i <= 400; ++i) {
            const Vec3 finger(1e-4 * i, 0, -0.001);
            const Vec3 felt = with.tick(finger), alone = without.tick(finger);
            const double depth = std::max(0.0, finger.norm() - kBorder);
            COMPARE_NEAR(felt - alone, Vec3(-kBorderStiffness * depth * finger.normalized()), 1e-6, "N");
        }
    }

    /// Against a wall that takes all of the device's force the border has nothing left to say.
    void whatLeavesIsWithinTheLimit() {
        DeviceInfo weak = Held::info();
        weak.maxForce = 3;
        Held with(weak), without(weak);
        with.border = kBorder;
        with.model = without.model = wall(1500);
        for (Held* held : {&with, &without}) {
            held->rest({0.01, 0, 0.01});
            for (int i = 0; i <= 400; ++i)
                held->tick({0.01 + 7e-5 * i, 0, 0.01 - 3.2e-5 * i});
            for (int i = 0; i < 200; ++i) {
                held->tick({0.038, 0, -0.0028});
                QCOMPARE_LE(held->output.force.norm(), 3 * (1 + 1e-12));
            }
        }
        COMPARE_NEAR(without.output.force, Vec3(0, 0, 3), 1e-6, "N");
        COMPARE_NEAR(with.output.force, without.output.force, 1e-6, "N");
    }

    void itIsABoundedPartOfTheLimit() {
        Held held;
        held.model.valid = true; // nothing is near
        held.border = 0.005;
        held.rest({0, 0.004, 0});
        for (int i = 0; i <= 400; ++i)
            held.tick({0, 0.004 + 2e-4 * i, 0});
        held.rest({0, 0.084, 0}, 100);
        COMPARE_NEAR(held.output.force, Vec3(0, -0.4 * 20, 0), 1e-9, "N");
    }

    void withoutForcesThereIsNone() {
        Held held;
        held.model.valid = true; // nothing is near
        held.border = kBorder;
        held.settings.armed = false;
        held.rest({0, 0, 0.02});
        for (int i = 0; i < 300; ++i)
            QCOMPARE(held.tick({0, 0, 0.02 + 5e-5 * i}), Vec3(Vec3::Zero()));
    }
};

TACTUM_TEST(TestBorderSpring)

} // namespace test_border_spring

#include "test_border_spring.moc"
