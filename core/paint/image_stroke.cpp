#include "core/paint/image_stroke.h"

#include <cassert>
#include <cmath>

#include "core/base/realtime.h"
#include "core/paint/local_means.h"
#include "core/surface/texture_mapping.h"

namespace tactum {
namespace {

using Eigen::Vector2d;

/// Texels: how far from a place an interpolation reads, and from there to the farthest of those that it
/// reads.
constexpr double kReads = 3;
constexpr double kMargin = 1.4142135623730951 * kReads;
constexpr int kTile = 32; ///< texels: what is known of changes
/// A triangle that the brush reaches on more texels than this shows the image so often that none can be told.
constexpr double kMaxTexels = 1 << 24;

/// The texels of a triangle that a ball reaches, and what is read all around.
TexelBox reached(const TriangleSoup& soup, Index index, const TexelTriangle& on, const TexelMap& map,
                 const Vec3& centre, double radius) {
    const auto& t = soup.triangles[index];
    const Triangle triangle{soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
    CornerUvs uvs;
    for (std::size_t k = 0; k < 3; ++k)
        uvs[k] = soup.cornerUvs[3 * std::size_t(index) + k].cast<double>();
    const Eigen::Matrix<double, 2, 3> perMetre = map.perUv * uvGradientOf(triangle, uvs);
    const auto& [a, b, c] = on.corners();
    const Vector2d middle = a + perMetre * (centre - triangle.a), reach = radius * perMetre.rowwise().norm();
    const Vector2d least = a.cwiseMin(b).cwiseMin(c).cwiseMax(middle - reach),
                   most = a.cwiseMax(b).cwiseMax(c).cwiseMin(middle + reach);
    return TexelBox::around(least.array() - kMargin, most.array() + kMargin);
}

} // namespace

ImageStroke::ImageStroke(std::shared_ptr<const SoupReach> reach, PaintableSurfaces surfaces,
                         std::shared_ptr<const TexelCover> cover, std::shared_ptr<const TextureImage> before,
                         const Brush& brush)
    : reach_(std::move(reach)), surfaces_(std::move(surfaces)), cover_(std::move(cover)),
      before_(std::move(before)), image_(before_), brush_(madeSafe(brush)), path_(brush_.radius) {
    assertNotRealtime();
    const TexelMap& map = cover_->map();
    assert(map.width == before_->width() && map.height == before_->height());
    const std::uint16_t* first = before_->row(0);
    now_.assign(first, first + map.texels());
    mask_.resize(map.texels(), 0);
    slotOf_.resize(map.texels(), 0);
    tilesAcross_ = (map.width + kTile - 1) / kTile;
    changed_.resize(std::size_t(tilesAcross_) * std::size_t((map.height + kTile - 1) / kTile), 0);
}

void ImageStroke::moveTo(const Dab& at) {
    path_.moveTo(at, [&](const Dab& dab) { paint(dab); });
}

void ImageStroke::gather(const Dab& dab, double radius) {
    touched_.clear();
    if (reach_->soup().cornerUvs.empty()) return;
    reach_->paintable(dab, radius, surfaces_, [&](Index triangle) { gather(triangle, dab.centre, radius); });
}

void ImageStroke::gather(Index triangle, const Vec3& centre, double radius) {
    const TriangleSoup& soup = reach_->soup();
    const TexelMap& map = cover_->map();
    const TexelTriangle on(soup, triangle, map);
    if (!on.hasArea()) return;
    const TexelBox box = reached(soup, triangle, on, map, centre, radius);
    if (box.area() > kMaxTexels) return;
    const auto& corners = soup.triangles[triangle];
    for (int y = box.low.y(); y < box.high.y(); ++y)
        for (int x = box.low.x(); x < box.high.x(); ++x) {
            const std::size_t texel = map.wrapped(x, y);
            Vec3 weights = on.weightsAt({x + 0.5, y + 0.5});
            if (!TexelTriangle::isInside(weights)) {
                if (cover_->isCovered(texel)) continue;
                const auto [nearest, apart] = on.nearestTo({x + 0.5, y + 0.5});
                if (apart > kMargin) continue;
                weights = nearest;
            }
            const Vec3 place = weights[0] * soup.positions[corners[0]] +
                               weights[1] * soup.positions[corners[1]] +
                               weights[2] * soup.positions[corners[2]];
            const double distance = (place - centre).norm();
            if (distance <= radius) touch(texel, place, distance);
        }
}

/// Of several places that a texel shows the nearest one counts.
void ImageStroke::touch(std::size_t texel, const Vec3& place, double distance) {
    const std::size_t slot = slotOf_[texel];
    if (slot < touched_.size() && touched_[slot].texel == texel) {
        if (distance < touched_[slot].distance) touched_[slot] = {texel, place, distance};
        return;
    }
    slotOf_[texel] = std::uint32_t(touched_.size());
    touched_.push_back({texel, place, distance});
}

void ImageStroke::set(std::size_t texel, double value) {
    const auto now = std::uint16_t(std::lround(65535 * value));
    if (now == now_[texel]) return;
    now_[texel] = now;
    const std::size_t width = std::size_t(cover_->map().width), x = texel % width, y = texel / width;
    changed_[y / kTile * std::size_t(tilesAcross_) + x / kTile] = 1;
}

void ImageStroke::paint(const Dab& dab) {
    assertNotRealtime();
    if (brush_.mode == BrushMode::Smooth) return smooth(dab);
    gather(dab, brush_.radius);
    const std::uint16_t* before = before_->row(0);
    for (const Touched& each : touched_) {
        const float weight = float(falloffAt(each.distance / brush_.radius, brush_.falloff));
        if (weight <= mask_[each.texel]) continue;
        mask_[each.texel] = weight;
        set(each.texel, painted(brush_, before[each.texel] / 65535.0, double(weight)));
    }
}

void ImageStroke::smooth(const Dab& dab) {
    gather(dab, LocalMeans::kReach * brush_.radius);
    LocalMeans means(dab.centre, brush_.radius);
    for (const Touched& each : touched_)
        means.add(each.place, now_[each.texel] / 65535.0);
    for (const Touched& each : touched_) {
        const double weight = falloffAt(each.distance / brush_.radius, brush_.falloff);
        if (weight > 0)
            set(each.texel, painted(brush_, now_[each.texel] / 65535.0, weight, means.at(each.place)));
    }
}

std::shared_ptr<const TextureImage> ImageStroke::image() {
    const TexelMap& map = cover_->map();
    std::vector<TextureImage::Region> regions;
    for (std::size_t i = 0; i < changed_.size(); ++i) {
        if (!std::exchange(changed_[i], 0)) continue;
        const int x = int(i) % tilesAcross_ * kTile, y = int(i) / tilesAcross_ * kTile;
        regions.push_back({x, y, std::min(kTile, map.width - x), std::min(kTile, map.height - y)});
    }
    if (!regions.empty()) image_ = image_->withRegions(regions, now_);
    return image_;
}

} // namespace tactum
