// Numbers as a person types and reads them.
//
// What would show that a test here is wrong: the factors are those of the SI, written out; what must not be
// taken stands beside what must.
#include <numbers>

#include <QLocale>
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/own_folders.h"
#include "ui/base/numbers.h"
#include "ui/base/preferences.h"
#include "ui/base/search.h"
#include "ui/base/units.h"

namespace test_typed_numbers {

using namespace tactum;

class TestTypedNumbers : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() {
        useFoldersIn(folder_.path());
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany)); // a comma, which must not come in
    }
    void cleanup() { QSettings().clear(); }

    void unitsOfOneKindAreTaken_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value"); // NaN: not taken
        const auto row = [](const char* typed, const char* unit, double value) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << QString::fromUtf8(unit) << value;
        };
        const double none = std::nan("");
        row("1.2 N/mm", "N/m", 1200);
        row("1,2N/mm", "N/m", 1200);
        row("0.5 kN/m", "N/m", 500);
        row("3 N/cm", "N/m", 300);
        row("800 kg/s^2", "N/m", 800);
        row("800 kg/s\u00b2", "N/m", 800);
        row("5 N s/m", "N s/m", 5);
        row("5 N*s/m", "N s/m", 5);
        row("5 kg/s", "N s/m", 5);
        row("2 N ms/mm", "N s/m", 2);
        row("0.3 cm", "mm", 3);
        row("250 um", "mm", 0.25);
        row("250 \u00b5m", "mm", 0.25);
        row("1 in", "mm", 25.4);
        row("1e-3 m", "mm", 1);
        row("1 rad", "\u00b0", 57.29577951308232);
        row("40 deg", "\u00b0", 40);
        row("50 %", "", 0.5);
        row("7", "N/m", 7);
        row("7 N", "N/m", none);
        row("7 N/s", "N/m", none);
        row("7 mm", "", none);
        row("7 N/", "N/m", none);
        row("N/m", "N/m", none);
        row("7 qq", "N/m", none);
        row("1 2", "N/m", none);
    }

    void unitsOfOneKindAreTaken() {
        QFETCH(QString, typed);
        QFETCH(QString, unit);
        QFETCH(double, value);
        const auto read = readNumber(typed, unit);
        QCOMPARE(read.has_value(), !std::isnan(value));
        if (read) QCOMPARE_LE(std::abs(*read - value), 1e-12 * std::abs(value));
    }

    // kg, m and s, each to its power.
    void aUnitIsAFactorAndItsDimension() {
        const auto is = [](const char* text, double factor, std::array<int, 3> dimension) {
            const auto unit = readUnit(QString::fromUtf8(text));
            QVERIFY2(unit.has_value(), text);
            COMPARE_NEAR(unit->factor, factor, 1e-14 * factor, text);
            QVERIFY2(unit->dimension == dimension, text);
        };
        is("", 1, {0, 0, 0});
        is("N", 1, {1, 1, -2});
        is("g", 1e-3, {1, 0, 0});
        is("kg", 1, {1, 0, 0});
        is("mm^3", 1e-9, {0, 3, 0});
        is("mm\u00b3", 1e-9, {0, 3, 0});
        is("cm\u00b2", 1e-4, {0, 2, 0});
        is("nm", 1e-9, {0, 1, 0});
        is("\u03bcm", 1e-6, {0, 1, 0});
        is("MHz", 1e6, {0, 0, -1});
        is("min", 60, {0, 0, 1});
        is("in", 0.0254, {0, 1, 0});
        is("1/s", 1, {0, 0, -1});
        is("m/s^2", 1, {0, 1, -2});
        is("m/s/s", 1, {0, 1, -2});
        is("N/m s", 1, {1, 0, -1}); // one symbol goes below, as in N s/m read from left to right
        is("%", 0.01, {0, 0, 0});
        is("mrad", 1e-3, {0, 0, 0});
        is("deg", std::numbers::pi / 180, {0, 0, 0});
        is("N\u22c5m", 1, {1, 2, -2});
        for (const char* none : {"Q", "k", "kk", "mmm", "kdeg", "k%", "N//m", "N*", "N/", "^2", "N^4"})
            QVERIFY2(!readUnit(QString::fromUtf8(none)), none);
    }

    void noNumberIsNone() {
        for (const char* none : {"nan", "inf", "1e999", "1 2", "", "-", "e3", "mm", "1..2", "1,2,3"})
            QVERIFY2(!readNumber(QString::fromUtf8(none)), none);
        QCOMPARE(readNumber(QStringLiteral("  -1,5  ")), std::optional(-1.5));
        QCOMPARE(readNumber(QStringLiteral("1e-3")), std::optional(1e-3));
        QVERIFY(!readNumber(QStringLiteral("3 mm"), QStringLiteral("furlongs")));
    }

    void numbersAreShownWithAPoint() {
        QCOMPARE(numberText(0.6, 2), QStringLiteral("0.60"));
        QCOMPARE(numberText(1234567.5, 1), QStringLiteral("1234567.5"));
        QCOMPARE(numberText(-0.001, 2), QStringLiteral("0.00")); // and no minus before nothing
        QCOMPARE(numberText(-0.006, 2), QStringLiteral("-0.01"));
        QCOMPARE(numberText(std::nan(""), 2), QStringLiteral("-"));
        QCOMPARE(numberText(HUGE_VAL, 2), QStringLiteral("-"));
        QCOMPARE(lengthText(0.2), QStringLiteral("200 mm"));
        QCOMPARE(lengthText(0.00999), QStringLiteral("9.99 mm"));
        QCOMPARE(lengthText(4.24), QStringLiteral("4.2 m"));
        QCOMPARE(lengthText(42.4), QStringLiteral("42 m"));
        QCOMPARE(durationText(0.2), QStringLiteral("1 s"));
        QCOMPARE(durationText(89), QStringLiteral("89 s"));
        QCOMPARE(durationText(91), QStringLiteral("2 min"));
        QCOMPARE(durationText(600), QStringLiteral("10 min"));
    }

    void everyFigureKeepsThreeOfItsDigits() {
        for (int power = -12; power <= 12; ++power)
            for (const double lead : {1.0, 4.56, 9.99})
                for (const int decimals : {0, 2, 6, 12}) {
                    const double value = lead * std::pow(10, power);
                    const int shown = decimalsFor(-value, decimals);
                    QCOMPARE_LE(shown, decimals);
                    QCOMPARE(shown, decimalsFor(value, decimals));
                    const double lost = std::abs(numberText(value, shown).toDouble() - value);
                    const double all = std::abs(numberText(value, decimals).toDouble() - value);
                    QCOMPARE_LE(lost, std::max(all, 0.5001e-2 * value));
                }
        QCOMPARE(decimalsFor(0, 9), 4);
        QCOMPARE(decimalsFor(0, 2), 2);
        QCOMPARE(decimalsFor(123456789, 6), 0);
        QCOMPARE(decimalsFor(1234, 6), 4);
        QCOMPARE(decimalsFor(0.001234, 12), 5);
    }

    void whatIsPreferredIsShown() {
        Parameter length = preference(Preferred::TurnSpeed).parameter;
        length.unit = "m", length.decimals = 5;
        const auto unitOf = [](Parameter of, std::string_view unit, int decimals) {
            of.unit = unit, of.decimals = decimals;
            const DisplayUnit shown = displayUnit(of);
            return QStringLiteral("%1 %2 %3")
                .arg(shown.name)
                .arg(shown.factor, 0, 'g', 6)
                .arg(shown.decimals);
        };
        QCOMPARE(unitOf(length, "m", 5), QStringLiteral("mm 1000 2"));
        QCOMPARE(unitOf(length, "m", 1), QStringLiteral("mm 1000 0"));
        QCOMPARE(unitOf(length, "N/m", 0), QStringLiteral("N/m 1 0"));
        QCOMPARE(unitOf(length, "kg", 5), QStringLiteral("g 1000 2"));
        QCOMPARE(unitOf(length, "rad", 3), QString::fromUtf8("\u00b0 57.2958 1"));
        QCOMPARE(unitOf(length, "s", 2), QStringLiteral("s 1 2"));
        Preferences::instance().set(Preferred::Lengths, 0);
        QCOMPARE(unitOf(length, "m", 5), QStringLiteral("m 1 5"));
        QCOMPARE(lengthText(0.2), QStringLiteral("0.20 m"));
        QCOMPARE(lengthText(99.0), QStringLiteral("99.0 m"));
        Preferences::instance().set(Preferred::Lengths, 1);
        QCOMPARE(unitOf(length, "m", 5), QStringLiteral("cm 100 3"));
        QCOMPARE(lengthText(0.2), QStringLiteral("20.0 cm"));
        Preferences::instance().set(Preferred::Lengths, 3);
        QCOMPARE(unitOf(length, "m", 5), QStringLiteral("in 39.3701 3"));
        QCOMPARE(lengthText(0.0254 * 250), QStringLiteral("250 in"));
        Preferences::instance().set(Preferred::Stiffnesses, 1);
        QCOMPARE(unitOf(length, "N/m", 0), QStringLiteral("N/mm 0.001 3"));
    }

    void wordsAreFoundInAnyOrder() {
        const auto finds = [](const char* text, const char* typed) {
            return hasWords(QString::fromUtf8(text), searchWords(QString::fromUtf8(typed)));
        };
        QVERIFY(finds("Save a copy", "copy  SAVE"));
        QVERIFY(finds("Save a copy", "av"));
        QVERIFY(finds("Save a copy", "  "));
        QVERIFY(!finds("Save a copy", "save copies"));
    }
};

TACTUM_TEST(TestTypedNumbers)

} // namespace test_typed_numbers

#include "test_typed_numbers.moc"
