#include "core/paint/vertex_stroke.h"

#include "core/base/realtime.h"
#include "core/paint/local_means.h"

namespace tactum {

VertexStroke::VertexStroke(std::shared_ptr<const SoupReach> reach, PaintableSurfaces surfaces,
                           std::shared_ptr<const PaintedValues> before, const Brush& brush)
    : reach_(std::move(reach)), surfaces_(std::move(surfaces)), brush_(madeSafe(brush)),
      path_(brush_.radius) {
    assertNotRealtime();
    const std::size_t count = reach_->soup().positions.size();
    if (before && before->size() == count) before_ = before->all();
    before_.resize(count, 0);
    now_ = before_;
    mask_.resize(count, 0);
    dabOf_.resize(count, 0);
}

void VertexStroke::moveTo(const Dab& at) {
    path_.moveTo(at, [&](const Dab& dab) { paint(dab); });
}

/// The positions within the radius that belong to a paintable triangle, each once.
void VertexStroke::gather(const Dab& dab, double radius) {
    touched_.clear();
    ++dab_;
    const TriangleSoup& soup = reach_->soup();
    reach_->paintable(dab, radius, surfaces_, [&](Index triangle) {
        for (const Index corner : soup.triangles[triangle]) {
            if (dabOf_[corner] == dab_) continue;
            const double distance = (soup.positions[corner] - dab.centre).norm();
            if (!(distance <= radius)) continue;
            dabOf_[corner] = dab_;
            touched_.push_back({corner, distance});
        }
    });
}

void VertexStroke::paint(const Dab& dab) {
    assertNotRealtime();
    if (brush_.mode == BrushMode::Smooth) return smooth(dab);
    gather(dab, brush_.radius);
    for (const auto& [position, distance] : touched_) {
        const float weight = float(falloffAt(distance / brush_.radius, brush_.falloff));
        if (weight <= mask_[position]) continue;
        mask_[position] = weight;
        now_[position] = float(painted(brush_, double(before_[position]), double(weight)));
    }
}

void VertexStroke::smooth(const Dab& dab) {
    const auto& positions = reach_->soup().positions;
    gather(dab, LocalMeans::kReach * brush_.radius);
    LocalMeans means(dab.centre, brush_.radius);
    for (const Touched& each : touched_)
        means.add(positions[each.position], double(now_[each.position]));
    for (const auto& [position, distance] : touched_) {
        const double weight = falloffAt(distance / brush_.radius, brush_.falloff);
        if (weight > 0)
            now_[position] =
                float(painted(brush_, double(now_[position]), weight, means.at(positions[position])));
    }
}

} // namespace tactum
