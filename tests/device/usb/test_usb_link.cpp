// The link against devices that answer and that do not, at moments that only the interposed bus knows: the
// real libusb. What holds on any bus is in test_usb_both_ways.cpp.
#include <atomic>
#include <cstdlib>
#include <new>

#include <QTest>

#include "device/usb/usb_link.h"
#include "tests/device/usb/counter_device.h"
#include "tests/device/usb/emulated_kernel.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace {

std::atomic<int> ownAllocations{0};
thread_local bool counting = false;

} // namespace

// Our code allocates by `new`, libusb by malloc; what the emulated bus does is nobody's fault.
void* operator new(std::size_t size) {
    if (counting && !tactum::test::kernel::isInside()) ++ownAllocations;
    if (void* memory = std::malloc(size ? size : 1)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace test_usb_link {

using namespace tactum;
using namespace tactum::test;

class TestUsbLink : public QObject {
    Q_OBJECT

private slots:
    void cleanup() {
        EmulatedBus::the().unplugAll();
        QVERIFY(isClean());
    }

    void findsNothingElse() {
        plugCounter();
        QCOMPARE(places().size(), 1u);
        const UsbId other[] = {{0x0403, 0xcb48}};
        QVERIFY(listUsb(other).value().empty());
    }

    void saysWhyItDoesNotOpen() {
        plugCounter();
        const UsbPlace place = places().at(0);
        EmulatedBus::the().setForbidden(kSocket, true);
        const auto forbidden = UsbLink::open(place, {});
        QVERIFY(!forbidden);
        COMPARE_CONTAINS(forbidden.error().text, "70-tactum.rules");
        COMPARE_CONTAINS(forbidden.error().text, "1-3");
        EmulatedBus::the().setForbidden(kSocket, false);
        const auto first = UsbLink::open(place, {});
        QVERIFY(first.has_value());
        const auto second = UsbLink::open(place, {});
        QVERIFY(!second);
        COMPARE_CONTAINS(second.error().text, "another program");
        plugCounter(); // another one in the same socket
        const auto late = UsbLink::open(place, {});
        QVERIFY(!late);
        COMPARE_CONTAINS(late.error().text, "not there");
    }

    void aRequestThatStallsIsOneThatFailed() {
        plugCounter();
        const auto link = open().value();
        UsbFaults faults;
        faults.stallControl = true;
        setFaults(faults);
        QVERIFY(!link->request(7, 6, 0));
        setFaults({});
        QVERIFY(link->request(7, 7, 0).has_value());
    }

    void readsAndWritesThatFail() {
        const auto device = plugCounter();
        const auto link = open().value();
        UsbFaults faults;
        faults.mute = true;
        setFaults(faults);
        QVERIFY(link->read(5).value().empty());
        const auto mute = link->write(kHello, 5);
        QVERIFY(!mute);
        COMPARE_CONTAINS(mute.error().text, "power");
        faults = {};
        faults.stallIn = faults.stallOut = true;
        setFaults(faults);
        QVERIFY(!link->read());
        QVERIFY(!link->write(kHello));
        setFaults({}); // the halts were cleared
        QVERIFY(link->write(kHello).has_value());
        device->left = 1;
        QCOMPARE(link->read().value().size(), 8u);
        device->left = 1;
        device->length = 65; // more than its packets hold
        QVERIFY(!link->read());
        device->length = 8;
        device->left = 1;
        QCOMPARE(link->read().value().size(), 8u);
        QVERIFY(link->write(kHello).has_value());
        EmulatedBus::the().unplug(kSocket);
        QVERIFY(!link->write(kHello));
        QVERIFY(link->gone());
    }

    void streamsEveryPacketInOrder() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        int expected = 0;
        for (int round = 0; round < 20'000; ++round) {
            device->left += round % 4;
            QVERIFY(link->send(kHello));
            link->poll();
            for (auto packet = link->take(); !packet.empty(); packet = link->take()) {
                QCOMPARE(packet.size(), 8u);
                QCOMPARE(numberIn(packet), ++expected & 0xffff);
            }
        }
        QCOMPARE(expected, device->said);
        QCOMPARE(link->failures(), 0);
        QCOMPARE(device->commands->load(), 20'000);
    }

    void allocatesNothingOfItsOwn() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        ownAllocations = 0;
        counting = true;
        for (int round = 0; round < 1000; ++round) {
            device->left = 2;
            link->send(kHello);
            link->poll();
            while (!link->take().empty()) {
            }
        }
        counting = false;
        QCOMPARE(ownAllocations.load(), 0);
        counting = true;
        ::operator delete(::operator new(4));
        counting = false;
        QCOMPARE(ownAllocations.load(), 1); // it would have noticed
    }

    void keepsTheNewestPacketsForWhoDoesNotTakeThem() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        for (int round = 0; round < 100; ++round) {
            device->left = 3;
            link->poll();
        }
        int last = 0, count = 0;
        for (auto packet = link->take(); !packet.empty(); packet = link->take(), ++count)
            last = numberIn(packet);
        QCOMPARE(count, 64);
        QCOMPARE(last, device->said);
    }

    void aSecondSendWaitsForTheFirst() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        UsbFaults faults;
        faults.delay = 2'000'000;
        setFaults(faults);
        QVERIFY(link->send(kHello));
        QVERIFY(!link->send(kHello));
        QCOMPARE(link->failures(), 0);
        setFaults({});
        QVERIFY(pollUntil(*link, [&] { return device->commands->load() == 1; }));
        link->poll();
        QVERIFY(link->send(kHello));
    }

    void babbleIsAFailureAndNoPacket() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        device->length = 80;
        device->left = 1;
        link->poll();
        QCOMPARE(link->failures(), 1);
        QVERIFY(link->take().empty());
        device->length = 8;
        device->left = 1;
        link->poll();
        link->poll();
        QCOMPARE(link->failures(), 0);
        QCOMPARE(numberIn(link->take()), 2);
        QVERIFY(!link->gone());
    }

    void goesOnAfterAStall() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        UsbFaults faults;
        faults.stallIn = faults.stallOut = true;
        setFaults(faults);
        device->left = 1;
        link->send(kHello);
        link->poll();
        QCOMPARE(link->failures(), 1); // the reads that were cancelled for it are no failures
        setFaults({});                 // but its endpoints stay halted until they are cleared
        link->poll();
        link->poll();
        QVERIFY(!link->take().empty());
        QVERIFY(link->send(kHello));
        link->poll();
        QCOMPARE(device->heard, kHello);
        QCOMPARE(link->failures(), 0);
    }

    void silenceIsNoFailureButAnUnheardCommandIs() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        for (int i = 0; i < 100; ++i) {
            QVERIFY(link->send(kHello));
            link->poll();
        }
        QCOMPARE(link->failures(), 0);
        UsbFaults faults;
        faults.mute = true;
        setFaults(faults);
        QVERIFY(pollUntil(*link, [&] {
            link->send(kHello);
            return link->failures() >= 3;
        }));
        QVERIFY(!link->gone());
        setFaults({});
        device->left = 1;
        QVERIFY(pollUntil(*link, [&] { return link->send(kHello) && link->failures() == 0; }));
    }

    void submitsThatFailAreTriedAgain() {
        const auto device = plugCounter();
        const auto link = open().value();
        UsbFaults faults;
        faults.failSubmits = 3;
        setFaults(faults);
        VERIFY_RESULT(link->startStream());
        QCOMPARE(link->failures(), 3);
        faults.failSubmits = 1;
        setFaults(faults);
        QVERIFY(!link->send(kHello));
        device->left = 1;
        link->poll();
        link->poll();
        QCOMPARE(numberIn(link->take()), 1);
        QVERIFY(link->send(kHello));
    }

    void aFewBrokenTransfersAreNoUnplugging() {
        const auto device = plugCounter();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        UsbFaults faults;
        faults.errors = 20;
        setFaults(faults);
        for (int i = 0; i < 10; ++i)
            link->poll();
        QCOMPARE_GE(link->failures(), 20);
        QVERIFY(!link->gone());
        device->left = 1;
        link->poll();
        QCOMPARE(link->failures(), 0);
        faults.errors = 1000;
        setFaults(faults);
        for (int i = 0; i < 20; ++i)
            link->poll();
        QVERIFY(link->gone());
    }

    void streamsStopAndStartAgain() {
        const auto device = plugCounter();
        const auto link = open().value();
        for (int reads : {1, 3, 5}) {
            VERIFY_RESULT(link->startStream(reads));
            QCOMPARE(EmulatedBus::the().pendingTransfers(), std::max(reads, 1));
            device->left = 1;
            link->poll();
            QCOMPARE(numberIn(link->take()), device->said);
            link->stopStream();
            QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
            QVERIFY(!link->send(kHello));
            QVERIFY(link->write(kHello).has_value());
        }
    }
};

TACTUM_TEST(TestUsbLink)

} // namespace test_usb_link

#include "test_usb_link.moc"
