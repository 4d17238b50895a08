// Bodies that leave the proxy too little room, and bodies that jump.

#include <QTest>

#include "tests/core/proxy/carry_stage.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_squeeze {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Where the finger is found, and no body that has passed is felt for it.
void restartAt(Stage& stage, const Vec3& p) {
    stage.state.position = stage.state.finger = p;
}

} // namespace

class SqueezeTest : public QObject {
    Q_OBJECT

private slots:
    void isSqueezedEvenlyAndFreed();
    void aSqueezeWithinAStepIsTold();
    void isPassedWithoutRoomAndFelt();
    void whatPassedKeepsItsPlaceOnTheBody();
    void eachBodyIsFeltAgainByItself();
    void whatIsNotFeltFromThereIsNotInTheWay();
    void aJumpLetsGo();
    void aSmallJumpIsSwept();
};

// A box drives the proxy against a wall and back: its centre stays between them while there is any room to
// speak of, evenly far from both, and as soon as there is room for all of it, it is clear of both.
void SqueezeTest::isSqueezedEvenlyAndFreed() {
    for (double mu : {0.0, 0.5})
        for (double depth : {0.0, 0.02}) {
            Stage stage(rough(mu, mu));
            stage.addStatic(sheet(0.05));
            const Vec3 half(0.02, 0.02, 0.005);
            const int mover = stage.addMover(box(half), at({0, 0, 0.01}));
            stage.startAt({0.001, 0.002, 0.0015});
            int squeezed = 0;
            for (int i = 0; i <= 200; ++i) {
                // From 5 mm down to 0.3 mm of room, and back.
                const double room = 0.005 - 0.0047 * std::sin(std::numbers::pi * i / 200);
                stage.put(mover, at({0, 0, room + half.z()}));
                const ProxyReport report = stage.step({0.001, 0.002, -depth});
                const double z = stage.state.position.z();
                QVERIFY(!report.passed);
                QCOMPARE(report.squeezed, room < 2 * kRadius - 1e-9);
                squeezed += report.squeezed;
                if (room >= 2 * kRadius) {
                    QVERIFY2(stage.clear() >= kRadius - kMicrometre, inMicrons(stage.clear()).c_str());
                } else {
                    QVERIFY2(z > 0 && z < room, inMicrons(z).c_str());
                    QVERIFY2(std::abs(z - room / 2) < kMicrometre, inMicrons(z - room / 2).c_str());
                }
            }
            QCOMPARE_GT(squeezed, 20);
            COMPARE_NEAR(stage.state.position.z(), kRadius, kMicrometre, "m");
        }
}

// A bar goes over the proxy in one step, which lies in a gutter and cannot get out of its way: at its end
// there is room again.
void SqueezeTest::aSqueezeWithinAStepIsTold() {
    const Vec3 half(0.0005, 0.05, 0.01);
    for (const double room : {2.1 * kRadius, 1.5 * kRadius}) {
        Stage stage;
        stage.addStatic(sheet(0.05));
        stage.addStatic(channel(0.05, 2.02 * kRadius));
        const double height = room + half.z();
        const int mover = stage.addMover(box(half), at({-0.006, 0, height}));
        const Vec3 finger(0, 0, kRadius * 1.001);
        stage.startAt(finger);
        stage.step(finger);
        stage.put(mover, at({0.006, 0, height}));
        const ProxyReport report = stage.step(finger);
        QVERIFY(!report.passed);
        QCOMPARE(report.squeezed, room < 2 * kRadius);
        QVERIFY2((stage.state.position - finger).norm() < 0.05 * kRadius,
                 inMicrons((stage.state.position - finger).norm()).c_str());
    }
}

// The box goes on into the wall: there is no place for the proxy, which stays before the wall. When the box
// is back the proxy is where it was, and the box is felt again.
void SqueezeTest::isPassedWithoutRoomAndFelt() {
    Rng rng(105);
    for (int run = 0; run < 20; ++run) {
        Stage stage(rough(run % 2 ? 0.4 : 0, run % 2 ? 0.3 : 0));
        stage.addStatic(sheet(0.05));
        const Vec3 half(0.02, 0.02, 0.005);
        const int mover = stage.addMover(box(half), at({0, 0, 0.01}));
        Vec3 finger(0, 0, -0.004);
        stage.startAt({0, 0, 0.0015});
        int passed = 0;
        for (int i = 0; i <= 400; ++i) {
            const double room = 0.005 - 0.012 * std::sin(std::numbers::pi * i / 400);
            stage.put(mover, at({1e-3 * std::sin(0.1 * i), 0, room + half.z()}));
            finger += 2e-4 * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), 0);
            passed += stage.step(finger).passed;
            QCOMPARE_GT(stage.state.position.z(), 0);
            if (room < 0)
                QVERIFY2(stage.state.position.z() >= kRadius - kMicrometre,
                         inMicrons(stage.state.position.z()).c_str());
        }
        QCOMPARE(passed, 1);
        QCOMPARE(stage.state.passedCount, 0);
        QCOMPARE_GE(stage.clear(), kRadius - kMicrometre);
        // Pressed up against the box from below: it holds.
        for (int i = 0; i < 40; ++i)
            stage.step(finger + Vec3(0, 0, 5e-4 * i));
        QCOMPARE_LT(stage.state.position.z(), 0.005 - kRadius + kMicrometre);
        QCOMPARE_GT(stage.state.position.z(), 0.005 - kRadius - 1e-5);
    }
}

// The box has passed over the proxy, which is beneath it now. On the box the place where the proxy would be
// goes on as it would have: down to the lid and along it, above the proxy, wherever the box and the proxy go;
// until the proxy comes out from under it.
void SqueezeTest::whatPassedKeepsItsPlaceOnTheBody() {
    const double gap = 0.5 * (1 - 0.9) * kRadius; // that the way back needs
    const Vec3 half(0.02, 0.02, 0.005);
    Rng rng(110);
    for (int run = 0; run < 20; ++run) {
        Stage stage;
        const int mover =
            stage.addMover(box(half), turned(uniform(rng, -3, 3), direction(rng), inBox(rng, 0.01)));
        const Pose first = stage.pose(mover);
        Vec3 beneath_B(0.005, -0.003, -0.012);
        stage.startAt(first.apply(beneath_B));
        stage.state.passed[0] = {0, Vec3(0.001, 0.002, 0.009)};
        stage.state.passedCount = 1;
        for (int i = 0; i < 50; ++i) {
            stage.step(stage.pose(mover).apply(beneath_B));
            QCOMPARE(stage.state.passedCount, 1);
            const Vec3 expected(beneath_B.x(), beneath_B.y(), half.z() + gap);
            const double error = (stage.state.passed[0].at_B - expected).norm();
            QVERIFY2(error < kMicrometre,
                     qPrintable(QString("run %1, step %2: the place is %3 mm above the lid "
                                        "instead of %4 mm, and %5 mm from where it should be")
                                    .arg(run)
                                    .arg(i)
                                    .arg(1e3 * (stage.state.passed[0].at_B.z() - half.z()))
                                    .arg(1e3 * gap)
                                    .arg(1e3 * error)));
            QVERIFY(stage.state.contactCount == 0);
            // Both go on; the proxy follows its finger before the next look at them.
            beneath_B += Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), 0) * 1e-3;
            beneath_B = beneath_B.cwiseMax(Vec3(-0.015, -0.015, -0.012)).cwiseMin(Vec3(0.015, 0.015, -0.012));
            stage.put(mover, wandered(stage.pose(mover), rng, 1e-3, 0.05, 0.05));
            restartAt(stage, stage.pose(mover).apply(beneath_B));
        }
        // Out to the side: above the proxy there is no lid any more, and with the next step it is felt again.
        beneath_B = {0.03, 0, -0.012};
        restartAt(stage, stage.pose(mover).apply(beneath_B));
        for (const int felt : {0, 1}) {
            QCOMPARE(stage.state.passedCount, 1);
            stage.step(stage.pose(mover).apply(beneath_B));
            QCOMPARE(stage.state.passedCount, 1 - felt);
        }
        // From there it is as solid as ever.
        for (int i = 0; i <= 100; ++i)
            stage.step(stage.pose(mover).apply({0.03 - 3e-4 * i, 0, 0}));
        const double side = stage.inBody(mover).x();
        QVERIFY2(std::abs(side - (half.x() + kRadius)) < kMicrometre, inMicrons(side).c_str());
    }
}

// Two boxes have passed over the proxy; it is free of the first, and still beneath the second.
void SqueezeTest::eachBodyIsFeltAgainByItself() {
    Stage stage;
    const Vec3 half(0.02, 0.02, 0.005);
    stage.addMover(box(half), at({0, 0, 0.1}));
    stage.addMover(box(half));
    const Vec3 proxy(0, 0, -0.009);
    stage.startAt(proxy);
    const Vec3 place(0.001, 0, half.z() + 2e-3);
    stage.state.passed[0] = {0, {0.001, 0, -0.009}};
    stage.state.passed[1] = {1, place};
    stage.state.passedCount = 2;
    stage.step(proxy);
    QCOMPARE(stage.state.passedCount, 1);
    QCOMPARE(stage.state.passed[0].body, 1u);
    QVERIFY((stage.state.passed[0].at_B - place).norm() < 3e-3);
    QVERIFY(stage.state.passed[0].at_B.z() > half.z());
}

// A plate that is felt from above alone lies between the place and the proxy: from above it is in the way,
// from beneath it is not.
void SqueezeTest::whatIsNotFeltFromThereIsNotInTheWay() {
    for (const double side : {1.0, -1.0}) {
        Stage stage;
        stage.addMover(sheet(0.02));
        stage.feelFrom(0, Sides::Front);
        const Vec3 proxy(0.001, 0, -5e-3 * side);
        stage.startAt(proxy);
        stage.state.passed[0] = {0, -proxy};
        stage.state.passedCount = 1;
        stage.step(proxy);
        QCOMPARE(stage.state.passedCount, side > 0 ? 1 : 0);
    }
}

// An animation that starts anew puts its body somewhere else: what lands on the proxy does not throw it.
void SqueezeTest::aJumpLetsGo() {
    Stage stage(rough(0.5, 0.5));
    const int mover = stage.addMover(sheet(0.05));
    stage.startAt({0, 0, 0.0011});
    const Vec3 finger(0.0001, 0, -0.002);
    stage.step(finger);
    QCOMPARE(stage.state.contactCount, 1);
    stage.put(mover, at({0, 0, 0.03}), true);
    stage.step(finger);
    QCOMPARE(stage.state.contactCount, 0);
    QCOMPARE(stage.state.position, finger);
    stage.put(mover, at({0, 0, -0.03}), true); // and back over it
    stage.step(finger);
    QCOMPARE(stage.state.position, finger);
    stage.step({0, 0, -0.04});
    COMPARE_NEAR(stage.state.position.z(), -0.03 + kRadius, kMicrometre, "m");
}

void SqueezeTest::aSmallJumpIsSwept() {
    Stage stage;
    const int mover = stage.addMover(sheet(0.05));
    stage.startAt({0, 0, 0.0011});
    const Vec3 finger(0, 0, -0.002);
    stage.step(finger);
    for (int i = 1; i <= 20; ++i) {
        stage.put(mover, at({0, 0, 1.5e-3 * i}), true);
        stage.step(finger);
        COMPARE_NEAR(stage.state.position.z(), 1.5e-3 * i + kRadius, kMicrometre, "m");
    }
}

TACTUM_TEST(SqueezeTest)

} // namespace test_squeeze

#include "test_squeeze.moc"
