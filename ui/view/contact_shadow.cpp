#include "ui/view/contact_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactum {

namespace {

constexpr int kTexels = 256;
constexpr double kMargin = 0.3;  ///< of the casters' extent, on each side
constexpr double kBelow = 0.004; ///< of their diagonal: what lies flat on the ground is not cut by it
constexpr double kDarkest = 0.72;
/// Of the extent: where a shadow has half its strength, and how much softer it gets with the height.
constexpr double kFades = 0.12, kSoftens = 0.35;
/// Radii of the slices, in texels; the last is as soft as it gets.
constexpr std::array<double, 6> kRadii{1, 2, 4, 8, 16, 32};

using Picture = std::vector<float>;
constexpr float kNothing = 1e9F; ///< the height where nothing is above the ground

/// The height over the ground of the lowest triangle at each texel, m.
class LowestPicture {
public:
    explicit LowestPicture(const GroundShadow& ground)
        : ground_(ground), lowest_(std::size_t(kTexels) * kTexels, kNothing) {}

    void add(const std::array<Vec3, 3>& corners) {
        std::array<Vec3, 3> p; // x and y in texels, z the height
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 from = (corners[k] - ground_.corner) * (kTexels / ground_.side);
            p[k] = {from.x(), from.z(), corners[k].y() - ground_.corner.y()};
            put(int(p[k].x()), int(p[k].y()), p[k].z()); // also what is smaller than a texel
        }
        fill(p);
    }
    const Picture& heights() const { return lowest_; }

private:
    void put(int x, int y, double height) {
        if (x < 0 || y < 0 || x >= kTexels || y >= kTexels) return;
        float& there = lowest_[std::size_t(y) * kTexels + std::size_t(x)];
        there = std::min(there, float(height));
    }

    void fill(const std::array<Vec3, 3>& p) {
        const Vec3 a = p[1] - p[0], b = p[2] - p[0];
        const double area = a.x() * b.y() - a.y() * b.x();
        if (std::abs(area) < 1e-9) return;
        const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
        const auto [front, back] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
        for (int y = int(front); y <= std::min(int(back), kTexels - 1); ++y)
            for (int x = int(left); x <= std::min(int(right), kTexels - 1); ++x) {
                const double u = x + 0.5 - p[0].x(), v = y + 0.5 - p[0].y();
                const double s = (u * b.y() - v * b.x()) / area, t = (a.x() * v - a.y() * u) / area;
                if (s >= 0 && t >= 0 && s + t <= 1) put(x, y, p[0].z() + s * a.z() + t * b.z());
            }
    }

    const GroundShadow& ground_;
    Picture lowest_;
};

/// The mean of a window of 2 r + 1 texels along each row, and turned: twice is along both directions.
Picture blurredAndTurned(const Picture& from, int r) {
    Picture to(from.size());
    for (int y = 0; y < kTexels; ++y) {
        const float* row = &from[std::size_t(y) * kTexels];
        float sum = 0;
        for (int x = -r; x < kTexels; ++x) {
            if (x + r < kTexels) sum += row[x + r];
            if (x - r - 1 >= 0) sum -= row[x - r - 1];
            if (x >= 0) to[std::size_t(x) * kTexels + std::size_t(y)] = sum / float(2 * r + 1);
        }
    }
    return to;
}

Picture blurred(Picture picture, double radius) {
    const int r = std::max(0, int(std::lround(radius / std::sqrt(2.0))));
    for (int i = 0; i < 4; ++i) // a window twice along each direction: a tent
        picture = blurredAndTurned(picture, r);
    return picture;
}

/// Each texel belongs to the two slices between whose radii it is.
float shareOf(double radius, std::size_t slice) {
    const double place = std::clamp(std::log2(std::max(radius, 1.0)), 0.0, double(kRadii.size() - 1));
    return float(std::max(0.0, 1 - std::abs(place - double(slice))));
}

std::vector<std::uint8_t> darknessOf(const Picture& lowest, double side) {
    const double extent = side / (1 + 2 * kMargin), texel = side / kTexels;
    Picture all(lowest.size());
    for (std::size_t slice = 0; slice < kRadii.size(); ++slice) {
        Picture part(lowest.size());
        for (std::size_t i = 0; i < part.size(); ++i) {
            if (lowest[i] == kNothing) continue;
            const double height = std::max(0.0, double(lowest[i])), far = height / (kFades * extent);
            part[i] =
                shareOf(kRadii[0] + kSoftens * height / texel, slice) * float(kDarkest / (1 + far * far));
        }
        part = blurred(std::move(part), kRadii[slice]);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] += part[i];
    }
    std::vector<std::uint8_t> dark(all.size());
    std::ranges::transform(all, dark.begin(), [](float d) {
        return std::uint8_t(std::lround(255 * std::clamp(double(d), 0.0, kDarkest)));
    });
    return dark;
}

} // namespace

std::optional<GroundShadow> shadowOf(std::span<const ShadowCaster> casters, bool standing,
                                     const Progress& progress) {
    GroundShadow made;
    // The ground stays where it is for all that is cut away.
    const auto addToBox = [&](const std::array<Vec3, 3>& corners, const auto&) {
        for (const Vec3& corner : corners)
            made.casters.add(corner);
    };
    if (!forEachTriangle(casters, progress, addToBox)) return std::nullopt;
    if (made.casters.empty()) return made;
    const Vec3 size = made.casters.high - made.casters.low, centre = made.casters.centre();
    made.side = (1 + 2 * kMargin) * std::max({size.x(), size.z(), 1e-9});
    made.corner = {centre.x() - 0.5 * made.side, made.casters.low.y() - kBelow * size.norm(),
                   centre.z() - 0.5 * made.side};
    LowestPicture picture(made);
    std::vector<ShadowCaster> chosen(casters.begin(), casters.end());
    if (standing) std::erase_if(chosen, [](const ShadowCaster& caster) { return caster.moves; });
    const auto draw = [&](const auto& corners, const auto& section) {
        const std::vector<Vec3> kept = keptOf(corners, section);
        for (std::size_t i = 2; i < kept.size(); ++i)
            picture.add({kept[0], kept[i - 1], kept[i]});
    };
    if (!forEachTriangle(chosen, progress, draw)) return std::nullopt;
    made.texels = kTexels;
    made.dark = darknessOf(picture.heights(), made.side);
    return made;
}

} // namespace tactum
