// A study while it runs, from the dialog that asks for the participant to the last page: what the page says,
// which keys do what, what of the window is there. Wrong itself if a step had a part of the page that its
// words do not name: the pages themselves stand in test_study_panels.
#include <QCheckBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTest>

#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/told_window.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_page.h"
#include "ui/study/study_session.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_study_runs {

using namespace tactum;

namespace {

/// Two trials of two intervals each, of which nothing is by chance.
StudyDesign design() {
    StudyDesign design;
    design.name = "Two plates";
    design.instructions = "Feel both.";
    design.procedure = Procedure::Pairs;
    design.conditions = {"soft", "stiff"};
    design.order = StudyOrder::AsListed;
    design.repeats = 2;
    design.seed = 7;
    design.questions = {{StudyQuestion::Kind::Rating, "How sure?", "guessed", "certain", 5, {}},
                        {StudyQuestion::Kind::Choice, "Which hand?", "", "", 7, {"left", "right"}},
                        {StudyQuestion::Kind::Magnitude, "How stiff?", "", "", 7, {}}};
    design.pauseSeconds = 0.01;
    design.forcesOffBetween = true;
    return design;
}

/// A window with a study of two conditions that is saved.
struct Desk {
    explicit Desk(const QString& theFolder, StudyDesign theDesign = design())
        : folder(theFolder), told(1, [](test::ToldEngine& engine) {
              engine.of[0].device.name = "Arm";
              engine.of[0].device.damping = 4;
          }) {
        testing::adopt(told.document, testing::knownScene());
        StudyDesk& desk = told.window->studyDesk();
        for (const std::string& name : theDesign.conditions) {
            if (!desk.keep(QString::fromStdString(name))) qFatal("no condition");
            told.document.setProxyRadius(told.document.scene().proxyRadius + 0.001);
        }
        desk.setDesign(theDesign);
        bool saved = false;
        desk.save(folder + QStringLiteral("/plates.tactum-study"), [&] { saved = true; });
        if (!test::waitFor([&] { return saved; })) qFatal("the study is not saved");
        told.catchUp();
    }
    StudyPage& page() const { return *told.window->findChild<StudyPage*>(); }
    StudySession& session() const { return told.window->study(); }

    /// What is done, what the page says then, and of the forces and the view.
    void note(const QString& words, const std::function<void()>& act) {
        act();
        if (!test::waitFor([&] { return !told.window->publisher().working(); })) qFatal("not published");
        told.frames(3);
        QStringList lines = page().isHidden() ? QStringList{QStringLiteral("no page")}
                                              : page().words().split(u'\n', Qt::SkipEmptyParts);
        lines << QStringLiteral("forces %1, proxy radius felt %2 mm")
                     .arg(told.engine.of[0].armed ? "on" : "off")
                     .arg(1e3 * told.engine.worlds.back()->proxyRadius);
        int on = 0;
        for (const Command& command : commands())
            on += told.command(command.id).isEnabled();
        if (const QString notice = told.window->findChild<NoticeBar*>()->text(); !notice.isEmpty())
            lines << QStringLiteral("says: ") + notice;
        int docks = 0;
        for (const auto* dock : told.window->findChildren<QDockWidget*>())
            docks += !dock->isHidden();
        lines << QStringLiteral("commands that are on: %1; panels: %2; menus %3; title \"%4\"")
                     .arg(on)
                     .arg(docks)
                     .arg(told.window->menuBar()->isHidden() ? "hidden" : "shown",
                          told.window->windowTitle());
        text += words + u'\n';
        for (const QString& line : lines)
            text += QStringLiteral("  ") + line + u'\n';
    }
    void key(Qt::Key key) {
        note(QStringLiteral("key ") + QKeySequence(key).toString(), [&] { QTest::keyClick(&page(), key); });
    }
    void run(const std::function<void(QDialog&)>& answer) {
        auto effects = told.effects();
        effects.answerNext(answer);
        note(QStringLiteral("run"), [&] { effects.choose("study-run"); });
    }

    QString folder;
    ToldWindow told;
    QString text;
};

/// Without folders and times.
QString withoutPlace(const Desk& desk) {
    static const QRegularExpression log(QStringLiteral("plates-P001[^ ]*csv"));
    QString text = desk.text;
    return text.replace(desk.folder, QStringLiteral("FOLDER")).replace(log, QStringLiteral("LOG"));
}

void accept(QDialog& dialog) {
    dialog.accept();
}

/// Up to the first question.
void toTheQuestion(Desk& desk) {
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Space, Qt::Key_Space, Qt::Key_1})
        desk.key(key);
}

} // namespace

class TestStudyRuns : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;
    QString own_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() {
        own_ = folders_.next();
        useSettingsIn(own_);
    }

    void aRunFromItsBeginningToItsEnd();
    void itIsEndedAndGoneOnWith();
    void theParticipantIsAskedFor();
    void whatGoesWrongEndsIt();
};

void TestStudyRuns::aRunFromItsBeginningToItsEnd() {
    Desk desk(own_);
    desk.run(accept);
    QVERIFY(desk.session().running());
    toTheQuestion(desk);
    desk.key(Qt::Key_9);
    desk.key(Qt::Key_4);
    desk.key(Qt::Key_2);
    auto& field = *desk.page().findChild<QLineEdit*>();
    desk.note(QStringLiteral("no number"), [&] {
        field.setText(QStringLiteral("hard"));
        QTest::keyClick(&field, Qt::Key_Return);
    });
    desk.note(QStringLiteral("a number"), [&] {
        field.setText(QStringLiteral("12.5"));
        QTest::keyClick(&field, Qt::Key_Return);
    });
    QVERIFY(test::waitFor([&] { return !desk.session().rests(); }));
    toTheQuestion(desk);
    desk.key(Qt::Key_5);
    desk.key(Qt::Key_1);
    desk.note(QStringLiteral("a number"), [&] {
        field.setText(QStringLiteral("3"));
        QTest::keyClick(&field, Qt::Key_Enter);
    });
    desk.key(Qt::Key_Space);
    QVERIFY(!desk.session().running());
    QCOMPARE_EQ(QDir(own_).entryList({QStringLiteral("plates-P001-*.csv")}).size(), 2);
    COMPARE_SHOWN(withoutPlace(desk), "study-run");
}

void TestStudyRuns::itIsEndedAndGoneOnWith() {
    {
        Desk desk(own_);
        desk.run(accept);
        toTheQuestion(desk);
        desk.text.clear();
        desk.key(Qt::Key_Escape);
        desk.key(Qt::Key_Space);
        desk.note(QStringLiteral("the window is closed"), [&] { desk.told.window->close(); });
        QVERIFY(desk.told.window->isVisible());
        desk.key(Qt::Key_E);
        QVERIFY(!desk.session().running());
        const QString words = desk.told.window->studyDesk().file();
        COMPARE_CONTAINS(words, QStringLiteral("plates"));
        COMPARE_SHOWN(withoutPlace(desk), "study-ended");
    }
    StudyDesign plain = design();
    plain.questions.clear();
    plain.forcesOffBetween = false;
    plain.pauseSeconds = 0;
    const QString apart = own_ + QStringLiteral("/plain"); // of two logs of one second neither is the newer
    QDir().mkpath(apart);
    Desk desk(apart, plain);
    desk.run(accept);
    for (const Qt::Key key :
         {Qt::Key_Space, Qt::Key_Space, Qt::Key_R, Qt::Key_Space, Qt::Key_Space, Qt::Key_2})
        desk.key(key);
    desk.key(Qt::Key_Escape);
    desk.key(Qt::Key_E);
    desk.run([](QDialog& dialog) {
        QVERIFY(dialog.findChild<QCheckBox*>()->isChecked());
        dialog.accept();
    });
    QCOMPARE_EQ(desk.session().run().number(), 2);
    desk.key(Qt::Key_Space);
    COMPARE_SHOWN(
        desk.text.replace(own_, QStringLiteral("FOLDER"))
            .replace(QRegularExpression(QStringLiteral("plates-P001[^ ]*csv")), QStringLiteral("LOG")),
        "study-gone-on");
}

void TestStudyRuns::theParticipantIsAskedFor() {
    Desk desk(own_);
    QString shown;
    desk.run([&](QDialog& dialog) {
        shown = test::shownIn(dialog);
        dialog.findChild<QSpinBox*>()->setValue(31);
        dialog.accept();
    });
    COMPARE_SHOWN(shown, "study-start");
    QCOMPARE_EQ(QDir(own_).entryList({QStringLiteral("plates-P031-*.csv")}).size(), 2);
    Desk other(own_);
    other.run([](QDialog& dialog) { dialog.reject(); });
    QVERIFY(!other.session().running());
    QVERIFY(other.page().isHidden());
}

void TestStudyRuns::whatGoesWrongEndsIt() {
    Desk desk(own_);
    desk.run(accept);
    desk.key(Qt::Key_Space);
    desk.text.clear();
    desk.note(QStringLiteral("it fails"),
              [&] { emit desk.session().failed(QStringLiteral("The disk is full.")); });
    desk.note(QStringLiteral("the page goes on"), [&] { emit desk.page().proceeded(); });
    COMPARE_SHOWN(withoutPlace(desk), "study-failed");
}

TACTUM_GUI_TEST(TestStudyRuns)

} // namespace test_study_runs

#include "test_study_runs.moc"
