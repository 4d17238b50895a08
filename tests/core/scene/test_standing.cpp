// Where things find room: on the floor, beside what is there, never inside of it; and what they stand on.
#include <QTest>

#include "core/scene/object_bounds.h"
#include "core/scene/standing.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_standing {

using namespace tactum;
using namespace tactum::test;

namespace {

Bounds boxOf(const Vec3& size, const Vec3& at) {
    Bounds bounds;
    bounds.add(at - 0.5 * size), bounds.add(at + 0.5 * size);
    return bounds;
}

ObjectId put(Scene& scene, const Vec3& size, const Vec3& at) {
    return add(scene, "thing", box(size), {Quat::Identity(), at});
}

/// Takes its way to room.
ObjectId arrive(Scene& scene, const Vec3& size) {
    const Vec3 from(0.3, 7, -0.2);
    return put(scene, size, from + wayToRoom(scene, boxOf(size, from)));
}

bool overlap(const Bounds& a, const Bounds& b) {
    return ((a.low.array() + 1e-9 < b.high.array()) && (b.low.array() + 1e-9 < a.high.array())).all();
}

bool anyOverlap(const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (overlap(boundsOf(scene.objects[i]), boundsOf(scene.objects[j]))) return true;
    return false;
}

} // namespace

class TestStanding : public QObject {
    Q_OBJECT

private slots:
    void theFirstStandsOnTheOrigin() {
        Scene scene;
        arrive(scene, {0.1, 0.2, 0.1});
        COMPARE_NEAR(boundsOf(scene.objects[0]).centre(), (Vec3(0, 0.1, 0)), 1e-12, "m");
    }

    // Ten of several sizes around each other: near, on one level, none inside of another.
    void besideEachOther() {
        Scene scene;
        for (int i = 0; i < 10; ++i) {
            const ObjectId id = arrive(scene, {0.02 + 0.01 * (i % 3), 0.05 + 0.01 * i, 0.03});
            COMPARE_NEAR(boundsOf(*scene.find(id)).low.y(), 0, 1e-12, "m");
        }
        QVERIFY(!anyOverlap(scene));
        const Vec3 size = boundsOf(scene).high - boundsOf(scene).low;
        QCOMPARE_LT(size.x(), 0.3);
        QCOMPARE_LT(size.z(), 0.3);
    }

    // On the floor as long as there is room, then beside it, as low as it lies.
    void onTheFloor() {
        Scene scene;
        put(scene, {0.2, 0.01, 0.2}, {1, -0.005, 1});
        int standing = 0;
        for (int i = 0; i < 12; ++i) {
            const Bounds there = boundsOf(*scene.find(arrive(scene, {0.05, 0.1, 0.05})));
            const bool onFloor = std::abs(there.low.y()) < 1e-12;
            standing += onFloor;
            if (!onFloor) COMPARE_NEAR(there.low.y(), -0.01, 1e-12, "m");
        }
        QCOMPARE_GE(standing, 5);
        QCOMPARE_LT(standing, 12);
        QVERIFY(!anyOverlap(scene));
        COMPARE_NEAR(boundsOf(scene.objects[1]).centre(), (Vec3(1, 0.05, 1)), 1e-12, "m");
    }

    // Plates side by side are no floor, and what is hidden takes no room.
    void whatIsNoFloor() {
        Scene scene;
        put(scene, {0.1, 0.01, 0.1}, {0, 0, 0});
        put(scene, {0.1, 0.01, 0.1}, {0.12, 0, 0});
        const Bounds there = boundsOf(*scene.find(arrive(scene, {0.02, 0.02, 0.02})));
        COMPARE_NEAR(there.low.y(), -0.005, 1e-12, "m");
        QVERIFY(!anyOverlap(scene));
        Scene hidden;
        put(hidden, {1, 1, 1}, {0, 0, 0});
        hidden.objects[0].visible = false;
        arrive(hidden, {0.02, 0.02, 0.02});
        COMPARE_NEAR(boundsOf(hidden.objects[1]).centre(), (Vec3(0, 0.01, 0)), 1e-12, "m");
    }

    void aDoubleComesBesideAtItsHeight() {
        Scene scene;
        put(scene, {0.2, 0.01, 0.2}, {0, 0, 0});
        const Bounds shelf = boundsOf(*scene.find(put(scene, {0.05, 0.02, 0.03}, {0.03, 0.2, 0})));
        const Vec3 way = wayBeside(scene, shelf);
        COMPARE_NEAR(way, (Vec3(0, 0, 0.035)), 1e-12, "m"); // the shorter one: along z
        COMPARE_NEAR(wayBeside(scene, Bounds()), (Vec3(0, 0, 0)), 1e-12, "m");
        // Along one axis, however the others around it lie: rows are made of doubles.
        for (const Vec3& other : {Vec3(0.05, 0.2, 0.04), Vec3(0, 0.2, -0.035), Vec3(0.09, 0.2, 0.01)}) {
            put(scene, {0.05, 0.02, 0.03}, other);
            const Vec3 next = wayBeside(scene, shelf);
            COMPARE_NEAR(std::min(std::abs(next.x()), std::abs(next.z())), 0, 1e-12, "m");
            COMPARE_NEAR(next.y(), 0, 1e-12, "m");
            QCOMPARE_GT(next.norm(), 0.03);
        }
    }

    void downToTheGround() {
        Scene scene;
        const auto way = [&](ObjectId id) { return wayToGround(scene, goingAlong(scene, std::array{id})); };
        const ObjectId thing = put(scene, {0.02, 0.02, 0.02}, {0, 0.5, 0});
        COMPARE_NEAR(way(thing), -0.49, 1e-12, "m"); // alone: onto y = 0
        put(scene, {0.2, 0.01, 0.2}, {0, -0.005, 0});
        const ObjectId table = put(scene, {0.1, 0.1, 0.1}, {0, 0.05, 0});
        COMPARE_NEAR(way(thing), -0.39, 1e-12, "m"); // onto the table
        scene.find(thing)->pose.translation = {0.08, 0.5, 0};
        COMPARE_NEAR(way(thing), -0.49, 1e-12, "m"); // beside the table, onto the floor
        scene.find(thing)->pose.translation = {0.08, -0.5, 0};
        COMPARE_NEAR(way(thing), 0.51, 1e-12, "m"); // and up onto it
        scene.find(thing)->pose.translation = {0.3, 0.5, 0};
        COMPARE_NEAR(way(thing), -0.5, 1e-12, "m"); // off the floor, as low as that
        COMPARE_NEAR(way(table), 0, 1e-12, "m");
    }
};

TACTUM_TEST(TestStanding)

} // namespace test_standing

#include "test_standing.moc"
