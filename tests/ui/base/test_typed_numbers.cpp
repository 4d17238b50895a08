// Numbers as a person types and reads them.
//
// What would show that a test here is wrong: the factors are those of the SI, written out; what must not be
// taken stands beside what must.
#include <cmath>

#include <QLocale>
#include <QSettings>
#include <QTest>

#include "core/scene/scene.h"
#include "core/surface/material.h"
#include "core/surface/texture_parameters.h"
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

    void numbersAsText() {
        QCOMPARE(numberText(0.6, 2), "0.60");
        QCOMPARE(numberText(-0.004, 2), "0.00"); // not -0.00
        QCOMPARE(numberText(-0.006, 2), "-0.01");
        QCOMPARE(numberText(1e6, 0), "1000000");
        QCOMPARE(numberText(std::nan(""), 2), "-");
        QCOMPARE(numberText(INFINITY, 2), "-");
    }

    void areasAsText() {
        QCOMPARE(areaText(0), QString::fromUtf8("0.00 mm\u00b2"));
        QCOMPARE(areaText(2.5e-7), QString::fromUtf8("0.25 mm\u00b2"));
        QCOMPARE(areaText(4.25e-5), QString::fromUtf8("42.5 mm\u00b2"));
        QCOMPARE(areaText(0.9999e-4), QString::fromUtf8("1.00 cm\u00b2"));
        QCOMPARE(areaText(0.01), QString::fromUtf8("100 cm\u00b2"));
        QCOMPARE(areaText(1.2), QString::fromUtf8("1.20 m\u00b2"));
    }

    void lengthsAndTimesAsText() {
        QCOMPARE(lengthText(0), "0.00 mm");
        QCOMPARE(lengthText(1.4e-10), "0.14 nm");
        QCOMPARE(lengthText(1.4e-7), QString::fromUtf8("0.14 \u00b5m"));
        QCOMPARE(lengthText(9.99e-6), QString::fromUtf8("10 \u00b5m"));
        QCOMPARE(lengthText(1.4e-5), QString::fromUtf8("14 \u00b5m"));
        QCOMPARE(lengthText(0.99e-4), QString::fromUtf8("99 \u00b5m"));
        QCOMPARE(lengthText(0.9999e-4), "0.10 mm");
        QCOMPARE(lengthText(0.00014), "0.14 mm");
        QCOMPARE(lengthText(0.0003), "0.30 mm");
        QCOMPARE(lengthText(0.00999), "9.99 mm");
        QCOMPARE(lengthText(0.01), "10 mm");
        QCOMPARE(lengthText(0.2), "200 mm");
        QCOMPARE(lengthText(0.999), "999 mm");
        QCOMPARE(lengthText(1), "1.0 m");
        QCOMPARE(lengthText(4.2), "4.2 m");
        QCOMPARE(lengthText(10), "10 m");
        QCOMPARE(lengthText(1234.4), "1234 m");
        QCOMPARE(durationText(0), "1 s"); // never nothing
        QCOMPARE(durationText(3), "3 s");
        QCOMPARE(durationText(89), "89 s");
        QCOMPARE(durationText(90), "2 min");
        QCOMPARE(durationText(600), "10 min");
    }

    void parametersInUnitsForTheScreen() {
        const DisplayUnit radius = displayUnit(kProxyRadius), stiffness = displayUnit(kStiffness),
                          turn = displayUnit(kTextureRotation), none = displayUnit(kStaticFriction);
        QCOMPARE(radius.factor, 1000.0);
        QCOMPARE(radius.name, "mm");
        QCOMPARE(radius.decimals, kProxyRadius.decimals - 3);
        QCOMPARE(stiffness.factor, 1.0);
        QCOMPARE(stiffness.name, "N/m");
        QCOMPARE(stiffness.decimals, kStiffness.decimals);
        COMPARE_NEAR(turn.factor * std::acos(-1.0), 180, 1e-9, "degrees");
        QCOMPARE(turn.name, QString::fromUtf8("\u00b0"));
        QCOMPARE(turn.decimals, std::max(0, kTextureRotation.decimals - 2));
        QCOMPARE(none.name, "");
        QCOMPARE(none.decimals, 3);
    }

    void unitsAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("factor");
        QTest::addColumn<QList<int>>("powers"); // of kg, m and s
        const auto row = [](const char* text, double factor, const QList<int>& powers) {
            QTest::newRow(text) << QString::fromUtf8(text) << factor << powers;
        };
        row("", 1, {0, 0, 0});
        row("1", 1, {0, 0, 0});
        row("N", 1, {1, 1, -2});
        row("m", 1, {0, 1, 0});
        row("s", 1, {0, 0, 1});
        row("g", 1e-3, {1, 0, 0});
        row("kg", 1, {1, 0, 0});
        row("Hz", 1, {0, 0, -1});
        row("kHz", 1e3, {0, 0, -1});
        row("rad", 1, {0, 0, 0});
        row("mrad", 1e-3, {0, 0, 0});
        row("deg", std::acos(-1.0) / 180, {0, 0, 0});
        row("\u00b0", std::acos(-1.0) / 180, {0, 0, 0});
        row("%", 0.01, {0, 0, 0});
        row("in", 0.0254, {0, 1, 0});
        row("min", 60, {0, 0, 1});
        row("mm", 1e-3, {0, 1, 0});
        row("cm", 1e-2, {0, 1, 0});
        row("km", 1e3, {0, 1, 0});
        row("nm", 1e-9, {0, 1, 0});
        row("um", 1e-6, {0, 1, 0});
        row("\u00b5m", 1e-6, {0, 1, 0});
        row("\u03bcm", 1e-6, {0, 1, 0});
        row("MN", 1e6, {1, 1, -2});
        row("N/mm", 1e3, {1, 0, -2});
        row("N s/m", 1, {1, 0, -1});
        row("N*s/m", 1, {1, 0, -1});
        row("N\u00b7s/m", 1, {1, 0, -1});
        row("N\u22c5s", 1, {1, 1, -1});
        row("1/s", 1, {0, 0, -1});
        row("m/s/s", 1, {0, 1, -2});
        row("m/s^2", 1, {0, 1, -2});
        row("m/s\u00b2", 1, {0, 1, -2});
        row("mm^2", 1e-6, {0, 2, 0});
        row("cm\u00b3", 1e-6, {0, 3, 0});
        row("mm^3", 1e-9, {0, 3, 0});
        row("kg m/s^2", 1, {1, 1, -2});
        row(" m ", 1, {0, 1, 0});
        row("N / m", 1, {1, 0, -2});
        row("N/m s", 1, {1, 0, -1}); // one symbol goes below
    }

    void unitsAreRead() {
        QFETCH(QString, text);
        QFETCH(double, factor);
        QFETCH(QList<int>, powers);
        const auto unit = readUnit(text);
        QVERIFY(unit.has_value());
        COMPARE_NEAR(unit->factor / factor, 1, 1e-12, "");
        for (int i = 0; i < 3; ++i)
            QCOMPARE(unit->dimension[std::size_t(i)], powers[i]);
    }

    void whatIsNoUnitIsRefused() {
        for (const char* text :
             {"x", "kdeg", "k", "N/", "/", "m*", "N//m", "N*/m", "mmm", "kin", "m^4", "M", "2", "m2"})
            QVERIFY2(!readUnit(QString::fromUtf8(text)), text);
    }

    void numbersAreReadWithTheirUnits() {
        const auto read = [](const char* text, const char* unit = "") {
            return readNumber(QString::fromUtf8(text), QString::fromUtf8(unit));
        };
        QCOMPARE(read("1.5"), 1.5);
        QCOMPARE(read(" 1,5 "), 1.5);
        QCOMPARE(read("-2e-3"), -2e-3);
        QCOMPARE(read("800", "N/m"), 800.0);
        COMPARE_NEAR(*read("1.2 N/mm", "N/m"), 1200, 1e-9, "N/m");
        COMPARE_NEAR(*read("0.3 mm", "mm"), 0.3, 1e-12, "mm");
        COMPARE_NEAR(*read("0.3m", "mm"), 300, 1e-9, "mm");
        COMPARE_NEAR(*read("1e-3 m", "mm"), 1, 1e-12, "mm");
        COMPARE_NEAR(*read("50 %"), 0.5, 1e-12, "");
        COMPARE_NEAR(*read("1 rad", "\u00b0"), 180 / std::acos(-1.0), 1e-9, "degrees");
        for (const char* text :
             {"", "x", "1 x", "mm", "1 2", "--1", "1 kg", "inf", "1e999", "-", "e3", "1..2", "1,2,3"})
            QVERIFY2(!read(text, "mm"), text);
        QVERIFY(!read("1 m")); // of another kind
        QVERIFY(!read("nan"));
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
