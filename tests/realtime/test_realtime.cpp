// The proof that the loops neither allocate, release, lock nor wait: no hit of the interposer inside a
// RealtimeScope, over a million steps and over the running engine, with edits and swaps of the World.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <mutex>
#include <shared_mutex>
#include <thread>

#include <QTest>
#include <linux/futex.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/base/realtime.h"
#include "core/haptics/compile.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/core/runtime/patience.h"
#include "tests/realtime/bumpy_scene.h"
#ifndef TACTUM_SANITIZER_OWNS_MALLOC
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#else
namespace tactum::interposer { // never reached: initTestCase skips
void reset() {}
std::uint64_t hits() {
    return 0;
}
std::string firstHit() {
    return {};
}
} // namespace tactum::interposer
#endif

using namespace tactum;
using namespace std::chrono_literals;

namespace {

constexpr double kStep = 1e-3;

/// A value that the compiler must believe to be used.
void* volatile escape = nullptr;

/// Page faults of this thread so far: a fault in a loop costs microseconds, one that reads a disk
/// milliseconds.
struct PageFaults {
    long minor = 0, major = 0;

    static PageFaults now() {
        rusage usage{};
        getrusage(RUSAGE_THREAD, &usage);
        return {usage.ru_minflt, usage.ru_majflt};
    }
    void addSince(const PageFaults& before) {
        const PageFaults after = now();
        minor += after.minor - before.minor;
        major += after.major - before.major;
    }
};

/// Three shapes, whose materials are edited by compiling again.
class EditedWorlds {
public:
    const World& current() const { return *worlds_.back(); }
    std::shared_ptr<const World> share() const { return worlds_.back(); }

    /// An edit of the material, and now and then another shape. The old World goes.
    void edit() {
        ++edits_;
        const auto& plate = plates_[std::size_t(edits_ / 5) % plates_.size()];
        const World* previous = worlds_.empty() ? nullptr : worlds_.back().get();
        worlds_.push_back(compile(bumpyScene(plate, edits_), previous).value());
        if (worlds_.size() > 4) worlds_.erase(worlds_.begin());
    }

private:
    std::vector<std::shared_ptr<const TriangleSoup>> plates_{bumpyPlate(1), bumpyPlate(2), bumpyPlate(3)};
    std::vector<std::shared_ptr<const World>> worlds_;
    int edits_ = 0;
};

struct Deed {
    const char* name;
    std::function<void()> act;
};

std::mutex mutex;
std::shared_mutex sharedMutex;
std::condition_variable condition;
int futex = 0;
const char* volatile nothing = ""; // of which the compiler does not know

std::vector<Deed> forbiddenDeeds() {
    return {
        {"malloc", [] { escape = std::malloc(64); }},
        {"free", [] { std::free(escape); }},
        {"calloc", [] { escape = std::calloc(4, 16); }},
        {"realloc", [] { escape = std::realloc(escape, 4096); }},
        {"operator new", [] { escape = ::operator new(64); }},
        {"operator delete", [] { ::operator delete(escape); }},
        {"aligned new", [] { escape = ::operator new(64, std::align_val_t(64)); }},
        {"aligned delete", [] { ::operator delete(escape, std::align_val_t(64)); }},
        {"std::vector", [] { std::vector<double>(100).swap(*std::make_unique<std::vector<double>>()); }},
        {"a Qt string", [] { QString::number(3.14159).append("mm"); }},
        {"mutex", [] { std::lock_guard lock(mutex); }},
        {"try_lock",
         [] {
             if (mutex.try_lock()) mutex.unlock();
         }},
        {"shared lock", [] { std::shared_lock lock(sharedMutex); }},
        {"unique shared lock", [] { std::unique_lock lock(sharedMutex); }},
        {"condition",
         [] {
             std::unique_lock lock(mutex);
             condition.wait_for(lock, 1us);
         }},
        {"notify", [] { condition.notify_all(); }},
        {"sleep", [] { std::this_thread::sleep_for(1us); }},
        {"yield", [] { std::this_thread::yield(); }},
        {"write", [] { escape = ::write(-1, "", 0) == 0 ? nullptr : escape; }},
        {"read", [] { escape = ::read(-1, nullptr, 0) == 0 ? nullptr : escape; }},
        {"poll", [] { ::poll(nullptr, 0, 0); }},
        {"ioctl", [] { ::ioctl(-1, 0, nullptr); }},
        {"mmap", [] { escape = ::mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); }},
        {"munmap", [] { ::munmap(escape, 4096); }},
        {"fprintf", [] { std::fprintf(stderr, "%.0s", nothing); }},
        {"fputs", [] { std::fputs(nothing, stderr); }},
        {"std::cerr", [] { std::cerr << nothing << std::flush; }},
        {"snprintf",
         [] {
             char text[8];
             escape = std::snprintf(text, sizeof text, "%d", 1) > 9 ? nullptr : escape;
         }},
        {"a futex", [] { syscall(SYS_futex, &futex, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0); }},
    };
}

} // namespace

class TestRealtime : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#ifdef TACTUM_SANITIZER_OWNS_MALLOC
        QSKIP("The sanitizer owns malloc and the locks in this build: the interposer cannot count them.");
#endif
    }

    void interposerSeesEveryForbiddenDeed() {
        for (const Deed& deed : forbiddenDeeds()) {
            interposer::reset();
            deed.act();
            QCOMPARE(interposer::hits(), 0u); // outside the scope all of it is allowed
        }
        for (const Deed& deed : forbiddenDeeds()) {
            interposer::reset();
            {
                const RealtimeScope scope;
                deed.act();
            }
            QVERIFY2(interposer::hits() > 0, deed.name);
            QCOMPARE_NE(interposer::firstHit(), "none");
        }
    }

    void interposerLooksAtTheCallersThreadOnly() {
        interposer::reset();
        std::atomic<bool> inside{false}, done{false};
        std::thread loop([&] {
            const RealtimeScope scope;
            inside = true;
            while (!done) {
            }
        });
        while (!inside) {
        }
        for (int i = 0; i < 1000; ++i) {
            escape = std::malloc(64);
            std::free(escape);
        }
        done = true;
        loop.join();
        QCOMPARE(interposer::hits(), 0u);
    }

    void aMillionHapticSteps() {
        EditedWorlds worlds;
        worlds.edit();
        SimState state;
        ServoState servo({.name = "Still hand",
                          .maxForce = 8,
                          .continuousForce = 3,
                          .rate = 1 / kStep,
                          .damping = 8,
                          .tripSpeed = 100});
        const auto rehearsed = std::make_unique<HandState>();
        const int steps = tactum::test::longOnly(1'000'000);
        int touching = 0, slipping = 0, riding = 0, squeezed = 0;
        PageFaults faults;
        interposer::reset();
        for (int i = 0; i < steps; ++i) {
            if (i % 2000 == 1999) worlds.edit();
            const Vec3 finger = wanderingFinger(kStep * i);
            const Vec3 velocity = (finger - wanderingFinger(kStep * (i - 1))) / kStep;
            const PageFaults before = PageFaults::now();

            const RealtimeScope scope;
            rehearse(worlds.current(), state, state.time, {finger, velocity}, kStep, *rehearsed);
            const HapticOutput output = hapticStep(worlds.current(), state, {finger, velocity}, kStep);
            state.model.anchoring = servo.gate.anchoring();
            const Vec3 force =
                servoStep(servo, {.armed = !isFault(servo.gate.inhibit())}, // faster than a hand
                          {.sample = {finger, velocity, 0, true}, .dt = kStep, .fresh = true}, state.model)
                    .force;
            if (i > 10'000) faults.addSince(before);
            touching += output.contacts > 0 && force.norm() > 0;
            slipping += output.contact[0].slipping;
            riding += output.contacts > 0 && output.contact[0].body == 1;
            squeezed += output.report.squeezed;
        }
        // Reported, not asserted: the machine may take pages away from whoever it likes.
        qInfo("touching %d, slipping %d of %d; page faults after warm-up: %ld minor, %ld major", touching,
              slipping, steps, faults.minor, faults.major);
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QCOMPARE_GT(touching, steps * 3 / 10);
        QCOMPARE_GT(slipping, steps / 100);
        QCOMPARE_GT(riding, steps / 100);                          // on the body that moves
        if (test::isLong()) QCOMPARE_GT(squeezed, steps / 10'000); // once in a hundred thousand steps or not
    }

    /// A minute of rows and states while somebody copies them again and again.
    void theFlightRecorder() {
        Recorder recorder(1000, 2000);
        std::atomic<bool> done{false};
        std::thread reader([&] {
            while (!done)
                escape = recorder.copy().proxy.rows.data();
        });
        EditedWorlds worlds;
        worlds.edit();
        SimState sim;
        ServoState servo(SimulatedHand(std::make_shared<HandTarget>()).info());
        PageFaults faults;
        interposer::reset();
        for (int i = 0; i < 130'000; ++i) {
            const double time = 5e-4 * i;
            ProxyRow proxyRow{.time = time,
                              .dt = 5e-4,
                              .finger = tripleOf(wanderingFinger(time)),
                              .world = worlds.current().revision};
            ServoRow servoRow{.time = time, .dt = 1e-3, .flags = ServoRow::Valid};
            const PageFaults before = PageFaults::now();

            const RealtimeScope scope;
            recorder.begin(proxyRow, sim);
            note(proxyRow, stepFrom(proxyRow, worlds.current(), sim));
            recorder.end(proxyRow);
            if (i % 2 == 0) {
                recorder.begin(servoRow, servo);
                note(servoRow, stepFrom(servoRow, servo, sim.model), servo);
                recorder.end(servoRow);
            }
            if (i > 1000) faults.addSince(before);
        }
        done = true;
        reader.join();
        qInfo("%.1f MB; page faults after warm-up: %ld minor, %ld major", 1e-6 * double(recorder.bytes()),
              faults.minor, faults.major);
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        const RecordedRun run = recorder.copy();
        QCOMPARE_GT(run.proxy.first, 0);
        QCOMPARE_GT(run.proxyStates.size(), 60); // it went round
    }

    void theRunningEngine_data() {
        QTest::addColumn<int>("hands");
        QTest::newRow("of one hand") << 1;
        QTest::newRow("of two hands") << 2;
    }
    void theRunningEngine() {
        QFETCH(int, hands);
        const auto target = std::make_shared<HandTarget>(), other = std::make_shared<HandTarget>();
        LocalEngine engine(std::make_unique<SimulatedHand>(target));
        EditedWorlds worlds;
        worlds.edit();
        interposer::reset();
        engine.publish(worlds.share());
        QVERIFY(engine.start().has_value());
        if (hands > 1) QVERIFY(engine.addDevice(std::make_unique<SimulatedHand>(other)).has_value());
        engine.setAllArmed(true);
        std::uint64_t frames = 0, touching = 0, pushed = 0;
        const bool ran = eventually([&] {
            engine.poll();
            target->write({.position = wanderingFinger(4e-3 * double(++frames))});
            other->write({.position = wanderingFinger(3e-3 * double(frames))});
            if (frames % 10 == 0) {
                worlds.edit();
                engine.publish(worlds.share());
            }
            if (frames % 500 == 0) engine.restartProxy();
            if (frames % 300 == 0) engine.setAllArmed(frames % 600 == 0);
            touching += engine.proxy().output.contacts > 0;
            pushed += engine.hand(engine.hands() - 1).servo().force.norm() > 0;
            for (TracePoint point; engine.popTrace(point);)
                continue;
            return engine.proxy().updates >= 8000 && engine.servo().ticks >= 4000;
        });
        engine.stop();
        qInfo("%s servo %.0f Hz, %.0f us jitter, %llu misses; proxy %.0f Hz, %.1f us mean, %.1f us worst",
              engine.priorityNote().c_str(), engine.servo().rate, engine.servo().jitterMicros,
              static_cast<unsigned long long>(engine.servo().misses), engine.proxy().rate,
              engine.proxy().updateMicros, engine.proxy().worstUpdateMicros);
        QVERIFY(ran);
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QCOMPARE_GT(touching, frames / 20);
        QCOMPARE_GT(pushed, frames / 20);
    }
};

TACTUM_TEST(TestRealtime)
#include "test_realtime.moc"
