// Strokes over waves that are laid on a body, and what of the wave comes back in the forces.
//
// The judge is the wave's own derivative at the place of the proxy on the ideal body, a plane, a cylinder or
// a ball: what it shares with the program is the sine.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "tests/core/surface/texture_rig.h"
#include "tests/support/hand.h"
#include "tests/support/movers.h"

namespace tactum::test {

inline constexpr double kPi = std::numbers::pi;

struct Wave {
    double length, height; ///< m; highest above lowest
    double heightAt(double x) const { return height * (0.5 + 0.5 * std::sin(2 * kPi * x / length)); }
    double slopeAt(double x) const { return kPi * height / length * std::cos(2 * kPi * x / length); }
};

inline constexpr int kWavesInAPicture = 4;

/// Four waves in a picture of so many texels a side.
inline TextureLayer pictureOf(const Wave& wave, int texels, TextureMapping mapping = TextureMapping::Planar) {
    const Image image = imageOf(texels, texels, [](double x, double) {
        return 0.5 + 0.5 * std::sin(2 * kPi * kWavesInAPicture * x);
    });
    return imageLayer(image, mapping, kWavesInAPicture * wave.length, wave.height);
}

inline TextureLayer formulaOf(const Wave& wave, TextureMapping mapping = TextureMapping::Planar) {
    TextureLayer layer = heightLayer(TextureSource::Grooves, mapping, wave.length, wave.height);
    layer.pattern.fill = 0.5;
    layer.pattern.softness = 1;
    layer.pattern.offsetU = 0.25 * wave.length; // a cosine becomes the sine
    return layer;
}

/// A line on a body, by its length in m. Body frame.
struct Course {
    Soup soup;
    std::function<Vec3(double)> place, out; ///< on the ideal surface, and away from it
    std::function<double(const Vec3&)> at;  ///< how far along a place beside it is
    Shading shading{};
    SharedMotion motion{};

    Vec3 along(double x) const {
        constexpr double kStep = 1e-6;
        return (place(x + kStep) - place(x - kStep)).normalized();
    }
};

/// Along x, on the plane z = 0.
inline Course flatCourse(Soup soup) {
    return {std::move(soup), [](double x) { return Vec3(x, 0, 0); },
            [](double) { return Vec3(Vec3::UnitZ()); }, [](const Vec3& p) { return p.x(); }};
}

/// Around z at the height z, outside or inside (side: 1 or -1) of a body of that radius.
inline Course roundCourse(Soup soup, double radius, double side, double z = 0) {
    const auto out = [=](double x) {
        return Vec3(side * std::cos(x / radius), side * std::sin(x / radius), 0);
    };
    return {std::move(soup), [=](double x) { return Vec3(side * radius * out(x) + z * Vec3::UnitZ()); }, out,
            [=](const Vec3& p) { return radius * std::atan2(p.y(), p.x()); }};
}

struct StrokeSettings {
    double radius = 1e-3, depth = 3e-3; ///< m; of the proxy, and of the finger below where it would rest
    double speed = 0.05;                ///< m/s, along the surface
    double from = 0, to = 0;            ///< m, along the course
    double told = 0;                    ///< m: what comes before is not told
};

/// One tick of a stroke.
struct StrokeTick {
    double finger = 0;          ///< how far along it is, m
    Vec3 proxy = Vec3::Zero();  ///< body frame, m
    double x = 0;               ///< how far along that is, m
    double way = 0;             ///< since the last tick, m
    double along = 0, push = 0; ///< of the force: along the course, and away from the body, N
    double step = 0;            ///< of `along` since the last tick, N
    double ratio() const { return -along / push; }
};

/// A finger that goes along a course, in the body as it moves.
template <class Seen>
void strokeAlong(const Course& course, const std::vector<TextureLayer>& layers, const Material& material,
                 const StrokeSettings& how, Seen&& seen) {
    Scene scene = sceneOf({bodyOf(course.soup, material, course.motion)}, how.radius);
    scene.objects[0].surfaces[0].layers = layers;
    scene.objects[0].surfaces[0].shading = course.shading;
    const auto world = compile(scene).value();
    Hand hand(world);
    const auto poseAt = [&](double time) {
        Pose pose;
        if (!world->movers.empty()) pose = world->movers[0].poseAt(time);
        return pose;
    };
    const auto put = [&](double x, double height) {
        hand.to(poseAt(hand.state.time + kMillisecond).apply(course.place(x) + height * course.out(x)));
    };
    const double above = 3e-3, below = how.radius - how.depth;
    constexpr int kDown = 100;
    for (int i = 0; i <= kDown; ++i)
        put(how.from, above + (below - above) * i / kDown);
    const int steps = int(std::llround((how.to - how.from) / (how.speed * kMillisecond)));
    std::optional<StrokeTick> last;
    for (int i = 1; i <= steps; ++i) {
        const double finger = how.from + i * (how.to - how.from) / steps;
        put(finger, below);
        const Pose now = poseAt(hand.state.time);
        const Vec3 force = now.rotateInverse(hand.output().force);
        StrokeTick tick{.finger = finger};
        tick.proxy = now.applyInverse(hand.output().proxy);
        tick.x = course.at(tick.proxy);
        tick.along = force.dot(course.along(tick.x));
        tick.push = force.dot(course.out(tick.x));
        if (last) tick.way = tick.x - last->x, tick.step = tick.along - last->along;
        if (last && finger > how.told) seen(tick);
        last = tick;
    }
}

/// What a stroke along a wave feels.
struct WaveStroke {
    double gain = 0;        ///< the felt slope by the wave's, as far as they go together
    double error = 0;       ///< of the felt slope, root mean square, by that of the wave's
    double height = 0;      ///< regained from the forces, m
    double largestStep = 0; ///< N in a tick
    int stops = 0;          ///< ticks in which the proxy hardly went on
    double ratio = 0;       ///< of tangential to normal force, mean
};

/// The slope is that of the force, seen from the cone of friction.
inline WaveStroke stroked(const Course& course, const std::vector<TextureLayer>& layers, double friction,
                          const StrokeSettings& how,
                          const std::function<double(const StrokeTick&)>& slopeAt) {
    WaveStroke stroke;
    double off = 0, both = 0, whole = 0, rise = 0, lowest = 0, highest = 0;
    int count = 0;
    strokeAlong(course, layers, rough(friction > 0 ? friction + 0.1 : 0, friction), how,
                [&](const StrokeTick& tick) {
                    const double ratio = tick.ratio(), felt = (ratio - friction) / (1 + ratio * friction),
                                 slope = slopeAt(tick);
                    off += (felt - slope) * (felt - slope), both += felt * slope, whole += slope * slope;
                    rise += felt * tick.way;
                    lowest = std::min(lowest, rise), highest = std::max(highest, rise);
                    stroke.largestStep = std::max(stroke.largestStep, std::abs(tick.step));
                    stroke.stops += tick.way < 0.01 * how.speed * kMillisecond;
                    stroke.ratio += ratio, ++count;
                });
    stroke.gain = both / whole;
    stroke.error = std::sqrt(off / whole);
    stroke.height = highest - lowest;
    stroke.ratio /= count;
    return stroke;
}

inline void tell(const WaveStroke& felt, const WaveStroke& formula) {
    qInfo("gain %.4f, off by %.2f %%, height %.4f of %.4f mm, step %.4f of %.4f N, %d of %d stops, ratio "
          "%.4f of %.4f",
          felt.gain, 100 * felt.error, 1e3 * felt.height, 1e3 * formula.height, felt.largestStep,
          formula.largestStep, felt.stops, formula.stops, felt.ratio, formula.ratio);
}

} // namespace tactum::test
