// The relief that is drawn is the one that is felt: what the shader computes at each pixel, read back from a
// picture, against feel() at the same place of the surface.
#include <algorithm>
#include <numbers>

#include <QTest>

#include <vtkCamera.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include "core/surface/image_sample.h"
#include "core/surface/texture_feel.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/view/offscreen_window.h"
#include "ui/view/poly_arrays.h"
#include "ui/view/relief_shader.h"
#include "ui/view/studio_light.h"

namespace test_relief {

using namespace tactum;

namespace {

constexpr double kHalf = 0.01; ///< m, of the sheet's side
constexpr int kPixels = 200;
constexpr double kSteepest = 1.0; ///< that the picture can tell, in both directions

/// A square sheet of a body, anywhere and leaning, with texture coordinates that are turned against it.
struct Sheet {
    Vec3 centre{0.021, -0.013, 0.034};
    Mat3 axes = (Eigen::AngleAxisd(0.5, Vec3::UnitX()) * Eigen::AngleAxisd(-0.35, Vec3::UnitY()))
                    .toRotationMatrix(); ///< columns: along the picture, up the picture, towards the eye

    Vec3 at(double x, double y) const { return centre + axes * Vec3(x, y, 0); }
    static Eigen::Vector2f uvAt(double x, double y) {
        return {float(30 * x + 11 * y + 0.2), float(-11 * x + 30 * y + 0.4)};
    }
    static constexpr int kCells = 10; ///< along each side
    static double alongAt(Index i) { return 2 * kHalf * double(i) / kCells - kHalf; }

    std::shared_ptr<const TriangleSoup> soup() const {
        auto soup = std::make_shared<TriangleSoup>();
        constexpr Index kRow = kCells + 1;
        for (Index i = 0; i < kRow * kRow; ++i)
            soup->positions.push_back(at(alongAt(i % kRow), alongAt(i / kRow)));
        for (Index y = 0; y < kCells; ++y)
            for (Index x = 0; x < kCells; ++x) {
                const Index low = y * kRow + x, high = low + kRow;
                soup->triangles.push_back({low, low + 1, high + 1});
                soup->triangles.push_back({low, high + 1, high});
            }
        soup->surfaceOf.assign(soup->triangles.size(), 0);
        for (const auto& t : soup->triangles)
            for (const Index corner : t)
                soup->cornerUvs.push_back(uvAt(alongAt(corner % kRow), alongAt(corner / kRow)));
        return soup;
    }
    TexturePoint point(const TriangleSoup& soup, double x, double y) const {
        TexturePoint point;
        point.position = at(x, y);
        point.normal = axes.col(2);
        point.uv = uvAt(x, y).cast<double>();
        const double across = (x + kHalf) / (2 * kHalf) * kCells, upward = (y + kHalf) / (2 * kHalf) * kCells;
        const int column = std::min(int(across), kCells - 1), row = std::min(int(upward), kCells - 1);
        const double right = across - column, up = upward - row;
        point.triangle = Index(2 * (row * kCells + column) + (up < right ? 0 : 1));
        const auto& t = soup.triangles[point.triangle];
        const Triangle triangle{soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
        CornerUvs uvs;
        for (std::size_t k = 0; k < 3; ++k)
            uvs[k] = soup.cornerUvs[3 * point.triangle + k].cast<double>();
        point.uvGradient = uvGradientOf(triangle, uvs);
        point.weights = up < right ? Vec3(1 - right, right - up, up) : Vec3(1 - up, right, up - right);
        return point;
    }
};

/// What the shader found at each pixel of a sheet: R the height between the relief's bounds, G and B the
/// slope along the picture and up it.
QImage drawn(const Sheet& sheet, const std::shared_ptr<const TriangleSoup>& soup,
             const std::shared_ptr<const Relief>& relief) {
    OffscreenWindow offscreen;
    if (!offscreen.isValid()) qFatal("no OpenGL");
    vtkNew<vtkRenderer> renderer;
    offscreen.window().AddRenderer(renderer);
    vtkNew<vtkPolyData> shared;
    vtkNew<vtkPoints> points;
    std::vector<float> positions, normals;
    std::vector<int> corners;
    for (const Vec3& p : soup->positions)
        for (int k = 0; k < 3; ++k) {
            positions.push_back(float(p[k]));
            normals.push_back(float(sheet.axes(k, 2)));
        }
    for (const auto& t : soup->triangles)
        corners.insert(corners.end(), {int(t[0]), int(t[1]), int(t[2])});
    points->SetData(vectorArray(positions));
    shared->SetPoints(points);
    shared->GetPointData()->SetNormals(vectorArray(normals));
    shared->SetPolys(cellArray(corners, 3));
    const auto mesh = corneredMesh(*shared);
    giveCorners(*mesh, 0, *relief);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    useStudioLight(*actor);
    ReliefTiles tiles;
    ReliefShader shader;
    shader.wear(*actor, *mapper, relief, tiles);
    const std::string light = "//VTK::Light::Impl";
    vtkShaderProperty& shaders = *actor->GetShaderProperty();
    std::string name, text;
    bool first = false, all = false;
    for (int i = 0; i < shaders.GetNumberOfShaderReplacements(); ++i) {
        std::string replacement;
        shaders.GetNthShaderReplacement(i, name, first, replacement, all);
        if (name == light) text = replacement;
    }
    const auto vector = [](const Vec3& v) {
        return "vec3(" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) +
               ")";
    };
    text += "gl_FragData[0] = vec4((felt.w - feltRange.x) / (feltRange.y - feltRange.x), 0.5 + 0.5 * "
            "dot(felt.xyz, " +
            vector(sheet.axes.col(0)) + "), 0.5 + 0.5 * dot(felt.xyz, " + vector(sheet.axes.col(1)) +
            "), 1.0);";
    shaders.AddFragmentShaderReplacement(light, true, text, false);
    renderer->AddActor(actor);
    vtkCamera& camera = *renderer->GetActiveCamera();
    camera.ParallelProjectionOn();
    camera.SetParallelScale(kHalf);
    const Vec3 eye = sheet.centre + 0.1 * sheet.axes.col(2);
    const Vec3 up = sheet.axes.col(1);
    camera.SetFocalPoint(sheet.centre.data());
    camera.SetPosition(eye.data());
    camera.SetViewUp(up.data());
    camera.SetClippingRange(0.05, 0.2);
    const QImage picture = offscreen.render({kPixels, kPixels}).copy();
    offscreen.window().RemoveRenderer(renderer);
    return picture;
}

/// How far picture and touch are apart over the sheet: in parts of the heights' range, and as a slope.
struct Apart {
    double height = 0, slope = 0;    ///< root of the mean square
    double range = 0, steepness = 0; ///< of what is felt
};

Apart compare(const std::vector<TextureLayer>& layers, double smallestFeature) {
    const Sheet sheet;
    const auto soup = sheet.soup();
    const auto stack = compileTextures(layers, soup, 0);
    if (!stack) qFatal("no stack");
    auto relief = std::make_shared<Relief>(*reliefOf(stack, smallestFeature));
    const double margin = 0.25 * (relief->high - relief->low); // the probes need not have met the ends
    relief->low -= margin, relief->high += margin;
    const QImage picture = drawn(sheet, soup, relief);
    Apart apart;
    int count = 0;
    const TextureStack eye = asOneHeight(*stack);
    for (int row = 2; row < kPixels - 2; ++row)
        for (int column = 2; column < kPixels - 2; ++column) {
            if (std::abs(column + row - kPixels + 1) < 3) continue; // where two triangles meet
            const double x = kHalf * (2 * (column + 0.5) / kPixels - 1),
                         y = kHalf * (1 - 2 * (row + 0.5) / kPixels);
            const TextureFeel felt = feel(eye, sheet.point(*soup, x, y), smallestFeature);
            const QColor seen = picture.pixelColor(column, row);
            const double height = (felt.height - relief->low) / (relief->high - relief->low);
            const Eigen::Vector2d slope = (sheet.axes.transpose() * felt.slope).head<2>(),
                                  seenSlope(2 * seen.greenF() - 1, 2 * seen.blueF() - 1);
            apart.height += std::pow(seen.redF() - height, 2);
            apart.slope += (seenSlope - slope).squaredNorm();
            apart.range = std::max(apart.range, std::abs(height - 0.5));
            apart.steepness += slope.squaredNorm();
            ++count;
        }
    apart.height = std::sqrt(apart.height / count);
    apart.slope = std::sqrt(apart.slope / count);
    apart.steepness = std::sqrt(apart.steepness / count);
    return apart;
}

TextureLayer layer(TextureSource source, TextureMapping mapping, double size, double height = 4e-4) {
    TextureLayer layer;
    layer.pattern.source = source;
    layer.pattern.mapping = mapping;
    layer.pattern.size = size;
    layer.pattern.offsetU = 1.3e-3;
    layer.pattern.offsetV = -0.4e-3;
    layer.pattern.rotation = 0.4;
    layer.pattern.radius = 0.04;
    layer.pattern.frame.rotation = Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
    layer.pattern.frame.translation = {0.001, 0.002, -0.003};
    layer.strength = height;
    return layer;
}

/// Waves of 32 and 16 texels, twice as wide as high.
std::shared_ptr<const TextureImage> waves() {
    constexpr int kWide = 128, kHigh = 64;
    std::vector<std::uint16_t> texels;
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x) {
            const double u = 2 * std::numbers::pi * x / 32, v = 2 * std::numbers::pi * y / 16;
            texels.push_back(std::uint16_t(32768 + 15000 * std::sin(u) + 14000 * std::cos(v + std::sin(u))));
        }
    return std::make_shared<const TextureImage>(kWide, kHigh, std::move(texels));
}

TextureLayer pictured(TextureMapping mapping, double size) {
    TextureLayer made = layer(TextureSource::Image, mapping, size);
    made.pattern.image = waves();
    return made;
}

TextureLayer painted(double height) {
    TextureLayer made = layer(TextureSource::Painted, TextureMapping::Planar, 0.01, height);
    std::vector<float> values;
    for (int y = 0; y <= Sheet::kCells; ++y)
        for (int x = 0; x <= Sheet::kCells; ++x)
            values.push_back(float(0.5 + 0.4 * std::sin(0.5 * x + 0.3) * std::cos(0.4 * y)));
    made.pattern.painted.values = std::make_shared<const PaintedValues>(std::move(values));
    return made;
}

TextureLayer blended(TextureLayer made, TextureBlend blend, double opacity) {
    made.blend = blend;
    made.opacity = opacity;
    return made;
}

TextureLayer masked(TextureLayer made, const TextureLayer& mask) {
    made.mask = mask.pattern;
    return made;
}

using Layers = std::vector<TextureLayer>;

} // namespace

class TestRelief : public QObject {
    Q_OBJECT
private slots:
    void whatIsDrawnIsFelt_data() {
        using enum TextureSource;
        using enum TextureMapping;
        using enum TextureBlend;
        QTest::addColumn<Layers>("layers");
        QTest::addColumn<double>("smallestFeature");
        const TextureLayer ground = layer(Noise, Triplanar, 0.008, 6e-4);
        QTest::newRow("picture, planar") << Layers{pictured(Planar, 0.016)} << 0.0;
        QTest::newRow("picture, uv") << Layers{pictured(Uv, 0.016)} << 0.0;
        QTest::newRow("picture, unit square") << Layers{pictured(UvUnit, 0.7)} << 0.0;
        QTest::newRow("picture, triplanar") << Layers{pictured(Triplanar, 0.016)} << 0.0;
        QTest::newRow("picture, cylinder") << Layers{pictured(Cylindrical, 0.016)} << 0.0;
        QTest::newRow("picture, sphere") << Layers{pictured(Spherical, 0.016)} << 0.0;
        QTest::newRow("noise") << Layers{ground} << 0.0;
        QTest::newRow("noise, coarse") << Layers{layer(Noise, Triplanar, 0.008, 9e-4)} << 6e-4;
        QTest::newRow("grooves") << Layers{layer(Grooves, Planar, 0.006)} << 0.0;
        QTest::newRow("grooves, coarse") << Layers{layer(Grooves, Uv, 0.006)} << 1e-3;
        QTest::newRow("dots on uvs") << Layers{layer(Dots, Uv, 0.006)} << 0.0;
        QTest::newRow("weave") << Layers{layer(Weave, Triplanar, 0.008)} << 0.0;
        QTest::newRow("painted") << Layers{painted(2e-3)} << 0.0;
        QTest::newRow("masked") << Layers{masked(ground, layer(Dots, Planar, 0.009))} << 0.0;
        QTest::newRow("masked by paint") << Layers{masked(pictured(Uv, 0.016), painted(1e-3))} << 0.0;
        for (std::size_t i = 0; i < kTextureBlends.size(); ++i)
            QTest::newRow(kTextureBlends[i].key.data())
                << Layers{ground, blended(layer(Weave, Planar, 0.009), TextureBlend(i), 0.7)} << 0.0;
        TextureLayer own = layer(Grooves, Planar, 0.006);
        own.ownPlane = true;
        QTest::newRow("a plane of its own") << Layers{own, ground} << 0.0;
        TextureLayer friction = layer(Dots, Planar, 0.006);
        friction.target = TextureTarget::StaticFriction;
        QTest::newRow("beside friction") << Layers{friction, ground} << 0.0;
    }
    void whatIsDrawnIsFelt() {
        QFETCH(Layers, layers);
        QFETCH(double, smallestFeature);
        const Apart apart = compare(layers, smallestFeature);
        QCOMPARE_GT(apart.range, 0.15); // it has something to say
        QCOMPARE_GT(apart.steepness, 0.03);
        QCOMPARE_LT(apart.height, 0.01);
        // Of paint slopes are drawn linear between the corners of triangles, and felt as a cubic has them.
        const bool isPainted = layers.front().pattern.source == TextureSource::Painted;
        const double part = isPainted ? 0.12 : 0.06;
        QCOMPARE_LT(apart.slope, part * apart.steepness + 0.004); // the picture has 8 bits
    }

    /// A tile has at each texel what the cubics of the touch have there.
    void aTileIsTheFeltPicture() {
        CompiledPattern pattern;
        pattern.source = TextureSource::Image;
        pattern.image = waves();
        const ReliefTile tile = reliefTile(pattern, 0);
        QCOMPARE(tile.width, 128);
        QCOMPARE(tile.height, 64);
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x) {
                FlatPoint point;
                point.at = {(x + 0.5) / tile.width, (y + 0.5) / tile.height};
                const FlatSample felt = sampleImage(*pattern.image, point, 0);
                const float* texel = &tile.texels[3 * std::size_t(y * tile.width + x)];
                const double apart = std::max({std::abs(felt.value - double(texel[0])),
                                               std::abs(felt.slope.x() - double(texel[1])),
                                               std::abs(felt.slope.y() - double(texel[2]))});
                QCOMPARE_LT(apart, 1e-4);
            }
    }

    /// Far away a coarser level is drawn, and at last next to nothing: no pixel flickers.
    void whatIsFinerThanAPixelIsLeftOut() {
        CompiledPattern pattern;
        pattern.source = TextureSource::Image;
        pattern.image = waves();
        pattern.repeatsPerMetre =
            100 * Eigen::Matrix2d::Identity(); // 10 mm wide: 12.8 texels to a millimetre
        QCOMPARE(reliefTile(pattern, 0).width, 128);
        QCOMPARE(reliefTile(pattern, 1e-2 / 128).width, 128);
        QCOMPARE(reliefTile(pattern, 4e-2 / 128).width, 32);
        QCOMPARE(reliefTile(pattern, 1).width, 1);
        pattern.source = TextureSource::Grooves;
        pattern.wave = waveShape(0.5, 0.4);
        const auto spread = [](const ReliefTile& tile) {
            float low = 1, high = 0;
            for (std::size_t i = 0; i < tile.texels.size(); i += 3) {
                low = std::min(low, tile.texels[i]);
                high = std::max(high, tile.texels[i]);
            }
            return double(high - low);
        };
        QCOMPARE_GT(spread(reliefTile(pattern, 0)), 0.97);
        QCOMPARE_LT(spread(reliefTile(pattern, 0.01)), 1e-6);
    }

    void nothingIsDrawnOfWhatHasNoHeight() {
        const auto soup = Sheet().soup();
        TextureLayer friction = layer(TextureSource::Dots, TextureMapping::Planar, 0.006);
        friction.target = TextureTarget::Viscosity;
        QVERIFY(!reliefOf(compileTextures({friction}, soup, 0), 0));
        QVERIFY(!reliefOf(nullptr, 0));
    }

    /// More than the shader has room for: the lowest are drawn.
    void manyLayersAreCutOff() {
        const Layers many(kMaxTextureLayers,
                          layer(TextureSource::Noise, TextureMapping::Planar, 0.006, 1e-4));
        const auto relief = reliefOf(compileTextures(many, Sheet().soup(), 0), 0);
        QCOMPARE(relief->stack->layers.size(), std::size_t(kMostReliefPatterns));
    }
};

TACTUM_GUI_TEST(TestRelief)

} // namespace test_relief

#include "test_relief.moc"
