// The pages of a self-test: what a person is asked and told, and what their answers say. Wrong itself if a
// page did not follow what it is given: each is asked for twice, by what is written down and by its signals.
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <QUrl>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/fake_devices.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/self_test_dialog.h"
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

/// The dialog on the screen, with an arm that does as it is told.
struct ShownDialog {
    ShownDialog() {
        dialog.show();
        if (!QTest::qWaitForWindowExposed(&dialog)) qFatal("no window");
        QObject::connect(&dialog, &SelfTestDialog::started, [this] { ++started; });
        QObject::connect(&dialog, &QDialog::finished, [this](int how) { finished << how; });
        QObject::connect(&dialog, &SelfTestDialog::keep, [this](const SelfTestReport& report) {
            kept << QString::fromStdString(report.device.name);
        });
    }
    void click(const char* name) { part<QPushButton>(dialog, name).click(); }
    QString words(const char* name) { return part<QLabel>(dialog, name).text(); }
    int page() { return dialog.findChild<QStackedWidget*>()->currentIndex(); }
    void begin() {
        click("self-test-start");
        dialog.begin(std::make_unique<FakeDevice>(arm),
                     {.rest = 0.1, .shake = 0.1, .settle = 0.1, .swings = 1, .buttons = 0.1});
    }
    bool isAsked() {
        return waitFor([&] { return part<QPushButton>(dialog, "self-test-skip").isEnabled(); });
    }
    /// Whoever leaves everything out comes to the end.
    bool comesToTheResult() {
        return waitFor([&] {
            if (auto& skip = part<QPushButton>(dialog, "self-test-skip"); skip.isEnabled()) skip.click();
            return page() == 2;
        });
    }

    std::shared_ptr<FakeDesk> arm = std::make_shared<FakeDesk>();
    SelfTestDialog dialog{QStringLiteral("Example arm"), nullptr};
    int started = 0;
    QList<int> finished;
    QStringList kept;
};

/// What is opened in a browser, instead of that.
class Opened : public QObject {
    Q_OBJECT
public:
    Opened() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "open"); }
    ~Opened() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    QStringList files;

public slots:
    void open(const QUrl& url) { files << url.toLocalFile(); }
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

    /// Takes a folder in the dialog that asks for one, or none.
    static void saveInto(ShownDialog& shown, const QString& folder) {
        QTimer::singleShot(0, qApp, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            if (folder.isEmpty()) return dialog->reject();
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(folder);
            QMetaObject::invokeMethod(dialog, "accept");
        });
        shown.click("self-test-save");
    }

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

    void theDialogSaysWhatComes() {
        ShownDialog shown;
        QString pages = shownIn(shown.dialog);
        COMPARE_SHOWN(pages, "trial-dialog");
        QCOMPARE(shown.page(), 0);
        QVERIFY(part<QPushButton>(shown.dialog, "self-test-start").hasFocus() ||
                part<QPushButton>(shown.dialog, "self-test-start").isDefault());
        shown.click("self-test-leave");
        QCOMPARE(shown.finished, QList<int>{QDialog::Rejected});
        QCOMPARE_EQ(shown.started, 0);
    }

    void aDeviceThatIsNotThereIsSaid() {
        ShownDialog shown;
        shown.click("self-test-start");
        QCOMPARE_EQ(shown.started, 1);
        QCOMPARE(shown.page(), 1);
        QCOMPARE(shown.words("self-test-part"), "The device is being made ready");
        shown.dialog.fail(QStringLiteral("It is not there."));
        QCOMPARE(shown.page(), 3);
        QCOMPARE(shown.words("self-test-failure"), "It is not there.");
        QVERIFY(shown.finished.isEmpty());
        shown.click("self-test-end");
        QCOMPARE(shown.finished, QList<int>{QDialog::Rejected});
    }

    /// Who leaves while the device is on its way leaves when it has come, and it is not begun with.
    void whoLeavesMeanwhileLeavesAfterwards() {
        for (const bool comes : {true, false}) {
            ShownDialog shown;
            shown.click("self-test-start");
            shown.dialog.reject();
            QVERIFY(shown.finished.isEmpty());
            QCOMPARE(shown.words("self-test-words"), "The forces are off. The device is being closed.");
            if (comes)
                shown.dialog.begin(std::make_unique<FakeDevice>(shown.arm), {});
            else
                shown.dialog.fail(QStringLiteral("It is not there."));
            QCOMPARE(shown.finished, QList<int>{QDialog::Rejected});
            QCOMPARE_EQ(shown.arm->made.load(), 0);
            QCOMPARE(shown.page(), 1);
        }
    }

    void aRunLeadsToItsResult() {
        QTemporaryDir folder;
        qputenv("XDG_CACHE_HOME", folder.path().toLocal8Bit());
        Opened opened;
        ShownDialog shown;
        shown.arm->go = 3;
        shown.begin();
        QVERIFY(shown.isAsked());
        COMPARE_CONTAINS(shown.words("self-test-part"), "Part 1 of 6: ");
        shown.arm->place(0.01, 0, 0);
        QVERIFY(shown.comesToTheResult());
        QCOMPARE_EQ(shown.arm->made.load(), 0); // it is closed
        auto& result = *shown.dialog.findChild<SelfTestResult*>();
        QVERIFY(result.isVisible());
        QVERIFY(!part<QPushButton>(shown.dialog, "self-test-keep").isEnabled()); // nothing was measured
        emit result.keepPressed();
        QCOMPARE(shown.kept, QStringList{QStringLiteral("Example arm")});
        shown.dialog.tellKept(QStringLiteral("They are kept."), false);
        QCOMPARE(shown.words("self-test-told"), "They are kept.");
        QVERIFY(!part<QLabel>(shown.dialog, "self-test-told").property("limit").toBool());
        shown.dialog.tellKept(QStringLiteral("They are not."), true);
        QVERIFY(part<QLabel>(shown.dialog, "self-test-told").property("limit").toBool());
        shown.click("self-test-report");
        QCOMPARE_EQ(opened.files.size(), 1);
        COMPARE_CONTAINS(opened.files[0], QStringLiteral("/self-test/report.html"));
        QVERIFY(QFileInfo::exists(opened.files[0]));
        QCOMPARE(shown.words("self-test-told"), "They are not."); // a page that came says nothing
        saveInto(shown, folder.path());
        const QString date = QString::fromStdString(selfTestDate());
        const QString place = folder.filePath(QStringLiteral("self-test-") + date);
        QCOMPARE(shown.words("self-test-told"),
                 QStringLiteral("The profile, the report and every tick are in %1.").arg(place));
        QVERIFY(!QDir(place).entryList(QDir::Files).isEmpty());
        saveInto(shown, QString());
        QCOMPARE(shown.words("self-test-told"),
                 QStringLiteral("The profile, the report and every tick are in %1.").arg(place));
        shown.click("self-test-close");
        QCOMPARE(shown.finished, QList<int>{QDialog::Accepted});
    }

    void whatEndsARunIsSaid() {
        ShownDialog silent;
        silent.arm->go = 3;
        silent.begin();
        QVERIFY(silent.isAsked());
        silent.arm->plugged = false; // nobody else would notice between two experiments
        QVERIFY(waitFor([&] { return silent.page() == 3; }));
        COMPARE_BEGINS(silent.words("self-test-failure"), "Example arm gives no readings any more");
        QVERIFY(silent.finished.isEmpty());
        ShownDialog failing;
        failing.arm->failAt = 0;
        failing.begin();
        QVERIFY(waitFor([&] { return failing.page() == 3; }));
        QCOMPARE(failing.words("self-test-failure"), "The grip did not move: pull it all the way out.");
        ShownDialog left;
        left.arm->go = 3;
        left.begin();
        QVERIFY(left.isAsked());
        left.click("self-test-cancel");
        QVERIFY(waitFor([&] { return !left.finished.isEmpty(); }));
        QCOMPARE(left.finished, QList<int>{QDialog::Rejected});
        QCOMPARE_EQ(left.arm->made.load(), 0);
    }
};

TACTUM_GUI_TEST(TestSelfTestPanels)

} // namespace test_self_test_panels

#include "test_self_test_panels.moc"
