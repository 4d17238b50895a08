#include "core/motion/motion_build.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"

namespace tactum {

namespace {

// What single-precision keys cannot tell apart is no jump.
constexpr double kSame = 1e-5;

bool same(const QuatCoefficients& a, const QuatCoefficients& b) {
    return std::min((a - b).norm(), (a + b).norm()) <= kSame; // q and -q turn alike
}

bool same(const Vec3& a, const Vec3& b, double size) {
    return (a - b).norm() <= kSame * size;
}

double sizeOf(const Track<Vec3>& track) {
    double size = 0;
    for (const Vec3& value : track.values)
        size = std::max(size, (value - track.values.front()).norm());
    return size;
}

template <class Value, class Same>
void appendJumps(const Track<Value>& track, std::vector<double>& jumps, Same&& isSame) {
    for (std::size_t key = 1; key < track.times.size(); ++key) {
        const bool stepped =
            track.interpolation == Interpolation::Step || track.times[key] == track.times[key - 1];
        if (stepped && !isSame(track.values[key - 1], track.values[key])) jumps.push_back(track.times[key]);
    }
}

void makeUnit(Track<QuatCoefficients>& rotation) {
    for (std::size_t key = 0; key < rotation.values.size(); ++key) {
        const double length = rotation.values[key].norm();
        if (std::abs(length - 1) <= 1e-12)
            continue; // it keeps its bits, so that reading what was written does
        rotation.values[key] /= length;
        if (rotation.interpolation != Interpolation::CubicSpline) continue;
        rotation.arriving[key] /= length;
        rotation.leaving[key] /= length;
    }
}

// The largest change for each second that two neighbouring moments show.
template <class Value, class Distance>
double steepest(const Track<Value>& track, const Motion& motion, Distance&& distance) {
    const int pieces = track.interpolation == Interpolation::CubicSpline ? 16 : 1;
    double most = 0;
    for (std::size_t key = 1; key < track.times.size(); ++key) {
        const double begin = track.times[key - 1], length = track.times[key] - begin;
        if (!(length > 0) || track.interpolation == Interpolation::Step) continue;
        // Just before the next key, so that a jump there does not count.
        const auto moment = [&](int i) {
            return begin + length * (i == pieces ? 1 - 1e-9 : double(i) / pieces);
        };
        for (int i = 0; i < pieces; ++i)
            most = std::max(most, distance(motion.at(moment(i)), motion.at(moment(i + 1))) * pieces / length);
    }
    return most;
}

} // namespace

Motion makeMotion(Track<Vec3> translation, Track<QuatCoefficients> rotation, double duration) {
    assertNotRealtime();
    makeUnit(rotation);
    Motion motion{std::move(translation), std::move(rotation), duration, {}, false};
    const double size = sizeOf(motion.translation);
    const auto samePlace = [size](const Vec3& a, const Vec3& b) { return same(a, b, size); };
    const auto sameTurn = [](const QuatCoefficients& a, const QuatCoefficients& b) { return same(a, b); };
    appendJumps(motion.translation, motion.jumps, samePlace);
    appendJumps(motion.rotation, motion.jumps, sameTurn);
    std::ranges::sort(motion.jumps);
    const Pose first = motion.at(0), last = motion.at(duration);
    motion.jumpsAtEnd = !samePlace(first.translation, last.translation) ||
                        !sameTurn(first.rotation.coeffs(), last.rotation.coeffs());
    return motion;
}

Motion scaled(Motion motion, double factor) {
    assertNotRealtime();
    Track<Vec3>& track = motion.translation;
    for (std::vector<Vec3>* lengths : {&track.values, &track.arriving, &track.leaving})
        for (Vec3& length : *lengths)
            length *= factor;
    return motion;
}

double topSpeed(const Motion& motion, double reach) {
    assertNotRealtime();
    const double slide = steepest(motion.translation, motion, [](const Pose& a, const Pose& b) {
        return (a.translation - b.translation).norm();
    });
    const double turn = steepest(motion.rotation, motion, [](const Pose& a, const Pose& b) {
        return a.rotation.angularDistance(b.rotation);
    });
    return slide + turn * reach;
}

} // namespace tactum
