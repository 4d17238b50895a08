// A flattened picture shows what the layers are felt as: against texels, closed forms and the texture stack.
#include <cmath>

#include <QTest>

#include "core/files/flatten_layers.h"
#include "core/files/uv_canvas.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_flatten_layers {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kSide = 0.08; // m

Soup uvSheet(const Vector2d& low = {0, 0}, const Vector2d& high = {1, 1}) {
    return std::make_shared<const TriangleSoup>(uvSquare(kSide, low, high));
}

SceneObject objectOf(std::vector<TextureLayer> layers, Soup soup = uvSheet()) {
    SceneObject object;
    object.geometry = std::move(soup);
    object.surfaces.resize(1);
    object.surfaces[0].layers = std::move(layers);
    return object;
}

/// The value that the picture has at a texel.
double shown(const FlatPicture& picture, int x, int y) {
    return picture.low + picture.image->texel(picture.image->level(0), x, y) * (picture.high - picture.low);
}

Image randomImage(Rng& rng, int width, int height, int low, int high) {
    std::vector<std::uint16_t> texels(std::size_t(width * height));
    for (auto& texel : texels)
        texel = std::uint16_t(low + int(rng() % std::uint64_t(high - low + 1)));
    texels.front() = std::uint16_t(low), texels.back() = std::uint16_t(high);
    return std::make_shared<const TextureImage>(width, height, std::move(texels), "random");
}

/// The largest distance from a formula of the place in metres, in steps of the picture's own.
template <class Formula> double stepsFrom(const FlatPicture& picture, Formula&& formula) {
    double most = 0;
    for (int y = 0; y < picture.canvas.height; ++y)
        for (int x = 0; x < picture.canvas.width; ++x) {
            const Vector2d metres = kSide * picture.canvas.uvAt(x, y);
            most = std::max(most, std::abs(shown(picture, x, y) - formula(metres)));
        }
    return most * 65535 / (picture.high - picture.low);
}

} // namespace

class TestFlattenLayers : public QObject {
    Q_OBJECT
private slots:
    void anImageComesBackTexelForTexel();
    void anImageThatDoesNotReachTheEndsKeepsItsValues();
    void imagesAreAddedUp();
    void planarGroovesFollowTheirFormula();
    void whatIsPaintedIsShownWhereItLies();
    void cylindersAreUnrolled();
    void ownPlanesAreAddedOnTop();
    void aFactorIsFlattenedAsItIsFelt();
    void coordinatesBeyondTheUnitSquareGetARectangle();
    void overlapsLeaveOutWhatNeedsPlaces();
    void withoutCoordinatesNothingIsShown();
    void aLargePictureIsCappedAndFiltered();
    void cappedGroovesKeepTheirOneRow();
    void theCoverGoesOnForTwoTexels();
    void overlappingTexelsAreCounted();
    void theRectangleIsOfItsSurfaceAlone();
};

void TestFlattenLayers::anImageComesBackTexelForTexel() {
    Rng rng(1);
    for (const auto& [width, height] : {std::pair{1, 2}, {2, 2}, {64, 32}, {33, 71}, {257, 3}}) {
        const Image image = randomImage(rng, width, height, 0, 65535);
        const FlatPicture picture =
            flattenHeight(objectOf({imageLayer(image, TextureMapping::UvUnit, 0.01, 5e-4)}), 0);
        QVERIFY(picture.image);
        QVERIFY(picture.lost.empty());
        QCOMPARE(picture.low, 0.0);
        QCOMPARE(picture.high, 5e-4);
        QCOMPARE(picture.image->width(), width);
        QCOMPARE(picture.image->height(), height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                QCOMPARE(picture.image->row(y)[x], image->row(y)[x]);
    }
}

void TestFlattenLayers::anImageThatDoesNotReachTheEndsKeepsItsValues() {
    Rng rng(2);
    const Image image = randomImage(rng, 40, 24, 12000, 30000);
    const double height = -3e-4; // dents
    const FlatPicture picture =
        flattenHeight(objectOf({imageLayer(image, TextureMapping::UvUnit, 0.01, height)}), 0);
    COMPARE_NEAR(picture.low, height * 30000 / 65535, 1e-12, "m");
    COMPARE_NEAR(picture.high, height * 12000 / 65535, 1e-12, "m");
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x) {
            const double step = (picture.high - picture.low) / 65535;
            QCOMPARE_LE(std::abs(shown(picture, x, y) - height * image->texel(image->level(0), x, y)),
                        0.51 * step);
        }
}

void TestFlattenLayers::imagesAreAddedUp() {
    Rng rng(3);
    const Image a = randomImage(rng, 16, 16, 0, 65535), b = randomImage(rng, 16, 16, 0, 65535);
    TextureLayer second = imageLayer(b, TextureMapping::UvUnit, 0.02, 2e-4);
    second.blend = TextureBlend::Subtract;
    second.opacity = 0.7;
    TextureLayer hidden = imageLayer(b, TextureMapping::UvUnit, 0.02, 9e-3);
    hidden.enabled = false;
    const FlatPicture picture =
        flattenHeight(objectOf({imageLayer(a, TextureMapping::UvUnit, 0.01, 5e-4), second, hidden}), 0);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const double sum = 5e-4 * a->texel(a->level(0), x, y) - 0.7 * 2e-4 * b->texel(b->level(0), x, y);
            QCOMPARE_LE(std::abs(shown(picture, x, y) - sum), 0.51 * (picture.high - picture.low) / 65535);
        }
}

/// A raised cosine: with an edge as wide as the repeat the Fourier series of a groove has one wave that
/// counts.
void TestFlattenLayers::planarGroovesFollowTheirFormula() {
    TextureLayer grooves = heightLayer(TextureSource::Grooves, TextureMapping::Planar, 0.01, 4e-4);
    grooves.pattern.offsetU = 0.0025;
    const FlatPicture picture = flattenHeight(objectOf({grooves}), 0);
    QVERIFY(picture.image);
    QVERIFY(picture.lost.empty());
    const WaveShape wave = waveShape(grooves.pattern.fill, grooves.pattern.softness);
    const double steps = stepsFrom(picture, [&](const Vector2d& p) {
        double value = wave.mean;
        for (int n = 1; n <= wave.harmonics; ++n)
            value += wave.amplitude[std::size_t(n - 1)] *
                     std::cos(2 * std::numbers::pi * n * (p.x() - 0.0025) / 0.01);
        return 4e-4 * value;
    });
    QVERIFY2(steps <= 0.51, qPrintable(QString("%1 steps").arg(steps)));
    QCOMPARE_GE(picture.canvas.width,
                8 * wave.harmonics * 8); // eight repeats, eight texels to the finest wave
}

/// Values of a function that is linear in space; where there are no coordinates nothing is shown, and that is
/// said.
void TestFlattenLayers::whatIsPaintedIsShownWhereItLies() {
    const Soup soup = uvSheet();
    std::vector<float> values;
    for (const Vec3& p : soup->positions)
        values.push_back(float(0.1 + 4 * p.x() + 6 * p.y()));
    TextureLayer layer = heightLayer(TextureSource::Painted, TextureMapping::Triplanar, 0.01, 4e-4);
    layer.pattern.painted.values = std::make_shared<const PaintedValues>(values);
    const FlatPicture picture = flattenHeight(objectOf({layer}), 0);
    QVERIFY(picture.image);
    QVERIFY(picture.lost.empty());
    QCOMPARE_GE(picture.canvas.width, 4);
    const double steps =
        stepsFrom(picture, [](const Vector2d& p) { return 4e-4 * (0.1 + 4 * p.x() + 6 * p.y()); });
    QVERIFY2(steps <= 0.52, qPrintable(QString("%1 steps").arg(steps)));
    auto bare = std::make_shared<TriangleSoup>(*soup);
    bare->cornerUvs.clear();
    const FlatPicture none = flattenHeight(objectOf({layer}, bare), 0);
    QVERIFY(!none.image);
    QCOMPARE(none.lost.size(), std::size_t(1));
}

/// The same sheet seen from the axis of a cylinder far away, and seen in its own coordinates.
void TestFlattenLayers::cylindersAreUnrolled() {
    TextureLayer dots = heightLayer(TextureSource::Dots, TextureMapping::Cylindrical, 0.01, 3e-4);
    dots.pattern.radius = 0.05;
    dots.pattern.frame.translation = {0.04, 0.04, -0.05};
    const SceneObject object = objectOf({dots});
    const FlatPicture picture = flattenHeight(object, 0);
    const Stack stack = stackOf({dots}, object.geometry);
    const double steps = stepsFrom(picture, [&](const Vector2d& p) {
        TexturePoint point;
        point.position = {p.x(), p.y(), 0};
        return feel(*stack, point, 0).height;
    });
    QVERIFY2(steps <= 0.52, qPrintable(QString("%1 steps").arg(steps)));
}

void TestFlattenLayers::ownPlanesAreAddedOnTop() {
    Rng rng(4);
    const Image a = randomImage(rng, 8, 8, 0, 65535), b = randomImage(rng, 8, 8, 0, 65535);
    TextureLayer first = imageLayer(a, TextureMapping::UvUnit, 0.01, 5e-4);
    first.ownPlane = true;
    TextureLayer replacing = imageLayer(b, TextureMapping::UvUnit, 0.01, 2e-4);
    replacing.blend = TextureBlend::Replace;
    const FlatPicture picture = flattenHeight(objectOf({first, replacing}), 0);
    QCOMPARE(picture.lost.size(), std::size_t(1));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const double sum = 5e-4 * a->texel(a->level(0), x, y) + 2e-4 * b->texel(b->level(0), x, y);
            QCOMPARE_LE(std::abs(shown(picture, x, y) - sum), 0.51 * (picture.high - picture.low) / 65535);
        }
}

void TestFlattenLayers::aFactorIsFlattenedAsItIsFelt() {
    Rng rng(5);
    const Image image = randomImage(rng, 16, 8, 0, 65535);
    TextureLayer rough = imageLayer(image, TextureMapping::UvUnit, 0.01, 2);
    rough.target = TextureTarget::StaticFriction;
    SceneObject object = objectOf({rough, imageLayer(image, TextureMapping::UvUnit, 0.01, 5e-4)});
    object.surfaces[0].material.staticFriction = 0.9;
    object.surfaces[0].material.dynamicFriction = 0.4;
    const FlatPicture factor = flattenFactor(object, 0, TextureTarget::StaticFriction);
    QCOMPARE(factor.low, 1.0);
    QCOMPARE(factor.high, 3.0);
    QVERIFY(!flattenFactor(object, 0, TextureTarget::Stiffness).image);
    const FlatPicture felt = flattenFelt(object, 0, &Material::staticFriction);
    QCOMPARE(felt.low, 0.9);
    QCOMPARE(felt.high, kStaticFriction.maximum); // 2.7 is more than the range
    const FlatPicture same = flattenFelt(object, 0, &Material::dynamicFriction);
    QVERIFY(!same.image);
    QCOMPARE(same.mean, 0.4);
}

void TestFlattenLayers::coordinatesBeyondTheUnitSquareGetARectangle() {
    Rng rng(6);
    const Image image = randomImage(rng, 8, 4, 0, 65535);
    const FlatPicture picture =
        flattenHeight(objectOf({imageLayer(image, TextureMapping::UvUnit, 0.01, 5e-4)},
                               uvSheet({-0.5, 0.25}, {1.75, 0.75})),
                      0);
    QCOMPARE(picture.canvas.low, Vector2d(-1, 0));
    QCOMPARE(picture.canvas.size, Vector2d(3, 1));
    QCOMPARE(picture.canvas.width, 24);
    QCOMPARE(picture.canvas.height, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 24; ++x)
            QCOMPARE(picture.image->row(y)[x], image->row(y)[x % 8]);
}

void TestFlattenLayers::overlapsLeaveOutWhatNeedsPlaces() {
    auto folded = std::make_shared<TriangleSoup>(*uvSheet());
    const TriangleSoup above = *folded; // the same coordinates once more, 1 cm higher
    for (const Vec3& p : above.positions)
        folded->positions.push_back(p + Vec3(0, 0, 0.01));
    for (const auto& t : above.triangles)
        folded->triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    folded->surfaceOf.assign(4, 0);
    folded->cornerUvs.insert(folded->cornerUvs.end(), above.cornerUvs.begin(), above.cornerUvs.end());
    const TextureLayer image = imageLayer(ramp(16), TextureMapping::UvUnit, 0.01, 5e-4);
    const TextureLayer planar = heightLayer(TextureSource::Grooves, TextureMapping::Planar, 0.01, 5e-3);
    const FlatPicture picture = flattenHeight(objectOf({image, planar}, folded), 0);
    QCOMPARE(picture.lost.size(), std::size_t(1));
    COMPARE_CONTAINS(picture.lost[0], "overlap");
    QCOMPARE(picture.canvas.width, 16);
    QCOMPARE_LE(picture.high, 5e-4);
    const FlatPicture nothing = flattenHeight(objectOf({planar}, folded), 0);
    QVERIFY(!nothing.image);
    QCOMPARE_EQ(nothing.lost.size(), 1);
    // Neighbours that share an edge do not overlap, and doubled triangles show the same twice.
    auto doubled = std::make_shared<TriangleSoup>(above);
    doubled->triangles.push_back(doubled->triangles[0]);
    doubled->surfaceOf.push_back(0);
    for (std::size_t i = 0; i < 3; ++i)
        doubled->cornerUvs.push_back(above.cornerUvs[i]);
    QVERIFY(flattenHeight(objectOf({planar}, doubled), 0).image);
}

void TestFlattenLayers::withoutCoordinatesNothingIsShown() {
    const FlatPicture picture = flattenHeight(
        objectOf({heightLayer(TextureSource::Noise, TextureMapping::Triplanar, 0.01, 5e-4)}, sheet(0.05)), 0);
    QVERIFY(!picture.image);
    QCOMPARE(picture.high, 0.0);
    QCOMPARE(picture.lost.size(), std::size_t(1));
    QVERIFY(flattenHeight(objectOf({}), 0).lost.empty());
}

void TestFlattenLayers::aLargePictureIsCappedAndFiltered() {
    // 0.1 mm grooves on 80 mm of a strip that is narrow in texels: far too fine for 4096 texels.
    const TextureLayer fine = heightLayer(TextureSource::Grooves, TextureMapping::Uv, 1e-4, 5e-4);
    TextureLayer coarse = heightLayer(TextureSource::Grooves, TextureMapping::Uv, 0.01, 5e-4);
    const FlatPicture picture = flattenHeight(objectOf({fine, coarse}), 0);
    QCOMPARE(picture.canvas.width, kLargestFlatSide);
    QCOMPARE(picture.lost.size(), std::size_t(1));
    COMPARE_CONTAINS(picture.lost[0], "would need");
}

/// Sixteen texels a wave where there is room, far fewer than their harmonics would need.
void TestFlattenLayers::cappedGroovesKeepTheirOneRow() {
    const TextureLayer grooves = heightLayer(TextureSource::Grooves, TextureMapping::Uv, 0.02, 5e-4);
    const FlatPicture whole = flattenHeight(objectOf({grooves}), 0);
    const FlatPicture capped = flattenHeight(objectOf({grooves}), 0, {64, {}});
    QCOMPARE_GT(whole.canvas.width, 64);
    QCOMPARE_EQ(whole.canvas.height, 1);
    QVERIFY(capped.image);
    QCOMPARE_EQ(capped.canvas.width, 64);
    QCOMPARE_EQ(capped.canvas.height, 1);
    QCOMPARE_GT(capped.high - capped.low, 0.8 * (whole.high - whole.low));
}

/// An interpolation at the edge of a surface reads a texel or two beside it: those show one of its triangles,
/// and all that are farther away show nothing.
void TestFlattenLayers::theCoverGoesOnForTwoTexels() {
    Rng rng(7);
    for (int run = 0; run < 20; ++run) {
        TriangleSoup soup;
        for (Index i = 0; i < 3; ++i) { // the last one is another surface's
            soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
            soup.surfaceOf.push_back(i / 2);
            const Vector2d middle(uniform(rng, 0, 1), uniform(rng, 0, 1)); // some reach beyond the canvas
            const double edge = uniform(rng, -0.2, 0.2);
            for (int k = 0; k < 3; ++k) {
                Vector2d uv = middle + Vector2d(uniform(rng, -0.2, 0.2), uniform(rng, -0.2, 0.2));
                if (i == 0 && k < 2) uv.y() = middle.y() + edge; // along a row
                soup.positions.emplace_back(uv.x(), uv.y(), double(i));
                soup.cornerUvs.push_back(uv.cast<float>());
            }
        }
        UvCanvas canvas;
        canvas.width = 41, canvas.height = 27;
        const UvCover cover = coverOf(canvas, soup, 0);
        QCOMPARE(cover.triangleOf.size(), canvas.texels());
        const auto lies = [&](std::size_t triangle, int x, int y) {
            return uvWeights(soup, triangle, canvas.uvAt(x, y)).minCoeff() >= 0;
        };
        for (int y = 0; y < canvas.height; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                int nearest = 1000; // texels, to one that has its centre on the surface
                for (int j = 0; j < canvas.height; ++j)
                    for (int i = 0; i < canvas.width; ++i)
                        if (lies(0, i, j) || lies(1, i, j))
                            nearest = std::min(nearest, std::max(std::abs(i - x), std::abs(j - y)));
                const Index owner = cover.triangleOf[std::size_t(y * canvas.width + x)];
                const bool isShown = owner != UvCover::kNothing;
                QVERIFY2(isShown == (nearest <= 2), qPrintable(QString("run %1, texel %2 %3: %4, %5 away")
                                                                   .arg(run)
                                                                   .arg(x)
                                                                   .arg(y)
                                                                   .arg(isShown ? "shown" : "empty")
                                                                   .arg(nearest)));
                if (isShown) QVERIFY(owner < 2);
                if (nearest == 0) QVERIFY(lies(owner, x, y));
            }
    }
}

/// Two squares that share a part of the canvas, and one without an area on it.
void TestFlattenLayers::overlappingTexelsAreCounted() {
    TriangleSoup soup = uvSquare(kSide, {0, 0}, {0.5, 0.5});
    const auto add = [&](const Vector2d& low, const Vector2d& high, double height) {
        const TriangleSoup more = uvSquare(kSide, low, high);
        for (std::size_t i = 0; i < 2; ++i) {
            const Index first = Index(soup.positions.size());
            for (const Index corner : more.triangles[i])
                soup.positions.push_back(more.positions[corner] + Vec3(0, 0, height));
            soup.triangles.push_back({first, first + 1, first + 2});
            soup.surfaceOf.push_back(0);
            for (std::size_t k = 0; k < 3; ++k)
                soup.cornerUvs.push_back(more.cornerUvs[3 * i + k]);
        }
    };
    UvCanvas canvas;
    canvas.width = canvas.height = 64;
    QCOMPARE(coverOf(canvas, soup, 0).overlaps, std::size_t(0));
    add({0.5, 0}, {1, 0.5}, 0.01); // beside it: the edge is shared
    const UvCover beside = coverOf(canvas, soup, 0);
    QCOMPARE(beside.overlaps, std::size_t(0));
    QCOMPARE(beside.withoutArea, std::size_t(0));
    add({0.25, 0.25}, {0.5, 0.5}, 0.02); // over a quarter of the first
    add({0.75, 0.75}, {0.75, 1}, 0.03);
    soup.triangles.push_back({0, 1, 1}); // a line in space
    soup.surfaceOf.push_back(0);
    for (const Vector2d& uv : {Vector2d(0, 0), Vector2d(0.5, 0), Vector2d(0, 0.5)})
        soup.cornerUvs.push_back(uv.cast<float>());
    const UvCover over = coverOf(canvas, soup, 0);
    QCOMPARE(over.withoutArea, std::size_t(2));
    // 16 x 16 texels, but for those on the diagonals of the squares.
    QVERIFY2(over.overlaps >= 16 * 16 - 2 * 16 && over.overlaps <= 16 * 16,
             qPrintable(QString("%1 texels").arg(over.overlaps)));
}

void TestFlattenLayers::theRectangleIsOfItsSurfaceAlone() {
    TriangleSoup soup = uvSquare(kSide, {0.2, 0.3}, {0.9, 1});
    soup.surfaceOf = {0, 1};
    for (std::size_t corner = 3; corner < 6; ++corner)
        soup.cornerUvs[corner] *= -2;
    const UvCanvas own = uvRectangleOf(soup, 0), other = uvRectangleOf(soup, 1),
                   none = uvRectangleOf(soup, 2);
    for (const UvCanvas& unit : {own, none}) {
        QCOMPARE(unit.low, Vector2d(0, 0));
        QCOMPARE(unit.size, Vector2d(1, 1));
    }
    QCOMPARE(other.low, Vector2d(-2, -2));
    QCOMPARE(other.size, Vector2d(2, 2));
    // Of a line it is as wide as a unit, and along an edge of the square the square itself.
    const auto onLine = [&](float u) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            soup.cornerUvs[corner] = {u, 0.5F};
        return uvRectangleOf(soup, 0);
    };
    QCOMPARE(onLine(2).low, Vector2d(2, 0));
    QCOMPARE(onLine(2).size, Vector2d(1, 1));
    QCOMPARE(onLine(1).low, Vector2d(0, 0));
    QCOMPARE(onLine(1).size, Vector2d(1, 1));
}

TACTUM_TEST(TestFlattenLayers)

} // namespace test_flatten_layers

#include "test_flatten_layers.moc"
