// A study with a participant, without window and loops: what is felt when, what is in the logs, how it ends
// and goes on.
//
// What would show that a test here is wrong: the order of the stimuli is asked of a StudyRun with the same
// seed, which knows nothing of scenes and files; logs are read as a reader of CSV sees them.
#include <fstream>
#include <set>

#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include "core/scene/primitives.h"
#include "tests/core/study/log_table.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/told_engine.h"
#include "ui/engine/world_publisher.h"
#include "ui/study/study_session.h"

namespace test_study_session {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kParticipant = 12; // "P012" in the names of the logs

/// A box of some stiffness, which tells the scenes apart.
Scene boxOf(double stiffness, Primitive shape = Primitive::Box) {
    Scene scene = sceneOf(shape);
    for (Surface& surface : scene.objects[0].surfaces)
        surface.material.stiffness = stiffness;
    return scene;
}

double stiffnessOf(const World& world) {
    return world.scene->objects[0].surfaces[0].material.stiffness;
}

/// Two intervals, each with each of three stiffnesses, and a question; twice.
Study pairs() {
    Study study;
    study.design = designOf(Procedure::Pairs, {"soft", "middle", "hard"}, 2);
    StudyQuestion question;
    question.text = "How sure?";
    study.design.questions = {question};
    study.conditions = {boxOf(200), boxOf(400), boxOf(800)};
    return study;
}

/// A desk with a session, whose engine has felt nothing yet.
struct Desk {
    explicit Desk(const QString& folder) : file(folder.toStdString() + "/texture.tactum-study") {
        std::ofstream(file) << "a study\n";
        QObject::connect(&session, &StudySession::failed, [this](const QString& what) { failure = what; });
        QObject::connect(&session, &StudySession::refused, [this](const QString& what) { refusal = what; });
        QObject::connect(&session, &StudySession::forcesWanted, [this](bool on) { forces.push_back(on); });
        QObject::connect(&session, &StudySession::finished, [this] { ++finished; });
        engine.of[0].device.name = "An arm";
        engine.of[0].device.damping = 4;
    }
    Result<void> begin(const Study& study, bool goOn = false) {
        const Result<void> begun =
            session.begin(std::make_shared<const Study>(study),
                          {.file = file, .participant = kParticipant, .seed = 11, .goOn = goOn});
        if (begun) (void)waitFor([&] { return !publisher.working(); });
        return begun;
    }
    /// On to the step after this one, until what it publishes is there.
    void proceed() {
        session.proceed();
        (void)waitFor([&] { return !publisher.working(); });
    }
    double felt() const { return stiffnessOf(*engine.worlds.back()); }
    /// A tick of the finger at x, m, in the World that is felt.
    void tick(double t, double x) {
        TracePoint point;
        point.t = t;
        point.finger = Vec3(x, 0, 0);
        point.revision = engine.worlds.back()->revision;
        session.take({point});
    }
    std::string log(const char* kind) const {
        const QDir folder(QString::fromStdString(file.parent_path().string()));
        const QStringList found = folder.entryList({QStringLiteral("texture-P012-*-%1.csv").arg(kind)});
        if (found.empty()) return {};
        std::ostringstream text;
        text << std::ifstream(folder.filePath(found.back()).toStdString()).rdbuf();
        return text.str();
    }

    std::filesystem::path file;
    ToldEngine engine;
    Document document;
    WorldPublisher publisher{document, engine};
    StudySession session{publisher, engine};
    QString failure, refusal;
    std::vector<bool> forces;
    int finished = 0;
};

/// What StudyRun says of the same study, participant and seed.
StudyRun planOf(const Study& study) {
    return StudyRun::begin(study.design, kParticipant, 11).value();
}

double stiffnessOf(const Study& study, const Stimulus& stimulus) {
    return study.conditions[std::size_t(stimulus.condition)].objects[0].surfaces[0].material.stiffness;
}

} // namespace

class TestStudySession : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;
    QString own_;

private slots:
    void init() { own_ = folders_.next(); }

    // Each interval is felt as the plan says, each answer is in the log, in its order, with its seed.
    void everyTrialIsFeltAskedAndLogged() {
        const Study study = pairs();
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        QVERIFY(desk.session.running());
        QVERIFY(!desk.session.felt());
        QCOMPARE(desk.session.run().step(), StudyStep::Instructions);
        StudyRun plan = planOf(study);
        plan.proceed();
        desk.proceed();
        int trials = 0;
        double time = 0;
        while (desk.session.run().step() != StudyStep::Done) {
            ++trials;
            for (std::size_t interval = 0; interval < 2; ++interval) {
                QCOMPARE(desk.session.run().step(), StudyStep::Stimulus);
                QVERIFY(desk.session.felt());
                QCOMPARE_EQ(desk.felt(), stiffnessOf(study, plan.trial().intervals[interval]));
                for (int i = 0; i < 3; ++i)
                    desk.tick(time += 0.001, 0.01 * trials);
                plan.proceed();
                desk.proceed();
            }
            QCOMPARE(desk.session.run().step(), StudyStep::Choice);
            desk.session.proceed(); // by no key but an answer
            QCOMPARE(desk.session.run().step(), StudyStep::Choice);
            desk.session.choose(trials % 2);
            QCOMPARE(desk.session.run().step(), StudyStep::Question);
            desk.session.proceed();
            QCOMPARE(desk.session.run().step(), StudyStep::Question);
            desk.session.reply(QStringLiteral("9")); // of seven
            QVERIFY2(!desk.refusal.isEmpty(), "a sentence");
            QCOMPARE(desk.session.run().step(), StudyStep::Question);
            desk.session.reply(QString::number(1 + trials % 7));
            (void)waitFor([&] { return !desk.publisher.working(); });
            QVERIFY(plan.choose(trials % 2).has_value());
            QVERIFY(plan.reply(std::to_string(1 + trials % 7)).has_value());
            if (plan.step() == StudyStep::Pause) plan.proceed();
            if (desk.session.run().step() == StudyStep::Pause) desk.proceed();
        }
        QCOMPARE(trials, 6); // three pairs, twice
        QCOMPARE(desk.finished, 1);
        QCOMPARE(desk.failure, QString());

        const auto answers = tableOf(desk.log("answers"));
        QCOMPARE(answers.size(), std::size_t(trials));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            auto row = answers[i];
            const StudyTrial& trial = desk.session.run().done()[i].trial;
            QCOMPARE(row["trial"], std::to_string(i + 1));
            QCOMPARE(row["participant"], "12");
            QCOMPARE(row["seed"], "11");
            QCOMPARE(row["device"], "An arm");
            QCOMPARE(row["felt"], "2");
            QCOMPARE(row["q1"], std::to_string(1 + int(i + 1) % 7));
            QCOMPARE(row["chosen"],
                     study.design.conditions[std::size_t(trial.intervals[(i + 1) % 2].condition)]);
            QCOMPARE_GT(std::stod(row["reaction_ms"]), 0);
            QCOMPARE_GT(std::stod(row["ceiling_N_per_m"]), 0);
        }
        // Of three ticks the first has no velocity, and no row.
        const auto touch = tableOf(desk.log("touch"));
        QCOMPARE(touch.size(), std::size_t(trials * 2 * 2));
        for (std::size_t i = 0; i < touch.size(); ++i) {
            auto row = touch[i];
            QCOMPARE(row["trial"], std::to_string(i / 4 + 1));
            QCOMPARE(row["interval"], std::to_string(i / 2 % 2 + 1));
            QCOMPARE(row["hand"], "1");
            QCOMPARE_EQ(std::stod(row["finger_x_m"]), 0.01 * double(i / 4 + 1));
        }
    }

    void theDocumentComesBackWhenItEnds() {
        Desk desk(own_);
        desk.document.begin(boxOf(555));
        QVERIFY(waitFor([&] { return !desk.engine.worlds.empty() && !desk.publisher.working(); }));
        VERIFY_RESULT(desk.begin(pairs()));
        desk.proceed();
        QVERIFY(desk.publisher.trying());
        QCOMPARE_NE(desk.felt(), 555);
        desk.session.end();
        QVERIFY(waitFor([&] { return !desk.publisher.working(); }));
        QVERIFY(!desk.session.running());
        QVERIFY(!desk.publisher.trying());
        QCOMPARE_EQ(desk.felt(), 555);
        desk.session.end(); // once more does nothing
        QCOMPARE(desk.failure, QString());
        // Nothing that comes afterwards is of a study.
        desk.session.proceed();
        desk.session.feelAgain();
        desk.session.choose(0);
        desk.session.reply(QStringLiteral("1"));
        desk.tick(1, 0);
        QCOMPARE(desk.refusal, QString());
    }

    // An interval may be felt again before the choice; it is counted.
    void anIntervalIsFeltAgain() {
        const Study study = pairs();
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        const StudyTrial trial = [&] {
            StudyRun plan = planOf(study);
            plan.proceed();
            return plan.trial();
        }();
        for (int i = 0; i < 3; ++i)
            desk.proceed();
        QCOMPARE(desk.session.run().step(), StudyStep::Choice);
        desk.session.feelAgain();
        QVERIFY(waitFor([&] { return desk.session.felt(); }));
        QCOMPARE_EQ(desk.felt(), stiffnessOf(study, trial.intervals[0]));
        desk.proceed(), desk.proceed();
        desk.session.choose(0);
        desk.session.reply(QStringLiteral("3"));
        auto rows = tableOf(desk.log("answers"));
        QCOMPARE(rows.size(), std::size_t(1));
        QCOMPARE(rows[0]["felt"], "4");
    }

    // Of a stimulus with other shapes a finger that touches may be inside: it waits.
    void otherShapesWaitUntilNothingIsTouched() {
        Study study;
        study.design = designOf(Procedure::List, {"box", "ball", "hard box"});
        study.design.order = StudyOrder::AsListed;
        study.conditions = {boxOf(200), boxOf(300, Primitive::Sphere), boxOf(400, Primitive::Sphere)};
        study.design.questions = pairs().design.questions;
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        desk.engine.proxyTold.output.contacts = 1;
        desk.proceed(); // the first is felt as it lies there already
        QVERIFY(desk.session.felt());
        QCOMPARE_EQ(desk.felt(), 200);
        desk.proceed();
        desk.session.reply(QStringLiteral("3"));
        QVERIFY(desk.session.waitsForLift());
        QVERIFY(!desk.session.felt());
        desk.tick(1, 0);
        QCOMPARE_EQ(desk.felt(), 200);
        desk.session.proceed(); // what is not felt does not end
        QVERIFY(desk.session.waitsForLift());
        desk.engine.proxyTold.output.contacts = 0;
        desk.tick(1.1, 0);
        QVERIFY(waitFor([&] { return desk.session.felt(); }));
        QCOMPARE_EQ(desk.felt(), 300);
        // The same shape that feels otherwise comes under the finger.
        desk.engine.proxyTold.output.contacts = 1;
        desk.proceed();
        desk.session.reply(QStringLiteral("4"));
        QVERIFY(waitFor([&] { return desk.session.felt(); }));
        QCOMPARE_EQ(desk.felt(), 400);
    }

    void timesAreKept() {
        Study study = pairs();
        study.design.stimulusSeconds = 0.05;
        study.design.pauseSeconds = 0.2;
        study.design.questions.clear();
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        desk.proceed();
        // Both intervals end by themselves, the choice does not.
        QVERIFY(waitFor([&] { return desk.session.run().step() == StudyStep::Choice; }));
        desk.session.choose(0);
        QCOMPARE(desk.session.run().step(), StudyStep::Pause);
        QVERIFY(desk.session.rests());
        desk.session.proceed(); // not before it is over
        QCOMPARE(desk.session.run().step(), StudyStep::Pause);
        QVERIFY(waitFor([&] { return desk.session.run().step() == StudyStep::Stimulus; }));
        QCOMPARE(desk.session.run().number(), 2);
    }

    void forcesAreOffBetweenWhereTheDesignSaysSo() {
        Study study = pairs();
        study.design.forcesOffBetween = true;
        study.design.pauseSeconds = 0.01;
        study.design.questions.clear();
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        QVERIFY(desk.forces.empty());
        desk.proceed();
        QCOMPARE(desk.forces, (std::vector<bool>{true}));
        desk.proceed();
        QCOMPARE(desk.forces, (std::vector<bool>{true, true}));
        desk.proceed();
        QCOMPARE(desk.forces, (std::vector<bool>{true, true, false}));
        desk.session.choose(1);
        QCOMPARE(desk.session.run().step(), StudyStep::Pause);
        // They come on by somebody who holds the handle, and not when the pause is over.
        QVERIFY(waitFor([&] { return !desk.session.rests(); }));
        QCOMPARE(desk.session.run().step(), StudyStep::Pause);
        QVERIFY(!desk.forces.back());
        desk.proceed();
        QVERIFY(desk.session.felt());
        QVERIFY(desk.forces.back());
    }

    // Faults of the trial, and not those before it.
    void faultsAreCountedByTrial() {
        Study study = pairs();
        study.design.questions.clear();
        Desk desk(own_);
        desk.engine.of[0].servo.faults = 5;
        VERIFY_RESULT(desk.begin(study));
        desk.proceed();
        desk.engine.of[0].servo.faults = 7;
        desk.proceed(), desk.proceed();
        desk.session.choose(0);
        (void)waitFor([&] { return !desk.publisher.working(); });
        desk.proceed(), desk.proceed();
        desk.session.choose(0);
        auto rows = tableOf(desk.log("answers"));
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[0]["faults"], "2");
        QCOMPARE(rows[1]["faults"], "0");
    }

    void whatBrokeOffGoesOn() {
        Study study = pairs();
        std::filesystem::path file;
        {
            Desk desk(own_);
            QVERIFY(!brokenOff(study.design, desk.file, kParticipant));
            VERIFY_RESULT(desk.begin(study));
            for (int trial = 0; trial < 2; ++trial) {
                for (int i = 0; i < (trial ? 2 : 3); ++i) {
                    desk.proceed();
                    desk.tick(1 + 0.1 * i, 0);
                    desk.tick(1.001 + 0.1 * i, 0);
                }
                desk.session.choose(0);
                desk.session.reply(QStringLiteral("2"));
                (void)waitFor([&] { return !desk.publisher.working(); });
            }
            file = desk.session.answers();
        }
        { // as a crash leaves it: a row that is not whole
            std::ofstream torn(file, std::ios::app);
            torn << "2,3,half a";
        }
        Desk desk(own_);
        const auto broken = brokenOff(study.design, desk.file, kParticipant);
        QVERIFY(broken.has_value());
        QCOMPARE(broken->run.answers.size(), std::size_t(2));
        QCOMPARE(broken->log, file);
        QVERIFY(!brokenOff(study.design, desk.file, 8)); // of another participant
        VERIFY_RESULT(desk.begin(study, true));
        QCOMPARE(desk.session.run().number(), 3);
        QCOMPARE(desk.session.run().seed(), std::uint64_t(11));
        QCOMPARE(desk.session.answers(), file);
        while (desk.session.run().step() != StudyStep::Done) {
            if (desk.session.run().step() == StudyStep::Choice) {
                desk.session.choose(1);
                desk.session.reply(QStringLiteral("5"));
                (void)waitFor([&] { return !desk.publisher.working(); });
            } else {
                desk.proceed();
            }
        }
        const auto rows = tableOf(desk.log("answers"));
        QCOMPARE(rows.size(), std::size_t(6));
        for (std::size_t i = 0; i < rows.size(); ++i)
            QCOMPARE(rows[i].at("trial"), std::to_string(i + 1));
        QCOMPARE(rows[1].at("q1"), "2");
        QCOMPARE(rows[2].at("q1"), "5");
        QVERIFY(!brokenOff(study.design, desk.file, kParticipant)); // it came to its end
    }

    void whatIsNoRunIsRefused() {
        Study study = pairs();
        Desk desk(own_);
        const auto none = desk.begin(study, true);
        QVERIFY(!none);
        COMPARE_CONTAINS(none.error().text, "begin a new one");
        study.design.conditions.pop_back(); // and the design with it
        study.design.conditions.pop_back();
        QVERIFY(!desk.begin(study));
        QVERIFY(!desk.session.running());
        QVERIFY(!desk.publisher.trying());
        QCOMPARE(desk.log("answers"), std::string());
        // A staircase over a surface that there is not.
        Study staircase;
        staircase.design = staircaseOf(1);
        staircase.conditions = {boxOf(400)};
        staircase.design.staircase.surface = "no such surface";
        const auto bends = desk.begin(staircase);
        QVERIFY(!bends);
        QCOMPARE(desk.log("answers"), std::string());
        // A folder that takes no logs.
        desk.file = "/proc/self/study.tactum-study";
        const auto unwritten = desk.begin(pairs());
        QVERIFY(!unwritten);
        QVERIFY(!desk.session.running());
    }

    // The stimuli of a staircase are the condition with another value.
    void aStaircaseBendsItsParameter() {
        Study study;
        study.design = staircaseOf(1);
        study.conditions = {boxOf(123)};
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        desk.proceed();
        std::set<double> first;
        first.insert(desk.felt());
        desk.tick(0.001, 0), desk.tick(0.002, 0);
        desk.proceed();
        first.insert(desk.felt());
        QVERIFY((first == std::set<double>{400, 426}));
        auto touch = tableOf(desk.log("touch"));
        QCOMPARE(touch.size(), std::size_t(1));
        QVERIFY(first.contains(std::stod(touch[0]["value"])));
    }

    void ticksNameWhatIsTouched() {
        Study study = pairs();
        Desk desk(own_);
        VERIFY_RESULT(desk.begin(study));
        desk.proceed();
        TracePoint point;
        point.touched.contacts = 1;
        point.touched.object = study.conditions[0].objects[0].id;
        point.revision = desk.engine.worlds.back()->revision;
        const auto at = [&](double t) {
            point.t = t;
            return point;
        };
        desk.session.take({at(0.001), at(0.002)});
        point.revision += 1000; // of a World that nobody knows
        desk.session.take({at(0.003)});
        auto rows = tableOf(desk.log("touch"));
        QCOMPARE(rows.size(), std::size_t(2));
        QCOMPARE(rows[0]["object"], study.conditions[0].objects[0].name);
        QCOMPARE_NE(rows[1]["object"], study.conditions[0].objects[0].name);
        desk.engine.of.resize(2);
        desk.engine.chosen = 1;
        desk.session.take({at(0.004)});
        rows = tableOf(desk.log("touch"));
        QCOMPARE(rows[2]["hand"], "2");
    }
};

TACTUM_TEST(TestStudySession)

} // namespace test_study_session

#include "test_study_session.moc"
