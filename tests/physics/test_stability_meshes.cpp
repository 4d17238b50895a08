// T11: the whole servo over random meshes: nothing pops through, nothing is above the limit, friction gives
// nothing. TACTUM_SEEDS=10000 makes it 10^6 paths; TACTUM_TRIANGLES=20000000 makes the large mesh that large.
#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/physics/servo.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/repeats.h"

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3, kReach = 0.03, kThin = 0.5e-3;
constexpr int kSteps = 20; ///< of each path, one tick each

int paths() {
    return 100 * repeats("TACTUM_SEEDS", 100);
}

constexpr double kFastest = 1.4; ///< m/s, just below the speed at which a device is taken to be let go

/// From one place towards another, no further than the steps of a path go at the fastest.
Vec3 reached(const Vec3& from, const Vec3& to) {
    const double most = kSteps * 1e-3 * kFastest;
    return from + (to - from) * std::min(1.0, most / std::max((to - from).norm(), 1e-9));
}

/// A servo and its proxy, led through one place after the other.
struct Led {
    Led(std::shared_ptr<const World> world, double rate = 1000)
        : proxy(std::move(world), rate), servo(infoOf({kFalcon, kFirm, {}}), proxy) {}

    const Vec3& to(const Vec3& position) {
        DeviceSample sample;
        sample.position = finger = position;
        sample.valid = true;
        return servo(sample, 1e-3), servo.output.force;
    }
    void rest(const Vec3& position) {
        for (int i = 0; i < 800; ++i)
            to(position);
    }
    bool sound() const {
        const Vec3& force = servo.output.force;
        return force.allFinite() && force.norm() <= kFalcon.maxForce;
    }

    Proxy proxy;
    Servo servo;
    Vec3 finger = Vec3::Zero();
};

/// Hills of 3 mm.
double hillsAt(double x, double y) {
    return 3e-3 * std::sin(80 * x) * std::cos(70 * y);
}

Soup hills() {
    const int triangles = qEnvironmentVariableIntValue("TACTUM_TRIANGLES");
    return heightField(0.1, int(std::sqrt(std::max(200'000, triangles) / 2)), hillsAt);
}

/// Leads the finger along random ways, as fast as it may go; the proxy stays above `bottom(x, y)`.
template <class Bottom> void wander(Led& led, int ways, Bottom&& bottom) {
    led.rest({0, 0, 0.01});
    Rng random(11);
    for (int i = 0; i < ways; ++i) {
        const Vec3 from = led.finger;
        const Vec3 wanted(uniform(random, -kReach, kReach), uniform(random, -kReach, kReach),
                          uniform(random, -0.01, 0.01));
        const Vec3 to = reached(from, wanted);
        for (int step = 1; step <= kSteps; ++step) {
            led.to(from + (to - from) * (double(step) / kSteps));
            QVERIFY(led.sound());
            const Vec3& proxy = led.proxy.state.proxy.position;
            QVERIFY2(proxy.z() > bottom(proxy.x(), proxy.y()), qPrintable(QString("path %1").arg(i)));
        }
    }
    QCOMPARE(led.servo.state.guard.faults(), 0u);
}

/// Ridges as sharp as they come.
Soup ridges() {
    return heightField(0.1, 40,
                       [](double x, double) { return 0.003 * std::cos(1e3 * x * M_PI / 5) - 0.003; });
}

} // namespace

class TestStabilityMeshes : public QObject {
    Q_OBJECT

private slots:
    void nothingPopsThrough_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("rate");
        for (const double rate : {100.0, 1000.0}) {
            QTest::addRow("plate of half a millimetre, %g Hz", rate) << 0 << rate;
            QTest::addRow("ridges, %g Hz", rate) << 1 << rate;
        }
    }

    void nothingPopsThrough() {
        QFETCH(int, shape);
        QFETCH(double, rate);
        const Soup soup = shape == 0 ? plate(0.1, kThin) : ridges();
        const double top = shape == 0 ? kThin / 2 : -0.006;
        Led led(worldOf(soup, rough(0.6, 0.4), kRadius), rate);
        wander(led, paths() / 4, [top](double, double) { return top; });
    }

    void nothingPopsThroughALargeMesh() {
        Led led(worldOf(hills(), rough(0.6, 0.4), kRadius));
        wander(led, paths() / 4, hillsAt);
    }

    /// Triangles of every kind, through each other: they have no inside, and a proxy may go around each of
    /// them, so that nobody can say what it is behind of. But its sphere is never in one.
    void soupsAreSound() {
        const int ways = paths() / 40;
        Rng random(12);
        long ticks = 0, pushing = 0;
        for (int mesh = 0; mesh < 20; ++mesh) {
            Material material = rough(uniform(random, 0, 1.5), 0);
            material.stiffness = uniform(random, 100, 5000);
            material.damping = uniform(random, 0, 20);
            const Soup soup = randomSoup(random, 200, kReach);
            Led led(worldOf(soup, material, kRadius));
            led.rest({0, 0, 0.05});
            for (int i = 0; i < ways; ++i) {
                const Vec3 from = led.finger;
                const Vec3 to = reached(from, from + (inBox(random, kReach) - from) * 0.5);
                for (int step = 1; step <= kSteps; ++step) {
                    pushing += led.to(from + (to - from) * (double(step) / kSteps)).isZero(0) ? 0 : 1;
                    ++ticks;
                    QVERIFY(led.sound());
                    const double gap = clearance(*soup, led.proxy.state.proxy.position);
                    QVERIFY2(gap >= kRadius * (1 - 1e-5),
                             qPrintable(QString("mesh %1, path %2: %3 m").arg(mesh).arg(i).arg(gap)));
                }
            }
            QCOMPARE(led.servo.state.guard.faults(), 0u);
        }
        qInfo("force in %.1f %% of the ticks", 100.0 * double(pushing) / double(ticks));
        QVERIFY(20 * pushing > ticks); // mostly there is nothing near
    }

    /// Slowly along closed ways in the surface.
    void frictionGivesNothing() {
        Led led(worldOf(sheet(0.1), rough(0.6, 0.6), kRadius));
        led.rest({0, 0, 0.01});
        for (int i = 0; i <= 800; ++i)
            led.to({0, 0, 0.01 - 1e-5 * 1.25 * i});
        Rng random(13);
        for (int i = 0; i < 100; ++i) {
            const double size = uniform(random, 1e-4, 1e-2);
            double given = 0;
            Vec3 last = led.finger, force = led.servo.output.force;
            for (int step = 1; step <= 2000; ++step) {
                const double turn = 2 * M_PI * step / 2000;
                const Vec3 next(size * (1 - std::cos(turn)), size * std::sin(turn) * std::cos(turn),
                                last.z());
                const Vec3 now = led.to(next);
                given += 0.5 * (force + now).dot(next - last);
                last = next;
                force = now;
            }
            QVERIFY2(given <= 1e-6, qPrintable(QString("%1: %2 J").arg(i).arg(given)));
        }
    }
};

QTEST_APPLESS_MAIN(TestStabilityMeshes)
#include "test_stability_meshes.moc"
