// What the self-test says of devices whose figures are known: they are found, every put-in fault is named,
// and a sound device has none.
#include <algorithm>

#include <QTest>

#include "core/self_test/self_test.h"
#include "device/profile.h"
#include "tests/core/self_test/plant_bench.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

Q_DECLARE_METATYPE(tactum::test::Plant)

namespace test_self_test {

using namespace tactum;
using namespace tactum::test;

namespace {

DeviceInfo saidOf(const Plant& plant) {
    return {.name = "Made-up arm",
            .maxForce = 8,
            .workspaceRadius = 0.05,
            .rate = 1000,
            .delay = double(plant.delay) + 1e3 * plant.lag,
            .buttons = 4};
}

SelfTestReport reportOf(const Plant& plant, unsigned seed = 1) {
    PlantBench bench(plant, seed);
    PlantPerson person(bench);
    auto report = selfTest(bench, person, saidOf(plant));
    if (!report) {
        qWarning("%s", report.error().text.c_str());
        return {};
    }
    return std::move(*report);
}

double valueOf(const SelfTestReport& report, const std::string& name) {
    for (const SelfTestFigure& figure : report.figures)
        if (figure.name.english() == name) return figure.measured.value;
    qWarning("no figure %s", name.c_str());
    return NAN;
}

/// For a window, which has other languages: every form is one of the table.
bool allListed(const TrialWords& words) {
    const bool listed = words.parts.empty() ||
                        std::ranges::find(trial_words::kAll, words.form) != std::end(trial_words::kAll);
    return listed && std::ranges::all_of(words.parts, allListed);
}

QByteArray all(const std::vector<TrialWords>& lines) {
    QByteArray text;
    for (const TrialWords& line : lines)
        text += QByteArray::fromStdString(line.english()) + '\n';
    return text;
}

/// Within a part of what was put in.
void expectNear(double found, double put, double part, const char* what) {
    qInfo("%s: put in %g, found %g (%+.1f %%)", what, put, found, 100 * (found / put - 1));
    QVERIFY2(std::abs(found - put) <= part * put, what);
}

Plant plantOf(std::size_t index) {
    const Plant plants[] = {
        {},
        {.mass = 0.08, .damping = 0.5, .friction = 0.1, .delay = 2, .noise = 2e-5},
        {.mass = 0.3, .damping = 2, .friction = 0.4, .delay = 3, .lag = 1e-3, .step = 2e-5, .noise = 1e-5},
        {.mass = 0.2,
         .damping = 1,
         .friction = 0.3,
         .delay = 5,
         .step = 1e-5,
         .weight = 0.2,
         .motorGain = 1.5},
    };
    return plants[index];
}

} // namespace

class TestSelfTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheFigures_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<int>("seed");
        for (int index = 0; index < 4; ++index)
            for (int seed = 1; seed <= 3; ++seed)
                QTest::addRow("plant %d, noise %d", index, seed) << index << seed;
    }
    void findsTheFigures() {
        QFETCH(int, index);
        QFETCH(int, seed);
        const Plant plant = plantOf(std::size_t(index));
        const SelfTestReport report = reportOf(plant, unsigned(seed));
        qInfo("%s%s", all(report.faults).constData(), all(report.leftOut).constData());
        for (const char* axis : {"x", "y", "z"}) {
            const std::string along = std::string(" along ") + axis;
            expectNear(valueOf(report, "moving mass" + along), plant.mass, 0.05, "mass");
            expectNear(valueOf(report, "damping" + along), plant.damping, 0.05, "damping");
            expectNear(valueOf(report, "dry friction" + along), plant.friction, 0.05, "friction");
            const double delay = 1e-3 * plant.delay + plant.lag,
                         found = valueOf(report, "delay from command to force" + along);
            qInfo("delay: put in %g, found %g", delay, found);
            QVERIFY(std::abs(found - delay) < 0.5e-3);
        }
        expectNear(valueOf(report, "force along y to the force that is asked for"), plant.motorGain, 0.05,
                   "gain");
        const double noise = std::hypot(plant.noise, plant.step / std::sqrt(12.0));
        expectNear(valueOf(report, "resolution of the position"), std::max(plant.step, 2 * noise), 0.05,
                   "step");
    }

    void namesNothingOnASoundDevice() {
        for (const std::size_t index : {0, 1, 2})
            for (unsigned seed = 1; seed <= 5; ++seed) {
                const SelfTestReport report = reportOf(plantOf(index), seed);
                QVERIFY2(report.faults.empty(), all(report.faults));
                QVERIFY2(report.leftOut.empty(), all(report.leftOut));
                QVERIFY(!report.figures.empty());
            }
    }

    void namesEachFault_data() {
        QTest::addColumn<Plant>("plant");
        QTest::addColumn<QByteArray>("sentence");
        const auto add = [](const char* sentence, const auto& put) {
            Plant plant;
            put(plant);
            QTest::newRow(sentence) << plant << QByteArray(sentence);
        };
        add("x runs the other way", [](Plant& p) { p.scale[0] = -1; });
        add("z runs the other way", [](Plant& p) { p.scale[2] = -1; });
        add("y reads 1.50 times as far", [](Plant& p) { p.scale[1] = 1.5; });
        add("x reads 0.80 times as far", [](Plant& p) { p.scale[0] = 0.8; });
        add("x and y are exchanged.", [](Plant& p) { p.read = {1, 0, 2}; });
        add("The way along x is read along y.", [](Plant& p) { p.read = {2, 0, 1}; });
        add("The readings hardly change when the handle moves upwards", [](Plant& p) { p.scale[1] = 0; });
        add("Two ways of the handle are read along one axis",
            [](Plant& p) { p.scale[1] = 0.1, p.crossed = 1; });
        add("The motors push the other way along y.", [](Plant& p) { p.motor[1] = -1; });
        add("The motors push along z when they should along x.", [](Plant& p) { p.push = {2, 1, 0}; });
        add("The device does not push along z", [](Plant& p) { p.motor[2] = 0; });
        add("The motors push 1.50 times as hard", [](Plant& p) { p.motorGain = 1.5; });
        add("The motors push 0.80 times as hard", [](Plant& p) { p.motorGain = 0.8; });
        add("It reads 500 times a second and not 1000", [](Plant& p) { p.rate = 500; });
        add("A button counts as held", [](Plant& p) { p.stuckButtons = 2; });
        add("Button 3 of 4 was not heard.", [](Plant& p) { p.deafButtons = 4; });
        add("Button 2 was not heard to be released.", [](Plant& p) { p.stuckButtons = 2; });
        add("more buttons than the 4", [](Plant& p) { p.stuckButtons = 16; });
    }
    void namesEachFault() {
        QFETCH(Plant, plant);
        QFETCH(QByteArray, sentence);
        const SelfTestReport report = reportOf(plant);
        const QByteArray faults = all(report.faults);
        QVERIFY2(faults.contains(sentence), faults);
        for (const TrialWords& fault : report.faults)
            QVERIFY2(allListed(fault), fault.form.c_str());
        for (const SelfTestFigure& figure : report.figures)
            QVERIFY2(allListed(figure.name), figure.name.form.c_str());
        // A ring of axes has three; a button that is stuck is heard at rest, too.
        QVERIFY2(report.faults.size() <= (plant.read[0] == 2 ? 3 : 2), faults);
    }

    void aDelayThatTheProfileDoesNotKnowIsNamed() {
        PlantBench bench({.delay = 6}, 1);
        PlantPerson person(bench);
        const auto report = selfTest(bench, person, saidOf({.delay = 1}));
        QVERIFY2(report &&
                     all(report->faults).contains("ticks after their reading, and the profile says 1.0"),
                 all(report->faults));
    }

    /// Turned round, scaled and pushing the other way at once: the figures are those of the arm all the same.
    void findsTheFiguresBehindFaults() {
        Plant plant;
        plant.scale = {-1.5, 1, 1};
        plant.read = {1, 0, 2};
        plant.motor = {1, -1, -1};
        plant.motorGain = 1.4;
        const SelfTestReport report = reportOf(plant);
        QCOMPARE(report.faults.size(), std::size_t(6));
        for (const char* axis : {"x", "y", "z"}) {
            expectNear(valueOf(report, std::string("moving mass along ") + axis), plant.mass, 0.05, "mass");
            expectNear(valueOf(report, std::string("damping along ") + axis), plant.damping, 0.05, "damping");
        }
    }

    void theForceStaysBelowFourTenths() {
        PlantBench bench({}, 1);
        PlantPerson person(bench);
        QVERIFY(selfTest(bench, person, saidOf({})));
        QCOMPARE_LT(bench.strongest, 0.4 * 8 + 1e-9);
        QCOMPARE_GT(bench.strongest, 1);
    }

    void aDeviceThatRunsAwayEndsIt() {
        // A handle of two grams, with nothing that brakes it, is thrown by a push.
        PlantBench bench({.mass = 0.002, .damping = 0, .friction = 0}, 1);
        PlantPerson person(bench);
        const auto report = selfTest(bench, person, saidOf({}));
        QVERIFY(!report);
        QCOMPARE(report.error().text, std::string("too fast"));
    }

    void whoLeavesThingsOutGetsTheRest() {
        PlantBench bench({}, 1);
        PlantPerson person(bench);
        person.leavesOut = {TrialAsk::Right, TrialAsk::Hang, TrialAsk::Press};
        const auto report = selfTest(bench, person, saidOf({}));
        QVERIFY(report && report->faults.empty());
        QCOMPARE(all(report->leftOut),
                 QByteArray("the ruler along x\nthe weight of a known mass\nthe buttons\n"));
        QCOMPARE(person.begun.size(), std::size(kTrialParts));
        expectNear(valueOf(*report, "moving mass along x"), 0.15, 0.05, "mass");
    }

    void withoutAMassNothingIsWeighed() {
        for (const std::optional<double> mass :
             {std::optional<double>(), std::optional(0.001), std::optional(5.0)}) {
            PlantBench bench({}, 1);
            PlantPerson person(bench);
            person.hangs = mass;
            const auto report = selfTest(bench, person, saidOf({}));
            QVERIFY(report && report->leftOut.size() == 1);
            QVERIFY2(report->leftOut[0].english().starts_with("the weight of a known mass"),
                     all(report->leftOut));
        }
    }

    void whoEndsItGetsWhatThereIs() {
        PlantBench bench({}, 1);
        PlantPerson person(bench);
        person.leavesAfter = 5; // in the middle of the ruler
        const auto report = selfTest(bench, person, saidOf({}));
        QVERIFY(report && report->faults.empty());
        QVERIFY2(all(report->leftOut).contains("all that was to come"), all(report->leftOut));
        QVERIFY(!std::isnan(valueOf(*report, "noise of the position at rest")));
        QVERIFY(readProfile(profileOfReport(*report, "today"), "p.json", {}));
    }

    void itsProfileIsOneThatTheProgramReads() {
        const Plant plant = plantOf(1);
        const SelfTestReport report = reportOf(plant);
        const DeviceProfile before = *profileOf("falcon", {});
        const auto read = readProfile(profileOfReport(report, "2026-01-02"), "falcon.json", before);
        VERIFY_RESULT(read);
        expectNear(read->info.damping, plant.damping, 0.05, "damping");
        expectNear(read->info.dryFriction, plant.friction, 0.05, "friction");
        expectNear(read->info.delay, plant.delay, 0.05, "delay");
        QCOMPARE(read->info.amplifierLag, 0.0);
        QCOMPARE(read->info.maxForce, before.info.maxForce); // nothing else
        QCOMPARE(read->info.rate, before.info.rate);
        const QByteArray text = QByteArray::fromStdString(profileOfReport(report, "2026-01-02"));
        COMPARE_CONTAINS(text, "Measured by the self-test on 2026-01-02");
        QVERIFY(text.contains("self-test of 2026-01-02, +-"));
    }

    void itsPageSaysWhatIsWrongAndWhatWasMeasured() {
        SelfTestReport report = reportOf({.motorGain = 1.5});
        report.device.name = "<b>&";
        const QByteArray page = QByteArray::fromStdString(htmlOfReport(report, "2026-01-02"));
        for (const char* part :
             {"&lt;b&gt;&amp;", "2026-01-02", "The motors push 1.50 times", "moving mass along z",
              "<h2>What was left out</h2>\n<p>Nothing.</p>", "</html>"})
            QVERIFY2(page.contains(part), page);
    }

    void itsTableHasEveryTick() {
        const SelfTestReport report = reportOf({});
        const QByteArray table = QByteArray::fromStdString(csvOfReport(report));
        QVERIFY(table.startsWith("t,x,y,z,force_x,force_y,force_z,buttons,valid\n0.000000,"));
        QCOMPARE(std::size_t(table.count('\n')), report.rows.size() + 1);
        for (std::size_t i = 1; i < report.rows.size(); ++i)
            QVERIFY(report.rows[i].time > report.rows[i - 1].time);
    }
};

TACTUM_TEST(TestSelfTest)

} // namespace test_self_test

#include "test_self_test.moc"
