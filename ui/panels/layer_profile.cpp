#include "ui/panels/layer_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/nearest.h"
#include "core/proxy/surface_under.h"
#include "ui/document/layer_picture.h"

namespace tactum {

namespace {

constexpr std::size_t kPlaces = 1200;
constexpr double kProfileReach = 1.2; // radii of the proxy: what rests on the surface is one away from it
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Places in the frame of the body, evenly spaced along the way.
std::vector<Vec3> placesAlong(const std::vector<Vec3>& way, double length) {
    std::vector<Vec3> places;
    double passed = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double step = (way[i] - way[i - 1]).norm();
        while (places.size() < kPlaces) {
            const double wanted = length * double(places.size()) / double(kPlaces - 1);
            if (wanted > passed + step) break;
            const double part = step > 0 ? (wanted - passed) / step : 0;
            places.push_back(way[i - 1] + part * (way[i] - way[i - 1]));
        }
        passed += step;
    }
    while (places.size() < kPlaces) // what rounding left over of the end
        places.push_back(way.back());
    return places;
}

/// A surface of a World with layers that need not be those that the World has.
class Felt {
public:
    Felt(const World& world, std::size_t body, Index surface, const TextureLayers& layers)
        : world_(world), obstacle_(world.obstacles[body]),
          sides_(world.bodies[body].materials.size(), Sides::None),
          stack_(compileTextures(withoutOwnPlanes(layers), obstacle_.mesh->soup, surface,
                                 world.bodies[body].textures)) {
        sides_[surface] = Sides::Both;
    }

    // A body that forces have moved is taken where it began: the stroke does not know where it was.
    Vec3 inBody(const StrokePoint& point) const {
        const Mover* mover = obstacle_.mover < 0 ? nullptr : &world_.movers[std::size_t(obstacle_.mover)];
        const Pose pose = mover && mover->motion ? mover->poseAt(point.time) : obstacle_.pose;
        return pose.applyInverse(point.proxy_W);
    }

    double at(const Vec3& p_B, TextureTarget target) const {
        const Nearest nearest = nearestOn(*obstacle_.mesh, p_B, kProfileReach * world_.proxyRadius, sides_);
        if (!std::isfinite(nearest.distance)) return kNothing;
        if (!stack_) return valueOf({}, target);
        const Triangle triangle = obstacle_.triangle(nearest.triangle);
        const Vec3 facet = (triangle.b - triangle.a).cross(triangle.c - triangle.a).stableNormalized();
        const Vec3 normal = facet.dot(p_B - nearest.point) < 0 ? Vec3(-facet) : facet;
        const TexturePoint point = texturePointOn(*obstacle_.mesh->soup, nearest.triangle, triangle,
                                                  closestPoint(triangle, p_B), normal);
        return valueOf(feel(*stack_, point, 0), target);
    }

private:
    const World& world_;
    const Obstacle& obstacle_;
    std::vector<Sides> sides_; ///< of this surface alone
    std::shared_ptr<const TextureStack> stack_;
};

} // namespace

bool LayerProfile::any() const {
    return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
}

LayerProfile profileAlong(const std::vector<StrokePoint>& stroke, const World& world, SurfaceRef surface,
                          const TextureLayers& layers, TextureTarget target, const Progress& progress) {
    const auto body = std::ranges::find(world.bodies, surface.object, &WorldBody::object);
    if (stroke.size() < 2 || body == world.bodies.end() || surface.surface >= body->materials.size())
        return {};
    const Felt felt(world, std::size_t(body - world.bodies.begin()), surface.surface, layers);
    std::vector<Vec3> way;
    double length = 0;
    for (const StrokePoint& point : stroke) {
        way.push_back(felt.inBody(point));
        if (way.size() > 1) length += (way.back() - way[way.size() - 2]).norm();
    }
    LayerProfile profile{target, length, {}};
    for (const Vec3& place : placesAlong(way, length)) {
        if (progress.isCancelled()) return {};
        profile.values.push_back(felt.at(place, target));
    }
    return profile;
}

} // namespace tactum
