// What GL's calls gather: corners and matrices. For this folder.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/hl/hl.h"

namespace hl {

/// Columns of the turning and scaling part, and the way: x' = a x + b.
struct Matrix {
    std::array<Vec, 3> a{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    Vec b{};

    Vec apply(const Vec& v) const;
    Vec direction(const Vec& v) const;
    Matrix operator*(const Matrix& inner) const;

    static Matrix ofTranslation(const Vec& way);
    static Matrix ofRotation(double degrees, const Vec& axis);
    static Matrix ofScale(const Vec& scale);
};

/// A matrix as a turn, a way and scales along the axes of the model. A sheared one is not possible: `rigid`
/// is false then.
struct Placement {
    Place place;
    Vec scale{1, 1, 1};
    bool possible = true;
};
Placement placementOf(const Matrix& matrix);

struct Corner {
    Vec position{};
    std::array<float, 3> normal{};
    std::array<float, 2> uv{};
};

/// Triangles, a corner for each of their corners.
struct Model {
    std::vector<Corner> corners;
    bool normals = false, uvs = false;

    bool empty() const { return corners.empty(); }
};

/// Corners as they were said, as triangles; `corners` is what came between begin() and end().
void appendTriangles(Model& model, Mode mode, const std::vector<Corner>& corners);

/// The bytes that the protocol wants, with each position once.
struct MeshBytes {
    std::uint64_t positions = 0, triangles = 0;
    std::string bytes;
};
MeshBytes bytesOf(const Model& model, const Vec& scale);

} // namespace hl
