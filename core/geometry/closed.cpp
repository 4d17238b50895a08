#include "core/geometry/closed.h"

#include <bit>

namespace tactum {
namespace {

/// The finalizer of splitmix64: every bit of the input changes half of the output's.
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

std::uint64_t placeHash(const Vec3& p) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i)
        hash = mixed(hash + 0x9e3779b97f4a7c15 + std::bit_cast<std::uint64_t>(p[i] + 0.0)); // -0 becomes 0
    return hash;
}

std::uint64_t edgeHash(std::uint64_t from, std::uint64_t to) {
    return mixed(from + 3 * to);
}

} // namespace

bool isClosed(const TriangleSoup& soup) {
    std::vector<std::uint64_t> place(soup.positions.size());
    for (std::size_t i = 0; i < place.size(); ++i)
        place[i] = placeHash(soup.positions[i]);

    std::uint64_t open = 0; // each edge minus its counterpart
    double volume = 0;      // six times it
    for (const auto& corners : soup.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t from = place[corners[i]], to = place[corners[(i + 1) % 3]];
            open += edgeHash(from, to) - edgeHash(to, from);
        }
        const auto& at = soup.positions;
        const Vec3& origin = at[soup.triangles[0][0]];
        volume += (at[corners[0]] - origin).dot((at[corners[1]] - origin).cross(at[corners[2]] - origin));
    }
    return open == 0 && volume > 0;
}

} // namespace tactum
