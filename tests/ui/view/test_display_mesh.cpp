#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/display_mesh.h"

namespace test_display_mesh {

using namespace tactum;
using namespace tactum::testing;

namespace {

/// Two triangles that share an edge and bend there by an angle, degrees.
TriangleSoup bentSheet(double degrees) {
    const double a = degrees * EIGEN_PI / 180;
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(a), 0, -std::sin(a)}};
    soup.triangles = {{0, 1, 2}, {0, 3, 1}};
    soup.surfaceOf = {0, 0};
    return soup;
}

} // namespace

class TestDisplayMesh : public QObject {
    Q_OBJECT
private slots:
    void everyTriangleIsInItsSurface() {
        const auto soup = ballSoup(16, 8);
        for (const DisplayMesh& mesh : {flatMesh(*soup), smoothMesh(*soup)}) {
            std::size_t shown = 0;
            for (const DisplaySurface& s : bySurface(mesh.corners, soup->surfaceOf, 2))
                shown += s.triangles.size() / 3 + s.segments.size() / 2;
            QCOMPARE(shown, soup->triangles.size());
        }
    }

    void aBallsNormalsPointOutward() {
        const auto soup = ballSoup(64, 32);
        const auto mesh = smoothMesh(*soup);
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        const auto surfaces = bySurface(mesh.corners, soup->surfaceOf, 2);
        for (int corner : surfaces[kUpper].triangles) {
            const Eigen::Map<const Eigen::Vector3f> p(&mesh.positions[3 * corner]),
                n(&mesh.normals[3 * corner]);
            QCOMPARE_GT(n.dot(p.normalized()), 0.98f);
        }
    }

    void onlyAGentleBendSharesItsVertices() {
        QCOMPARE(smoothMesh(bentSheet(20)).positions.size() / 3, std::size_t(4));
        QCOMPARE(smoothMesh(bentSheet(60)).positions.size() / 3, std::size_t(6));
    }

    void theFilesNormalsWin() {
        TriangleSoup soup = bentSheet(0);
        soup.cornerNormals.assign(6, Eigen::Vector3f::UnitX());
        const auto mesh = smoothMesh(soup);
        for (std::size_t i = 0; i < mesh.normals.size(); i += 3)
            QCOMPARE(mesh.normals[i], 1.0f);
    }

    void segmentsAndPointsAreShownAsSuch() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {1, 0, 0}};
        soup.triangles = {{0, 1, 1}, {1, 1, 1}};
        soup.surfaceOf = {0, 0};
        for (const DisplayMesh& mesh : {flatMesh(soup), smoothMesh(soup)}) {
            const DisplaySurface shown = bySurface(mesh.corners, soup.surfaceOf, 1)[0];
            QCOMPARE(shown.segments.size(), std::size_t(2));
            QCOMPARE(shown.points.size(), std::size_t(1));
            QVERIFY(shown.triangles.empty());
        }
    }

    void cancelledWorkStillShowsEverything() {
        const std::atomic<bool> cancelled = true;
        const auto mesh = smoothMesh(*ballSoup(16, 8), Progress{{}, &cancelled});
        QVERIFY(mesh.normals.empty());
        QCOMPARE(mesh.corners.size(), ballSoup(16, 8)->triangles.size());
    }
};

TACTUM_TEST(TestDisplayMesh)

} // namespace test_display_mesh

#include "test_display_mesh.moc"
