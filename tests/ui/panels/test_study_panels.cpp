// The dock of a study, and the page that a participant sees.
#include <set>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include "core/study/study_file.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_dialog.h"
#include "ui/study/study_page.h"
#include "ui/study/study_panel.h"

namespace test_study_panels {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

StudyDesign abx() {
    StudyDesign design;
    design.name = "Clay";
    design.procedure = Procedure::Abx;
    design.conditions = {"glazed", "bare"};
    design.repeats = 8;
    design.questions = {{StudyQuestion::Kind::Rating, "How sure?", "guessed", "certain", 5, {}}};
    return design;
}

StudyRun begun(const StudyDesign& design, std::uint64_t seed = 1) {
    auto run = StudyRun::begin(design, 1, seed);
    if (!run) qFatal("%s", run.error().text.c_str());
    return *run;
}

constexpr StudyMoment kFelt{.felt = true};

/// What the page says at each step of a trial.
QStringList saidIn(StudyPage& page, StudyRun& run) {
    QStringList said;
    const std::size_t done = run.done().size();
    if (run.step() == StudyStep::Instructions) run.proceed();
    while (run.step() == StudyStep::Stimulus) {
        page.display(run, kFelt);
        said << page.words() << shownIn(page);
        run.proceed();
    }
    page.display(run, {});
    said << page.words() << shownIn(page);
    if (!run.choose(0) || !run.reply("3") || run.done().size() != done + 1) qFatal("the trial did not end");
    return said;
}

/// A design in which no member is what it comes with.
StudyDesign written() {
    StudyDesign design = abx();
    design.instructions = "Feel, then choose.";
    design.order = StudyOrder::Balanced;
    design.seed = 17;
    design.prompt = "Which is harder?";
    design.questions = {{StudyQuestion::Kind::Rating, "How rough?", "smooth", "rough", 5, {}},
                        {StudyQuestion::Kind::Choice, "Which hand?", "", "", 7, {"left", "right"}},
                        {StudyQuestion::Kind::Magnitude, "How stiff?", "", "", 7, {}},
                        {StudyQuestion::Kind::Text, "What was it like?", "", "", 7, {}}};
    design.stimulusSeconds = 3.5;
    design.pauseSeconds = 1.5;
    design.again = false;
    design.forcesOffBetween = true;
    design.view = StudyView::Frozen;
    design.touchEvery = 4;
    design.staircase.surface = "lid";
    design.staircase.object = "Box";
    return design;
}

/// Each member, as a study's file has it.
QStringList linesOf(const StudyDesign& design) {
    return QString::fromStdString(designText(design)).split(u'\n');
}

/// What the dialog gives after a person did something in it and pressed OK, or nothing where that cannot be
/// pressed.
std::optional<StudyDesign> asked(const StudyDesign& design, const std::function<void(QDialog&)>& act) {
    QTimer::singleShot(0, qApp, [&] {
        auto& dialog = *qobject_cast<QDialog*>(QApplication::activeModalWidget());
        act(dialog);
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        ok->isEnabled() ? ok->click() : dialog.reject();
    });
    return askForDesign(nullptr, design, {knownScene(), knownScene()});
}

/// One step of what a person can do with a field; false for what is none.
bool turn(QWidget& field) {
    if (auto* line = qobject_cast<QLineEdit*>(&field)) {
        line->setText(line->text() + QStringLiteral("1"));
    } else if (auto* text = qobject_cast<QPlainTextEdit*>(&field)) {
        text->appendPlainText(QStringLiteral("text | And more?"));
    } else if (auto* combo = qobject_cast<QComboBox*>(&field)) {
        combo->setCurrentIndex((combo->currentIndex() + 1) % combo->count());
    } else if (auto* spin = qobject_cast<QSpinBox*>(&field)) {
        spin->stepUp();
    } else if (auto* number = qobject_cast<QDoubleSpinBox*>(&field)) {
        number->stepUp();
    } else if (auto* tick = qobject_cast<QCheckBox*>(&field)) {
        tick->click();
    } else {
        return false;
    }
    return true;
}

} // namespace

class TestStudyPanels : public QObject {
    Q_OBJECT

private slots:
    static void initMain() { namePanelTest("study"); }
    static void initTestCase() { speakEnglish(); }

    void thePageLooksLikeThis();
    void thePageTellsNothing();
    void keysAreAnswers();
    void theDockLooksLikeThis();
    void theSummarySaysWhatIsMissing();
    void theDialogLooksLikeThis();
    void theDialogKeepsWhatItIsGiven();
    void eachFieldOfTheDialogChangesItsMemberAlone();
    void aQuestionThatIsNoneIsSaid();
};

void TestStudyPanels::thePageLooksLikeThis() {
    StudyPage page;
    StudyRun run = begun(abx());
    page.display(run, {});
    COMPARE_SHOWN(shownIn(page), "study-welcome");
    run.proceed();
    page.display(run, kFelt);
    QVERIFY(page.leavesView());
    COMPARE_SHOWN(shownIn(page), "study-stimulus");
    page.display(run, {.felt = true, .forces = false});
    COMPARE_CONTAINS(page.words(), QStringLiteral("The forces are off"));
    page.display(run, {.lift = true});
    COMPARE_CONTAINS(page.words(), QStringLiteral("Lift off"));
    for (int i = 0; i < 3; ++i)
        run.proceed();
    page.display(run, {});
    QVERIFY(!page.leavesView());
    COMPARE_SHOWN(shownIn(page), "study-choice");
    VERIFY_RESULT(run.choose(0));
    page.display(run, {});
    COMPARE_SHOWN(shownIn(page), "study-rating");
}

/// Every trial says the same, whatever A, B and X are in it.
void TestStudyPanels::thePageTellsNothing() {
    StudyPage page;
    StudyRun run = begun(abx());
    std::set<std::pair<int, int>> ways;
    QStringList first;
    while (run.step() != StudyStep::Done) {
        ways.insert({run.trial().intervals[0].condition, *run.trial().right});
        const QStringList said = saidIn(page, run);
        if (first.isEmpty()) first = said;
        QCOMPARE(said, first);
        for (const QString& words : said)
            for (const char* told : {"glazed", "bare"})
                COMPARE_LACKS(words, QLatin1String(told));
    }
    QCOMPARE(ways.size(), std::size_t(4)); // each was there
}

void TestStudyPanels::keysAreAnswers() {
    StudyPage page;
    QSignalSpy chosen(&page, &StudyPage::chosen), again(&page, &StudyPage::againWanted),
        replied(&page, &StudyPage::replied), ended(&page, &StudyPage::endWanted),
        proceeded(&page, &StudyPage::proceeded);
    StudyRun run = begun(abx());
    page.display(run, {});
    QTest::keyClick(&page, Qt::Key_Return);
    QCOMPARE(proceeded.size(), 1);
    for (int i = 0; i < 4; ++i)
        run.proceed();
    page.display(run, {});
    QTest::keyClick(&page, Qt::Key_Space); // is no answer
    QTest::keyClick(&page, Qt::Key_R);
    QTest::keyClick(&page, Qt::Key_B);
    QCOMPARE(proceeded.size(), 1);
    QCOMPARE(again.size(), 1);
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen[0][0].toInt(), 1);
    VERIFY_RESULT(run.choose(1));
    page.display(run, {});
    QTest::keyClick(&page, Qt::Key_6); // beyond the scale
    QTest::keyClick(&page, Qt::Key_5);
    QCOMPARE(replied.size(), 1);
    QCOMPARE(replied[0][0].toString(), QStringLiteral("5"));
    QTest::keyClick(&page, Qt::Key_Escape);
    COMPARE_CONTAINS(page.words(), QStringLiteral("End the study?"));
    QTest::keyClick(&page, Qt::Key_Space);
    COMPARE_CONTAINS(page.words(), QStringLiteral("How sure?"));
    QCOMPARE(ended.size(), 0);
    QTest::keyClick(&page, Qt::Key_Escape);
    QTest::keyClick(&page, Qt::Key_E);
    QCOMPARE(ended.size(), 1);
}

void TestStudyPanels::theDockLooksLikeThis() {
    Document document;
    adopt(document, knownScene());
    StudyDesk desk(document);
    StudyPanel panel(desk);
    panel.show();
    COMPARE_SHOWN(shownIn(panel), "study-dock-empty");
    QVERIFY(desk.keep(QStringLiteral("glazed")));
    QVERIFY(desk.keep(QStringLiteral("bare")));
    desk.setDesign(abx());
    QCOMPARE(desk.study().design.conditions, abx().conditions);
    COMPARE_SHOWN(shownIn(panel), "study-dock");
    QCOMPARE(panel.chosen(), 1);
    auto& list = part<QTreeWidget>(panel, "study-conditions");
    list.topLevelItem(0)->setText(0, QStringLiteral("bare")); // is taken
    QCOMPARE(list.topLevelItem(0)->text(0), QStringLiteral("glazed"));
    list.topLevelItem(0)->setText(0, QStringLiteral("wet"));
    QCOMPARE(desk.study().design.conditions[0], std::string("wet"));
}

void TestStudyPanels::theSummarySaysWhatIsMissing() {
    StudyDesign design = abx();
    COMPARE_CONTAINS(summaryOf(design), QStringLiteral("8 trials, about 3 min")); // 8 (3 * 4 + 2 * 3) s
    design.conditions.pop_back();
    COMPARE_CONTAINS(summaryOf(design), QStringLiteral("the procedure needs 2"));
    const QString nothing = QStringLiteral("Nothing is asked of the participant");
    design.questions.clear();
    COMPARE_LACKS(summaryOf(design), nothing); // they choose
    design.procedure = Procedure::List;
    COMPARE_CONTAINS(summaryOf(design), nothing);
    design.questions = abx().questions;
    COMPARE_LACKS(summaryOf(design), nothing);
}

void TestStudyPanels::theDialogLooksLikeThis() {
    QStringList first;
    for (const auto& [procedure, name] : {std::pair(Procedure::Abx, "study-dialog"),
                                          {Procedure::List, "study-dialog-list"},
                                          {Procedure::Staircase, "study-dialog-staircase"}}) {
        StudyDesign design = written();
        design.procedure = procedure;
        QString shown;
        asked(design, [&](const QDialog& dialog) { shown = shownIn(dialog); });
        const QStringList now = shown.split(u'\n');
        COMPARE_SHOWN(first.isEmpty() ? shown : changedLines(first, now), name);
        if (first.isEmpty()) first = now;
    }
}

void TestStudyPanels::theDialogKeepsWhatItIsGiven() {
    for (const Procedure procedure :
         {Procedure::List, Procedure::Pairs, Procedure::Abx, Procedure::Staircase}) {
        StudyDesign design = written();
        design.procedure = procedure;
        const auto same = asked(design, [](const QDialog&) {});
        QVERIFY(same);
        QCOMPARE(linesOf(*same), linesOf(design));
        QVERIFY(*same == design);
    }
    // Millimetres in the fields are metres in the study.
    StudyDesign small = written();
    small.procedure = Procedure::Staircase;
    small.staircase.object.clear();
    small.staircase.surface.clear();
    small.staircase.parameter = "proxy-radius";
    small.staircase.reference = 1e-3;
    small.staircase.start = 5e-4;
    small.staircase.smallest = 1e-4;
    small.staircase.largest = 2e-3;
    small.staircase.steps = {2e-4, 1e-4};
    const auto same = asked(small, [](const QDialog&) {});
    QVERIFY(same);
    QCOMPARE(linesOf(*same), linesOf(small));
}

void TestStudyPanels::eachFieldOfTheDialogChangesItsMemberAlone() {
    StudyDesign design = written();
    design.procedure = Procedure::Staircase;
    const QStringList before = linesOf(design);
    QStringList names;
    asked(design, [&](const QDialog& dialog) {
        for (const auto* each : dialog.findChildren<QWidget*>())
            if (each->objectName().startsWith(QStringLiteral("study-"))) names << each->objectName();
    });
    QString text;
    for (const QString& name : names) {
        bool field = false;
        const auto now =
            asked(design, [&](const QDialog& dialog) { field = turn(*dialog.findChild<QWidget*>(name)); });
        if (!field) continue;
        text += name + (now ? QStringLiteral("\n") : QStringLiteral(" is refused\n"));
        if (now) text += changedLines(before, linesOf(*now));
    }
    COMPARE_SHOWN(text, "study-dialog-edits");
}

void TestStudyPanels::aQuestionThatIsNoneIsSaid() {
    QString said;
    const auto none = asked(abx(), [&](const QDialog& dialog) {
        dialog.findChild<QPlainTextEdit*>(QStringLiteral("study-questions"))
            ->setPlainText(QStringLiteral("\n  \nguess | How?"));
        said = dialog.findChild<QLabel*>(QStringLiteral("study-dialog-summary"))->text();
    });
    QVERIFY(!none); // it cannot be pressed
    QCOMPARE(said, "questions: \"guess | How?\" begins with no kind; write it as in the examples");
}

TACTUM_GUI_TEST(TestStudyPanels)

} // namespace test_study_panels

#include "test_study_panels.moc"
