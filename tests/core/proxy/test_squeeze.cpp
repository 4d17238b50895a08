// Bodies that leave the proxy too little room, and bodies that jump.

#include <QtTest>

#include "tests/core/proxy/carry_stage.h"
#include "tests/support/compare.h"

using namespace tactum;
using namespace tactum::test;

class SqueezeTest : public QObject {
    Q_OBJECT

private slots:
    void isSqueezedEvenlyAndFreed();
    void isPassedWithoutRoomAndFelt();
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

QTEST_APPLESS_MAIN(SqueezeTest)
#include "test_squeeze.moc"
