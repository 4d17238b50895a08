// The self-test in the window: a person is led through it with real clicks, and the device that the window
// had comes back without force, whatever happens in between. Wrong if the fake arm moved by itself: it does
// not, and so the test must find that it does not push.
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/device_desk.h"
#include "tests/ui/window/self_test_person.h"
#include "ui/base/preferences.h"

namespace test_self_test_dialog {

using namespace tactum;

namespace {

constexpr SelfTestPace kHurry{.rest = 0.2, .shake = 0.5, .settle = 0.2, .swings = 1, .buttons = 0.3};

/// An arm that was connected, whose x runs the other way, and its person.
struct Trials {
    Trials() {
        if (!desk.connectIt()) qFatal("no arm");
        person.hurry(kHurry);
    }
    bool lead(TrialAsk what) {
        desk.desk->place(what == TrialAsk::Right ? -kRulerWay : 0, what == TrialAsk::Up ? kRulerWay : 0,
                         what == TrialAsk::Toward ? kRulerWay : 0);
        if (what == TrialAsk::Press) desk.desk->buttons = 0b011;
        return true;
    }
    /// The window has its arm again, as it comes: without force.
    bool backWithoutForce() {
        return test::waitFor([this] { return !person.dialog() && desk.ready(); }) && !desk.engine().armed() &&
               desk.desk->force == 0 && desk.desk->made == 1;
    }

    Desk desk;
    SelfTestPerson person{desk.program, [this](TrialAsk what) { return lead(what); }};
};

} // namespace

class TestSelfTestDialog : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { beginDeviceTest(folder_); }

    void itSaysWhyThereIsNothingToMeasure() {
        Desk desk;
        desk.program.frames(3);
        QAction& command = desk.program.command("self-test");
        QVERIFY(!command.isEnabled());
        COMPARE_CONTAINS(command.toolTip(), QStringLiteral("simulated hand has nothing to be measured"));
        QVERIFY(desk.connectIt());
        QTRY_VERIFY_WITH_TIMEOUT(command.isEnabled(), kPatience);
        desk.engine().setArmed(true);
        QTRY_VERIFY_WITH_TIMEOUT(!command.isEnabled(), kPatience);
        COMPARE_CONTAINS(command.toolTip(), QStringLiteral("The forces are on"));
    }

    void aPersonIsLedThroughAllOfIt() {
        Trials trials;
        auto& person = trials.person;
        person.open();
        QCOMPARE(trials.desk.link().current(), kFake); // nothing is taken before it starts
        person.click("self-test-start");
        QVERIFY(person.goThrough());
        QVERIFY2(person.shown("self-test-verdict"), qPrintable(person.text("self-test-failure")));
        const QString found = person.text("self-test-found");
        for (const char* sentence : {"x runs the other way", "does not push along x", "does not push along z",
                                     "Button 3 of 3 was not heard", "Button 1 was not heard to be released"})
            COMPARE_CONTAINS(found, QLatin1String(sentence));
        COMPARE_CONTAINS(found, QStringLiteral("Left out:"));
        QCOMPARE(found.section(QStringLiteral("Left out"), 0, 0).count(QStringLiteral("<li>")), 7);
        auto& figures = person.widget<QTreeWidget>("self-test-figures");
        QCOMPARE_GT(figures.topLevelItemCount(), 5);
        QCOMPARE(figures.topLevelItem(0)->text(0), QStringLiteral("new readings"));
        QCOMPARE(trials.desk.desk->made.load(), 0); // it is closed already
        if (const QString file = qEnvironmentVariable("TACTUM_PICTURE"); !file.isEmpty())
            person.dialog()->grab().save(file);
        person.click("self-test-close");
        QVERIFY(trials.backWithoutForce());
    }

    void itsFiguresAreKept() {
        Trials trials;
        auto& person = trials.person;
        person.open();
        person.click("self-test-start");
        QVERIFY(person.goThrough());
        QVERIFY(person.shown("self-test-verdict"));
        person.click("self-test-keep");
        QTRY_VERIFY_WITH_TIMEOUT(!person.text("self-test-told").isEmpty(), kPatience);
        COMPARE_CONTAINS(
            person.text("self-test-told"),
            QStringLiteral("The figures of Example arm are kept. They hold from the next connection on"));
        COMPARE_CONTAINS(QString::fromStdString(trials.desk.catalogue->keptFigures),
                         QStringLiteral("\"position_resolution_m\""));
    }

    void escapeTakesTheForceAndTheArmComesBack() {
        Trials trials;
        auto& person = trials.person;
        person.open();
        person.click("self-test-start");
        // In the middle of a push.
        QVERIFY(person.goThrough([&] { return trials.desk.desk->force > 0.5; }));
        QVERIFY(!person.over());
        QTest::keyClick(person.dialog(), Qt::Key_Escape);
        QVERIFY(trials.backWithoutForce());
    }

    void leftBeforeTheDeviceWasMadeItComesBack() {
        Trials trials;
        auto& person = trials.person;
        person.open();
        trials.desk.desk->go = 0; // it is not made ready before the test wants it
        person.click("self-test-start");
        person.click("self-test-cancel");
        trials.desk.desk->go = 3;
        QVERIFY(trials.backWithoutForce());
        QCOMPARE_GE(trials.desk.desk->prepared.load(), 2); // once more for the window
    }

    void aPulledPlugIsSaid() {
        Trials trials;
        auto& person = trials.person;
        person.open();
        person.click("self-test-start");
        QVERIFY(person.goThrough([&] { return person.asked() && person.ask() == TrialAsk::Up; }));
        trials.desk.desk->plugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(person.shown("self-test-failure"), kPatience);
        COMPARE_CONTAINS(person.text("self-test-failure"),
                         QStringLiteral("Example arm gives no readings any more: look at its cable"));
        person.click("self-test-end");
        trials.desk.desk->plugged = true;
        QVERIFY(trials.backWithoutForce());
    }

    void closingTheWindowEndsIt() {
        auto trials = std::make_unique<Trials>();
        const auto desk = trials->desk.desk;
        trials->person.open();
        trials->person.click("self-test-start");
        QVERIFY(trials->person.goThrough([&] { return desk->force > 0.5; }));
        trials.reset();
        QCOMPARE(desk->made.load(), 0);
        QCOMPARE(desk->force.load(), 0.0);
    }

    void theButtonThatEndsAllForceEndsItToo() {
        Trials trials;
        trials.desk.link().stop().buttons = 0b100;
        trials.person.open();
        trials.person.click("self-test-start");
        QVERIFY(trials.person.goThrough([&] { return trials.desk.desk->force > 0.5; }));
        trials.desk.desk->buttons = 0b100;
        QTRY_VERIFY_WITH_TIMEOUT(trials.person.shown("self-test-failure"), kPatience);
        COMPARE_CONTAINS(trials.person.text("self-test-failure"),
                         QStringLiteral("was stopped by its own button"));
        trials.desk.desk->buttons = 0;
        trials.person.click("self-test-end");
        QVERIFY(trials.backWithoutForce());
    }

    /// What the person does not want to feel is not felt here either: four tenths of it at most.
    void itKeepsTheForceThatThePersonPrefers() {
        Preferences::instance().set(Preferred::LargestForce, 1);
        Trials trials;
        trials.person.open();
        trials.desk.desk->strongest = 0;
        trials.person.click("self-test-start");
        QVERIFY(trials.person.goThrough());
        Preferences::instance().set(Preferred::LargestForce, 0);
        QVERIFY(trials.person.shown("self-test-verdict"));
        QCOMPARE_GT(trials.desk.desk->strongest.load(), 0.2);
        QCOMPARE_LE(trials.desk.desk->strongest.load(), 0.4);
    }
};

TACTUM_GUI_TEST(TestSelfTestDialog)

} // namespace test_self_test_dialog

#include "test_self_test_dialog.moc"
