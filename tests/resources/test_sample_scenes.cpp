// The sample that the program opens by itself: whole, of a hand's size, and what its generator writes.
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/geometry/mesh_health.h"
#include "core/geometry/triangle.h"
#include "core/scene/finger_path.h"
#include "core/scene/load_scene.h"

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

} // namespace

class TestSampleScenes : public QObject {
    Q_OBJECT

private slots:
    void theFilesAreWhatTheGeneratorWrites() {
        QTemporaryDir folder;
        QCOMPARE(QProcess::execute(MAKE_SAMPLES, {folder.path()}), 0);
        for (const char* name : {"teapot.obj", "teapot.mtl", "teapot-finger.csv"}) {
            const QByteArray committed = contentOf(QString::fromStdString(kFolder + name));
            QVERIFY(!committed.isEmpty());
            QVERIFY2(contentOf(folder.filePath(name)) == committed, name);
        }
    }

    void theTeapotIsClosedAndOfAHandsSize() {
        const auto loaded = loadScene(kFolder + "teapot.obj");
        QVERIFY(loaded);
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
        QVERIFY(std::abs((box.high - box.low).x() - 0.125) < 0.01);
        QVERIFY(box.low.y() > 0 && box.low.y() < 0.001); // stands just above the table
        QVERIFY(std::abs(top.high.y()) < 1e-6 && std::abs((top.high - top.low).x() - 0.2) < 0.002);
        QVERIFY(triangleCount(loaded->scene) > 8000 && triangleCount(loaded->scene) < 12000);
    }

    /// Otherwise shading would light the inside.
    void normalsPointOutwardLikeTheTriangles() {
        const auto loaded = loadScene(kFolder + "teapot.obj");
        QVERIFY(loaded);
        for (const SceneObject& object : loaded->scene.objects) {
            const TriangleSoup& soup = *object.geometry;
            double volume = 0;
            for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
                const auto& t = soup.triangles[f];
                const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
                const Vec3 normal = (b - a).cross(c - a);
                volume += a.dot(normal);
                const Vec3 shading = soup.cornerNormals[3 * f].cast<double>();
                QVERIFY(normal.normalized().dot(shading) > 0.3);
            }
            QVERIFY(volume > 0);
        }
    }

    void theFingerComesFromOutsideAndTouchesGently() {
        const auto path = readFingerPath(kFolder + "teapot-finger.csv");
        QVERIFY(path);
        QCOMPARE(path->size(), std::size_t(8001));
        const auto loaded = loadScene(kFolder + "teapot.obj");
        QVERIFY(loaded);
        QVERIFY(distanceTo(loaded->scene, path->front().position) > 0.02);
        QVERIFY(distanceTo(loaded->scene, path->back().position) > 0.02);
        QVERIFY(distanceTo(loaded->scene, (*path)[1000].position) > 0.0035); // pressed 4 mm in
        for (std::size_t i = 0; i < path->size(); ++i) {
            if (i % 50 == 0 && i >= 700 && i <= 2800)
                QVERIFY(distanceTo(loaded->scene, (*path)[i].position) < 0.0045);
            if (i == 0) continue;
            const Vec3 step = (*path)[i].position - (*path)[i - 1].position;
            QVERIFY2(step.norm() < 0.3e-3, "faster than 0.3 m/s");
        }
    }
};

QTEST_GUILESS_MAIN(TestSampleScenes)
#include "test_sample_scenes.moc"
