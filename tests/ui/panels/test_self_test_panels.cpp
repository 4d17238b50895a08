// The pages of a self-test: what a person is asked and told, and what their answers say. Wrong itself if a
// page did not follow what it is given: each is asked for twice, by what is written down and by its signals.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/self_test_page.h"
#include "ui/panels/self_test_result.h"

namespace test_self_test_panels {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

DeviceInfo knownDevice() {
    DeviceInfo device;
    device.name = "Known";
    device.workspaceRadius = 0.05;
    device.maxForce = 8;
    return device;
}

struct ShownPage {
    ShownPage() {
        page.resize(600, 500);
        page.setVisible(true);
        if (!QTest::qWaitForWindowExposed(&page)) qFatal("no window");
        QApplication::setActiveWindow(&page); // as far as Qt knows: there is no window manager
    }
    QPushButton& button(const char* name) { return part<QPushButton>(page, name); }
    QString words(const char* name) { return part<QLabel>(page, name).text(); }
    void ask(TrialAsk ask, const TrialWords& words = "Let go.") {
        page.ask({TrialQuestion::Kind::Does, ask, words, 0});
    }
    bool asks() { return button("self-test-continue").isEnabled() && button("self-test-skip").isEnabled(); }
    QString picture() { return drawnBy(*page.findChild<QWidget*>(QStringLiteral("workspace-picture"))); }

    SelfTestPage page;
};

SelfTestReport reportOf(std::vector<SelfTestFigure> figures) {
    SelfTestReport report;
    report.device = knownDevice();
    report.figures = std::move(figures);
    return report;
}

} // namespace

class TestSelfTestPanels : public QObject {
    Q_OBJECT

public:
    static void initMain() { namePanelTest("TactumSelfTestPanels"); }

private slots:
    static void initTestCase() {
        speakEnglish();
        applyTheme(ThemeChoice::Dark);
    }

    void itAsksOneThingAtATime() {
        ShownPage shown;
        COMPARE_SHOWN(shownIn(shown.page), "trial-page");
        QVERIFY(!shown.asks());
        shown.page.showPreparing(QStringLiteral("Opening"), {});
        QCOMPARE(shown.words("self-test-part"), "The device is being made ready");
        QCOMPARE(shown.words("self-test-words"), "Opening");
        shown.page.showPreparing(QStringLiteral("Opening"), QStringLiteral("Pull the handle out."));
        QCOMPARE(shown.words("self-test-words"), "Pull the handle out.");
        shown.page.showPart(TrialPart::Dynamics);
        COMPARE_CONTAINS(shown.words("self-test-part"), "Part 4 of 6: ");
        shown.ask(TrialAsk::LetGo);
        COMPARE_SHOWN(shownIn(shown.page), "trial-page-asks");
        QCOMPARE(shown.button("self-test-continue").accessibleDescription(), "Let go.");
        QVERIFY(shown.asks());
        QVERIFY(shown.button("self-test-continue").hasFocus());
        QSignalSpy done(&shown.page, &SelfTestPage::done), skipped(&shown.page, &SelfTestPage::skipped),
            cancelled(&shown.page, &SelfTestPage::cancelled), mass(&shown.page, &SelfTestPage::massGiven);
        shown.button("self-test-continue").click();
        QCOMPARE_EQ(done.count(), 1);
        QVERIFY(!shown.asks());
        QVERIFY(shown.button("self-test-cancel").hasFocus()); // where Enter does no harm
        shown.ask(TrialAsk::LetGo);
        shown.button("self-test-skip").click();
        QCOMPARE_EQ(skipped.count(), 1);
        QVERIFY(!shown.asks());
        shown.button("self-test-cancel").click();
        QCOMPARE_EQ(cancelled.count(), 1);
        QCOMPARE_EQ(done.count() + skipped.count() + mass.count(), 2);
        shown.page.showEnding();
        QVERIFY(!shown.asks());
        QVERIFY(!shown.button("self-test-cancel").isEnabled());
        QCOMPARE(shown.words("self-test-words"), "The forces are off. The device is being closed.");
    }

    void aMassIsGivenInGrams() {
        ShownPage shown;
        shown.page.showPart(TrialPart::Weight);
        auto& mass = part<QDoubleSpinBox>(shown.page, "self-test-mass");
        QVERIFY(!mass.isVisible());
        shown.page.ask({TrialQuestion::Kind::Mass, TrialAsk::Hang, {}, 0.2});
        COMPARE_SHOWN(shownIn(shown.page), "trial-page-mass");
        QVERIFY(mass.hasFocus());
        COMPARE_NEAR(mass.minimum(), 5.0, 1e-9, "g");
        COMPARE_NEAR(mass.maximum(), 200.0, 1e-9, "g");
        COMPARE_NEAR(mass.value(), 50.0, 1e-9, "g");
        mass.setValue(12.5);
        QSignalSpy given(&shown.page, &SelfTestPage::massGiven), done(&shown.page, &SelfTestPage::done);
        shown.button("self-test-continue").click();
        COMPARE_NEAR(given.takeFirst()[0].toDouble(), 0.0125, 1e-12, "kg");
        QVERIFY(!mass.isVisible());
        shown.ask(TrialAsk::Hang);
        shown.button("self-test-continue").click();
        QCOMPARE_EQ(done.count(), 1);
        QCOMPARE_EQ(given.count(), 0);
        shown.page.ask(
            {TrialQuestion::Kind::Mass, TrialAsk::Hang, {}, 0.001}); // less than what can be weighed
        COMPARE_NEAR(mass.maximum(), 5.0, 1e-9, "g");
    }

    void thePictureAimsWhereTheHandleIsLed() {
        ShownPage shown;
        const DeviceInfo device = knownDevice();
        TrialLook look;
        look.position = {0.01, 0, 0};
        shown.page.show(look, device);
        shown.page.showPart(TrialPart::Ruler);
        QStringList pictures;
        for (const TrialAsk ask : {TrialAsk::Zero, TrialAsk::Right, TrialAsk::Up, TrialAsk::Toward}) {
            shown.ask(ask);
            pictures << shown.picture();
            if (ask == TrialAsk::Zero)
                shown.button("self-test-continue").click(); // the ruler begins where the handle is
        }
        shown.page.showPart(TrialPart::Rest);
        shown.ask(TrialAsk::LetGo);
        pictures << shown.picture();
        COMPARE_SHOWN(pictures.join(QStringLiteral("--\n")), "trial-aims");
    }

    void itSaysHowFarAnExperimentIs() {
        ShownPage shown;
        TrialLook look;
        shown.page.show(look, knownDevice());
        QCOMPARE(shown.words("self-test-doing"), "");
        look.part = 0.34;
        look.runs = true;
        look.force = {0, 3, 4};
        shown.page.show(look, knownDevice());
        QCOMPARE(shown.words("self-test-doing"), "It is being measured.");
        QCOMPARE_EQ(part<QProgressBar>(shown.page, "self-test-progress").value(), 34);
        shown.page.tell(QStringLiteral("The handle is pushed to the right."));
        shown.page.show(look, knownDevice());
        QCOMPARE(shown.words("self-test-doing"), "The handle is pushed to the right.");
        shown.page.showPart(TrialPart::Motors);
        QCOMPARE(shown.words("self-test-doing"), "");
    }

    void theResultSaysWhatWasFound() {
        SelfTestResult result;
        result.resize(600, 500);
        result.show(reportOf({}));
        COMPARE_SHOWN(shownIn(result), "trial-result-nothing");
        SelfTestReport report = reportOf({{"mass", "mass at the handle", "kg", {0.1234, 0.0056}, 0.1},
                                          {"", "noise", "m", {2.34e-6, 0}, std::nullopt},
                                          {"", "way along x", "m", {0.0998, 1e-4}, 0.1},
                                          {"", "delay", "s", {0.00123, 0.00002}, 0.001},
                                          {"", "gain along x", "", {0.98765, 0.0123}, std::nullopt},
                                          {"", "nothing at all", "N", {1e-9, 1e-12}, 0.0}});
        report.faults = {"The motor of x pushes the other way; swap its wires."};
        report.leftOut = {"The weight: nothing was hung on the handle."};
        result.show(report);
        COMPARE_SHOWN(shownIn(result), "trial-result");
        auto& told = part<QLabel>(result, "self-test-told");
        result.tell(QStringLiteral("Kept."));
        QVERIFY(!told.property("limit").toBool());
        QCOMPARE(told.text(), "Kept.");
        QCOMPARE(part<QPushButton>(result, "self-test-keep").accessibleDescription(), "Kept.");
        result.tell(QStringLiteral("The folder cannot be written."), true);
        QVERIFY(told.property("limit").toBool());
        QCOMPARE(told.text(), "The folder cannot be written.");
        QCOMPARE(part<QPushButton>(result, "self-test-keep").accessibleDescription(), "Kept.");
        QSignalSpy keep(&result, &SelfTestResult::keepPressed), show(&result, &SelfTestResult::showPressed),
            save(&result, &SelfTestResult::savePressed), close(&result, &SelfTestResult::closePressed);
        for (const char* name : {"self-test-keep", "self-test-report", "self-test-save", "self-test-close"})
            part<QPushButton>(result, name).click();
        QCOMPARE((QList<int>{int(keep.count()), int(show.count()), int(save.count()), int(close.count())}),
                 (QList<int>{1, 1, 1, 1}));
    }
};

TACTUM_GUI_TEST(TestSelfTestPanels)

} // namespace test_self_test_panels

#include "test_self_test_panels.moc"
