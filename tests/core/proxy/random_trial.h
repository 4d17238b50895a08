// What the random trials of the proxy have in common: shapes, feels, paths, and what must never be.
// Everything about a trial follows from its number.
#pragma once

#include <QString>
#include <QtGlobal>

#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/repeats.h"

namespace tactum::test {

// Parts of the radius. A proxy that a sweep stopped a skin too near is pushed out again, by a little more
// between tilted planes; a micrometre of a proxy of a millimetre is what may be out of reach.
inline constexpr double kPushOut = 2 * kSkin;
inline constexpr double kTolerance = 1e-3;
// Steps in which a proxy under a still finger comes to where it can come.
inline constexpr int kRest = 20;

inline Soup crumpled(Rng& rng, double half) {
    const double height = half * uniform(rng, 0.02, 0.6);
    const int cells = 2 + int(rng() % 4);
    Rng bumps(rng());
    std::vector<double> heights(std::size_t((cells + 1) * (cells + 1)));
    for (double& h : heights)
        h = uniform(bumps, -height, height);
    return heightField(half, cells, [&](double x, double y) {
        const auto at = [&](double v) { return std::size_t(std::lround(0.5 * (v / half + 1) * cells)); };
        return heights[at(x) * std::size_t(cells + 1) + at(y)];
    });
}

/// Many faces that meet in one corner, around a hollow or a spike.
inline Soup randomFan(Rng& rng, double half) {
    const int n = 3 + int(rng() % 10);
    std::vector<Vec3> rays;
    for (int k = 0; k < n; ++k) {
        const double turn = 2 * std::numbers::pi * (k + uniform(rng, 0, 0.9)) / n;
        rays.push_back(Vec3(std::cos(turn), std::sin(turn), uniform(rng, -0.5, 1.5)).normalized());
    }
    return pit(rays, half);
}

/// Closed, and seen whole from its middle.
inline Soup dentedBall(Rng& rng, double half) {
    const std::uint64_t salt = rng();
    auto dented = std::make_shared<TriangleSoup>(*ball(1, 1));
    for (Vec3& p : dented->positions) { // the same at every copy of a corner
        Rng dent(salt ^ std::uint64_t(std::llround(1e6 * (p.x() + 3 * p.y() + 9 * p.z()))));
        p *= half * uniform(dent, 0.5, 1);
    }
    return dented;
}

inline Soup someSoup(Rng& rng, double half) {
    switch (rng() % 6) {
    case 0:
        return crumpled(rng, half);
    case 1:
        return randomFan(rng, half);
    case 2:
        return dentedBall(rng, half);
    case 3:
        return wedge(uniform(rng, 0.05, 3.1), half);
    default:
        return randomSoup(rng, 3 + int(rng() % 40), half);
    }
}

inline Material someMaterial(Rng& rng) {
    if (rng() % 2) return frictionless();
    const double mu = uniform(rng, 0, 1.5);
    return rough(mu, mu * uniform(rng, 0, 1), rng() % 2 ? uniform(rng, 0, 5) : 0);
}

/// Whether a place that is seen by a closed soup is within it: the solid angle that it fills.
inline bool isInside(const TriangleSoup& soup, const Vec3& p) {
    double angle = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle t = triangleOf(soup, i);
        const Vec3 a = (t.a - p).normalized(), b = (t.b - p).normalized(), c = (t.c - p).normalized();
        angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    return std::abs(angle) > 2 * std::numbers::pi;
}

/// The steps of a finger: smooth strokes, rests, and now and then a jump.
inline std::vector<Vec3> somePath(Rng& rng, const Vec3& start, int steps, double half, double stride) {
    std::vector<Vec3> places{start};
    Vec3 at = start, target = inBox(rng, half);
    while (places.size() < std::size_t(steps)) {
        if (rng() % 30 == 0) target = inBox(rng, half);
        const Vec3 way = target - at;
        if (rng() % 100 == 0)
            at = inBox(rng, 1.5 * half);
        else if (rng() % 5 && way.norm() > 0)
            at += way * std::min(1.0, stride / way.norm());
        places.push_back(at);
    }
    return places;
}

/// Whether a straight way for which isFree(way) holds brings the proxy nearer to the finger by more than the
/// tolerance.
template <class Free>
bool couldComeNearer(const Vec3& proxy, const Vec3& finger, double radius, Rng& rng, Free&& isFree) {
    const Vec3 gap = finger - proxy;
    for (int i = 0; i < 20; ++i) {
        const Vec3 toward = (i == 0 ? gap : (gap.normalized() + 1.5 * inBox(rng, 1))).normalized();
        const double length = std::min(gap.norm(), radius * std::pow(10, uniform(rng, -2.5, 0)));
        if ((gap - length * toward).norm() > gap.norm() - 1.1 * kTolerance * radius) continue;
        if (isFree(Vec3(length * toward))) return true;
    }
    return false;
}

/// What goes wrong first on a path, and where; empty: nothing. step(i, finger) makes a step of two proxies
/// that are told the same and says whether they came to the same; faultOf(i, finger) is what is wrong then,
/// or empty; freezes(i, finger): whether the proxy rests where it could come nearer, which a few more steps
/// may repair.
template <class Step, class FaultOf, class Freezes>
QString firstFault(const std::vector<Vec3>& path, Step&& step, FaultOf&& faultOf, Freezes&& freezes) {
    for (int i = 0; i < int(path.size()); ++i) {
        const Vec3& finger = path[std::size_t(i)];
        const bool same = step(i, finger);
        QString fault = faultOf(i, finger);
        if (fault.isEmpty() && !same) fault = "differs the second time";
        if (fault.isEmpty() && i % 10 == 9 && freezes(i, finger)) {
            for (int k = 0; k < kRest; ++k)
                step(i, finger);
            if (freezes(i, finger)) fault = "freezes";
        }
        if (!fault.isEmpty()) return QString("the proxy %1 at step %2").arg(fault).arg(i);
    }
    return {};
}

/// How many trials have a fault, faultIn(number) being what it is or empty. As many as TACTUM_SOUPS says, or
/// an ordinary number of them (a tenth in the short ./check), from TACTUM_FIRST_SOUP on, to see again what
/// failed.
template <class FaultIn> QString failures(int ordinary, FaultIn&& faultIn) {
    const std::uint64_t first = qEnvironmentVariable("TACTUM_FIRST_SOUP").toULongLong();
    const auto count = std::uint64_t(repeats("TACTUM_SOUPS", longOnly(ordinary)));
    std::uint64_t failed = 0;
    for (std::uint64_t number = first; number < first + count; ++number) {
        const QString fault = faultIn(number);
        if (fault.isEmpty()) continue;
        if (++failed <= 20)
            qWarning("soup %llu: %s", static_cast<unsigned long long>(number), qPrintable(fault));
    }
    return failed == 0 ? QString() : QString("%1 of %2 soups").arg(failed).arg(count);
}

} // namespace tactum::test
