#include "core/surface/painted_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace tactum {
namespace {

using Mat2 = Eigen::Matrix2d;

constexpr int kTerms = 9; ///< of two variables, up to the third degree, without the value
using Terms = Eigen::Matrix<double, kTerms, 1>;

// Of triangles: around the place, across their far sides, across those of these; farther where the surface
// ends, as there are too few on one side of a place.
constexpr int kRings = 3, kRingsAtARim = 5;
constexpr std::array<double, kRingsAtARim + 1> kWeight{0, 1, 0.25, 0.0625, 0.0625, 0.0625};

// By so much of the range of the values around it an ordinate beside a place may lie beyond them.
constexpr double kMargin = 0.3;
// Added to the squares of the coefficients, for lengths of one: what corners leave open stays zero, first of
// all what is cubic.
constexpr double kLinearStays = 1e-14, kSquareStays = 1e-9, kCubicStays = 1e-7;

Terms termsAt(const Eigen::Vector2d& p) {
    const double x = p.x(), y = p.y();
    Terms terms;
    terms << x, y, x * x / 2, x * y, y * y / 2, x * x * x / 6, x * x * y / 2, x * y * y / 2, y * y * y / 6;
    return terms;
}

} // namespace

PaintedFit PaintedFitter::at(Index place) {
    if (isLevelAt(place)) return {};
    const Vec3 normal = ground_.normal[place].cast<double>();
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = normal.unitOrthogonal();
    plane.col(1) = normal.cross(plane.col(0));
    gather(place, plane);
    const Mat2 even = evenly();
    Eigen::Matrix<double, kTerms, kTerms> squares = Eigen::Matrix<double, kTerms, kTerms>::Zero();
    squares.diagonal() << kLinearStays * Vec2(1, 1), kSquareStays * Vec3(1, 2, 1),
        kCubicStays * Eigen::Vector4d(1, 3, 3, 1);
    Terms sums = Terms::Zero();
    for (const Sample& sample : samples_) {
        const Terms terms = termsAt(even * sample.at);
        const double weight = kWeight[std::size_t(sample.ring)];
        squares.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight);
        sums += weight * sample.rise * terms;
    }
    const Terms fit = squares.ldlt().solve(sums);
    Mat2 bend;
    bend << fit[2], fit[3], fit[3], fit[4];
    const Eigen::Matrix<double, 3, 2> back = plane * even.transpose();
    const Vec2 plain = area_ > 0 ? Vec2(flux_ / area_) : Vec2(0, 0),
               curved = even.transpose() * fit.head<2>() - plain;
    const double part = curved.allFinite() ? partWithin(plain, curved) : 0;
    const PaintedFit result{plane * (plain + part * curved), part * back * bend * back.transpose()};
    return result.rise.allFinite() && result.bend.allFinite() ? result : PaintedFit{};
}

// How much of what a fit has beyond the mean slope counts: on the way to no corner may it lead beyond all
// values there by more than a part of their range. Corners that lie on one circle, as around the middle of a
// lid, or on one side, leave a slope across them nearly open.
double PaintedFitter::partWithin(const Vec2& plain, const Vec2& curved) const {
    double low = 0, high = 0, part = 1;
    for (const Sample& sample : samples_)
        if (sample.ring == 1) low = std::min(low, sample.rise), high = std::max(high, sample.rise);
    const double margin = kMargin * (high - low);
    for (const Sample& sample : samples_) {
        if (sample.ring != 1) continue;
        const double from = plain.dot(sample.at) / 3, more = curved.dot(sample.at) / 3;
        const double room = more > 0 ? high + margin - from : from - low + margin;
        if (std::abs(more) > room) part = std::min(part, std::max(0.0, room) / std::abs(more));
    }
    return part;
}

bool PaintedFitter::isLevelAt(Index place) const {
    return std::ranges::all_of(ground_.around(place), [&](Index triangle) {
        const auto& corner = soup_.triangles[triangle];
        return values_[corner[0]] == values_[corner[1]] && values_[corner[0]] == values_[corner[2]];
    });
}

bool PaintedFitter::isAtARim(Index place) const {
    return std::ranges::any_of(ground_.around(place), [&](Index triangle) {
        return std::ranges::count(ground_.across[triangle], PaintedGround::kNothing) > 0;
    });
}

// Turns and stretches the plane so that the nearest corners lie evenly around, a length of one away.
Eigen::Matrix2d PaintedFitter::evenly() const {
    Mat2 spread = Mat2::Zero();
    int count = 0;
    for (const Sample& sample : samples_)
        if (sample.ring == 1) spread += sample.at * sample.at.transpose(), ++count;
    return std::sqrt(0.5 * count) * spread.llt().matrixL().solve(Mat2::Identity());
}

void PaintedFitter::gather(Index place, const Eigen::Matrix<double, 3, 2>& plane) {
    samples_.clear();
    flux_ = Vec2::Zero();
    area_ = 0;
    place_ = place;
    rings_ = isAtARim(place) ? kRingsAtARim : kRings;
    const Vec3 normal = ground_.normal[place].cast<double>();
    for (const Index triangle : ground_.around(place)) {
        const Triangle t = cornersOf(soup_, triangle);
        const Vec3 across = acrossOf(t).normalized();
        if (!shareAPlane(across, normal)) continue;
        const auto& corner = soup_.triangles[triangle];
        const std::array<Vec3, 3> corners{t.a, t.b, t.c};
        std::size_t own = 0;
        while (own < 2 && ground_.place[corner[own]] != place)
            ++own;
        here_ = values_[corner[own]];
        Corners at;
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = plane.transpose() * turned(corners[i] - corners[own], across, normal);
            if (i != own) take(corner[i], at[i], 1);
        }
        const std::size_t next = (own + 1) % 3, last = (own + 2) % 3;
        addFlat(at[next], values_[corner[next]] - here_, at[last], values_[corner[last]] - here_);
        beyond(triangle, at, next, 2);
    }
}

// The slope of the linear surface on a triangle, weighted by its area: `p` and `q` are its other corners.
void PaintedFitter::addFlat(const Vec2& p, double riseP, const Vec2& q, double riseQ) {
    const double area = p.x() * q.y() - p.y() * q.x();
    const Vec2 flux(riseP * q.y() - riseQ * p.y(), riseQ * p.x() - riseP * q.x());
    flux_ += std::copysign(1.0, area) * flux;
    area_ += std::abs(area);
}

void PaintedFitter::beyond(Index triangle, const Corners& at, std::size_t side, int ring) {
    const Index next = ground_.across[triangle][side];
    if (next == PaintedGround::kNothing) return;
    const std::size_t end = (side + 1) % 3;
    const Index from = soup_.triangles[triangle][side], to = soup_.triangles[triangle][end];
    const auto& corner = soup_.triangles[next];
    Corners there;
    std::size_t far = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        const Index place = ground_.place[corner[i]];
        if (place == ground_.place[from])
            there[i] = at[side];
        else if (place == ground_.place[to])
            there[i] = at[end];
        else
            far = i;
    }
    if (far > 2) return;
    const Vec3 edge = (soup_.positions[to] - soup_.positions[from]).normalized(),
               way = soup_.positions[corner[far]] - soup_.positions[from];
    const Vec2 along = (at[end] - at[side]).normalized();
    Vec2 out(along.y(), -along.x());
    if (out.dot(at[(side + 2) % 3] - at[side]) > 0) out = -out;
    there[far] = at[side] + way.dot(edge) * along + (way - way.dot(edge) * edge).norm() * out;
    take(corner[far], there[far], ring);
    if (ring == rings_) return;
    beyond(next, there, far, ring + 1);
    beyond(next, there, (far + 2) % 3, ring + 1);
}

void PaintedFitter::take(Index position, const Vec2& at, int ring) {
    if (ground_.place[position] != place_) samples_.push_back({at, values_[position] - here_, ring});
}

} // namespace tactum
