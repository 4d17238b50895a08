// Bulk bytes: the same calls write and read, and each fault is told with its place.
#include <limits>

#include <QTest>

#include "core/base/byte_stream.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_byte_stream {

using namespace tactum;

namespace {

enum class Fruit : std::uint8_t { Apple, Pear, Plum };

/// What a reader says of bytes; "" when it says nothing.
template <class Read> std::string faultOf(std::string_view bytes, Read&& read, std::size_t offset = 100) {
    ByteIn in(bytes, "part", offset, "write it again");
    try {
        read(in);
    } catch (const ByteFault& fault) {
        return fault.error.kind == Error::Kind::Input ? fault.error.text : "of another kind";
    }
    return {};
}

template <class Write> std::string bytesOf(Write&& write) {
    StringOut out;
    write(out);
    return out.bytes;
}

struct Thing {
    double number = 0;
    bool on = false;
    Vec3 place = Vec3::Zero();
    Pose pose;
    std::string text;
    std::vector<std::uint16_t> list;
    std::vector<std::string> words;
    Fruit fruit = Fruit::Apple;

    template <class Io> void pass(Io& io) {
        io(number);
        io(on);
        io(place);
        io(pose);
        io(text);
        io.bulk(list);
        io.count(words, 8);
        for (std::string& word : words)
            io(word);
        choose(io, fruit, 3);
    }
};

Thing sample() {
    return {-2.25,
            true,
            {1, 2, 3},
            {Quat(0, 1, 0, 0), {4, 5, 6}},
            std::string("a\0b", 3),
            {1, 2, 65535},
            {"x", "", "yz"},
            Fruit::Plum};
}

} // namespace

class TestByteStream : public QObject {
    Q_OBJECT

private slots:
    void theSameCallsReadWhatTheyWrote() {
        const std::string bytes = bytesOf([](StringOut& out) { sample().pass(out); });
        QCOMPARE(bytes.size(), std::size_t(8 + 1 + 24 + 56 + 8 + 3 + 8 + 6 + 8 + 9 + 8 + 10 + 1));
        // However the bytes lie in memory.
        for (std::size_t shift = 0; shift < 3; ++shift) {
            const std::string moved = std::string(shift, '#') + bytes;
            ByteIn in(std::string_view(moved).substr(shift), "", 0, "");
            Thing read;
            read.pass(in);
            QCOMPARE(in.left(), 0u);
            QCOMPARE(read.number, -2.25);
            QVERIFY(read.on);
            QCOMPARE(read.place, Vec3(1, 2, 3));
            QCOMPARE(read.pose.rotation.coeffs(), sample().pose.rotation.coeffs());
            QCOMPARE(read.pose.translation, Vec3(4, 5, 6));
            QCOMPARE(read.text, sample().text);
            QCOMPARE(read.list, sample().list);
            QCOMPARE(read.words, sample().words);
            QCOMPARE(read.fruit, Fruit::Plum);
        }
    }

    /// Whatever a list begins at, its items are the same, and so is what follows it.
    void listsLieAnywhere() {
        for (std::size_t before = 0; before < 9; ++before)
            for (std::size_t count = 0; count < 4; ++count) {
                std::vector<double> list(count, 0.5);
                for (std::size_t i = 0; i < count; ++i)
                    list[i] += double(i);
                const std::string bytes = std::string(before, 'x') + bytesOf([&](StringOut& out) {
                                              out.bulk(list);
                                              std::uint8_t end = 200;
                                              out(end);
                                          });
                std::vector<double> read{9, 9, 9, 9, 9};
                std::uint8_t end = 0;
                ByteIn in(std::string_view(bytes).substr(before), "", 0, "");
                in.bulk(read);
                QCOMPARE(in.left(), 1u);
                QCOMPARE(in.rest(), "\xC8");
                in(end);
                QCOMPARE(read, list);
                QCOMPARE(int(end), 200);
            }
    }

    void aSingleByteIsTaken() {
        std::uint8_t byte = 0;
        ByteIn in("A", "", 0, "");
        in(byte);
        QCOMPARE(int(byte), int('A'));
        QCOMPARE(in.left(), 0u);
    }

    void everyCutIsTold() {
        const std::string bytes = bytesOf([](StringOut& out) { sample().pass(out); });
        for (std::size_t length = 0; length < bytes.size(); ++length)
            QVERIFY2(!faultOf(bytes.substr(0, length), [](ByteIn& in) { Thing().pass(in); }).empty(),
                     qPrintable(QString::number(length)));
        QCOMPARE(faultOf(bytes, [](ByteIn& in) { Thing().pass(in); }), "");
    }

    void aFaultSaysItsPlace() {
        const std::string eight(8, '\0');
        const auto number = [](ByteIn& in) {
            double x = 0;
            in(x);
        };
        QCOMPARE(faultOf("1234567", number), "part: byte 100: it ends too early; write it again");
        QCOMPARE(faultOf(eight + "1234567",
                         [&](ByteIn& in) {
                             number(in);
                             number(in);
                         }),
                 "part: byte 108: it ends too early; write it again");
        QCOMPARE(faultOf(eight, [](ByteIn& in) { in.fail("no"); }), "part: byte 100: no; write it again");
        QCOMPARE(faultOf(
                     eight, [](ByteIn& in) { in.demand(false, "no"); }, 7),
                 "part: byte 7: no; write it again");
        QCOMPARE(faultOf(eight, [](ByteIn& in) { in.demand(true, "no"); }), "");
    }

    void numbersAreFinite() {
        for (const double bad :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            double value = bad;
            const std::string bytes = bytesOf([&](StringOut& out) { out(value); });
            COMPARE_CONTAINS(faultOf(bytes,
                                     [](ByteIn& in) {
                                         double x = 0;
                                         in(x);
                                     }),
                             "a number is not finite");
            Vec3 v(1, bad, 2);
            const std::string three = bytesOf([&](StringOut& out) { out(v); });
            COMPARE_CONTAINS(faultOf(three,
                                     [](ByteIn& in) {
                                         Vec3 x;
                                         in(x);
                                     }),
                             "part: byte 116: a number is not finite");
        }
    }

    void aSwitchIsOnOrOff() {
        for (const char byte : {'\0', '\1', '\2', '\xFF'}) {
            bool on = byte != 1;
            const std::string fault = faultOf(std::string(1, byte), [&](ByteIn& in) { in(on); });
            QCOMPARE(fault, byte == 0 || byte == 1
                                ? ""
                                : "part: byte 101: a switch is neither on nor off; write it again");
            if (fault.empty()) QCOMPARE(on, byte == 1);
        }
    }

    void aRotationIsOfUnitLength() {
        for (const double length : {0.9, 1 - 2e-6, 1 - 1e-7, 1.0, 1 + 1e-7, 1 + 2e-6, 2.0}) {
            Pose pose{Quat(0.5 * length, -0.5 * length, 0.5 * length, 0.5 * length), Vec3(1, 2, 3)};
            const std::string bytes = bytesOf([&](StringOut& out) { out(pose); });
            QCOMPARE(bytes.size(), 56u);
            const std::string fault = faultOf(bytes, [](ByteIn& in) {
                Pose read;
                in(read);
            });
            QCOMPARE(fault.empty(), std::abs(length - 1) < 1e-6);
            if (!fault.empty()) COMPARE_CONTAINS(fault, "a rotation is not of unit length");
        }
    }

    void aTextIsNoLongerThanAllThereIs() {
        for (std::uint64_t size : {0, 3, 4, 1000}) {
            std::string bytes = bytesOf([&](StringOut&out) { out(size); }) + "abc", text = "before";
            const std::string fault = faultOf(bytes, [&](ByteIn& in) { in(text); });
            if (size <= 3) {
                QCOMPARE(fault, "");
                QCOMPARE(text, std::string("abc").substr(0, size));
            } else {
                QCOMPARE(fault, "part: byte 108: a text is longer than all there is; write it again");
            }
        }
    }

    void aListIsNoLongerThanAllThereIs() {
        for (std::uint64_t size : {std::uint64_t(0), std::uint64_t(2), std::uint64_t(3), ~std::uint64_t(0)}) {
            const std::string bytes = bytesOf([&](StringOut& out) { out(size); }) + std::string(9, 'x');
            std::vector<std::uint32_t> bulk;
            std::vector<std::string> counted;
            const std::string first = faultOf(bytes, [&](ByteIn&in) { in.bulk(bulk); }),
                              second = faultOf(bytes, [&](ByteIn&in) { in.count(counted, 4); });
            QCOMPARE(first, second);
            if (size <= 2) {
                QCOMPARE(first, "");
                QCOMPARE(bulk.size(), size);
                QCOMPARE(counted.size(), size);
            } else {
                QCOMPARE(first, "part: byte 108: a list is longer than all there is; write it again");
            }
        }
    }

    void aChoiceIsOneOfThoseThatThereAre() {
        for (int number = 0; number < 6; ++number) {
            Fruit fruit{};
            const std::string fault =
                faultOf(std::string(1, char(number)), [&](ByteIn& in) { choose(in, fruit, 3); });
            QCOMPARE(fault.empty(), number < 3);
            if (number < 3) QCOMPARE(int(fruit), number);
            if (number >= 3) COMPARE_CONTAINS(fault, "it names a choice that there is not");
        }
    }
};

TACTUM_TEST(TestByteStream)

} // namespace test_byte_stream

#include "test_byte_stream.moc"
