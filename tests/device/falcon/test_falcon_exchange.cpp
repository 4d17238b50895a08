// What an exchange over USB costs in the servo: libusb's allocations and locks, counted; our own are none
// (tests/device/usb). docs/decisions/usb.md says why they may be.
#include <cstdlib>

#include <dlfcn.h>
#include <pthread.h>

#include <QTest>

#include "tests/device/falcon/falcon_bench.h"
#include "tests/device/usb/emulated_kernel.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
}

namespace {

struct Cost {
    int allocations = 0, locks = 0, waits = 0;
    std::size_t bytes = 0;
};
thread_local Cost cost;
thread_local bool counting = false;

/// What the emulated kernel does is nobody's fault.
bool counts() {
    return counting && !tactum::test::kernel::isInside();
}
template <class Function> Function* next(Function*, const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
    if (counts()) ++cost.allocations, cost.bytes += size;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    if (counts()) ++cost.allocations, cost.bytes += count * size;
    return __libc_calloc(count, size);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static const auto lock = next(&pthread_mutex_lock, "pthread_mutex_lock");
    if (counts()) ++cost.locks;
    return lock(mutex);
}
int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
    static const auto wait = next(&pthread_cond_timedwait, "pthread_cond_timedwait");
    if (counts()) ++cost.waits;
    return wait(condition, mutex, until);
}
}

namespace test_falcon_exchange {

using namespace tactum;
using namespace tactum::test;

class TestFalconExchange : public QObject {
    Q_OBJECT

private slots:
    /// The same in each, however many there were: what grew would not be bounded. Nobody else holds the
    /// locks.
    void allocatesAndLocksALittle() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        exchange(*falcon, 200);
        constexpr int kExchanges = 2000;
        Cost most, sum;
        int valid = 0;
        for (int i = 0; i < kExchanges; ++i) {
            cost = {};
            counting = true;
            valid += falcon->exchange({{0.1, 0, 0.1}}, 1e-3).valid;
            counting = false;
            most.allocations = std::max(most.allocations, cost.allocations);
            most.locks = std::max(most.locks, cost.locks);
            most.bytes = std::max(most.bytes, cost.bytes);
            sum.allocations += cost.allocations;
            sum.locks += cost.locks;
            sum.waits += cost.waits;
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        qInfo("allocations %.2f an exchange, %d and %d bytes at most; locks %.1f, %d at most; %d waits",
              double(sum.allocations) / kExchanges, most.allocations, int(most.bytes),
              double(sum.locks) / kExchanges, most.locks, sum.waits);
        QCOMPARE_GT(valid, kExchanges / 2);
        QCOMPARE_GT(sum.allocations, 0); // they are counted at all
        // What one costs as a rule; a late one takes up at most what all reads of the stream have got.
        constexpr int kAllocations = 8, kLocks = 64, kReads = 3; // of UsbLink::startStream()
        QCOMPARE_LE(sum.allocations, kAllocations * kExchanges);
        QCOMPARE_LE(most.allocations, kAllocations * kReads);
        QCOMPARE_LE(most.bytes, std::size_t(4096));
        QCOMPARE_GT(sum.locks, 0);
        QCOMPARE_LE(sum.locks, kLocks * kExchanges);
        QCOMPARE_LE(most.locks, kLocks * kReads);
        QCOMPARE(sum.waits, 0);
    }
};

TACTUM_TEST(TestFalconExchange)

} // namespace test_falcon_exchange

#include "test_falcon_exchange.moc"
