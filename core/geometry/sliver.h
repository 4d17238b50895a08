// Which triangles are too thin to see. For this folder only.
#pragma once

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Area below 1e-12 of the squared diagonal of the box.
class SliverRule {
public:
    explicit SliverRule(const TriangleSoup& soup) : soup_(soup), diagonal_(boundsOf(soup).diagonal()) {
        const double least = 2 * 1e-12 * diagonal_ * diagonal_;
        least_ = least * least;
    }

    bool operator()(Index triangle) const { return (*this)(soup_.triangles[triangle]); }
    bool operator()(const std::array<Index, 3>& t) const {
        const auto& p = soup_.positions;
        return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).squaredNorm() < least_;
    }
    double diagonal() const { return diagonal_; }

private:
    const TriangleSoup& soup_;
    double diagonal_, least_;
};

} // namespace tactum
