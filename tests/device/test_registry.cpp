// What devices are found, on an emulated bus, and what is said of those that cannot be used.
#include <QTest>

#include "device/listings_text.h"
#include "device/registry.h"
#include "device/remote/output_of.h"
#include "tests/device/usb/emulated_usb.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_registry {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Is there, and says nothing.
class Plugged : public EmulatedUsbDevice {
public:
    Plugged(std::uint16_t vendor, std::uint16_t product) : vendor_(vendor), product_(product) {}
    UsbDescription describe() const override {
        return {.vendor = vendor_, .product = product_, .maker = "", .name = ""};
    }
    std::optional<Bytes> control(const UsbSetup&, std::span<const std::uint8_t>, std::int64_t) override {
        return Bytes();
    }
    void out(std::span<const std::uint8_t>, std::int64_t) override {}
    std::optional<Bytes> in(std::int64_t) override { return {}; }
    std::int64_t nextIn(std::int64_t now) const override { return now + 1'000'000; }

private:
    std::uint16_t vendor_, product_;
};

DeviceRegistry registry() {
    return DeviceRegistry({.hand = {}, .profiles = {}, .program = {}});
}

const DeviceListing* named(const std::vector<DeviceListing>& listings, std::string_view name) {
    const auto found = std::ranges::find(listings, name, &DeviceListing::name);
    return found == listings.end() ? nullptr : &*found;
}

} // namespace

class TestRegistry : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { EmulatedBus::the().unplugAll(); }

    void theSimulatedHandIsAlwaysThere() {
        const auto listings = registry().list();
        QVERIFY(listings.front().usable);
        QCOMPARE(listings.front().id, std::string("simulated"));
        const auto hand = registry().make("simulated");
        VERIFY_RESULT(hand);
        QVERIFY(!(*hand)->info().real);
    }

    void withoutADeviceItSaysSo() {
        const auto listings = registry().list();
        const DeviceListing* const usb = named(listings, "USB");
        QVERIFY(usb);
        QVERIFY(!usb->usable);
        QVERIFY(usb->id.empty());
        QVERIFY(!usb->sentence.empty());
        // Of each maker's family one sentence that says what is missing.
        QCOMPARE(std::ranges::count(listings, true, &DeviceListing::usable), 2);
        for (const DeviceListing& listing : listings)
            QVERIFY2(!listing.sentence.empty() && listing.sentence.find('\n') == std::string::npos,
                     listing.name.c_str());
    }

    void driversOfOnesOwnAreListedAndMade() {
        qputenv("TACTUM_DRIVERS", "/nowhere");
        const auto without = registry().list();
        const DeviceListing* const none = named(without, "Drivers of your own");
        QVERIFY(none && !none->usable);
        QVERIFY2(none->sentence.find("/nowhere") != std::string::npos, none->sentence.c_str());
        qputenv("TACTUM_DRIVERS", TACTUM_DRIVERS_OF_THE_BENCH);
        qputenv("HAPLY_2DIY", "/dev/null"); // a port that is there
        const auto listings = registry().list();
        const DeviceListing* const found = named(listings, "Haply 2DIY");
        QVERIFY(found && found->usable);
        QCOMPARE(found->id, std::string("driver:haply_2diy:/dev/null"));
        const auto device = registry().make(found->id);
        VERIFY_RESULT(device);
        QCOMPARE((*device)->info().name, found->name);
        const auto opened = (*device)->open();
        QVERIFY(!opened); // /dev/null is no serial port
        QVERIFY2(opened.error().text.find("/dev/null") != std::string::npos, opened.error().text.c_str());
        qunsetenv("TACTUM_DRIVERS");
        qunsetenv("HAPLY_2DIY");
    }

    /// Where the bus cannot be asked too: its port is no USB device of ours.
    void aSerialPortIsFoundAndMade() {
        qputenv("TACTUM_POLHEM", "/dev/null"); // a port that is there
        const auto listings = registry().list();
        const DeviceListing* const found = named(listings, "Haptikfabriken Polhem");
        QVERIFY(found && found->usable);
        QVERIFY(!named(listings, "USB"));
        QCOMPARE(found->id, std::string("polhem:null"));
        const auto device = registry().make(found->id);
        VERIFY_RESULT(device);
        QCOMPARE((*device)->info().name, found->name);
        QCOMPARE((*device)->info().maxForce, 5.0);
        QVERIFY(!(*device)->open()); // /dev/null is no serial port
        qunsetenv("TACTUM_POLHEM");
        QVERIFY(!registry().make("polhem:null"));
    }

    void whatIsPluggedInIsFoundAndMade() {
        EmulatedBus::the().plug(1, std::make_shared<Plugged>(0x0403, 0x6001)); // some other serial adapter
        EmulatedBus::the().plug(2, std::make_shared<Plugged>(0x0403, 0xcb48));
        EmulatedBus::the().plug(3, std::make_shared<Plugged>(0x1234, 0x0006));
        const auto listings = registry().list();
        QVERIFY(!named(listings, "USB"));
        const DeviceListing* const falcon = named(listings, "Novint Falcon");
        const DeviceListing* const wooden = named(listings, "WoodenHaptics");
        QVERIFY(falcon);
        QVERIFY(falcon->usable);
        QVERIFY(wooden);
        QVERIFY(wooden->usable);
        QCOMPARE(falcon->id, std::string("falcon:1-2"));
        QCOMPARE(listings[1].id, falcon->id); // before all that cannot be used
        for (const DeviceListing* listing : {falcon, wooden}) {
            const auto device = registry().make(listing->id);
            VERIFY_RESULT(device);
            QVERIFY((*device)->info().real);
            QCOMPARE((*device)->info().name, listing->name);
            QVERIFY(!(*device)->steps().empty());
        }
        EmulatedBus::the().unplug(2);
        const auto gone = registry().make("falcon:1-2");
        QVERIFY(!gone);
        COMPARE_CONTAINS(gone.error().text, "not connected");
    }

    void whatDoesNotExistIsRefused() {
        for (const char* id : {"", "falcon", "falcon:", "falcon:9-9", "no such", "simulated:2"})
            QVERIFY2(!registry().make(id), id);
    }

    void listingsPassAsText() {
        const std::vector<DeviceListing> listings{{"a:1", "A \"name\"", true, "is there"},
                                                  {"", "B", false, "is not", true}};
        const auto back = listingsOf(toJson(listings));
        QVERIFY(back == listings);
        for (const char* nonsense : {"", "{}", "[7]", "[{\"id\": 1}]", "[[[[["})
            QVERIFY(listingsOf(nonsense).empty());
    }

    void anotherProcessIsHeardButNotWaitedFor() {
        QCOMPARE(outputOf("/bin/echo", {"two words"}, 5000), std::string("two words\n"));
        QVERIFY(outputOf("/bin/false", {}, 5000).empty());
        QVERIFY(outputOf("/no/such/program", {}, 5000).empty());
        QVERIFY(outputOf("/bin/sleep", {"100"}, 50).empty());
        QVERIFY(outputOf("/usr/bin/yes", {}, 5000).empty()); // more than anybody needs
    }

    /// A library that breaks the process that asks it breaks only that.
    void aProcessThatAsksTheMakersMayBreak() {
        DeviceRegistry apart({.hand = {}, .profiles = {}, .program = "/bin/false"});
        const auto listings = apart.list();
        for (const char* maker : {"OpenHaptics", "Force Dimension", "Haply"}) {
            const DeviceListing* const listing = named(listings, maker);
            QVERIFY(listing);
            QVERIFY(!listing->usable);
            COMPARE_CONTAINS(listing->sentence, "crashed");
        }
    }
};

TACTUM_TEST(TestRegistry)

} // namespace test_registry

#include "test_registry.moc"
