#include "core/dynamics/path_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/dynamics/path_places.h"

namespace tactum {

namespace {

/// Pieces of the final curve for each span between two points, and at least.
constexpr std::size_t kPiecesOfSpan = 8, kLeastPieces = 64;
/// A curve by its length has the speed 1; less than this part of it is a corner.
constexpr double kLeastSpeed = 0.7;
/// Sine of the least angle between the curve and up.
constexpr double kLeastAside = 0.05;

Vec6 rowOf(const Vec3& place, const Vec3& up) {
    return spatial(place, up);
}

/// Places between which nothing is known yet: over the lengths of the chords.
Result<QuinticSpline> throughPoints(JointPath path) {
    const std::size_t least = path.closed ? 3 : 2;
    if (path.points.size() < least)
        return inputError("its path has too few points; give " + std::to_string(least) + " or more");
    if (path.points.size() > kMostPathPoints)
        return inputError("its path has more than " + std::to_string(kMostPathPoints) +
                          " points; give fewer, it is smooth between them");
    if (!path.ups.empty() && path.ups.size() != path.points.size())
        return inputError("its path has not one up for each point; give as many, or none");
    if (path.points.size() == 2) { // a line
        path.points.insert(path.points.begin() + 1, 0.5 * (path.points[0] + path.points[1]));
        if (!path.ups.empty()) path.ups.insert(path.ups.begin() + 1, path.ups[0] + path.ups[1]);
    }
    const std::size_t count = path.points.size();
    std::vector<double> knots{0};
    std::vector<Vec6> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 up = path.ups.empty() ? Vec3::Zero() : path.ups[i];
        rows.push_back(rowOf(path.points[i], up.stableNormalized()));
        if (i + 1 == count && !path.closed) break;
        const double chord = (path.points[(i + 1) % count] - path.points[i]).norm();
        if (!(chord > 0 && std::isfinite(chord)))
            return inputError(
                "its path has two points in the same place, or one that is no place; move them");
        knots.push_back(knots.back() + chord);
    }
    return QuinticSpline(std::move(knots), rows, path.closed);
}

/// Of a curve between two parameters, by Gauss and Legendre's five points.
double lengthOf(const QuinticSpline& curve, double from, double to) {
    constexpr std::array<double, 3> kAt{0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> kWeight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (const double sign : {-1.0, 1.0})
            sum += (i == 0 ? 0.5 : 1) * kWeight[i] *
                   curve.at(middle + sign * half * kAt[i]).first.head<3>().norm();
    return half * sum;
}

/// The parameters of `pieces` + 1 places in equal ways; gives the whole length.
double equalWays(const QuinticSpline& curve, std::size_t pieces, std::vector<double>& parameters) {
    std::vector<double> at{curve.begin()}, way{0};
    for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i) {
        const double from = curve.knots()[i], step = (curve.knots()[i + 1] - from) / kPiecesOfSpan;
        for (std::size_t k = 0; k < kPiecesOfSpan; ++k) {
            way.push_back(way.back() + lengthOf(curve, at.back(), from + double(k + 1) * step));
            at.push_back(from + double(k + 1) * step);
        }
    }
    for (std::size_t k = 0; k <= pieces; ++k) {
        const double wanted = way.back() * double(k) / double(pieces);
        const std::size_t part =
            std::size_t(std::upper_bound(way.begin() + 1, way.end() - 1, wanted) - way.begin()) - 1;
        double u = at[part];
        for (int round = 0; round < 20; ++round) { // Newton
            const double speed = curve.at(u).first.head<3>().norm();
            const double missing = wanted - way[part] - lengthOf(curve, at[part], u);
            u = std::clamp(u + missing / std::max(speed, 1e-9), at[part], at[part + 1]);
        }
        parameters.push_back(u);
    }
    return way.back();
}

/// Ups that turn about the curve as little as can be. Source: W. Wang and others, Computation of Rotation
/// Minimizing Frames, ACM Transactions on Graphics 2008 (double reflection).
std::vector<Vec3> calmUps(const std::vector<Vec3>& places, const std::vector<Vec3>& ways, bool closed) {
    const Vec3 first = std::abs(ways[0].y()) < 0.99 ? Vec3::UnitY() : Vec3::UnitZ();
    std::vector<Vec3> ups{(first - first.dot(ways[0]) * ways[0]).normalized()};
    const auto mirrored = [](const Vec3& v, const Vec3& normal) {
        const double square = normal.squaredNorm();
        return square > 0 ? Vec3(v - 2 / square * normal.dot(v) * normal) : v;
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const Vec3 chord = places[i + 1] - places[i];
        const Vec3 way = mirrored(ways[i], chord), up = mirrored(ups[i], chord);
        ups.push_back(mirrored(up, ways[i + 1] - way).normalized());
    }
    if (!closed) return ups;
    const double twist =
        std::atan2(ups.back().cross(ups.front()).dot(ways.front()), ups.back().dot(ups.front()));
    for (std::size_t i = 0; i < ups.size(); ++i)
        ups[i] = Eigen::AngleAxisd(twist * double(i) / double(ups.size() - 1), ways[i]) * ups[i];
    return ups;
}

/// The frame of a place with all derivatives of the curve at hand, as the header has it.
PathSpot spotOf(const SplineJet& jet) noexcept {
    const Vec3 c1 = jet.first.head<3>(), c2 = jet.second.head<3>(), c3 = jet.third.head<3>();
    const Vec3 w = jet.value.tail<3>(), w1 = jet.first.tail<3>(), w2 = jet.second.tail<3>();
    // The unit tangent t = c' / |c'| and its derivatives.
    const double g = c1.norm();
    const Vec3 t = c1 / g;
    const double g1 = t.dot(c2);
    const Vec3 t1 = (c2 - g1 * t) / g;
    const double g2 = t1.dot(c2) + t.dot(c3);
    const Vec3 t2 = (c3 - 2 * g1 * t1 - g2 * t) / g;
    // z = t x up / |t x up|, y = z x t.
    const Vec3 m = t.cross(w), m1 = t1.cross(w) + t.cross(w1);
    const Vec3 m2 = t2.cross(w) + 2 * t1.cross(w1) + t.cross(w2);
    const double l = m.norm();
    const Vec3 z = m / l, y = z.cross(t);
    // The axes turn by t x t' + r t, where r = -z' . y.
    const double roll = -m1.dot(y) / l;
    PathSpot spot;
    spot.turn = t.cross(t1) + roll * t;
    const double rollRate = -(m2.dot(y) + m1.dot(spot.turn.cross(y)) + roll * m1.dot(z)) / l;
    spot.turnRate = t.cross(t2) + rollRate * t + roll * t1;
    spot.way = c1;
    spot.wayRate = c2;
    Mat3 axes;
    axes << t, y, z;
    spot.pose = {Quat(axes), jet.value.head<3>()};
    return spot;
}

/// The same, going on straight.
PathSpot straightOn(PathSpot spot, double beyond) noexcept {
    spot.pose.translation += beyond * spot.way;
    spot.turn.setZero(), spot.wayRate.setZero(), spot.turnRate.setZero();
    return spot;
}

Result<void> check(const QuinticSpline& curve) {
    for (std::size_t i = 0; i + 1 < curve.knots().size(); ++i)
        for (const double part : {0.0, 0.25, 0.5, 0.75}) {
            const double s = curve.knots()[i] + part * (curve.knots()[i + 1] - curve.knots()[i]);
            const SplineJet jet = curve.at(s);
            const Vec3 way = jet.first.head<3>(), up = jet.value.tail<3>();
            const std::string where = " after " + std::to_string(s) + " m";
            if (!(way.norm() > kLeastSpeed))
                return inputError("its path turns too sharply" + where +
                                  "; set more points there, or none so "
                                  "close together");
            if (!(up.norm() > kLeastAside) || !(way.cross(up).norm() > kLeastAside * way.norm() * up.norm()))
                return inputError("up lies along its path" + where + "; let it point aside");
        }
    return {};
}

} // namespace

Result<PathCurve> PathCurve::through(const JointPath& path) {
    const auto drawn = throughPoints(path);
    if (!drawn) return tl::unexpected(drawn.error());
    const std::size_t pieces = std::max(kLeastPieces, kPiecesOfSpan * (drawn->knots().size() - 1));
    std::vector<double> parameters, knots;
    const double length = equalWays(*drawn, pieces, parameters);
    std::vector<Vec3> places, ways, ups;
    for (std::size_t k = 0; k <= pieces; ++k) {
        const SplineJet jet = drawn->at(parameters[k]);
        knots.push_back(length * double(k) / double(pieces));
        places.push_back(jet.value.head<3>());
        ways.push_back(jet.first.head<3>().stableNormalized());
        ups.push_back(jet.value.tail<3>().stableNormalized());
    }
    if (path.ups.empty()) ups = calmUps(places, ways, path.closed);
    std::vector<Vec6> rows;
    for (std::size_t k = 0; k < pieces + (path.closed ? 0 : 1); ++k)
        rows.push_back(rowOf(places[k], ups[k]));
    PathCurve made;
    made.curve_ = QuinticSpline(std::move(knots), rows, path.closed);
    made.closed_ = path.closed;
    if (const auto fine = check(made.curve_); !fine) return tl::unexpected(fine.error());
    return made;
}

PathSpot PathCurve::at(double s) const noexcept {
    const double all = length();
    if (closed_) return spotOf(curve_.at(s - all * std::floor(s / all)));
    const double within = std::clamp(s, 0.0, all);
    const PathSpot spot = spotOf(curve_.at(within));
    return s == within ? spot : straightOn(spot, s - within);
}

double PathCurve::nearest(const Pose& to) const {
    const auto away = [&](double s) { return Vec3(at(s).pose.translation - to.translation); };
    const auto slope = [&](double s) { return away(s).dot(at(s).way); };
    const double step = curve_.knots()[1], all = length();
    // A quaternion's distance counts as millimetres: it decides between places that are as near.
    const auto cost = [&](double s) {
        const Quat turned = at(s).pose.rotation;
        return away(s).norm() + 1e-3 * std::min((turned.coeffs() - to.rotation.coeffs()).norm(),
                                                (turned.coeffs() + to.rotation.coeffs()).norm());
    };
    // An open path ends, though at() goes on straight.
    const auto within = [&](double s) { return closed_ ? s : std::clamp(s, 0.0, all); };
    std::optional<double> best;
    for (double k = 0; k < all + 0.5 * step; k += step) {
        const double s = within(k), here = away(s).squaredNorm();
        double low = within(s - step), high = within(s + step);
        if (away(low).squaredNorm() < here || away(high).squaredNorm() < here) continue;
        if (slope(low) > 0) high = low;
        if (slope(high) < 0) low = high;
        for (int round = 0; round < 60; ++round)
            (slope(0.5 * (low + high)) < 0 ? low : high) = 0.5 * (low + high);
        const double found = 0.5 * (low + high);
        if (!best || cost(found) < cost(*best)) best = found;
    }
    if (!best) return 0;
    return closed_ ? *best - all * std::floor(*best / all) : *best;
}

std::vector<Pose> placesAlong(const JointPath& path, int parts) {
    std::vector<Pose> places;
    const auto curve = PathCurve::through(path);
    for (int i = 0; curve && i <= parts; ++i)
        places.push_back(curve->at(curve->length() * i / parts).pose);
    return places;
}

std::optional<Pose> nearestOn(const JointPath& path, const Pose& to) {
    const auto curve = PathCurve::through(path);
    return curve ? std::optional(curve->at(curve->nearest(to)).pose) : std::nullopt;
}

} // namespace tactum
