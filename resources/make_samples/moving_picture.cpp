#include "resources/make_samples/moving_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bundle/preview.h"
#include "core/haptics/body_places.h"
#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/video/video_file.h"
#include "resources/make_samples/mesh.h"

namespace tactum::samples {

namespace {

constexpr int kWidth = 224, kHeight = 168;
constexpr double kPeriod = 0.08; // s

/// Its tip in the origin; of a length, m.
SceneObject stylus(double length) {
    Mesh mesh;
    const std::vector<double> along{0, 0.2, 0.9, 0.97, 1};
    constexpr double kThick[] = {0, 0.045, 0.045, 0.03, 0};
    mesh.grid(evenly(0, 2 * std::numbers::pi, 12), along, [&](double turn, double s) -> Vec3 {
        const double r = kThick[std::ranges::find(along, s) - along.begin()];
        return length * Vec3(r * std::cos(turn), s, -r * std::sin(turn));
    });
    SceneObject stylus = object("stylus", mesh, {surface("stylus", {0.9F, 0.35F, 0.03F})});
    stylus.pose.rotation = Quat::FromTwoVectors(Vec3::UnitY(), Vec3(0.35, 1, 0.25).normalized());
    return stylus;
}

/// As large as what is seen of the scene.
double sizeOf(const Scene& scene) {
    Bounds all;
    for (const SceneObject& object : scene.objects)
        if (object.visible)
            for (const Vec3& p : object.geometry->positions)
                all.add(object.pose.apply(p));
    return (all.high - all.low).norm();
}

/// The scene while it is touched.
class Touched {
public:
    Touched(const Scene& scene, const World& world)
        : scene_(scene), world_(world), places_(&world), camera_(scene, kWidth, kHeight) {
        scene_.objects.push_back(stylus(0.3 * sizeOf(scene)));
    }

    void step(const FingerPoint& before, const FingerPoint& now) {
        HapticInput input{.finger = now.position};
        const double dt = now.t - before.t;
        input.fingerVelocity = (now.position - before.position) / dt;
        scene_.objects.back().pose.translation = hapticStep(world_, state_, input, dt).proxy;
    }
    VideoPicture picture() {
        for (const PlacedObject& placed : places_.at(state_.bodies))
            for (SceneObject& object : scene_.objects)
                if (object.id == placed.object) object.pose = placed.pose;
        const auto values = camera_.draw(scene_);
        VideoPicture picture{kWidth, kHeight, {}};
        for (std::size_t i = 0; i < values.size(); i += 3)
            picture.pixels.push_back(0xff000000U | unsigned(values[i] >> 8) << 16 |
                                     unsigned(values[i + 1] >> 8) << 8 | unsigned(values[i + 2] >> 8));
        return picture;
    }

private:
    Scene scene_;
    const World& world_;
    SimState state_;
    BodyPlaces places_;
    Preview camera_;
};

} // namespace

Result<void> writeMovingPicture(const Scene& scene, const std::filesystem::path& file) {
    const auto world = compile(scene);
    if (!world) return tl::unexpected(world.error());
    auto video = beginVideo(file, kWidth, kHeight);
    if (!video) return tl::unexpected(video.error());
    Touched touched(scene, **world);
    const auto& path = *scene.finger;
    double next = path.front().t;
    for (std::size_t i = 1; i < path.size(); ++i) {
        touched.step(path[i - 1], path[i]);
        if (path[i].t < next) continue;
        if (auto added = (*video)->add(touched.picture(), next - path.front().t); !added) return added;
        next += kPeriod;
    }
    return (*video)->finish(next - path.front().t);
}

} // namespace tactum::samples
