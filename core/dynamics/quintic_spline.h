// Smooth curves through rows of six numbers: pieces of fifth degree with four continuous derivatives. For
// this folder.
#pragma once

#include <array>
#include <vector>

#include "core/dynamics/spatial.h"

namespace tactum {

/// A value and its derivatives by the parameter.
struct SplineJet {
    Vec6 value = Vec6::Zero(), first = Vec6::Zero(), second = Vec6::Zero(), third = Vec6::Zero();
};

/// Minimises the square of its third derivative, so it has the ends that follow from that: there the third
/// and the fourth are none. Source: J. Ahlberg, E. Nilson and J. Walsh, The Theory of Splines and Their
/// Applications, Academic Press 1967, chapter 4.
class QuinticSpline {
public:
    QuinticSpline() = default;
    /// Through `values` at `knots`, which grow. Of a closed one there is one more knot than values: where the
    /// first comes again; at least three values either way. Thread: any but real time.
    QuinticSpline(std::vector<double> knots, const std::vector<Vec6>& values, bool closed);

    double begin() const noexcept { return knots_.front(); }
    double end() const noexcept { return knots_.back(); }
    const std::vector<double>& knots() const noexcept { return knots_; }
    /// Between its ends; beyond them the last piece goes on. Thread: real time.
    SplineJet at(double u) const noexcept;

private:
    using Piece = std::array<Vec6, 6>; ///< coefficients of the powers, from the constant up

    std::vector<double> knots_;
    std::vector<Piece> pieces_;
};

} // namespace tactum
