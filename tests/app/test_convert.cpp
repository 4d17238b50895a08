// tactum convert: which files it writes, what it leaves alone, and what it says.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_convert {

using namespace test_program;

namespace {

const QStringList kEndings{"glb", "gltf", "tactum", "zip", "x3d", "obj", "ply", "stl", "off"};

// Grey pictures of one texel, and of two: black beside white.
const char* const kGrain =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";
const char* const kEdge =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAAAAADRSSBWAAAAC0lEQVR4nGNg+A8AAQIBAEK+vGgAAAAASUVORK5CYII=";

QByteArray bytesOf(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("(not there)");
}

} // namespace

class TestConvert : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WorkFolder> folder_;

    QString file(const QString& name) const { return folder_->file(name); }
    QString write(const QString& name, const QByteArray& text) const { return folder_->write(name, text); }
    QStringList names() const {
        return QDir(folder_->folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
    }

    // A square of two triangles. Its material: a colour, or a picture of heights.
    QString plate(const QString& name, const QByteArray& library = {}) const {
        return write(name, (library.isEmpty() ? "" : "mtllib " + library + "\nusemtl m\n") +
                               "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                               "f 1/1 2/2 3/3 4/4\n");
    }
    QString bumpyPlate(const QString& name, const char* picture) const {
        const QByteArray stem = name.section('.', 0, 0).toUtf8();
        write(stem + ".png", QByteArray::fromBase64(picture));
        write(stem + ".mtl", "newmtl m\nmap_bump " + stem + ".png\n");
        return plate(name, stem + ".mtl");
    }

    Ended convert(const QString& in, const QString& out, const QStringList& options = {}) const {
        return runTactum(QStringList{"convert", in, out} + options, {}, folder_->folder.path());
    }

private slots:
    void init() { folder_ = std::make_unique<WorkFolder>(); }

    void x3dExportsOfOneFolderStayApart() {
        bumpyPlate("one.obj", kEdge);
        bumpyPlate("two.obj", kEdge);
        QFile::remove(file("two.png"));
        write("two.png", QByteArray::fromBase64(kGrain));
        const QStringList before = names();
        QCOMPARE(convert("one.obj", "a.x3d").code, 0);
        const QStringList maps = QDir(file("a-maps")).entryList(QDir::Files);
        QCOMPARE(maps.size(), 1);
        const QByteArray scene = bytesOf(file("a.x3d")), map = bytesOf(file("a-maps/" + maps[0])),
                         device = bytesOf(file("a-deviceinfo.x3d"));
        QVERIFY(scene.contains("a-maps/" + maps[0].toUtf8()));
        QVERIFY(device.contains("DeviceInfo"));
        QCOMPARE(convert("two.obj", "b.x3d").code, 0);
        QCOMPARE(bytesOf(file("a.x3d")), scene);
        QCOMPARE(bytesOf(file("a-maps/" + maps[0])), map);
        QCOMPARE(bytesOf(file("a-deviceinfo.x3d")), device);
        for (const QString& name : names())
            QVERIFY2(before.contains(name) || name.startsWith("a") || name.startsWith("b"), qPrintable(name));
    }

    void besideABlankTheSceneStillNamesItsFiles() {
        bumpyPlate("one.obj", kEdge);
        QCOMPARE(convert("one.obj", "my cup & co.X3D").code, 0);
        const QRegularExpression url("url='&quot;([^&]*)&quot;'|url=\"&quot;([^&]*)&quot;\"");
        const auto found = url.match(bytesOf(file("my cup & co.X3D")));
        QVERIFY(found.hasMatch());
        QVERIFY2(QFile::exists(file(found.captured(1) + found.captured(2))), qPrintable(found.captured()));
    }

    // The library is that of another model, or of the one that is read.
    void whatTheInputReadsIsNotReplaced() {
        const QByteArray library = "newmtl m\nKd 1 0 0\n";
        write("bar.mtl", library);
        plate("foo.obj", "bar.mtl");
        const Ended ended = convert("foo.obj", "bar.obj");
        QCOMPARE(ended.code, 2);
        QVERIFY2(oneLine(ended.error).contains("bar.mtl: belongs to foo.obj"), ended.error);
        QCOMPARE(bytesOf(file("bar.mtl")), library);
        QCOMPARE(names(), QStringList({"bar.mtl", "foo.obj"}));
        plate("foo.obj", "./bar.mtl");
        QCOMPARE(convert(file("foo.obj"), "bar.obj").code, 2);
    }

    // One that only sounds alike may be: exporting again is the usual case.
    void exportingAgainIsNoClash() {
        write("my-bar.mtl", "newmtl m\nKd 1 0 0\n");
        plate("my-bar.obj", "my-bar.mtl");
        for (int i = 0; i < 2; ++i)
            for (const char* out : {"bar.obj", "bar.x3d"}) {
                const Ended ended = convert("my-bar.obj", out);
                QVERIFY2(ended.code == 0, ended.error);
            }
    }

    void filesBesideTheResultReplaceNothingThatWasNamed() {
        plate("in.obj");
        write("a.mtl", "t,x,y,z\n0,0,0,0\n1,0,0,0\n"); // a finger path, by whatever name
        for (const QStringList& options :
             {QStringList{"--report", "b.mtl"}, QStringList{"--path", "a.mtl"}}) {
            const QString out = options[1].section('.', 0, 0) + ".obj";
            const Ended ended = convert("in.obj", out, options);
            QCOMPARE(ended.code, 2);
            QVERIFY2(oneLine(ended.error).contains(options[1].toUtf8()), ended.error);
            QVERIFY(!QFile::exists(file(out)));
        }
        QCOMPARE(convert("in.obj", "a.x3d", {"--report", "a-deviceinfo.x3d"}).code, 2);
        QCOMPARE(convert("in.obj", "a.glb", {"--path", "a.mtl", "--report", "a.mtl"}).code, 2);
        QCOMPARE(convert("in.obj", "a.glb", {"--path", "a.mtl", "--report", "a.json"}).code, 0);
    }

    void whatTheImportFoundIsSaid() {
        plate("in.obj", "missing.mtl");
        const Ended check = runTactum({"check", file("in.obj")});
        const Ended ended = convert("in.obj", "a.glb");
        QCOMPARE(ended.code, 0);
        const auto lines = ended.error.split('\n');
        const auto said =
            std::ranges::find_if(lines, [](auto& line) { return line.contains("missing.mtl"); });
        QVERIFY2(said != lines.end(), ended.error);
        QVERIFY(check.out.split('\n').contains(*said)); // as the other verb says it
    }

    void whatOthersPutInIsLostOutsideOfGltf() {
        plate("in.obj");
        QCOMPARE(convert("in.obj", "plain.glb").code, 0);
        QByteArray glb = bytesOf(file("plain.glb"));
        quint32 length = 0;
        memcpy(&length, glb.constData() + 12, 4);
        QJsonObject root = QJsonDocument::fromJson(glb.mid(20, int(length))).object();
        root.remove("extensions"); // not ours any more
        root.insert("cameras",
                    QJsonArray{QJsonObject{{"type", "perspective"},
                                           {"perspective", QJsonObject{{"yfov", 1}, {"znear", 0.1}}}}});
        root.insert("buffers",
                    QJsonArray{QJsonObject{{"byteLength", int(glb.size() - 28 - int(length))},
                                           {"uri", "data:application/octet-stream;base64," +
                                                       QString(glb.mid(28 + int(length)).toBase64())}}});
        write("cam.gltf", QJsonDocument(root).toJson());
        const Ended ended = convert("cam.gltf", "cam.x3d", {"--report", "cam.json"});
        QVERIFY2(ended.code == 0, ended.error);
        COMPARE_CONTAINS(ended.error, "lost: scene: cameras: ");
        COMPARE_CONTAINS(bytesOf(file("cam.json")), "\"cameras\"");
        const Ended kept = convert("cam.gltf", "cam.glb");
        QVERIFY2(kept.code == 0 && !kept.error.contains("cameras"), kept.error);
    }

    void gltfIsTextWithItsDataBesideIt() {
        plate("in.obj");
        QCOMPARE(convert("in.obj", "a.glb").code, 0);
        QCOMPARE(convert("a.glb", "b c.gltf").code, 0);
        QCOMPARE(names(), QStringList({"a.glb", "b c.gltf", "b~20c.bin", "in.obj"}));
        COMPARE_CONTAINS(bytesOf(file("b c.gltf")), "\"uri\": \"b~20c.bin\"");
        QCOMPARE(convert("b c.gltf", "again.glb").code, 0);
        QCOMPARE(bytesOf(file("again.glb")), bytesOf(file("a.glb")));
        QByteArray later = bytesOf(file("b c.gltf")); // of a program that is not written yet
        write("b c.gltf", later.replace("\"version\": \"1.0\"", "\"version\": \"9.0\""));
        QCOMPARE(convert("in.obj", "b c.gltf").code, 1);
        QCOMPARE(bytesOf(file("b c.gltf")), later);
    }

    /// A URI is cut at some signs and read by others; both files have to be found again.
    void gltfOfAnyNameFindsItsData() {
        plate("in.obj");
        QCOMPARE(convert("in.obj", "a.glb").code, 0);
        for (const char* stem : {"a#b", "50%", "50%25", "a?b", "two  words", "tässchen", "a&b=c", "\"q\""}) {
            QCOMPARE(convert("a.glb", stem + QString(".gltf")).code, 0);
            const Ended back = convert(stem + QString(".gltf"), "again.glb");
            QVERIFY2(back.code == 0, back.error);
            QCOMPARE(bytesOf(file("again.glb")), bytesOf(file("a.glb")));
        }
    }

    /// What has the name of a file beside the result is replaced only where the result before named it.
    void whatLiesBesideAResultIsKeptWhereItIsAnothers() {
        plate("in.obj");
        for (const auto& [out, beside] :
             {std::pair{"a.gltf", "a.bin"}, {"b.obj", "b.mtl"}, {"c.x3d", "c-deviceinfo.x3d"}}) {
            write(beside, "another's");
            const Ended refused = convert("in.obj", out);
            QCOMPARE(refused.code, 2);
            QVERIFY2(oneLine(refused.error).contains(beside + QByteArray(": is there already")),
                     refused.error);
            QCOMPARE(bytesOf(file(beside)), "another's");
            QVERIFY(!QFile::exists(file(out)));
            write(out, "a file that names none");
            QCOMPARE(convert("in.obj", out).code, 2);
            QFile::remove(file(out)), QFile::remove(file(beside));
            QCOMPARE(convert("in.obj", out).code, 0);
            write(beside, "of the result before");
            QCOMPARE(convert("in.obj", out, {"--fit-diagonal", "2"}).code, 0);
            QVERIFY(bytesOf(file(beside)) != "of the result before");
            QFile::remove(file(out)); // the same bytes are no loss
            QCOMPARE(convert("in.obj", out, {"--fit-diagonal", "2"}).code, 0);
        }
    }

    void scenesGoThroughPipes() {
        plate("in.obj");
        const QString in = file("in.obj");
        QCOMPARE(convert("in.obj", "a.glb").code, 0);
        const QByteArray glb = bytesOf(file("a.glb"));
        for (const char* ending : {"glb", "ply", "stl", "off", "tactum"}) {
            const Ended out = runTactum({"convert", "-", "-", "--to", ending}, {}, {}, glb);
            QVERIFY2(out.code == 0, out.error);
            const Ended told = runTactum({"info", "-"}, {}, {}, out.out);
            QVERIFY2(told.code == 0, told.error);
            COMPARE_CONTAINS(told.out, "2 triangles");
        }
        QCOMPARE(runTactum({"convert", "-", "-", "--to", "glb"}, {}, {}, glb).out, glb);
        QCOMPARE(runTactum({"check", "-"}, {}, {}, bytesOf(in)).code, 0);
        const auto refused = [](const QStringList& arguments, const QByteArray& input, int code,
                                const char* part) {
            const Ended ended = runTactum(arguments, {}, {}, input);
            QCOMPARE(ended.code, code);
            QVERIFY(ended.out.isEmpty());
            QVERIFY2(oneLine(ended.error).contains(part), ended.error);
            QVERIFY2(!ended.error.contains("/tmp"), ended.error);
        };
        refused({"info", "-"}, {}, 1, "standard input: is empty");
        refused({"info", "-"}, "ply\nformat ascii 1.0\n", 1,
                "standard input:2: the header has no end_header");
        refused({"info", "-"}, QByteArray("\1\0\2", 3), 1, "standard input: cannot tell its format");
        refused({"info", "-"}, "hello\n", 1, "standard input: cannot tell its format");
        refused({"info", "-"}, glb + "more", 1, "standard input: is longer than its head says");
        refused({"convert", in, "-"}, {}, 2, "standard output: needs --to");
        refused({"convert", in, "-", "--to", "x3d"}, {}, 2, "standard output: .x3d is several files");
        refused({"convert", in, "-", "--to", "dwg"}, {}, 2,
                "standard output: needs --to with one of glb, tactum,");
        refused({"convert", in, "-", "--to", "/../../a.ply"}, {}, 2, "standard output: needs --to");
        refused({"convert", in, file("b.glb"), "--to", "glb"}, {}, 2, "--to: is for - alone");
    }

    void nothingLeavesBackups() {
        bumpyPlate("in.obj", kEdge);
        for (const QString& ending : kEndings)
            for (int i = 0; i < 2; ++i)
                QCOMPARE(convert("in.obj", "e." + ending).code, 0);
        QDirIterator all(folder_->folder.path(), QDir::Files, QDirIterator::Subdirectories);
        while (all.hasNext())
            QVERIFY2(!all.next().endsWith('1'), qPrintable(all.filePath()));
    }

    void aMissingFolderIsTheSameForEveryFormat() {
        bumpyPlate("in.obj", kEdge);
        for (const QString& ending : kEndings) {
            const Ended ended = convert("in.obj", "no/such/e." + ending);
            QCOMPARE(ended.code, 3);
            QVERIFY2(oneLine(ended.error).contains(("no/such/e." + ending + ": cannot be written").toUtf8()),
                     ended.error);
            QVERIFY(!QFile::exists(file("no")));
        }
    }

    void capitalsOfTheEndingDoNotMatter() {
        plate("in.obj");
        for (const QString& ending : kEndings) {
            const QString out = "UP." + ending.toUpper();
            const Ended ended = convert("in.obj", out);
            QVERIFY2(ended.code == 0, ended.error);
            QVERIFY(QFile::exists(file(out)));
            QVERIFY(!QFile::exists(file("UP." + ending)));
            QCOMPARE(runTactum({"info", file(out)}).code, 0);
        }
    }

    void infoRoundsForPeopleAlone() {
        write("in.obj", "v 0.01 0 0\nv 0.15 0 0\nv 0.15 0.0007654321 0\nf 1 2 3\n");
        const QByteArray text = runTactum({"info", file("in.obj")}).out;
        auto numbers = QRegularExpression(R"(\d+(\.\d+)?)").globalMatch(text);
        while (numbers.hasNext()) {
            QString digits = numbers.next().captured().remove('.');
            QVERIFY2(digits.remove(QRegularExpression("^0+")).size() <= 6, text);
        }
        QVERIFY2(text.contains("diagonal 0.140002 m"), text);
        const QJsonObject json =
            QJsonDocument::fromJson(runTactum({"info", file("in.obj"), "--json"}).out).object();
        const double diagonal = json["bounds_m"].toObject()["diagonal"].toDouble();
        QCOMPARE_NE(diagonal, 0.140002);
        COMPARE_NEAR(diagonal, 0.140002, 1e-6, "m");
    }

    // The script itself, over a program that says what it was called with.
    void theScriptPassesEveryVerb() {
        const QByteArray help = runTactum({"--help"}).out;
        const QByteArray list = help.mid(help.indexOf("Subcommands:"));
        QStringList verbs;
        auto lines =
            QRegularExpression(R"(^  ([a-z]+) )", QRegularExpression::MultilineOption).globalMatch(list);
        while (lines.hasNext())
            verbs += lines.next().captured(1);
        QVERIFY2(verbs.size() >= 6, list);
        QDir(folder_->folder.path()).mkpath("cmake");
        QDir(folder_->folder.path()).mkpath("build/release");
        QVERIFY(QFile::copy(TACTUM_ROOT "/run", file("run")));
        write("cmake/setup.sh", "say() { :; }\ninstall_missing() { :; }\nbuild() { :; }\n");
        QFile program(write("build/release/tactum", "#!/bin/sh\necho \"called: $*\"\n"));
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
        const auto run = [&](const QString& arguments) {
            QProcess shell;
            shell.start("sh",
                        {"-c", "unset DISPLAY WAYLAND_DISPLAY; bash '" + file("run") + "' " + arguments});
            return shell.waitForFinished(60000) ? shell.readAllStandardOutput() : QByteArray();
        };
        const QByteArray usage = run("--help");
        for (const QString& verb : verbs) {
            QCOMPARE(run(verb + " a b"), "called: " + verb.toUtf8() + " a b\n");
            QVERIFY2(usage.contains(verb.toUtf8()), usage);
        }
    }
};

TACTUM_TEST(TestConvert)

} // namespace test_convert

#include "test_convert.moc"
