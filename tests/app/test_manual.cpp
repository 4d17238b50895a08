// What the program says of itself for man and for shells: made from the table of --help, so that it cannot
// leave anything out. The judges are roff and the shells themselves.

#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_manual {

using namespace test_program;

const QStringList kVerbs{"touch", "convert", "simulate", "play",    "info",
                         "check", "verify",  "feel",     "devices", "thumbnail"};

QByteArray manualAs(const QString& form) {
    return runTactum({"manual", form}).out;
}

/// What bash offers for the words of a line, the last of which is being typed.
QStringList completed(const QString& folder, const QStringList& words) {
    QProcess bash;
    bash.setWorkingDirectory(folder);
    bash.start("bash", {"--norc", "-c",
                        QString::fromUtf8(manualAs("bash")) + "\nCOMP_WORDS=(" + words.join(' ') +
                            ")\nCOMP_CWORD=" + QString::number(words.size() - 1) +
                            "\n_tactum\nprintf '%s\\n' \"${COMPREPLY[@]}\""});
    if (!bash.waitForFinished()) return {"bash did not end"};
    return QString::fromUtf8(bash.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts);
}

class TestManual : public QObject, WorkFolder {
    Q_OBJECT

private slots:
    /// Every long option that --help of a verb lists stands in every form.
    void everyOptionOfHelpIsThere_data() {
        QTest::addColumn<QString>("form");
        for (const char* form : {"man", "bash", "zsh", "fish"})
            QTest::newRow(form) << QString(form);
    }
    void everyOptionOfHelpIsThere() {
        QFETCH(QString, form);
        QString text = QString::fromUtf8(manualAs(form));
        text.replace("\\-", "-"); // roff
        const QRegularExpression option("^  (?:-h,)?--([a-z-]+)", QRegularExpression::MultilineOption);
        int seen = 0;
        for (const QString& verb : kVerbs) {
            COMPARE_CONTAINS(text, verb);
            auto found = option.globalMatch(QString::fromUtf8(runTactum({verb, "--help"}).out));
            for (; found.hasNext(); ++seen) {
                const QString name = found.next().captured(1);
                COMPARE_CONTAINS(text, (form == "fish" ? "-l " : "--") + name);
            }
        }
        QCOMPARE_GE(seen, 30); // else --help has another form, and nothing was compared
    }

    void whatIsForTheProgramItselfIsNotTold() {
        for (const char* form : {"man", "bash", "zsh", "fish"})
            for (const char* word : {"device\\-server", "device-server", "makers"})
                COMPARE_LACKS(manualAs(form), QByteArray(word));
    }

    void roffHasNothingToComplainAbout() {
        QProcess groff;
        groff.start("groff", {"-man", "-Tutf8", "-ww", "-z"});
        if (!groff.waitForStarted()) QSKIP("groff is not installed: nobody judges the man page");
        groff.write(manualAs("man"));
        groff.closeWriteChannel();
        QVERIFY(groff.waitForFinished());
        QCOMPARE(groff.readAllStandardError(), QByteArray());
    }

    void bashCompletesVerbsOptionsAndValues() {
        write("model.ply", "x");
        QCOMPARE(completed(folder.path(), {"tactum", "sim"}), QStringList{"simulate"});
        QCOMPARE(completed(folder.path(), {"tactum", "mod"}), QStringList{"model.ply"});
        QCOMPARE(completed(folder.path(), {"tactum", "touch", "--stat"}), QStringList{"--static-friction"});
        QCOMPARE(completed(folder.path(), {"tactum", "touch", "--sides", "b"}),
                 (QStringList{"both", "back"}));
        QCOMPARE(completed(folder.path(), {"tactum", "touch", "--path", "mo"}), QStringList{"model.ply"});
        QCOMPARE(completed(folder.path(), {"tactum", "info", "--stat"}), QStringList{});
    }

    void anotherFormIsWrongUsage() {
        const Ended ended = runTactum({"manual", "html"});
        QCOMPARE(ended.code, 2);
        COMPARE_CONTAINS(oneLine(ended.error), QByteArray("'html' is none of man|bash|zsh|fish"));
    }
};

TACTUM_TEST(TestManual)

} // namespace test_manual

#include "test_manual.moc"
