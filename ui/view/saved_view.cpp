#include "ui/view/saved_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactum {

namespace {
/// Of the direction: nearer to straight up or down it does not say where right is.
constexpr double kUpright = 1e-6;
constexpr double kLeastView = 1e-4, kMostView = EIGEN_PI - 1e-4; // rad: beyond, a picture of nothing
} // namespace

SavedCamera savedCamera(const ViewCamera& camera, std::string name) {
    Mat3 axes;
    axes << camera.right(), camera.up(), -camera.forward();
    SavedCamera saved;
    saved.name = std::move(name);
    saved.pose = {Quat(axes).normalized(), camera.eye()};
    saved.parallel = camera.parallel;
    saved.ahead = (camera.focus - camera.eye()).norm();
    if (camera.parallel)
        saved.height = 2 * camera.distance * std::tan(0.5 * camera.fieldOfView);
    else
        saved.angle = camera.fieldOfView;
    return saved;
}

ViewCamera viewOf(const SavedCamera& saved, const ViewCamera& like) {
    const Mat3 axes = saved.pose.rotation.toRotationMatrix();
    const Vec3 back = axes.col(2), up = axes.col(1);
    ViewCamera camera = like;
    camera.parallel = saved.parallel;
    camera.focus = saved.pose.translation - saved.ahead * back;
    const double aside = std::hypot(back.x(), back.z());
    camera.pitch = std::atan2(back.y(), aside);
    const bool steep = aside < kUpright;
    const Vec3 level = steep ? Vec3((back.y() > 0 ? -1 : 1) * up) : back; // both point at the eye's side
    camera.yaw = std::atan2(level.x(), level.z());
    camera.distance = saved.ahead;
    if (saved.parallel)
        camera.distance = 0.5 * saved.height / std::tan(0.5 * camera.fieldOfView);
    else
        camera.fieldOfView = std::clamp(saved.angle, kLeastView, kMostView);
    return camera;
}

} // namespace tactum
