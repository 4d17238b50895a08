// The contact transition by itself: what is rendered is continuous in force, bounded in rate and in energy.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/safety/contact_transition.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_contact_transition {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kTick = 1e-3, kStiff = 1000; ///< s, N/m
constexpr TransitionBounds kBounds{.ceiling = 1e9, .leaving = 1e9, .force = 10};

LocalContactModel plane(double height, const Vec3& normal = Vec3::UnitZ()) {
    LocalContactModel model;
    model.proxy = {0, 0, height};
    model.planes = 1;
    model.plane[0] = {normal, 0};
    model.stiffness = kStiff;
    model.valid = true;
    return model;
}

/// A finger that the test puts somewhere, and what is rendered for it.
struct Touching {
    explicit Touching(double depth) : finger(0, 0, -depth) {
        transition(plane(0), true, Vec3::Zero(), Vec3::Zero(), kBounds, kTick);
        newest = plane(0);
        tick();
    }
    Vec3 tick(bool fresh = true) {
        const LocalContactModel& rendered = transition(newest, fresh, finger, Vec3::Zero(), kBounds, kTick);
        const Anchor anchor = anchorOf(rendered, finger);
        return force = anchor.touching ? Vec3(rendered.stiffness * (anchor.position - finger)) : Vec3::Zero();
    }
    /// The largest change of the force within so many ticks.
    double settle(int ticks) {
        double change = 0;
        for (int i = 0; i < ticks; ++i) {
            const Vec3 before = force;
            change = std::max(change, (tick() - before).norm());
        }
        return change;
    }

    ContactTransition transition;
    LocalContactModel newest;
    Vec3 finger, force = Vec3::Zero();
};

} // namespace

class TestContactTransition : public QObject {
    Q_OBJECT

private slots:
    void whatDoesNotChangeIsRenderedAsItIs() {
        Touching touching(2e-3);
        COMPARE_NEAR(touching.force, Vec3(0, 0, 2), 1e-12, "N");
        QVERIFY(!touching.transition.easing());
    }

    /// The proxy begins anew, and what it touches now pushes the same way: the contact goes on.
    void aBodyThatIsMovedComesAsFastAsItReturns() {
        for (const double height : {1e-3, -1e-3, 0.02}) {
            Touching touching(2e-3);
            touching.newest = plane(height);
            ++touching.newest.restarts;
            ++touching.newest.revision;
            const Vec3 before = touching.force;
            COMPARE_NEAR(touching.tick(), before, kStiff * kReturnSpeed * kTick + 1e-9, "N");
            const int ticks = int(std::abs(height) / kReturnSpeed / kTick) + 10;
            QCOMPARE_LE(touching.settle(ticks), kStiff * kReturnSpeed * kTick + 1e-9);
            COMPARE_NEAR(touching.force, Vec3(0, 0, kStiff * (height + 2e-3)), 1e-9, "N");
            QVERIFY(!touching.transition.easing());
        }
    }

    /// An edit takes it away: 10 N/s.
    void aBodyThatIsDeletedFadesAsAnEdit() {
        Touching touching(2e-3);
        touching.newest.planes = 0;
        ++touching.newest.revision;
        COMPARE_NEAR(touching.tick().z(), 2 - kEditRate * kTick, 1e-9, "N");
        QCOMPARE_LE(touching.settle(1000), kEditRate * kTick * 3.1); // the last of it goes at once
        QCOMPARE_EQ(touching.force, Vec3(0, 0, 0));
    }

    /// The finger's own way takes it away: 300 N/s where it pushed hard, at once where it hardly did.
    void aPushThatIsGoneFadesWhereItWasStrong() {
        Touching strong(5e-3), weak(2e-3);
        strong.newest.planes = weak.newest.planes = 0;
        COMPARE_NEAR(strong.tick().z(), 5 - kSurfaceRate * kTick, 1e-9, "N");
        QCOMPARE_LE(strong.settle(40), kSurfaceRate * kTick + 1e-9);
        QCOMPARE_EQ(strong.force, Vec3(0, 0, 0));
        QCOMPARE_EQ(weak.tick(), Vec3(0, 0, 0));
    }

    /// The finger lifts off by itself: nothing holds it.
    void whoLiftsOffIsFree() {
        Touching touching(5e-3);
        for (double z = -5e-3; z < 1e-3; z += 1e-4) {
            touching.finger.z() = z;
            COMPARE_NEAR(touching.tick().z(), std::max(0.0, -kStiff * z), 1e-9, "N");
        }
        touching.newest.planes = 0;
        QCOMPARE_EQ(touching.tick(), Vec3(0, 0, 0));
        QVERIFY(!touching.transition.easing());
    }

    /// An edit moves the surface, and that is its own work. Answers that jump about do not: what they hold
    /// back and give later the spring gives, and the balance has to see it.
    void onlyAnEventMovesTheSurfaceByItself() {
        Touching edited(2e-3), jumping(2e-3);
        edited.newest = jumping.newest = plane(2e-3);
        ++edited.newest.revision;
        for (Touching* touching : {&edited, &jumping}) {
            for (int i = 0; i < 5; ++i)
                touching->tick();
            QVERIFY(touching->transition.easing());
        }
        COMPARE_NEAR(edited.transition.ownMotion(), Vec3(0, 0, kReturnSpeed), 1e-12, "m/s");
        QCOMPARE_EQ(jumping.transition.ownMotion(), Vec3(0, 0, 0));
        // Held back on the way back from the edit: that returns first, and is counted.
        edited.newest.proxy.z() += 2e-3;
        edited.tick();
        edited.tick();
        QCOMPARE_EQ(edited.transition.ownMotion(), Vec3(0, 0, 0));
        for (int i = 0; i < int(2.2e-3 / kReturnSpeed / kTick); ++i)
            edited.tick();
        COMPARE_NEAR(edited.transition.ownMotion(), Vec3(0, 0, kReturnSpeed), 1e-12, "m/s");
        // What was held back is still on its way when an edit comes, and goes with it.
        ++jumping.newest.revision;
        jumping.tick();
        jumping.tick();
        COMPARE_NEAR(jumping.transition.ownMotion(), Vec3(0, 0, kReturnSpeed), 1e-12, "m/s");
    }

    /// Answers that jump about: what they bring to the spring is at most the credit.
    void newerModelsBringNoMoreThanTheirCredit() {
        Rng random(4);
        Touching touching(2e-3);
        double brought = 0;
        constexpr int kTicks = 5000;
        for (int i = 0; i < kTicks; ++i) {
            const double before = touching.force.squaredNorm() / (2 * kStiff);
            touching.newest = plane(uniform(random, -4e-3, 4e-3));
            touching.tick(i % 10 == 0);
            if (i % 10 != 0) continue;
            brought += std::max(0.0, touching.force.squaredNorm() / (2 * kStiff) - before);
        }
        // What comes back in these ticks with 15 mm/s is its own work.
        const double returns = 0.1 * kTicks * kTick * kReturnSpeed * 6;
        QCOMPARE_LE(brought, kHandOverEnergy + kHandOverPower * kTicks * kTick + returns);
        QCOMPARE_GT(brought, 0.5 * kHandOverEnergy);
    }

    /// Any models in any order: finite, no stiffer than the ceiling in free motion.
    void anythingIsFinite() {
        Rng random(8);
        ContactTransition transition;
        for (int i = 0; i < 20000; ++i) {
            LocalContactModel model = plane(uniform(random, -0.01, 0.01), direction(random));
            model.planes = int(random() % 2);
            model.revision = random() % 3;
            model.restarts = std::uint32_t(random() % 3);
            model.velocity = inBox(random, 0.3);
            const LocalContactModel& rendered = transition(model, random() % 2, inBox(random, 0.01),
                                                           inBox(random, 0.5), {500, 500, 10}, kTick);
            QVERIFY(rendered.proxy.allFinite());
            QVERIFY(std::isfinite(rendered.stiffness));
            QCOMPARE_GE(rendered.stiffness, 0);
            QCOMPARE_LE(rendered.stiffness, kStiff);
        }
    }
};

TACTUM_TEST(TestContactTransition)

} // namespace test_contact_transition

#include "test_contact_transition.moc"
