// What an edit changes in what is felt, against closed forms on a plane.
#include <QTest>

#include "core/haptics/compile.h"
#include "core/haptics/touch_difference.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_touch_difference {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3, kStep = 1e-3;

Scene plane(double stiffness, double friction = 0) {
    Material material;
    material.stiffness = stiffness;
    material.damping = 0;
    material.staticFriction = material.dynamicFriction = friction;
    return sceneOf(sheet(0.2), material, kRadius);
}

/// From above ever deeper, to `depth` below where the surface begins to push, and along x in the second half.
std::vector<FingerPoint> stroke(double depth) {
    std::vector<FingerPoint> path;
    for (int i = 0; i <= 1000; ++i) {
        const double z = 0.002 - (0.002 + depth) * i / 1000;
        path.push_back({kStep * i, Vec3(i < 500 ? 0 : 4e-5 * (i - 500), 0.001, kRadius + z)});
    }
    return path;
}

TouchTrace touch(const Scene& scene, const std::vector<FingerPoint>& path) {
    const auto world = compile(scene);
    if (!world) qFatal("%s", world.error().text.c_str());
    return replay(**world, path);
}

} // namespace

class TestTouchDifference : public QObject {
    Q_OBJECT

private slots:
    void equalScenesDifferByNothing();
    void twiceTheStiffnessIsTwiceTheForce();
    void frictionShowsInRatioAndWork();
    void whatTheDeviceCannotGiveIsNotCompared();
    void theLongerOneIsCut();
    void theCsvReadsBack();
    void stopsWhenItIsCancelled();
};

void TestTouchDifference::equalScenesDifferByNothing() {
    const Scene scene = plane(500, 0.4);
    const TouchDifference same = differenceOf(touch(scene, stroke(0.003)), touch(scene, stroke(0.003)));
    QCOMPARE_EQ(same.rms, 0);
    QCOMPARE_EQ(same.largest, 0);
    QCOMPARE_EQ(same.workA, same.workB);
    QCOMPARE_EQ(same.ratioA, same.ratioB);
    QCOMPARE_NE(same.workA, 0);
    QCOMPARE_GT(same.ratioA, 0);
    QCOMPARE(same.steps, std::size_t(1001));
}

void TestTouchDifference::twiceTheStiffnessIsTwiceTheForce() {
    constexpr double kStiffness1 = 400, kDepth = 0.003;
    const auto path = stroke(kDepth);
    const TouchDifference said =
        differenceOf(touch(plane(kStiffness1), path), touch(plane(2 * kStiffness1), path));
    // Without friction the force is stiffness times depth, so the difference is that of A.
    double squares = 0;
    for (const FingerPoint& point : path)
        squares += std::pow(kStiffness1 * std::max(0.0, kRadius - point.position.z()), 2);
    COMPARE_NEAR(said.rms, std::sqrt(squares / double(path.size())), 1e-9, "N");
    COMPARE_NEAR(said.largest, kStiffness1 * kDepth, 1e-9, "N");
    COMPARE_NEAR(said.largestWhere.z(), kRadius - kDepth, 1e-9, "m");
    COMPARE_NEAR(said.largestAt, 1, 1e-9, "s");
    // To press a spring takes half its stiffness times the square of the way.
    COMPARE_NEAR(said.workA, 0.5 * kStiffness1 * kDepth * kDepth, 1e-9, "J");
    COMPARE_NEAR(said.workB, kStiffness1 * kDepth * kDepth, 1e-9, "J");
    QCOMPARE_LT(said.ratioA, 1e-9);
    QCOMPARE_LT(said.ratioB, 1e-9);
}

void TestTouchDifference::frictionShowsInRatioAndWork() {
    // Down in a few steps, and then along the surface for so long that the beginning hardly counts.
    std::vector<FingerPoint> path;
    for (int i = -10; i <= 4000; ++i)
        path.push_back(
            {kStep * i, Vec3(-0.08 + 4e-5 * std::max(0, i), 0.001, kRadius - 0.002 - 4e-4 * std::min(0, i))});
    const TouchDifference said = differenceOf(touch(plane(500, 0.2), path), touch(plane(500, 0.5), path));
    COMPARE_NEAR(said.ratioA, 0.2, 0.004, "");
    COMPARE_NEAR(said.ratioB, 0.5, 0.01, "");
    const double normal = 500 * 0.002, way = 0.16, press = 0.5 * normal * 0.002;
    COMPARE_NEAR(said.workA, 0.2 * normal * way + press, 0.02 * normal * way, "J");
    COMPARE_NEAR(said.workB, 0.5 * normal * way + press, 0.02 * normal * way, "J");
    COMPARE_NEAR(said.largest, 0.3 * normal, 0.02 * normal, "N");
}

/// Two walls that both ask for more than the device has are felt alike there.
void TestTouchDifference::whatTheDeviceCannotGiveIsNotCompared() {
    const auto path = stroke(0.02);
    const TouchTrace asked = touch(plane(500, 0.3), path);
    TouchTrace a = asked, b = touch(plane(1000, 0.3), path);
    QCOMPARE_GT(b.back().force.norm(), 19);
    limitForces(a, 4);
    limitForces(b, 4);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double force = asked[i].force.norm();
        QCOMPARE_LE(a[i].force.norm(), 4 * (1 + 1e-12));
        if (force <= 4) QCOMPARE_EQ(a[i].force, asked[i].force);
        COMPARE_NEAR(a[i].force.cross(asked[i].force).norm(), 0, 1e-9, "N2");
        COMPARE_NEAR(a[i].tangential * force, asked[i].tangential * a[i].force.norm(), 1e-9, "N2");
    }
    COMPARE_NEAR(b.back().force, a.back().force, 1e-9, "N");
    const TouchDifference said = differenceOf(a, b);
    COMPARE_NEAR(said.ratioA, said.ratioB, 0.02, "");
    QCOMPARE_LE(said.largest, 4);
    TouchTrace unknown = asked;
    limitForces(unknown, 0);
    QCOMPARE_EQ(unknown.back().force, asked.back().force);
}

void TestTouchDifference::theLongerOneIsCut() {
    const auto path = stroke(0.003);
    TouchTrace a = touch(plane(400), path), b = touch(plane(800), path);
    b.resize(300);
    QCOMPARE(differenceOf(a, b).steps, std::size_t(300));
    QCOMPARE(differenceOf(b, a).steps, std::size_t(300));
    QVERIFY(differenceOf({}, a) == TouchDifference{});
    QCOMPARE(QByteArray::fromStdString(differenceCsv(a, b)).count('\n'), 301);
}

void TestTouchDifference::theCsvReadsBack() {
    const auto path = stroke(0.003);
    const TouchTrace a = touch(plane(400), path), b = touch(plane(800), path);
    const QList<QByteArray> lines = QByteArray::fromStdString(differenceCsv(a, b)).split('\n');
    const qsizetype columns = lines[0].split(',').size();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const QList<QByteArray> fields = lines[qsizetype(i) + 1].split(',');
        QCOMPARE(fields.size(), columns);
        QCOMPARE(fields[0].toDouble(), a[i].t);
        QCOMPARE(fields[6].toDouble(), a[i].force.z());
        QCOMPARE(fields[9].toDouble(), b[i].force.z());
        QCOMPARE(fields[10].toDouble(), (b[i].force - a[i].force).norm());
    }
}

void TestTouchDifference::stopsWhenItIsCancelled() {
    const auto world = compile(plane(400));
    std::atomic<bool> cancelled = false;
    Progress progress;
    progress.cancelled = &cancelled;
    progress.report = [&](double fraction) { cancelled = fraction > 0.4; };
    QVERIFY(!replay(**world, stroke(0.003), progress));
    cancelled = false;
    progress.report = nullptr;
    QCOMPARE(replay(**world, stroke(0.003), progress)->size(), std::size_t(1001));
}

TACTUM_TEST(TestTouchDifference)

} // namespace test_touch_difference

#include "test_touch_difference.moc"
