// T6: a limit cycle is noticed within a tenth of a second, stroking textures and tapping never are.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/safety/oscillation_detector.h"
#include "tests/physics/hand_script.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_oscillation {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;

struct LimitCycle {
    double frequency = 20;   ///< Hz
    double amplitude = 1e-4; ///< m
    double rate = 1000;      ///< Hz, of the servo
    bool oneSided = false;   ///< as bounces are
};

/// s until it is noticed; 1 if it is not.
double noticedAfter(const LimitCycle& cycle, double phase, const Vec3& axis, double resolution) {
    OscillationDetector detector;
    for (double t = 0; t < 1; t += 1 / cycle.rate) {
        const double turn = 2 * kPi * cycle.frequency * t;
        const double swing =
            cycle.oneSided ? 2 * std::abs(std::sin(0.5 * turn + phase)) - 1 : std::sin(turn + phase);
        if (detector(counted(cycle.amplitude * swing * axis, resolution), 1 / cycle.rate)) return t;
    }
    return 1;
}

/// Over phases, axes and resolutions.
double latestNotice(const LimitCycle& cycle) {
    // Half of a slow bounce takes longer than that of 20 Hz; a fast one is none between so few readings.
    if (cycle.oneSided && (cycle.frequency < 25 || cycle.frequency > cycle.rate / 8)) return 0;
    std::vector<Vec3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    if (cycle.amplitude >= 2e-4) axes.push_back({0.6, 0.8, 0});
    double latest = 0;
    for (int i = 0; i < 8; ++i)
        for (const Vec3& axis : axes)
            for (const double resolution : {0.0, 30e-6, 60e-6})
                latest = std::max(latest, noticedAfter(cycle, i * kPi / 4, axis, resolution));
    return latest;
}

std::shared_ptr<const World> texturedSheet(TextureSource source, double size, double height,
                                           const Material& material) {
    Scene scene = sceneOf(sheet(0.1, 4), material, 1e-3);
    TextureLayer layer;
    layer.pattern.source = source;
    layer.pattern.size = size;
    layer.strength = height;
    scene.objects[0].surfaces[0].layers = {layer};
    return compile(scene).value();
}

Material stiff(Material material, double stiffness) {
    material.stiffness = stiffness;
    return material;
}

} // namespace

class TestStabilityOscillation : public QObject {
    Q_OBJECT

private slots:
    void limitCycleIsNoticedSoon_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<bool>("oneSided");
        for (const double rate : {1000.0, 2000.0, 4000.0})
            for (const bool oneSided : {false, true})
                QTest::addRow("%g Hz%s", rate, oneSided ? ", bouncing" : "") << rate << oneSided;
    }

    void limitCycleIsNoticedSoon() {
        QFETCH(double, rate);
        QFETCH(bool, oneSided);
        double worst = 0;
        for (const double frequency :
             {20.0, 22.5, 31.0, 50.0, 77.0, 100.0, 142.9, 166.7, 200.0, 249.0, 300.0})
            for (const double amplitude : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3})
                worst = std::max(worst, latestNotice({frequency, amplitude, rate, oneSided}));
        qInfo("after %.1f ms at most", 1e3 * worst);
        QCOMPARE_LE(worst, 0.1);
    }

    /// Ten minutes in all. Of the grooves that are 0.4 mm deep and 8 mm long a fast stroke may shake a
    /// pinched handle as widely as a limit cycle would: measured once.
    void strokingAndTappingIsNoLimitCycle() {
        const PlantProfile devices[] = {kTouch, kFalcon, kPremium};
        const HandProfile hands[] = {kPinch, kGrasp, kFirm};
        const TextureSource sources[] = {TextureSource::Noise, TextureSource::Grooves, TextureSource::Dots,
                                         TextureSource::Weave};
        std::uint64_t trips = 0;
        for (int i = 0; i < 20; ++i) {
            const double size = 0.5e-3 * std::pow(2, i % 5);
            const Material material = stiff(i % 2 ? frictionless() : rough(0.6, 0.4), 300 * (1 + i % 7));
            Proxy proxy(texturedSheet(sources[i % 4], size, 0.05 * size, material), 1000);
            const Bench bench{devices[i % 3], hands[i % 3], {}};
            Servo servo(infoOf(bench), proxy);
            ClosedLoop loop(bench, servo.control(), 3);
            HandScript script(std::uint64_t(i), 1e-3);
            loop.plant.place({0, 0, 0.01});
            loop.warmUp();
            double contact = 0;
            loop.run(30, [&](ClosedLoop& now) {
                now.plant.setGoal(script.goal(1e-3));
                contact += now.command.norm() > 0 ? 1e-3 : 0;
            });
            qInfo("%s on %d of %.1f mm: %.0f s in contact, %d trips, %d faults %d", bench.device.name, i % 4,
                  1e3 * size, contact, int(servo.state.schedule.oscillations()),
                  int(servo.state.gate.faults()), int(servo.state.gate.inhibit()));
            trips += servo.state.schedule.oscillations();
        }
        QCOMPARE_LE(trips, 1u);
    }
};

TACTUM_TEST(TestStabilityOscillation)

} // namespace test_stability_oscillation

#include "test_stability_oscillation.moc"
