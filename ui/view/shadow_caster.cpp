#include "ui/view/shadow_caster.h"

namespace tactum {

std::vector<Vec3> keptOf(const std::array<Vec3, 3>& corners, const std::optional<SectionPlane>& section) {
    if (!section) return {corners.begin(), corners.end()};
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % 3];
        const double heightA = section->height(a), heightB = section->height(b);
        if (heightA <= 0) kept.push_back(a);
        if ((heightA <= 0) != (heightB <= 0)) kept.push_back(a + heightA / (heightA - heightB) * (b - a));
    }
    return kept;
}

} // namespace tactum
