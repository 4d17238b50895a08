// T5 with every profile that the program ships: what a person let go comes to rest, though the program takes
// it to be held and the amplifier answers late.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "device/profile.h"
#include "tests/physics/press.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_stability_let_go {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kLetSwing = 25; ///< s: what nobody holds loses its own energy slowly
constexpr double kWall = 1500;   ///< N/m
/// J, before it rests. The ceiling is for a light pinch; without any hand it is beyond what the device loses.
constexpr double kMostGiven = 5e-3;

/// No profile tells its mass: a light stylus and a heavy parallel one.
constexpr std::array kMasses{0.05, 0.2}; // kg

PlantProfile plantOf(const DeviceInfo& info, double mass) {
    return {info.name.c_str(),       mass,          info.damping,     info.dryFriction,
            info.positionResolution, info.maxForce, info.amplifierLag};
}

} // namespace

class TestStabilityLetGo : public QObject {
    Q_OBJECT

private slots:
    void shippedDeviceThatWasLetGoComesToRest_data() {
        QTest::addColumn<int>("profile");
        for (int i = 0; i < int(builtInProfiles().size()); ++i)
            QTest::addRow("%s", builtInProfiles()[std::size_t(i)].key.c_str()) << i;
    }

    void shippedDeviceThatWasLetGoComesToRest() {
        QFETCH(int, profile);
        DeviceInfo info = builtInProfiles()[std::size_t(profile)].info;
        info.continuousForce = 0; // warm motors give way to a press for ever, which is no swing
        QCOMPARE_GT(info.amplifierLag, 0);
        QCOMPARE_GT(info.handDamping, 0);
        const double count = info.positionResolution;
        double widest = 0, most = 0;
        for (const double mass : kMasses)
            for (const Press& press : kPresses) {
                const Bench bench{
                    plantOf(info, mass), kNoHand, {.rate = info.rate, .delay = int(std::ceil(info.delay))}};
                const Rest rest = pressServo(bench, press, kWall, kLetSwing,
                                             [&](Servo& servo) { servo.state = ServoState(info); });
                widest = std::max(widest, rest.motion);
                most = std::max(most, rest.given);
                const QByteArray told = QString("%1 kg, %2 N, %3 m/s: %4 mm, %5 N, %6 mJ")
                                            .arg(mass)
                                            .arg(press.force)
                                            .arg(press.impact)
                                            .arg(1e3 * rest.motion)
                                            .arg(rest.force)
                                            .arg(1e3 * rest.given)
                                            .toUtf8();
                QVERIFY2(rest.motion <= 2 * count, told);
                QVERIFY2(rest.force <= 2 * rest.stiffness * count * (1 + 1e-9), told);
                QVERIFY2(rest.given <= kMostGiven, told);
                // It is the surface that holds it, and no fault that took the force away.
                QVERIFY2(rest.steady > 0 || press.force <= info.dryFriction, told);
            }
        qInfo("%.1f um, %.2f mJ", 1e6 * widest, 1e3 * most);
    }
};

TACTUM_TEST(TestStabilityLetGo)

} // namespace test_stability_let_go

#include "test_stability_let_go.moc"
