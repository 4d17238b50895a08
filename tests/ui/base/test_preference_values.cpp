// What a person decided once: kept, brought into its range, told when it changes.
//
// What would show that a test here is wrong: what is read back was written by the settings alone.
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/own_folders.h"
#include "ui/base/preferences.h"
#include "ui/base/words.h"

namespace test_preference_values {

using namespace tactum;

namespace {

double preferred(Preferred id) {
    return Preferences::instance().value(id);
}

} // namespace

class TestPreferenceValues : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() { useFoldersIn(folder_.path()); }
    void cleanup() { QSettings().clear(); }

    void theTableIsInTheOrderOfItsNames() {
        std::size_t i = 0;
        for (const Preference& each : preferenceTable()) {
            QCOMPARE(std::size_t(each.id), i++);
            QVERIFY2(each.parameter.allows(each.parameter.initial), each.parameter.key.data());
            if (!each.choices.empty()) QCOMPARE(each.parameter.maximum, double(each.choices.size() - 1));
        }
    }

    void settingsOfAnotherHandAreBroughtIntoRange() {
        QSettings settings;
        for (const Preference& each : preferenceTable()) {
            const QString key = asIs(each.parameter.key);
            for (const QVariant& odd :
                 {QVariant(1e99), QVariant(-1e99), QVariant("nan"), QVariant("red"), QVariant()}) {
                settings.setValue(key, odd);
                QVERIFY2(each.parameter.allows(preferred(each.id)), qPrintable(key + u' ' + odd.toString()));
            }
            settings.setValue(key, QStringLiteral("red"));
            QCOMPARE(preferred(each.id), each.parameter.initial);
        }
    }

    void whatIsSetIsKeptUnderItsKeyAndToldOnce() {
        for (const Preference& each : preferenceTable()) {
            const Parameter& of = each.parameter;
            QSignalSpy changed(&Preferences::instance(), &Preferences::changed);
            Preferences::instance().set(each.id, of.initial);
            QCOMPARE(changed.size(), 0); // it was so already
            const double other = of.initial == of.maximum ? of.minimum : of.maximum;
            Preferences::instance().set(each.id, other);
            QCOMPARE(changed.size(), 1);
            QCOMPARE(changed[0][0].value<Preferred>(), each.id);
            QCOMPARE_EQ(preferred(each.id), other);
            QCOMPARE_EQ(QSettings().value(asIs(of.key)).toDouble(), other);
            Preferences::instance().set(each.id, 2 * of.maximum + 1); // beyond: the most
            QCOMPARE_EQ(preferred(each.id), of.maximum);
            Preferences::instance().set(each.id, of.minimum - 1);
            QCOMPARE_EQ(preferred(each.id), of.minimum);
        }
    }

    // A choice is the place of it, and what is between two places the nearer one.
    void choicesAreWhole() {
        QSettings().setValue(asIs(preference(Preferred::Lengths).parameter.key), 1.4);
        QCOMPARE_EQ(preferred(Preferred::Lengths), 1);
        QSettings().setValue(asIs(preference(Preferred::TurnSpeed).parameter.key), 1.4);
        QCOMPARE_EQ(preferred(Preferred::TurnSpeed), 1.4);
        Preferences::instance().set(Preferred::WheelAway, 1);
        QCOMPARE(Preferences::instance().choice<WheelAway>(Preferred::WheelAway), WheelAway::Farther);
    }
};

TACTUM_TEST(TestPreferenceValues)

} // namespace test_preference_values

#include "test_preference_values.moc"
