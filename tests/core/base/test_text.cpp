// Words and numbers of files, and what is printed of them.
#include <clocale>
#include <cmath>
#include <limits>

#include <QTest>

#include "core/base/host_port.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_text {

using namespace tactum;

namespace {

std::string numberText(double value) {
    std::string text = "=";
    appendNumber(text, value);
    return text;
}
std::string numberText(float value) {
    std::string text = "=";
    appendNumber(text, value);
    return text;
}

struct Line {
    std::string text;
    std::size_t number, offset;
    bool operator==(const Line&) const = default;
};

std::vector<Line> linesOf(std::string_view text, bool join = false) {
    Lines lines(text, join);
    std::vector<Line> all;
    for (std::string_view line; lines.next(line);)
        all.push_back({std::string(line), lines.number(), lines.offset()});
    return all;
}

} // namespace

class TestText : public QObject {
    Q_OBJECT

private slots:
    void hostAndPort() {
        const auto is = [](const char* text, const char* host, int port) {
            const auto place = hostPortOf(text);
            return place && place->host == host && place->port == port;
        };
        QVERIFY(is("localhost:0", "localhost", 0));
        QVERIFY(is("10.0.0.7:65535", "10.0.0.7", 65535));
        QVERIFY(is("[::1]:51270", "::1", 51270));
        for (const char* none : {"", ":", "localhost", "localhost:", ":1", "a:65536", "a:-1", "a:+1", "a:1.0",
                                 "a:1e3", "::1:5", "[]:1", "a b:1", "a:b", "a: 1"})
            QVERIFY2(!hostPortOf(none), none);
    }

    /// The bounds of each length of UTF-8: the last that is right and the first that is not.
    void whatIsNoUtf8IsAQuestionMark_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char* name, const QByteArray& text, const QByteArray& shown) {
            QTest::newRow(name) << text << shown;
        };
        const auto stays = [&](const char* name, const QByteArray& text) { row(name, text, text); };
        stays("letters", "abc XYZ ~ 09");
        stays("two bytes, first", "\xC2\xA0");
        stays("two bytes, last", "\xDF\xBF");
        stays("three bytes, first", "\xE0\xA0\x80");
        stays("three bytes, before the surrogates", "\xED\x9F\xBF");
        stays("three bytes, after the surrogates", "\xEE\x80\x80");
        stays("three bytes, last", "\xEF\xBF\xBF");
        stays("four bytes, first", "\xF0\x90\x80\x80");
        stays("four bytes, last", "\xF4\x8F\xBF\xBF");
        stays("four bytes", "\xF1\x80\x80\x80");
        row("a follower alone", "\x80", "?");
        row("the last follower alone", "\xBF", "?");
        row("two bytes, overlong", "\xC1\xBF", "??");
        row("three bytes, overlong", "\xE0\x9F\xBF", "???");
        row("a surrogate", "\xED\xA0\x80", "???");
        row("four bytes, overlong", "\xF0\x8F\xBF\xBF", "????");
        row("beyond", "\xF4\x90\x80\x80", "????");
        row("no such first byte", "\xF5\x80\x80\x80", "????");
        row("two bytes, cut", "a\xC3", "a?");
        row("three bytes, cut", "\xE2\x82", "??");
        row("four bytes, cut", "\xF0\x9F\x98", "???");
        row("no follower", "\xC3(", "?(");
        row("no second follower", "\xE2\x82(",
            "?"
            "?(");
        row("no third follower", "\xF0\x9F\x98(",
            "?"
            "??"
            "(");
        row("control characters", QByteArray("a\0\t\n\x1F\x7F z", 8), "a????? z");
        stays("a blank and a tilde", " ~");
        row("control characters of two bytes", "\xC2\x80\xC2\x9F", "??");
        row("the first and the last that embed or override a direction", "\u202A\u202E", "??");
        row("those that isolate one", "\u2066\u2069", "??");
        row("marks of one", "\u200E\u200F\u061C", "???");
        stays("their neighbours", "\u2029\u202F\u2065\u206A\u200D\u2010\u061B\u061D");
    }

    void whatIsNoUtf8IsAQuestionMark() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, shown);
        QCOMPARE(printable(text.toStdString()), shown.toStdString());
        QCOMPARE(inQuotes(text.toStdString()), '"' + shown.toStdString() + '"');
    }

    void longTextIsCutBetweenCharacters() {
        QCOMPARE(printable("abcd", 4), "abcd");
        QCOMPARE(printable("abcde", 4), "a...");
        QCOMPARE(printable("ab\xC3\xA4"
                           "cdef",
                           6),
                 "ab..."); // the a with dots has no room
        QCOMPARE(printable(printable("ab\xC3\xA4"
                                     "cdef",
                                     6),
                           6),
                 "ab..."); // and is not cut again
        QCOMPARE(printable("abc\xC3\xA4", 5), "abc\xC3\xA4");
        QCOMPARE(printable("", 0), "");
        QCOMPARE(printable(std::string(60, 'x')), std::string(60, 'x'));
        QCOMPARE(printable(std::string(61, 'x')), std::string(57, 'x') + "...");
    }

    void percentsStandForBytes() {
        QCOMPARE(withoutPercents("a%20b"), "a b");
        QCOMPARE(withoutPercents("%41%6a%6A"), "Ajj");
        QCOMPARE(withoutPercents("%20"), " ");
        QCOMPARE(withoutPercents("100%"), "100%");
        QCOMPARE(withoutPercents("%2"), "%2");
        QCOMPARE(withoutPercents("%zz%4"), "%zz%4");
        QCOMPARE(withoutPercents("%4z"), "%4z");
        QCOMPARE(withoutPercents("%2520"), "%20"); // once only
        QCOMPARE(withoutPercents(""), "");
    }

    void blanksAreThoseInALine() {
        for (int c = 0; c < 256; ++c)
            QCOMPARE(isBlank(char(c)), c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r');
        QCOMPARE(trimmed(" \t a b\r"), "a b");
        QCOMPARE(trimmed(" \t"), "");
        QCOMPARE(trimmed(""), "");
        QCOMPARE(trimmed("\na\n"), "\na\n");
    }

    void lettersBecomeSmall() { QCOMPARE(lowerCase("AZaz@[`{09\xC3\x84"), "azaz@[`{09\xC3\x84"); }

    void fieldsLieBetweenBlanks() {
        Fields fields("  f 1/2\t\t3 \r");
        QCOMPARE(fields.rest(), "f 1/2\t\t3");
        QCOMPARE(fields.next(), "f");
        QCOMPARE(fields.rest(), "1/2\t\t3");
        QCOMPARE(fields.next(), "1/2");
        QCOMPARE(fields.next(), "3");
        QCOMPARE(fields.next(), "");
        QCOMPARE(fields.next(), "");
        QCOMPARE(fields.rest(), "");
        std::string_view rest = ",,a,b,";
        const auto comma = [](char c) { return c == ','; };
        QCOMPARE(takeSeparated(rest, comma), "a");
        QCOMPARE(rest, ",b,");
        QCOMPARE(takeSeparated(rest, comma), "b");
        QCOMPARE(takeSeparated(rest, comma), "");
        QCOMPARE(rest, "");
    }

    void linesHaveNumbers() {
        QCOMPARE(linesOf(""), std::vector<Line>());
        QCOMPARE(linesOf("a"), (std::vector<Line>{{"a", 1, 1}}));
        QCOMPARE(linesOf("a\n"), (std::vector<Line>{{"a", 1, 2}}));
        QCOMPARE(linesOf("a\r\n\nb\\\nc\r"),
                 (std::vector<Line>{{"a", 1, 3}, {"", 2, 4}, {"b\\", 3, 7}, {"c", 4, 9}}));
        QCOMPARE(linesOf("\n\n"), (std::vector<Line>{{"", 1, 1}, {"", 2, 2}}));
    }

    /// A joined line has the number of its first, and the one after it its own.
    void joinedLinesGoOn() {
        QCOMPARE(linesOf("a\\\nb\\\nc\nd\ne", true),
                 (std::vector<Line>{{"a b c ", 1, 8}, {"d", 4, 10}, {"e", 5, 11}}));
        QCOMPARE(linesOf("x\na\\\r\nb\ny", true),
                 (std::vector<Line>{{"x", 1, 2}, {"a b ", 2, 8}, {"y", 4, 9}}));
        QCOMPARE(linesOf("a\\", true), (std::vector<Line>{{"a ", 1, 2}}));
        QCOMPARE(linesOf("\\\n\nz", true), (std::vector<Line>{{"  ", 1, 3}, {"z", 3, 4}}));
    }

    void numbersAreReadWhole() {
        std::setlocale(LC_NUMERIC, "de_DE.UTF-8"); // whatever the user's language
        double value = 77;
        for (const auto& [text, number] : std::initializer_list<std::pair<const char*, double>>{
                 {"1", 1}, {"+1.5", 1.5}, {"-2e3", -2000}, {".5", 0.5}, {"0", 0}, {"5.", 5}}) {
            QVERIFY2(parseNumber(text, value), text);
            QCOMPARE(value, number);
            QCOMPARE(parseNumber(std::string_view(text)), std::optional(number));
        }
        for (const char* text : {"", "+", "-", "1x", " 1", "1 ", "++1", "+-1", "1,5", "e5", "0x10"}) {
            value = 77;
            QVERIFY2(!parseNumber(text, value), text);
            QVERIFY2(!parseNumber(std::string_view(text)), text);
        }
        for (const char* text : {"nan", "inf", "-inf"}) {
            QVERIFY2(parseNumber(text, value), text);
            QVERIFY2(!parseNumber(std::string_view(text)), text); // not finite
        }
        QVERIFY(!parseNumber("1e999", value));
        QVERIFY(!parseNumber(std::string_view("1e999")));
        std::setlocale(LC_NUMERIC, "C");
    }

    void wholeNumbersAreReadWhole() {
        std::int64_t value = 77;
        QVERIFY(parseNumber("-12", value));
        QCOMPARE(value, -12);
        QVERIFY(parseNumber("+9223372036854775807", value));
        QCOMPARE(value, std::numeric_limits<std::int64_t>::max());
        for (const char* text : {"1.5", "9223372036854775808", "", "+", "+-1", "1/2"})
            QVERIFY2(!parseNumber(text, value), text);
    }

    /// The shortest text that gives the same bits again, behind what is there.
    void numbersAreWrittenShort() {
        QCOMPARE(numberText(0.1), "=0.1");
        QCOMPARE(numberText(0.1f), "=0.1");
        QCOMPARE(numberText(-1e300), "=-1e+300");
        QCOMPARE(numberText(1.0 / 3), "=0.3333333333333333");
        QCOMPARE(numberText(1.0f / 3), "=0.33333334");
        QCOMPARE(numberText(-2.2250738585072014e-308), "=-2.2250738585072014e-308"); // the longest
        for (double x = 1e-300; x < 1e300; x *= -1.7e3)
            QCOMPARE_EQ(parseNumber(std::string_view(numberText(x)).substr(1)).value_or(0), x);
    }
};

TACTUM_TEST(TestText)

} // namespace test_text

#include "test_text.moc"
