#include "core/motion/motion.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

Vec3 blend(const Vec3& a, const Vec3& b, double s) noexcept {
    return a + s * (b - a);
}

QuatCoefficients blend(const QuatCoefficients& a, const QuatCoefficients& b, double s) noexcept {
    return Quat(a).slerp(s, Quat(b)).coeffs();
}

// Hermite's cubic, with slopes for each second of a span of `length` seconds.
template <class Value>
Value cubic(const Track<Value>& track, std::size_t key, double s, double length) noexcept {
    const double s2 = s * s, s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * track.values[key] + (3 * s2 - 2 * s3) * track.values[key + 1] +
           length * ((s3 - 2 * s2 + s) * track.leaving[key] + (s3 - s2) * track.arriving[key + 1]);
}

template <class Value> Value valueAt(const Track<Value>& track, double t) noexcept {
    const auto later = std::upper_bound(track.times.begin(), track.times.end(), t);
    if (later == track.times.begin()) return track.values.front();
    const std::size_t key = std::size_t(later - track.times.begin()) - 1;
    if (later == track.times.end() || track.interpolation == Interpolation::Step) return track.values[key];
    const double length = *later - track.times[key];
    const double s = (t - track.times[key]) / length;
    if (track.interpolation == Interpolation::CubicSpline) return cubic(track, key, s, length);
    return blend(track.values[key], track.values[key + 1], s);
}

// A cubic between opposite quaternions may pass zero, where it says nothing.
Quat unit(const QuatCoefficients& q) noexcept {
    const double length = q.norm();
    return length > 1e-9 ? Quat(QuatCoefficients(q / length)) : Quat::Identity();
}

} // namespace

double Motion::looped(double t) const noexcept {
    if (!(duration > 0) || t <= duration) return std::max(t, 0.0);
    const double rest = std::fmod(t, duration);
    return rest > 0 ? rest : duration;
}

Pose Motion::at(double t) const noexcept {
    const double local = looped(t);
    Pose pose;
    if (!translation.times.empty()) pose.translation = valueAt(translation, local);
    if (!rotation.times.empty()) pose.rotation = unit(valueAt(rotation, local));
    return pose;
}

bool Motion::jumpsBetween(double before, double now) const noexcept {
    if (jumps.empty() && !jumpsAtEnd) return false;
    if (duration > 0 && now - before >= duration) return true;
    const double from = looped(before), to = looped(now);
    const auto within = [this](double low, double high) {
        const auto next = std::upper_bound(jumps.begin(), jumps.end(), low);
        return next != jumps.end() && *next <= high;
    };
    if (from <= to) return within(from, to);
    return jumpsAtEnd || within(from, duration) || within(-1, to);
}

std::vector<Vec3> controlPoints(const Track<Vec3>& track) {
    if (track.times.empty()) return {Vec3::Zero()};
    std::vector<Vec3> points = track.values;
    if (track.interpolation != Interpolation::CubicSpline) return points;
    for (std::size_t key = 0; key + 1 < track.times.size(); ++key) {
        const double third = (track.times[key + 1] - track.times[key]) / 3;
        points.push_back(track.values[key] + third * track.leaving[key]);
        points.push_back(track.values[key + 1] - third * track.arriving[key + 1]);
    }
    return points;
}

} // namespace tactum
