// What is told in one line or in a list: notices, events, the state of the loops, scenes that were not saved.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/told_engine.h"
#include "ui/engine/shared_link.h"
#include "ui/panels/connection_bar.h"
#include "ui/panels/event_list.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/history_list.h"
#include "ui/panels/recent_list.h"
#include "ui/panels/sample_gallery.h"
#include "ui/panels/selection_count.h"
#include "ui/panels/start_page.h"
#include "ui/panels/status_strip.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/picture_card.h"
#include "ui/widgets/tool_strip.h"

namespace test_notices {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

HealthEvent eventAt(int second, bool fault, const char* what) {
    return {QTime(12, 34, second), fault, QString::fromUtf8(what),
            QStringLiteral("%1. Do <this>.").arg(QString::fromUtf8(what))};
}

DeviceInfo arm() {
    DeviceInfo info;
    info.name = "Arm";
    info.maxForce = 6;
    info.rate = 1000;
    return info;
}

ServoTelemetry servoTelemetry() {
    ServoTelemetry servo;
    servo.force = {0, 3, 4};
    servo.rate = 998.7;
    servo.jitterMicros = 12.4;
    servo.misses = 15;
    servo.machineMisses = 12;
    servo.periods.count = {900, 90, 9, 1, 0, 0, 0, 0, 0, 0, 0, 0};
    servo.heat = 0.42;
    servo.energy = 0.4e-3;
    return servo;
}

ProxyTelemetry proxyTelemetry() {
    ProxyTelemetry proxy;
    proxy.rate = 1998;
    proxy.updateMicros = 7.25;
    return proxy;
}

QLabel& label(QWidget& in, const char* name) {
    auto* found = in.findChild<QLabel*>(QLatin1String(name));
    if (!found) qFatal("no label %s", name);
    return *found;
}

} // namespace

class TestNotices : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumNotices"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    void noticesAreShownUntilTheyAreOver() {
        NoticeBar bar;
        COMPARE_SHOWN(shownIn(bar), "notice-none");
        QCOMPARE(bar.text(), "");
        bar.showError(QStringLiteral("It failed."));
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.text(), "It failed.");
        COMPARE_SHOWN(shownIn(bar), "notice-error");
        bar.showNote(QStringLiteral("It is done."));
        COMPARE_SHOWN(shownIn(bar), "notice-note");
        bar.endProgress(); // a message stays
        QVERIFY(bar.isVisible());
        bar.showProgress(QStringLiteral("Opening"), 0.25, -1, false);
        COMPARE_SHOWN(shownIn(bar), "notice-progress");
        bar.showProgress(QStringLiteral("Opening"), 0.5, 30, true);
        COMPARE_SHOWN(shownIn(bar), "notice-progress-cancel");
        QSignalSpy cancelled(&bar, &NoticeBar::cancelled);
        bar.findChild<QPushButton*>(QStringLiteral("notice-cancel"))->click();
        QCOMPARE(cancelled.size(), 1);
        bar.endProgress();
        QCOMPARE(bar.text(), "It is done."); // nobody had time to read it
        bar.hide();
        bar.showProgress(QStringLiteral("Opening"), 0.25, -1, false);
        bar.endProgress();
        QVERIFY(bar.isHidden());
        QCOMPARE(bar.text(), "");
        bar.showError(QStringLiteral("Again."));
        bar.findChild<QToolButton*>()->click();
        QVERIFY(bar.isHidden());
    }

    void anOfferIsDoneOnceAndTakenBack() {
        NoticeBar bar;
        int done = 0;
        bool hiddenThen = false;
        const auto act = [&] {
            ++done;
            hiddenThen = bar.isHidden();
        };
        bar.offer(QStringLiteral("Removed."), QStringLiteral("note"), QStringLiteral("Undo"), act);
        COMPARE_SHOWN(shownIn(bar), "notice-offer");
        auto& button = *bar.findChild<QPushButton*>(QStringLiteral("notice-act"));
        button.click();
        QCOMPARE(done, 1);
        QVERIFY(hiddenThen); // it may show something itself
        bar.showNote(QStringLiteral("Something else"));
        button.click(); // what is hidden does nothing more
        QCOMPARE(done, 1);
        bar.offer(QStringLiteral("Removed."), QStringLiteral("note"), QStringLiteral("Undo"), act);
        bar.withdraw(QStringLiteral("Redo"));
        QVERIFY(bar.isVisible());
        bar.withdraw(QStringLiteral("Undo"));
        QVERIFY(bar.isHidden());
        bar.offer(QStringLiteral("Removed."), QStringLiteral("note"), QStringLiteral("Undo"), act);
        bar.showProgress(QStringLiteral("Opening"), 0.25, -1, false);
        QVERIFY(button.isHidden());
        bar.endProgress();
        button.click(); // it is there again
        QCOMPARE(done, 2);
        bar.offer(QStringLiteral("Removed."), QStringLiteral("note"), QStringLiteral("Undo"), act);
        bar.showProgress(QStringLiteral("Opening"), 0.25, -1, false);
        bar.withdraw(QStringLiteral("Undo")); // from behind the progress
        bar.endProgress();
        QVERIFY(bar.isHidden());
        bar.offer(QStringLiteral("Removed."), QStringLiteral("error"), QStringLiteral("Undo"), act);
        bar.showError(QStringLiteral("Other"));
        bar.withdraw(QStringLiteral("Undo")); // it is not shown any more
        QVERIFY(bar.isVisible());
        QCOMPARE(done, 2);
    }

    void eventsAreListed() {
        EventList list;
        list.resize(300, 200);
        COMPARE_SHOWN(shownIn(list), "events-none");
        COMPARE_CONTAINS(drawnBy(*list.viewport()), "\"Nothing has taken the force away so far.");
        list.setEvents({eventAt(56, true, "Too fast"), eventAt(7, false, "Detail left out")});
        COMPARE_SHOWN(shownIn(list), "events");
        COMPARE_LACKS(drawnBy(*list.viewport()), "Nothing has taken");
        const auto* first = list.topLevelItem(0);
        list.setEvents({eventAt(56, true, "Too fast"), eventAt(7, false, "Detail left out")});
        QCOMPARE(list.topLevelItem(0), first); // the same: nothing is made anew
        list.setEvents({eventAt(57, true, "Too fast"), eventAt(7, false, "Detail left out")});
        COMPARE_BEGINS(list.topLevelItem(0)->text(0), QStringLiteral("12:34:57"));
        list.setEvents({eventAt(57, true, "Stall"), eventAt(7, false, "Detail left out")});
        COMPARE_CONTAINS(list.topLevelItem(0)->text(0), "Stall");
        QCOMPARE(list.sizeHint(), QSize(200, 96));
    }

    /// A narrower list needs higher rows.
    void sentencesAreWrapped() {
        EventList list;
        list.resize(600, 200);
        list.setEvents(
            {eventAt(1, false, "a sentence of quite a few words that has no room in a narrow list at all")});
        list.show();
        QVERIFY(QTest::qWaitForWindowExposed(&list));
        const int low = list.topLevelItem(0)->sizeHint(0).height();
        list.resize(200, 200);
        QTRY_VERIFY(list.topLevelItem(0)->sizeHint(0).height() > 2 * low - 16);
    }

    void stepsOfTheHistory() {
        QUndoStack steps;
        HistoryList list(steps);
        for (const char* step : {"one", "two", "three"})
            steps.push(new QUndoCommand(QLatin1String(step)));
        steps.undo();
        COMPARE_SHOWN(shownIn(list), "history");
        QCOMPARE(list.model()->rowCount(), 4);
        QCOMPARE(list.model()->index(0, 0).data().toString(), "As opened");
        QCOMPARE(list.currentIndex().row(), 2);
        steps.redo();
        list.setCurrentIndex(list.model()->index(2, 0));
        QCOMPARE(steps.index(), 2); // a click goes there
    }

    void theHealthOfTheLoops() {
        HealthPanel panel;
        panel.resize(1000, 240);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.display(servoTelemetry(), proxyTelemetry(), arm());
        panel.displayCeiling({1200, QStringLiteral("limited by the hand")}, {800, QStringLiteral("lid")},
                             false);
        panel.setEvents({eventAt(1, true, "Stall")});
        COMPARE_SHOWN(shownIn(panel), "health");
        ServoTelemetry servo = servoTelemetry();
        servo.rate = 10500;
        servo.energy = -1; // it took some: nothing was given
        servo.passivityDamping = 2.25;
        servo.periods.count = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
        servo.heat = 0.9;
        ProxyTelemetry proxy = proxyTelemetry();
        proxy.fidelity = Fidelity::NoShading;
        proxy.stepsDown = 3;
        panel.display(servo, proxy, arm());
        panel.displayCeiling({1200, QStringLiteral("limited by the hand")}, {}, true);
        COMPARE_SHOWN(shownIn(panel), "health-troubled");
        proxy.stepsDown = 1;
        panel.display(servo, proxy, arm());
        COMPARE_CONTAINS(label(panel, "health-fidelity").text(), " Lowered once.");
        proxy = proxyTelemetry();
        panel.display(servoTelemetry(), proxy, arm());
        COMPARE_LACKS(label(panel, "health-fidelity").text(), "Lowered");
        QCOMPARE(label(panel, "health-fidelity").property("limit").toBool(), false);
        QCOMPARE(label(panel, "health-damping").property("limit").toBool(), false);
        QCOMPARE(panel.minimumSizeHint(), QSize(200, 96));
    }

    void theHealthOfARecording() {
        HealthPanel panel;
        panel.setRecorded(true);
        panel.display(servoTelemetry(), proxyTelemetry(), arm());
        COMPARE_SHOWN(shownIn(panel), "health-recorded");
        panel.setRecorded(false);
        QVERIFY(panel.findChild<QCheckBox*>()->isEnabled());
    }

    /// The box is what was decided, and not what was clicked.
    void theCeilingIsOverriddenByWhoeverDecides() {
        HealthPanel panel;
        auto& box = *panel.findChild<QCheckBox*>(QStringLiteral("health-override"));
        QSignalSpy asked(&panel, &HealthPanel::overrideAsked);
        box.click();
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toBool(), true);
        QVERIFY(!box.isChecked());
        panel.displayCeiling({1200, {}}, {}, true);
        QVERIFY(box.isChecked());
        box.click();
        QCOMPARE(asked[1][0].toBool(), false);
        QVERIFY(box.isChecked());
    }

    /// As many sections side by side as there is room for.
    void sectionsAreArranged() {
        HealthPanel panel;
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        const auto columnsAt = [&](int width) {
            panel.resize(width + 2 * panel.frameWidth(), 1200);
            QApplication::processEvents();
            QSet<int> columns;
            for (const char* name :
                 {"health-servo", "health-spread", "health-energy", "health-ceiling", "health-events"}) {
                auto* section = panel.findChild<QWidget*>(QLatin1String(name));
                while (section->parentWidget() != panel.widget())
                    section = section->parentWidget();
                columns << section->x();
            }
            return columns.size();
        };
        // Sections of 156 pixels, 16 between them, 12 at the edges.
        QCOMPARE(columnsAt(24 + 5 * 156 + 4 * 16), 5);
        QCOMPARE(columnsAt(24 + 5 * 156 + 4 * 16 - 1), 4);
        QCOMPARE(columnsAt(24 + 2 * 156 + 16), 2);
        QCOMPARE(columnsAt(24 + 2 * 156 + 16 - 1), 1);
        QCOMPARE(columnsAt(2000), 5);
    }

    void theStateInOneLine() {
        StatusStrip strip;
        strip.resize(1400, 40);
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        ProxyTelemetry proxy = proxyTelemetry();
        strip.display(proxy, servoTelemetry(), arm());
        COMPARE_SHOWN(shownIn(strip), "status-recorded");
        strip.setFault(QStringLiteral("The finger was let go."), QStringLiteral("Arm again"));
        COMPARE_SHOWN(shownIn(strip), "status-fault");
        strip.setFault({});
        COMPARE_SHOWN(shownIn(strip).replace(QStringLiteral(" .fault=false"), QString()), "status-recorded");
        QSignalSpy armed(&strip, &StatusStrip::armPressed), stopped(&strip, &StatusStrip::stopPressed);
        auto& stop = *strip.findChild<QPushButton*>(QStringLiteral("stop"));
        stop.setEnabled(true);
        stop.click();
        strip.findChild<QPushButton*>(QStringLiteral("arm-again"))->click();
        QCOMPARE(armed.size(), 1);
        QCOMPARE(stopped.size(), 1);
    }

    /// What comes first where several have something to say, and what is read of a touch.
    void theStateAfterWhatHappens() {
        ToldEngine engine;
        HandReport& hand = engine.of[0];
        hand.device = arm();
        hand.servo = servoTelemetry();
        engine.proxyTold = proxyTelemetry();
        StatusStrip strip;
        strip.resize(1600, 40);
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        strip.display(engine);
        States states(shownIn(strip));
        const auto then = [&](const char* what, const auto& act) {
            act();
            strip.display(engine);
            states.note(QString::fromLatin1(what), shownIn(strip));
        };
        then("armed", [&] { hand.armed = true; });
        then("the mouse is over something", [&] { strip.setHovered(QStringLiteral("lid: 500 N/m")); });
        then("it is touched", [&] { engine.proxyTold.output.contacts = 2; });
        then("it has a name", [&] { strip.setTouched(QStringLiteral("lid")); });
        then("there is less force", [&] { strip.setQuietNote(QStringLiteral("Less force: it is warm.")); });
        then("a fault", [&] { strip.setFault(QStringLiteral("It stopped."), QStringLiteral("Arm again")); });
        then("not armed", [&] { hand.armed = false; });
        then("another hand pushes", [&] { strip.setOthersPush(true); });
        then("the fault is gone", [&] { strip.setFault({}); });
        then("let go", [&] { engine.proxyTold.output.contacts = 0; });
        then("no less force", [&] { strip.setQuietNote({}); });
        then("over nothing", [&] { strip.setHovered({}); });
        then("the loops have ended", [&] { engine.runs = false; });
        then("no other hand", [&] { strip.setOthersPush(false); });
        COMPARE_SHOWN(states.text(), "status-states");
    }

    /// Who took a file off the list by the keyboard goes on with the one that came to its place.
    void theListKeepsTheKeysAtTheirPlace() {
        RecentList list;
        QList<RecentFile> files;
        for (const char* name : {"/a.glb", "/b.glb", "/c.glb"}) {
            files << RecentFile();
            files.back().path = QLatin1String(name);
        }
        list.setFiles(files);
        list.show();
        QVERIFY(QTest::qWaitForWindowExposed(&list));
        QApplication::setActiveWindow(&list);
        const auto place = [&] {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the cards of before
            const auto cards = list.findChildren<PictureCard*>();
            for (qsizetype i = 0; i < cards.size(); ++i)
                if (cards[i]->hasFocus()) return int(i);
            return -1;
        };
        list.findChildren<PictureCard*>()[1]->setFocus();
        files.removeAt(1);
        list.setFiles(files);
        QCOMPARE(place(), 1);
        files.removeLast();
        list.setFiles(files);
        QCOMPARE(place(), 0);
        list.setFocusPolicy(Qt::StrongFocus);
        list.setFocus();
        list.setFiles(files); // the keys are elsewhere
        QCOMPARE(place(), -1);
        list.setFiles({});
        QVERIFY(list.isHidden());
    }

    void progressSaysHowLongItTakes_data() {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<QString>("words");
        QTest::newRow("not known") << -1.0 << "Opening";
        QTest::newRow("now") << 0.0 << "Opening - about 1 s left";
        QTest::newRow("soon") << 2.4 << "Opening - about 2 s left";
        QTest::newRow("later") << 75.0 << "Opening - about 75 s left";
        QTest::newRow("much later") << 600.0 << "Opening - about 10 min left";
    }
    void progressSaysHowLongItTakes() {
        QFETCH(double, seconds);
        NoticeBar bar;
        bar.showProgress(QStringLiteral("Opening"), 0.5, seconds, true);
        QTEST(label(bar, "notice-text").text(), "words");
    }

    void contactsInWords_data() {
        QTest::addColumn<int>("contacts");
        QTest::addColumn<QString>("each"); // f: no friction, s: slips, h: holds
        QTest::addColumn<QString>("words");
        const auto row = [](int contacts, const char* each, const char* words) {
            QTest::addRow("%d %s", contacts, each)
                << contacts << QString::fromUtf8(each) << QString::fromUtf8(words);
        };
        row(0, "", "free");
        row(1, "f", "1 contact");
        row(2, "ff", "2 contacts");
        row(1, "s", "1 contact \u00b7 slip");
        row(1, "h", "1 contact \u00b7 stick");
        row(2, "fs", "2 contacts \u00b7 slip");
        row(2, "fh", "2 contacts \u00b7 stick");
        row(2, "sh", "2 contacts \u00b7 stick");
        row(3, "sss", "3 contacts \u00b7 slip");
    }

    void contactsInWords() {
        QFETCH(int, contacts);
        QFETCH(QString, each);
        QFETCH(QString, words);
        ProxyTelemetry proxy;
        proxy.output.contacts = contacts;
        for (int i = 0; i < contacts; ++i) {
            ContactReport& contact = proxy.output.contact[std::size_t(i)];
            contact.frictionless = each[i] == u'f';
            contact.slipping = each[i] == u's';
        }
        StatusStrip strip;
        strip.display(proxy, {}, arm());
        QCOMPARE(label(strip, "status-contacts").text(), words);
    }

    void ratesInWords() {
        StatusStrip strip;
        ServoTelemetry servo;
        for (const auto& [rate, words] : {std::pair(0.0, "servo 0 Hz"),
                                          {999.6, "servo 1000 Hz"},
                                          {9949.0, "servo 9949 Hz"},
                                          {9950.0, "servo 9.9 kHz"},
                                          {12340.0, "servo 12.3 kHz"}}) {
            servo.rate = rate;
            strip.display(ProxyTelemetry(), servo, arm());
            if (rate != 9950.0) QCOMPARE(label(strip, "status-servo").text(), words);
            if (rate == 9950.0) COMPARE_CONTAINS(label(strip, "status-servo").text(), "kHz");
        }
    }

    void theStripOfATool() {
        ToolStrip strip;
        QAction size(QStringLiteral("&Size")), large(QStringLiteral("Paint &large")),
            small(QStringLiteral("Paint &small"));
        size.setObjectName(QStringLiteral("size"));
        size.setToolTip(QStringLiteral("How large"));
        size.setCheckable(true);
        for (QAction* each : {&large, &small})
            each->setCheckable(true);
        large.setToolTip(QStringLiteral("Much"));
        small.setToolTip(QStringLiteral("Little"));
        small.setChecked(true);
        strip.addLabel(QStringLiteral("Brush"));
        strip.addChoices(QStringLiteral("How much"), {&large, &small},
                         {QStringLiteral("Large"), QStringLiteral("Small")});
        strip.addAction(&size);
        strip.addGap();
        strip.addField(new QLabel(QStringLiteral("field")));
        COMPARE_SHOWN(shownIn(strip), "tool-strip");
        auto& list = *strip.findChild<QComboBox*>();
        auto& button = *strip.findChild<QToolButton*>(QStringLiteral("size-button"));
        QSignalSpy largeDone(&large, &QAction::triggered), sizeDone(&size, &QAction::triggered);
        emit list.activated(0);
        QCOMPARE(largeDone.size(), 1);
        QVERIFY(large.isChecked());
        QCOMPARE(list.currentIndex(), 0);
        small.setChecked(false);
        QCOMPARE(list.currentIndex(), 0); // what goes off says nothing
        small.setChecked(true);
        QCOMPARE(list.currentIndex(), 1);
        button.click();
        QCOMPARE(sizeDone.size(), 1);
        QVERIFY(size.isChecked());
        QVERIFY(button.isChecked());
        size.setEnabled(false);
        QVERIFY(!button.isEnabled());
        size.setChecked(false);
        QVERIFY(!button.isChecked());
        // What has no room goes on below; words stay beside what they name.
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        const auto topOf = [&](const QWidget& of) { return of.mapTo(&strip, of.rect().center()).y(); };
        const auto& word = *strip.findChild<QLabel*>();
        strip.resize(3000, strip.height());
        const int row = strip.height();
        QCOMPARE(row, strip.sizeHint().height());
        QCOMPARE_LT(std::abs(topOf(button) - topOf(list)), 2);
        strip.resize(strip.sizeHint().width() - 1, strip.height());
        QCOMPARE_GT(strip.height(), row);
        QCOMPARE_LT(std::abs(topOf(word) - topOf(list)), 2);
        strip.resize(word.width() + list.width() + 30, strip.height());
        QCOMPARE_LT(std::abs(topOf(word) - topOf(list)), 2);
        QCOMPARE_GT(topOf(button) - topOf(list), 10);
        for (const QWidget* each : {static_cast<const QWidget*>(&word), static_cast<const QWidget*>(&list),
                                    static_cast<const QWidget*>(&button)})
            QVERIFY(strip.rect().contains(QRect(each->mapTo(&strip, QPoint()), each->size())));
    }

    void theStartPage() {
        QTemporaryDir folder;
        for (const char* name :
             {"b-second.glb", "b-second.png", "a-first-one.glb", "a-first-one.png", "lonely.glb", "c.png"}) {
            QFile file(folder.filePath(QLatin1String(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        const QStringList samples = samplesIn(folder.path());
        QCOMPARE(samples.size(), 2);
        QVERIFY(samples[0].endsWith(QStringLiteral("/a-first-one.glb")));
        QVERIFY(samples[1].endsWith(QStringLiteral("/b-second.glb")));
        StartPage page(samples);
        page.recent().setFiles({{QDir::homePath() + QStringLiteral("/models/cup.obj"),
                                 QDateTime(QDate(2025, 3, 1), QTime(9, 30))},
                                {QStringLiteral("/other/tea.glb"), {}}});
        const auto plain = [&] {
            return shownIn(page)
                .replace(folder.path(), QStringLiteral("FOLDER"))
                .replace(QDir::homePath() + u'/', QStringLiteral("HOME/"))
                .replace(QFileInfo(folder.path()).canonicalFilePath(), QStringLiteral("FOLDER"));
        };
        COMPARE_SHOWN(plain(), "start");
        QSignalSpy chosen(&page, &StartPage::fileChosen), open(&page, &StartPage::openRequested);
        page.findChild<QPushButton*>(QStringLiteral("start-open"))->click();
        QCOMPARE(open.size(), 1);
        page.findChild<QToolButton*>(QStringLiteral("sample-b-second"))->click();
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(chosen[0][0].toString(), samples[1]);
        page.findChild<QToolButton*>(QStringLiteral("recent-tea.glb"))->click();
        QCOMPARE(chosen.size(), 2);
        QCOMPARE(chosen[1][0].toString(), "/other/tea.glb");
        page.recent().setFiles({});
        COMPARE_LACKS(plain(), "cup.obj");
        StartPage bare({});
        QVERIFY(!bare.findChild<SampleGallery*>());
    }

    /// As many in a row as fit, then the next row.
    void samplesStandInRows() {
        QStringList files;
        for (int i = 0; i < 7; ++i)
            files << QStringLiteral("/none/s%1.glb").arg(i);
        SampleGallery gallery(files);
        gallery.resize(600, 400);
        COMPARE_SHOWN(shownIn(gallery), "gallery");
    }

    void theServersBarSaysWhoEdits() {
        ConnectionBar bar;
        QVERIFY(bar.isHidden());
        QSignalSpy wanted(&bar, &ConnectionBar::penWanted);
        auto& ask = part<QPushButton>(bar, "connection-ask");
        struct Case {
            SharedState state;
            const char *text, *severity;
            bool asks;
        };
        for (const Case& each :
             {Case{{"host", false, false, "", "", 0, false},
                   "Not connected to host: no force",
                   "error",
                   false},
              {{"host", false, true, "", "", 2, false}, "Not connected to host: no force", "error", false},
              {{"host", true, true, "me", "", 1, false}, "Haptic server host, you edit", "note", false},
              {{"host", true, false, "", "", 1, false}, "Haptic server host, nobody edits", "note", true},
              {{"host", true, false, "<b>Ann", "", 1, false},
               "Haptic server host, <b>Ann edits",
               "note",
               true},
              {{"host", true, false, "Ann", "", 2, false},
               "Haptic server host, 2 clients, Ann edits",
               "note",
               true}}) {
            bar.display(each.state);
            QVERIFY(!bar.isHidden());
            QCOMPARE(bar.text(), each.text);
            QCOMPARE(bar.property("severity").toString(), each.severity);
            QCOMPARE_EQ(!ask.isHidden(), each.asks);
        }
        ask.click();
        QCOMPARE_EQ(wanted.count(), 1);
        COMPARE_SHOWN(shownIn(bar), "connection");
    }

    // A plate is a square of 100 square centimetres in two triangles.
    void theCountSaysHowMuchIsSelected() {
        Document document;
        adopt(document, knownScene());
        SelectionCount count(document);
        QCOMPARE(count.text(), "");
        const auto says = [&](const char* text) {
            (void)waitFor([&] { return count.text() == QString::fromUtf8(text); });
            QCOMPARE(count.text(), text);
        };
        document.select({{1, 0}});
        says("2 triangles, 100 cm\u00b2");
        document.select({{1, 0}, {1, 1}, {2, 0}});
        says("6 triangles, 300 cm\u00b2");
        document.selectFaces({1, {0}});
        says("1 triangle, 50.0 cm\u00b2"); // before whole surfaces
        document.selectFaces({});
        says("6 triangles, 300 cm\u00b2");
        document.select({});
        says("");
        for (const SurfaceRef& ref : {SurfaceRef{1, 0}, {2, 0}}) // the second while the first is counted
            document.select({ref}, SelectMode::Add);
        says("4 triangles, 200 cm\u00b2");
    }
};

TACTUM_GUI_TEST(TestNotices)

} // namespace test_notices

#include "test_notices.moc"
