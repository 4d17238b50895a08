#include "core/dynamics/quintic_spline.h"

#include <algorithm>

#include <Eigen/SparseLU>

namespace tactum {

namespace {

/// A derivative at one end of a piece of length h: `rise` times its rise, and so much for the slopes and the
/// second derivatives at both ends.
struct EndRow {
    double rise, slope0, slope1, bend0, bend1;
};

// By comparing coefficients of the piece that has given values, slopes and second derivatives at both ends.
EndRow thirdAtBegin(double h) {
    return {60 / (h * h * h), -36 / (h * h), -24 / (h * h), -9 / h, 3 / h};
}
EndRow thirdAtEnd(double h) {
    return {60 / (h * h * h), -24 / (h * h), -36 / (h * h), -3 / h, 9 / h};
}
EndRow fourthAtBegin(double h) {
    const double h3 = h * h * h;
    return {-360 / (h3 * h), 192 / h3, 168 / h3, 36 / (h * h), -24 / (h * h)};
}
EndRow fourthAtEnd(double h) {
    const double h3 = h * h * h;
    return {360 / (h3 * h), -168 / h3, -192 / h3, -24 / (h * h), 36 / (h * h)};
}

/// The slopes and second derivatives at all knots, from the continuity of the third and the fourth.
class KnotEquations {
public:
    KnotEquations(const std::vector<double>& knots, const std::vector<Vec6>& values, bool closed)
        : values_(values), closed_(closed), knots_(int(values.size())),
          right_(Eigen::MatrixXd::Zero(2 * knots_, 6)) {
        // Lengths of about one keep the equations well scaled.
        const int pieces = int(knots.size()) - 1;
        unit_ = (knots.back() - knots.front()) / pieces;
        for (int i = 0; i < pieces; ++i)
            lengths_.push_back((knots[std::size_t(i + 1)] - knots[std::size_t(i)]) / unit_);
        for (int knot = 0; knot < knots_; ++knot)
            join(knot);
    }

    void solve() {
        Eigen::SparseMatrix<double> matrix(2 * knots_, 2 * knots_);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
        found_ = factor.solve(right_);
    }
    Vec6 slope(int knot) const { return found_.row(2 * (knot % knots_)).transpose() / unit_; }
    Vec6 bend(int knot) const { return found_.row(2 * (knot % knots_) + 1).transpose() / (unit_ * unit_); }

private:
    /// What comes before a knot goes on after it; at an open end there is nothing to go on with.
    void join(int knot) {
        const int pieces = int(lengths_.size());
        const int after = knot < pieces ? knot : -1;
        const int before = knot > 0 ? knot - 1 : closed_ ? pieces - 1 : -1;
        const double least = std::min(before < 0 ? 1e300 : length(before), after < 0 ? 1e300 : length(after));
        const double weight = least * least * least;
        if (before < 0 || after < 0) { // two rows of one piece
            const bool first = before < 0;
            const int piece = first ? after : before;
            add(2 * knot, piece, first ? thirdAtBegin(length(piece)) : thirdAtEnd(length(piece)), weight);
            add(2 * knot + 1, piece, first ? fourthAtBegin(length(piece)) : fourthAtEnd(length(piece)),
                weight * least);
            return;
        }
        add(2 * knot, before, thirdAtEnd(length(before)), weight);
        add(2 * knot, after, thirdAtBegin(length(after)), -weight);
        add(2 * knot + 1, before, fourthAtEnd(length(before)), weight * least);
        add(2 * knot + 1, after, fourthAtBegin(length(after)), -weight * least);
    }
    double length(int piece) const { return lengths_[std::size_t(piece)]; }

    void add(int row, int piece, const EndRow& of, double weight) {
        const int a = piece, b = (piece + 1) % knots_;
        entries_.emplace_back(row, 2 * a, weight * of.slope0);
        entries_.emplace_back(row, 2 * a + 1, weight * of.bend0);
        entries_.emplace_back(row, 2 * b, weight * of.slope1);
        entries_.emplace_back(row, 2 * b + 1, weight * of.bend1);
        right_.row(row) -= weight * of.rise * (values_[std::size_t(b)] - values_[std::size_t(a)]).transpose();
    }

    const std::vector<Vec6>& values_;
    bool closed_;
    int knots_;
    double unit_ = 1;
    std::vector<double> lengths_; ///< of the pieces, in units
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::MatrixXd right_, found_;
};

} // namespace

QuinticSpline::QuinticSpline(std::vector<double> knots, const std::vector<Vec6>& values, bool closed)
    : knots_(std::move(knots)) {
    KnotEquations equations(knots_, values, closed);
    equations.solve();
    for (int i = 0; i + 1 < int(knots_.size()); ++i) {
        const double h = knots_[std::size_t(i + 1)] - knots_[std::size_t(i)];
        const Vec6 &from = values[std::size_t(i)], &to = values[std::size_t(i + 1) % values.size()];
        const Vec6 rise = to - from;
        const Vec6 s0 = h * equations.slope(i), s1 = h * equations.slope(i + 1);
        const Vec6 b0 = h * h * equations.bend(i), b1 = h * h * equations.bend(i + 1);
        Piece piece{from,
                    s0,
                    0.5 * b0,
                    10 * rise - 6 * s0 - 4 * s1 - 1.5 * b0 + 0.5 * b1,
                    -15 * rise + 8 * s0 + 7 * s1 + 1.5 * b0 - b1,
                    6 * rise - 3 * (s0 + s1) - 0.5 * (b0 - b1)};
        double power = 1;
        for (Vec6& coefficient : piece) {
            coefficient /= power;
            power *= h;
        }
        pieces_.push_back(piece);
    }
}

SplineJet QuinticSpline::at(double u) const noexcept {
    const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, u);
    const std::size_t i = std::size_t(above - knots_.begin()) - 1;
    const double x = u - knots_[i];
    const Piece& c = pieces_[i];
    SplineJet jet;
    jet.value = c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
    jet.first = c[1] + x * (2 * c[2] + x * (3 * c[3] + x * (4 * c[4] + x * 5 * c[5])));
    jet.second = 2 * c[2] + x * (6 * c[3] + x * (12 * c[4] + x * 20 * c[5]));
    jet.third = 6 * c[3] + x * (24 * c[4] + x * 60 * c[5]);
    return jet;
}

} // namespace tactum
