// Changes of the scene under the finger: where the proxy is afterwards (rule: what lands on the finger begins
// without force, and what was not touched by the change is felt as before).
#include <QTest>

#include "core/collision/nearest.h"
#include "core/proxy/place.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_scene_changes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3, kBall = 0.03;

SceneObject objectOf(Soup soup, const Vec3& at = Vec3::Zero()) {
    SceneObject object;
    object.geometry = std::move(soup);
    object.pose.translation = at;
    object.surfaces.resize(1);
    object.surfaces[0].material = frictionless();
    return object;
}

/// A ball in the origin and a sheet below it.
Scene ballAndSheet() {
    Scene scene;
    scene.proxyRadius = kRadius;
    scene.add(objectOf(ball(kBall, 3)));
    scene.add(objectOf(sheet(0.1), {0, 0, -0.05}));
    return scene;
}

double clearanceOf(const World& world, const Vec3& p_W) {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& obstacle : world.obstacles)
        least = std::min(least, nearestOn(*obstacle.mesh, obstacle.pose.applyInverse(p_W)).distance);
    return least;
}

bool isInside(const Obstacle& obstacle, const Vec3& p_W) {
    return obstacle.mesh->closed && nearestOn(*obstacle.mesh, obstacle.pose.applyInverse(p_W)).front < 0;
}

/// A hand, and the scene that it feels.
struct Editing {
    explicit Editing(const Scene& theScene) : scene(theScene), world(compile(scene).value()), hand(world) {}

    void recompile() {
        world = compile(scene, world.get()).value();
        hand.take(world);
        hand.to(hand.finger());
    }

    Scene scene;
    std::shared_ptr<const World> world;
    Hand hand;
};

} // namespace

class TestSceneChanges : public QObject {
    Q_OBJECT

private slots:
    void whatLandsOnTheFingerHasTheProxyOutsideAtOnce() {
        Editing edit(ballAndSheet());
        edit.scene.objects[0].visible = false;
        edit.recompile();
        const Vec3 finger(0.004, 0.002, 0.02);
        edit.hand.to(finger);
        QCOMPARE(edit.hand.output().proxy, finger);
        const std::uint32_t restarts = edit.hand.state.model.restarts;
        edit.scene.objects[0].visible = true;
        edit.recompile();
        const Vec3 proxy = edit.hand.output().proxy;
        QCOMPARE_GE(clearanceOf(*edit.world, proxy), kRadius * (1 - 2 * kSkin));
        QVERIFY(!isInside(edit.world->obstacles[0], proxy));
        // Through the nearest wall: straight outward, but for the facets of the ball.
        COMPARE_NEAR(proxy, (kBall + kRadius) * finger.normalized(), 2e-3, "m");
        QCOMPARE(edit.hand.state.model.restarts, restarts + 1);
    }

    void whatLiesElsewhereMayChangeUnfelt() {
        Editing edit(ballAndSheet());
        edit.hand.to({0, 0, 0.04});
        edit.hand.go({0, 0, kBall - 0.003}, 0.05);
        const HapticOutput before = edit.hand.output();
        const std::uint32_t restarts = edit.hand.state.model.restarts;
        QCOMPARE_GT(before.force.z(), 1);
        edit.scene.objects[1].visible = false;
        edit.recompile();
        COMPARE_NEAR(edit.hand.output().proxy, before.proxy, 1e-9, "m");
        COMPARE_NEAR(edit.hand.output().force, before.force, 1e-6, "N");
        QCOMPARE(edit.hand.output().contacts, before.contacts);
        QCOMPARE(edit.hand.state.model.restarts, restarts);
    }

    void hiddenUnderTheFingerAndShownAgainItIsFeltAgain() {
        Editing edit(ballAndSheet());
        edit.hand.to({0, 0, 0.04});
        edit.hand.go({0, 0, kBall - 0.004}, 0.05);
        for (const bool visible : {false, true}) {
            edit.scene.objects[0].visible = visible;
            edit.recompile();
            for (int i = 0; i < 5; ++i)
                edit.hand.to(edit.hand.finger());
            QCOMPARE(edit.hand.output().contacts > 0, visible);
        }
        QCOMPARE_GT(edit.hand.output().proxy.z(), kBall);
    }

    void theFirstPlaceIsTheFingersAlsoInsideAHollow() {
        Hand hand(worldOf(ball(kBall, 3), frictionless(), kRadius));
        QCOMPARE(hand.to({0, 0, 0.01}).proxy, Vec3(0, 0, 0.01));
        hand.go({0, 0, 0.05}, 0.05); // held by the wall, from inside
        QCOMPARE_LT(hand.output().proxy.norm(), kBall);
    }

    void aFingerThatIsFoundInsideHasItsProxyOutside() {
        Editing edit(ballAndSheet());
        edit.hand.to({0, 0, 0.04});
        edit.hand.go({0, 0, 0.02}, 0.05);
        const std::uint32_t restarts = edit.hand.state.model.restarts;
        const Vec3 finger(0.021, 0, 0.004); // elsewhere inside of it, near another wall
        const Vec3 proxy = edit.hand.find(finger).proxy;
        QCOMPARE_GE(clearanceOf(*edit.world, proxy), kRadius * (1 - 2 * kSkin));
        QVERIFY(!isInside(edit.world->obstacles[0], proxy));
        COMPARE_NEAR(proxy, (kBall + kRadius) * finger.normalized(), 2e-3, "m");
        QCOMPARE(edit.hand.state.model.restarts, restarts + 1);
        // Outside of everything it begins at the finger, wherever the proxy was.
        QCOMPARE(edit.hand.find({0, 0.05, 0}).proxy, Vec3(0, 0.05, 0));
    }

    void aFingerThatIsFoundInItsHollowStaysThere() {
        Hand hand(worldOf(ball(kBall, 3), frictionless(), kRadius));
        hand.to({0, 0, 0.01});
        QCOMPARE(hand.find({0, 0.01, 0}).proxy, Vec3(0, 0.01, 0));
        // Having left it unseen, it is outside, and the hollow is closed to it from then on.
        QCOMPARE(hand.find({0, 0, 0.04}).proxy, Vec3(0, 0, 0.04));
        QCOMPARE_GT(hand.find({0, 0, 0.01}).proxy.norm(), kBall);
    }

    void anEditElsewhereLeavesTheProxyInItsHollow() {
        Editing edit(ballAndSheet());
        edit.hand.to({0, 0, 0.01});
        edit.scene.objects[1].pose.translation.z() -= 0.01;
        edit.recompile();
        QCOMPARE(edit.hand.output().proxy, Vec3(0, 0, 0.01));
        edit.scene.objects[0].pose.translation.x() += 0.001; // now it is the hollow that lands on the finger
        edit.recompile();
        QCOMPARE_GT(edit.hand.output().proxy.norm(), kBall);
    }

    void aStartOnASurfaceIsBesideIt_data() {
        QTest::addColumn<double>("height");
        QTest::newRow("above") << 0.2e-3;
        QTest::newRow("on it") << 0.0;
        QTest::newRow("below") << -0.4e-3;
    }

    void aStartOnASurfaceIsBesideIt() {
        QFETCH(double, height);
        Hand hand(worldOf(sheet(0.05), frictionless(), kRadius));
        const double side = height < 0 ? -1 : 1;
        QCOMPARE_GE(side * hand.to({0, 0, height}).proxy.z(), kRadius * (1 - 2 * kSkin));
    }

    void aStartExactlyInASheetIsBesideItToo() {
        Rng rng(74);
        for (int i = 0; i < 1000; ++i) {
            Hand hand(worldOf(sheet(0.1), frictionless(), kRadius));
            const Vec3 start(uniform(rng, -0.09, 0.09), uniform(rng, -0.09, 0.09), 0);
            const Vec3 proxy = hand.to(start).proxy;
            COMPARE_NEAR(proxy - start, kRadius * Vec3::UnitZ(), 2e-3 * kRadius, "m");
        }
    }

    void aRestartIsAtTheFinger() {
        Hand hand(worldOf(sheet(0.05), frictionless(), kRadius));
        hand.to({0, 0, 0.01});
        hand.go({0, 0, -0.02}, 0.05);
        QCOMPARE_GT(hand.output().proxy.z(), 0);
        const HapticOutput output =
            hapticStep(hand.world(), hand.state, {hand.finger(), Vec3::Zero(), true}, kMillisecond);
        QCOMPARE(output.proxy, hand.finger());
        QCOMPARE(hand.state.model.restarts, 2u);
    }

    void whereverSolidsLandTheProxyIsOutside() {
        Rng rng(73);
        int moved = 0;
        for (int i = 0; i < 400; ++i) {
            Scene scene;
            scene.proxyRadius = kRadius;
            Editing edit(scene);
            edit.hand.to(inBox(rng, 0.015));
            const Vec3 before = edit.hand.output().proxy;
            for (int n = 1 + int(rng() % 4); n > 0; --n)
                edit.scene.add(objectOf(ball(uniform(rng, 0.004, 0.03), 2), inBox(rng, 0.02)));
            edit.recompile();
            const Vec3 proxy = edit.hand.output().proxy;
            moved += proxy != before;
            QCOMPARE_GE(clearanceOf(*edit.world, proxy), kRadius * (1 - 2 * kSkin));
            for (const Obstacle& obstacle : edit.world->obstacles)
                QVERIFY(!isInside(obstacle, proxy));
        }
        QCOMPARE_GT(moved, 100);
    }

    void aSlotThatIsTooNarrowHasNoPlace() {
        const Soup walls = channel(1, 1.5 * kRadius); // a metre long: nowhere near is there room
        const CollisionMesh mesh{walls, SphereTree(*walls)};
        const std::vector<Obstacle> obstacles{{.mesh = &mesh}};
        const auto place = clearPlace(obstacles, {}, kRadius, Vec3::Zero(), {kNoShape});
        if (place) QCOMPARE_GE(nearestOn(mesh, *place).distance, kRadius);
    }
};

TACTUM_TEST(TestSceneChanges)

} // namespace test_scene_changes

#include "test_scene_changes.moc"
