// A study in the window, from nothing to its logs: by real events, with a participant who answers by what is
// felt.
#include <cmath>
#include <map>
#include <set>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/study/study_desk.h"
#include "ui/study/study_page.h"
#include "ui/study/study_session.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_study {

using namespace tactum;

namespace {

using Row = std::map<QString, QString>;

/// Does something in the next dialog, as a person does, and agrees to it.
template <class Do> void inDialog(Do act) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        timer->stop();
        act(*dialog);
        timer->deleteLater();
        QTest::keyClick(dialog, Qt::Key_Return);
    });
    timer->start(20);
}

template <class T> T& in(QWidget& window, const char* name) {
    auto* found = window.findChild<T*>(QString::fromLatin1(name));
    if (!found) qFatal("no %s", name);
    return *found;
}

/// Rows of a file without quotes, by their columns.
std::vector<Row> tableOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) qWarning("no file %s", qPrintable(path));
    std::vector<Row> rows;
    const QStringList names = QString::fromUtf8(file.readLine()).trimmed().split(u',');
    while (!file.atEnd()) {
        const QStringList cells = QString::fromUtf8(file.readLine()).remove(u'\n').split(u',');
        Row& row = rows.emplace_back();
        for (int i = 0; i < int(std::min(names.size(), cells.size())); ++i)
            row[names[i]] = cells[i];
    }
    return rows;
}

QStringList logsIn(const QDir& folder, const char* kind) {
    QStringList paths;
    for (const QString& name :
         folder.entryList({QLatin1Char('*') + QLatin1String(kind)}, QDir::Files, QDir::Name))
        paths << folder.filePath(name);
    return paths;
}

/// Every word that can be read in the window.
QString wordsIn(QWidget& window) {
    QStringList words{window.windowTitle()};
    for (const auto* label : window.findChildren<QLabel*>())
        if (label->isVisible()) words << label->text();
    for (const auto* button : window.findChildren<QAbstractButton*>())
        if (button->isVisible()) words << button->text();
    return words.join(u'\n');
}

/// A participant before the window.
class Participant {
public:
    explicit Participant(TouchedWindow& program) : program_(program) {}

    StudySession& study() { return program_.window->study(); }
    StudyStep step() { return study().run().step(); }
    StudyPage& page() { return in<StudyPage>(*program_.window, "study-page"); }
    void key(Qt::Key key) {
        // Nobody has the keys for a moment after a dialog.
        if (test::waitFor([] { return QApplication::focusWidget() != nullptr; }))
            QTest::keyClick(QApplication::focusWidget(), key);
    }

    /// Past what comes before the next stimulus, until that is felt.
    bool toStimulus() {
        if (step() == StudyStep::Instructions && !test::waitFor([this] {
                key(Qt::Key_Space);
                return step() != StudyStep::Instructions;
            }))
            return false;
        return test::waitFor([this] { return step() == StudyStep::Stimulus && study().felt(); });
    }

    /// The force of a press in the middle of the view, when it has settled; N.
    double feel() {
        const QPoint at = program_.centre();
        program_.press(at);
        double force = 0;
        (void)program_.fullForce();
        (void)test::waitFor([&] { return program_.touch().contacts > 0; });
        (void)program_.atRest();
        force = program_.engine.servo().force.norm();
        program_.release(at);
        (void)test::waitFor([&] { return program_.touch().contacts == 0; });
        return force;
    }

private:
    TouchedWindow& program_;
};

/// Through the intervals of a trial without a touch, and back: one picture for all of them.
bool looksTheSame(TouchedWindow& program, Participant& participant) {
    QImage first;
    bool same = true;
    for (int interval = 0; interval < 3; ++interval) {
        if (!participant.toStimulus() || !program.atRest()) return false;
        const QImage picture = program.window->view().grabPicture();
        if (first.isNull()) first = picture;
        same = same && picture == first && !picture.isNull();
        participant.key(Qt::Key_Space);
    }
    participant.key(Qt::Key_R);
    return same && participant.step() == StudyStep::Stimulus && participant.study().run().interval() == 0;
}

void makeAllFeel(TouchedWindow& program, const QString& stiffness) {
    program.command("select-all").trigger();
    program.type(QStringLiteral("stiffness"), stiffness);
}

void keepAs(TouchedWindow& program, const QString& name) {
    inDialog([name](QDialog& dialog) {
        auto* line = dialog.findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, name);
    });
    program.command("study-keep").trigger();
}

/// Through the dialog about the run, which was asked for.
void agreeToRun(TouchedWindow& program, int participant) {
    inDialog(
        [participant](QDialog& dialog) { in<QSpinBox>(dialog, "study-participant").setValue(participant); });
    program.command("study-run").trigger();
}

/// A study of two states, kept and saved without a dialog.
bool makeSmallStudy(TouchedWindow& program, const QString& file,
                    const std::function<void(StudyDesign&)>& change) {
    StudyDesk& desk = program.window->studyDesk();
    makeAllFeel(program, QStringLiteral("200"));
    bool kept = desk.keep(QStringLiteral("soft"));
    makeAllFeel(program, QStringLiteral("700"));
    kept = desk.keep(QStringLiteral("stiff")) && kept;
    StudyDesign design = desk.study().design;
    change(design);
    desk.setDesign(design);
    QSignalSpy saved(&desk, &StudyDesk::changed);
    desk.save(file);
    return kept && test::waitFor([&] { return !saved.isEmpty() && !desk.modified(); });
}

} // namespace

class TestStudy : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        useSettingsIn(folder_->path());
    }

    void anAbxFromNothingToItsLogs();
    void aStaircaseOverAParameter();
    void aStaircaseOverTheHeightOfALayer();
    void aRunThatBrokeOffGoesOn();
    void questionsAreAskedAndLogged();
    void whatIsNotSavedIsNotLost();
};

void TestStudy::anAbxFromNothingToItsLogs() {
    constexpr int kTrials = 6;
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    makeAllFeel(program, QStringLiteral("150"));
    keepAs(program, QStringLiteral("soft"));
    COMPARE_CONTAINS(program.window->findChild<NoticeBar*>()->text(),
                     QStringLiteral("condition of the study: soft"));
    makeAllFeel(program, QStringLiteral("600"));
    keepAs(program, QStringLiteral("stiff"));
    inDialog([](QDialog& dialog) {
        in<QComboBox>(dialog, "study-kind").setCurrentIndex(int(Procedure::Abx));
        // It goes onto a small screen: what has no room is scrolled to.
        const QSize least = dialog.minimumSizeHint(), all = dialog.sizeHint();
        QCOMPARE_LE(2 * least.width(), all.width());
        QCOMPARE_LE(3 * least.height(), 2 * all.height());
        in<QSpinBox>(dialog, "study-repeats").setValue(kTrials);
    });
    program.command("study-edit").trigger();
    QCOMPARE(trialsOf(program.window->studyDesk().study().design), kTrials);
    const Scene before = program.document.scene();
    const int steps = program.document.history().count();
    const auto* inspector = program.window->findChild<QDockWidget*>(QStringLiteral("dock-inspector"));
    QVERIFY(inspector->isVisible());

    answerFileDialog(folder_->filePath(QStringLiteral("cube.tactum-study")));
    QSignalSpy saved(&program.window->studyDesk(), &StudyDesk::changed);
    program.command("study-save").trigger();
    QTRY_VERIFY(!saved.isEmpty() && !program.window->studyDesk().modified());
    agreeToRun(program, 7);
    Participant participant(program);
    QVERIFY(participant.study().running());
    QVERIFY(!inspector->isVisible());
    QVERIFY(!program.window->menuBar()->isVisible());
    QVERIFY(!program.engine.armed());

    std::map<int, QString> seen; // by interval
    const auto see = [&](int interval) {
        const QString words = wordsIn(*program.window);
        const auto [first, isNew] = seen.try_emplace(interval, words);
        QCOMPARE(words, first->second); // the same whatever is felt
        QVERIFY2(!words.contains(program.document.title()), qPrintable(words));
    };
    std::vector<std::array<double, 3>> felt;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::array<double, 3>& forces = felt.emplace_back();
        if (trial == 0) QVERIFY(looksTheSame(program, participant));
        for (int interval = 0; interval < 3; ++interval) {
            QVERIFY(participant.toStimulus());
            QCOMPARE(participant.study().run().interval(), interval);
            QVERIFY(participant.page().leavesView());
            see(interval);
            forces[std::size_t(interval)] = participant.feel();
            QCOMPARE_GT(forces[std::size_t(interval)], 0.1);
            participant.key(Qt::Key_Space);
        }
        QCOMPARE(participant.step(), StudyStep::Choice);
        see(3);
        const bool isA = std::abs(forces[2] - forces[0]) < std::abs(forces[2] - forces[1]);
        participant.key(isA ? Qt::Key_A : Qt::Key_B);
    }
    for (const auto& [interval, words] : seen) {
        for (const char* told : {"soft", "stiff", "150", "600", " N"})
            COMPARE_LACKS(words, QLatin1String(told));
    }
    QCOMPARE(participant.step(), StudyStep::Done);
    QVERIFY(!program.engine.armed());
    participant.key(Qt::Key_Space);
    QVERIFY(!participant.study().running());
    QVERIFY(inspector->isVisible());
    QVERIFY(program.window->menuBar()->isVisible());
    QVERIFY(program.document.scene() == before);
    QCOMPARE(program.document.history().count(), steps);

    const QStringList answers = logsIn(QDir(folder_->path()), "-answers.csv"),
                      touches = logsIn(QDir(folder_->path()), "-touch.csv");
    QCOMPARE(answers.size(), 1);
    QCOMPARE(touches.size(), 1);
    COMPARE_CONTAINS(answers[0], QStringLiteral("cube-P007-"));
    std::vector<Row> rows = tableOf(answers[0]);
    QCOMPARE(rows.size(), std::size_t(kTrials));
    for (int trial = 0; trial < kTrials; ++trial) {
        Row& row = rows[std::size_t(trial)];
        QCOMPARE(row[QStringLiteral("participant")], QStringLiteral("7"));
        QCOMPARE(row[QStringLiteral("correct")], QStringLiteral("1")); // four times as stiff is felt
        QCOMPARE(row[QStringLiteral("faults")], QStringLiteral("0"));
        const bool stiffFirst = row[QStringLiteral("condition_1")] == QLatin1String("stiff");
        QCOMPARE(felt[std::size_t(trial)][0] > felt[std::size_t(trial)][1], stiffFirst);
        QCOMPARE_LT(row[QStringLiteral("begun_1_s")].toDouble(), row[QStringLiteral("begun_2_s")].toDouble());
        QCOMPARE_LT(row[QStringLiteral("begun_3_s")].toDouble(),
                    row[QStringLiteral("answered_s")].toDouble());
        QCOMPARE_GT(row[QStringLiteral("reaction_ms")].toDouble(), 0);
    }
    // The largest force of an interval in the log is at least the one that was felt at rest.
    std::map<std::pair<int, int>, double> largest;
    for (Row& row : tableOf(touches[0])) {
        const Vec3 force(row[QStringLiteral("force_x_N")].toDouble(),
                         row[QStringLiteral("force_y_N")].toDouble(),
                         row[QStringLiteral("force_z_N")].toDouble());
        double& most =
            largest[{row[QStringLiteral("trial")].toInt(), row[QStringLiteral("interval")].toInt()}];
        most = std::max(most, force.norm());
    }
    QCOMPARE(largest.size(), std::size_t(3 * kTrials));
    for (const auto& [place, most] : largest)
        QCOMPARE_GE(most + 0.01, felt[std::size_t(place.first - 1)][std::size_t(place.second - 1)]);
}

void TestStudy::aStaircaseOverAParameter() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    QVERIFY(
        makeSmallStudy(program, folder_->filePath(QStringLiteral("s.tactum-study")), [](StudyDesign& design) {
            design.procedure = Procedure::Staircase;
            design.staircase.reference = 300;
            design.staircase.start = 200;
            design.staircase.steps = {100, 50};
            design.staircase.reversals = design.staircase.used = 2;
        }));
    agreeToRun(program, 1);
    Participant participant(program);
    const auto stiffness = [&] {
        return program.window->publisher().world()->scene->objects[0].surfaces[0].material.stiffness;
    };
    QList<double> levels;
    // Always right, so down by two; then always wrong, so up: the first reversal; right again: the second.
    for (int trial = 0; participant.study().running() && participant.step() != StudyStep::Done; ++trial) {
        std::array<double, 2> values{};
        for (double& value : values) {
            QVERIFY(participant.toStimulus());
            QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
            value = stiffness();
            participant.key(Qt::Key_Space);
        }
        levels << std::max(values[0], values[1]) - 300;
        QCOMPARE(std::min(values[0], values[1]), 300.0);
        const bool first = values[0] > values[1], wrong = trial == 2;
        participant.key(first != wrong ? Qt::Key_1 : Qt::Key_2);
    }
    QCOMPARE(levels, (QList<double>{200, 200, 100, 150, 150}));
    participant.key(Qt::Key_Space);
    const auto rows = tableOf(logsIn(QDir(folder_->path()), "-answers.csv").value(0));
    QCOMPARE(rows.size(), std::size_t(5));
    QStringList reversals;
    for (Row row : rows)
        reversals << row[QStringLiteral("reversal")];
    QCOMPARE(reversals.join(u' '), QStringLiteral("0 0 1 0 1"));
}

/// Two layers on each side of a cube. Of the front the lower one is bent, by its height, and nothing else.
void TestStudy::aStaircaseOverTheHeightOfALayer() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    program.command("select-all").trigger();
    for (const char* layer : {"layer-grooves", "layer-dots"})
        program.command(layer).trigger();
    QVERIFY(program.window->studyDesk().keep(QStringLiteral("grooved")));
    QString unit;
    inDialog([&unit](QDialog& dialog) {
        auto& kind = in<QComboBox>(dialog, "study-kind");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_End);
        // Down through the list, past the headings, as far as the height of the lowest layer.
        auto& parameter = in<QComboBox>(dialog, "study-parameter");
        parameter.setFocus();
        for (int i = 0;
             i < parameter.count() && parameter.currentText() != QLatin1String("Layer 1: Height (mm)"); ++i)
            QTest::keyClick(&parameter, Qt::Key_Down);
        QCOMPARE(parameter.currentText(), QStringLiteral("Layer 1: Height (mm)"));
        auto& surface = in<QComboBox>(dialog, "study-surface");
        surface.setFocus();
        for (int i = 0; i < surface.count() && surface.currentText() != QLatin1String("front"); ++i)
            QTest::keyClick(&surface, Qt::Key_Down);
        unit = in<QDoubleSpinBox>(dialog, "study-reference").suffix();
        const auto type = [&](const char* name, const QString& value) {
            auto& box = in<QDoubleSpinBox>(dialog, name);
            box.setFocus();
            box.selectAll();
            QTest::keyClicks(&box, value);
        };
        type("study-reference", QStringLiteral("0.1"));
        type("study-largest", QStringLiteral("0.3"));
        type("study-start", QStringLiteral("0.3"));
    });
    program.command("study-edit").trigger();
    QCOMPARE(unit, QStringLiteral(" mm"));
    const StaircaseRule& rule = program.window->studyDesk().study().design.staircase;
    QCOMPARE(rule.parameter, std::string("layers[0].height"));
    QCOMPARE(rule.surface, std::string("front"));
    COMPARE_NEAR(rule.reference, 1e-4, 1e-12, "m");
    COMPARE_NEAR(rule.start, 3e-4, 1e-12, "m");
    QSignalSpy saved(&program.window->studyDesk(), &StudyDesk::changed);
    program.window->studyDesk().save(folder_->filePath(QStringLiteral("s.tactum-study")));
    QTRY_VERIFY(!saved.isEmpty() && !program.window->studyDesk().modified());
    const Scene condition = program.window->studyDesk().study().conditions[0];
    const std::vector<Surface>& sides = condition.objects[0].surfaces;
    const auto front = std::size_t(std::ranges::find(sides, "front", &Surface::name) - sides.begin());
    agreeToRun(program, 1);
    Participant participant(program);
    std::set<double> heights;
    for (int interval = 0; interval < 2; ++interval) {
        QVERIFY(participant.toStimulus());
        QVERIFY(test::waitFor([&] { return program.caughtUp(); }));
        Scene felt = *program.window->publisher().world()->scene;
        double& height = felt.objects[0].surfaces[front].layers[0].strength;
        heights.insert(std::round(1e7 * height));
        height = sides[front].layers[0].strength;
        QVERIFY(felt == condition);
        (void)participant.feel();
        participant.key(Qt::Key_Space);
    }
    QCOMPARE(heights, (std::set<double>{1000, 4000})); // 0.1 mm, and 0.3 above it
    participant.key(Qt::Key_1);
    participant.key(Qt::Key_Escape);
    participant.key(Qt::Key_E);
    QVERIFY(!participant.study().running());
    auto answers = tableOf(logsIn(QDir(folder_->path()), "-answers.csv").value(0));
    QCOMPARE(answers.size(), std::size_t(1));
    QCOMPARE(answers[0][QStringLiteral("parameter")], QStringLiteral("layers[0].height"));
    QCOMPARE(answers[0][QStringLiteral("unit")], QStringLiteral("m"));
    // The touch says what was touched, of which stimulus, and in which World.
    std::map<QString, std::set<QString>> seen; // revisions by value
    bool pushed = false;
    for (Row& row : tableOf(logsIn(QDir(folder_->path()), "-touch.csv").value(0))) {
        QCOMPARE(row[QStringLiteral("condition")], QStringLiteral("grooved"));
        QCOMPARE(row[QStringLiteral("hand")], QStringLiteral("1"));
        seen[row[QStringLiteral("value")]].insert(row[QStringLiteral("scene_revision")]);
        if (row[QStringLiteral("contacts")].toInt() == 0) continue;
        QCOMPARE(row[QStringLiteral("object")].toStdString(), condition.objects[0].name);
        const std::string side = row[QStringLiteral("surface")].toStdString();
        QVERIFY(std::ranges::find(sides, side, &Surface::name) != sides.end());
        QVERIFY(row[QStringLiteral("friction")] != QLatin1String("none"));
        pushed |=
            row[QStringLiteral("gain")].toDouble() == 1 && row[QStringLiteral("normal_N")].toDouble() > 0.1;
    }
    QVERIFY(pushed);
    QCOMPARE(seen.size(), std::size_t(2));
    QVERIFY(seen.begin()->second != seen.rbegin()->second);
}

void TestStudy::aRunThatBrokeOffGoesOn() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    QVERIFY(
        makeSmallStudy(program, folder_->filePath(QStringLiteral("s.tactum-study")), [](StudyDesign& design) {
            design.procedure = Procedure::Pairs;
            design.repeats = 4;
        }));
    Participant participant(program);
    const auto answerOne = [&] {
        for (int interval = 0; interval < 2; ++interval) {
            if (!participant.toStimulus()) return false;
            participant.key(Qt::Key_Space);
        }
        participant.key(Qt::Key_2);
        return true;
    };
    agreeToRun(program, 3);
    QVERIFY(answerOne());
    QVERIFY(participant.toStimulus());
    participant.key(Qt::Key_Escape);
    COMPARE_CONTAINS(participant.page().words(), QStringLiteral("End the study?"));
    participant.key(Qt::Key_Space);
    QVERIFY(participant.study().running());
    program.window->close(); // asks as well
    QVERIFY(program.window->isVisible());
    participant.key(Qt::Key_E);
    QVERIFY(!participant.study().running());
    const QString log = logsIn(QDir(folder_->path()), "-answers.csv").value(0);
    QCOMPARE(tableOf(log).size(), std::size_t(1));

    // Half a row of a crash.
    QFile torn(log);
    QVERIFY(torn.open(QIODevice::Append));
    torn.write("1.0,Study,half");
    torn.close();
    bool offered = false;
    inDialog([&offered](QDialog& dialog) {
        in<QSpinBox>(dialog, "study-participant").setValue(3);
        offered = in<QCheckBox>(dialog, "study-go-on").isChecked();
    });
    program.command("study-run").trigger();
    QVERIFY(offered);
    QCOMPARE(participant.study().run().number(), 2);
    for (int trial = 2; trial <= 4; ++trial)
        QVERIFY(answerOne());
    QCOMPARE(participant.step(), StudyStep::Done);
    participant.key(Qt::Key_Space);
    QCOMPARE(logsIn(QDir(folder_->path()), "-answers.csv"), QStringList{log});
    auto rows = tableOf(log);
    QCOMPARE(rows.size(), std::size_t(4));
    for (Row& row : rows)
        QCOMPARE(row[QStringLiteral("seed")], rows[0][QStringLiteral("seed")]);
    // Nothing is left to go on with, and the next run has files of its own.
    QVERIFY(!brokenOff(
        program.window->studyDesk().study().design,
        std::filesystem::path(folder_->filePath(QStringLiteral("s.tactum-study")).toStdU16String()), 3));
}

void TestStudy::questionsAreAskedAndLogged() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    QVERIFY(
        makeSmallStudy(program, folder_->filePath(QStringLiteral("s.tactum-study")), [](StudyDesign& design) {
            design.instructions = "Touch the cube.";
            design.stimulusSeconds = 0.2;
            design.pauseSeconds = 0.1;
            design.forcesOffBetween = true;
            design.view = StudyView::Hidden;
            design.questions = {{StudyQuestion::Kind::Rating, "How rough?", "smooth", "rough", 7, {}},
                                {StudyQuestion::Kind::Choice, "Which hand?", {}, {}, 7, {"left", "right"}},
                                {StudyQuestion::Kind::Magnitude, "How stiff?", {}, {}, 7, {}},
                                {StudyQuestion::Kind::Text, "Why?", {}, {}, 7, {}}};
        }));
    agreeToRun(program, 1);
    Participant participant(program);
    COMPARE_CONTAINS(participant.page().words(), QStringLiteral("Touch the cube."));
    for (int trial = 0; trial < 2; ++trial) {
        if (trial == 1) {
            QTRY_VERIFY(participant.step() == StudyStep::Pause && !participant.study().rests());
            QVERIFY(!program.engine.armed());
            participant.key(Qt::Key_Space); // the forces come on by a person
        }
        QVERIFY(participant.toStimulus());
        QVERIFY(!participant.page().leavesView());
        QTRY_VERIFY(participant.step() == StudyStep::Question); // the stimulus ends by itself
        QVERIFY(!program.engine.armed());
        participant.key(Qt::Key_5);
        participant.key(Qt::Key_2);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("none"));
        participant.key(Qt::Key_Return);
        QCOMPARE(participant.step(), StudyStep::Question);
        COMPARE_CONTAINS(in<QLabel>(*program.window, "study-note").text(), QStringLiteral("number above 0"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("12.5"));
        participant.key(Qt::Key_Return);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("it felt so"));
        participant.key(Qt::Key_Return);
    }
    QVERIFY(participant.study().running()); // the Return of the last answer is not that of the last page
    QCOMPARE(participant.step(), StudyStep::Done);
    participant.key(Qt::Key_Space);
    auto rows = tableOf(logsIn(QDir(folder_->path()), "-answers.csv").value(0));
    QCOMPARE(rows.size(), std::size_t(2));
    for (Row& row : rows) {
        QCOMPARE(row[QStringLiteral("q1")], QStringLiteral("5"));
        QCOMPARE(row[QStringLiteral("q2")], QStringLiteral("right"));
        QCOMPARE(row[QStringLiteral("q3")], QStringLiteral("12.5"));
        QCOMPARE(row[QStringLiteral("q4")], QStringLiteral("it felt so"));
    }
}

void TestStudy::whatIsNotSavedIsNotLost() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    StudyDesk& desk = program.window->studyDesk();
    QVERIFY(desk.keep(QStringLiteral("one")));
    QVERIFY(!desk.keep(QStringLiteral("one")));
    QVERIFY(!desk.keep(QStringLiteral(" ")));
    program.command("study-new").trigger();
    QCOMPARE(desk.study().conditions.size(), std::size_t(1));
    COMPARE_CONTAINS(program.window->findChild<NoticeBar*>()->text(), QStringLiteral("has not been saved"));
    program.window->close();
    QVERIFY(program.window->isVisible());
    // A condition comes back into the scene as one step.
    makeAllFeel(program, QStringLiteral("123"));
    const int steps = program.document.history().count();
    program.command("study-show").trigger();
    QCOMPARE(program.document.history().count(), steps + 1);
    QVERIFY(program.document.scene() == desk.study().conditions[0]);
    program.document.history().undo();
    program.command("study-replace").trigger();
    QCOMPARE(desk.study().conditions[0].objects[0].surfaces[0].material.stiffness, 123.0);
    desk.begin();
}

TACTUM_GUI_TEST(TestStudy)

} // namespace test_study

#include "test_study.moc"
