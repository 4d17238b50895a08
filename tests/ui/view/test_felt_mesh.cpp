#include <QTest>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/felt_mesh.h"
#include "ui/view/felt_normals.h"
#include "ui/view/felt_options.h"
#include "ui/view/scale_bar.h"
#include "ui/view/sphere_mesh.h"

namespace test_felt_mesh {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr double kRepeat = 0.01, kHeight = 5e-4; // m

TextureLayer grooves(TextureTarget target, double strength) {
    TextureLayer layer;
    layer.pattern.source = TextureSource::Grooves;
    layer.pattern.mapping = TextureMapping::Planar;
    layer.pattern.size = kRepeat;
    layer.pattern.softness = 0.5;
    layer.target = target;
    layer.strength = strength;
    return layer;
}

/// A square of 4 cm in the plane z = 0, of 8 triangles.
std::shared_ptr<const World> sheetWorld(std::vector<TextureLayer> layers) {
    SceneObject sheet;
    sheet.geometry = test::sheet(0.02, 2);
    sheet.surfaces.resize(1);
    sheet.surfaces[0].material.staticFriction = 0.4;
    sheet.surfaces[0].layers = std::move(layers);
    Scene scene;
    scene.add(sheet);
    return compile(scene).value();
}

FeltMesh meshOf(const World& world, const FeltMeshWish& wish) {
    return feltMesh(world.bodies[0], 0, drawnNormalsOf(*world.bodies[0].mesh->soup), wish);
}

struct Span {
    float low = 1e9f, high = -1e9f;
    void add(float v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};
Span spanOf(const std::vector<float>& list, std::size_t first, std::size_t step) {
    Span span;
    for (std::size_t i = first; i < list.size(); i += step)
        span.add(list[i]);
    return span;
}

double largestLean(const std::vector<Needle>& needles) {
    double most = 0;
    for (const Needle& n : needles)
        most = std::max(most, n.lean);
    return most;
}

} // namespace

class TestFeltMesh : public QObject {
    Q_OBJECT
private slots:
    void bumpsRiseByTheirHeightTimesTheFactor() {
        const auto world = sheetWorld({grooves(TextureTarget::Height, kHeight)});
        for (const double factor : {1.0, 10.0, 100.0}) {
            const FeltMesh mesh = meshOf(*world, {.value = {}, .bumps = factor});
            const Span z = spanOf(mesh.positions, 2, 3);
            COMPARE_NEAR(z.low, 0, 0.05 * factor * kHeight, "m");
            COMPARE_NEAR(z.high, factor * kHeight, 0.05 * factor * kHeight, "m");
            QCOMPARE_LT(mesh.lost, 0.05);
        }
    }

    // Ridges across x: a vertex is as high as the one a repeat away, and half a repeat away as high as the
    // other half.
    void bumpsAreWhereTheyAreFelt() {
        const auto world = sheetWorld({grooves(TextureTarget::Height, kHeight)});
        const FeltMesh mesh = meshOf(*world, {.value = {}, .bumps = 1});
        const double middle = 0.5 * kHeight;
        int ridges = 0;
        for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
            const double x = double(mesh.positions[i]) / kRepeat, z = double(mesh.positions[i + 2]);
            const double part = x - std::floor(x);
            // By docs/physics the middle of the raised half is at the beginning of a repeat.
            if (part < 0.1 || part > 0.9) {
                QCOMPARE_GT(z, middle);
                ++ridges;
            }
            if (part > 0.4 && part < 0.6) QCOMPARE_LT(z, middle);
        }
        QCOMPARE_GT(ridges, 100);
    }

    void whatIsTooFineIsFlatAndSaid() {
        TextureLayer fine = grooves(TextureTarget::Height, kHeight);
        fine.pattern.size = 0.73 * kRepeat; // no multiple of the triangles
        const auto world = sheetWorld({fine});
        const FeltMesh mesh = meshOf(*world, {.value = {}, .bumps = 100, .mostTriangles = 8});
        QCOMPARE(mesh.triangles.size(), std::size_t(3 * 8));
        const Span z = spanOf(mesh.positions, 2, 3);
        QCOMPARE_LT(z.high - z.low, 1e-6f);
        QCOMPARE_GT(mesh.lost, 0.95);
    }

    void frictionIsSampledWithItsLayers() {
        const auto world = sheetWorld({grooves(TextureTarget::StaticFriction, 0.5)});
        const FeltMesh mesh = meshOf(*world, {.value = FeltValue::StaticFriction});
        QCOMPARE(mesh.values.size(), mesh.positions.size() / 3);
        COMPARE_NEAR(mesh.low, 0.4, 0.01, "");
        COMPARE_NEAR(mesh.high, 0.6, 0.01, "");
        const Span z = spanOf(mesh.positions, 2, 3);
        QCOMPARE_EQ(z.low, 0);
        QCOMPARE_EQ(z.high, 0);
    }

    void theVerticesLieWhereTheCutsAre() {
        const auto world = sheetWorld({grooves(TextureTarget::StaticFriction, 0.5)});
        const FeltMesh mesh = meshOf(*world, {.value = FeltValue::StaticFriction});
        const TriangleSoup& soup = *world->bodies[0].mesh->soup;
        QCOMPARE_GT(mesh.cuts, 1);
        std::size_t at = 0;
        for (const Index face : mesh.faces)
            eachCut(mesh.cuts, [&](const Vec3& weights) {
                Vec3 place = Vec3::Zero();
                for (std::size_t k = 0; k < 3; ++k)
                    place += weights[Eigen::Index(k)] * soup.positions[soup.triangles[face][k]];
                const Vec3 vertex(mesh.positions[at], mesh.positions[at + 1], mesh.positions[at + 2]);
                COMPARE_NEAR(vertex, place, 1e-7, "m");
                at += 3;
            });
        QCOMPARE(at, mesh.positions.size());
    }

    void onlyWhatALayerChangesVaries() {
        const auto world = sheetWorld({grooves(TextureTarget::StaticFriction, 0.5)});
        const WorldBody& body = world->bodies[0];
        QVERIFY(varies(body, 0, {.value = FeltValue::StaticFriction}));
        QVERIFY(varies(body, 0, {.value = FeltValue::DynamicFriction})); // it never exceeds static
        QVERIFY(!varies(body, 0, {.value = FeltValue::Stiffness}));
        QVERIFY(!varies(body, 0, {.value = FeltValue::Height, .bumps = 10}));
        QVERIFY(!varies(sheetWorld({})->bodies[0], 0, {.value = FeltValue::Height}));
    }

    void aCancelledMeshIsEmpty() {
        const auto world = sheetWorld({grooves(TextureTarget::Height, kHeight)});
        const std::atomic<bool> cancelled{true};
        const FeltMesh mesh = feltMesh(world->bodies[0], 0, drawnNormalsOf(*world->bodies[0].mesh->soup),
                                       {.value = {}, .bumps = 1}, Progress{{}, &cancelled});
        QVERIFY(mesh.positions.empty());
        QVERIFY(mesh.triangles.empty());
    }

    void aLevelHasTheSpheresOfTheTree() {
        const auto world = compile(ballScene(96, 64)).value();
        const SphereTree& tree = world->bodies[0].mesh->tree;
        for (int level = 0; level < 6; ++level) {
            const SphereLevel spheres = sphereLevel(*world, level, Vec3::Zero());
            QCOMPARE(spheres.all, tree.spheresAt(level).size());
            QCOMPARE(spheres.drawn, std::min(spheres.all, kMaxSpheres));
        }
        QCOMPARE(sphereLevel(*world, 0, Vec3::Zero()).all, std::size_t(8));
    }

    void ofTooManySpheresTheNearestAreDrawn() {
        const auto world = compile(ballScene(400, 400)).value();
        const SphereLevel spheres = sphereLevel(*world, kDeepestLevel, {0, 0, 2 * kBallRadius});
        QCOMPARE_GT(spheres.all, 2 * kMaxSpheres);
        QCOMPARE_EQ(spheres.drawn, kMaxSpheres);
        for (std::size_t i = 2; i < spheres.meshes[0].positions.size(); i += 3)
            QCOMPARE_GT(spheres.meshes[0].positions[i], -0.5f * float(kBallRadius));
        QCOMPARE_LT(spheres.meshes[0].triangles.size() / 3, 300'000);
    }

    void normalsOfFacetsLeanFromThoseThatAreDrawnSmooth() {
        Scene scene = ballScene(32, 16);
        const auto facets = compile(scene).value();
        const CornerNormals drawn = drawnNormalsOf(*facets->bodies[0].mesh->soup);
        const auto plain = needlesOf(facets->bodies[0], drawn, 100'000);
        QCOMPARE(plain.size(), facets->bodies[0].mesh->soup->triangles.size());
        // From the middle of a facet to its corner: about half of its 11 degrees, along both ways.
        QCOMPARE_GT(largestLean(plain), 0.08);
        QCOMPARE_LT(largestLean(plain), 0.2);
        for (Surface& surface : scene.objects[0].surfaces)
            surface.shading = {true, NormalSource::Computed, kDrawnCreaseForTest};
        const auto shaded = compile(scene).value();
        const auto smooth = needlesOf(shaded->bodies[0], drawn, 100'000);
        QCOMPARE_GT(smooth.size(), 400);
        QCOMPARE_LT(largestLean(smooth), 1e-3);
        for (const Needle& n : smooth)
            QCOMPARE_GT(n.normal.dot(n.at.normalized()), 0.99);
    }

    void whatIsNotFeltHasNoNormals() {
        for (const bool shaded : {false, true}) {
            Scene scene = ballScene(32, 16);
            for (Surface& surface : scene.objects[0].surfaces)
                surface.shading = {shaded, NormalSource::Computed, kDrawnCreaseForTest};
            scene.objects[0].surfaces[kLower].visible = false;
            const auto world = compile(scene).value();
            QVERIFY(!isFelt(world->bodies[0], kLower));
            QVERIFY(isFelt(world->bodies[0], kUpper));
            const auto needles =
                needlesOf(world->bodies[0], drawnNormalsOf(*world->bodies[0].mesh->soup), 100'000);
            QCOMPARE_GT(needles.size(), 200);
            for (const Needle& n : needles)
                QCOMPARE_GT(n.at.y(), -1e-9);
        }
    }

    void ofTooManyNormalsSomeAreShownEvenly() {
        const auto world = compile(ballScene(200, 100)).value();
        const auto needles = needlesOf(world->bodies[0], drawnNormalsOf(*world->bodies[0].mesh->soup), 500);
        QCOMPARE_GT(needles.size(), 450);
        QCOMPARE_LE(needles.size(), 500);
        const auto below = std::ranges::count_if(needles, [](const Needle& n) { return n.at.y() < 0; });
        QCOMPARE_GT(below, 200);
        QCOMPARE_LT(below, 300);
    }

    void scalesBeginAtZeroWhereAllIsTheSame() {
        QVERIFY((rangeOf(0.3, 0.7) == MapRange{0.3, 0.7}));
        QVERIFY((rangeOf(800, 800) == MapRange{0, 800}));
        QVERIFY((rangeOf(0, 0) == MapRange{0, 1}));
        QVERIFY((rangeOf(0, 0, 1e-3) == MapRange{0, 1e-3}));
        COMPARE_NEAR(rangeOf(2, 4).part(3), 0.5, 1e-12, "");
        QCOMPARE(wordsOf(FeltValue::Height).unit, QStringLiteral("mm"));
        QCOMPARE(wordsOf(FeltValue::Stiffness).unit, QStringLiteral("N/m"));
    }

private:
    static constexpr double kDrawnCreaseForTest = 50 * std::numbers::pi / 180;
};

TACTUM_TEST(TestFeltMesh)

} // namespace test_felt_mesh

#include "test_felt_mesh.moc"
