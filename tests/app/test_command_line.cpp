// The command line is a contract: verbs, options, columns, keys and exit codes, driven from outside.

#include <cmath>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/program.h"

using namespace test_program;

namespace {

using Row = QList<double>;

QList<Row> rowsOf(const QString& file) {
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly)) return {};
    QList<Row> rows;
    in.readLine();
    while (!in.atEnd()) {
        Row row;
        for (const QByteArray& cell : in.readLine().trimmed().split(','))
            row.append(cell.toDouble());
        rows.append(row);
    }
    return rows;
}

enum Column {
    T,
    FingerX,
    FingerY,
    FingerZ,
    ProxyX,
    ProxyY,
    ProxyZ,
    ForceX,
    ForceY,
    ForceZ,
    Contacts,
    UpdateNs
};

} // namespace

class TestCommandLine : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    QString file(const QString& name) const { return folder_.filePath(name); }

    QString write(const QString& name, const QByteArray& text) const {
        QFile out(file(name));
        if (!out.open(QIODevice::WriteOnly)) return {};
        out.write(text);
        return file(name);
    }

    // A square plate of two triangles in the plane z = 0, 0.2 m wide.
    QString plate() const {
        return write("plate.obj", "v -0.1 -0.1 0\nv 0.1 -0.1 0\nv 0.1 0.1 0\nv -0.1 0.1 0\nf 1 2 3 4\n");
    }

    // Two groups of one material with a picture of heights, which is a layer on each.
    QString bumpyPlate() const {
        write("grain.png",
              QByteArray::fromBase64("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAA"
                                     "AggCBd81ytgAAAABJRU5ErkJggg=="));
        write("grain.mtl", "newmtl grainy\nmap_bump grain.png\n");
        return write("bumpy.obj", "mtllib grain.mtl\nv 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\n"
                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl grainy\n"
                                  "g low\nf 1/1 2/2 3/3\ng high\nf 1/1 3/3 4/4\n");
    }

    // Straight down onto the plate to `depth`, then along x by `along`, at 1 kHz.
    QString pressAndSlide(double depth, double along) const {
        QByteArray text = "t,x,y,z\n";
        int row = 0;
        auto add = [&](double x, double z) {
            text += QByteArray::number(row++ * 1e-3, 'g', 17) + ',' + QByteArray::number(x, 'g', 17) +
                    ",0.003," + QByteArray::number(z, 'g', 17) + '\n';
        };
        for (int i = 0; i <= 200; ++i)
            add(0.01, 0.01 - (0.01 + depth) * i / 200.0);
        for (int i = 1; i <= 400; ++i)
            add(0.01 + along * i / 400.0, -depth);
        return write("path.csv", text);
    }

    static QByteArray oneLine(const QByteArray& text) {
        return text.count('\n') == 1 ? text.trimmed() : QByteArray();
    }

private slots:
    void touchWritesTheColumnsOfTheContract() {
        const QString path = pressAndSlide(0.004, 0.01);
        const Ended ended = tactum({"touch", plate(), "--path", path, "--out", file("touch.csv"), "--summary",
                                    file("touch.json"), "--proxy-radius", "0.001", "--stiffness", "500"});
        QVERIFY2(ended.code == 0, ended.error);
        QFile out(file("touch.csv"));
        QVERIFY(out.open(QIODevice::ReadOnly));
        QCOMPARE(out.readLine().trimmed(),
                 QByteArray("t,finger_x,finger_y,finger_z,proxy_x,proxy_y,proxy_z,force_x,"
                            "force_y,force_z,contacts,update_ns"));
        const QList<Row> rows = rowsOf(file("touch.csv"));
        QCOMPARE(rows.size(), 601);
        const Row& last = rows.last();
        QCOMPARE(last.size(), 12);
        // The proxy stays a radius above the plate; the spring pushes the finger up by k times the distance.
        QVERIFY(std::abs(last[ProxyZ] - 0.001) < 1e-8);
        QVERIFY(std::abs(last[ForceZ] - 500 * 0.005) < 1e-5);
        QCOMPARE(int(last[Contacts]), 1);
        QCOMPARE(last[FingerY], 0.003); // full precision: reads back as the same double
    }

    void touchPrintsTheSummary() {
        const QString path = pressAndSlide(0.002, 0);
        const Ended ended = tactum({"touch", plate(), "--path", path, "--summary", file("s.json")});
        QCOMPARE(ended.code, 0);
        const QJsonObject printed = QJsonDocument::fromJson(ended.out).object();
        QFile saved(file("s.json"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(QJsonDocument::fromJson(saved.readAll()).object(), printed);
        QCOMPARE(printed["triangles"].toInt(), 2);
        QCOMPARE(printed["updates"].toInt(), 601);
        for (const char* key : {"load_s", "build_s", "peak_rss_bytes", "hierarchy_bytes"})
            QVERIFY2(printed[key].toDouble() > 0, key);
        const QJsonObject times = printed["update_ns"].toObject();
        for (const char* key : {"mean", "median", "p99", "p999", "max"})
            QVERIFY2(times[key].toDouble() > 0, key);
        QVERIFY(times["median"].toDouble() <= times["p99"].toDouble());
        QVERIFY(times["p999"].toDouble() <= times["max"].toDouble());
    }

    // A roof of two slopes, and a finger that is pressed below its ridge a little to one side.
    void touchShadesWhenAsked() {
        const QString roof = write("roof.obj", "v -0.1 -0.1 -0.02\nv -0.1 0.1 -0.02\nv 0 -0.1 0\nv 0 0.1 0\n"
                                               "v 0.1 -0.1 -0.02\nv 0.1 0.1 -0.02\nf 1 3 4 2\nf 3 5 6 4\n");
        const QString path = pressAndSlide(0.006, 0);
        const auto lean = [&](const QString& shading) {
            const Ended ended = tactum({"touch", roof, "--path", path, "--out", file("roof.csv"),
                                        "--proxy-radius", "0.001", "--shading", shading});
            if (ended.code != 0 || !ended.error.isEmpty()) return -1.0;
            const Row last = rowsOf(file("roof.csv")).last();
            return last[ForceX] / last[ForceZ];
        };
        // The facet is inclined by 0.2; near the ridge the felt normal is nearly upright.
        QVERIFY(std::abs(lean("off") - 0.2) < 1e-3);
        QVERIFY(lean("on") > 0 && lean("on") < 0.1);
    }

    // The plate's corners run counter-clockwise seen from +z, where the finger comes from.
    void touchFeelsTheSidesThatItIsGiven() {
        const QString path = pressAndSlide(0.004, 0);
        for (const auto& [sides, felt] :
             {std::pair{"both", true}, std::pair{"front", true}, std::pair{"back", false}}) {
            QCOMPARE(
                tactum({"touch", plate(), "--path", path, "--out", file("sides.csv"), "--sides", sides}).code,
                0);
            const Row last = rowsOf(file("sides.csv")).last();
            QCOMPARE(last[Contacts] == 1 && last[ForceZ] > 1, felt);
        }
    }

    void touchIsDeterministicToTheBit() {
        const QString path = pressAndSlide(0.004, 0.03);
        QList<QList<Row>> runs;
        for (const char* name : {"a.csv", "b.csv"}) {
            QCOMPARE(tactum({"touch", plate(), "--path", path, "--out", file(name), "--static-friction",
                             "0.5", "--dynamic-friction", "0.3", "--viscosity", "2"})
                         .code,
                     0);
            runs.append(rowsOf(file(name)));
            for (Row& row : runs.last())
                row[UpdateNs] = 0;
        }
        QVERIFY(!runs[0].isEmpty());
        QCOMPARE(runs[0], runs[1]);
    }

    void aDashIsStandardOutput() {
        const QString path = pressAndSlide(0.002, 0);
        const QString recording = QStringLiteral(TACTUM_REPLAYS "/few-bumps.tactum-recording");
        for (const auto& [arguments, rows] :
             {std::pair{QStringList{"touch", plate(), "--path", path, "--out", "-"}, 601},
              std::pair{QStringList{"play", recording, "--out", "-"}, 800}}) {
            const Ended ended = tactum(arguments + QStringList{"--summary", "s.json"}, {}, folder_.path());
            QVERIFY2(ended.code == 0, ended.error);
            const QList<QByteArray> lines = ended.out.trimmed().split('\n'); // the table, and nothing else
            QCOMPARE(lines.size(), rows + 1);
            QVERIFY(lines.first().startsWith("t,finger_x"));
            for (const QByteArray& line : lines)
                QCOMPARE(line.count(','), 11);
            QVERIFY(!QFile::exists(file("-")));
            QVERIFY(QFile::exists(file("s.json")));
        }
        const Ended summary = tactum({"touch", plate(), "--path", path, "--summary", "-"});
        QVERIFY2(!oneLine(summary.out).isEmpty(), summary.out); // once
        for (const char* verb : {"touch", "play"})
            QVERIFY2(tactum({verb, "--help"}).out.contains("- is standard output"), verb);
    }

    void frictionHoldsAndSlidesAsGiven() {
        const QString path = pressAndSlide(0.004, 0.02);
        QCOMPARE(tactum({"touch", plate(), "--path", path, "--out", file("f.csv"), "--proxy-radius", "0.001",
                         "--stiffness", "1000", "--static-friction", "0.6", "--dynamic-friction", "0.4"})
                     .code,
                 0);
        double most = 0;
        const QList<Row> rows = rowsOf(file("f.csv"));
        for (const Row& row : rows)
            if (row[ForceZ] > 4) most = std::max(most, -row[ForceX] / row[ForceZ]);
        QVERIFY2(std::abs(most - 0.6) < 0.02, qPrintable(QString::number(most))); // a step of 50 um over 5 mm
        QVERIFY(std::abs(-rows.last()[ForceX] / rows.last()[ForceZ] - 0.4) < 1e-6);
    }

    // One coefficient is that of both: the slide pulls as hard as the hold did at last.
    void staticFrictionAloneIsDynamicToo() {
        const QString path = pressAndSlide(0.004, 0.02);
        QCOMPARE(tactum({"touch", plate(), "--path", path, "--out", file("s.csv"), "--proxy-radius", "0.001",
                         "--static-friction", "0.5"})
                     .code,
                 0);
        const Row last = rowsOf(file("s.csv")).last();
        QVERIFY(std::abs(-last[ForceX] / last[ForceZ] - 0.5) < 1e-6);
    }

    void fitDiagonalScalesAboutTheBoxCentre() {
        const QString big =
            write("big.obj", "v 1000 1000 7\nv 1020 1000 7\nv 1020 1020 7\nv 1000 1020 7\nf 1 2 3 4\n");
        const QString path = pressAndSlide(0.002, 0);
        QCOMPARE(tactum({"touch", big, "--path", path, "--out", file("fit.csv"), "--fit-diagonal", "0.2",
                         "--proxy-radius", "0.001"})
                     .code,
                 0);
        QVERIFY(std::abs(rowsOf(file("fit.csv")).last()[ProxyZ] - 0.001) < 1e-8);
    }

    void wrongUsageIsTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("no path") << QStringList{"touch", "x.obj"};
        QTest::newRow("no scene") << QStringList{"info"};
        QTest::newRow("unknown option") << QStringList{"check", "x.obj", "--nonsense"};
        QTest::newRow("unknown flag without verb") << QStringList{"--nonsense"};
        QTest::newRow("not a number") << QStringList{"touch", "x", "--path", "y", "--stiffness", "1,5"};
        QTest::newRow("negative radius") << QStringList{"touch", "x", "--path", "y", "--proxy-radius", "-1"};
        QTest::newRow("infinite") << QStringList{"touch", "x", "--path", "y", "--fit-diagonal", "inf"};
        QTest::newRow("shading maybe") << QStringList{"touch", "x", "--path", "y", "--shading", "maybe"};
        QTest::newRow("no side") << QStringList{"touch", "x", "--path", "y", "--sides", "inside"};
        QTest::newRow("contradicting friction") << QStringList{
            "touch", "x", "--path", "y", "--static-friction", "0.2", "--dynamic-friction", "0.5"};
    }
    void wrongUsageIsTwo() {
        QFETCH(QStringList, arguments);
        const Ended ended = tactum(arguments);
        QCOMPARE(ended.code, 2);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        QVERIFY(ended.out.isEmpty());
    }

    void badInputIsOne() {
        const QString path = pressAndSlide(0.002, 0);
        const QString broken = write("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
        for (const QStringList& arguments :
             {QStringList{"touch", broken, "--path", path}, QStringList{"info", broken},
              QStringList{"check", broken}, QStringList{"info", file("missing.obj")},
              QStringList{"touch", plate(), "--path", file("missing.csv")}}) {
            const Ended ended = tactum(arguments);
            QCOMPARE(ended.code, 1);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        QVERIFY(tactum({"info", broken}).error.contains("broken.obj:3")); // where
    }

    void unwritableOutputIsThree() {
        const QString path = pressAndSlide(0.002, 0);
        const Ended ended = tactum({"touch", plate(), "--path", path, "--out", file("no/such/folder.csv")});
        QCOMPARE(ended.code, 3);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        QCOMPARE(tactum({"touch", plate(), "--path", path, "--picture", file("p.png")}).code,
                 3); // no display
    }

    void resultsNeverReplaceTheirInputs() {
        const QString path = pressAndSlide(0.002, 0), model = plate();
        for (const QStringList& outputs : {QStringList{"--out", model}, QStringList{"--out", path},
                                           QStringList{"--out", file("same"), "--summary", file("same")}}) {
            const Ended ended = tactum(QStringList{"touch", model, "--path", path} + outputs);
            QCOMPARE(ended.code, 2);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        QCOMPARE(tactum({"info", model}).code, 0); // still a model
    }

    void theWindowNeedsADisplay() {
        const Ended ended = tactum({plate()});
        QCOMPARE(ended.code, 3);
        QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
    }

    void whatCannotBeOpenedIsSaidBeforeTheDisplay() {
        const Ended missing = tactum({file("missing.obj")});
        QCOMPARE(missing.code, 1);
        QVERIFY2(oneLine(missing.error).contains("missing.obj: no such file"), missing.error);
        const Ended mistyped = tactum({"chekc"});
        QCOMPARE(mistyped.code, 2);
        QVERIFY2(oneLine(mistyped.error).contains("'chekc' is no verb"), mistyped.error);
    }

    void aDisplayThatCannotBeReachedIsThree() {
        const QString path = pressAndSlide(0.002, 0);
        for (const QStringList& arguments :
             {QStringList{plate()},
              QStringList{"touch", plate(), "--path", path, "--picture", file("p.png")}}) {
            const Ended ended = tactum(arguments, ":4711");
            QCOMPARE(ended.code, 3);
            QVERIFY2(oneLine(ended.error).contains("the display :4711 cannot be reached"), ended.error);
        }
    }

    void aDisplayWithoutOpenGlIsThree() {
        const QString display = qEnvironmentVariable("DISPLAY");
        if (display.isEmpty()) QSKIP("there is no display to take OpenGL from");
        qputenv("QT_XCB_GL_INTEGRATION", "none");
        const Ended ended = tactum({plate()}, display);
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
            QVERIFY(shell.exitStatus() == QProcess::NormalExit);
            QCOMPARE(shell.exitCode(), 3);
            QVERIFY(oneLine(shell.readAllStandardError()).contains("long.csv"));
        }
    }

    void aFolderIsCalledOne() {
        const QString path = pressAndSlide(0.002, 0), folder = file(".");
        for (const QStringList& arguments :
             {QStringList{"play", folder}, QStringList{"touch", plate(), "--path", folder},
              QStringList{"touch", folder, "--path", path}, QStringList{"info", folder},
              QStringList{"check", folder}, QStringList{"convert", folder, file("to.glb")}}) {
            const Ended ended = tactum(arguments);
            QCOMPARE(ended.code, 1);
            QVERIFY2(oneLine(ended.error).contains("is a folder; name a file in it"), ended.error);
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
            QVERIFY2(lines[0].startsWith("t,finger_x") && lines[3].startsWith("{\"triangles\""), lines[0]);
        }
        QCOMPARE(tactum({"touch", plate(), "--path", path, "--out", "/dev/null"}).code, 0);
        QVERIFY(!QFileInfo("/dev/null").isFile());
        QCOMPARE(tactum({"touch", plate(), "--path", path, "--out", "/dev/full"}).code, 3);
    }

    void playComparesEveryBit() {
        const QString recording = QStringLiteral(TACTUM_REPLAYS "/few-bumps.tactum-recording");
        const Ended ended =
            tactum({"play", recording, "--out", file("again.csv"), "--summary", file("again.json")});
        QVERIFY2(ended.code == 0, ended.error);
        QVERIFY2(ended.out.startsWith("1200 steps, 0 differ\n"), ended.out);
        QVERIFY(ended.out.contains("FAULT: the device was lost\n"));
        QCOMPARE(rowsOf(file("again.csv")).size(), 800);
        QFile summary(file("again.json"));
        QVERIFY(summary.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(summary.readAll()).object();
        QCOMPARE(json["haptic_steps"].toInt(), 800);
        QCOMPARE(json["servo_ticks"].toInt(), 400);
        QCOMPARE(json["differ"].toInt(-1), 0);
        QVERIFY(json["events"].toArray().size() > 5);
    }

    void whatCannotBePlayedIsOne() {
        for (const QString& recording :
             {plate(), file("nothing.tactum-recording"), write("torn.tactum-recording", "TACTUMRC")}) {
            const Ended ended = tactum({"play", recording});
            QCOMPARE(ended.code, 1);
            QVERIFY2(!oneLine(ended.error).isEmpty(), ended.error);
        }
        QCOMPARE(tactum({"play"}).code, 2);
        const QString copy = write("copy.tactum-recording", "x");
        QCOMPARE(tactum({"play", copy, "--out", copy}).code, 2);
    }

    void infoNamesEverything() {
        const Ended text = tactum({"info", plate()});
        QCOMPARE(text.code, 0);
        QVERIFY(text.out.contains("stiffness") && text.out.contains("N/m") &&
                text.out.contains("2 triangles"));
        const Ended json = tactum({"info", plate(), "--json"});
        QCOMPARE(json.code, 0);
        const QJsonObject scene = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(scene["triangles"].toInt(), 2);
        const QJsonObject object = scene["objects"].toArray().at(0).toObject();
        const QJsonObject surface = object["surfaces"].toArray().at(0).toObject();
        const QJsonObject parameters = surface["parameters"].toObject();
        for (const char* key : {"stiffness", "damping", "static-friction", "dynamic-friction", "viscosity"})
            QVERIFY2(parameters[key].toObject().contains("value") &&
                         parameters[key].toObject().contains("unit"),
                     key);
        QCOMPARE(surface["sides"].toString(), QString("both"));
        QVERIFY(text.out.contains("sides both"));
        QCOMPARE(object["health"].toObject()["boundary_edges"].toInt(), 4);
    }

    void infoShowsShadingAndLayers() {
        const Ended text = tactum({"info", bumpyPlate()});
        QVERIFY2(text.code == 0, text.error);
        QCOMPARE(text.out.count("    shading off\n"), 2);
        QCOMPARE(text.out.count("    layer grain.png: image grain.png, mapping uv-unit, height 2e-04 m, "
                                "blend add, opacity 1\n"),
                 2);
        const QJsonObject scene =
            QJsonDocument::fromJson(tactum({"info", bumpyPlate(), "--json"}).out).object();
        const QJsonObject surface =
            scene["objects"].toArray().at(0).toObject()["surfaces"].toArray().at(1).toObject();
        QCOMPARE(surface["shading"].toObject()["on"], QJsonValue(false));
        const QJsonObject layer = surface["layers"].toArray().at(0).toObject();
        for (const auto& [key, value] : {std::pair{"name", "grain.png"},
                                         {"source", "image"},
                                         {"image", "grain.png"},
                                         {"mapping", "uv-unit"},
                                         {"target", "height"},
                                         {"blend", "add"}})
            QCOMPARE(layer[key].toString(), QString(value));
        QCOMPARE(layer["strength"].toObject()["value"].toDouble(), 2e-4);
        QCOMPARE(layer["strength"].toObject()["unit"].toString(), QString("m"));
    }

    void checkSaysEverythingOnce() {
        for (const QString& scene : {plate(), bumpyPlate()}) {
            const Ended check = tactum({"check", scene});
            QCOMPARE(check.code, 0);
            const QList<QByteArray> lines = check.out.trimmed().split('\n');
            QVERIFY(check.out.contains("open rim"));
            for (const QByteArray& line : lines)
                QVERIFY2(lines.count(line) == 1, line);
        }
        QVERIFY(tactum({"check", bumpyPlate()}).out.contains("has no unit"));
    }

    void checkAndDevicesAnswer() {
        const Ended check = tactum({"check", plate()});
        QCOMPARE(check.code, 0);
        QVERIFY(!check.out.isEmpty());
        const Ended devices = tactum({"devices"});
        QCOMPARE(devices.code, 0);
        QVERIFY(devices.out.contains("Simulated hand: ready"));
    }

    void helpIsZero() {
        QCOMPARE(tactum({"--help"}).code, 0);
        const Ended help = tactum({"touch", "--help"});
        QCOMPARE(help.code, 0);
        for (const char* part : {"--static-friction", "--fit-diagonal", "Without --dynamic-friction",
                                 "before the device's limit"})
            QVERIFY2(help.out.contains(part), part);
    }
};

QTEST_GUILESS_MAIN(TestCommandLine)
#include "test_command_line.moc"
