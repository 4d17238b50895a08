#include "tests/benchmarks/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numbers>
#include <unordered_map>

namespace tactum::bench {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// The box of the sphere has a diagonal of 0.2 m; that of the height field's square and hills as well.
const double kSphereRadius = 0.1 / std::numbers::sqrt3;
constexpr double kFieldSide = 0.14;

// Noise in [-1, 1) that depends on nothing but the place: a mixer of bits (the finaliser of SplitMix64).
double roughness(int i, int j) {
    std::uint64_t h = (std::uint64_t(i) << 32 | std::uint32_t(j)) + 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    return double((h ^ (h >> 31)) >> 11) * 0x1p-52 - 1;
}

// Hills, ridges and bumps, each with slopes of about 0.4.
double hills(double x, double y) {
    return 5.5e-3 * std::sin(kTurn * x / 0.09 + 0.4) * std::cos(kTurn * y / 0.1) +
           1.5e-3 * std::sin(kTurn * (0.8 * x + 0.6 * y) / 0.022) +
           0.4e-3 * std::sin(kTurn * (0.6 * x - 0.8 * y) / 0.006);
}

TriangleSoup heightField(int n) {
    const double cell = kFieldSide / n;
    TriangleSoup soup;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = i * cell - kFieldSide / 2, y = j * cell - kFieldSide / 2;
            soup.positions.emplace_back(x, y, hills(x, y) + 0.05 * cell * roughness(i, j));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = Index(j * (n + 1) + i), b = a + 1, c = b + Index(n) + 1, d = c - 1;
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
        }
    return soup;
}

// Points of the cube's surface lattice, each made once however many sides share it.
class CubeLattice {
public:
    CubeLattice(int n, std::vector<Vec3>& positions) : n_(n), positions_(positions) {}

    Index at(const std::array<int, 3>& place) {
        const std::uint64_t size = std::uint64_t(n_) + 1;
        const std::uint64_t key =
            (std::uint64_t(place[0]) * size + std::uint64_t(place[1])) * size + std::uint64_t(place[2]);
        const auto [entry, isNew] = indexOf_.try_emplace(key, Index(positions_.size()));
        if (isNew) {
            const Vec3 onCube(even(place[0]), even(place[1]), even(place[2]));
            positions_.push_back(kSphereRadius * onCube.normalized());
        }
        return entry->second;
    }

private:
    // Equal angles instead of equal lengths: triangles in the middle of a side and at its rim are alike.
    double even(int i) const { return std::tan(std::numbers::pi / 4 * (2.0 * i / n_ - 1)); }

    int n_;
    std::vector<Vec3>& positions_;
    std::unordered_map<std::uint64_t, Index> indexOf_;
};

TriangleSoup sphere(int n) {
    TriangleSoup soup;
    CubeLattice lattice(n, soup.positions);
    // The side where coordinate `axis` is 0 or n; u and v run so that the corners turn outward.
    auto side = [&](int axis, bool high) {
        const int u = (axis + (high ? 1 : 2)) % 3, v = 3 - axis - u;
        auto corner = [&](int a, int b) {
            std::array<int, 3> place{};
            place[std::size_t(axis)] = high ? n : 0;
            place[std::size_t(u)] = a;
            place[std::size_t(v)] = b;
            return lattice.at(place);
        };
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) {
                const Index p = corner(a, b), q = corner(a + 1, b), r = corner(a + 1, b + 1);
                soup.triangles.push_back({p, q, r});
                soup.triangles.push_back({p, r, corner(a, b + 1)});
            }
    };
    for (int axis = 0; axis < 3; ++axis)
        for (bool high : {false, true})
            side(axis, high);
    return soup;
}

// A place on a surface and the direction from which the finger comes there.
struct Base {
    Vec3 point, outward;
};

Base overSphere(double s) {
    const double latitude = 1.05 * std::sin(kTurn * 5 * s), longitude = kTurn * 8 * s;
    const Vec3 u(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                 std::cos(latitude) * std::sin(longitude));
    return {kSphereRadius * u, u};
}

Base overField(double s) {
    const double reach = 0.43 * kFieldSide;
    const double x = reach * std::sin(kTurn * 5 * s), y = reach * std::sin(kTurn * 8 * s + 0.5);
    return {{x, y, hills(x, y)}, Vec3::UnitZ()};
}

std::vector<FingerPoint> along(const std::function<Base(double)>& base) {
    constexpr int kRows = 20000, kApproach = 167;
    constexpr double kStep = 1e-3, kStride = 0.15 * kStep, kProbe = 1e-7;
    std::vector<FingerPoint> path;
    double s = 0;
    for (int row = 0; row < kRows; ++row) {
        const Base now = base(s);
        double depth = -20e-3 + kStride * row;
        if (row >= kApproach) {
            depth = 4e-3 + 4e-3 * std::sin(kTurn * 0.5 * kStep * (row - kApproach) + std::asin(0.25));
            s += kStride * kProbe / (base(s + kProbe).point - now.point).norm();
        }
        path.push_back({row * kStep, now.point - depth * now.outward});
    }
    return path;
}

template <class T> void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

std::size_t GeneratedShape::triangles() const {
    return std::size_t(family == Family::Sphere ? 12 : 2) * std::size_t(n) * std::size_t(n);
}

std::string GeneratedShape::name() const {
    const double thousands = double(triangles()) / 1000;
    char text[32];
    std::snprintf(text, sizeof text, thousands < 900 ? "%s-%.0fk" : "%s-%.1fM",
                  family == Family::Sphere ? "sphere" : "height",
                  thousands < 900 ? thousands : thousands / 1000);
    return text;
}

const std::vector<GeneratedShape>& generatedShapes() {
    static const std::vector<GeneratedShape> shapes{{Family::Sphere, 45},       {Family::Sphere, 91},
                                                    {Family::Sphere, 289},      {Family::Sphere, 577},
                                                    {Family::HeightField, 110}, {Family::HeightField, 224},
                                                    {Family::HeightField, 707}, {Family::HeightField, 1414}};
    return shapes;
}

TriangleSoup soupOf(const GeneratedShape& shape) {
    TriangleSoup soup = shape.family == Family::Sphere ? sphere(shape.n) : heightField(shape.n);
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

std::vector<FingerPoint> fingerOver(Family family) {
    return along(family == Family::Sphere ? overSphere : overField);
}

bool writePly(const TriangleSoup& soup, const std::filesystem::path& file) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(soup.positions.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(soup.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& p : soup.positions)
        append(bytes, std::array<float, 3>{float(p.x()), float(p.y()), float(p.z())});
    for (const auto& corners : soup.triangles) {
        append(bytes, std::uint8_t(3));
        append(bytes, corners);
    }
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    return bool(out.flush());
}

} // namespace tactum::bench
