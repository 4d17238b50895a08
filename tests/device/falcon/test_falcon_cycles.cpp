// A Falcon that is plugged in and pulled out a thousand times, at any moment of being made ready, felt and
// closed.
#include <random>

#include <QtTest>

#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kHurry = 1000;
/// A hand that homes within some milliseconds.
constexpr FalconBody::Hand kQuickHand{.mass = 0.15, .stiffness = 1e5, .damping = 250, .speed = 20};

int cyclesAskedFor() {
    const int asked = qEnvironmentVariableIntValue("TACTUM_CYCLES");
    return asked > 0 ? asked : 1000;
}

} // namespace

class TestFalconCycles : public QObject {
    Q_OBJECT

private slots:
    void pluggedInAndPulledOut() {
        FalconBench bench(kHurry);
        bench.device->setHand(kQuickHand);
        std::mt19937 random(11);
        auto falcon = bench.driver();
        int notReady = 0, ready = 0, felt = 0, loaded = 0;
        const int cycles = cyclesAskedFor();
        for (int cycle = 0; cycle < cycles; ++cycle) {
            const bool cold = random() % 6 == 0;
            if (cold) {
                bench.device->setPower(false);
                bench.device->setPower(true);
            } else {
                bench.device->startFirmware(true);
            }
            bench.device->putGrip(Vec3::Zero());
            const int uploads = bench.device->uploads();
            bench.plug();
            // Whoever has no firmware is asked for 150 ms before he gets some.
            const auto after =
                std::chrono::microseconds(cold ? 140'000 + random() % 200'000 : random() % 40'000);
            std::jthread puller([after] {
                std::this_thread::sleep_for(after);
                FalconBench::unplug();
            });
            Person person(bench.device);
            person.homes = random() % 4 != 0;
            if (!person.homes) person.givesUpAt = "Home";
            const auto prepared = falcon->prepare(person);
            if (!prepared) COMPARE_CONTAINS(refusal(prepared), "Falcon");
            if (prepared && falcon->open()) {
                const int exchanges = int(random() % 60);
                felt += exchange(*falcon, exchanges, {0, 0, 1}).valid;
                if (random() % 4 == 0) falcon->emergencyStop();
                if (random() % 4 == 0) falcon->close();
            }
            if (random() % 4 == 0) falcon = bench.driver();
            puller.join();
            QCOMPARE(exchange(*falcon, 2, {0, 0, 1}).valid, 0);
            QVERIFY(!bench.device->firstHadTorque());
            QCOMPARE(bench.device->malformed(), 0);
            prepared ? ++ready : ++notReady;
            loaded += bench.device->uploads() - uploads;
        }
        falcon.reset();
        qInfo("%d cycles: %d times ready, %d not, %d exchanges felt, firmware loaded %d times", cycles, ready,
              notReady, felt, loaded);
        QCOMPARE_GT(ready, cycles / 20);
        QCOMPARE_GT(notReady, cycles / 20);
        QCOMPARE_GT(loaded, 0);
        QCOMPARE_GT(felt, 0);
        QCOMPARE(EmulatedBus::the().openDescriptors(), 0);
        QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
    }
};

QTEST_APPLESS_MAIN(TestFalconCycles)
#include "test_falcon_cycles.moc"
