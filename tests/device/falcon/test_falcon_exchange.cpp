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
int libusb_submit_transfer(struct libusb_transfer* transfer);
}

namespace {

struct Cost {
    int allocations = 0, locks = 0, waits = 0, transfers = 0;
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
int libusb_submit_transfer(libusb_transfer* transfer) {
    static const auto submit = next(&libusb_submit_transfer, "libusb_submit_transfer");
    if (counts()) ++cost.transfers;
    return submit(transfer);
}
}

namespace test_falcon_exchange {

using namespace tactum;
using namespace tactum::test;

class TestFalconExchange : public QObject {
    Q_OBJECT

private slots:
    /// libusb's own for each transfer that is handed to it again, and the more of these the later the
    /// exchange comes: what grew beside them would not be bounded. Nobody else holds the locks.
    void allocatesAndLocksWithItsTransfers() {
        FalconBench bench;
        const auto falcon = bench.opened();
        QVERIFY(falcon);
        exchange(*falcon, 200);
        constexpr int kExchanges = 2000;
        constexpr int kLocks = 9; // of a transfer, and of an exchange with none
        Cost sum;
        int valid = 0;
        for (int i = 0; i < kExchanges; ++i) {
            cost = {};
            counting = true;
            valid += falcon->exchange({{0.1, 0, 0.1}}, 1e-3).valid;
            counting = false;
            QCOMPARE_LE(cost.allocations, cost.transfers);
            QCOMPARE_LE(cost.locks, kLocks * (cost.transfers + 1));
            QCOMPARE_LE(cost.bytes, std::size_t(4096));
            QCOMPARE(cost.waits, 0);
            sum.allocations += cost.allocations;
            sum.transfers += cost.transfers;
            sum.locks += cost.locks;
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        qInfo("an exchange: %.2f transfers, %.2f allocations, %.1f locks", double(sum.transfers) / kExchanges,
              double(sum.allocations) / kExchanges, double(sum.locks) / kExchanges);
        QCOMPARE_GT(valid, kExchanges / 2);
        QCOMPARE_GT(sum.allocations, 0); // they are counted at all
        QCOMPARE_GT(sum.locks, 0);
        QCOMPARE_LE(sum.transfers, 8 * kExchanges); // as a rule
    }
};

TACTUM_TEST(TestFalconExchange)

} // namespace test_falcon_exchange

#include "test_falcon_exchange.moc"
