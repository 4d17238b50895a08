// Added damping: along the push, within its bounds of force and rate, and never giving energy for longer than
// it fades.
#include <cmath>

#include <QTest>

#include "core/safety/added_damping.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_added_damping {

using namespace tactum;
using namespace tactum::test;

namespace {
constexpr double kLimit = 10, kTick = 1e-3, kStep = kAddedRate * kLimit * kTick; // N, s, N a tick
} // namespace

class TestAddedDamping : public QObject {
    Q_OBJECT

private slots:
    void brakesAlongThePushAlone() {
        AddedDamping damper;
        const Vec3 push(0, 0, 2), sliding(0.3, 0, -0.1);
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < 100; ++i)
            force = damper(push, -5 * sliding, sliding, kLimit, kTick);
        COMPARE_NEAR(force, Vec3(0, 0, 0.5), 1e-12, "N"); // 5 N s/m times 0.1 m/s
    }

    void growsByItsRateAndEndsAtItsShare() {
        AddedDamping damper;
        for (int i = 1; i < 40; ++i) {
            const double force = damper({0, 0, 2}, {0, 0, 100}, {0, 0, -1}, kLimit, kTick).z();
            COMPARE_NEAR(force, std::min(i * kStep, kMaxAddedForce * kLimit), 1e-12, "N");
        }
    }

    /// At 4 kHz a tick is a quarter of one at 1 kHz.
    void theRateIsOfTime() {
        AddedDamping damper;
        for (int i = 0; i < 4; ++i)
            damper({0, 0, 2}, {0, 0, 100}, {0, 0, -1}, kLimit, kTick / 4);
        COMPARE_NEAR(damper.added(), kStep, 1e-12, "N");
    }

    /// What fades is gone within 0.3 of the limit at 5 % of it a tick.
    void whatIsLeftFadesInSixTicks() {
        for (const bool turns : {false, true}) {
            AddedDamping damper;
            const Vec3 push(0, 0, 2);
            for (int i = 0; i < 40; ++i)
                damper(push, {0, 0, 100}, {0, 0, -1}, kLimit, kTick);
            double last = damper.added();
            COMPARE_NEAR(last, 3, 1e-12, "N");
            for (int i = 0; i < 6; ++i) {
                damper(turns ? push : Vec3::Zero(), {0, 0, 100}, {0, 0, turns ? 1.0 : 0.0}, kLimit, kTick);
                QCOMPARE_LE(last - damper.added(), 2.5 * kStep + 1e-12);
                last = damper.added();
            }
            COMPARE_NEAR(last, 0, 1e-12, "N");
        }
    }

    /// What was along the push before goes as what is left does: at once it would be a step.
    void whatTurnsWithThePushHasNoStep() {
        for (const Vec3& turned : {Vec3(0, 0, -2), Vec3(2, 0, 0)}) {
            AddedDamping damper;
            for (int i = 0; i < 40; ++i)
                damper({0, 0, 2}, {0, 0, 100}, {0, 0, -1}, kLimit, kTick);
            Vec3 last = damper.force();
            for (int i = 0; i < 40; ++i) {
                const Vec3 now = damper(turned, 50 * turned, -0.5 * turned, kLimit, kTick);
                COMPARE_NEAR(now, last, 2.5 * kStep + 1e-12, "N");
                last = now;
            }
            COMPARE_NEAR(last, Vec3(0.5 * kMaxAddedForce * kLimit * turned), 1e-9, "N");
        }
    }

    /// Any push, wish and way: bounded in force and rate, and what is sideways only becomes less.
    void anythingStaysWithinItsBounds() {
        Rng random(5);
        AddedDamping damper;
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 100000; ++i) {
            const Vec3 push = random() % 4 ? Vec3(uniform(random, 0, 9) * direction(random)) : Vec3(0, 0, 0);
            const Vec3 force = damper(push, inBox(random, 50), inBox(random, 1), kLimit, kTick);
            QCOMPARE_LE(force.norm(), kMaxAddedForce * kLimit * (1 + 1e-12));
            QCOMPARE_LE((force - last).norm(), 2.5 * kStep * (1 + 1e-9));
            if (!push.isZero(0)) QCOMPARE_LE(force.cross(push).norm(), last.cross(push).norm() + 1e-12);
            last = force;
        }
    }
};

TACTUM_TEST(TestAddedDamping)

} // namespace test_added_damping

#include "test_added_damping.moc"
