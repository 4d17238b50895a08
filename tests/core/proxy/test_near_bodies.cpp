// A hierarchy over many bodies leaves out only what is far, and nobody feels that it is there.
//
// The judges are the distance to every triangle, and the same steps with every body looked at. They would be
// wrong if both ways left out the same body: then the first test would see it.

#include <QTest>

#include "core/collision/nearest.h"
#include "core/proxy/near_bodies.h"
#include "core/proxy/place.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/movers.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_near_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

Vec3 inCube(Rng& rng, double half) {
    return {uniform(rng, -half, half), uniform(rng, -half, half), uniform(rng, -half, half)};
}

/// Plates of several sizes, or what else is given, anyhow turned, in a cube.
struct Heap {
    explicit Heap(int count, double half = 0.1, const Soup& soup = plate(0.004, 0.002),
                  const Soup& large = plate(0.015, 0.001))
        : material(rough(0.4, 0.3)) {
        meshes = {CollisionMesh{soup, SphereTree(*soup)}, CollisionMesh{large, SphereTree(*large)}};
        Rng rng(3);
        for (int i = 0; i < count; ++i) {
            Obstacle obstacle;
            obstacle.mesh = &meshes[i % 5 == 0];
            obstacle.pose = {Quat(Eigen::AngleAxisd(uniform(rng, 0, 3), inCube(rng, 1).normalized())),
                             inCube(rng, half)};
            obstacle.materials = {&material, 1};
            obstacles.push_back(obstacle);
        }
    }

    /// Lets every so many of them swing, slide or turn.
    std::vector<Mover> moved(std::size_t every) {
        const std::array motions{swinging({0.05, 0.02, 0}, 2), sliding({0, 0.01, 0}, 3),
                                 turning({1, 2, 0}, 4)};
        std::vector<Mover> movers;
        for (std::size_t body = 0; body < obstacles.size(); body += every) {
            obstacles[body].mover = int(movers.size());
            movers.push_back(
                {std::uint32_t(body), obstacles[body].pose, motions[body / every % motions.size()]});
        }
        return movers;
    }

    Material material;
    std::vector<CollisionMesh> meshes;
    std::vector<Obstacle> obstacles;
};

} // namespace

class NearBodiesTest : public QObject {
    Q_OBJECT

private slots:
    void nothingThatIsNearIsLeftOut();
    void mostOfWhatIsFarIsLeftOut();
    void theStepIsTheSame_data();
    void theStepIsTheSame();
    void theClearPlaceIsTheSame();
    void whatMovesIsSeenOnAllOfItsWay();
};

void NearBodiesTest::nothingThatIsNearIsLeftOut() {
    for (int count : {0, 1, 8, 9, 40, 700}) {
        const Heap heap(count);
        const NearBodies near(heap.obstacles);
        Rng rng(4);
        for (int trial = 0; trial < 100; ++trial) {
            const Vec3 at = inCube(rng, 0.12);
            const double reach = uniform(rng, 0, 0.02);
            std::vector<int> seen(heap.obstacles.size());
            near.forEach(at, reach, [&](std::uint32_t body) { ++seen[body]; });
            for (std::size_t i = 0; i < seen.size(); ++i) {
                QCOMPARE_LE(seen[i], 1);
                const Obstacle& obstacle = heap.obstacles[i];
                if (nearestOn(*obstacle.mesh, obstacle.pose.applyInverse(at), reach).distance < reach)
                    QCOMPARE(seen[i], 1);
            }
        }
    }
}

// Ten times as many bodies, as dense: as many are looked at.
void NearBodiesTest::mostOfWhatIsFarIsLeftOut() {
    const auto looked = [](int count, double half) {
        const Heap heap(count, half);
        const NearBodies near(heap.obstacles);
        Rng rng(5);
        int seen = 0;
        for (int trial = 0; trial < 200; ++trial)
            near.forEach(inCube(rng, 0.5 * half), 1e-3, [&](std::uint32_t) { ++seen; });
        return seen / 200.0;
    };
    const double few = looked(500, 0.1), many = looked(5000, 0.1 * std::cbrt(10.0));
    qInfo("looked at: %.1f of 500, %.1f of 5000", few, many);
    QCOMPARE_LT(many, 1.3 * few);
    QCOMPARE_LT(many, 50);
}

void NearBodiesTest::theStepIsTheSame_data() {
    QTest::addColumn<bool>("oneSided");
    QTest::addColumn<bool>("moving");
    QTest::newRow("at rest") << false << false;
    QTest::newRow("from one side") << true << false;
    QTest::newRow("some move") << false << true;
    QTest::newRow("from one side, some move") << true << true;
}

void NearBodiesTest::theStepIsTheSame() {
    QFETCH(bool, oneSided);
    QFETCH(bool, moving);
    static constexpr std::array kSides{Sides::Front, Sides::Back};
    Heap heap(600, 0.05);
    for (std::size_t i = 0; oneSided && i < heap.obstacles.size(); i += 3)
        heap.obstacles[i].sides = {&kSides[i % 2], 1};
    const std::vector<Mover> movers = moving ? heap.moved(4) : std::vector<Mover>();
    const NearBodies near(heap.obstacles, movers);
    ProxyState with, without;
    Rng rng(6);
    Vec3 finger(0.07, 0, 0);
    restart(with, finger);
    restart(without, finger);
    int touched = 0;
    double time = 0;
    for (int leg = 0; leg < 60; ++leg) {
        const Vec3 target = inCube(rng, 0.05), way = (target - finger) / 100;
        for (int i = 0; i < 100; ++i, time += kMillisecond) {
            finger += way;
            const StepMotions now(movers, time, time + kMillisecond, {});
            moveAndUpdate(with, heap.obstacles, 1e-3, finger, kMillisecond, now, kMaxRounds, &near);
            moveAndUpdate(without, heap.obstacles, 1e-3, finger, kMillisecond, now);
            COMPARE_NEAR(with.position, without.position, 1e-9, "m");
            touched += with.contactCount > 0;
        }
    }
    QCOMPARE_GT(touched, 1000);
}

// Overlapped, inside of cubes that came to where it is, between several: the way out is the same one.
void NearBodiesTest::theClearPlaceIsTheSame() {
    Heap heap(60, 0.05, cube(0.003), cube(0.01));
    for (CollisionMesh& mesh : heap.meshes)
        mesh.closed = true;
    for (std::size_t i = 0; i < heap.obstacles.size(); i += 2)
        heap.obstacles[i].placedIn = 1;
    const NearBodies near(heap.obstacles);
    Rng rng(7);
    int pushed = 0, inside = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const double radius = std::array{1e-3, 5e-3, 2e-2}[std::size_t(trial % 3)];
        const Vec3 wanted = inCube(rng, 0.05);
        FormerPlace former{0};
        if (trial % 2) former.at_W = inCube(rng, 0.05);
        const auto with = clearPlace(heap.obstacles, {}, radius, wanted, former, &near),
                   without = clearPlace(heap.obstacles, {}, radius, wanted, former);
        QCOMPARE(with.has_value(), without.has_value());
        if (!with) continue;
        COMPARE_NEAR(*with, *without, 1e-12, "m");
        pushed += *with != wanted;
        inside += (*with - wanted).norm() > radius;
    }
    qInfo("%d pushed off, %d from inside", pushed, inside);
    QCOMPARE_GT(pushed, 1000);
    QCOMPARE_GT(inside, 100);
}

// Wherever it is at some time of its course; and where it never comes it is not looked at.
void NearBodiesTest::whatMovesIsSeenOnAllOfItsWay() {
    Rng rng(8);
    Heap heap(60, 0.1);
    const std::vector<Mover> movers = heap.moved(2);
    const NearBodies near(heap.obstacles, movers);
    int reached = 0, looked = 0;
    for (int trial = 0; trial < 10000; ++trial) {
        const Vec3 at = inCube(rng, 0.12);
        const double reach = 0.003, time = uniform(rng, 0, 5);
        std::vector<int> seen(heap.obstacles.size());
        near.forEach(at, reach, [&](std::uint32_t body) { ++seen[body], ++looked; });
        for (const Mover& mover : movers) {
            const Vec3 at_B = mover.poseAt(time).applyInverse(at);
            if (nearestOn(*heap.obstacles[mover.body].mesh, at_B, reach).distance >= reach) continue;
            QCOMPARE(seen[mover.body], 1);
            ++reached;
        }
    }
    QCOMPARE_GT(reached, 50);
    QCOMPARE_LT(looked, 10000 * 30);
    near.forEach({50, 0, 0}, 1e-3, [](std::uint32_t) { QFAIL("nothing is there"); });
}

TACTUM_TEST(NearBodiesTest)

} // namespace test_near_bodies

#include "test_near_bodies.moc"
