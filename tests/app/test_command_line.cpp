// The command line is a contract: verbs, options, columns, keys and exit codes, driven from outside.

#include <algorithm>
#include <cmath>

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_command_line {

using namespace test_program;

namespace {

using Row = QList<double>;

/// A square of cells, two triangles each.
QByteArray gridObj(int cells) {
    QByteArray text;
    for (int i = 0; i <= cells; ++i)
        for (int k = 0; k <= cells; ++k)
            text += "v " + QByteArray::number(i) + "e-4 " + QByteArray::number(k) + "e-4 0\n";
    const auto at = [&](int i, int k) { return QByteArray::number(i * (cells + 1) + k + 1) + ' '; };
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k)
            text += "f " + at(i, k) + at(i + 1, k) + at(i + 1, k + 1) + at(i, k + 1) + '\n';
    return text;
}

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

class TestCommandLine : public QObject, WorkFolder {
    Q_OBJECT

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

private slots:
    void touchWritesTheColumnsOfTheContract() {
        const QString path = pressAndSlide(0.004, 0.01);
        const Ended ended =
            runTactum({"touch", plate(), "--path", path, "--out", file("touch.csv"), "--summary",
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
        COMPARE_NEAR(last[ProxyZ], 0.001, 1e-8, "");
        COMPARE_NEAR(last[ForceZ], 500 * 0.005, 1e-5, "");
        QCOMPARE(int(last[Contacts]), 1);
        QCOMPARE(last[FingerY], 0.003); // full precision: reads back as the same double
    }

    // The forces are those of the file beside the sample, which is no finger itself.
    void touchGoesTheScenesOwnPath() {
        const QString sample = QStringLiteral(TACTUM_ROOT "/resources/scenes/stiffness-ladder");
        const Ended ended = runTactum({"touch", sample + ".glb", "--out", file("own.csv")});
        QVERIFY2(ended.code == 0, ended.error);
        const QList<Row> felt = rowsOf(file("own.csv")), right = rowsOf(sample + ".csv");
        QCOMPARE_GT(felt.size(), 1000);
        QCOMPARE(felt.size(), right.size());
        double off = 0;
        for (qsizetype i = 0; i < felt.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                off = std::max(off, std::abs(felt[i][ForceX + axis] - right[i][1 + axis]));
        QCOMPARE_LT(off, 1e-6); // N: the file has seven decimals
        const Ended without = runTactum({"touch", plate()}),
                    forces = runTactum({"touch", sample + ".glb", "--path", sample + ".csv"});
        QCOMPARE(without.code, 2);
        COMPARE_CONTAINS(oneLine(without.error), "plate.obj: has no finger path in it; give one with --path");
        QCOMPARE(forces.code, 1);
        COMPARE_CONTAINS(oneLine(forces.error), "the header must be \"t,x,y,z\"");
    }

    void touchPrintsTheSummary() {
        const QString path = pressAndSlide(0.002, 0);
        const Ended ended = runTactum({"touch", plate(), "--path", path, "--summary", file("s.json")});
        QCOMPARE(ended.code, 0);
        const QJsonObject printed = QJsonDocument::fromJson(ended.out).object();
        QFile saved(file("s.json"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(QJsonDocument::fromJson(saved.readAll()).object(), printed);
        QCOMPARE(printed["triangles"].toInt(), 2);
        QCOMPARE(printed["updates"].toInt(), 601);
        for (const char* key : {"load_s", "build_s", "peak_rss_bytes", "hierarchy_bytes"})
            QCOMPARE_GT(printed[key].toDouble(), 0);
        const QJsonObject times = printed["update_ns"].toObject();
        for (const char* key : {"mean", "median", "p99", "p999", "max"})
            QCOMPARE_GT(times[key].toDouble(), 0);
        QCOMPARE_LE(times["median"].toDouble(), times["p99"].toDouble());
        QCOMPARE_LE(times["p999"].toDouble(), times["max"].toDouble());
    }

    // A roof of two slopes, and a finger that is pressed below its ridge a little to one side.
    void touchShadesWhenAsked() {
        const QString roof = write("roof.obj", "v -0.1 -0.1 -0.02\nv -0.1 0.1 -0.02\nv 0 -0.1 0\nv 0 0.1 0\n"
                                               "v 0.1 -0.1 -0.02\nv 0.1 0.1 -0.02\nf 1 3 4 2\nf 3 5 6 4\n");
        const QString path = pressAndSlide(0.006, 0);
        const auto lean = [&](const QString& shading) {
            const Ended ended = runTactum({"touch", roof, "--path", path, "--out", file("roof.csv"),
                                           "--proxy-radius", "0.001", "--shading", shading});
            if (ended.code != 0 || !ended.error.isEmpty()) return -1.0;
            const Row last = rowsOf(file("roof.csv")).last();
            return last[ForceX] / last[ForceZ];
        };
        // The facet is inclined by 0.2; near the ridge the felt normal is nearly upright.
        COMPARE_NEAR(lean("off"), 0.2, 1e-3, "");
        QCOMPARE_GT(lean("on"), 0);
        QCOMPARE_LT(lean("on"), 0.1);
    }

    // The plate's corners run counter-clockwise seen from +z, where the finger comes from.
    void touchFeelsTheSidesThatItIsGiven() {
        const QString path = pressAndSlide(0.004, 0);
        for (const auto& [sides, felt] :
             {std::pair{"both", true}, std::pair{"front", true}, std::pair{"back", false}}) {
            QCOMPARE(
                runTactum({"touch", plate(), "--path", path, "--out", file("sides.csv"), "--sides", sides})
                    .code,
                0);
            const Row last = rowsOf(file("sides.csv")).last();
            QCOMPARE(last[Contacts] == 1 && last[ForceZ] > 1, felt);
        }
    }

    void touchIsDeterministicToTheBit() {
        const QString path = pressAndSlide(0.004, 0.03);
        QList<QList<Row>> runs;
        for (const char* name : {"a.csv", "b.csv"}) {
            QCOMPARE(runTactum({"touch", plate(), "--path", path, "--out", file(name), "--static-friction",
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
            const Ended ended = runTactum(arguments + QStringList{"--summary", "s.json"}, {}, folder.path());
            QVERIFY2(ended.code == 0, ended.error);
            const QList<QByteArray> lines = ended.out.trimmed().split('\n'); // the table, and nothing else
            QCOMPARE(lines.size(), rows + 1);
            COMPARE_BEGINS(lines.first(), "t,finger_x");
            for (const QByteArray& line : lines)
                QCOMPARE(line.count(','), 11);
            QVERIFY(!QFile::exists(file("-")));
            QVERIFY(QFile::exists(file("s.json")));
        }
        const Ended summary = runTactum({"touch", plate(), "--path", path, "--summary", "-"});
        QVERIFY2(!oneLine(summary.out).isEmpty(), summary.out); // once
        for (const char* verb : {"touch", "play"})
            COMPARE_CONTAINS(runTactum({verb, "--help"}).out, "- is standard output");
    }

    void frictionHoldsAndSlidesAsGiven() {
        const QString path = pressAndSlide(0.004, 0.02);
        QCOMPARE(
            runTactum({"touch", plate(), "--path", path, "--out", file("f.csv"), "--proxy-radius", "0.001",
                       "--stiffness", "1000", "--static-friction", "0.6", "--dynamic-friction", "0.4"})
                .code,
            0);
        double most = 0;
        const QList<Row> rows = rowsOf(file("f.csv"));
        for (const Row& row : rows)
            if (row[ForceZ] > 4) most = std::max(most, -row[ForceX] / row[ForceZ]);
        COMPARE_NEAR(most, 0.6, 0.02, ""); // a step of 50 um over 5 mm
        COMPARE_NEAR(-rows.last()[ForceX] / rows.last()[ForceZ], 0.4, 1e-6, "");
    }

    // One coefficient is that of both: the slide pulls as hard as the hold did at last.
    void staticFrictionAloneIsDynamicToo() {
        const QString path = pressAndSlide(0.004, 0.02);
        QCOMPARE(runTactum({"touch", plate(), "--path", path, "--out", file("s.csv"), "--proxy-radius",
                            "0.001", "--static-friction", "0.5"})
                     .code,
                 0);
        const Row last = rowsOf(file("s.csv")).last();
        COMPARE_NEAR(-last[ForceX] / last[ForceZ], 0.5, 1e-6, "");
    }

    void fitDiagonalScalesAboutTheBoxCentre() {
        const QString big =
            write("big.obj", "v 1000 1000 7\nv 1020 1000 7\nv 1020 1020 7\nv 1000 1020 7\nf 1 2 3 4\n");
        const QString path = pressAndSlide(0.002, 0);
        QCOMPARE(runTactum({"touch", big, "--path", path, "--out", file("fit.csv"), "--fit-diagonal", "0.2",
                            "--proxy-radius", "0.001"})
                     .code,
                 0);
        COMPARE_NEAR(rowsOf(file("fit.csv")).last()[ProxyZ], 0.001, 1e-8, "");
    }

    void playComparesEveryBit() {
        const QString recording = QStringLiteral(TACTUM_REPLAYS "/few-bumps.tactum-recording");
        const Ended ended =
            runTactum({"play", recording, "--out", file("again.csv"), "--summary", file("again.json")});
        QVERIFY2(ended.code == 0, ended.error);
        COMPARE_BEGINS(ended.out, "1200 steps, 0 differ\n");
        COMPARE_CONTAINS(ended.out, "FAULT: the device was lost\n");
        QCOMPARE(rowsOf(file("again.csv")).size(), 800);
        QFile summary(file("again.json"));
        QVERIFY(summary.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(summary.readAll()).object();
        QCOMPARE(json["haptic_steps"].toInt(), 800);
        QCOMPARE(json["servo_ticks"].toInt(), 400);
        QCOMPARE(json["differ"].toInt(-1), 0);
        QCOMPARE_GT(json["events"].toArray().size(), 5);
    }

    void infoNamesEverything() {
        const Ended text = runTactum({"info", plate()});
        QCOMPARE(text.code, 0);
        COMPARE_CONTAINS(text.out, "stiffness");
        COMPARE_CONTAINS(text.out, "N/m");
        COMPARE_CONTAINS(text.out, "2 triangles");
        const Ended json = runTactum({"info", plate(), "--json"});
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
        COMPARE_CONTAINS(text.out, "sides both");
        QCOMPARE(object["health"].toObject()["boundary_edges"].toInt(), 4);
    }

    void infoCountsLinesAndPointsByThemselves() {
        const QString mixed = write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\np 1\np 2\n");
        const QByteArray text = runTactum({"info", mixed}).out;
        COMPARE_CONTAINS(text, "object mixed: 1 triangle, 3 vertices");
        COMPARE_CONTAINS(text, "  segments 1\n  points 2\n");
        COMPARE_CONTAINS(text, "scene: 1 object, 1 triangle,");
        COMPARE_CONTAINS(text, "  surface surface: 1 triangle\n");
    }

    void infoShowsBodiesAndJoints() {
        const QString crank = QStringLiteral(TACTUM_ROOT "/resources/scenes/moving/crank.glb");
        const Ended text = runTactum({"info", crank});
        QVERIFY2(text.code == 0, text.error);
        COMPARE_CONTAINS(text.out, "body wheel: 0.111047 kg, 3 colliders\n");
        COMPARE_CONTAINS(text.out, "joint axle: the world to wheel\n");
        const QJsonObject scene = QJsonDocument::fromJson(runTactum({"info", crank, "--json"}).out).object();
        const QJsonObject wheel = scene["bodies"].toArray().at(0).toObject();
        QCOMPARE(wheel["name"].toString(), QString("wheel"));
        QCOMPARE(wheel["colliders"].toInt(), 3);
        const QJsonObject axle = scene["joints"].toArray().at(0).toObject();
        QVERIFY(axle["a"].isNull());
        QCOMPARE(axle["b"].toString(), QString("wheel"));
    }

    void bodiesWithoutAMeshAreNoEmptyScene() {
        const QString scene = write(
            "bare.gltf",
            R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_physics_rigid_bodies"],"scenes":[{"nodes":[0]}],)"
            R"("nodes":[{"name":"ball","extensions":{"KHR_physics_rigid_bodies":{"motion":{"mass":1}}}}]})");
        const Ended run = runTactum({"check", scene});
        COMPARE_CONTAINS(run.out, "has bodies that can be simulated, but no mesh");
        QVERIFY(!run.out.contains("the scene is empty"));
    }

    void infoShowsShadingAndLayers() {
        const Ended text = runTactum({"info", bumpyPlate()});
        QVERIFY2(text.code == 0, text.error);
        QCOMPARE(text.out.count("    shading off\n"), 2);
        QCOMPARE(text.out.count("    layer grain.png: image grain.png, mapping uv-unit, height 2e-04 m, "
                                "blend add, opacity 1\n"),
                 2);
        const QJsonObject scene =
            QJsonDocument::fromJson(runTactum({"info", bumpyPlate(), "--json"}).out).object();
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

    void infoSaysHowHandsReach() {
        const auto reaching = [&](const QByteArray& how) {
            return write(
                "bare.gltf",
                QByteArray(
                    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
                "extensionsUsed":["TACTUM_haptics"],"extensions":{"TACTUM_haptics":{"version":"1.0"@}},
                "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
                "max":[0.1,0.1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
                "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MzD0AAAAA"}]})")
                    .replace("@", how));
        };
        const QString drifts = reaching(",\"reach\":\"drift\"");
        COMPARE_CONTAINS(runTactum({"info", drifts}).out, "  reach: drift\n");
        const QByteArray json = runTactum({"info", drifts, "--json"}).out;
        QCOMPARE(QJsonDocument::fromJson(json).object()["reach"].toString(), QStringLiteral("drift"));
        COMPARE_CONTAINS(runTactum({"info", reaching(",\"reach\":\"rate\"")}).out, "  reach: rate\n");
        COMPARE_LACKS(runTactum({"info", reaching("")}).out, "reach:");
    }

    void infoNamesCameras() {
        const QString scene =
            write("cameras.gltf",
                  R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},
                {"name":"eye","camera":0,"translation":[0,0,1]}],
                "cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":2}}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
                "max":[0.1,0.1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,
                "uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MzD0AAAAA"}]})");
        COMPARE_CONTAINS(runTactum({"info", scene}).out, "camera eye: parallel\n");
        const QJsonObject json = QJsonDocument::fromJson(runTactum({"info", scene, "--json"}).out).object();
        QCOMPARE(json["cameras"].toArray().at(0).toObject()["name"].toString(), QString("eye"));
    }

    void infoNamesSelectionSets() {
        const QString scene = write(
            "sets.gltf",
            R"({"asset":{"version":"2.0"},"extensionsUsed":["TACTUM_haptics"],"scene":0,"scenes":[{"nodes":[0]}],
                "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}],
                "extensions":{"TACTUM_haptics":{"sets":{"of":1,"parts":[{"name":"rim","ranges":1}]}}}}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
                "max":[0.1,0.1,0]}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,
                "byteLength":8}],"buffers":[{"byteLength":44,"uri":"data:application/octet-stream;base64,)"
            "AAAAAAAAAAAAAAAAzczMPQAAAAAAAAAAAAAAAM3MzD0AAAAAAAAAAAEAAAA="
            R"("}]})");
        COMPARE_CONTAINS(runTactum({"info", scene}).out, "  set rim: 1 triangle\n");
        const QJsonObject json = QJsonDocument::fromJson(runTactum({"info", scene, "--json"}).out).object();
        const QJsonObject set = json["objects"].toArray().at(0).toObject()["sets"].toArray().at(0).toObject();
        QCOMPARE(set["name"].toString(), QString("rim"));
        QCOMPARE(set["triangles"].toInt(), 1);
    }

    void checkSaysEverythingOnce() {
        for (const QString& scene : {plate(), bumpyPlate()}) {
            const Ended check = runTactum({"check", scene});
            QCOMPARE(check.code, 0);
            const QList<QByteArray> lines = check.out.trimmed().split('\n');
            COMPARE_CONTAINS(check.out, "open rim");
            for (const QByteArray& line : lines)
                QCOMPARE_EQ(lines.count(line), 1);
        }
        COMPARE_CONTAINS(runTactum({"check", bumpyPlate()}).out, "has no unit");
    }

    /// How it turns out is the machine's affair.
    void aSelfTestNeedsADeviceThatPushes() {
        const Ended none = runTactum({"devices", "--self-test", "nothing"});
        QCOMPARE(none.code, 1);
        COMPARE_CONTAINS(none.error, "There is no device \"nothing\"");
        const Ended simulated = runTactum({"devices", "--self-test", "simulated"});
        QCOMPARE(simulated.code, 1);
        COMPARE_CONTAINS(simulated.error, "there is nothing to measure");
        QVERIFY(!QDir("self-test").exists());
    }

    void devicesTellHowLateTheMachineIs() {
        const Ended said = runTactum({"devices", "--latency", "0.2"});
        QVERIFY(said.code == 0 || said.code == 3);
        COMPARE_CONTAINS(said.out, "ticks at 1000 Hz");
        COMPARE_CONTAINS(said.out, "over 10 ms: ");
        const Ended json = runTactum({"devices", "--latency", "0.2", "--rate", "2000", "--json"});
        const QJsonObject report = QJsonDocument::fromJson(json.out).object();
        QCOMPARE(report["rate_Hz"].toDouble(), 2000.0);
        QCOMPARE_GT(report["ticks"].toInt(), 0);
        QCOMPARE_LE(report["ticks"].toInt(), 402);
        QCOMPARE(json.code, report["over_10_ms"].toInt() > 0 ? 3 : 0);
        QCOMPARE(runTactum({"devices", "--rate", "2000"}).code, 2);
        QCOMPARE(runTactum({"devices", "--latency", "never"}).code, 2);
    }

    void checkAndDevicesAnswer() {
        const Ended check = runTactum({"check", plate()});
        QCOMPARE(check.code, 0);
        QVERIFY(!check.out.isEmpty());
        const Ended devices = runTactum({"devices"});
        QCOMPARE(devices.code, 0);
        COMPARE_CONTAINS(devices.out, "Simulated hand (simulated): ready");
        // A maker's library that is none, or missing, is one sentence and takes nothing else with it.
        COMPARE_CONTAINS(devices.out, "OpenHaptics");
        COMPARE_CONTAINS(devices.out, "Force Dimension");
        const Ended json = runTactum({"devices", "--json"});
        QCOMPARE(json.code, 0);
        QVERIFY(QJsonDocument::fromJson(json.out).isArray());
        const Ended none = runTactum({"device-server", "no such"});
        QCOMPARE_NE(none.code, 0);
        COMPARE_CONTAINS(none.error, "no such");
    }

    /// Work of seconds on two million triangles; a pipe or a file gets none of it.
    void aTerminalSeesHowFarItIs() {
        const WorkFolder work;
        const QString obj = work.write("grid.obj", gridObj(1000));
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
        QVERIFY(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
        QProcess process;
        process.setStandardErrorFile(QString::fromLocal8Bit(ptsname(terminal)));
        process.start(TACTUM_PROGRAM, {"check", obj});
        QVERIFY(process.waitForFinished(120000));
        QCOMPARE_EQ(process.exitCode(), 0);
        QByteArray seen(1 << 20, '\0');
        seen.resize(std::max<ssize_t>(0, read(terminal, seen.data(), std::size_t(seen.size()))));
        close(terminal);
        COMPARE_CONTAINS(seen, QByteArray("reading "));
        COMPARE_CONTAINS(seen, QByteArray("grid.obj ... "));
        COMPARE_CONTAINS(seen, QByteArray(" %"));
        QVERIFY(seen.endsWith("\r\x1b[K")); // and nothing is left of it
        QCOMPARE(runTactum({"check", obj}).error, QByteArray());
    }

    void helpIsZero() {
        QCOMPARE(runTactum({"--help"}).code, 0);
        const Ended help = runTactum({"touch", "--help"});
        QCOMPARE(help.code, 0);
        for (const char* part : {"--static-friction", "--fit-diagonal", "Without --dynamic-friction",
                                 "before the device's limit"})
            QVERIFY2(help.out.contains(part), part);
    }
};

TACTUM_TEST(TestCommandLine)

} // namespace test_command_line

#include "test_command_line.moc"
