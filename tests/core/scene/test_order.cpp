// The list of objects in another order, and objects in line with each other.
#include <QTest>

#include "core/scene/object_bounds.h"
#include "core/scene/order.h"
#include "core/scene/standing.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_order {

using namespace tactum;
using namespace tactum::test;

namespace {

struct Row {
    Scene scene;
    ObjectId a = add(scene, "a", box({1, 1, 1}), {Quat::Identity(), {0, 0, 0}});
    ObjectId b = add(scene, "b", box({1, 2, 1}), {Quat::Identity(), {1.5, 3, 0}});
    ObjectId c = add(scene, "c", box({4, 1, 1}), {Quat::Identity(), {5, 1, 2}});
    ObjectId d = add(scene, "d", box({2, 1, 1}), {Quat::Identity(), {9, -1, 4}});

    std::string names() const {
        std::string all;
        for (const SceneObject& object : scene.objects)
            all += object.name;
        return all;
    }
    std::vector<GoingAlong> each(std::initializer_list<ObjectId> ids) const {
        std::vector<GoingAlong> parts;
        for (const ObjectId id : ids)
            parts.push_back(goingAlong(scene, std::array{id}));
        return parts;
    }
    Bounds boxOf(ObjectId id) const { return boundsOf(*scene.find(id)); }
    double middle(ObjectId id) const { return boxOf(id).centre().x(); }
};

} // namespace

class TestOrder : public QObject {
    Q_OBJECT

private slots:
    void objectsComeBeforeAnother_data() {
        QTest::addColumn<QByteArray>("moved");
        QTest::addColumn<int>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("to the front") << QByteArray("c") << 1 << QByteArray("cabd");
        QTest::newRow("to the end") << QByteArray("a") << 0 << QByteArray("bcda");
        QTest::newRow("down by one") << QByteArray("a") << 3 << QByteArray("bacd");
        QTest::newRow("two that are apart") << QByteArray("ad") << 3 << QByteArray("badc");
        QTest::newRow("before itself") << QByteArray("b") << 2 << QByteArray("abcd");
        QTest::newRow("before one of themselves") << QByteArray("bd") << 2 << QByteArray("abdc");
        QTest::newRow("before what there is not") << QByteArray("b") << 99 << QByteArray("acdb");
        QTest::newRow("none") << QByteArray("") << 1 << QByteArray("abcd");
        QTest::newRow("all") << QByteArray("abcd") << 3 << QByteArray("abcd");
    }
    void objectsComeBeforeAnother() {
        QFETCH(QByteArray, moved);
        QFETCH(int, before);
        QFETCH(QByteArray, after);
        Row row;
        std::vector<ObjectId> ids;
        for (const char name : moved)
            ids.push_back(ObjectId(name - 'a' + 1));
        reorder(row.scene, ids, ObjectId(before));
        QCOMPARE(row.names(), after.toStdString());
        for (const SceneObject& object : row.scene.objects)
            QCOMPARE(row.scene.find(object.id), &object);
    }

    void oneUpAndOneDown() {
        Row row;
        moveUp(row.scene, std::array{row.c});
        QCOMPARE(row.names(), "acbd");
        moveDown(row.scene, std::array{row.a, row.b});
        QCOMPARE(row.names(), "cdab");
        moveDown(row.scene, std::array{row.a, row.b});
        QCOMPARE(row.names(), "cdab");
        moveUp(row.scene, std::array{row.c});
        QCOMPARE(row.names(), "cdab");
        moveUp(row.scene, std::array{ObjectId(99)});
        moveDown(row.scene, std::array{ObjectId(99)});
        QCOMPARE(row.names(), "cdab");
    }

    void sidesComeIntoLine() {
        for (int axis = 0; axis < 3; ++axis) {
            Row low, middle, high;
            align(low.scene, low.each({low.a, low.b, low.c}), low.boxOf(low.d), axis, BoxSide::Low);
            align(middle.scene, middle.each({middle.a, middle.b}), middle.boxOf(middle.d), axis,
                  BoxSide::Middle);
            align(high.scene, high.each({high.c}), high.boxOf(high.d), axis, BoxSide::High);
            COMPARE_NEAR(low.boxOf(low.b).low[axis], low.boxOf(low.d).low[axis], 1e-12, "m");
            COMPARE_NEAR(middle.boxOf(middle.b).centre()[axis], middle.boxOf(middle.d).centre()[axis], 1e-12,
                         "m");
            COMPARE_NEAR(high.boxOf(high.c).high[axis], high.boxOf(high.d).high[axis], 1e-12, "m");
            const int other = (axis + 1) % 3;
            QCOMPARE_EQ(low.boxOf(low.b).low[other], Row().boxOf(2).low[other]);
            QCOMPARE_EQ(low.scene.find(low.d)->pose.translation, Row().scene.find(4)->pose.translation);
        }
    }

    /// Middles at 0, 1.5, 5 and 9 come to 0, 3, 6 and 9.
    void middlesComeToEvenDistances() {
        Row row;
        distribute(row.scene, row.each({row.c, row.a, row.d, row.b}), 0);
        for (const auto& [id, at] : {std::pair(row.a, 0.0), {row.b, 3}, {row.c, 6}, {row.d, 9}})
            COMPARE_NEAR(row.middle(id), at, 1e-12, "m");
        Row two;
        distribute(two.scene, two.each({two.a, two.d}), 0);
        QVERIFY2(two.middle(two.d) == 9 && two.middle(two.a) == 0, "two stay");
    }

    /// Door and post: what hangs on it comes along, and its joint.
    void whatGoesAlongIsOne() {
        Doorway way;
        Scene& scene = way.scene;
        const ObjectId stone = add(scene, "stone", box({0.1, 0.1, 0.1}), {Quat::Identity(), {1, 0, 0}});
        const Vec3 apart = scene.find(way.door)->pose.translation - scene.find(way.post)->pose.translation;
        const GoingAlong both = goingAlong(scene, std::array{way.post, way.door});
        align(scene, std::array{both}, boundsOf(*scene.find(stone)), 0, BoxSide::Low);
        COMPARE_NEAR(boundsOf(scene, both.objects).low.x(), 0.95, 1e-12, "m");
        COMPARE_NEAR(scene.find(way.door)->pose.translation - scene.find(way.post)->pose.translation, apart,
                     1e-12, "m");
    }
};

TACTUM_TEST(TestOrder)

} // namespace test_order

#include "test_order.moc"
