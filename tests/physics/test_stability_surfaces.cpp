// T3 over surfaces that rub, and over textures: what prescribed motion, which no plant forgives, gets from
// the servo and its proxy.
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include <QTest>

#include "core/safety/safe_stiffness.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_surfaces {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMicrojoule = 1e-6;
constexpr double kRadius = 1e-3;
constexpr double kDepth = 2e-3; ///< m below the surface, of a finger that is pressed

/// A servo and its proxy, led from reading to reading, with the energy that they gave net of what the device
/// is known to lose; its friction is that of its joints, along each axis.
struct Led {
    Led(std::shared_ptr<const World> world, const DeviceInfo& info, const PlantProfile& theDevice,
        double proxyRate)
        : device(theDevice), period(1 / info.rate), proxy(std::move(world), proxyRate), servo(info, proxy),
          onTheWay(1 + std::size_t(info.delay), Vec3::Zero()) {
        for (double t = 0; t < 1; t += period)
            to({0, 0, 0.01});
        given = 0;
    }

    void to(const Vec3& place) {
        const Vec3 way = place - at;
        given += onTheWay.front().dot(way) - device.damping * way.squaredNorm() / period -
                 device.friction * way.lpNorm<1>();
        at = place;
        DeviceSample sample;
        sample.position = counted(place, device.resolution);
        sample.valid = true;
        servo.state.schedule
            .forgetSwings(); // to which random steps are a limit cycle: it shall not help here
        onTheWay.push_back(servo(sample, period));
        onTheWay.pop_front();
    }
    template <class Seen> void go(const Vec3& place, double speed, Seen&& seen) {
        const Vec3 from = at;
        const int steps = std::max(1, int(std::ceil((place - from).norm() / (speed * period))));
        for (int i = 1; i <= steps; ++i) {
            to(from + (place - from) * (double(i) / steps));
            seen();
        }
    }
    void go(const Vec3& place, double speed) {
        go(place, speed, [] {});
    }
    /// Until no force of before is on its way any more.
    void rest() {
        for (int i = 0; i < 20; ++i)
            to(at);
    }
    /// J, that the spring holds.
    double stored() const {
        const Previous& last = servo.state.previous;
        const double stretch = last.touching ? (last.anchor_D - last.finger_D).norm() : 0;
        return 0.5 * servo.state.transition.rendered().stiffness * stretch * stretch;
    }
    bool isPushing() const { return servo.state.gate.gain() == 1 && servo.state.gate.faults() == 0; }

    PlantProfile device;
    double period; ///< s
    Proxy proxy;
    Servo servo;
    std::deque<Vec3> onTheWay; ///< N: the first one is that of the device
    Vec3 at = Vec3(0, 0, 0.01);
    double given = 0; ///< J
};

/// A place on the surface, or above.
Vec3 over(double x, double y, double height) {
    return {x, y, kRadius + height};
}

/// One tick's random steps while pressed, by up to `reach` along each axis.
template <class Seen> void wander(Led& led, int count, double reach, Seen&& seen) {
    constexpr double kSide = 5e-3;
    Rng random(5);
    for (int i = 0; i < count; ++i) {
        Vec3 next = led.at + inBox(random, reach);
        next.x() = std::clamp(next.x(), -kSide, kSide);
        next.y() = std::clamp(next.y(), -kSide, kSide);
        next.z() = std::clamp(next.z(), kRadius - 2 * kDepth, kRadius - 1e-6);
        led.to(next);
        seen();
    }
}

/// Coefficients, and viscosity and damping in N s/m.
struct Feel {
    const char* name;
    double muStatic, muDynamic, viscosity, damping;
};
constexpr std::array kFeels{Feel{"smooth", 0, 0, 0, 0},
                            Feel{"dry", 0.6, 0.6, 0, 0},
                            Feel{"stick and slip", 0.8, 0.3, 0, 0},
                            Feel{"hardly viscous", 0, 0, 0.05, 0},
                            Feel{"viscous", 0, 0, 1, 0},
                            Feel{"stick, slip and hardly viscous", 0.8, 0.3, 0.05, 0},
                            Feel{"stick, slip and viscous", 0.8, 0.3, 2, 0}};

Material materialOf(const Feel& feel, double stiffness) {
    Material material = rough(feel.muStatic, feel.muDynamic, feel.viscosity);
    material.stiffness = kStiffness.clamped(stiffness);
    material.damping = feel.damping;
    return material;
}

constexpr double kRepeat = 2e-3, kHigh = 0.2e-3; ///< m

/// Grooves across x: a single cosine, as steep as 2 kHigh / kRepeat.
TextureLayer cosineGrooves() {
    TextureLayer layer = heightLayer(TextureSource::Grooves, TextureMapping::Planar, kRepeat, kHigh);
    layer.pattern.fill = 0.5;
    layer.pattern.softness = 1;
    return layer;
}

/// The same from a picture.
TextureLayer picturedGrooves() {
    const Image image =
        imageOf(512, 4, [](double x, double) { return 0.5 + 0.5 * std::cos(2 * std::numbers::pi * 4 * x); });
    return imageLayer(image, TextureMapping::Planar, 4 * kRepeat, kHigh);
}

std::shared_ptr<const World> groovedWorld(const Material& material,
                                          const TextureLayer& layer = cosineGrooves()) {
    Scene scene = sceneOf(sheet(0.1), material, kRadius);
    scene.objects[0].surfaces[0].layers = {layer};
    return compile(scene).value();
}

/// What the texture has at most to give: it pushes along the surface with F_n grad h and never lifts, so that
/// a closed way gives - int F_n dh, at most (F_most - F_least) / 2 for each metre up or down.
struct Relief {
    double climbed = 0;             ///< m, up and down together, by the proxy
    double least = 1e300, most = 0; ///< N, along the normal

    void add(const Led& led) {
        TexturePoint point;
        point.position = led.proxy.state.proxy.position - kRadius * Vec3::UnitZ();
        const double now = feel(*stack, point, 0).height;
        if (begun) climbed += std::abs(now - height);
        begun = true;
        height = now;
        least = std::min(least, led.servo.output.force.z());
        most = std::max(most, led.servo.output.force.z());
    }
    double gift() const { return 0.5 * (most - least) * climbed; } ///< J

    Stack stack = stackOf({cosineGrooves()});
    double height = 0; ///< m
    bool begun = false;
};

/// J, the most that random steps get, and that all of it leaves when the finger is out again.
double afterRandomSteps(Led led) {
    led.go(over(0, 0, -kDepth), 0.05);
    const double before = led.given;
    double most = -1;
    wander(led, 4000, 0.4 * led.period, [&] { most = std::max(most, led.given - before); });
    led.go(over(0, 0, 0.005), 0.05);
    return std::max(most, led.given);
}

/// J, the most that the sawtooth along the surface gets after the finger was drawn there.
double overACount(Led led) {
    const double boundary = (std::floor(5e-3 / led.device.resolution) + 0.5) * led.device.resolution;
    led.go(over(0, 0, -kDepth), 0.05);
    led.go(over(boundary, 0, -kDepth), 0.05);
    const double before = led.given;
    double most = -1;
    for (int i = 0; i < 4000; ++i) {
        led.to(over(boundary + (i % 2 ? 1e-9 : -1e-9), 0, -kDepth));
        most = std::max(most, led.given - before);
    }
    return most;
}

/// J, the most that one of twenty closed ways at one depth gets.
double aroundAtOneDepth(Led led, double speed) {
    led.go(over(0, 0, -kDepth), 0.05);
    Rng random(13);
    double most = -1;
    for (int i = 0; i < 20; ++i) {
        const double size = uniform(random, 1e-4, 1e-2);
        const double before = led.given;
        const int steps = int(5 * size / speed / led.period);
        for (int step = 1; step <= steps; ++step) {
            const double turn = 2 * std::numbers::pi * step / steps;
            led.to(over(size * (1 - std::cos(turn)), size * std::sin(turn) * std::cos(turn), -kDepth));
        }
        most = std::max(most, led.given - before);
    }
    return most;
}

/// J, what so many rounds get over one flank, shallow on the way up and deep on the way down, and the bound.
std::pair<double, double> rowing(Led led, double speed, int rounds) {
    led.go(over(0.5 * kRepeat, 0, -0.5 * kDepth), 0.01);
    const double before = led.given;
    Relief relief;
    for (int i = 0; i < rounds; ++i)
        for (const Vec3& place :
             {over(0, 0, -0.5 * kDepth), over(0, 0, -1.5 * kDepth), over(0.5 * kRepeat, 0, -1.5 * kDepth),
              over(0.5 * kRepeat, 0, -0.5 * kDepth)})
            led.go(place, speed, [&] { relief.add(led); });
    return {led.given - before, relief.gift()};
}

/// A device that loses just what the theory asks for, b = K T (1/2 + delay), told to the servo so that seven
/// tenths of it are that: its ceiling is K, without any reserve.
struct Bare {
    static constexpr double kStiff = 1000, kAlmost = 1 + 1e-6, kReserve = 0.7;

    explicit Bare(double rate, int delay = 0)
        : device{"bare", 0.1, (0.5 + delay) * kStiff / rate * kAlmost, 0, 0, 1e9} {
        info = infoOf({device, kNoHand, {.rate = rate, .delay = delay}});
        info.damping = device.damping * kAlmost / kReserve;
    }
    PlantProfile device;
    DeviceInfo info;
};

} // namespace

class TestStabilitySurfaces : public QObject {
    Q_OBJECT

private slots:
    void rubbingMakesNoEnergy_data() {
        QTest::addColumn<int>("feel");
        QTest::addColumn<double>("rate");
        QTest::addColumn<int>("delay");
        for (int i = 0; i < int(kFeels.size()); ++i)
            for (const double rate : {1000.0, 4000.0})
                for (const int delay : {0, 1, 2})
                    QTest::addRow("%s, %g Hz, %d late", kFeels[std::size_t(i)].name, rate, delay)
                        << i << rate << delay;
    }

    /// Random steps at the boundary of the theory: what was given and what the spring holds never grow
    /// together.
    void rubbingMakesNoEnergy() {
        QFETCH(int, feel);
        QFETCH(double, rate);
        QFETCH(int, delay);
        const Bare bare(rate, delay);
        Led led(worldOf(sheet(0.1), materialOf(kFeels[std::size_t(feel)], Bare::kStiff), kRadius), bare.info,
                bare.device, rate);
        led.go(over(0, 0, -kDepth), 0.05);
        led.rest();
        const double before = led.given + led.stored();
        double most = -1;
        wander(led, 20'000, 0.4 / rate, [&] { most = std::max(most, led.given + led.stored() - before); });
        qInfo("W %.3g J", most);
        QVERIFY(led.isPushing());
        COMPARE_NEAR(led.servo.state.transition.rendered().stiffness / Bare::kStiff, 1, 1e-5, "");
        QCOMPARE_LE(most, kMicrojoule);
    }

    void teethAlongTheSurfaceMakeNoEnergy_data() { rubbingMakesNoEnergy_data(); }

    /// To and fro along the surface, from tick to tick or in some, by a micrometre up to what stays below the
    /// trip speed, at the boundary of the theory, with a proxy loop that keeps up and one that does not;
    /// where it sticks, and where it was just drawn to.
    void teethAlongTheSurfaceMakeNoEnergy() {
        QFETCH(int, feel);
        QFETCH(double, rate);
        QFETCH(int, delay);
        const Bare bare(rate, delay);
        const auto world = worldOf(sheet(0.1), materialOf(kFeels[std::size_t(feel)], Bare::kStiff), kRadius);
        for (const double proxyRate : {rate, 300.0})
            for (const double drawn : {0.0, 5e-3})
                for (const double size : {1e-6, 1e-5, 1e-4, 3e-4, 1e-3})
                    for (const int ticks : {1, 2, 3, 5, 10}) {
                        if (size * rate > 1.2) continue;
                        Led led(world, bare.info, bare.device, proxyRate);
                        led.go(over(0, 0, -kDepth), 0.05);
                        led.go(over(drawn, 0, -kDepth), 0.05);
                        led.rest();
                        const double before = led.given;
                        for (int i = 0; i < 1000; ++i)
                            led.to(over(drawn + size * ((i / ticks) % 2), 0, -kDepth));
                        QVERIFY(led.isPushing());
                        QVERIFY2(led.given - before <= kMicrojoule,
                                 qPrintable(QString("the proxy's %1 Hz, drawn by %2 m, teeth of %3 m and %4 "
                                                    "ticks: %5 J")
                                                .arg(proxyRate)
                                                .arg(drawn)
                                                .arg(size)
                                                .arg(ticks)
                                                .arg(led.given - before)));
                    }
    }

    void rubbingGetsNothingFromTheServo_data() {
        QTest::addColumn<int>("feel");
        QTest::addColumn<int>("delay");
        for (int i = 0; i < int(kFeels.size()); ++i)
            for (const int delay : {0, 1, 2})
                QTest::addRow("%s, %d late", kFeels[std::size_t(i)].name, delay) << i << delay;
    }

    /// Each device's own losses, at its own ceiling, on surfaces that damp too, with a proxy loop that keeps
    /// up and one that does not: random steps, and the sawtooth of a nanometre over the boundary of two
    /// counts.
    void rubbingGetsNothingFromTheServo() {
        QFETCH(int, feel);
        QFETCH(int, delay);
        double most = -1;
        for (const PlantProfile& device : kDevices)
            for (const double rate : {1000.0, 4000.0})
                for (const double damping : {0.0, 2.0})
                    for (const double proxyRate : {rate, 300.0}) {
                        const DeviceInfo info = infoOf({device, kNoHand, {.rate = rate, .delay = delay}});
                        LoopFigures loop = loopFigures(info);
                        loop.surfaceDamping = damping;
                        Feel rubbing = kFeels[std::size_t(feel)];
                        rubbing.damping = damping;
                        const auto world =
                            worldOf(sheet(0.1), materialOf(rubbing, safeStiffness(loop).value), kRadius);
                        const double gift = std::max(afterRandomSteps({world, info, device, proxyRate}),
                                                     overACount({world, info, device, proxyRate}));
                        most = std::max(most, gift);
                        QVERIFY2(gift <= kMicrojoule,
                                 qPrintable(QString("%1, %2 Hz, the proxy's %3 Hz, damps with %4: %5 J")
                                                .arg(device.name)
                                                .arg(rate)
                                                .arg(proxyRate)
                                                .arg(damping)
                                                .arg(gift)));
                    }
        qInfo("W %.3g uJ", 1e6 * most);
    }

    void texturesGiveWhatTheirHeightIsWorth_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<bool>("picture");
        QTest::addColumn<double>("friction");
        for (const double rate : {1000.0, 4000.0})
            for (const bool picture : {false, true})
                for (const double friction : {0.0, 0.3})
                    QTest::addRow("%g Hz, %s, mu %g", rate, picture ? "picture" : "formula", friction)
                        << rate << picture << friction;
    }

    /// Grooves at the boundary of the theory. At one depth, along closed ways, they give nothing; and
    /// friction only takes.
    void texturesGiveWhatTheirHeightIsWorth() {
        QFETCH(double, rate);
        QFETCH(bool, picture);
        QFETCH(double, friction);
        const Bare bare(rate);
        Material material = rough(friction, friction);
        material.stiffness = Bare::kStiff;
        const auto world = groovedWorld(material, picture ? picturedGrooves() : cosineGrooves());
        for (const double speed : {0.005, 0.02, 0.05})
            QCOMPARE_LE(aroundAtOneDepth({world, bare.info, bare.device, rate}, speed), kMicrojoule);
        // Up a flank under 1 N and down under 3 N: the worst that a hand can do.
        for (const double speed : {0.005, 0.02, 0.05}) {
            const auto [given, bound] = rowing({world, bare.info, bare.device, rate}, speed, 1);
            const auto [more, mostOfAll] = rowing({world, bare.info, bare.device, rate}, speed, 100);
            qInfo("at %g m/s %.3g mJ of at most %.3g for one groove, %.3g of %.3g for a hundred", speed,
                  1e3 * given, 1e3 * bound, 1e3 * more, 1e3 * mostOfAll);
            QCOMPARE_LE(given, bound);
            QCOMPARE_LE(more, mostOfAll);
            if (friction == 0) QCOMPARE_GT(given, 0.4 * bound); // the bound is not far away
        }
        for (const double reach : {0.4, 0.1, 0.03, 0.01}) {
            Led led(world, bare.info, bare.device, rate);
            led.go(over(0, 0, -kDepth), 0.05);
            const double before = led.given;
            Relief relief;
            wander(led, 10'000, reach / rate, [&] { relief.add(led); });
            led.go(over(0, 0, -kDepth), 0.05, [&] { relief.add(led); });
            QVERIFY(led.isPushing());
            QCOMPARE_LE(led.given - before, relief.gift());
        }
    }
};

TACTUM_TEST(TestStabilitySurfaces)

} // namespace test_stability_surfaces

#include "test_stability_surfaces.moc"
