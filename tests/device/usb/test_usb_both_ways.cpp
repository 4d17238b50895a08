// What has to hold on any bus: the real libusb and the link over both back ends of the emulated one. Nothing
// here counts on when something happens, only on that it does.
#include <deque>
#include <random>
#include <thread>

#include <QElapsedTimer>
#include <QTest>
#include <libusb.h>

#include "tests/device/usb/counter_device.h"
#include "tests/device/usb/emulated_kernel.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_usb_both_ways {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Says every packet back, with other bytes.
class Echo final : public EmulatedUsbDevice {
public:
    explicit Echo(bool interrupt = false) : interrupt_(interrupt) {}

    static Bytes answer(Bytes packet) {
        for (auto& byte : packet)
            byte = static_cast<std::uint8_t>(~byte);
        return packet;
    }

    UsbDescription describe() const override {
        UsbDescription about{kId.vendor, kId.product, 0x0203, "Tactum", "Echo"};
        about.interrupt = interrupt_;
        if (interrupt_) about.interfaceClass = 3;
        return about;
    }
    std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data,
                                 std::int64_t) override {
        if (setup.request != 7) return std::nullopt;
        told = {setup.value, setup.index};
        written.assign(data.begin(), data.end());
        return Bytes{3, 1, 4, 1, 5};
    }
    void out(std::span<const std::uint8_t> bytes, std::int64_t) override {
        heard.emplace_back(bytes.begin(), bytes.end());
        if (answers) toSay.push_back(answer(heard.back()));
    }
    std::optional<Bytes> in(std::int64_t) override {
        if (toSay.empty()) return std::nullopt;
        Bytes packet = std::move(toSay.front());
        toSay.pop_front();
        return packet;
    }
    std::int64_t nextIn(std::int64_t now) const override { return now + 1'000'000; }

    // Only inside().
    std::pair<int, int> told;
    Bytes written;
    std::vector<Bytes> heard;
    std::deque<Bytes> toSay;
    bool answers = true;

private:
    bool interrupt_;
};

std::shared_ptr<Echo> plugEcho(bool interrupt = false) {
    auto device = std::make_shared<Echo>(interrupt);
    EmulatedBus::the().plug(kSocket, device);
    return device;
}

/// The device is asked by another thread than the test's.
template <class Look> auto inside(Look look) {
    const kernel::Inside locked;
    return look();
}

Bytes randomPacket(std::mt19937& random) {
    Bytes packet(1 + random() % 64);
    for (auto& byte : packet)
        byte = static_cast<std::uint8_t>(random());
    return packet;
}

/// The next packet; empty when none came for a long time.
Bytes nextPacket(UsbLink& link) {
    QElapsedTimer patience;
    patience.start();
    while (!patience.hasExpired(20'000) && !link.gone()) {
        link.poll();
        if (const auto packet = link.take(); !packet.empty()) return {packet.begin(), packet.end()};
    }
    return {};
}

/// Whether a packet went there and its answer came back.
bool isEchoed(UsbLink& link, const Bytes& packet) {
    return pollUntil(link, [&] { return link.send(packet); }) && nextPacket(link) == Echo::answer(packet);
}

/// All reads that were complete have been fetched and begun again.
bool allFetched(int reads) {
    return EmulatedBus::the().pendingTransfers() == reads;
}

using Handle = std::unique_ptr<libusb_device_handle, decltype(&libusb_close)>;

/// Null when it does not open.
Handle opened(libusb_device* device) {
    libusb_device_handle* handle = nullptr;
    libusb_open(device, &handle);
    return {handle, &libusb_close};
}

std::string textOf(libusb_device_handle* device, std::uint8_t number) {
    unsigned char text[64] = {};
    const int length = libusb_get_string_descriptor_ascii(device, number, text, sizeof text);
    return std::string(text, text + std::max(length, 0));
}

/// By libusb itself, for what the link has no use for.
template <class Visit> int visitDevices(Visit visit) {
    libusb_context* context = nullptr;
    if (libusb_init(&context) != 0) return -1;
    libusb_device** devices = nullptr;
    const auto count = libusb_get_device_list(context, &devices);
    for (auto i = decltype(count){0}; i < count; ++i)
        visit(devices[i]);
    libusb_free_device_list(devices, 1);
    libusb_exit(context);
    return static_cast<int>(count);
}

} // namespace

class TestUsbBothWays : public QObject {
    Q_OBJECT

private slots:
    void cleanup() {
        EmulatedBus::the().unplugAll();
        QTRY_VERIFY(isClean());
    }

    // ---- Found and opened.

    void findsWhatIsPluggedIn() {
        QVERIFY(places().empty());
        plugEcho();
        QCOMPARE(places().size(), 1u);
        QCOMPARE(places()[0].port, std::string("1-3"));
        QVERIFY(places()[0].id == kId);
        const int address = places()[0].address;
        plugEcho();
        QCOMPARE(places().size(), 1u);
        QCOMPARE_NE(places()[0].address, address);
        EmulatedBus::the().unplug(kSocket);
        QVERIFY(places().empty());
    }

    void readsWhatItSaysOfItself() {
        plugEcho();
        const int count = visitDevices([](libusb_device* device) {
            libusb_device_descriptor about{};
            QCOMPARE(libusb_get_device_descriptor(device, &about), 0);
            QCOMPARE(about.idVendor, kId.vendor);
            QCOMPARE(about.idProduct, kId.product);
            QCOMPARE(int(about.bcdDevice), 0x0203);
            QCOMPARE(libusb_get_max_packet_size(device, 0x81), 64);
            const Handle handle = opened(device);
            QVERIFY(handle);
            QCOMPARE(textOf(handle.get(), about.iManufacturer), std::string("Tactum"));
            QCOMPARE(textOf(handle.get(), about.iProduct), std::string("Echo"));
        });
        QCOMPARE(count, 1);
    }

    void opensForOneAtATime() {
        plugEcho();
        auto first = open();
        QVERIFY(first.has_value());
        const auto second = open();
        QVERIFY(!second);
        COMPARE_CONTAINS(second.error().text, "another program");
        first->reset();
        QTRY_VERIFY(open().has_value());
    }

    void doesNotOpenWhatIsGone() {
        plugEcho();
        const UsbPlace place = places().at(0);
        EmulatedBus::the().unplug(kSocket);
        const auto late = UsbLink::open(place, {});
        QVERIFY(!late);
        COMPARE_CONTAINS(late.error().text, "not there");
    }

    void takesTheDeviceFromTheKernelAndGivesItBack() {
        plugEcho(true);
        QVERIFY(EmulatedBus::the().kernelDriverHolds(kSocket));
        {
            const auto link = open(true);
            QVERIFY(link.has_value());
            QVERIFY(!EmulatedBus::the().kernelDriverHolds(kSocket));
        }
        QVERIFY(EmulatedBus::the().kernelDriverHolds(kSocket));
    }

    // ---- One transfer.

    void requestsAndTheirRefusal() {
        const auto device = plugEcho();
        const auto link = open().value();
        QVERIFY(link->request(7, 0x1234, 0x5678).has_value());
        QCOMPARE_EQ(inside([&] { return device->told; }), std::pair(0x1234, 0x5678));
        QVERIFY(!link->request(8, 1, 0)); // one that it does not know
        QVERIFY(link->request(7, 5, 6).has_value());
        QCOMPARE_EQ(inside([&] { return device->told; }), std::pair(5, 6));
    }

    void requestsWithData() {
        const auto device = plugEcho();
        const int count = visitDevices([&](libusb_device* there) {
            const Handle handle = opened(there);
            QVERIFY(handle);
            Bytes bytes = kHello;
            const auto size = static_cast<std::uint16_t>(bytes.size());
            QCOMPARE(libusb_control_transfer(handle.get(), 0x40, 7, 0, 0, bytes.data(), size, 1000),
                     int(size));
            QCOMPARE(inside([&] { return device->written; }), kHello);
            Bytes answer(8, 9); // more room than what it has to say
            QCOMPARE(libusb_control_transfer(handle.get(), 0xc0, 7, 0, 0, answer.data(), 8, 1000), 5);
            QCOMPARE(answer, (Bytes{3, 1, 4, 1, 5, 9, 9, 9}));
        });
        QCOMPARE(count, 1);
    }

    void writesAndReads_data() {
        QTest::addColumn<bool>("interrupt");
        QTest::newRow("bulk") << false;
        QTest::newRow("interrupt") << true;
    }
    void writesAndReads() {
        QFETCH(bool, interrupt);
        const auto device = plugEcho(interrupt);
        const auto link = open(interrupt).value();
        std::mt19937 random(5);
        for (int i = 0; i < 50; ++i) {
            const Bytes packet = randomPacket(random);
            QVERIFY(link->write(packet).has_value());
            QCOMPARE(inside([&] { return device->heard.back(); }), packet);
            QCOMPARE(link->read(1000).value(), Echo::answer(packet));
        }
        QVERIFY(link->read(1).value().empty()); // it has nothing to say
    }

    void endsAStallBetweenTransfers() {
        plugEcho();
        const auto link = open().value();
        UsbFaults faults;
        faults.stallIn = faults.stallOut = true;
        setFaults(faults);
        QVERIFY(!link->read());
        QVERIFY(!link->write(kHello));
        setFaults({}); // the halts were cleared
        QVERIFY(link->write(kHello).has_value());
        QCOMPARE(link->read(1000).value(), Echo::answer(kHello));
    }

    // ---- The stream.

    /// Its figure of rounds is in docs/decisions/usb.md.
    void streamsEveryPacketBothWays() {
        const auto device = plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        std::mt19937 random(6);
        std::vector<Bytes> sent;
        QElapsedTimer time;
        time.start();
        for (int round = 0; round < 2000; ++round) {
            sent.push_back(randomPacket(random));
            while (!link->send(sent.back()) && !link->gone())
                link->poll();
            QCOMPARE(nextPacket(*link), Echo::answer(sent.back()));
        }
        qInfo("%.0f rounds of a command and its answer a second",
              2e6 / double(std::max(time.elapsed(), qint64{1})));
        QCOMPARE_EQ(inside([&] { return device->heard; }), sent);
        QVERIFY(link->take().empty());
        QCOMPARE(link->failures(), 0);
    }

    void streamsWhatComesUnasked() {
        const auto device = plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        std::mt19937 random(7);
        std::vector<Bytes> said;
        for (int i = 0; i < 60; ++i)
            said.push_back(randomPacket(random));
        inside([&] { device->toSay.assign(said.begin(), said.end()); });
        for (const Bytes& packet : said)
            QCOMPARE(nextPacket(*link), packet);
    }

    void shortPacketsAreTakenAsTheyAre() {
        const auto device = plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream(1));
        for (const std::size_t length : {2u, 63u, 64u, 1u, 16u}) {
            const Bytes packet(length, static_cast<std::uint8_t>(length));
            inside([&] { device->toSay.push_back(packet); });
            QCOMPARE(nextPacket(*link), packet);
        }
        inside([&] { device->toSay = {Bytes(80, 1), Bytes(8, 2)}; }); // more than its packets hold: babble
        QCOMPARE(nextPacket(*link), Bytes(8, 2));
    }

    void goesOnAfterAStall() {
        plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        QVERIFY(isEchoed(*link, kHello));
        UsbFaults faults;
        faults.stallIn = faults.stallOut = true;
        setFaults(faults);
        QVERIFY(pollUntil(*link, [&] {
            link->send(kHello);
            return link->failures() > 0;
        }));
        setFaults({}); // but its endpoints stay halted until they are cleared
        const Bytes bye{'b', 'y', 'e'};
        QVERIFY(isEchoed(*link, bye));
        QCOMPARE(link->failures(), 0);
        QVERIFY(!link->gone());
    }

    void streamsStopAndStartAgain() {
        const auto device = plugEcho();
        const auto link = open().value();
        for (int reads : {1, 3, 5}) {
            VERIFY_RESULT(link->startStream(reads));
            QVERIFY(isEchoed(*link, kHello));
            link->stopStream();
            QCOMPARE(EmulatedBus::the().pendingTransfers(), 0);
            QVERIFY(!link->send(kHello));
            QVERIFY(link->write(kHello).has_value());
            QCOMPARE(link->read(1000).value(), Echo::answer(kHello));
        }
    }

    void sendsNowBesideTheStream() {
        const auto device = plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        const Bytes stop{'<', '0'};
        link->sendNow(stop);
        QCOMPARE(inside([&] { return device->heard.back(); }), stop);
        QCOMPARE(nextPacket(*link), Echo::answer(stop));
        QVERIFY(isEchoed(*link, kHello));
    }

    // ---- Pulled out, and plugged in again.

    void givesOutNothingOfADeviceThatIsGone() {
        const auto device = plugEcho();
        const auto link = open().value();
        VERIFY_RESULT(link->startStream());
        QVERIFY(isEchoed(*link, kHello));
        inside([&] { device->toSay.assign(3, kHello); });
        QVERIFY(
            pollUntil(*link, [&] { return inside([&] { return device->toSay.empty(); }) && allFetched(3); }));
        EmulatedBus::the().unplug(kSocket);
        QVERIFY(pollUntil(*link, [&] { return link->gone(); }));
        QVERIFY(link->take().empty());
        QVERIFY(!link->send(kHello));
        link->sendNow(kHello);
        link->poll();
        QVERIFY(link->take().empty());
        QCOMPARE(inside([&] { return device->heard.size(); }), 1u);
    }

    void isOpenedAnewWhenPluggedInAgain() {
        const auto device = plugEcho();
        auto link = open().value();
        for (int times = 0; times < 5; ++times) {
            VERIFY_RESULT(link->startStream());
            QVERIFY(isEchoed(*link, kHello));
            EmulatedBus::the().unplug(kSocket);
            QVERIFY(pollUntil(*link, [&] { return link->gone(); }));
            inside([&] { device->toSay.clear(); });
            EmulatedBus::the().plug(kSocket, device);
            QVERIFY(link->gone()); // this one for ever
            link = open().value();
        }
    }

    void noticesItWhileAnotherThreadPulls() {
        std::mt19937 random(8);
        for (int i = 0; i < 20; ++i) {
            plugEcho();
            const auto link = open().value();
            VERIFY_RESULT(link->startStream());
            const auto after = std::chrono::microseconds(random() % 5000);
            const std::jthread person([after] {
                std::this_thread::sleep_for(after);
                EmulatedBus::the().unplug(kSocket);
            });
            QVERIFY(pollUntil(*link, [&] {
                link->send(kHello);
                return link->gone();
            }));
            QVERIFY(link->take().empty());
        }
    }
};

TACTUM_TEST(TestUsbBothWays)

} // namespace test_usb_both_ways

#include "test_usb_both_ways.moc"
