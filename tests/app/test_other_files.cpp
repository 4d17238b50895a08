// Verbs about other people's files: verify, feel, check and info over several files; what a terminal may get.
#include <cmath>

#include <QColor>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTest>
#include <sys/resource.h>

#include "tests/app/program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_other_files {

using namespace test_program;

namespace {

QByteArray bytesOf(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
}

QJsonObject objectOf(const QByteArray& json) {
    return QJsonDocument::fromJson(json).object();
}

} // namespace

class TestOtherFiles : public QObject, private WorkFolder {
    Q_OBJECT

    /// A plate of 0.2 m whose material is called `material`; its object as the file is.
    QString model(const QString& name, const QByteArray& material) const {
        return write(name, "usemtl " + material +
                               "\nv -0.1 0 -0.1\nv -0.1 0 0.1\nv 0.1 0 0.1\nv 0.1 0 -0.1\nf 1 2 3 4\n");
    }

private slots:
    void aBundleIsVerified() {
        QCOMPARE(runTactum({"convert", model("plate.obj", "clay"), file("plate.zip")}).code, 0);
        const Ended whole = runTactum({"verify", file("plate.zip")});
        QVERIFY2(whole.code == 0, whole.error);
        COMPARE_CONTAINS(whole.out, "4001 steps");
        COMPARE_CONTAINS(whole.out, "as the scene feels");
        const QJsonObject json = objectOf(runTactum({"verify", file("plate.zip"), "--json"}).out);
        QCOMPARE(json["true"].toBool(), true);
        QVERIFY(QFile::copy(file("plate.zip"), file("plate.tactum")));
        QCOMPARE(runTactum({"verify", file("plate.tactum")}).code, 0);
        QCOMPARE_GT(json["largest_force_N"].toDouble(), 0.1);
        QByteArray bytes = bytesOf(file("plate.zip"));
        bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 1);
        const Ended changed = runTactum({"verify", write("changed.zip", bytes)});
        QCOMPARE(changed.code, 1);
        QVERIFY2(!oneLine(changed.error).isEmpty(), changed.error);
        QCOMPARE(runTactum({"verify", model("plate.obj", "clay")}).code, 1);
    }

    /// Another hand: plain Python that knows the bundle's page alone. Frictionless, holding and sliding; one
    /// triangle, for the edge between two is met as a new contact.
    void aReaderInPythonGetsTheSameForces() {
        if (QStandardPaths::findExecutable(QStringLiteral("python3")).isEmpty()) QSKIP("there is no python3");
        const QString floor = write("floor.obj", "usemtl clay\nv -1 0 -1\nv -1 0 3\nv 3 0 -1\nf 1 2 3\n");
        QByteArray path = "t,x,y,z\n";
        for (int i = 0; i <= 2000; ++i) {
            const double t = i * 1e-3;
            for (const double x : {t, 0.02 * std::sin(3 * t), 0.004 * std::cos(5 * t) - 0.001})
                path += QByteArray::number(x, 'g', 17) + ',';
            path += QByteArray::number(0.03 * std::cos(2 * t), 'g', 17) + '\n';
        }
        write("sine.csv", path);
        QCOMPARE(runTactum({"convert", floor, file("smooth.glb")}).code, 0);
        const QByteArray smooth = bytesOf(file("smooth.glb"));
        for (const auto& [held, sliding] : {std::pair{"0.0", "0.0"}, {"0.5", "0.5"}, {"0.6", "0.3"}}) {
            QByteArray rough = smooth; // of the same length
            rough.replace("\"staticFriction\":0.0", QByteArray("\"staticFriction\":") + held);
            rough.replace("\"dynamicFriction\":0.0", QByteArray("\"dynamicFriction\":") + sliding);
            QCOMPARE(runTactum({"convert", write("rough.glb", rough), file("rough.zip"), "--path",
                                file("sine.csv")})
                         .code,
                     0);
            QProcess reader;
            reader.start("python3", {TACTUM_ROOT "/docs/examples/read_bundle.py", file("rough.zip")});
            QVERIFY(reader.waitForFinished(60000));
            const QByteArray said = reader.readAllStandardOutput() + reader.readAllStandardError();
            QVERIFY2(reader.exitCode() == 0, said);
            COMPARE_CONTAINS(said, "largest force "); // of several newtons
        }
    }

    /// One page of a scene, without a display.
    void reportIsWrittenByItsEnding() {
        qputenv("SOURCE_DATE_EPOCH", "1700000000");
        const Ended page = runTactum({"report", plate(), "-o", file("r.html")});
        QVERIFY2(page.code == 0, page.error);
        QFile html(file("r.html"));
        QVERIFY2(html.open(QIODevice::ReadOnly), qPrintable(html.errorString()));
        const QByteArray text = html.readAll();
        COMPARE_CONTAINS(text, "2023-11-14 22:13 UTC");
        QFile model(plate());
        QVERIFY2(model.open(QIODevice::ReadOnly), qPrintable(model.errorString()));
        COMPARE_CONTAINS(text, QCryptographicHash::hash(model.readAll(), QCryptographicHash::Sha256).toHex());
        const Ended paper = runTactum({"report", plate(), "-o", file("r.pdf")});
        qunsetenv("SOURCE_DATE_EPOCH");
        QVERIFY2(paper.code == 0, paper.error);
        const Ended other = runTactum({"report", plate(), "-o", file("r.doc")});
        QCOMPARE(other.code, 2);
        COMPARE_CONTAINS(oneLine(other.error), "a report is written as .html or .pdf");
        QCOMPARE(runTactum({"report", file("none.obj"), "-o", file("r.html")}).code, 1);
        QCOMPARE(runTactum({"report", plate(), "-o", file("no/r.html")}).code, 3);
        QProcess reader;
        reader.start("pdftotext", {"-layout", file("r.pdf"), "-"});
        if (!reader.waitForStarted())
            QSKIP("pdftotext is not installed: nobody else reads the PDF; apt install poppler-utils");
        QVERIFY(reader.waitForFinished());
        const QByteArray words = reader.readAllStandardOutput();
        for (const char* part : {"plate.obj", "2023-11-14 22:13 UTC", "Surfaces", "Forces of a stroke"})
            COMPARE_CONTAINS(words, part);
    }

    /// The words of the pages by another reader; the headings by the page of the web. Beneath some is a
    /// picture, in which nobody reads.
    void noHeadingEndsAPageOfPaper() {
        for (const char* name : {"teapot", "layered-leather", "texture-wall", "moving/crank"}) {
            const QString scene =
                QStringLiteral(TACTUM_ROOT "/resources/scenes/") + QLatin1String(name) + ".glb";
            QCOMPARE(runTactum({"report", scene, "-o", file("p.html")}).code, 0);
            QCOMPARE(runTactum({"report", scene, "-o", file("p.pdf")}).code, 0);
            QProcess reader;
            reader.start("pdftotext", {"-layout", file("p.pdf"), "-"});
            if (!reader.waitForStarted())
                QSKIP("pdftotext is not installed: nobody else reads the PDF; apt install poppler-utils");
            QVERIFY2(reader.waitForFinished(), "pdftotext ends");
            QFile html(file("p.html"));
            QVERIFY2(html.open(QIODevice::ReadOnly), qPrintable(html.errorString()));
            const QString text = QString::fromUtf8(html.readAll());
            QStringList headings;
            for (auto i = QRegularExpression("<h[1-6][^>]*>([^<]+)</h[1-6]>\\s*+(?!<p[^>]*><img)")
                              .globalMatch(text);
                 i.hasNext();)
                headings << i.next().captured(1).trimmed();
            QCOMPARE_GT(headings.size(), 3);
            QStringList pages = QString::fromUtf8(reader.readAllStandardOutput()).split(u'\f');
            QCOMPARE_GT(pages.size(), 1);
            pages.removeLast(); // what the last page ends is the file
            for (const QString& page : pages) {
                QStringList lines = page.split(u'\n', Qt::SkipEmptyParts);
                if (lines.size() > 1) lines.removeLast(); // the page's number
                QVERIFY2(!headings.contains(lines.back().trimmed()), qPrintable(page));
            }
        }
    }

    /// What is said of a pattern, or of the forces, stands over its picture on the same page, as another
    /// reader finds both. Between a picture and what follows it there are no half empty pages.
    void noCaptionEndsAPageOfPaper() {
        int captions = 0;
        for (const char* name : {"layered-leather", "texture-wall", "relief-coin"}) {
            const QString scene =
                QStringLiteral(TACTUM_ROOT "/resources/scenes/") + QLatin1String(name) + ".glb";
            QCOMPARE(runTactum({"report", scene, "-o", file("c.pdf")}).code, 0);
            QProcess reader;
            reader.start("pdftohtml", {"-xml", "-q", file("c.pdf"), file("c.xml")});
            if (!reader.waitForStarted())
                QSKIP("pdftohtml is not installed: nobody else reads the PDF; apt install poppler-utils");
            QVERIFY2(reader.waitForFinished(), "pdftohtml ends");
            QFile pages(file("c.xml"));
            QVERIFY2(pages.open(QIODevice::ReadOnly), qPrintable(pages.errorString()));
            const QStringList all = QString::fromUtf8(pages.readAll()).split(QStringLiteral("<page "));
            if (QLatin1String(name) == QLatin1String("texture-wall")) QCOMPARE_LE(all.size() - 1, 7);
            for (const QString& page : all) {
                int lowest = -1;
                for (auto i = QRegularExpression("<image top=\"(-?\\d+)\"").globalMatch(page); i.hasNext();)
                    lowest = std::max(lowest, i.next().captured(1).toInt());
                for (auto i = QRegularExpression(
                                  "<text top=\"(\\d+)\"[^>]*>(Layer [^<]* mm across|[^<]*haptic step[^<]*)<")
                                  .globalMatch(page);
                     i.hasNext(); ++captions) {
                    const auto caption = i.next();
                    QVERIFY2(caption.captured(1).toInt() < lowest, qPrintable(caption.captured(2)));
                }
            }
        }
        QCOMPARE_GT(captions, 10);
    }

    /// A file manager's picture: square, of the size asked for, with the model in the middle of it.
    void aThumbnailShowsTheScene() {
        const QString teapot = QStringLiteral(TACTUM_ROOT "/resources/scenes/teapot.glb");
        QCOMPARE(runTactum({"thumbnail", teapot, file("t.png"), "--size", "128"}).code, 0);
        const QImage picture(file("t.png"));
        QCOMPARE(picture.size(), QSize(128, 128));
        const QColor corner = picture.pixelColor(1, 1);
        int drawn = 0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x)
                drawn += picture.pixelColor(x, y) != corner;
        QCOMPARE_GT(drawn, 128 * 128 / 8);
        QVERIFY(picture.pixelColor(64, 64) != corner);
        const Ended piped = runTactum({"thumbnail", teapot, "-"});
        QCOMPARE(QImage::fromData(piped.out, "PNG").size(), QSize(256, 256));
        QCOMPARE(runTactum({"thumbnail", file("none.glb"), file("n.png")}).code, 1);
        QVERIFY(!QFile::exists(file("n.png")));
        QCOMPARE(runTactum({"thumbnail", teapot, file("n.png"), "--size", "3000000"}).code, 2);
        const QString own = model("own.obj", "clay");
        QCOMPARE(runTactum({"thumbnail", own, own}).code, 2);
    }

    void aFingerThatTouchesNothingIsSaid() {
        const QString plate = model("plate.obj", "clay");
        const QString far = write("far.csv", "t,x,y,z\n0,9,9,9\n0.001,9,9,9\n");
        const Ended bundle = runTactum({"convert", plate, file("far.zip"), "--path", far});
        QCOMPARE(bundle.code, 0);
        COMPARE_CONTAINS(bundle.error, "touches nothing");
        COMPARE_CONTAINS(runTactum({"touch", plate, "--path", far}).error, "touches nothing");
        COMPARE_CONTAINS(runTactum({"verify", file("far.zip")}).out, "touches nothing");
        COMPARE_LACKS(runTactum({"convert", plate, file("near.zip")}).error, "touches nothing");
    }

    /// The scene of the issue: what was a press along y was 6e-14 N of it after scaling.
    void scalingKeepsWhatTheFingerShows() {
        const QString ladder = QStringLiteral(TACTUM_ROOT "/resources/scenes/stiffness-ladder.glb");
        QCOMPARE(runTactum({"convert", ladder, file("large.zip"), "--fit-diagonal", "1.0"}).code, 0);
        QCOMPARE(runTactum({"convert", ladder, file("own.zip")}).code, 0);
        const auto most = [&](const QString& bundle) {
            return objectOf(runTactum({"verify", file(bundle), "--json"}).out)["largest_force_N"].toDouble();
        };
        QCOMPARE_GT(most("own.zip"), 1);
        QCOMPARE_GT(most("large.zip"), most("own.zip")); // deeper, for it is larger
    }

    void theFeelIsCarriedOntoAnotherModel() {
        QCOMPARE(runTactum({"convert", model("old.obj", "clay"), file("old.glb")}).code, 0);
        QByteArray glb = bytesOf(file("old.glb")); // of the same length, in the extension and the extras
        glb.replace("800.0", "123.0");
        write("felt.glb", glb);
        const Ended carried =
            runTactum({"feel", file("felt.glb"), model("new.obj", "clay"), file("out.glb")});
        QVERIFY2(carried.code == 0, carried.error);
        COMPARE_CONTAINS(carried.out, "1 surface as in");
        COMPARE_CONTAINS(runTactum({"info", file("out.glb")}).out, "stiffness 123 N/m");
        const Ended nobody = runTactum({"feel", file("felt.glb"),
                                        write("two.obj", "usemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                                                         "usemtl b\nf 3 2 1\n"),
                                        file("none.glb")});
        QCOMPARE(nobody.code, 1);
        QVERIFY(!QFile::exists(file("none.glb")));
        QCOMPARE(runTactum({"feel", file("felt.glb"), file("new.obj"), file("out.obj")}).code, 2);
    }

    /// Exported again in millimetres with z up: as large as the scene was, and upright, or as it is said.
    void aModelThatSaysNoUnitIsTakenAsTheSceneOfBefore() {
        const auto sheet = [&](const char* name, const char* rows) {
            return write(name, QByteArray("usemtl clay\n") + rows + "f 1 2 3 4\n");
        };
        const QString metres = sheet("m.obj", "v 0 0 0\nv 0.1 0 0\nv 0.1 0.3 0.02\nv 0 0.3 0.02\n");
        const QString other = sheet("mm.obj", "v 0 0 0\nv 100 0 0\nv 100 -20 300\nv 0 -20 300\n");
        QCOMPARE(runTactum({"convert", metres, file("felt.glb")}).code, 0);
        const Ended like = runTactum({"feel", file("felt.glb"), other, file("like.glb")});
        QVERIFY2(like.code == 0, like.error);
        COMPARE_CONTAINS(like.error, "millimetres, with z up");
        const QString across = QStringLiteral("diagonal 0.316");
        COMPARE_CONTAINS(runTactum({"info", file("like.glb")}).out, across.toLatin1());
        const Ended said =
            runTactum({"feel", file("felt.glb"), other, file("said.glb"), "--unit", "cm", "--up", "y"});
        COMPARE_CONTAINS(said.error, "as you said, centimetres, with y up");
        COMPARE_CONTAINS(runTactum({"info", file("said.glb")}).out, "diagonal 3.16");
    }

    void whatIsSaidOfAUnitIsNotGuessedAsWell() {
        const QString large = write("l.obj", "v 0 0 0\nv 140 0 0\nv 0 140 0\nf 1 2 3\n");
        const Ended said = runTactum({"convert", large, file("l.glb"), "--unit", "mm"});
        COMPARE_CONTAINS(said.error, "is taken as you said, millimetres; 0.19");
        COMPARE_LACKS(said.error, "taken as metres");
        COMPARE_CONTAINS(runTactum({"convert", large, file("l.glb")}).error, "taken as metres");
        const Ended own = runTactum({"convert", file("l.glb"), file("o.glb"), "--unit", "cm"});
        COMPARE_CONTAINS(own.error, "says its unit itself");
    }

    void checkCountsAndJudges() {
        const QString plate = model("plate.obj", "clay");
        QByteArray many;
        for (int i = 0; i < 40; ++i)
            many += "o part" + QByteArray::number(i) +
                    "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf -3 -2 -1\n"; // each face twice
        const QString doubled = write("doubled.obj", many);
        QCOMPARE(runTactum({"check", plate}).code, 0);
        QCOMPARE(runTactum({"check", doubled}).code, 0);
        QCOMPARE(runTactum({"check", doubled, "--strict"}).code, 1);
        const Ended both = runTactum({"check", plate, doubled});
        for (const QByteArray& line : both.out.trimmed().split('\n'))
            QVERIFY2(line.contains("plate.obj: ") || line.contains("doubled.obj: "), line);
        COMPARE_CONTAINS(both.out, "(and 39 more like it; --json has each)");
        QCOMPARE_LT(both.out.count('\n'), 15);
        const QJsonObject json = objectOf(runTactum({"check", plate, doubled, "--json"}).out);
        QCOMPARE(json["version"].toInt(), 1);
        const QJsonArray files = json["files"].toArray();
        QCOMPARE(files.size(), 2);
        QCOMPARE_GE(files[1].toObject()["warnings"].toInt(), 40);
        const QJsonObject finding = files[1].toObject()["findings"].toArray().at(0).toObject();
        for (const char* key : {"severity", "object", "sentence", "remedy"})
            QVERIFY2(finding.contains(key), key);
    }

    void infoTellsWhatTheReaderFound() {
        const QString plate = write("plate.obj", "v 0 0 0\nv 100 0 0\nv 0 0 100\nf 1 2 3\n");
        COMPARE_CONTAINS(runTactum({"info", plate}).out, "note: has no unit: taken as metres; 141");
        QVERIFY(!objectOf(runTactum({"info", plate, "--json"}).out)["findings"].toArray().isEmpty());
        const Ended two = runTactum({"info", plate, model("second.obj", "clay"), "--json"});
        const QJsonArray all = QJsonDocument::fromJson(two.out).array();
        QCOMPARE(all.size(), 2);
        COMPARE_CONTAINS(all[1].toObject()["file"].toString(), "second.obj");
    }

    /// What cannot be read is said in its place, and the others are read all the same.
    void oneBadFileDoesNotEndTheList() {
        const QString good = model("good.obj", "clay"), last = model("last.obj", "clay");
        const QString bad = write("bad.obj", "v 0 0 0\nf 1 2 9\n");
        for (const char* verb : {"info", "check"}) {
            const Ended text = runTactum({verb, bad, good, file("gone.obj"), last});
            QCOMPARE(text.code, 1);
            QCOMPARE(text.error.count('\n'), 2);
            COMPARE_CONTAINS(text.error, "tactum: " + bad.toUtf8() + ":2: face refers to vertex");
            COMPARE_CONTAINS(text.error, "gone.obj: no such file");
            COMPARE_CONTAINS(text.out, "good.obj:");
            COMPARE_CONTAINS(text.out, "last.obj:");
        }
        const Ended info = runTactum({"info", bad, good, "--json"});
        QCOMPARE(info.code, 1);
        const QJsonArray all = QJsonDocument::fromJson(info.out).array();
        QCOMPARE(all.size(), 2);
        COMPARE_CONTAINS(all[0].toObject()["file"].toString(), "bad.obj");
        COMPARE_CONTAINS(all[0].toObject()["error"].toString(), "face refers to vertex");
        QCOMPARE(all[1].toObject()["triangles"].toInt(), 2);
        const Ended check = runTactum({"check", bad, good, "--json"});
        QCOMPARE(check.code, 1);
        const QJsonArray files = objectOf(check.out)["files"].toArray();
        QCOMPARE(files.size(), 2);
        QCOMPARE(objectOf(check.out)["ok"].toBool(true), false);
        QCOMPARE(files[0].toObject()["errors"].toInt(), 1);
        COMPARE_CONTAINS(files[0].toObject()["error"].toString(), "face refers to vertex");
        QCOMPARE(files[1].toObject()["errors"].toInt(-1), 0);
        QVERIFY(!files[1].toObject().contains("error"));
    }

    /// "cod" and "gpj.exe", turned round: a terminal would show another name.
    void namesDoNotTurnTheTerminal() {
        const QByteArray name = "cod\u202Egpj\u2066x\u200F";
        const QString evil = model("evil.obj", name);
        for (const QStringList& verb :
             {QStringList{"info", evil}, {"info", evil, "--json"}, {"check", evil}}) {
            const Ended ended = runTactum(verb);
            for (const char* turn : {"\u202E", "\u2066", "\u200F"})
                QVERIFY2(!ended.out.contains(turn), ended.out);
        }
        COMPARE_CONTAINS(runTactum({"info", evil}).out, "cod?gpj?x?");
    }

    /// All files of an export or none: the main one cannot be written, for it is too long, or a folder has
    /// its name.
    void anExportThatFailsLeavesWhatWasThere() {
        const QString plate = model("plate.obj", "clay");
        QByteArray points;
        for (int i = 0; i < 4500; ++i)
            points += (i % 3 == 0 ? "\nv " : " ") + QByteArray::number(std::sin(i), 'g', 17);
        QCOMPARE(runTactum({"convert", plate, file("a.obj")}).code, 0);
        const QByteArray before = bytesOf(file("a.obj"));
        write("a.mtl", "the old materials");
        QProcess program;
        program.setChildProcessModifier([] {
            constexpr rlimit kMost{80'000, 80'000};
            setrlimit(RLIMIT_FSIZE, &kMost);
        });
        program.start(TACTUM_PROGRAM, {"convert", write("points.obj", points), file("a.obj")});
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitCode(), 3);
        COMPARE_CONTAINS(program.readAllStandardError(), "a.obj");
        QCOMPARE(bytesOf(file("a.mtl")), QByteArray("the old materials"));
        QCOMPARE(bytesOf(file("a.obj")), before);
        QDir().mkpath(file("b.x3d"));
        QCOMPARE(runTactum({"convert", plate, file("b.x3d")}).code, 3);
        QVERIFY(!QFile::exists(file("b-deviceinfo.x3d"))); // nothing was there before
        const QStringList left = QDir(folder.path()).entryList({".tactum*"}, QDir::Files | QDir::Hidden);
        QVERIFY2(left.isEmpty(), qPrintable(left.join(' ')));
        QCOMPARE(runTactum({"convert", plate, file("c.obj")}).code, 0);
        QVERIFY(QFile::exists(file("c.mtl")));
        QCOMPARE(runTactum({"convert", plate, file("c.obj")}).code, 0); // over itself
        QVERIFY(QDir(folder.path()).entryList({".tactum*"}, QDir::Files | QDir::Hidden).isEmpty());
    }

    /// A box of 100, 50 and 20 mm that stands on z.
    void unitAndUpAreSaidAndApplied() {
        const QString box =
            write("box.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 0 0\n"
                             "vertex 100 50 20\nendloop\nendfacet\nendsolid a\n");
        COMPARE_CONTAINS(runTactum({"check", box}).out, "in millimetres it would be 0.113");
        const auto high = [&](const QStringList& options) {
            const Ended ended = runTactum(QStringList{"convert", box, file("out.glb")} + options);
            const QJsonObject scene = objectOf(runTactum({"info", file("out.glb"), "--json"}).out);
            const QJsonObject bounds = scene["bounds_m"].toObject();
            QList<double> ends{double(ended.code)};
            for (const char* end : {"low", "high"})
                for (const QJsonValue& value : bounds[end].toArray())
                    ends << value.toDouble();
            return ends;
        };
        const auto compare = [](const QList<double>& now, const QList<double>& wanted) {
            QCOMPARE(now.size(), wanted.size());
            for (int i = 0; i < now.size(); ++i)
                COMPARE_NEAR(now[i], wanted[i], 1e-7, "m");
        };
        compare(high({"--unit", "mm"}), {0, 0, 0, 0, 0.1, 0.05, 0.02});
        compare(high({"--unit", "in"}), {0, 0, 0, 0, 2.54, 1.27, 0.508});
        compare(high({"--unit", "mm", "--up", "z"}), {0, 0, 0, -0.05, 0.1, 0.02, 0});
        compare(high({"--up", "y"}), {0, 0, 0, 0, 100, 50, 20});
        QCOMPARE(runTactum({"convert", box, file("out.glb"), "--unit", "ell"}).code, 2);
    }

    /// A sheet of 100: a finger 0.2 m from its corner touches it where it is one of metres, and not as one of
    /// millimetres.
    void everyVerbTakesTheUnit() {
        const QString sheet = write("sheet.obj", "v 0 0 0\nv 100 0 0\nv 100 0 100\nv 0 0 100\nf 4 3 2 1\n");
        COMPARE_CONTAINS(runTactum({"info", sheet, "--unit", "mm"}).out, "diagonal 0.141");
        const Ended checked = runTactum({"check", sheet, "--unit", "mm"});
        COMPARE_CONTAINS(checked.out, "is taken as you said, millimetres");
        COMPARE_LACKS(checked.out, "in millimetres it would be");
        const QString path = write("in.csv", "t,x,y,z\n0,0.2,0.01,0.2\n0.001,0.2,-0.001,0.2\n");
        const QStringList touch{"touch", sheet, "--path", path};
        COMPARE_LACKS(runTactum(touch).error, "touches nothing");
        COMPARE_CONTAINS(runTactum(touch + QStringList{"--unit", "mm"}).error, "touches nothing");
    }

    void theVersionIsALine() {
        const Ended version = runTactum({"--version"});
        QCOMPARE(version.code, 0);
        COMPARE_BEGINS(version.out, "tactum 0.");
        QCOMPARE(version.out.count('\n'), 1);
    }

    /// What takes most of the time in which a verb starts.
    void aVerbLoadsNoWindow() {
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_TRACE_LOADED_OBJECTS", "1");
        program.setProcessEnvironment(environment);
        program.start(TACTUM_PROGRAM, {"--help"});
        QVERIFY(program.waitForFinished(60000));
        const QByteArray libraries = program.readAllStandardOutput();
        COMPARE_CONTAINS(libraries, "libc.so");
        for (const char* heavy : {"libQt", "libvtk", "libGL"})
            QVERIFY2(!libraries.contains(heavy), libraries);
    }
};

TACTUM_TEST(TestOtherFiles)

} // namespace test_other_files

#include "test_other_files.moc"
