// Plain values as bytes of a fixed room and back: where each lies, and what stops a reader.
#include <cstring>
#include <limits>
#include <vector>

#include <QTest>

#include "core/base/byte_archive.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_byte_archive {

using namespace tactum;

namespace {

enum class Colour : std::uint8_t { Red = 7 };

struct Inner {
    std::int32_t a = 0;
    bool b = false;

    static void fields(auto& visit, MaybeConst<Inner> auto& value) { visit(value.a, value.b); }
};

struct Whole {
    double x = 0;
    Colour colour{};
    Vec3 v = Vec3::Zero();
    Pose pose;
    std::array<std::int16_t, 2> two{};
    Inner inner;

    static void fields(auto& visit, MaybeConst<Whole> auto& w) {
        visit(w.x, w.colour, w.v, w.pose, w.two, w.inner);
    }
};

Whole sample() {
    return {1.5, Colour::Red, {1, -2, 3}, {Quat(0.5, 0.5, -0.5, 0.5), {7, 8, 9}}, {-3, 300}, {-70000, true}};
}

template <class T> T at(std::span<const std::byte> bytes, std::size_t place) {
    T value;
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
}

template <class... T> std::vector<std::byte> written(const T&... values) {
    std::vector<std::byte> room(1000, std::byte(0xEE));
    ByteWriter writer(room);
    writer(values...);
    room.resize(writer.size());
    return room;
}

template <class... T> void put(ByteWriter& writer, const T&... values) {
    writer(values...);
}

} // namespace

class TestByteArchive : public QObject {
    Q_OBJECT

private slots:
    void valuesLieOneBehindTheOther() {
        const auto bytes = written(sample());
        QCOMPARE(bytes.size(), std::size_t(8 + 1 + 3 * 8 + 7 * 8 + 2 * 2 + 4 + 1));
        QCOMPARE(at<double>(bytes, 0), 1.5);
        QCOMPARE(int(bytes[8]), 7);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(at<double>(bytes, 9 + 8 * i), sample().v[Eigen::Index(i)]);
        const double turn[] = {0.5, -0.5, 0.5, 0.5, 7, 8, 9}; // x, y, z, w of the rotation first
        for (std::size_t i = 0; i < 7; ++i)
            QCOMPARE(at<double>(bytes, 33 + 8 * i), turn[i]);
        QCOMPARE(at<std::int16_t>(bytes, 89), -3);
        QCOMPARE(at<std::int16_t>(bytes, 91), 300);
        QCOMPARE(at<std::int32_t>(bytes, 93), -70000);
        QCOMPARE(int(bytes[97]), 1);
    }

    void whatIsReadIsWhatWasWritten() {
        const auto bytes = written(sample(), std::int64_t(-5));
        ByteReader reader(bytes, NotFinite::Refused);
        Whole w;
        std::int64_t last = 0;
        reader(w);
        QVERIFY(reader.good());
        QVERIFY(!reader.complete()); // the last one is still there
        reader(last);
        QVERIFY(reader.complete());
        QCOMPARE(last, -5);
        QCOMPARE(w.x, 1.5);
        QCOMPARE(w.colour, Colour::Red);
        QCOMPARE(w.v, sample().v);
        QCOMPARE(w.pose.rotation.coeffs(), sample().pose.rotation.coeffs());
        QCOMPARE(w.pose.translation, sample().pose.translation);
        QCOMPARE(w.two, sample().two);
        QCOMPARE(w.inner.a, -70000);
        QVERIFY(w.inner.b);
    }

    /// The room may be filled to the last byte; what comes behind it is never touched.
    void theRoomIsKept() {
        std::array<std::byte, 12> memory{};
        memory.fill(std::byte(0xEE));
        ByteWriter writer(std::span<std::byte>(memory).first(8));
        QCOMPARE(writer.size(), 0u);
        QVERIFY(writer.fits());
        put(writer, std::uint32_t(1), std::uint32_t(2));
        QCOMPARE(writer.size(), 8u);
        QVERIFY(writer.fits());
        put(writer, std::uint8_t(3));
        QCOMPARE(writer.size(), 9u); // what it would take
        QVERIFY(!writer.fits());
        QCOMPARE(at<std::uint32_t>(memory, 4), 2u);
        for (std::size_t i = 8; i < 12; ++i)
            QCOMPARE(int(memory[i]), 0xEE);
    }

    void whatHasNoRoomIsNotWrittenInPart() {
        std::array<std::byte, 8> memory{};
        ByteWriter writer(std::span<std::byte>(memory).first(6));
        put(writer, std::uint32_t(0xFFFFFFFF), std::uint32_t(0xFFFFFFFF));
        for (std::size_t i = 4; i < 8; ++i)
            QCOMPARE(int(memory[i]), 0);
        QVERIFY(!writer.fits());
    }

    void bytesThatEndTooEarlyStopEverything() {
        const auto bytes = written(std::uint32_t(1), std::uint32_t(2));
        for (std::size_t length = 0; length < 8; ++length) {
            ByteReader reader(std::span<const std::byte>(bytes).first(length), NotFinite::Refused);
            std::uint32_t a = 77, b = 78;
            std::uint8_t c = 79;
            reader(a, b, c);
            QVERIFY(!reader.good());
            QVERIFY(!reader.complete());
            QCOMPARE(a, length < 4 ? 77u : 1u);
            QCOMPARE(b, 78u);
            QCOMPARE(int(c), 79); // not even where a byte would be left for it
        }
    }

    void aSwitchIsOnOrOff() {
        for (int byte = 0; byte < 256; ++byte) {
            const std::byte bytes[] = {std::byte(byte)};
            ByteReader reader(bytes, NotFinite::Refused);
            bool value = byte != 1;
            reader(value);
            QCOMPARE(reader.good(), byte < 2);
            QCOMPARE(value, byte == 1 || byte > 1);
        }
    }

    void numbersAreFiniteWhereTheRuleSaysSo() {
        const double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinite = std::numeric_limits<double>::infinity();
        for (const double value : {1.0, -infinite, infinite, nan}) {
            const auto bytes = written(value);
            const bool finite = value == 1.0;
            double read = 77;
            ByteReader strict(bytes, NotFinite::Refused);
            strict(read);
            QCOMPARE(strict.good(), finite);
            QCOMPARE(read, finite ? 1.0 : 77.0);
            ByteReader lax(bytes, NotFinite::Allowed);
            lax(read);
            QVERIFY(lax.complete());
            QVERIFY(std::memcmp(&read, &value, sizeof value) == 0);
            read = 77;
            ByteReader unbounded(bytes, NotFinite::Refused);
            unbounded.unbounded(read);
            QCOMPARE(unbounded.complete(), !std::isnan(value));
            QCOMPARE(read, std::isnan(value) ? 77.0 : value);
        }
        ByteReader none({}, NotFinite::Refused);
        double read = 77;
        none.unbounded(read);
        QVERIFY(!none.good());
        QCOMPARE(read, 77.0);
    }

    void anUnboundedNumberIsWrittenAsItIs() {
        std::array<std::byte, 8> memory{};
        ByteWriter writer(memory);
        writer.unbounded(-std::numeric_limits<double>::infinity());
        QCOMPARE(writer.size(), 8u);
        QCOMPARE(at<double>(memory, 0), -std::numeric_limits<double>::infinity());
    }

    void anIndexIsBelowItsEnd() {
        for (int value = -2; value < 6; ++value) {
            std::array<std::byte, 4> memory{};
            ByteWriter writer(memory);
            writer.index(value, 4);
            QCOMPARE(writer.size(), 4u);
            ByteReader reader(memory, NotFinite::Refused);
            int read = 77;
            reader.index(read, 4);
            const bool right = value >= 0 && value < 4;
            QCOMPARE(reader.good(), right);
            QCOMPARE(read, right ? value : 77);
        }
    }

    void aListHasAsManyItemsAsItSays() {
        for (int count = -1; count <= 5; ++count) {
            const std::array<std::int16_t, 4> items{1, 2, 3, 4};
            std::array<std::byte, 32> memory{};
            ByteWriter writer(memory);
            if (count >= 0 && count <= 4)
                writer.counted(items, count);
            else
                put(writer, count, items, std::int16_t(5));
            if (count >= 0 && count <= 4) QCOMPARE(writer.size(), std::size_t(4 + 2 * count));
            ByteReader reader(std::span<const std::byte>(memory).first(writer.size()), NotFinite::Refused);
            std::array<std::int16_t, 4> read{-1, -1, -1, -1};
            int many = 77;
            reader.counted(read, many);
            const bool right = count >= 0 && count <= 4;
            QCOMPARE(reader.complete(), right);
            QCOMPARE(many, right ? count : 77);
            for (int i = 0; i < 4; ++i)
                QCOMPARE(int(read[std::size_t(i)]), right && i < count ? i + 1 : -1);
        }
    }

    void aListThatBreaksOffHasNoLength() {
        std::array<std::byte, 8> memory{};
        ByteWriter writer(memory);
        put(writer, 3, std::int16_t(9), std::int16_t(9)); // one too few
        ByteReader reader(memory, NotFinite::Refused);
        std::array<std::int16_t, 4> read{};
        int many = 77;
        reader.counted(read, many);
        QVERIFY(!reader.good());
        QCOMPARE(many, 77);
    }
};

TACTUM_TEST(TestByteArchive)

} // namespace test_byte_archive

#include "test_byte_archive.moc"
