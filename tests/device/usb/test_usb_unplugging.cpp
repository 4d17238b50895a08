// The link when the device is pulled out or the program dies, at any moment: the real libusb on an emulated
// bus.
#include <atomic>
#include <random>
#include <thread>

#include <QTest>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/device/usb/counter_device.h"
#include "tests/device/usb/emulated_kernel.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_usb_unplugging {

using namespace tactum;
using namespace tactum::test;

class TestUsbUnplugging : public QObject {
    Q_OBJECT

private slots:
    void cleanup() {
        EmulatedBus::the().unplugAll();
        QVERIFY(isClean());
    }

    void noticesTheUnpluggingAtTheNextPoll() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        device->left = 3;
        link->poll();
        EmulatedBus::the().unplug(kSocket);
        link->poll();
        QVERIFY(link->gone());
        QVERIFY(link->take().empty()); // not even what came before
        QVERIFY(!link->send(kHello));
        link->sendNow(kHello);
        link->poll();
        QVERIFY(link->take().empty());
    }

    void noticesItWhileAnotherThreadPulls() {
        for (int i = 0; i < 20; ++i) {
            const auto device = plugCounter();
            const auto link = open().value();
            VERIFY_RESULT(link->startStream());
            std::thread person([] { EmulatedBus::the().unplug(kSocket); });
            while (!link->gone()) {
                link->send(kHello);
                link->poll();
            }
            person.join();
            QVERIFY(link->take().empty());
        }
    }

    void noticesItWhenSendingToo() {
        plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        EmulatedBus::the().unplug(kSocket);
        QVERIFY(!link->send(kHello));
        QVERIFY(link->gone());
    }

    void leavesNothingBehindInAnyState() {
        // cleanup() looks at the bus.
        const auto device = plugCounter();
        open().value();
        const auto stream = [&](const UsbFaults& faults, int polls) {
            const auto link = open().value();
            VERIFY_RESULT(link->startStream());
            setFaults(faults);
            device->left = 5;
            for (int i = 0; i < polls; ++i) {
                link->send(kHello);
                link->poll();
            }
        };
        UsbFaults mute, delayed, stalled, failing, broken;
        mute.mute = true;
        delayed.delay = 50'000'000;
        stalled.stallIn = stalled.stallOut = true;
        failing.failSubmits = 1000;
        broken.errors = 1000;
        for (const UsbFaults& faults : {UsbFaults{}, mute, delayed, stalled, failing, broken})
            for (const int polls : {0, 1, 2, 20}) {
                stream(faults, polls);
                setFaults({});
                QVERIFY(isClean());
            }
    }

    void aThousandPluggings() {
        std::mt19937 random(20);
        const auto upTo = [&](int most) {
            return static_cast<int>(random() % static_cast<unsigned>(most + 1));
        };
        for (int cycle = 0; cycle < 1000; ++cycle) {
            const auto device = plugCounter(cycle % 2);
            device->left = upTo(10);
            std::unique_ptr<UsbLink> link;
            const int state = upTo(4);
            if (state > 0) link = open(cycle % 2).value();
            if (state > 1) VERIFY_RESULT(link->startStream(1 + upTo(3)));
            UsbFaults faults;
            faults.delay = upTo(1) * 1'000'000;
            faults.stallIn = upTo(9) == 0;
            faults.errors = upTo(4);
            setFaults(faults);
            for (int i = upTo(5); state > 2 && i > 0; --i) {
                link->send(kHello);
                link->poll();
                while (upTo(3) && !link->take().empty()) {
                }
            }
            if (upTo(1)) link.reset(); // before the unplugging, or after it
            EmulatedBus::the().unplug(kSocket);
            if (link && state > 1) {
                link->poll();
                QVERIFY(link->take().empty());
            }
            link.reset();
            QVERIFY2(isClean(), qPrintable(QString("cycle %1, state %2").arg(cycle).arg(state)));
        }
    }

    void sendsNowFromAForkedChild() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        link->send(kHello);
        link->poll();
        QCOMPARE(device->lastByte->load(), int('o'));
        const pid_t child = fork();
        if (child == 0) {
            const std::uint8_t stop[] = {'<', '0'};
            link->sendNow(stop);
            _exit(0);
        }
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
        QCOMPARE(device->lastByte->load(), int('0'));
        QVERIFY(link->send(kHello)); // and the stream goes on
        device->left = 1;
        link->poll();
        QCOMPARE(device->lastByte->load(), int('o'));
        QVERIFY(!link->take().empty());
    }

    void sendNowEndsWhenNobodyListens() {
        const auto device = plugCounter();
        const auto link = open().value();
        UsbFaults faults;
        faults.mute = true;
        setFaults(faults);
        errno = 17;
        link->sendNow(kHello);
        QCOMPARE(errno, 17);
        QCOMPARE(device->commands->load(), 0);
    }
};

TACTUM_TEST(TestUsbUnplugging)

} // namespace test_usb_unplugging

#include "test_usb_unplugging.moc"
