// T11: the whole servo over random meshes: nothing pops through, nothing is above the limit, friction gives
// nothing. TACTUM_SEEDS=10000 makes it 10^6 paths; TACTUM_TRIANGLES=20000000 makes the large mesh that large.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/exactness.h"
#include "tests/support/hand.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_stability_meshes {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3, kReach = 0.03, kThin = 0.5e-3;
constexpr int kSteps = 20; ///< of each path, one tick each

int paths() {
    return 100 * repeats("TACTUM_SEEDS", 100);
}

constexpr double kFastest = 1.4; ///< m/s, just below the speed at which a device is taken to be let go

/// From one place towards another, no further than the steps of a path go at a speed.
Vec3 reached(const Vec3& from, const Vec3& to, double speed = kFastest) {
    const double most = kSteps * 1e-3 * speed;
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
    QCOMPARE(led.servo.state.gate.faults(), 0u);
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

    /// The rule switched off: a proxy that is put onto the finger at every step, and not led there.
    void aProxyThatIsPutThereDoes() {
        Led led(worldOf(plate(0.1, kThin), rough(0.6, 0.4), kRadius));
        led.rest({0, 0, 0.01});
        int through = 0;
        for (double z = 0.01; z > -0.01; z -= 1e-3) {
            led.proxy.state.shapeRevision = kNoShape;
            led.to({0, 0, z});
            through += led.proxy.state.proxy.position.z() < 0;
        }
        QCOMPARE_GT(through, 0);
    }

    void nothingPopsThroughALargeMesh() {
        Led led(worldOf(hills(), rough(0.6, 0.4), kRadius));
        wander(led, paths() / 4, hillsAt);
    }

    void soupsAreSound_data() {
        QTest::addColumn<int>("triangles");
        QTest::addColumn<int>("soups");
        QTest::addColumn<bool>("allOver");
        QTest::addColumn<double>("rate");
        QTest::newRow("200 triangles, led near the middle") << 200 << 20 << false << 1e3;
        QTest::newRow("200 triangles, led all over") << 200 << 20 << true << 1e3;
        QTest::newRow("800 triangles, led all over") << 800 << 20 << true << 1e3;
        QTest::newRow("3000 triangles, led all over") << 3000 << 8 << true << 1e3;
        QTest::newRow("800 triangles, led all over, 300 Hz") << 800 << 20 << true << 300.0;
    }

    /// Triangles of every kind, through each other: they have no inside, and a proxy may go around each of
    /// them, so that nobody can say what it is behind of. But its sphere is never in one. Led all over, the
    /// proxy falls from pocket to pocket under the full force, and that is no fault.
    void soupsAreSound() {
        QFETCH(int, triangles);
        QFETCH(int, soups);
        QFETCH(bool, allOver);
        QFETCH(double, rate);
        const int ways = paths() / 40;
        Rng random(12);
        long ticks = 0, pushing = 0;
        for (int mesh = 0; mesh < soups; ++mesh) {
            Material material = rough(uniform(random, 0, 1.5), 0);
            material.stiffness = uniform(random, 100, 5000);
            material.damping = uniform(random, 0, 20);
            const Soup soup = randomSoup(random, triangles, kReach);
            const TriangleGrid grid(*soup, 1.25 * kRadius);
            Led led(worldOf(soup, material, kRadius), rate);
            led.rest({0, 0, 0.05});
            for (int i = 0; i < ways; ++i) {
                const Vec3 from = led.finger;
                const double fastest = allOver ? uniform(random, 0.05, kFastest) : kFastest;
                const Vec3 wanted = inBox(random, kReach);
                const Vec3 to = reached(from, allOver ? wanted : from + (wanted - from) * 0.5, fastest);
                for (int step = 1; step <= kSteps; ++step) {
                    pushing += led.to(from + (to - from) * (double(step) / kSteps)).isZero(0) ? 0 : 1;
                    ++ticks;
                    QVERIFY(led.sound());
                    const QString place = QString("mesh %1, path %2").arg(mesh).arg(i);
                    const double gap = clearance(grid, led.proxy.state.proxy.position, 2 * kRadius);
                    QVERIFY2(gap >= kRadius * (1 - 1e-5), qPrintable(place + QString(": %1 m").arg(gap)));
                    QVERIFY2(led.servo.state.gate.faults() == 0, qPrintable(place + ": a fault"));
                }
            }
        }
        qInfo("force in %.1f %% of the ticks", 100.0 * double(pushing) / double(ticks));
        QCOMPARE_GT(20 * pushing, ticks); // mostly there is nothing near
    }

    void bodiesAreLedThrough_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<double>("rate");
        for (const double rate : {100.0, 1000.0}) {
            QTest::addRow("ball, %g Hz", rate) << 0 << rate;
            QTest::addRow("plate with a rim, %g Hz", rate) << 1 << rate;
            QTest::addRow("egg crate, %g Hz", rate) << 2 << rate;
            QTest::addRow("pipe, %g Hz", rate) << 3 << rate;
        }
    }

    /// All the way through and out on the other side: the proxy goes around meanwhile, and the force turns as
    /// fast as the finger passes the middle.
    void bodiesAreLedThrough() {
        QFETCH(int, shape);
        QFETCH(double, rate);
        const Soup soups[] = {ball(0.02, 4), plate(0.015, kThin), eggCrate(0.03, 60, 2e-3, 0.01),
                              pipe(0.015, 0.02, 12)};
        Material material = rough(0.6, 0.4);
        material.stiffness = 3000;
        material.damping = 1;
        Led led(worldOf(soups[shape], material, kRadius), rate);
        led.rest({0, 0, kReach});
        Rng random(3);
        const Vec3 half(0.025, 0.025, 0.0175), middle(0, 0, 0.0025);
        for (int i = 0; i < paths() / 5; ++i) {
            const Vec3 from = led.finger;
            const double speed = uniform(random, 0.05, kFastest);
            const Vec3 to = reached(from, middle + inBox(random, 1).cwiseProduct(half), speed);
            for (int step = 1; step <= kSteps; ++step) {
                led.to(from + (to - from) * (double(step) / kSteps));
                QVERIFY(led.sound());
            }
            QVERIFY2(led.servo.state.gate.faults() == 0, qPrintable(QString("path %1: a fault").arg(i)));
        }
    }

    /// Off the rim of a sheet without thickness, pressed by as much as its proxy is thick: on the other side
    /// of the rim the nearest place for the proxy is on the other side of the sheet, and pushes as hard.
    void offTheRimOfASheet() {
        constexpr double kHalf = 0.02, kDeep = 5e-5, kSpeed = 0.02;
        Material material = frictionless();
        material.stiffness = 4000;
        Led led(worldOf(sheet(kHalf), material, kRadius));
        led.rest({kHalf - 0.002, 0, 0.005});
        for (double z = 0.005; z > -kDeep; z -= kSpeed * 1e-3)
            led.to({kHalf - 0.002, 0, z});
        double kick = 0, down = 0, up = 0;
        const auto to = [&](double x) {
            const Vec3 before = led.servo.output.force, way(x - led.finger.x(), 0, 0);
            const Vec3 now = led.to({x, 0, -kDeep});
            kick = std::max(kick, rise(now, before) - material.stiffness * way.norm());
            up = std::max(up, now.z());
            down = std::min(down, now.z());
        };
        for (double x = kHalf - 0.002; x < kHalf; x += kSpeed * 1e-3)
            to(x);
        for (int i = 0; i < 200; ++i)
            to(kHalf + 1e-5);
        qInfo("from %.2f to %.2f N, at most %.2f N at once", up, down, kick);
        QCOMPARE_GT(up, 4);
        QCOMPARE_LT(down, -3);
        QCOMPARE_LE(kick, 0.1);
        QCOMPARE(led.servo.state.gate.faults(), 0u);
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

TACTUM_TEST(TestStabilityMeshes)

} // namespace test_stability_meshes

#include "test_stability_meshes.moc"
