// Where a felt surface is stroked exactly along the edges and over the corners of its mesh, contacts take
// over from each other: every tick pushes with the surface's own material, and the servo gets what pushes.
//
// The judge is the spring of section 5 (19), f = k (proxy - finger), with the k that the scene gives: of the
// program only where the proxy is. It would be wrong where the reported proxy were not the one that pushes.

#include <QTest>

#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_felt_edges {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3; // m

/// A surface whose feel is nothing that a default could be.
Surface feltSurface(double stiffness, double friction, bool shaded) {
    Surface surface;
    surface.material = rough(1.25 * friction, friction);
    surface.material.stiffness = stiffness;
    surface.material.damping = 0;
    if (shaded)
        surface.shading.on = true;
    else
        surface.layers = {heightLayer(TextureSource::Grooves, TextureMapping::Planar, 1e-2, 1e-3)};
    return surface;
}

std::shared_ptr<const World> worldWith(Soup soup, Surface surface) {
    Scene scene = sceneOf(std::move(soup), surface.material, kRadius);
    scene.objects[0].surfaces = {std::move(surface)};
    return compile(scene).value();
}

/// A mesh, and a way over it that follows its edges, m: where the proxy's foot would be.
struct Way {
    Soup soup;
    double depth, speed; ///< m, m/s
    std::vector<Vec3> along;
};

// From corner to corner of all quads, and along a row of them.
std::vector<Vec3> overQuads() {
    constexpr double kFar = 0.04;
    return {{-kFar, -kFar, 0}, {kFar, kFar, 0},  {kFar, 0, 0},
            {-kFar, 0, 0},     {-kFar, kFar, 0}, {kFar, -kFar, 0}};
}

// From vertex to vertex.
Way overTheBall() {
    Way way{ball(0.03, 4), 1e-2, 0.05, {}};
    const TriangleSoup& soup = *way.soup;
    for (std::size_t i = soup.triangles.size() / 2; way.along.size() < 60; ++i)
        for (Index corner : soup.triangles[i])
            way.along.push_back(soup.positions[corner]);
    return way;
}

// Out is up from what lies flat, and away from the middle of the ball.
Vec3 above(const Vec3& foot, double height) {
    return foot + height * (foot.z() == 0 ? Vec3(Vec3::UnitZ()) : Vec3(foot.normalized()));
}

} // namespace

class FeltEdgesTest : public QObject {
    Q_OBJECT

private slots:
    void everyTickPushesWithItsMaterial_data();
    void everyTickPushesWithItsMaterial();
};

void FeltEdgesTest::everyTickPushesWithItsMaterial_data() {
    QTest::addColumn<Way>("way");
    QTest::addColumn<double>("stiffness");
    QTest::addColumn<double>("friction");
    QTest::addColumn<bool>("shaded");
    const std::pair<const char*, Way> ways[] = {
        {"plate", {sheet(0.05), 2e-3, 0.2, overQuads()}},
        {"grid", {sheet(0.05, 10), 2e-3, 0.2, overQuads()}},
        {"egg crate", {eggCrate(0.05, 40, 1e-3, 0.03), 2e-3, 0.05, overQuads()}},
        {"ball", overTheBall()}};
    for (const auto& [name, way] : ways)
        for (const double stiffness : {100.0, 3000.0})
            for (const double friction : {0.0, 0.4})
                for (const bool shaded : {false, true})
                    QTest::addRow("%s, %g N/m, mu %g%s", name, stiffness, friction, shaded ? ", shaded" : "")
                        << way << stiffness << friction << shaded;
}

void FeltEdgesTest::everyTickPushesWithItsMaterial() {
    QFETCH(Way, way);
    QFETCH(double, stiffness);
    QFETCH(double, friction);
    QFETCH(bool, shaded);
    Hand hand(worldWith(way.soup, feltSurface(stiffness, friction, shaded)));
    double off = 0, unserved = 0, unlike = 0;
    int pushes = 0;
    hand.to(above(way.along[0], 4e-3));
    hand.go(above(way.along[0], kRadius - way.depth), 0.05);
    for (const Vec3& foot : way.along)
        hand.go(above(foot, kRadius - way.depth), way.speed, [&](const Hand& h) {
            const HapticOutput& out = h.output();
            const Vec3 right = stiffness * (out.proxy - h.finger());
            off = std::max(off, (out.force - right).norm());
            if (out.contacts == 0) return;
            ++pushes;
            const Vec3 served = contactModelForce(h.state.model, h.finger(), Vec3::Zero());
            unserved = std::max(unserved, (served - right).norm() / right.norm());
            for (int i = 0; i < out.contacts; ++i)
                unlike = std::max(unlike, std::abs(out.contact[i].dynamicFriction - friction));
        });
    qInfo("%d pushes, %g N off, %g of the force off in the servo, %g of the friction", pushes, off, unserved,
          unlike);
    QCOMPARE_GE(pushes, 1000);
    QCOMPARE_LT(off, 1e-9);
    QCOMPARE_LT(unlike, 1e-12);
    // In a fold the servo does not know yet what the step ended at.
    QCOMPARE_LT(unserved, 0.2);
}

TACTUM_TEST(FeltEdgesTest)

} // namespace test_felt_edges

#include "test_felt_edges.moc"
