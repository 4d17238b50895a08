// What an author begins with: closed, outside out, of a hand's size, and with coordinates for pictures.
#include <numbers>

#include <QTest>

#include "core/geometry/mesh_health.h"
#include "core/scene/findings.h"
#include "core/scene/primitives.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_primitives {

using namespace tactum;
using namespace tactum::test;

class TestScenePrimitives : public QObject {
    Q_OBJECT

private slots:
    void eachIsASolid_data() {
        QTest::addColumn<int>("primitive");
        QTest::addColumn<double>("volume"); // m^3
        const double pi = std::numbers::pi;
        QTest::newRow("box") << int(Primitive::Box) << 0.06 * 0.06 * 0.06;
        QTest::newRow("sphere") << int(Primitive::Sphere) << 4 / 3.0 * pi * 0.03 * 0.03 * 0.03;
        QTest::newRow("cylinder") << int(Primitive::Cylinder) << pi * 0.03 * 0.03 * 0.08;
        QTest::newRow("plate") << int(Primitive::Plate) << 0.12 * 0.12 * 0.008;
        QTest::newRow("ground") << int(Primitive::Ground) << 0.32 * 0.32 * 0.01;
    }

    void eachIsASolid() {
        QFETCH(int, primitive);
        QFETCH(double, volume);
        const Scene scene = sceneOf(Primitive(primitive));
        const TriangleSoup& soup = *scene.objects.at(0).geometry;
        const MeshHealth health = healthOf(soup).value();
        QVERIFY(health.closed());
        QCOMPARE(health.components, std::size_t(1));
        QCOMPARE(health.unreferencedVertices, std::size_t(0));
        QVERIFY(validate(scene).empty());
        double enclosed = 0, away = 0;
        float least = 1, most = 0;
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const auto& [a, b, c] = soup.triangles[t];
            const Vec3 p = soup.positions[a], q = soup.positions[b], r = soup.positions[c];
            enclosed += p.dot(q.cross(r)) / 6;
            const Vec3 facet = (q - p).cross(r - p).normalized();
            for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
                away = std::max(away, (soup.cornerNormals[corner].cast<double>() - facet).norm());
                least = std::min(least, soup.cornerUvs[corner].minCoeff());
                most = std::max(most, soup.cornerUvs[corner].maxCoeff());
            }
        }
        COMPARE_NEAR(enclosed / volume, 1, 0.003, "");
        QCOMPARE_LT(away, 0.05); // normals point out, and round as the body is
        QCOMPARE_EQ(least, 0.0f);
        QCOMPARE_EQ(most, 1.0f);
    }

    // A picture is the right way round on every side: u, v and the normal are a right-handed frame.
    void picturesAreNotMirrored() {
        for (int kind = 0; kind <= int(Primitive::Ground); ++kind) {
            const TriangleSoup soup = *sceneOf(Primitive(kind)).objects[0].geometry;
            for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
                const Eigen::Vector2f u = soup.cornerUvs[3 * t + 1] - soup.cornerUvs[3 * t],
                                      v = soup.cornerUvs[3 * t + 2] - soup.cornerUvs[3 * t];
                QCOMPARE_GT(u.x() * v.y() - u.y() * v.x(), 0.0f);
            }
        }
    }
};

TACTUM_TEST(TestScenePrimitives)

} // namespace test_scene_primitives

#include "test_scene_primitives.moc"
