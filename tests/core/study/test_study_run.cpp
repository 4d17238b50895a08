// A run of a study: its steps, what it refuses, and how it goes on after a crash.
#include <utility>

#include <QTest>

#include "core/study/stimulus.h"
#include "core/study/study_run.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_study_run {

using namespace tactum;
using namespace tactum::test;

namespace {

StudyDesign askingDesign() {
    StudyDesign design = designOf(Procedure::Abx, {"soft", "stiff"}, 3);
    design.pauseSeconds = 1;
    design.questions.resize(4);
    design.questions[0].text = "How sure are you?";
    design.questions[1] = {StudyQuestion::Kind::Choice, "Hand?", {}, {}, 7, {"left", "right"}};
    design.questions[2] = {StudyQuestion::Kind::Magnitude, "How hard?", {}, {}, 7, {}};
    design.questions[3] = {StudyQuestion::Kind::Text, "Why?", {}, {}, 7, {}};
    return design;
}

StudyRun begun(const StudyDesign& design) {
    auto run = StudyRun::begin(design, 1, 1);
    if (!run) qFatal("%s", run.error().text.c_str());
    run->proceed();
    return *run;
}

void throughIntervals(StudyRun& run) {
    while (run.step() == StudyStep::Stimulus || run.step() == StudyStep::Pause)
        run.proceed();
}

Surface called(const char* name) {
    Surface surface;
    surface.name = name;
    return surface;
}

} // namespace

class TestStudyRun : public QObject {
    Q_OBJECT

private slots:
    void aTrialIsItsSteps();
    void intervalsAreFeltAgain();
    void answersAreChecked();
    void aListHasNothingToChoose();
    void aRunGoesOn();
    void answersOfAnotherStudyAreRefused();
    void designsAreChecked_data();
    void designsAreChecked();
    void eachTextHasItsLimit();
    void aStimulusChangesWhatItNames();
    void aStaircaseBendsALayer();
    void levelsKeepToTheRangeOfWhatIsBent();
};

void TestStudyRun::aTrialIsItsSteps() {
    auto run = StudyRun::begin(askingDesign(), 2, 9);
    VERIFY_RESULT(run);
    QCOMPARE(run->step(), StudyStep::Instructions);
    for (int trial = 1; trial <= 3; ++trial) {
        for (int interval = 0; interval < 3; ++interval) {
            run->proceed(); // what came before
            QCOMPARE(run->step(), StudyStep::Stimulus);
            QCOMPARE(run->interval(), interval);
            QCOMPARE(run->number(), trial);
        }
        run->proceed();
        QCOMPARE(run->step(), StudyStep::Choice);
        run->proceed();
        QCOMPARE(run->step(), StudyStep::Choice); // only an answer ends it
        VERIFY_RESULT(run->choose(0));
        for (const char* words : {"3", "left", "12.5", "because, \"well\""}) {
            QCOMPARE(run->step(), StudyStep::Question);
            VERIFY_RESULT(run->reply(words));
        }
        QCOMPARE(run->step(), trial == 3 ? StudyStep::Done : StudyStep::Pause);
        const DoneTrial& done = run->done().back();
        QCOMPARE(done.correct, std::optional(done.trial.right == 0));
        QCOMPARE(done.answer.answers[3], std::string("because, \"well\""));
    }
    QCOMPARE(run->done().size(), std::size_t(3));
}

void TestStudyRun::intervalsAreFeltAgain() {
    StudyRun run = begun(askingDesign());
    QVERIFY(!run.feelAgain(0)); // X was not felt yet
    throughIntervals(run);
    QVERIFY(run.feelAgain(1));
    QCOMPARE(run.step(), StudyStep::Stimulus);
    QCOMPARE(run.interval(), 1);
    QVERIFY(!run.feelAgain(3));
    StudyDesign design = askingDesign();
    design.again = false;
    StudyRun once = begun(design);
    throughIntervals(once);
    QVERIFY(!once.feelAgain(1));
}

void TestStudyRun::answersAreChecked() {
    StudyRun run = begun(askingDesign());
    COMPARE_CONTAINS(refusal(run.choose(0)), "feel the stimuli first");
    throughIntervals(run);
    COMPARE_CONTAINS(refusal(run.choose(2)), "no such choice");
    COMPARE_CONTAINS(refusal(run.choose(-1)), "no such choice");
    COMPARE_CONTAINS(refusal(run.reply("1")), "Nothing is asked");
    VERIFY_RESULT(run.choose(1));
    for (const char* words : {"0", "8", "3.5", "", "nan", "99999999999999999999"})
        COMPARE_CONTAINS(refusal(run.reply(words)), "from 1 to 7");
    VERIFY_RESULT(run.reply("7"));
    COMPARE_CONTAINS(refusal(run.reply("foot")), "none of the choices");
    VERIFY_RESULT(run.reply("right"));
    for (const char* words : {"0", "-1", "hard", "inf"})
        COMPARE_CONTAINS(refusal(run.reply(words)), "above 0");
    VERIFY_RESULT(run.reply("1e3"));
    VERIFY_RESULT(run.reply("one\nline"));
    COMPARE_LACKS(run.done().back().answer.answers[3], "\n");
}

void TestStudyRun::aListHasNothingToChoose() {
    StudyRun run = begun(designOf(Procedure::List, {"a", "b"}));
    run.proceed();
    QCOMPARE(run.done().size(), std::size_t(1));
    QVERIFY(!run.done()[0].correct);
    run.proceed();
    QCOMPARE(run.step(), StudyStep::Done);
    run.proceed();
    QCOMPARE(run.done().size(), std::size_t(2));
}

/// A staircase that broke off is at the same level, with the same interval to come, as one that did not.
void TestStudyRun::aRunGoesOn() {
    const StudyDesign design = staircaseOf(2);
    StudyRun whole = begun(design);
    std::vector<TrialAnswer> answers;
    for (int trial = 0; trial < 30; ++trial) {
        throughIntervals(whole);
        VERIFY_RESULT(whole.choose(trial % 5 == 3 ? 0 : 1));
        answers.push_back(whole.done().back().answer);
    }
    const auto again = StudyRun::resume(design, 1, 1, answers);
    VERIFY_RESULT(again);
    QCOMPARE(again->number(), 31);
    QCOMPARE(again->step(), StudyStep::Instructions);
    QVERIFY(again->trial() == whole.trial());
    QCOMPARE(again->threshold()->mean, whole.threshold()->mean);
    QVERIFY(!StudyRun::resume(design, 1, 2, answers)->trial().intervals.empty());
}

void TestStudyRun::answersOfAnotherStudyAreRefused() {
    const StudyDesign design = askingDesign();
    const std::vector<TrialAnswer> missing{{0, {"1", "left", "1"}}}, wrong{{0, {"9", "left", "1", ""}}},
        none{{{}, {"1", "left", "1", ""}}}, beyond(9, {0, {"1", "left", "1", ""}});
    for (const auto& answers : {missing, wrong, none, beyond})
        COMPARE_CONTAINS(refusal(StudyRun::resume(design, 1, 1, answers)), "begin a new run");
}

void TestStudyRun::designsAreChecked_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<QString>("says");
    const char* says[] = {
        "the study has none",    "the procedure needs 2",  "two are called",       "has no name",
        "repeats is 0",          "balanced is for a list", "there is none called", "leave the range",
        "one is not above 0",    "staircase.start is",     "2 to 9 choices",       "steps of a rating is 1",
        "stimulusSeconds is -1", "more than 10000 trials", "longer than 4000",     "staircase.used is"};
    for (int i = 0; i < int(std::size(says)); ++i)
        QTest::newRow(says[i]) << i << QString::fromLatin1(says[i]);
}

void TestStudyRun::designsAreChecked() {
    QFETCH(int, which);
    QFETCH(QString, says);
    StudyDesign design = askingDesign();
    if (which >= 6 && which <= 9) design = staircaseOf(2);
    if (which == 15) design = staircaseOf(2);
    const std::function<void()> faults[] = {
        [&] { design.name = " "; },
        [&] { design.conditions.pop_back(); },
        [&] { design.conditions[1] = "soft"; },
        [&] { design.conditions[1].clear(); },
        [&] { design.repeats = 0; },
        [&] { design.order = StudyOrder::Balanced; },
        [&] { design.staircase.parameter = "warmth"; },
        [&] { design.staircase.largest = 1e9; },
        [&] {
            design.staircase.steps = {1, 0};
        },
        [&] { design.staircase.start = 41; },
        [&] { design.questions[1].choices.pop_back(); },
        [&] { design.questions[0].steps = 1; },
        [&] { design.stimulusSeconds = -1; },
        [&] {
            design.repeats = 1000;
            for (int i = 0; i < 5; ++i)
                design.conditions.push_back(std::to_string(i));
        },
        [&] { design.prompt = std::string(4001, 'a'); },
        [&] { design.staircase.used = 45; },
    };
    VERIFY_RESULT(check(design));
    faults[which]();
    COMPARE_CONTAINS(QString::fromStdString(refusal(check(design))), says);
    COMPARE_CONTAINS(refusal(StudyRun::begin(design, 1, 1)), says.toStdString());
}

void TestStudyRun::eachTextHasItsLimit() {
    StudyDesign design = askingDesign();
    for (std::string* text :
         {&design.name, &design.instructions, &design.prompt, &design.staircase.surface,
          &design.staircase.object, &design.conditions[0], &design.questions[0].text,
          &design.questions[0].low, &design.questions[0].high, &design.questions[1].choices[0]}) {
        const std::string before = std::exchange(*text, std::string(4000, 'a'));
        VERIFY_RESULT(check(design));
        *text += 'a';
        COMPARE_CONTAINS(refusal(check(design)), "longer than 4000 bytes");
        *text = before;
    }
}

void TestStudyRun::aStimulusChangesWhatItNames() {
    Scene scene;
    SceneObject object;
    object.surfaces = {called("lid"), called("floor")};
    scene.add(object);
    StaircaseRule rule;
    rule.surface = "lid";
    const Scene one = sceneOf(scene, rule, {0, 1234.});
    QCOMPARE(one.objects[0].surfaces[0].material.stiffness, 1234.0);
    QCOMPARE(one.objects[0].surfaces[1].material.stiffness, kStiffness.initial);
    QVERIFY(sceneOf(scene, rule, {0, {}}) == scene);
    QVERIFY(sameShapes(one, scene));
    Scene moved = scene;
    moved.objects[0].pose.translation.x() = 0.01;
    QVERIFY(!sameShapes(moved, scene));
    rule.surface.clear();
    QCOMPARE(sceneOf(scene, rule, {0, 10.}).objects[0].surfaces[1].material.stiffness, 10.0);
    VERIFY_RESULT(checkStaircase(scene, rule));
    rule.surface = "handle";
    COMPARE_CONTAINS(refusal(checkStaircase(scene, rule)), "no \"stiffness\" of a surface \"handle\"");
}

void TestStudyRun::aStaircaseBendsALayer() {
    Scene scene;
    SceneObject object;
    object.name = "box";
    object.surfaces = {called("lid"), called("floor")};
    for (Surface& surface : object.surfaces)
        surface.layers.resize(2);
    scene.add(object);
    object.id = 0, object.name = "plate";
    scene.add(object);
    StaircaseRule rule;
    rule.object = "box", rule.surface = "lid", rule.parameter = "layers[1].height";
    const Scene bent = sceneOf(scene, rule, {0, 3e-4});
    Scene expected = scene;
    expected.objects[0].surfaces[0].layers[1].strength = 3e-4;
    QVERIFY(bent == expected);
    QVERIFY(sameShapes(bent, scene)); // it comes under the finger
    VERIFY_RESULT(checkStaircase(scene, rule));
    rule.parameter = "layers[2].height";
    COMPARE_CONTAINS(refusal(checkStaircase(scene, rule)),
                     "no \"layers[2].height\" of a surface \"lid\" of an object \"box\"");
    rule.parameter = "proxy-radius";
    QCOMPARE(sceneOf(scene, rule, {0, 2e-3}).proxyRadius, 2e-3);
    QVERIFY(!sameShapes(sceneOf(scene, rule, {0, 2e-3}), scene));
    Scene reaching = scene;
    reaching.reach.mode = ReachMode::Drift;
    QVERIFY(!sameShapes(reaching, scene)); // it moves the finger
}

/// The range is that of what is bent, whatever it is.
void TestStudyRun::levelsKeepToTheRangeOfWhatIsBent() {
    StudyDesign design = staircaseOf(2);
    StaircaseRule& rule = design.staircase;
    rule.parameter = "layers[0].height";
    COMPARE_CONTAINS(refusal(check(design)), "leave the range of Height, -0.01 to 0.01 m");
    rule.reference = 1e-4, rule.start = rule.largest = 2e-4, rule.steps = {5e-5};
    VERIFY_RESULT(check(design));
    auto run = StudyRun::begin(design, 1, 1);
    VERIFY_RESULT(run);
    run->proceed();
    const auto& intervals = run->trial().intervals;
    QCOMPARE(std::max(*intervals[0].value, *intervals[1].value), 1e-4 + 2e-4);
}

} // namespace test_study_run

using test_study_run::TestStudyRun;
TACTUM_TEST(TestStudyRun)
#include "test_study_run.moc"
