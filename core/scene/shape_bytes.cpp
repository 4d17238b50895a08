#include "core/scene/shape_bytes.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/geometry/soup_builder.h"

namespace tactum {
namespace {

template <class Io, class Value> void track(Io& io, Track<Value>& t) {
    choose(io, t.interpolation, 3);
    io.bulk(t.times), io.bulk(t.values), io.bulk(t.arriving), io.bulk(t.leaving);
    if constexpr (!Io::kReads) return;
    const std::size_t keys = t.times.size(),
                      slopes = t.interpolation == Interpolation::CubicSpline ? keys : 0;
    io.demand(t.values.size() == keys && t.arriving.size() == slopes && t.leaving.size() == slopes,
              "a motion has not a value for each key");
    io.demand(std::ranges::is_sorted(t.times), "the keys of a motion are not in the order of time");
    const auto finite = [](const Value& v) { return v.allFinite(); };
    io.demand(std::ranges::all_of(t.times, [](double x) { return std::isfinite(x); }) &&
                  std::ranges::all_of(t.values, finite) && std::ranges::all_of(t.arriving, finite) &&
                  std::ranges::all_of(t.leaving, finite),
              "a motion has a number that is not finite");
}

template <class Io> void motion(Io& io, Motion& m) {
    auto& [translation, rotation, duration, jumps, jumpsAtEnd] =
        m; // all members: another one does not compile
    track(io, translation);
    track(io, rotation);
    io(duration);
    io.bulk(jumps);
    io(jumpsAtEnd);
    if constexpr (!Io::kReads) return;
    io.demand(duration >= 0 && std::ranges::is_sorted(jumps), "a motion's times make no sense");
    const auto isTurn = [](const QuatCoefficients& q) { return std::abs(q.norm() - 1) < 1e-6; };
    io.demand(std::ranges::all_of(rotation.values, isTurn), "a rotation is not of unit length");
}

template <class Io> void soup(Io& io, TriangleSoup& s) {
    auto& [positions, triangles, surfaceOf, cornerNormals, cornerUvs] = s;
    io.bulk(positions), io.bulk(triangles), io.bulk(surfaceOf), io.bulk(cornerNormals), io.bulk(cornerUvs);
    if constexpr (!Io::kReads) return;
    const std::size_t corners = 3 * s.triangles.size();
    io.demand(s.surfaceOf.size() == s.triangles.size() &&
                  (s.cornerNormals.empty() || s.cornerNormals.size() == corners) &&
                  (s.cornerUvs.empty() || s.cornerUvs.size() == corners),
              "a mesh has not as many corners as it says");
    for (const Vec3& p : s.positions)
        io.demand(isCoordinate(p.x()) && isCoordinate(p.y()) && isCoordinate(p.z()),
                  "a corner of a mesh is not within 1e6 m");
    for (const auto& triangle : s.triangles)
        for (const Index corner : triangle)
            io.demand(corner < s.positions.size(), "a triangle names a corner that there is not");
    const auto finite = [](const auto& v) { return v.allFinite(); };
    io.demand(std::ranges::all_of(s.cornerNormals, finite) && std::ranges::all_of(s.cornerUvs, finite),
              "a mesh has a number that is not finite");
}

} // namespace

std::vector<std::uint16_t> texelsOf(const TextureImage& image) {
    std::vector<std::uint16_t> texels;
    for (int y = 0; y < image.height(); ++y) {
        const std::uint16_t* row = image.row(y);
        texels.insert(texels.end(), row, row + image.width());
    }
    return texels;
}

void write(ByteOut& out, const TextureImage& image) {
    std::string name = image.name();
    int width = image.width(), height = image.height(), bits = image.bits();
    std::vector<std::uint16_t> texels = texelsOf(image);
    out(name), out(width), out(height), out(bits), out.bulk(texels);
}

std::shared_ptr<const TextureImage> readImage(ByteIn& in) {
    std::string name;
    int width = 0, height = 0, bits = 0;
    std::vector<std::uint16_t> texels;
    in(name), in(width), in(height), in(bits), in.bulk(texels);
    const auto isSide = [](int side) { return side >= 1 && side <= TextureImage::kLargestSide; };
    in.demand(isSide(width) && isSide(height) && texels.size() == std::size_t(width) * std::size_t(height) &&
                  texels.size() <= TextureImage::kMaxTexels,
              "an image has not as many texels as it says");
    return std::make_shared<const TextureImage>(width, height, std::move(texels), printable(name, 200), bits);
}

void write(ByteOut& out, const PaintedValues& painted) {
    std::vector<float> values = painted.all();
    out.bulk(values);
}

std::shared_ptr<const PaintedValues> readPainted(ByteIn& in) {
    std::vector<float> values;
    in.bulk(values);
    in.demand(std::ranges::all_of(values, [](float value) { return value >= 0 && value <= 1; }),
              "a painted value is not from 0 to 1");
    return std::make_shared<const PaintedValues>(std::move(values));
}

void write(ByteOut& out, const TriangleSoup& geometry) {
    soup(out, const_cast<TriangleSoup&>(geometry)); // writing does not touch it
}

std::shared_ptr<const TriangleSoup> readSoup(ByteIn& in) {
    auto read = std::make_shared<TriangleSoup>();
    soup(in, *read);
    return read;
}

void write(ByteOut& out, const Motion& moving) {
    motion(out, const_cast<Motion&>(moving)); // writing does not touch it
}

std::shared_ptr<const Motion> readMotion(ByteIn& in) {
    auto read = std::make_shared<Motion>();
    motion(in, *read);
    return read;
}

} // namespace tactum
