// T10: a slow or late proxy loop costs fidelity, not stability. Nobody helps: of the losses only the device's
// own count.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/as_connected.h"
#include "tests/physics/event.h"
#include "tests/physics/hand_script.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_proxy {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;

Material springy(double stiffness) {
    Material material = frictionless();
    material.stiffness = stiffness;
    return material;
}

/// A servo that is led along a path, with all that hand-over from model to model gave.
struct Led {
    Led(std::shared_ptr<const World> world, double rate, double latency,
        const PlantProfile& theDevice = kFalcon)
        : device(theDevice), proxy(std::move(world), rate, latency), servo(info(theDevice), proxy) {}

    static DeviceInfo info(const PlantProfile& device) {
        DeviceInfo info = infoOf({device, kNoHand, {}});
        info.tripSpeed = 5;
        return info;
    }

    void to(const Vec3& position) {
        const LocalContactModel before = servo.state.transition.rendered(), answer = servo.model;
        const Vec3 force = servo.output.force;
        const Vec3 way = position - last;
        if (begun)
            work += force.dot(way) - device.damping * way.squaredNorm() / 1e-3 - device.friction * way.norm();
        most = std::max(most, work);
        if (force.isZero(0)) touchedWork = work;
        contact = std::max(contact, work - touchedWork);
        drag = std::max(drag, force.norm());
        last = position;
        begun = true;
        DeviceSample sample;
        sample.position = position;
        sample.valid = true;
        servo(sample, 1e-3);
        handOver += std::max(0.0, storedIn(servo.state.transition.rendered(), position, 0) -
                                      storedIn(before, position, kReturnSpeed * 1e-3));
        atOnce += std::max(0.0, storedIn(answer, position, 0) - storedIn(answered, position, 0));
        answered = answer;
        time += 1e-3;
    }
    /// `returned`: how far the surface may come back meanwhile.
    double storedIn(const LocalContactModel& model, const Vec3& finger, double returned) const {
        const double stretch = (anchorOf(model, finger).position - finger).norm();
        const double more = servo.state.transition.easing() ? returned : 0;
        return 0.5 * model.stiffness * (stretch + more) * (stretch + more);
    }
    void rest(double seconds) {
        for (double t = 0; t < seconds; t += 1e-3)
            to(last);
    }
    void go(const Vec3& target, double speed) {
        const Vec3 from = last;
        const int steps = std::max(1, int((target - from).norm() / (speed * 1e-3)));
        for (int i = 1; i <= steps; ++i)
            to(from + (target - from) * (double(i) / steps));
    }

    /// In and out of what is there, for some seconds.
    void wander() {
        to({-0.01, 0, 0.02});
        rest(0.8);
        work = most = handOver = atOnce = time = 0;
        Rng random(1);
        for (int i = 0; i < 60; ++i)
            go({uniform(random, -0.012, 0.012), uniform(random, -0.012, 0.012),
                uniform(random, -0.006, 0.006)},
               uniform(random, 0.02, 0.3));
    }

    PlantProfile device;
    Proxy proxy;
    Servo servo;
    Vec3 last = Vec3::Zero();
    bool begun = false;
    double work = 0, most = 0, drag = 0, handOver = 0, time = 0;
    double touchedWork = 0, contact = 0; ///< J, when the last contact began; the most that one gave
    double atOnce = 0;          ///< J, what hand-over would have given if every answer were met as it comes
    LocalContactModel answered; ///< in the last tick
};

} // namespace

class TestStabilityProxy : public QObject {
    Q_OBJECT

private slots:
    void slowProxyCostsNothingButFidelity_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("latency");
        for (const double rate : {50.0, 100.0, 300.0, 1000.0})
            for (const double latency : {0.0, 0.005, 0.02})
                QTest::addRow("%g Hz, %g ms late", rate, 1e3 * latency) << rate << latency;
    }

    void slowProxyCostsNothingButFidelity() {
        QFETCH(double, rate);
        QFETCH(double, latency);
        Led free(worldOf(sheet(0.1), springy(1500), kRadius), rate, latency);
        free.to({-0.05, 0, 0.02});
        free.rest(0.8);
        for (int i = 0; i < 5; ++i) {
            free.go({0.05, 0, 0.02}, 0.5);
            free.go({-0.05, 0, 0.02}, 0.5);
        }
        QCOMPARE_LE(free.drag, 0.05);

        double given = 0, handOver = 0;
        for (const Soup& soup :
             {sheet(0.1), transformed(*ball(0.03, 4), {Quat::Identity(), {0, 0, -0.03}}), wedge(2.1, 0.1)}) {
            Led led(worldOf(soup, springy(1500), kRadius), rate, latency);
            led.wander();
            given = std::max(given, led.most);
            handOver = std::max(handOver, led.handOver / led.time);
            QCOMPARE_LE(led.most, 1e-6);
            QCOMPARE_LE(led.handOver, kHandOverPower * led.time + kHandOverEnergy);
            QCOMPARE(led.servo.state.gate.faults(), 0u);
        }
        qInfo("drag %.3f N, W %.3g mJ, hand-over %.2f mJ/s", free.drag, 1e3 * given, 1e3 * handOver);
    }

    void slowViscousProxyGivesLittle_data() {
        QTest::addColumn<double>("rate");
        for (const double rate : {30.0, 50.0, 100.0, 200.0, 1000.0})
            QTest::addRow("%g Hz", rate) << rate;
    }

    /// Friction that holds and drags: what slides on in the servo must not run ahead of a proxy that is late.
    void slowViscousProxyGivesLittle() {
        QFETCH(double, rate);
        for (const double friction : {0.0, 0.5, 1.5}) {
            double plain = 0;
            for (const double viscosity : {0.0, 5.0, 20.0}) {
                Material material = rough(friction, 0.8 * friction, viscosity);
                material.stiffness = 800;
                Led led(worldOf(sheet(0.1), material, kRadius), rate, 0, kPremium);
                led.servo.settings.overrideCeiling = true; // as stiff as it asks to be
                led.to({-0.01, 0, 0.02});
                led.rest(0.8);
                led.work = led.most = led.contact = led.touchedWork = 0;
                Rng random(3);
                for (int i = 0; i < 300; ++i)
                    led.go({uniform(random, -0.04, 0.04), uniform(random, -0.04, 0.04),
                            uniform(random, -0.006, i % 3 == 2 ? 0.006 : -0.001)},
                           uniform(random, 0.02, 0.3));
                if (viscosity == 0)
                    plain = led.contact; // what was found late comes back: that is its own work
                qInfo("mu %g, %g N s/m: %.2f mJ a contact", friction, viscosity, 1e3 * led.contact);
                QCOMPARE_LE(led.contact, plain + 2e-3);
                QCOMPARE(led.servo.state.gate.faults(), 0u);
            }
        }
    }

    /// In hands: what drags gives no more than what is free of it, and is no fault.
    void viscosityCostsNoEnergyInHands() {
        double plain = 0;
        for (const double rate : {1000.0, 200.0, 100.0, 50.0, 30.0})
            for (const double viscosity : {0.0, 20.0}) {
                double most = 0;
                int faults = 0;
                for (const HandProfile& hand : {kPinch, kGrasp, kFirm})
                    for (int seed = 0; seed < 2; ++seed) {
                        Material material = rough(1.5, 1.2, viscosity);
                        material.stiffness = 800;
                        Proxy proxy(worldOf(sheet(0.1), material, kRadius), rate, 0);
                        Servo servo(connectedInfo(kPremiumConnected), proxy);
                        ClosedLoop loop(benchOf(kPremiumConnected, hand), servo.control(), 3,
                                        std::uint64_t(seed));
                        HandScript script(std::uint64_t(seed), kRadius, 0.25);
                        loop.plant.place({0, 0, 0.01});
                        loop.warmUp();
                        double before = 0;
                        loop.run(15, [&](ClosedLoop& now) {
                            now.plant.setGoal(script.goal(1e-3));
                            if (now.command.isZero(0)) before = now.plant.given();
                            most = std::max(most, now.plant.given() - before);
                        });
                        faults += int(servo.state.gate.faults());
                    }
                qInfo("%g Hz, %g N s/m: %.2f mJ a contact", rate, viscosity, 1e3 * most);
                QCOMPARE(faults, 0);
                if (viscosity == 0) plain = most;
                QCOMPARE_LE(most, plain + 1e-3);
            }
    }

    /// The hand-over switched off.
    void answersThatAreMetAsTheyComeGive() {
        Led led(worldOf(wedge(2.1, 0.1), springy(1500), kRadius), 50, 0.02);
        led.wander();
        qInfo("hand-over %.2f mJ/s, without it %.2f", 1e3 * led.handOver / led.time,
              1e3 * led.atOnce / led.time);
        QCOMPARE_GT(led.atOnce, 2 * (kHandOverPower * led.time + kHandOverEnergy));
    }

    /// Rule 6 switched off: a spring to the proxy itself drags in free motion.
    void springToThePointDrags() {
        for (const double rate : {1000.0, 100.0}) {
            Proxy proxy(worldOf(sheet(0.1), springy(1500), kRadius), rate);
            LocalContactModel model;
            double drag = 0;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 finger(0.3 * 1e-3 * i, 0, 0.02);
                proxy.answer({finger, {}, 0, true, 1}, 1e-3, model);
                if (i > 100) drag = std::max(drag, 1500 * (model.proxy - finger - Vec3(3e-4, 0, 0)).norm());
            }
            qInfo("%g Hz: %.2f N", rate, drag);
            QCOMPARE_GT(drag, 0.4);
        }
    }
};

TACTUM_TEST(TestStabilityProxy)

} // namespace test_stability_proxy

#include "test_stability_proxy.moc"
