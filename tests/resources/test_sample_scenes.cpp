// The samples: whole, of a hand's size, felt by a finger, and what their generator writes.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <set>

#include "core/bundle/sample_stroke.h"
#include "core/files/load_scene.h"
#include "core/files/read_finger_path.h"
#include "core/geometry/mesh_health.h"
#include "core/geometry/triangle.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_sample_scenes {

using namespace tactum;

namespace {

const std::string kFolder = SAMPLES "/";

QByteArray contentOf(const QString& file) {
    QFile stream(file);
    return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

/// How far a point is from the nearest triangle of a scene.
double distanceTo(const Scene& scene, const Vec3& p) {
    double nearest = 1e300;
    for (const SceneObject& object : scene.objects)
        for (const auto& t : object.geometry->triangles) {
            const auto& at = object.geometry->positions;
            const Triangle triangle{at[t[0]], at[t[1]], at[t[2]]};
            nearest = std::min(nearest, (closestPoint(triangle, p).point - p).norm());
        }
    return nearest;
}

/// Without ending; what moves has a folder of its own.
std::string pathOf(const std::string& name) {
    const std::string moving = kFolder + "moving/" + name;
    return QFile::exists(QString::fromStdString(moving + ".glb")) ? moving : kFolder + name;
}

Result<LoadedScene> sample(const std::string& name) {
    return loadScene(pathOf(name) + ".glb");
}

/// All below a folder, relative to it.
QStringList filesBelow(const QString& folder) {
    QStringList files;
    for (QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        files << QDir(folder).relativeFilePath(it.next());
    files.sort();
    return files;
}

/// What of a file is its finger: four doubles a row.
qint64 pathLength(const QString& file) {
    if (!file.endsWith(".glb")) return 0;
    const auto loaded = loadScene(kFolder + file.toStdString());
    return loaded && loaded->scene.finger ? qint64(loaded->scene.finger->size()) * 32 : 0;
}

} // namespace

class TestSampleScenes : public QObject {
    Q_OBJECT

private slots:
    void theFilesAreWhatTheGeneratorWrites() {
        QTemporaryDir made;
        QCOMPARE(QProcess::execute(MAKE_SAMPLES, {made.path()}), 0);
        const QStringList names = filesBelow(made.path());
        QCOMPARE(filesBelow(QString::fromStdString(kFolder)), names);
        qint64 total = 0, rows = 0;
        for (const QString& name : names) {
            const QByteArray committed = contentOf(QString::fromStdString(kFolder) + name);
            QCOMPARE_EQ(contentOf(made.filePath(name)), committed);
            if (name.endsWith(".glb") || name.endsWith(".png") || name.endsWith(".gif")) {
                QCOMPARE_LT(committed.size(), 500'000 + pathLength(name));
                total += committed.size() - pathLength(name);
            }
            if (name.endsWith(".csv")) rows += committed.size();
        }
        QCOMPARE_LT(total, std::size_t(names.size()) * 50'000);
        QCOMPARE_LT(rows, std::size_t(names.size()) * 25'000);
    }

    void aSampleHasItsSurfacesAndNothingToMend_data() {
        QTest::addColumn<QString>("objects");
        const auto row = [](const char* name, const char* objects) { QTest::newRow(name) << objects; };
        row("teapot", "teapot(body,lid,spout,handle) table(table)");
        row("friction-ladder",
            "plate 1(mu 0) plate 2(mu 0.2) plate 3(mu 0.4) plate 4(mu 0.6) plate 5(mu 0.8) plate 6(mu 1) "
            "board(board,studs)");
        row("viscosity-ladder",
            "plate 1(b 0 N s/m) plate 2(b 4 N s/m) plate 3(b 8 N s/m) plate 4(b 12 N s/m) "
            "plate 5(b 16 N s/m) plate 6(b 20 N s/m) board(board,studs)");
        row("stiffness-ladder", "plate 1(k 50 N/m) plate 2(k 100 N/m) plate 3(k 200 N/m) plate 4(k 400 N/m) "
                                "plate 5(k 800 N/m) plate 6(k 1600 N/m) board(board,studs)");
        row("texture-wall", "brick(brick,mortar,brick back) tiles(tile,grout,tiles back) "
                            "weave(weave,weave back) sandpaper(sandpaper,sandpaper back) wall(plaster)");
        row("layered-leather", "cushion(leather,thread,lining) board(wood)");
        row("relief-coin", "coin(field,relief,rim) tray(felt)");
        row("thin-wall-maze", "walls(wall) floor(floor) start(start) goal(goal)");
        row("blind-box", "box(walls,lid) hidden shape(shape)");
        row("windmill", "meadow(meadow) tower(tower) sails(sails)");
        row("crank", "frame(frame) wheel(wheel) connecting rod(connecting rod) piston(piston)");
        row("turntable", "box(box) record(record) label(label) mark(mark)");
        row("rocket-car", "track(track) car(car) rocket(rocket) wheels(wheels)");
        row("roller-coaster",
            "ground(ground) rails(rails) posts(posts) car 1(car 1) seat 1(seat 1) car 2(car 2) "
            "seat 2(seat 2) car 3(car 3) seat 3(seat 3)");
        row("cabinet", "cabinet(cabinet) door(door) lower drawer(lower drawer) upper drawer(upper drawer)");
        row("keyboard", "bed(bed) C(C) D(D) E(E) F(F) G(G) A(A) B(B) c(c) C sharp(C sharp) D sharp(D sharp) "
                        "F sharp(F sharp) G sharp(G sharp) A sharp(A sharp)");
        row("kettle", "table(table) kettle(kettle) lid(lid) knob(knob)");
        row("micro-sensor", "frame(frame) test mass(test mass) flexures(flexures)");
        row("ball-table", "cloth(cloth) rail(rail) cue ball(cue ball) ball 1(ball 1) ball 2(ball 2) ball "
                          "3(ball 3) ball 4(ball 4) ball 5(ball 5) ball 6(ball 6)");
        row("dominoes",
            "table(table) domino 1(domino 1) domino 2(domino 2) domino 3(domino 3) domino 4(domino 4) domino "
            "5(domino 5) domino 6(domino 6) domino 7(domino 7) domino 8(domino 8) domino 9(domino 9) domino "
            "10(domino 10) domino 11(domino 11) domino 12(domino 12) domino 13(domino 13) domino 14(domino "
            "14) domino 15(domino 15) domino 16(domino 16)");
        row("bell", "gallows(gallows) rope 1(rope 1) rope 2(rope 2) rope 3(rope 3) rope 4(rope 4) rope "
                    "5(rope 5) bell(bell)");
        row("marionette",
            "cross(cross) stage(stage) chest(chest) hips(hips) head(head) head string(head string) left "
            "arm(left arm) left hand(left hand) left thigh(left thigh) left shin(left shin) left foot(left "
            "foot) left hand string(left hand string) left knee string(left knee string) right arm(right "
            "arm) right hand(right hand) right thigh(right thigh) right shin(right shin) right foot(right "
            "foot) right hand string(right hand string) right knee string(right knee string)");
    }
    void aSampleHasItsSurfacesAndNothingToMend() {
        QFETCH(QString, objects);
        const auto loaded = sample(QTest::currentDataTag());
        VERIFY_RESULT(loaded);
        QStringList found;
        for (const SceneObject& object : loaded->scene.objects) {
            QStringList surfaces;
            for (const Surface& surface : object.surfaces)
                surfaces << QString::fromStdString(surface.name);
            found << QStringLiteral("%1(%2)").arg(QString::fromStdString(object.name), surfaces.join(u','));
        }
        QCOMPARE(found.join(u' '), objects);
        const Vec3 size = boundsOf(loaded->scene).high - boundsOf(loaded->scene).low;
        QCOMPARE_GE(size.maxCoeff(), 0.1);
        const bool wide = QByteArray(QTest::currentDataTag()) == "roller-coaster";
        QCOMPARE_LE(size.maxCoeff(), wide ? 0.3 : 0.21);
        for (const auto& findings : {loaded->findings, validate(loaded->scene)})
            for (const Finding& finding : findings)
                QVERIFY2(finding.severity == Finding::Severity::Note,
                         (finding.object + ": " + finding.sentence).c_str());
    }

    void aStrokeTouchesEverySampleGently_data() { aSampleHasItsSurfacesAndNothingToMend_data(); }
    void aStrokeTouchesEverySampleGently() {
        const auto loaded = sample(QTest::currentDataTag());
        VERIFY_RESULT(loaded);
        const auto world = compile(loaded->scene);
        VERIFY_RESULT(world);
        double greatest = 0;
        int touched = 0;
        for (const TouchRow& row : replay(**world, sampleStroke(**world))) {
            QVERIFY(row.force.allFinite());
            QVERIFY(row.proxy.allFinite());
            greatest = std::max(greatest, row.force.norm());
            touched += row.contacts > 0;
        }
        qInfo("%d of 4001 steps touch, with at most %.2f N", touched, greatest);
        // What is pushed goes away.
        QCOMPARE_GT(touched, loaded->scene.mechanics.bodies.empty() ? 1000 : 300);
        QCOMPARE_GT(greatest, 0.1);
        QCOMPARE_LT(greatest, 30);
    }

    /// What a bundle promises, of the file beside the scene; it has seven decimals.
    void theFingerFeelsWhatItsFileSays_data() { aSampleHasItsSurfacesAndNothingToMend_data(); }
    void theFingerFeelsWhatItsFileSays() {
        const auto loaded = sample(QTest::currentDataTag());
        VERIFY_RESULT(loaded);
        QVERIFY(loaded->scene.finger);
        const std::vector<FingerPoint>& finger = *loaded->scene.finger;
        const std::string file = pathOf(QTest::currentDataTag()) + ".csv";
        COMPARE_CONTAINS(test::refusal(readFingerPath(file)),
                         "the header must be"); // nobody takes it for a finger
        const std::string text = contentOf(QString::fromStdString(file)).toStdString();
        const auto expected = readFingerPath("t,x,y,z" + text.substr(text.find('\n')), file);
        VERIFY_RESULT(expected);
        QCOMPARE(expected->size(), finger.size());
        const TouchTrace rows = replay(**compile(loaded->scene), finger);
        double most = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Vec3& force = (*expected)[i].position;
            QCOMPARE((*expected)[i].t, finger[i].t);
            QVERIFY2((rows[i].force - force).norm() < 1e-6, qPrintable(QString::number(finger[i].t)));
            most = std::max(most, force.norm());
        }
        QVERIFY2(most > 0.5 && most < 5, qPrintable(QString::number(most)));
    }

    /// From the air and back into it, no faster than 0.3 m/s.
    void theFingerMovesAsAHandDoes_data() { aSampleHasItsSurfacesAndNothingToMend_data(); }
    void theFingerMovesAsAHandDoes() {
        const auto loaded = sample(QTest::currentDataTag());
        VERIFY_RESULT(loaded);
        QVERIFY(loaded->scene.finger);
        const std::vector<FingerPoint>& finger = *loaded->scene.finger;
        QCOMPARE_GT(finger.size(), 1900);
        QCOMPARE_LE(finger.size(), 3601); // ms
        for (const FingerPoint& end : {finger.front(), finger.back()})
            QCOMPARE_GT(distanceTo(loaded->scene, end.position), 0.005);
        for (std::size_t i = 1; i < finger.size(); ++i) {
            COMPARE_NEAR(finger[i].t - finger[i - 1].t, 1e-3, 1e-9, "s");
            COMPARE_NEAR(finger[i].position, finger[i - 1].position, 0.3e-3, "m");
        }
    }

    /// Each path comes to everything that its scene is for.
    void theFingerTouchesWhatTheSceneShows() {
        const auto rowsOf = [](const char* name, const auto& look) {
            const auto loaded = sample(name);
            if (!loaded || !loaded->scene.finger) return;
            const auto world = compile(loaded->scene);
            for (const TouchRow& row : replay(**world, *loaded->scene.finger))
                if (row.contacts > 0) look(loaded->scene, row);
        };
        for (const char* ladder : {"friction-ladder", "viscosity-ladder", "stiffness-ladder"}) {
            std::set<int> plates;
            rowsOf(ladder, [&](const Scene& scene, const TouchRow& row) {
                for (int i = 0; i < 6; ++i) {
                    const Bounds box = boundsOf(*scene.objects[std::size_t(i)].geometry);
                    if (row.proxy.x() > box.low.x() && row.proxy.x() < box.high.x()) plates.insert(i);
                }
            });
            QCOMPARE(plates.size(), std::size_t(6));
        }
        std::set<std::string> panels;
        rowsOf("texture-wall", [&](const Scene& scene, const TouchRow& row) {
            for (const SceneObject& object : scene.objects) {
                const Vec3 p = object.pose.applyInverse(row.proxy);
                const Bounds box = boundsOf(*object.geometry);
                if (std::abs(p.z() - 1e-3) < 1e-6 && p.x() > box.low.x() && p.x() < box.high.x() &&
                    p.y() > box.low.y() && p.y() < box.high.y())
                    panels.insert(object.name);
            }
        });
        QCOMPARE(panels, (std::set<std::string>{"brick", "sandpaper", "tiles", "weave"}));
        bool held = false;
        rowsOf("thin-wall-maze",
               [&](const Scene& scene, const TouchRow& row) { // 2 mm behind the wall's middle
                   const double side = boundsOf(*scene.objects[0].geometry).low.x();
                   held |= row.finger.x() < side && row.proxy.x() > side + 0.0016;
               });
        QVERIFY(held);
        bool isInside = false; // below the top of the hidden shape
        rowsOf("blind-box", [&](const Scene& scene, const TouchRow& row) {
            isInside |= row.proxy.y() < boundsOf(*scene.objects[1].geometry).high.y() / 2;
        });
        QVERIFY(isInside);
    }

    void theLaddersRise() {
        const auto values = [](const char* name, double Material::*value) {
            std::vector<double> all;
            const auto loaded = sample(name);
            for (std::size_t i = 0; loaded && i < 6; ++i)
                all.push_back(loaded->scene.objects[i].surfaces[0].material.*value);
            return all;
        };
        using Values = std::vector<double>;
        const Values rest = values("friction-ladder", &Material::staticFriction);
        const Values slide = values("friction-ladder", &Material::dynamicFriction);
        QCOMPARE(rest, (Values{0, 0.2, 0.4, 0.6, 0.8, 1}));
        for (std::size_t i = 1; i < rest.size(); ++i) {
            QCOMPARE_LT(slide[i], rest[i]);
            QCOMPARE_GT(slide[i], slide[i - 1]);
        }
        QCOMPARE(values("viscosity-ladder", &Material::viscosity), (Values{0, 4, 8, 12, 16, 20}));
        QCOMPARE(values("stiffness-ladder", &Material::stiffness), (Values{50, 100, 200, 400, 800, 1600}));
    }

    void picturesKeepTheirSixteenBits() {
        for (const auto& [name, object, layer] : {std::tuple{"texture-wall", 0, 0},
                                                  {"texture-wall", 1, 0},
                                                  {"layered-leather", 0, 2},
                                                  {"relief-coin", 0, 0}}) {
            const auto loaded = sample(name);
            VERIFY_RESULT(loaded);
            const auto& layers = loaded->scene.objects[std::size_t(object)].surfaces[0].layers;
            QCOMPARE_LT(std::size_t(layer), layers.size());
            const TextureLayer& found = layers[std::size_t(layer)];
            QVERIFY(found.pattern.image);
            QCOMPARE_EQ(found.pattern.image->bits(), 16);
            QCOMPARE_GE(found.strength, 1e-4);
            QCOMPARE_LE(found.strength, 1e-3);
        }
    }

    /// Pressed sideways from a way into the next one: the proxy, 2 mm across, stays before 1.6 mm of wall.
    void nobodyGetsThroughAWallOfTheMaze() {
        const auto loaded = sample("thin-wall-maze");
        VERIFY_RESULT(loaded);
        const auto world = compile(loaded->scene);
        VERIFY_RESULT(world);
        const double outside = boundsOf(*loaded->scene.objects[0].geometry).low.x();
        std::vector<FingerPoint> path;
        for (int i = 0; i <= 2000; ++i)
            path.push_back({i * 1e-3, {outside + 0.009 - 0.02 * i / 2000.0, 0.003, 0.055}});
        const TouchTrace trace = replay(**world, path);
        QCOMPARE_GT(trace.back().contacts, 0);
        QCOMPARE_LT(trace.back().finger.x(), outside);
        QCOMPARE_GT(trace.back().proxy.x(), outside + 0.0016);
        QCOMPARE_GT(trace.back().force.x(), 5); // N, back inside
    }

    void theTeapotIsClosedAndOfAHandsSize() {
        const auto loaded = loadScene(kFolder + "teapot.obj");
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects.size(), std::size_t(2));
        const SceneObject &teapot = loaded->scene.objects[0], &table = loaded->scene.objects[1];
        QCOMPARE(teapot.name, std::string("teapot"));
        QCOMPARE(table.name, std::string("table"));
        std::vector<std::string> names;
        for (const Surface& surface : teapot.surfaces)
            names.push_back(surface.name);
        QCOMPARE(names, (std::vector<std::string>{"body", "lid", "spout", "handle"}));
        QVERIFY(teapot.surfaces[0].colour != teapot.surfaces[1].colour);
        for (const SceneObject* object : {&teapot, &table}) {
            const MeshHealth health = healthOf(*object->geometry).value();
            QVERIFY(health.closed());
            QCOMPARE(health.slivers + health.duplicateFaces + health.segments + health.points,
                     std::size_t(0));
            QVERIFY(health.hasNormals);
        }
        const Bounds box = boundsOf(*teapot.geometry), top = boundsOf(*table.geometry);
        COMPARE_NEAR((box.high - box.low).x(), 0.125, 0.01, "m");
        QCOMPARE_GT(box.low.y(), 0);
        QCOMPARE_LT(box.low.y(), 0.001); // stands just above the table
        QCOMPARE_LT(std::abs(top.high.y()), 1e-6);
        COMPARE_NEAR((top.high - top.low).x(), 0.2, 0.002, "m");
        QCOMPARE_GT(triangleCount(loaded->scene), 8000);
        QCOMPARE_LT(triangleCount(loaded->scene), 12000);
    }

    /// Otherwise shading would light the inside.
    void normalsPointOutwardLikeTheTriangles() {
        const auto loaded = loadScene(kFolder + "teapot.obj");
        VERIFY_RESULT(loaded);
        for (const SceneObject& object : loaded->scene.objects) {
            const TriangleSoup& soup = *object.geometry;
            double volume = 0;
            for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
                const auto& t = soup.triangles[f];
                const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
                const Vec3 normal = (b - a).cross(c - a);
                volume += a.dot(normal);
                const Vec3 shading = soup.cornerNormals[3 * f].cast<double>();
                QCOMPARE_GT(normal.normalized().dot(shading), 0.3);
            }
            QCOMPARE_GT(volume, 0);
        }
    }

    void theFingerComesFromOutsideAndTouchesGently() {
        const auto path = readFingerPath(kFolder + "teapot-finger.csv");
        VERIFY_RESULT(path);
        QCOMPARE(path->size(), std::size_t(8001));
        const auto loaded = loadScene(kFolder + "teapot.obj");
        VERIFY_RESULT(loaded);
        QCOMPARE_GT(distanceTo(loaded->scene, path->front().position), 0.02);
        QCOMPARE_GT(distanceTo(loaded->scene, path->back().position), 0.02);
        QCOMPARE_GT(distanceTo(loaded->scene, (*path)[1000].position), 0.0035); // pressed 4 mm in
        for (std::size_t i = 0; i < path->size(); ++i) {
            if (i % 50 == 0 && i >= 700 && i <= 2800)
                QCOMPARE_LT(distanceTo(loaded->scene, (*path)[i].position), 0.0045);
            if (i == 0) continue;
            const Vec3 step = (*path)[i].position - (*path)[i - 1].position;
            QVERIFY2(step.norm() < 0.3e-3, "faster than 0.3 m/s");
        }
    }
};

TACTUM_TEST(TestSampleScenes)

} // namespace test_sample_scenes

#include "test_sample_scenes.moc"
