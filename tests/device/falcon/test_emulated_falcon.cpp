// The emulated Falcon by itself, byte by byte and without any driver: it is what the tests of the driver rest
// on.
#include <random>

#include <QTest>

#include "device/falcon/falcon_kinematics.h"
#include "tests/device/falcon/boot_stream.h"
#include "tests/device/falcon/emulated_falcon.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_emulated_falcon {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A host with a clock of its own.
struct Host {
    bool request(std::uint8_t number, int value) {
        return device.control({0x40, number, std::uint16_t(value), 0, 0}, {}, now).has_value();
    }
    void say(std::string_view text) { device.out(Bytes(text.begin(), text.end()), now); }
    /// All that comes within `ms`, without the chip's bytes.
    std::string hear(int ms) {
        std::string heard;
        for (const std::int64_t end = now + ms * kMs; now < end; now += 50'000)
            if (const auto packet = device.in(now)) {
                packets.push_back(*packet);
                heard.append(packet->begin() + 2, packet->end());
            }
        return heard;
    }
    void boot() {
        request(9, 16);
        request(3, 0x4138);
        request(1, 0x0100);
        request(1, 0x0101);
    }
    bool load(const Bytes& stream) {
        boot();
        say("\nC\r");
        if (hear(60) != "\nD,\r") return false;
        request(1, 0x0100);
        request(3, 0x0015);
        say("A");
        if (hear(60) != "A") return false;
        for (std::size_t at = 0; at < stream.size(); at += 62) {
            const Bytes block(stream.begin() + std::ptrdiff_t(at),
                              stream.begin() + std::ptrdiff_t(std::min(at + 62, stream.size())));
            device.out(block, now);
            const std::string echo = hear(30);
            if (!std::equal(echo.begin(), echo.end(), block.begin(), block.end(),
                            [](char a, std::uint8_t b) { return std::uint8_t(a) == b; }))
                return false;
        }
        return true;
    }
    void run() {
        request(9, 1);
        request(3, 2);
    }

    EmulatedFalcon device;
    std::int64_t now = 1000 * kMs;
    std::vector<Bytes> packets;
};

} // namespace

class TestEmulatedFalcon : public QObject {
    Q_OBJECT

private slots:
    void saysNothingButTheChipsBytesOnceInEachPeriod() {
        Host host;
        host.request(9, 16);
        host.hear(40);
        host.packets.clear();
        QCOMPARE(host.hear(161), std::string());
        QCOMPARE_GE(host.packets.size(), 10);
        QCOMPARE_LE(host.packets.size(), 11);
        for (const Bytes& packet : host.packets)
            QCOMPARE(packet, (Bytes{0x01, 0x60}));
        host.request(9, 1);
        host.hear(10);
        host.packets.clear();
        host.hear(100);
        QCOMPARE_GE(host.packets.size(), 95);
        QCOMPARE_LE(host.packets.size(), 101);
    }

    void refusesRequestsThatItDoesNotKnow() {
        Host host;
        for (const auto& [number, value] :
             {std::pair(0, 3), {2, 0x100}, {4, 7}, {5, 0}, {6, 0x013e}, {9, 0}, {11, 0}})
            QVERIFY(!host.request(std::uint8_t(number), value));
        const auto timer = host.device.control({0xc0, 10, 0, 0, 1}, {}, host.now);
        QVERIFY(timer);
        QCOMPARE_EQ(*timer, Bytes{16});
    }

    void answersTheCallAtTheRightRateOnly() {
        Host host;
        host.boot();
        host.request(3, 2);
        host.say("\nC\r");
        QCOMPARE(host.hear(60), std::string());
        host.request(3, 0x4138);
        host.say("\nC\r");
        QCOMPARE(host.hear(60), std::string("\nD,\r"));
    }

    void takesAProgramByItsOwnLength() {
        Host host;
        QVERIFY(host.load(makeBootStream()));
        QCOMPARE_EQ(host.device.state(), EmulatedFalcon::State::Running);
        QCOMPARE(host.device.uploads(), 1);
        host.request(1, 0x0101); // DTR rises
        QCOMPARE_EQ(host.device.state(), EmulatedFalcon::State::Boot);
        Bytes half = makeBootStream();
        half.resize(half.size() - 2);
        QVERIFY(host.load(half));
        QCOMPARE_EQ(host.device.state(), EmulatedFalcon::State::Loading);
    }

    void aFullPacketOfEchoesComesBeforeTheTimer() {
        Host host;
        host.load({});
        host.packets.clear();
        const std::int64_t begun = host.now;
        host.device.out(Bytes(62, 0x55), host.now);
        while (host.packets.empty() || host.packets.back().size() < 64)
            host.hear(1);
        QCOMPARE_LT(host.now - begun, 6 * kMs); // 62 bytes of 70 us
    }

    void sixteenForSixteen() {
        Host host;
        host.device.startFirmware(true);
        host.device.putGrip({0, 0, 0.134602 - 0.125});
        host.run();
        QCOMPARE(host.hear(20), std::string());
        host.say("<AAAAAAAAAAAA");
        QCOMPARE(host.hear(20), std::string());
        host.say("BA>");
        QCOMPARE(host.hear(3), std::string("<AAAAAAAAAAAA\xb1"
                                           "A>"));
        host.say("x<FJCALNCAOPCAEA><AAAAAAAAAAAABA>");
        QCOMPARE(host.hear(3).size(), std::size_t(32));
        QCOMPARE(host.device.commands(), 3);
        QCOMPARE(host.device.torqueCommands(), 1);
        QCOMPARE(host.device.malformed(), 1);
    }

    void anArmIsHomedByItsIndexMarks() {
        Host host;
        host.device.startFirmware(false);
        host.run();
        host.device.homeByHand();
        for (int i = 0; i < 1500; ++i) // without the bit nothing happens
            host.say("<AAAAAAAAAAAAAA>"), host.hear(1);
        QVERIFY(!host.device.homed());
        QVERIFY(host.device.gripArrived());
        host.device.homeByHand();
        for (int i = 0; i < 1500; ++i)
            host.say("<AAAAAAAAAAAABA>"), host.hear(1);
        QVERIFY(host.device.homed());
    }

    /// Two ways to the same arm.
    void itsArmIsTheOneThatTheDriverKnows() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> side(-0.03, 0.03);
        for (int i = 0; i < 5000; ++i) {
            const Vec3 p(side(random), side(random), side(random));
            const auto arm = falconArmAt(p);
            const Vec3 inBase = p + Vec3(0, 0, kFalconCentre);
            COMPARE_NEAR(legDegrees(inBase), arm->angles * 180 / 3.14159265358979323846, 1e-9, "degrees");
            const Vec3 torques = Vec3::Random();
            const Vec3 force = arm->jacobian.transpose() * torques;
            COMPARE_NEAR(forceAtGrip(inBase, torques), force, 1e-6 * force.norm(), "N");
        }
    }

    void theHandGivesWayLikeASpring() {
        FalconBody body;
        body.put({0, 0, 0.125});
        const auto arm = falconArmAt(Vec3::Zero());
        const Vec3 torques = arm->jacobian.transpose().inverse() * Vec3(1, 0, 2);
        for (int i = 0; i < 20'000; ++i)
            body.step(2e-4, torques);
        const Vec3 way = body.position() - Vec3(0, 0, 0.125);
        COMPARE_NEAR(way * body.hand.stiffness, forceAtGrip(body.position(), torques), 1e-3, "N");
        QCOMPARE_GT(way.z(), 0.005);
        QCOMPARE_LT(body.velocity().norm(), 1e-6);
    }
};

TACTUM_TEST(TestEmulatedFalcon)

} // namespace test_emulated_falcon

#include "test_emulated_falcon.moc"
