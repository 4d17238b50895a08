// What a run writes: that it agrees with what was fed, can be gone on with, and is never written over.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/study/answer_log.h"
#include "core/study/log_file.h"
#include "tests/core/study/log_table.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_study_logs {

using namespace tactum;
using namespace tactum::test;

namespace {

TrialFacts facts(int trial) {
    return {"00ff00ff00ff00ff",
            "2026-01-02T03:04:05.678Z",
            1000.5 * trial,
            {0.5, 1.5, 2.5},
            3.25,
            4,
            321.5,
            "A hand",
            1200,
            2};
}

std::string contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// The log of a run whose answers are these, one choice a trial.
std::string logOf(StudyRun& run, const std::vector<int>& choices,
                  const std::vector<std::string>& words = {}) {
    std::string csv = answerHeader(run.design());
    if (run.step() == StudyStep::Instructions) run.proceed();
    for (const int choice : choices) {
        while (run.step() == StudyStep::Stimulus)
            run.proceed();
        if (!run.choose(choice)) return {};
        for (const std::string& one : words)
            if (!run.reply(one)) return {};
        csv += answerRow(run, facts(int(run.done().size())));
    }
    return csv;
}

} // namespace

class TestStudyLogs : public QObject {
    Q_OBJECT

private slots:
    void rowsAreWhatWasAnswered();
    void aStaircaseIsLogged();
    void anyWordsComeBack();
    void aTornRowIsLeftOut();
    void foreignLogsAreRefused_data();
    void foreignLogsAreRefused();
    void aFileIsNeverWrittenOver();
    void aFileGoesOn();
};

void TestStudyLogs::rowsAreWhatWasAnswered() {
    const StudyDesign design = designOf(Procedure::Abx, {"soft", "stiff"}, 4);
    auto run = StudyRun::begin(design, 7, 18446744073709551615u);
    const auto table = tableOf(logOf(*run, {0, 1, 1, 0}));
    QCOMPARE(table.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i) {
        auto row = table[i];
        const DoneTrial& done = run->done()[i];
        const auto name = [&](std::size_t n) {
            return design.conditions[std::size_t(done.trial.intervals[n].condition)];
        };
        QCOMPARE(row["trial"], std::to_string(i + 1));
        QCOMPARE(row["participant"], std::string("7"));
        QCOMPARE(row["seed"], std::string("18446744073709551615"));
        QCOMPARE(row["condition_1"], name(0));
        QCOMPARE(row["condition_2"], name(1));
        QCOMPARE(row["condition_3"], name(2));
        QCOMPARE(row["answer"], std::string(*done.answer.chosen == 0 ? "A" : "B"));
        QCOMPARE(row["chosen"], name(std::size_t(*done.answer.chosen)));
        QCOMPARE(row["correct"], std::string(row["chosen"] == row["condition_3"] ? "1" : "0"));
        QCOMPARE(row["level"], std::string());
        QCOMPARE(row["begun_3_s"], std::string("2.5"));
        QCOMPARE(row["reaction_ms"], std::string("321.5"));
        QCOMPARE(row["ceiling_N_per_m"], std::string("1200"));
        QCOMPARE(row["faults"], std::string("2"));
    }
}

void TestStudyLogs::aStaircaseIsLogged() {
    auto run = StudyRun::begin(staircaseOf(1), 1, 1);
    run->proceed();
    std::string csv = answerHeader(run->design());
    for (const bool right : {true, true, false, true}) {
        run->proceed();
        run->proceed();
        const int correct = *run->trial().right;
        VERIFY_RESULT(run->choose(right ? correct : 1 - correct));
        csv += answerRow(*run, facts(1));
    }
    const auto table = tableOf(csv);
    // 26 right 24 right 22 wrong (a reversal, and the next step) 23 right (another).
    const std::pair<const char*, const char*> expected[] = {
        {"26", "0"}, {"24", "0"}, {"22", "1"}, {"23", "1"}};
    for (std::size_t i = 0; i < 4; ++i) {
        auto row = table[i];
        QCOMPARE(row["level"], std::string(expected[i].first));
        QCOMPARE(row["reversal"], std::string(expected[i].second));
        QCOMPARE(row["parameter"], std::string("stiffness"));
        QCOMPARE(row["unit"], std::string("N/m"));
        const std::string first = row["value_1"], second = row["value_2"];
        QVERIFY(first == "400" || second == "400");
        QVERIFY(std::stod(first) + std::stod(second) == 800 + std::stod(row["level"]));
    }
}

void TestStudyLogs::anyWordsComeBack() {
    StudyDesign design = designOf(Procedure::Pairs, {"a, \"b\"", "=c"}, 2);
    design.name = "x,\ny";
    design.questions.push_back({StudyQuestion::Kind::Text, "Why?", {}, {}, 7, {}});
    design.questions.push_back({StudyQuestion::Kind::Text, "Else?", {}, {}, 7, {}});
    for (const std::string words : {"plain", "a,b", "\"", "\"\",\"\"", "", "\xC3\xA4 '; drop", "a\nb"}) {
        auto run = StudyRun::begin(design, 1, 1);
        const std::string csv = logOf(*run, {0, 1}, {words, "z"});
        QCOMPARE(std::count(csv.begin(), csv.end(), '\n'), 3);
        const auto log = readAnswers(csv, design);
        VERIFY_RESULT(log);
        QCOMPARE(log->answers.size(), std::size_t(2));
        QVERIFY(log->answers[1] == run->done()[1].answer);
        QCOMPARE(log->seed, std::uint64_t(1));
        QCOMPARE(log->scene, std::string("00ff00ff00ff00ff"));
        VERIFY_RESULT(StudyRun::resume(design, 1, 1, log->answers));
    }
}

void TestStudyLogs::aTornRowIsLeftOut() {
    const StudyDesign design = designOf(Procedure::Abx, {"soft", "stiff"}, 4);
    auto run = StudyRun::begin(design, 7, 1);
    const std::string csv = logOf(*run, {0, 1, 1});
    const std::size_t second = csv.rfind('\n', csv.size() - 2) + 1;
    for (const std::size_t torn : {csv.size() - 1, csv.size() - 30, second + 1, second}) {
        const auto log = readAnswers(std::string_view(csv).substr(0, torn), design);
        VERIFY_RESULT(log);
        QCOMPARE(log->answers.size(), std::size_t(2));
        QCOMPARE(log->bytes, second);
    }
}

void TestStudyLogs::foreignLogsAreRefused_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("another study") << "1.1,Trial"
                                   << "1.1,Trail";
    QTest::newRow("columns of before") << "1.1,Trial"
                                       << "1.0,Trial";
    QTest::newRow("a trial twice") << ",abx,,,2,"
                                   << ",abx,,,1,";
    QTest::newRow("another participant") << ",7,1,abx,,,2"
                                         << ",8,1,abx,,,2";
    QTest::newRow("no seed") << ",7,1,abx"
                             << ",7,,abx";
    QTest::newRow("a seed beyond") << ",7,1,abx"
                                   << ",7,18446744073709551616,abx";
    QTest::newRow("an answer that there is not") << ",A,soft"
                                                 << ",C,soft";
    QTest::newRow("too many cells") << ",A,soft"
                                    << ",A,,soft";
    QTest::newRow("quotes that do not end") << ",A,soft"
                                            << ",\"A,soft";
    QTest::newRow("other columns") << "format,"
                                   << "version,";
    QTest::newRow("nothing") << ""
                             << "";
}

void TestStudyLogs::foreignLogsAreRefused() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    const StudyDesign design = designOf(Procedure::Abx, {"soft", "stiff"}, 4);
    auto run = StudyRun::begin(design, 7, 1);
    QString csv = QString::fromStdString(logOf(*run, {0, 0, 0, 0}));
    VERIFY_RESULT(readAnswers(csv.toStdString(), design));
    if (from.isEmpty())
        csv.clear();
    else
        COMPARE_CONTAINS(csv, from);
    csv.replace(from, to);
    const auto log = readAnswers(csv.toStdString(), design);
    COMPARE_CONTAINS(refusal(log), "begin a new run");
}

void TestStudyLogs::aFileIsNeverWrittenOver() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    const std::filesystem::path file(path.toStdString());
    {
        auto log = LogFile::create(file);
        VERIFY_RESULT(log);
        VERIFY_RESULT(log->write("first\n"));
        QCOMPARE(contentOf(path), std::string("first\n")); // before it is closed
        VERIFY_RESULT(log->keep());
    }
    COMPARE_CONTAINS(refusal(LogFile::create(file)), "a.csv");
    QCOMPARE(contentOf(path), std::string("first\n"));
    COMPARE_CONTAINS(refusal(LogFile::create(file / "b.csv")), "choose a folder");
}

void TestStudyLogs::aFileGoesOn() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    const std::filesystem::path file(path.toStdString());
    VERIFY_RESULT(LogFile::create(file)->write("whole\ntor"));
    auto log = LogFile::goOn(file, 6);
    VERIFY_RESULT(log);
    VERIFY_RESULT(log->write("next\n"));
    QCOMPARE(contentOf(path), std::string("whole\nnext\n"));
    QVERIFY(!LogFile::goOn(file / "none", 0));
}

} // namespace test_study_logs

using test_study_logs::TestStudyLogs;
TACTUM_TEST(TestStudyLogs)
#include "test_study_logs.moc"
