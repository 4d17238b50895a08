// Two Falcons on one engine, of which now one and now the other is pulled out and plugged in again: while
// both press, while one is made ready, while the engine takes it. The other goes on each time.
#include <array>
#include <cerrno>
#include <random>
#include <thread>

#include <sys/wait.h>

#include <QTest>

#include "core/runtime/local_engine.h"
#include "tests/core/runtime/patience.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_falcon_pair_cycles {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kHurry = 1000;
/// A hand that homes within some milliseconds.
constexpr FalconBody::Hand kQuickHand{.mass = 0.15, .stiffness = 1e5, .damping = 250, .speed = 20};
constexpr int kSome = 10; ///< readings and commands: more than chance

class Pair {
public:
    explicit Pair(unsigned seed) : random_(seed) {
        for (const FalconBench& bench : benches_)
            bench.device->setHand(kQuickHand);
    }
    /// The first sentence that something is wrong; empty when both run.
    std::string start() {
        engine_ = std::make_unique<LocalEngine>(ready(0).value());
        engine_->publish(worldOf(sheet(0.1), Material()));
        if (auto started = engine_->start(); !started) return started.error().text;
        of_ = {0};
        return add(1);
    }
    /// One is pulled out at any moment of being felt, and comes again. What is wrong, or nothing.
    std::string goThrough() {
        const std::size_t lost = random_() % 2, other = 1 - lost, bench = of_[lost];
        engine_->setAllArmed(random_() % 4 != 0);
        feelFor(std::chrono::microseconds(random_() % 20'000));
        benches_[bench].pull();
        const std::uint64_t unread = engine_->hand(lost).servo().invalidSamples;
        if (!eventually([&] {
                engine_->poll();
                return engine_->hand(lost).servo().invalidSamples > unread + kSome;
            }))
            return "readings of one that was pulled out";
        const std::size_t left = of_[other];
        of_ = {left};
        if (!allGoOn()) return "the other one does not go on";
        if (auto removed = engine_->removeDevice(lost); !removed) return removed.error().text;
        if (!allGoOn()) return "the one that is left does not start again";
        return add(bench);
    }
    int pulledEarly() const { return pulledEarly_; }

private:
    /// Whether the device of each hand that there is obeys more commands than until now.
    bool allGoOn() {
        std::vector<int> before;
        for (const std::size_t bench : of_)
            before.push_back(benches_[bench].device->commands());
        return eventually([&] {
            engine_->poll();
            for (std::size_t hand = 0; hand < of_.size(); ++hand)
                if (benches_[of_[hand]].device->commands() <= before[hand] + kSome) return false;
            return true;
        });
    }
    void feelFor(std::chrono::microseconds time) {
        const auto end = std::chrono::steady_clock::now() + time;
        while (std::chrono::steady_clock::now() < end) {
            engine_->poll();
            engine_->speakOf(random_() % engine_->hands());
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    Result<std::unique_ptr<Falcon>> ready(std::size_t bench) {
        benches_[bench].device->startFirmware(true);
        benches_[bench].device->putGrip(Vec3(bench == 0 ? -0.01 : 0.01, 0, -1e-3));
        benches_[bench].plug();
        auto falcon = benches_[bench].driver();
        Person person(benches_[bench].device);
        if (auto prepared = falcon->prepare(person); !prepared) return tl::unexpected(prepared.error());
        return falcon;
    }
    /// At first perhaps pulled out again before it is felt.
    std::string add(std::size_t bench) {
        std::jthread puller;
        if (random_() % 4 == 0)
            puller = std::jthread([after = random_() % 40'000, &one = benches_[bench]] {
                std::this_thread::sleep_for(std::chrono::microseconds(after));
                one.pull();
            });
        auto added = addOnce(bench);
        if (puller.joinable()) {
            puller.join();
            ++pulledEarly_;
            if (added) (void)engine_->removeDevice(engine_->hands() - 1);
            added = addOnce(bench);
        }
        if (!added) return added.error().text;
        of_.push_back(bench);
        if (benches_[bench].device->firstHadTorque()) return "the first command had a torque";
        if (benches_[bench].device->malformed() != 0) return "bytes that belong to no command";
        if (!allGoOn()) return "not both of them go on";
        return {};
    }
    Result<void> addOnce(std::size_t bench) {
        auto falcon = ready(bench);
        if (!falcon) return tl::unexpected(falcon.error());
        const std::size_t before = engine_->hands();
        auto added = engine_->addDevice(std::move(*falcon));
        if (added || engine_->hands() == before) return added;
        (void)engine_->removeDevice(before);
        if (auto again = engine_->start(); !again) return again;
        return added;
    }

    std::mt19937 random_;
    std::array<FalconBench, 2> benches_{FalconBench(kHurry, 2), FalconBench(kHurry, 3)};
    std::unique_ptr<LocalEngine> engine_; // ends before its devices
    std::vector<std::size_t> of_;         ///< the bench of each hand
    int pulledEarly_ = 0;
};

} // namespace

class TestFalconPairCycles : public QObject {
    Q_OBJECT

private slots:
    void oneGoesAndTheOtherStays() {
        {
            Pair pair(1);
            if (const std::string wrong = pair.start(); !wrong.empty()) QFAIL(wrong.c_str());
            const int cycles = repeats("TACTUM_CYCLES", 100);
            for (int cycle = 0; cycle < cycles; ++cycle)
                if (const std::string wrong = pair.goThrough(); !wrong.empty())
                    QFAIL(qPrintable(QString("cycle %1: %2").arg(cycle).arg(wrong.c_str())));
            qInfo("%d cycles, of which %d pulled out once more while it was made ready", cycles,
                  pair.pulledEarly());
        }
        QCOMPARE(EmulatedBus::the().openDescriptors(), 0);
        QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
        QVERIFY2(::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD, "a device watchdog was left");
    }
};

TACTUM_TEST(TestFalconPairCycles)

} // namespace test_falcon_pair_cycles

#include "test_falcon_pair_cycles.moc"
