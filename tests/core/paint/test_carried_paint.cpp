// What was painted stays where it was when a mesh is repaired.
#include <cmath>

#include <QTest>

#include "core/geometry/repair.h"
#include "core/paint/carry.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_carried_paint {

using namespace tactum;

class TestCarriedPaint : public QObject {
    Q_OBJECT

private slots:
    void weldedCornersKeepTheirValue();
    void asManyPositionsKeepTheirOrder();
    void nothingIsMadeOfNothing();
};

namespace {

/// A plate of squares, each triangle with corners of its own; painted by a formula of the place.
TriangleSoup splitPlate(int squares) {
    TriangleSoup soup;
    const auto add = [&](double x, double y) {
        soup.positions.emplace_back(0.01 * x, 0.01 * y, 0.0);
        return Index(soup.positions.size() - 1);
    };
    for (int y = 0; y < squares; ++y)
        for (int x = 0; x < squares; ++x) {
            soup.triangles.push_back({add(x, y), add(x + 1, y), add(x + 1, y + 1)});
            soup.triangles.push_back({add(x, y), add(x + 1, y + 1), add(x, y + 1)});
        }
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

float painted(const Vec3& p) {
    return float(0.5 + 0.4 * std::sin(80 * p.x()) * std::cos(50 * p.y()));
}

std::shared_ptr<const PaintedValues> paint(const TriangleSoup& soup) {
    std::vector<float> values;
    for (const Vec3& p : soup.positions)
        values.push_back(painted(p));
    return std::make_shared<const PaintedValues>(std::move(values));
}

} // namespace

void TestCarriedPaint::weldedCornersKeepTheirValue() {
    const auto split = std::make_shared<const TriangleSoup>(splitPlate(12));
    const auto welded = weldVertices(split);
    VERIFY_RESULT(welded);
    QCOMPARE_EQ(welded->soup->positions.size(), 13 * 13);
    const auto carried = carriedPaint(paint(*split), *split, *welded->soup);
    QCOMPARE(carried->size(), std::size_t(13 * 13));
    for (std::size_t i = 0; i < carried->size(); ++i)
        COMPARE_NEAR((*carried)[i], double(painted(welded->soup->positions[i])), 1e-6, "");
    // A vertex that moves as far as a repair moves one takes its value along; one in the open has none.
    TriangleSoup moved = *welded->soup;
    const double diagonal = 0.12 * std::sqrt(2);
    for (Vec3& p : moved.positions)
        p += Vec3(1.5e-6, -1e-6, 1e-6) * diagonal;
    moved.positions.emplace_back(0.05, 0.05, 0.03);
    const auto again = carriedPaint(carried, *welded->soup, moved);
    for (std::size_t i = 0; i + 1 < again->size(); ++i)
        COMPARE_NEAR((*again)[i], (*carried)[i], 1e-6, "");
    QCOMPARE(again->all().back(), 0.0F);
}

void TestCarriedPaint::asManyPositionsKeepTheirOrder() {
    const TriangleSoup plate = splitPlate(3);
    TriangleSoup large = plate;
    for (Vec3& p : large.positions)
        p *= 25.4;
    const auto values = paint(plate);
    QCOMPARE(carriedPaint(values, plate, large), values);
}

void TestCarriedPaint::nothingIsMadeOfNothing() {
    const TriangleSoup plate = splitPlate(2), other = splitPlate(3);
    QVERIFY(!carriedPaint(nullptr, plate, other));
    QCOMPARE(carriedPaint(paint(other), plate, other)->size(), other.positions.size()); // of another mesh
    TriangleSoup point;
    point.positions.assign(3, Vec3::Zero());
    const auto flat = std::make_shared<const PaintedValues>(std::vector<float>(3, 1.0F));
    QCOMPARE(carriedPaint(flat, point, other), flat);
}

TACTUM_TEST(TestCarriedPaint)

} // namespace test_carried_paint

#include "test_carried_paint.moc"
