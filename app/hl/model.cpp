#include "app/hl/model.h"

#include <cmath>
#include <map>
#include <numbers>

namespace hl {
namespace {

double length(const Vec& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}
double dot(const Vec& a, const Vec& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec times(double factor, const Vec& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}

/// Of columns of unit length that are square to each other.
Turn turnOf(const std::array<Vec, 3>& c) {
    const double trace = c[0][0] + c[1][1] + c[2][2];
    Turn q;
    if (trace > 0) {
        const double s = 2 * std::sqrt(1 + trace);
        q = {s / 4, (c[1][2] - c[2][1]) / s, (c[2][0] - c[0][2]) / s, (c[0][1] - c[1][0]) / s};
    } else {
        std::size_t i = c[1][1] > c[0][0] ? 1 : 0;
        if (c[2][2] > c[i][i]) i = 2;
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double s = 2 * std::sqrt(1 + c[i][i] - c[j][j] - c[k][k]);
        q[0] = (c[j][k] - c[k][j]) / s;
        q[1 + i] = s / 4;
        q[1 + j] = (c[j][i] + c[i][j]) / s;
        q[1 + k] = (c[k][i] + c[i][k]) / s;
    }
    return q;
}

template <class T> void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

Vec Matrix::direction(const Vec& v) const {
    Vec out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2];
    return out;
}

Vec Matrix::apply(const Vec& v) const {
    const Vec turned = direction(v);
    return {turned[0] + b[0], turned[1] + b[1], turned[2] + b[2]};
}

Matrix Matrix::operator*(const Matrix& inner) const {
    Matrix out;
    for (std::size_t i = 0; i < 3; ++i)
        out.a[i] = direction(inner.a[i]);
    out.b = apply(inner.b);
    return out;
}

Matrix Matrix::ofTranslation(const Vec& way) {
    Matrix out;
    out.b = way;
    return out;
}

Matrix Matrix::ofScale(const Vec& scale) {
    Matrix out;
    for (std::size_t i = 0; i < 3; ++i)
        out.a[i][i] = scale[i];
    return out;
}

Matrix Matrix::ofRotation(double degrees, const Vec& axis) {
    const double size = length(axis), angle = degrees * std::numbers::pi / 180;
    if (!(size > 0)) return {};
    const Vec n = times(1 / size, axis);
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix out;
    for (std::size_t i = 0; i < 3; ++i) {
        Vec e{};
        e[i] = 1;
        const Vec side = cross(n, e);
        for (std::size_t k = 0; k < 3; ++k)
            out.a[i][k] = c * e[k] + s * side[k] + (1 - c) * n[i] * n[k];
    }
    return out;
}

Placement placementOf(const Matrix& matrix) {
    constexpr double kNear = 1e-6;
    Placement out;
    out.place.position = matrix.b;
    std::array<Vec, 3> columns = matrix.a;
    for (std::size_t i = 0; i < 3; ++i) {
        out.scale[i] = length(columns[i]);
        if (!(out.scale[i] > 1e-9 && out.scale[i] < 1e9))
            out.possible = false;
        else
            columns[i] = times(1 / out.scale[i], columns[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(dot(columns[i], columns[(i + 1) % 3])) > kNear) out.possible = false; // sheared
    if (!out.possible) return out;
    if (dot(cross(columns[0], columns[1]), columns[2]) < 0) { // a mirror
        columns[0] = times(-1, columns[0]);
        out.scale[0] = -out.scale[0];
    }
    out.place.turn = turnOf(columns);
    return out;
}

void appendTriangles(Model& model, Mode mode, const std::vector<Corner>& corners) {
    const std::size_t count = corners.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        for (const std::size_t i : {a, b, c})
            model.corners.push_back(corners[i]);
    };
    switch (mode) {
    case Triangles:
        for (std::size_t i = 0; i + 2 < count; i += 3)
            add(i, i + 1, i + 2);
        return;
    case TriangleStrip: // every other one runs the other way
        for (std::size_t i = 0; i + 2 < count; ++i)
            i % 2 == 0 ? add(i, i + 1, i + 2) : add(i + 1, i, i + 2);
        return;
    case Quads:
        for (std::size_t i = 0; i + 3 < count; i += 4)
            add(i, i + 1, i + 2), add(i, i + 2, i + 3);
        return;
    case TriangleFan:
    case Polygon:
        for (std::size_t i = 1; i + 1 < count; ++i)
            add(0, i, i + 1);
    }
}

MeshBytes bytesOf(const Model& model, const Vec& scale) {
    MeshBytes out;
    std::map<Vec, std::uint32_t> known;
    std::vector<std::uint32_t> indices;
    std::string normals, uvs;
    const bool mirrored = scale[0] * scale[1] * scale[2] < 0;
    for (std::size_t i = 0; i < model.corners.size(); ++i) {
        // The other way round where it is mirrored, so that the front stays outside.
        const std::size_t k = mirrored && i % 3 != 0 ? i + (i % 3 == 1 ? 1 : -1) : i;
        const Corner& corner = model.corners[k];
        const Vec p{scale[0] * corner.position[0], scale[1] * corner.position[1],
                    scale[2] * corner.position[2]};
        const auto [place, isNew] = known.try_emplace(p, std::uint32_t(known.size()));
        if (isNew) append(out.bytes, p);
        indices.push_back(place->second);
        const std::array<float, 3> n{float(corner.normal[0] / scale[0]), float(corner.normal[1] / scale[1]),
                                     float(corner.normal[2] / scale[2])};
        append(normals, n);
        append(uvs, corner.uv);
    }
    out.positions = known.size();
    out.triangles = indices.size() / 3;
    for (const std::uint32_t index : indices)
        append(out.bytes, index);
    if (model.normals) out.bytes += normals;
    if (model.uvs) out.bytes += uvs;
    return out;
}

} // namespace hl
