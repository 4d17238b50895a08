// The proof that sampling a texture neither allocates nor locks: no hit of the interposer.
#include <QTest>

#include "core/base/realtime.h"
#include "core/surface/texture_feel.h"
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_texture_realtime {

using namespace tactum;
using namespace tactum::test;

namespace {

std::shared_ptr<const TextureImage> grain(Rng& rng) {
    std::vector<std::uint16_t> texels(300 * 200);
    for (std::uint16_t& texel : texels)
        texel = std::uint16_t(rng());
    return std::make_shared<const TextureImage>(300, 200, std::move(texels));
}

Soup triangleWithUvs() {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    soup->triangles = {{0, 1, 2}};
    soup->surfaceOf = {0};
    soup->cornerUvs = {{0, 0}, {1, 0}, {0, 1}};
    return soup;
}

/// Every source in every mapping, for every target, with and without a mask.
std::vector<std::shared_ptr<const TextureStack>> everyStack(Rng& rng) {
    std::vector<std::shared_ptr<const TextureStack>> stacks;
    const auto image = grain(rng);
    const Soup soup = triangleWithUvs();
    for (std::size_t mapping = 0; mapping < kTextureMappings.size(); ++mapping) {
        std::vector<TextureLayer> layers;
        for (std::size_t i = 0; i < 10; ++i) {
            TextureLayer layer;
            layer.pattern.source = TextureSource(i % kTextureSources.size());
            layer.pattern.image = image;
            layer.pattern.painted.values =
                std::make_shared<const PaintedValues>(std::vector{0.1F, 0.9F, 0.4F});
            layer.pattern.mapping = TextureMapping(mapping);
            layer.target = TextureTarget(i / 2);
            layer.blend = TextureBlend(i % kTextureBlends.size());
            if (i % 2 == 1) layer.mask = layer.pattern;
            layer.ownPlane = i == 0;
            layers.push_back(layer);
        }
        stacks.push_back(compileTextures(layers, soup, 0));
    }
    return stacks;
}

} // namespace

class TestTextureRealtime : public QObject {
    Q_OBJECT

private slots:
    void aMillionPatterns() {
        Rng rng(1);
        const auto stacks = everyStack(rng);
        const Triangle triangle{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
        const CornerUvs uvs{Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)};
        double sum = 0;
        int felt = 0;
        interposer::reset();
        for (int i = 0; i < 60'000; ++i) {
            TexturePoint point;
            point.position = inBox(rng, 0.1);
            point.normal = direction(rng);
            const RealtimeScope scope;
            point.uv = point.position.head<2>() / 0.1;
            point.uvGradient = uvGradientOf(triangle, uvs);
            const TextureFeel texture = feel(*stacks[std::size_t(i) % stacks.size()], point, 1e-4 * (i % 40));
            const Material material = modulated(Material{}, texture);
            sum += material.stiffness + bumpedNormal(point.normal, texture.slope).sum();
            felt += texture.slope.norm() > 0 && texture.ownPlanes == 1;
        }
        QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
        QVERIFY(std::isfinite(sum));
        QCOMPARE_GT(felt, 30'000);
    }
};

TACTUM_TEST(TestTextureRealtime)

} // namespace test_texture_realtime

#include "test_texture_realtime.moc"
