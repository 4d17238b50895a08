#include <QTest>

#include "core/runtime/trace_point.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_trace_point {

using namespace tactum;

namespace {

LocalContactModel modelOf(std::initializer_list<Vec3> normals) {
    LocalContactModel model;
    model.valid = true;
    model.proxy = {1, 2, 3};
    for (const Vec3& normal : normals)
        model.plane[std::size_t(model.planes++)] = {normal.normalized(), -1e-4};
    return model;
}

TracePoint pointOf(const Vec3& force) {
    TracePoint point;
    point.force = force;
    return point;
}

} // namespace

class TestTracePoint : public QObject {
    Q_OBJECT
private slots:
    void onePlaneDividesTheForceByItsNormal() {
        const TracePoint point = tracePoint(pointOf({0.3, 2, 0.4}), modelOf({Vec3::UnitY()}));
        QVERIFY(point.touching);
        QCOMPARE_EQ(point.proxy, Vec3(1, 2, 3));
        COMPARE_NEAR(point.normalForce, 2, 1e-12, "N");
        COMPARE_NEAR(point.tangentialForce, 0.5, 1e-12, "N");
    }

    void aGrooveTakesAllAcrossItAndLeavesWhatIsAlongIt() {
        const auto groove = modelOf({{1, 1, 0}, {-1, 1, 0}});
        const TracePoint point = tracePoint(pointOf({0.4, 1, 0.3}), groove);
        COMPARE_NEAR(point.normalForce, std::hypot(0.4, 1), 1e-12, "N");
        COMPARE_NEAR(point.tangentialForce, 0.3, 1e-12, "N");
    }

    void withoutAPushNothingIsTouched() {
        const TracePoint free = tracePoint(pointOf(Vec3::Zero()), modelOf({Vec3::UnitY()}));
        QVERIFY(!free.touching);
        QCOMPARE_EQ(free.normalForce, 0);
        QCOMPARE_EQ(free.tangentialForce, 0);
        TracePoint unknown = pointOf({0, 1, 0});
        unknown.finger = {5, 5, 5};
        unknown = tracePoint(unknown, {});
        QVERIFY(!unknown.touching);
        QCOMPARE_EQ(unknown.proxy, Vec3(5, 5, 5));
    }
};

TACTUM_TEST(TestTracePoint)

} // namespace test_trace_point

#include "test_trace_point.moc"
