// What goes wrong on the command line: one line that says what to do, and an exit code that says whose fault
// it is.

#include <QDir>
#include <QFile>
#include <QImageReader>
#include <QProcess>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_command_errors {

using namespace test_program;

class TestCommandErrors : public QObject, WorkFolder {
    Q_OBJECT

private slots:
    void whereStandardInputIsReadIsSaid() {
        for (const char* verb : {"touch", "simulate", "convert", "info", "check", "feel"})
            COMPARE_CONTAINS(runTactum({verb, "--help"}).out, "- is standard input");
    }

    void wrongUsageIsTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no scene") << QStringList{"info"};
        QTest::newRow("unknown option") << QStringList{"check", "x.obj", "--nonsense"};
        QTest::newRow("unknown flag without verb") << QStringList{"--nonsense"};
        QTest::newRow("server without a port") << QStringList{"--connect", "localhost"};
        QTest::newRow("server of port 0") << QStringList{"--connect", "localhost:0"};
        QTest::newRow("a verb at a server") << QStringList{"--connect", "localhost:1", "info", "x.obj"};
        QTest::newRow("credentials for nobody") << QStringList{"--credentials", "/tmp"};
        QTest::newRow("not a number") << QStringList{"touch", "x", "--path", "y", "--stiffness", "1,5"};
        QTest::newRow("negative radius") << QStringList{"touch", "x", "--path", "y", "--proxy-radius", "-1"};
        QTest::newRow("infinite") << QStringList{"touch", "x", "--path", "y", "--fit-diagonal", "inf"};
        QTest::newRow("shading maybe") << QStringList{"touch", "x", "--path", "y", "--shading", "maybe"};
        QTest::newRow("no side") << QStringList{"touch", "x", "--path", "y", "--sides", "inside"};
        QTest::newRow("more hands than can be") << QStringList{"touch",  "x", "--path", "a", "--path", "b",
                                                               "--path", "c", "--path", "d", "--path", "e"};
        QTest::newRow("one result of two hands")
            << QStringList{"touch", "x", "--path", "a", "--path", "b", "--out", "c"};
        QTest::newRow("two results of one hand")
            << QStringList{"touch", "x", "--path", "a", "--out", "b", "--out", "c"};
        QTest::newRow("two hands in one file")
            << QStringList{"touch", "x", "--path", "a", "--path", "b", "--out", "-", "--out", "-"};
        QTest::newRow("the vibration of two hands")
            << QStringList{"touch", "x", "--path", "a", "--path", "b", "--vibration", "c.wav"};
        QTest::newRow("self-test of no id") << QStringList{"devices", "--self-test", ""};
        QTest::newRow("a folder without a self-test") << QStringList{"devices", "--out", "x"};
        QTest::newRow("contradicting friction") << QStringList{
            "touch", "x", "--path", "y", "--static-friction", "0.2", "--dynamic-friction", "0.5"};
    }
    void wrongUsageIsTwo() {
        QFETCH(QStringList, arguments);
        const Ended ended = runTactum(arguments);
        QCOMPARE(ended.code, 2);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        QVERIFY(ended.out.isEmpty());
    }

    void anEmptyNameIsWrongUsage_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("which");
        const QString recording = TACTUM_REPLAYS "/few-bumps.tactum-recording";
        QTest::newRow("window") << QStringList{""} << "SCENE";
        QTest::newRow("info") << QStringList{"info", ""} << "SCENE";
        QTest::newRow("check") << QStringList{"check", ""} << "SCENE";
        QTest::newRow("touch") << QStringList{"touch", "", "--path", "x.csv"} << "SCENE";
        QTest::newRow("path") << QStringList{"touch", "x.obj", "--path", ""} << "--path";
        QTest::newRow("play") << QStringList{"play", ""} << "RECORDING";
        QTest::newRow("out") << QStringList{"play", recording, "--out", ""} << "--out";
        QTest::newRow("summary") << QStringList{"play", recording, "--summary", ""} << "--summary";
        QTest::newRow("from nothing") << QStringList{"convert", "", "x.glb"} << "IN";
        QTest::newRow("to nothing") << QStringList{"convert", "x.obj", ""} << "OUT";
    }
    void anEmptyNameIsWrongUsage() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, which);
        const Ended ended = runTactum(arguments);
        QCOMPARE(ended.code, 2);
        QVERIFY2(
            oneLine(ended.error).startsWith("tactum: " + which.toUtf8() + ": is an empty name; name a file;"),
            ended.error);
    }

    void theRemedyIsACommandThatThereIs() {
        QVERIFY(oneLine(runTactum({"--nonsense"}).error).endsWith("; see tactum --help"));
        QVERIFY(
            oneLine(runTactum({"check", "x.obj", "--nonsense"}).error).endsWith("; see tactum check --help"));
        const QByteArray ratio = runTactum({"touch", "x", "--path", "y", "--static-friction", ""}).error;
        QVERIFY2(oneLine(ratio).contains("from 0 to 2; see tactum touch --help"), ratio);
    }

    void badInputIsOne() {
        const QString path = pressAndSlide(0.002, 0);
        const QString broken = write("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
        for (const QStringList& arguments :
             {QStringList{"touch", broken, "--path", path}, QStringList{"info", broken},
              QStringList{"check", broken}, QStringList{"info", file("missing.obj")},
              QStringList{"touch", plate(), "--path", file("missing.csv")}}) {
            const Ended ended = runTactum(arguments);
            QCOMPARE(ended.code, 1);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        COMPARE_CONTAINS(runTactum({"info", broken}).error, "broken.obj:3"); // where
    }

    void unwritableOutputIsThree() {
        const QString path = pressAndSlide(0.002, 0);
        const Ended ended =
            runTactum({"touch", plate(), "--path", path, "--out", file("no/such/folder.csv")});
        QCOMPARE(ended.code, 3);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        QCOMPARE(runTactum({"touch", plate(), "--path", path, "--picture", file("p.png")}).code,
                 3); // no display
    }

    void aVibrationIsWrittenByItsEnding() {
        const QStringList touch{"touch", plate(), "--path", pressAndSlide(0.002, 0), "--vibration"};
        QCOMPARE(runTactum(touch + QStringList{file("a.haptic")}).code, 0);
        QFile written(file("a.haptic"));
        QVERIFY2(written.open(QIODevice::ReadOnly), qPrintable(written.errorString()));
        COMPARE_CONTAINS(written.readAll(), "full scale is");
        const Ended other = runTactum(touch + QStringList{file("a.ogg")});
        QCOMPARE(other.code, 2);
        COMPARE_CONTAINS(oneLine(other.error), ".wav, .hjif and .haptic");
    }

    void resultsNeverReplaceTheirInputs() {
        const QString path = pressAndSlide(0.002, 0), model = plate();
        for (const QStringList& outputs : {QStringList{"--out", model}, QStringList{"--out", path},
                                           QStringList{"--out", file("same"), "--summary", file("same")}}) {
            const Ended ended = runTactum(QStringList{"touch", model, "--path", path} + outputs);
            QCOMPARE(ended.code, 2);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        QCOMPARE(runTactum({"info", model}).code, 0); // still a model
    }

    void theWindowNeedsADisplay() {
        const Ended ended = runTactum({plate()});
        QCOMPARE(ended.code, 3);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
    }

    void whatCannotBeOpenedIsSaidBeforeTheDisplay() {
        const Ended missing = runTactum({file("missing.obj")});
        QCOMPARE(missing.code, 1);
        QVERIFY2(oneLine(missing.error).contains("missing.obj: no such file"), missing.error);
        const Ended mistyped = runTactum({"chekc"});
        QCOMPARE(mistyped.code, 2);
        QVERIFY2(oneLine(mistyped.error).contains("'chekc' is no verb"), mistyped.error);
    }

    void aDisplayThatCannotBeReachedIsThree() {
        const QString path = pressAndSlide(0.002, 0);
        for (const QStringList& arguments :
             {QStringList{plate()},
              QStringList{"touch", plate(), "--path", path, "--picture", file("p.png")}}) {
            const Ended ended = runTactum(arguments, ":4711");
            QCOMPARE(ended.code, 3);
            QVERIFY2(oneLine(ended.error).contains("the display :4711 cannot be reached"), ended.error);
        }
    }

    void aRecordingBecomesAVideo() {
        const QString recording = TACTUM_REPLAYS "/few-bumps.tactum-recording";
        const QStringList play{"play", recording, "--video"};
        QCOMPARE(runTactum(play + QStringList{file("a.webm")}).code, 3); // no display
        const Ended other = runTactum(play + QStringList{file("a.avi")});
        QCOMPARE(other.code, 2);
        COMPARE_CONTAINS(oneLine(other.error), "a.avi: a video is written as .webm or .gif");
        QCOMPARE(runTactum({"play", recording, "--plot"}).code, 2); // of what?
        const QString display = qEnvironmentVariable("DISPLAY");
        if (display.isEmpty()) QSKIP("there is no display to draw on");
        const Ended ended =
            runTactum(play + QStringList{file("a.gif"), "--height", "180", "--plot"}, display);
        QVERIFY2(ended.code == 0, ended.error);
        const QImageReader picture(file("a.gif"));
        QCOMPARE(picture.size(), QSize(320, 180));
        const Ended away = runTactum(play + QStringList{file("no/a.webm")}, display);
        QCOMPARE(away.code, 3);
        COMPARE_CONTAINS(away.error, "a.webm: cannot be written");
    }

    void aDisplayWithoutOpenGlIsThree() {
        const QString display = qEnvironmentVariable("DISPLAY");
        if (display.isEmpty()) QSKIP("there is no display to take OpenGL from");
        qputenv("QT_XCB_GL_INTEGRATION", "none");
        const Ended ended = runTactum({plate()}, display);
        qunsetenv("QT_XCB_GL_INTEGRATION");
        QCOMPARE(ended.code, 3);
        QVERIFY2(oneLine(ended.error).contains("has no OpenGL 3.2"), ended.error);
    }

    void aFullDiskUnderStandardOutputIsThree() {
        QProcess shell;
        shell.start("sh", {"-c", QStringLiteral("'%1' devices > /dev/full").arg(TACTUM_PROGRAM)});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 3);
    }

    /// The scene still goes from the reader to us: what is written is longer.
    void aFileThatMayNotGrowIsThree() {
        QByteArray rows = "t,x,y,z\n";
        for (int i = 0; i < 2000; ++i)
            rows += QByteArray::number(1e-3 * i) + ",0,0.01,0\n";
        const QString path = write("long-path.csv", rows);
        for (const QString& verb : {QStringLiteral("touch '%1' --path '%2'").arg(plate(), path),
                                    QStringLiteral("play '" TACTUM_REPLAYS "/few-bumps.tactum-recording'")}) {
            QProcess shell;
            shell.start("sh", {"-c", QStringLiteral("ulimit -f 64; exec '%1' %2 --out '%3'")
                                         .arg(TACTUM_PROGRAM, verb, file("long.csv"))});
            QVERIFY(shell.waitForFinished(60000));
            QCOMPARE_EQ(shell.exitStatus(), QProcess::NormalExit);
            QCOMPARE(shell.exitCode(), 3);
            QVERIFY(oneLine(shell.readAllStandardError()).contains("long.csv"));
        }
    }

    void aFolderIsCalledOne() {
        const QString path = pressAndSlide(0.002, 0), here = file(".");
        for (const QStringList& arguments :
             {QStringList{"play", here}, QStringList{"touch", plate(), "--path", here},
              QStringList{"touch", here, "--path", path}, QStringList{"info", here},
              QStringList{"check", here}, QStringList{"convert", here, file("to.glb")}}) {
            const Ended ended = runTactum(arguments);
            QCOMPARE(ended.code, 1);
            QVERIFY2(oneLine(ended.error).contains("is a folder; name a file in it"), ended.error);
        }
    }

    void whatIsThereButNoFileIsNotMissing() {
        const QString pipe = file("no-file");
        QCOMPARE(QProcess::execute("mkfifo", {pipe}), 0);
        for (const QString& name : {QString("/dev/zero"), pipe})
            for (const char* verb : {"play", "info"}) {
                const Ended ended = runTactum({verb, name});
                QCOMPARE(ended.code, 1);
                QVERIFY2(oneLine(ended.error).contains(name.toUtf8() + ": cannot be read as a file"),
                         ended.error);
            }
    }

    /// The first bytes are of no format that is known: there is no reason to wait for the last ones.
    void whatGoesOnForEverIsNotReadToItsEnd() {
        for (const char* input : {"cat /dev/zero", "yes"}) {
            QProcess shell;
            shell.start("sh", {"-c", QStringLiteral("%1 | '%2' info -").arg(input, TACTUM_PROGRAM)});
            QVERIFY(shell.waitForFinished(60000));
            QCOMPARE(shell.exitCode(), 1);
            const QByteArray error = shell.readAllStandardError();
            QVERIFY2(oneLine(error).contains("standard input: cannot tell its format"), error);
        }
    }

    // A new file would take the place of a pipe; or of the file with everything else that we say.
    void resultsGoIntoPipesDevicesAndOurOwnOutput() {
        const auto path = write("stream.csv", "t,x,y,z\n0,0,0.01,0\n0.001,0,0.009,0\n");
        const QString touch =
            QStringLiteral("'%1' touch '%2' --path '%3' --out ").arg(TACTUM_PROGRAM, plate(), path);
        const QString all = file("all.txt"), pipe = file("pipe");
        for (const QString& command :
             {touch + "/dev/stdout | cat > '" + all + "'", touch + "/dev/stdout > '" + all + "'",
              touch + "'" + all + "' > '" + all + "'",
              "mkfifo '" + pipe + "'; cat '" + pipe + "' > '" + all + "' & " + touch + "'" + pipe + "' >> '" +
                  all + ".later'; wait; cat '" + all + ".later' >> '" + all + "'"}) {
            QProcess shell;
            shell.start("sh", {"-c", command});
            QVERIFY(shell.waitForFinished(60000));
            QFile in(all);
            QVERIFY(in.open(QIODevice::ReadOnly));
            const QList<QByteArray> lines = in.readAll().split('\n');
            QCOMPARE(lines.size(), 5); // a header, two rows, the summary, and nothing after it
            QVERIFY2(lines[0].startsWith("t,finger_x") && lines[3].startsWith("{\"version\""), lines[0]);
        }
        QCOMPARE(runTactum({"touch", plate(), "--path", path, "--out", "/dev/null"}).code, 0);
        QVERIFY(!QFileInfo("/dev/null").isFile());
        QCOMPARE(runTactum({"touch", plate(), "--path", path, "--out", "/dev/full"}).code, 3);
    }

    void whatCannotBePlayedIsOne() {
        for (const QString& recording :
             {plate(), file("nothing.tactum-recording"), write("torn.tactum-recording", "TACTUMRC")}) {
            const Ended ended = runTactum({"play", recording});
            QCOMPARE(ended.code, 1);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        QCOMPARE(runTactum({"play"}).code, 2);
        const QString copy = write("copy.tactum-recording", "x");
        QCOMPARE(runTactum({"play", copy, "--out", copy}).code, 2);
    }
};

TACTUM_TEST(TestCommandErrors)

} // namespace test_command_errors

#include "test_command_errors.moc"
