// A self-test on its own thread: what it tells, how it is answered and ended, and that the device is closed
// and gone each time.
//
// What would show that a test here is wrong: the device counts itself, and what it was sent.
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/fake_devices.h"
#include "ui/engine/self_test_run.h"

namespace test_self_test_run {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A run of the fake device, in a hurry.
struct Desk {
    Desk() {
        QObject::connect(&run, &SelfTestRun::prepares, [this](const QString& step, const QString& request) {
            steps << (request.isEmpty() ? step : step + u':' + request);
        });
        QObject::connect(&run, &SelfTestRun::begun, [this](TrialPart) { ++parts; });
        QObject::connect(&run, &SelfTestRun::asked,
                         [this](const TrialQuestion& question) { asked.push_back(question); });
        QObject::connect(&run, &SelfTestRun::finished, [this] { ++finished; });
    }
    bool isAsked(std::size_t times) {
        return waitFor([&] { return asked.size() >= times || finished > 0; }) && finished == 0;
    }
    bool ends() {
        return waitFor([&] { return finished == 1; });
    }

    std::shared_ptr<FakeDesk> arm = std::make_shared<FakeDesk>();
    SelfTestRun run{std::make_unique<FakeDevice>(arm),
                    {.rest = 0.1, .shake = 0.1, .settle = 0.1, .swings = 1, .buttons = 0.1}};
    QStringList steps;
    std::vector<TrialQuestion> asked;
    int parts = 0, finished = 0;
};

} // namespace

class TestSelfTestRun : public QObject {
    Q_OBJECT

private slots:
    void wordsHaveTheirPartsInTheirPlaces() {
        QCOMPARE(trialText(TrialWords("plain")), QStringLiteral("plain"));
        QCOMPARE(trialText(TrialWords("%2 before %1", {"one", "two"})), QStringLiteral("two before one"));
        QCOMPARE(trialText(TrialWords("%1", {TrialWords("in %1", {"depth"})})), QStringLiteral("in depth"));
        TrialWords many("%1 and %11", {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"});
        QCOMPARE(trialText(many), QStringLiteral("a and k"));
    }

    void itAsksWaitsAndIsEnded() {
        Desk desk;
        QCOMPARE(desk.run.device().name, "Example arm");
        QVERIFY(!desk.run.look());
        desk.run.end(QStringLiteral("before it began"));
        desk.run.end(QStringLiteral("once more")); // the first reason stays
        desk.run.start();
        QVERIFY(desk.ends());
        QVERIFY(!desk.run.finishedWhole());
        QCOMPARE(desk.run.failure(), QStringLiteral("before it began"));
        QCOMPARE(desk.arm->made, 0);
    }

    void aPreparationIsTold() {
        Desk desk;
        desk.run.start();
        QVERIFY(waitFor([&] { return desk.steps.size() == 1; }));
        QVERIFY(!desk.run.look()); // it is not open yet
        desk.arm->go = 1;
        QVERIFY(waitFor([&] { return desk.steps.size() == 2; }));
        QCOMPARE(desk.steps, (QStringList{"Load the firmware", "Find home:Push the grip in and out."}));
        desk.run.end();
        QVERIFY(desk.ends());
        QCOMPARE(desk.run.failure(), QString()); // the person ended it
        QVERIFY(!desk.run.finishedWhole());
        QCOMPARE(desk.parts, 0);
        QCOMPARE(desk.arm->made, 0);
    }

    void whatFailsIsSaid() {
        Desk desk;
        desk.arm->go = 1;
        desk.arm->failAt = 1;
        desk.run.start();
        QVERIFY(desk.ends());
        QCOMPARE(desk.run.failure(), QStringLiteral("The grip did not move: pull it all the way out."));
        QCOMPARE(desk.arm->made, 0);
        Desk other;
        other.arm->go = 3;
        other.arm->failOpen = true;
        other.run.start();
        QVERIFY(other.ends());
        QCOMPARE(other.run.failure(), QStringLiteral("The arm did not wake: switch it off and on."));
        QCOMPARE(other.parts, 0);
        QCOMPARE(other.arm->made, 0);
    }

    // It waits for the person as long as they take; what is answered before it asks is no answer.
    void aQuestionWaitsForItsAnswer() {
        Desk desk;
        desk.arm->go = 3;
        desk.run.answer(true);
        desk.run.start();
        QVERIFY(desk.isAsked(1));
        QVERIFY(desk.run.look().has_value());
        COMPARE_NEAR(desk.run.look()->position.x(), 0, 1e-12, "m");
        desk.arm->x = 0.01;
        QVERIFY(waitFor([&] { return std::abs(desk.run.look()->position.x() - 0.01) < 1e-12; }));
        QTest::qWait(100);
        QCOMPARE(desk.asked.size(), std::size_t(1));
        QCOMPARE_EQ(desk.arm->force.load(), 0); // no force but within an experiment
        desk.run.end(QStringLiteral("the window closes"));
        QVERIFY(desk.ends());
        QCOMPARE(desk.run.failure(), QStringLiteral("the window closes"));
        QVERIFY(!desk.run.look());
        QCOMPARE(desk.arm->made, 0);
        desk.run.end(QStringLiteral("once more")); // the first reason stays
        QCOMPARE(desk.run.failure(), QStringLiteral("the window closes"));
    }

    // Whoever leaves everything out comes to the end, too.
    void allOfItMayBeLeftOut() {
        Desk desk;
        desk.arm->go = 3;
        desk.run.start();
        for (std::size_t i = 1; desk.isAsked(i); ++i) {
            const TrialQuestion& question = desk.asked.back();
            if (question.kind == TrialQuestion::Kind::Mass) {
                QCOMPARE_GT(question.heaviest, 0);
                desk.run.answerMass({});
            } else {
                QVERIFY(!trialText(question.words).isEmpty());
                desk.run.answer(false);
            }
        }
        QVERIFY(desk.ends());
        QCOMPARE(desk.run.failure(), QString());
        QVERIFY(desk.run.finishedWhole());
        QCOMPARE_GT(desk.parts, 2);
        QCOMPARE_GT(desk.asked.size(), std::size_t(2));
        QCOMPARE(desk.arm->made, 0);
    }

    void whoGoesTakesTheDeviceAlong() {
        const auto arm = std::make_shared<FakeDesk>();
        arm->go = 3;
        {
            SelfTestRun run(std::make_unique<FakeDevice>(arm), {.rest = 0.1});
            QSignalSpy asked(&run, &SelfTestRun::asked);
            run.start();
            QVERIFY(waitFor([&] { return !asked.empty(); }));
            QCOMPARE(arm->made, 1);
        }
        QCOMPARE(arm->made, 0); // it waited until it was closed
        QCOMPARE_EQ(arm->force.load(), 0);
    }
};

TACTUM_TEST(TestSelfTestRun)

} // namespace test_self_test_run

#include "test_self_test_run.moc"
