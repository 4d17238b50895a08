// The dock of a study, and the page that a participant sees.
#include <set>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/study/study_desk.h"
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
}

TACTUM_GUI_TEST(TestStudyPanels)

} // namespace test_study_panels

#include "test_study_panels.moc"
