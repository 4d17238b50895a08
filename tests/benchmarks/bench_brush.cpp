// How long a dab of the brush takes on a large mesh: bench-brush [triangles].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "core/paint/image_stroke.h"
#include "core/paint/vertex_stroke.h"
#include "core/surface/texture_mapping.h"

using namespace tactum;

namespace {

template <class Work> double seconds(Work&& work) {
    const std::clock_t begin = std::clock(); // of the processor: others may be at work too
    work();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// A wavy square of 0.2 m whose coordinates fill the unit square.
std::shared_ptr<const TriangleSoup> waves(double triangles) {
    const Index cells = Index(std::max(1.0, std::sqrt(triangles / 2)));
    auto soup = std::make_shared<TriangleSoup>();
    const auto uvOf = [&](Index i) {
        return Eigen::Vector2f(float(i % (cells + 1)) / float(cells), float(i / (cells + 1)) / float(cells));
    };
    for (Index i = 0; i < (cells + 1) * (cells + 1); ++i) {
        const Vec3 at(0.2 * double(uvOf(i).x()), 0.2 * double(uvOf(i).y()), 0);
        soup->positions.push_back(at + Vec3(0, 0, 2e-3 * std::sin(200 * at.x()) * std::sin(200 * at.y())));
    }
    for (Index row = 0; row < cells; ++row)
        for (Index column = 0; column < cells; ++column) {
            const Index a = row * (cells + 1) + column, b = a + 1, c = b + cells + 1, d = a + cells + 1;
            soup->triangles.push_back({a, b, c});
            soup->triangles.push_back({a, c, d});
        }
    soup->surfaceOf.assign(soup->triangles.size(), 0);
    for (const auto& triangle : soup->triangles)
        for (const Index corner : triangle)
            soup->cornerUvs.push_back(uvOf(corner));
    return soup;
}

/// Of 50 dabs at places all over the mesh: the median and the longest, ms.
template <class Paint> void dabs(const char* what, Paint&& paint) {
    std::vector<double> times;
    for (int i = 0; i < 50; ++i) {
        const Dab dab{{0.02 + 0.16 * (i % 7) / 7.0, 0.02 + 0.16 * (i % 11) / 11.0, 0}, Vec3::UnitZ()};
        times.push_back(1e3 * seconds([&] { paint(dab); }));
    }
    std::ranges::sort(times);
    std::printf("%-44s median %6.2f ms, longest %6.2f ms\n", what, times[25], times.back());
}

} // namespace

int main(int argc, char** argv) {
    const auto soup = waves(argc > 1 ? std::atof(argv[1]) : 1e6);
    std::printf("%zu triangles\n", soup->triangles.size());
    std::shared_ptr<const SoupReach> reach;
    std::printf("index   %.2f s\n", seconds([&] { reach = std::make_shared<const SoupReach>(soup); }));
    const auto image =
        std::make_shared<const TextureImage>(1024, 1024, std::vector<std::uint16_t>(1024 * 1024, 0));
    TexelMap map;
    map.width = map.height = 1024;
    map.perUv *= 1024;
    std::shared_ptr<const TexelCover> cover;
    std::printf("texels  %.2f s\n", seconds([&] {
                    cover = std::make_shared<const TexelCover>(*soup, PaintableSurfaces{}, map);
                }));
    for (const double radius : {2e-3, 5e-3, 0.02})
        for (const BrushMode mode : {BrushMode::Add, BrushMode::Smooth}) {
            const Brush brush{radius, 0.5, 1, 1, mode};
            VertexStroke onVertices(reach, {}, nullptr, brush);
            ImageStroke onImage(reach, {}, cover, image, brush);
            const std::string of = std::string(kBrushModes[std::size_t(mode)].label) + ", radius " +
                                   std::to_string(int(1e3 * radius)) + " mm";
            dabs((of + ", vertices").c_str(), [&](const Dab& dab) { onVertices.paint(dab); });
            dabs((of + ", texels and image").c_str(), [&](const Dab& dab) {
                onImage.paint(dab);
                onImage.image();
            });
        }
}
