// A gamepad vibrates while the simulated hand strokes over grooves, as strongly as the force that was felt
// does. Judged by a Fourier transform of that force, which knows nothing of filters that go tick by tick.
#include <cmath>
#include <complex>
#include <numbers>

#include <QTest>

#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/rumble/virtual_pad.h"
#include "ui/rumble/rumble_link.h"

namespace test_rumble_stroke {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRate = 1000, kStrength = 3;
constexpr double kDeep = -2e-3, kAbove = 0.01, kLong = 0.12; // m

std::shared_ptr<const World> grooved() {
    Material material;
    material.stiffness = 500;
    Scene scene = sceneOf(sheet(0.1), material);
    TextureLayer layer;
    layer.pattern.source = TextureSource::Grooves;
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.size = 2e-3;
    layer.strength = 3e-4;
    scene.objects[0].surfaces[0].layers = {layer};
    return compile(scene).value();
}

double steady() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A hand over the grooves, whose gamepad is told sixty times a second what it feels.
struct Stroking {
    Stroking() {
        engine.publish(grooved());
        link.setStrength(kStrength);
    }
    bool begin() {
        link.setOn(true);
        if (!engine.start()) return false;
        engine.setArmed(true);
        target->write({.position = {-kLong / 2, 0, kAbove}, .teleport = true, .sequence = 1});
        return waitFor([&] { return link.pads().size() == 1; }) &&
               until([&] { return engine.servo().gain == 1; }) && reaches(-kLong / 2, false);
    }
    void to(const Vec3& position, double seconds) {
        target->write({.position = position, .sequence = 1, .time = seconds});
    }
    void frame() {
        engine.poll();
        points.clear();
        for (TracePoint point; engine.popTrace(point);)
            points.push_back(point);
        link.play(points, kRate);
        felt.insert(felt.end(), points.begin(), points.end());
    }
    template <class Condition> bool until(Condition condition) {
        return waitFor([&] {
            frame();
            return condition();
        });
    }
    /// The hand gives way to what pushes it: not all the way down.
    bool reaches(double x, bool touching) {
        return until([&] {
            return std::abs(engine.servo().finger.x() - x) < 1e-3 &&
                   (engine.proxy().output.contacts > 0) == touching;
        });
    }

    VirtualPad pad{"A gamepad"};
    std::shared_ptr<HandTarget> target = std::make_shared<HandTarget>();
    LocalEngine engine{std::make_unique<SimulatedHand>(target)};
    RumbleLink link;
    std::vector<TracePoint> points, felt;
};

/// N, of the sines that would have the power of a force below and above the split.
MotorStrengths bandsOf(std::span<const TracePoint> points) {
    const std::size_t count = points.size();
    Vec3 mean = Vec3::Zero();
    for (const TracePoint& point : points)
        mean += point.force / double(count);
    double low = 0, high = 0;
    for (std::size_t k = 1; k < count / 2; ++k) {
        const double f = double(k) * kRate / double(count);
        double power = 0;
        for (int axis = 0; axis < 3; ++axis) {
            std::complex<double> sum = 0;
            const std::complex<double> turn =
                std::polar(1.0, -2 * std::numbers::pi * double(k) / double(count));
            std::complex<double> at = 1;
            for (const TracePoint& point : points) {
                sum += (point.force[axis] - mean[axis]) * at;
                at *= turn;
            }
            power += 2 * std::norm(sum) / double(count * count);
        }
        power /= 1 + std::pow(20 / f, 4);
        low += power / (1 + std::pow(f / PadMotors::kSplit, 4));
        high += power / (1 + std::pow(PadMotors::kSplit / f, 4));
    }
    return {std::sqrt(2 * low), std::sqrt(2 * high)};
}

/// N, the same of what the motors were told between two times.
MotorStrengths bandsTold(const std::vector<VirtualPad::Told>& told, double from, double to) {
    double low = 0, high = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
        const double begin = std::max(from, told[i].t);
        const double end = std::min(to, i + 1 < told.size() ? told[i + 1].t : to);
        if (end <= begin) continue;
        low += std::pow(told[i].low, 4) * (end - begin);
        high += std::pow(told[i].high, 4) * (end - begin);
    }
    return {std::sqrt(low / (to - from)) / kStrength, std::sqrt(high / (to - from)) / kStrength};
}

} // namespace

class TestRumbleStroke : public QObject {
    Q_OBJECT
private slots:
    void aStrokeOverGroovesVibratesAsItIsFelt() {
        Stroking hand;
        QVERIFY(hand.begin());
        hand.to({-kLong / 2, 0, kDeep}, 0.3);
        QVERIFY(hand.reaches(-kLong / 2, true));
        // An impact, which is over then.
        QVERIFY(hand.until([&] { return hand.pad.last().high > 0.1; }));
        QVERIFY(hand.until([&] { return hand.pad.last().low < 0.1 && hand.pad.last().high < 0.1; }));
        const std::size_t first = hand.felt.size();
        const double from = steady();
        hand.to({kLong / 2, 0, kDeep}, 1.6);
        QVERIFY(hand.reaches(kLong / 2, true));
        const double to = steady();
        const std::size_t last = hand.felt.size();
        hand.to({kLong / 2, 0, kAbove}, 0.2);
        QVERIFY(hand.reaches(kLong / 2, false));
        QVERIFY(hand.until([&] { return hand.pad.last().low == 0 && hand.pad.last().high == 0; }));
        hand.engine.stop();

        const MotorStrengths felt = bandsOf(std::span(hand.felt).subspan(first, last - first));
        const MotorStrengths told = bandsTold(hand.pad.told(), from, to);
        qInfo("felt %.1f and %.1f mN, told %.1f and %.1f mN", 1e3 * felt.low, 1e3 * felt.high, 1e3 * told.low,
              1e3 * told.high);
        QCOMPARE_GT(felt.low, 0.02);
        QCOMPARE_GT(felt.high, 0.01);
        COMPARE_NEAR(told.low, felt.low, 0.1 * felt.low, "N");
        COMPARE_NEAR(told.high, felt.high, 0.1 * felt.high, "N");
    }

    void aStopEndsIt() {
        Stroking hand;
        QVERIFY(hand.begin());
        hand.to({-kLong / 2, 0, kDeep}, 0.3);
        QVERIFY(hand.reaches(-kLong / 2, true));
        hand.to({kLong / 2, 0, kDeep}, 3);
        QVERIFY(
            hand.until([&] { return hand.engine.servo().finger.x() > -0.03 && hand.pad.last().low > 0.1; }));
        hand.engine.setArmed(false);
        QVERIFY(hand.until([&] { return hand.pad.last().low == 0 && hand.pad.last().high == 0; }));
        QCOMPARE_LT(hand.engine.servo().finger.x(), kLong / 2 - 2e-3); // it strokes still
        hand.engine.stop();
    }
};

TACTUM_TEST(TestRumbleStroke)

} // namespace test_rumble_stroke

#include "test_rumble_stroke.moc"
