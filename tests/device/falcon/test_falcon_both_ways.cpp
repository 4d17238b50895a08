// The driver of the Falcon and the emulated one over both back ends of the emulated bus: from power to
// forces, and pulled out. Nothing here counts on when something happens, only on that it does.
#include <QTest>

#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_both_ways {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kPatience = 5000; ///< exchanges
const Vec3 kPush(0.5, 0.3, 2);

template <class Wanted> bool exchangeUntil(Falcon& falcon, const Vec3& force, Wanted wanted) {
    for (int i = 0; i < kPatience; ++i)
        if (wanted(exchange(falcon, 1, force).last)) return true;
    return false;
}

bool isAt(const DeviceSample& sample, const Vec3& p) {
    return sample.valid && (sample.position - p).norm() < 1e-4;
}

bool isFelt(Falcon& falcon) {
    int valid = 0;
    return exchangeUntil(falcon, Vec3::Zero(), [&](const DeviceSample& sample) {
        valid += sample.valid;
        return valid == 50;
    });
}

bool pushes(Falcon& falcon, const EmulatedFalcon& device, const Vec3& force) {
    return exchangeUntil(falcon, force, [&](const DeviceSample&) {
        return (device.force() - force).norm() < 0.01 * force.norm() + 0.005;
    });
}

bool isClean() {
    return EmulatedBus::the().openDescriptors() == 0 && EmulatedBus::the().pendingTransfers() == 0;
}

} // namespace

class TestFalconBothWays : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QTRY_VERIFY(isClean()); }

    void fromPowerToReady() {
        FalconBench bench;
        const auto falcon = bench.driver();
        Person person(bench.device);
        const auto ready = falcon->prepare(person);
        VERIFY_RESULT(ready);
        QCOMPARE_EQ(bench.device->state(), EmulatedFalcon::State::Running);
        QVERIFY(bench.device->homed());
        QCOMPARE(bench.device->uploads(), 1);
        QCOMPARE(bench.device->latency(), 1);
        VERIFY_RESULT(falcon->open());
        QVERIFY(isFelt(*falcon));
        QCOMPARE(falcon->trouble(), std::string());
        QCOMPARE(bench.device->malformed(), 0);
    }

    void readsAndPushes() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        bench.device->setHand({.stiffness = 2000, .damping = 40});
        for (const Vec3& p : {Vec3(0.01, 0, 0), Vec3(0, 0.03, -0.01), Vec3(-0.02, -0.01, 0.02)}) {
            bench.device->putGrip(p);
            QVERIFY(exchangeUntil(*falcon, Vec3::Zero(),
                                  [&](const DeviceSample& sample) { return isAt(sample, p); }));
        }
        for (const Vec3& force : {Vec3(1, 0, 0), Vec3(0, -2, 0), Vec3(-1, 2, -3)})
            QVERIFY(pushes(*falcon, *bench.device, force));
        QVERIFY(!bench.device->overdriven());
        QCOMPARE(bench.device->malformed(), 0);
        falcon->close();
        QCOMPARE(bench.device->motors(), FalconLegs{});
    }

    void goesOnAfterAStall() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        QVERIFY(isFelt(*falcon));
        EmulatedBus::the().setFaults(kSocket, {.stallIn = true, .stallOut = true});
        QVERIFY(
            exchangeUntil(*falcon, kPush, [&](const DeviceSample&) { return !falcon->trouble().empty(); }));
        EmulatedBus::the().setFaults(kSocket, {});
        QVERIFY(isFelt(*falcon));
        QVERIFY(pushes(*falcon, *bench.device, kPush));
        QCOMPARE(bench.device->malformed(), 0);
    }

    void pulledOutAndPluggedInAgain() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        for (int times = 0; times < 3; ++times) {
            QVERIFY(pushes(*falcon, *bench.device, kPush));
            FalconBench::unplug();
            QVERIFY(exchangeUntil(*falcon, kPush, [&](const DeviceSample& sample) {
                return !sample.valid && falcon->trouble().find("unplugged") != std::string::npos;
            }));
            QCOMPARE(exchange(*falcon, 20, kPush).valid, 0);
            bench.plug();
            VERIFY_RESULT(falcon->open());
            QVERIFY(!bench.device->firstHadTorque());
        }
        QVERIFY(isFelt(*falcon));
    }
};

TACTUM_TEST(TestFalconBothWays)

} // namespace test_falcon_both_ways

#include "test_falcon_both_ways.moc"
