// A Falcon that is plugged in and pulled out a thousand times, at any moment of being made ready, felt and
// closed.
#include <algorithm>
#include <random>

#include <QTest>

#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_cycles {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kHurry = 1000;
/// A hand that homes within some milliseconds.
constexpr FalconBody::Hand kQuickHand{.mass = 0.15, .stiffness = 1e5, .damping = 250, .speed = 20};

int cyclesAskedFor() {
    const int asked = qEnvironmentVariableIntValue("TACTUM_CYCLES");
    return asked > 0 ? std::max(asked, 4) : 1000;
}

/// What came of the cycles of one Falcon.
struct Cycles {
    int notReady = 0, ready = 0, felt = 0, loaded = 0;
    std::string wrong; ///< what ended them; empty: they were all gone through
};

/// Plugs it in and pulls it out so often, at any moment.
Cycles goThrough(FalconBench& bench, int cycles, unsigned seed) {
    std::mt19937 random(seed);
    auto falcon = bench.driver();
    Cycles all;
    for (int cycle = 0; cycle < cycles && all.wrong.empty(); ++cycle) {
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
        const auto after = std::chrono::microseconds(cold ? 140'000 + random() % 200'000 : random() % 40'000);
        std::jthread puller([after, &bench] {
            std::this_thread::sleep_for(after);
            bench.pull();
        });
        Person person(bench.device);
        person.homes = random() % 4 != 0;
        if (!person.homes) person.givesUpAt = "Home";
        const auto prepared = falcon->prepare(person);
        if (!prepared && refusal(prepared).find("Falcon") == std::string::npos)
            all.wrong = prepared.error().text;
        if (prepared && falcon->open()) {
            const int exchanges = int(random() % 60);
            all.felt += exchange(*falcon, exchanges, {0, 0, 1}).valid;
            if (random() % 4 == 0) falcon->emergencyStop();
            if (random() % 4 == 0) falcon->close();
        }
        if (random() % 4 == 0) falcon = bench.driver();
        puller.join();
        if (exchange(*falcon, 2, {0, 0, 1}).valid != 0) all.wrong = "a reading of one that was pulled out";
        if (bench.device->firstHadTorque()) all.wrong = "the first command had a torque";
        if (bench.device->malformed() != 0) all.wrong = "bytes that belong to no command";
        prepared ? ++all.ready : ++all.notReady;
        all.loaded += bench.device->uploads() - uploads;
    }
    return all;
}

} // namespace

class TestFalconCycles : public QObject {
    Q_OBJECT

private slots:
    /// Several at once, because nearly all of it is waiting.
    void pluggedInAndPulledOut() {
        constexpr int kAtOnce = 4;
        const int cycles = cyclesAskedFor() / kAtOnce;
        std::vector<std::unique_ptr<FalconBench>> benches;
        std::vector<Cycles> each(kAtOnce);
        for (int i = 0; i < kAtOnce; ++i) {
            benches.push_back(std::make_unique<FalconBench>(kHurry, kSocket + i));
            benches.back()->device->setHand(kQuickHand);
        }
        {
            std::vector<std::jthread> people;
            for (int i = 0; i < kAtOnce; ++i)
                people.emplace_back([&bench = *benches[i], &one = each[i], cycles, i] {
                    one = goThrough(bench, cycles, 11 + unsigned(i));
                });
        }
        Cycles all;
        for (const Cycles& one : each) {
            QVERIFY2(one.wrong.empty(), one.wrong.c_str());
            all.ready += one.ready;
            all.notReady += one.notReady;
            all.felt += one.felt;
            all.loaded += one.loaded;
        }
        qInfo("%d cycles: %d times ready, %d not, %d exchanges felt, firmware loaded %d times",
              kAtOnce * cycles, all.ready, all.notReady, all.felt, all.loaded);
        const int few = kAtOnce * cycles / 20;
        QVERIFY(all.ready > few && all.notReady > few && all.loaded > 0 && all.felt > 0);
        QCOMPARE(EmulatedBus::the().openDescriptors(), 0);
        QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
    }
};

TACTUM_TEST(TestFalconCycles)

} // namespace test_falcon_cycles

#include "test_falcon_cycles.moc"
