// What HL makes of GL's calls before anything is sent: triangles, matrices, bytes.
#include <cmath>
#include <cstring>

#include <QTest>

#include "app/hl/model.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_hl_model {

using namespace hl;

namespace {

tactum::Vec3 of(const Vec& v) {
    return {v[0], v[1], v[2]};
}

std::vector<Corner> cornersAt(std::initializer_list<Vec> points) {
    std::vector<Corner> corners;
    for (const Vec& p : points)
        corners.push_back({.position = p});
    return corners;
}

/// Twice its area, along its front.
tactum::Vec3 frontOf(const Model& model, std::size_t triangle) {
    const auto at = [&](std::size_t i) { return of(model.corners[3 * triangle + i].position); };
    return (at(1) - at(0)).cross(at(2) - at(0));
}

} // namespace

class TestHlModel : public QObject {
    Q_OBJECT

private slots:
    void modesKeepTheFront();
    void matricesAreThoseOfGl();
    void placementsGiveTheMatrixBack();
    void whatCannotBePlaced();
    void cornersAreSentOnce();
    void mirrorsKeepTheFront();
};

// The unit square, counter-clockwise, as every mode says it.
void TestHlModel::modesKeepTheFront() {
    const Vec a{0, 0, 0}, b{1, 0, 0}, c{1, 1, 0}, d{0, 1, 0};
    const std::vector<std::pair<Mode, std::vector<Corner>>> all{{Triangles, cornersAt({a, b, c, a, c, d})},
                                                                {TriangleStrip, cornersAt({a, b, d, c})},
                                                                {TriangleFan, cornersAt({a, b, c, d})},
                                                                {Quads, cornersAt({a, b, c, d})},
                                                                {Polygon, cornersAt({a, b, c, d})}};
    for (const auto& [mode, corners] : all) {
        Model model;
        appendTriangles(model, mode, corners);
        QCOMPARE_EQ(model.corners.size(), std::size_t(6));
        COMPARE_NEAR(frontOf(model, 0), tactum::Vec3(0, 0, 1), 1e-15, "");
        COMPARE_NEAR(frontOf(model, 1), tactum::Vec3(0, 0, 1), 1e-15, "");
    }
}

void TestHlModel::matricesAreThoseOfGl() {
    const Matrix all =
        Matrix::ofTranslation({1, 2, 3}) * Matrix::ofRotation(90, {0, 0, 2}) * Matrix::ofScale({2, 3, 4});
    COMPARE_NEAR(of(all.apply({1, 0, 0})), tactum::Vec3(1, 4, 3), 1e-12, "");
    COMPARE_NEAR(of(all.apply({0, 1, 0})), tactum::Vec3(-2, 2, 3), 1e-12, "");
    COMPARE_NEAR(of(all.apply({0, 0, 1})), tactum::Vec3(1, 2, 7), 1e-12, "");
}

void TestHlModel::placementsGiveTheMatrixBack() {
    for (const Vec& axis : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}, Vec{1, 2, -3}})
        for (const double degrees : {0.0, 30.0, 120.0, 180.0, 270.0}) {
            const Matrix matrix = Matrix::ofTranslation({1, 2, 3}) * Matrix::ofRotation(degrees, axis) *
                                  Matrix::ofScale({2, 3, -4});
            const Placement placement = placementOf(matrix);
            QVERIFY(placement.possible);
            const Turn& q = placement.place.turn;
            const tactum::Quat turn(q[0], q[1], q[2], q[3]);
            COMPARE_NEAR(turn.norm(), 1.0, 1e-12, "");
            const Vec& s = placement.scale;
            for (const Vec& p : {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0.3, -0.2, 0.7}}) {
                const tactum::Vec3 back =
                    turn * tactum::Vec3(s[0] * p[0], s[1] * p[1], s[2] * p[2]) + of(placement.place.position);
                COMPARE_NEAR(back, of(matrix.apply(p)), 1e-9, "");
            }
        }
}

void TestHlModel::whatCannotBePlaced() {
    QVERIFY(!placementOf(Matrix::ofScale({1, 0, 1})).possible);                                     // flat
    QVERIFY(!placementOf(Matrix::ofScale({1, 2, 1}) * Matrix::ofRotation(45, {0, 0, 1})).possible); // sheared
    QVERIFY(!placementOf(Matrix::ofScale({std::nan(""), 1, 1})).possible);
}

void TestHlModel::cornersAreSentOnce() {
    Model model;
    appendTriangles(model, Quads, cornersAt({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    const MeshBytes mesh = bytesOf(model, {1, 1, 1});
    QCOMPARE_EQ(mesh.positions, std::uint64_t(4));
    QCOMPARE_EQ(mesh.triangles, std::uint64_t(2));
    QCOMPARE_EQ(mesh.bytes.size(), 4 * 3 * sizeof(double) + 6 * sizeof(std::uint32_t));
}

void TestHlModel::mirrorsKeepTheFront() {
    Model model;
    appendTriangles(model, Triangles, cornersAt({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const MeshBytes mesh = bytesOf(model, {-1, 1, 1});
    std::vector<double> p(9);
    std::vector<std::uint32_t> corner(3);
    std::memcpy(p.data(), mesh.bytes.data(), 9 * sizeof(double));
    std::memcpy(corner.data(), mesh.bytes.data() + 9 * sizeof(double), 3 * sizeof(std::uint32_t));
    const auto at = [&](std::size_t i) {
        return tactum::Vec3(p[3 * corner[i]], p[3 * corner[i] + 1], p[3 * corner[i] + 2]);
    };
    QCOMPARE_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0);
}

TACTUM_TEST(TestHlModel)

} // namespace test_hl_model

#include "test_hl_model.moc"
