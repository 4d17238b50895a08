// The Falcon's packets: every number, the examples that are known, and a stream with everything wrong in it.
#include <random>
#include <string>
#include <string_view>

#include <QTest>

#include "device/falcon/falcon_packet.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_packet {

using namespace tactum;

namespace {

FalconPacket packetOf(std::string_view text) {
    FalconPacket packet{};
    std::copy(text.begin(), text.end(), packet.begin());
    return packet;
}
std::string textOf(const FalconPacket& packet) {
    return {packet.begin(), packet.end()};
}

/// A number in the device's letters, by arithmetic instead of bits.
std::string letters(int value) {
    int rest = value < 0 ? value + 65536 : value;
    std::string text;
    for (int i = 0; i < 4; ++i, rest /= 16)
        text += char('A' + rest % 16);
    return text;
}

std::string reportText(const FalconReport& report) {
    std::string text = "<";
    for (const int count : report.counts)
        text += letters(count);
    return text + char('A' + report.buttons + 16 * report.homed) + "A>";
}

struct Source {
    explicit Source(unsigned seed) : random(seed) {}
    int below(int limit) { return int(random() % unsigned(limit)); }
    FalconReport report() {
        FalconReport made{.buttons = std::uint8_t(below(16)), .homed = std::uint8_t(below(8))};
        for (auto& count : made.counts)
            count = std::int16_t(below(65536) - 32768);
        return made;
    }
    std::mt19937 random;
};

std::vector<FalconReport> reportsIn(std::string_view bytes, FalconStream& stream) {
    std::vector<FalconReport> found;
    for (const char byte : bytes)
        if (const auto report = stream(std::uint8_t(byte))) found.push_back(*report);
    return found;
}
std::vector<FalconReport> reportsIn(std::string_view bytes) {
    FalconStream stream;
    return reportsIn(bytes, stream);
}

} // namespace

class TestFalconPacket : public QObject {
    Q_OBJECT

private slots:
    void numbersThatAreKnown_data() {
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("text");
        const std::pair<int, const char*> known[] = {
            {0, "AAAA"},    {1, "BAAA"},     {-1, "PPPP"},    {1447, "HKFA"},   {-1447, "JFKP"},
            {4095, "PPPA"}, {-4095, "BAAP"}, {32767, "PPPH"}, {-32768, "AAAI"},
        };
        for (const auto& [value, text] : known)
            QTest::addRow("%d", value) << value << text;
    }
    void numbersThatAreKnown() {
        QFETCH(int, value);
        QFETCH(QString, text);
        const FalconCommand command{.motors = {0, std::int16_t(value), 0}, .homing = false};
        QCOMPARE(textOf(encodeCommand(command)), "<AAAA" + text.toStdString() + "AAAAAA>");
        const auto report = decodeReport(packetOf("<AAAAAAAA" + text.toStdString() + "AA>"));
        QVERIFY(report);
        QCOMPARE(int(report->counts[2]), value);
    }

    void commandsThatAreKnown() {
        QCOMPARE(textOf(encodeCommand({.homing = false})), std::string("<AAAAAAAAAAAAAA>"));
        QCOMPARE(
            textOf(encodeCommand({.motors = {661, 731, 766}, .homing = false, .light = FalconLight::Blue})),
            std::string("<FJCALNCAOPCAEA>"));
        QCOMPARE(textOf(encodeCommand({.light = FalconLight::Red})), std::string("<AAAAAAAAAAAAJA>"));
        QCOMPARE(textOf(encodeCommand({.light = FalconLight::Green})), std::string("<AAAAAAAAAAAADA>"));
    }

    void everyNumberOfEveryLegThereAndBack() {
        for (std::size_t leg = 0; leg < 3; ++leg)
            for (int value = -32768; value <= 32767; ++value) {
                FalconCommand command{.homing = false};
                command.motors[leg] = std::int16_t(value);
                const FalconPacket packet = encodeCommand(command);
                QCOMPARE(textOf(packet).substr(1 + 4 * leg, 4), letters(value));
                const auto report = decodeReport(packet);
                QVERIFY(report);
                QVERIFY(report->counts == command.motors);
            }
    }

    void flagsOfAReport() {
        const auto ready = decodeReport(packetOf("<AAAAAAAAAAAA\xb1"
                                                 "A>"));
        QVERIFY(ready);
        QCOMPARE_EQ(ready->homed, FalconReport::kAllHomed);
        QCOMPARE_EQ(ready->buttons, 0);
        for (int flags = 0; flags < 128; ++flags) {
            FalconPacket packet = packetOf("<AAAAAAAAAAAAAA>");
            packet[13] = std::uint8_t(0x41 + flags);
            const auto report = decodeReport(packet);
            QVERIFY(report);
            QCOMPARE(int(report->buttons), flags % 16);
            QCOMPARE(int(report->homed), flags / 16);
        }
    }

    void whatIsNoReport() {
        const FalconPacket good = packetOf("<BCDEFGHIJKLMAA>");
        QVERIFY(decodeReport(good));
        for (std::size_t at = 0; at < kFalconPacket; ++at)
            for (int byte = 0; byte < 256; ++byte) {
                FalconPacket bad = good;
                bad[at] = std::uint8_t(byte);
                const bool letter = byte >= 'A' && byte <= 'P', bracket = byte == '<' || byte == '>';
                const bool allowed = at == 0    ? byte == '<'
                                     : at == 15 ? byte == '>'
                                     : at == 14 ? !bracket
                                     : at == 13 ? byte >= 0x41 && byte <= 0xc0
                                                : letter;
                QCOMPARE(decodeReport(bad).has_value(), allowed);
            }
    }

    void theChipsOwnBytesAreTakenAway() {
        const std::uint8_t packet[] = {1, 0x60, '<', 'A'};
        QCOMPARE(falconPayload(packet).size(), std::size_t(2));
        QCOMPARE(int(falconPayload(packet)[0]), int('<'));
        QVERIFY(falconPayload(std::span(packet, 2)).empty());
        QVERIFY(falconPayload(std::span(packet, 1)).empty());
        QVERIFY(falconPayload({}).empty());
    }

    void aLostByteCostsOneReport() {
        Source source(1);
        for (std::size_t lost = 0; lost < kFalconPacket; ++lost) {
            const FalconReport before = source.report(), broken = source.report(), after = source.report();
            std::string bytes = reportText(broken);
            bytes.erase(lost, 1);
            QCOMPARE(reportsIn(reportText(before) + bytes + reportText(after)),
                     (std::vector<FalconReport>{before, after}));
        }
    }

    void anAddedByteCostsOneReportAtMost() {
        Source source(2);
        for (std::size_t at = 0; at <= kFalconPacket; ++at)
            for (int byte = 0; byte < 256; ++byte) {
                const FalconReport before = source.report(), broken = source.report(),
                                   after = source.report();
                std::string bytes = reportText(broken);
                bytes.insert(at, 1, char(byte));
                const auto found = reportsIn(reportText(before) + bytes + reportText(after));
                QCOMPARE_GE(found.size(), 2);
                QCOMPARE_LE(found.size(), 3);
                QVERIFY(found.front() == before);
                QVERIFY(found.back() == after);
            }
    }

    /// Whatever comes between reports, each that is whole is found and nothing else is made up: junk here has
    /// no bracket that could begin a report of its own.
    void reportsAreFoundAmongJunk() {
        for (unsigned seed = 0; seed < 2000; ++seed) {
            Source source(seed);
            std::string bytes;
            std::vector<FalconReport> sent;
            for (int i = 0; i < 20; ++i) {
                for (int junk = source.below(8); junk > 0; --junk)
                    if (const int byte = source.below(256); byte != '<') bytes += char(byte);
                if (source.below(3) == 0)
                    bytes += reportText(source.report()).substr(0, 1 + source.below(12));
                sent.push_back(source.report());
                bytes += reportText(sent.back());
            }
            QCOMPARE(reportsIn(bytes), sent);
        }
    }

    /// Of bytes that are nearly right nothing is reported but what stands there, letter by letter, whole.
    void nothingIsReportedThatDoesNotStandThere() {
        constexpr std::string_view kLikely = "<<>AABPPQ@";
        int found = 0;
        for (unsigned seed = 0; seed < 300; ++seed) {
            Source source(seed);
            FalconStream stream;
            std::string bytes;
            for (int i = 0; i < 3000; ++i) {
                if (source.below(20) == 0) {
                    std::string text = reportText(source.report());
                    if (source.below(2)) text[std::size_t(source.below(16))] = char(source.below(256));
                    if (source.below(4) == 0) text.erase(std::size_t(source.below(16)), 1);
                    bytes += text;
                }
                bytes += kLikely[std::size_t(source.below(int(kLikely.size())))];
            }
            for (std::size_t i = 0; i < bytes.size(); ++i) {
                const auto report = stream(std::uint8_t(bytes[i]));
                if (!report) continue;
                ++found;
                QCOMPARE_GE(i, 15);
                const std::string window = bytes.substr(i - 15, 16);
                std::string expected = reportText(*report);
                expected[14] = window[14];
                QCOMPARE(window, expected);
            }
            QCOMPARE_LT(stream.dropped(), bytes.size());
        }
        QCOMPARE_GT(found, 10'000);
    }

    void aRestartForgetsWhatWasBegun() {
        FalconStream stream;
        QVERIFY(reportsIn("<BBBBBBBB", stream).empty());
        stream.restart();
        QVERIFY(reportsIn("BBBBAA>", stream).empty());
        QCOMPARE(reportsIn("<CAAAAAAAAAAAAA>", stream).size(), std::size_t(1));
    }
};

TACTUM_TEST(TestFalconPacket)

} // namespace test_falcon_packet

#include "test_falcon_packet.moc"
