#include "ui/view/occlusion_bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/closed.h"
#include "ui/view/cube_distances.h"

namespace tactum {

namespace {

constexpr int kMargin = 3;            ///< cubes about the scene
constexpr int kNear = 3;              ///< cubes: farther off a surface nothing is looked up
constexpr float kBehind = 0.3F;       ///< the cosine from which on a cube is seen from behind for sure
constexpr int kDirections = 64;       ///< in which cubes beside each other look around,
constexpr int kTurns = 4;             ///< each in every fourth of them
constexpr double kSamplesApart = 0.5; ///< cubes, of the points that stand for a triangle

/// A direction in which a cube looks.
struct Look {
    Eigen::Vector3f toward;
    float stride; ///< cubes, on the way of one cube along the axis that it goes along most
};

/// Evenly over the sphere, on a spiral of the golden angle.
std::array<Look, kDirections> looks() {
    std::array<Look, kDirections> all;
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int i = 0; i < kDirections; ++i) {
        const double y = 1 - (2 * i + 1.0) / kDirections, across = std::sqrt(1 - y * y);
        const Vec3 toward(across * std::cos(golden * i), y, across * std::sin(golden * i));
        all[std::size_t(i)] = {toward.cast<float>(), float(1 / toward.cwiseAbs().maxCoeff())};
    }
    return all;
}

/// Points all over a triangle, in cubes.
template <class Visit> void forEachPoint(const std::array<Vec3, 3>& corners, Visit visit) {
    const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
    const int steps = std::max(1, int(std::ceil(longest / kSamplesApart)));
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; k <= steps - i; ++k)
            visit(corners[0] + (double(i) * a + double(k) * b) / steps);
}

/// Of a cube: the direction that it is open toward, and the mean.
using Light = Eigen::Vector4f;
const Light kOpen(0, 0, 0, 1);

/// Cubes that hold surfaces, and which way these face.
struct SolidCubes {
    explicit SolidCubes(const std::array<int, 3>& count)
        : distances(count), facing(distances.size(), Eigen::Vector3f::Zero()) {}

    /// `corners`: in cubes.
    void add(const std::array<Vec3, 3>& corners) {
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
        forEachPoint(corners, [&](const Vec3& p) {
            if (const auto cube = distances.put(p)) facing[*cube] += normal.cast<float>();
        });
    }

    /// After all was added.
    void finish() {
        distances.spread();
        for (Eigen::Vector3f& normal : facing)
            if (const float length = normal.norm(); length > 0) normal /= length;
    }

    CubeDistances distances;
    std::vector<Eigen::Vector3f> facing; ///< the sum of the normals at its points, at last of unit length
};

/// Looks around from each cube near a surface.
class Bake {
public:
    /// `reach`: in cubes.
    Bake(const SolidCubes& solid, double reach)
        : distances_(solid.distances), facing_(solid.facing), outside_(distances_.reached()),
          reach_(float(reach)) {}

    /// Nothing for cancelled work. What some rays miss of small things is smoothed away; cubes that hold a
    /// surface, from which nothing is seen, are as dark as those about them, and dark where there are none.
    std::optional<std::vector<Light>> lights(const Progress& progress) const {
        std::vector<Light> all(distances_.size(), kOpen);
        ProgressMeter meter(progress, all.size(), 1 << 12);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!meter.goesOn(i)) return std::nullopt;
            if (!outside_[i])
                all[i] = Light::Zero();
            else if (isNear(i))
                all[i] = around(distances_.cubeOf(i));
        }
        all = averaged(all, [this](std::size_t i) { return isNear(i); });
        return averaged(all, [this](std::size_t i) { return distances_.at(i) == 0; });
    }

private:
    /// The outermost ones are open: they stand for all that lies beyond, as where something goes that moves.
    bool isNear(std::size_t cube) const {
        return distances_.at(cube) > 0 && distances_.at(cube) <= kNear && !distances_.isOutermost(cube);
    }

    /// The cubes about it have the other directions, and the mean of them all is taken.
    Light around(const Eigen::Vector3i& cube) const {
        const Eigen::Vector3f middle = cube.cast<float>().array() + 0.5F;
        Light light = Light::Zero();
        for (std::size_t i = std::size_t((cube.x() + 2 * cube.y() + 3 * cube.z()) % kTurns);
             i < looks_.size(); i += kTurns) {
            const float open = openTo(middle, looks_[i]) * kTurns / kDirections;
            light.head<3>() += 2 * open * looks_[i].toward;
            light[3] += open;
        }
        return light;
    }

    /// In steps over what is known to be empty. Who sees a surface from behind is inside of something.
    float openTo(const Eigen::Vector3f& from, const Look& look) const {
        const float end = std::min(reach_, distances_.wayOut(from, look.toward));
        for (float far = 0; far < end;) {
            const std::size_t cube = distances_.indexOf((from + far * look.toward).cast<int>());
            const int empty = distances_.at(cube);
            if (empty == 0) {
                const bool behind = facing_[cube].dot(look.toward) > kBehind;
                return behind ? 0 : std::min(1.F, far * far / (reach_ * reach_));
            }
            far += std::max(0.5F, float(empty - 1) * look.stride);
        }
        return 1;
    }

    /// Those that are wanted, of the near ones about them.
    template <class Wanted> std::vector<Light> averaged(const std::vector<Light>& from, Wanted wanted) const {
        std::vector<Light> all = from;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!wanted(i)) continue;
            Light sum = isNear(i) ? from[i] : Light::Zero();
            float count = isNear(i);
            distances_.forEachNeighbour(i, [&](std::size_t other) {
                if (!isNear(other)) return;
                sum += from[other];
                ++count;
            });
            if (count > 0) all[i] = sum / count;
        }
        return all;
    }

    const CubeDistances& distances_;
    const std::vector<Eigen::Vector3f>& facing_;
    const std::vector<bool> outside_; ///< no light comes into a closed surface
    const float reach_;
    const std::array<Look, kDirections> looks_ = looks();
};

std::uint8_t byteOf(float part) {
    return std::uint8_t(std::lround(255 * std::clamp(part, 0.F, 1.F)));
}

/// What is left of each triangle of what stands still.
template <class Visit>
bool forEachStanding(std::span<const ShadowCaster> casters, const Progress& progress, Visit visit) {
    std::vector<ShadowCaster> standing(casters.begin(), casters.end());
    std::erase_if(standing, [](const ShadowCaster& caster) { return caster.moves; });
    return forEachTriangle(standing, progress, [&](const auto& corners, const auto& section) {
        const std::vector<Vec3> kept = keptOf(corners, section);
        for (std::size_t i = 2; i < kept.size(); ++i)
            visit(std::array<Vec3, 3>{kept[0], kept[i - 1], kept[i]});
    });
}

OcclusionVolume gridAround(const Bounds& box, int along) {
    OcclusionVolume volume;
    const Vec3 size = box.high - box.low;
    volume.voxel = size.maxCoeff() / along;
    if (!(volume.voxel > 0)) return volume;
    volume.corner = box.low - Vec3::Constant(kMargin * volume.voxel);
    for (int i = 0; i < 3; ++i)
        volume.count[std::size_t(i)] = int(size[i] / volume.voxel) + 1 + 2 * kMargin;
    return volume;
}

/// Larger meshes are not asked whether they are convex.
constexpr std::size_t kFewTriangles = 2000;

/// Whether it has an inside, and no corner lies before any of its faces.
bool isConvex(const TriangleSoup& soup) {
    if (soup.triangles.size() > kFewTriangles || !isClosed(soup)) return false;
    const Bounds box = boundsOf(soup);
    const double flat = 1e-6 * (box.high - box.low).norm();
    for (const auto& [a, b, c] : soup.triangles) {
        const Vec3& at = soup.positions[a];
        const Vec3 normal = (soup.positions[b] - at).cross(soup.positions[c] - at).stableNormalized();
        for (const Vec3& corner : soup.positions)
            if (normal.dot(corner - at) > flat) return false;
    }
    return true;
}

/// Of a convex body no part takes light from another.
bool isConvexAlone(std::span<const ShadowCaster> casters) {
    const ShadowCaster* alone = nullptr;
    for (const ShadowCaster& caster : casters) {
        if (caster.moves) continue;
        if (alone || caster.section || std::ranges::find(caster.seen, false) != caster.seen.end())
            return false;
        alone = &caster;
    }
    return alone && isConvex(*alone->soup);
}

} // namespace

std::optional<OcclusionVolume> occlusionOf(std::span<const ShadowCaster> casters, const Progress& progress,
                                           const OcclusionDetail& detail) {
    if (isConvexAlone(casters)) return OcclusionVolume{};
    Bounds box;
    const auto addToBox = [&](const std::array<Vec3, 3>& corners) {
        for (const Vec3& corner : corners)
            box.add(corner);
    };
    if (!forEachStanding(casters, progress, addToBox)) return std::nullopt;
    if (box.empty()) return OcclusionVolume{};
    OcclusionVolume volume = gridAround(box, detail.along);
    if (!(volume.voxel > 0)) return OcclusionVolume{};
    SolidCubes solid(volume.count);
    const auto fill = [&](std::array<Vec3, 3> corners) {
        for (Vec3& corner : corners)
            corner = (corner - volume.corner) / volume.voxel;
        solid.add(corners);
    };
    if (!forEachStanding(casters, progress, fill)) return std::nullopt;
    solid.finish();
    const auto lights = Bake(solid, detail.reach * detail.along).lights(progress);
    if (!lights) return std::nullopt;
    volume.values.reserve(4 * lights->size());
    for (const Light& light : *lights)
        for (int k = 0; k < 4; ++k)
            volume.values.push_back(byteOf(k < 3 ? 0.5F + light[k] : light[k]));
    return volume;
}

double OcclusionVolume::openness(const Vec3& p_W, const Vec3& normal_W) const {
    if (empty()) return 1;
    const Vec3 at = (p_W + offset() * normal_W - corner) / voxel - Vec3::Constant(0.5);
    const Vec3 low = at.array().floor();
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int i = 0; i < 8; ++i) {
        double weight = 1;
        std::size_t index = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const int up = i >> axis & 1, cubes = count[std::size_t(axis)];
            weight *= up ? at[axis] - low[axis] : 1 - (at[axis] - low[axis]);
            index = index * std::size_t(cubes) + std::size_t(std::clamp(int(low[axis]) + up, 0, cubes - 1));
        }
        for (int k = 0; k < 4; ++k)
            sum[k] += weight * values[4 * index + std::size_t(k)] / 255;
    }
    const Vec3 toward = sum.head<3>() - Vec3::Constant(0.5);
    return std::clamp(sum[3] + toward.dot(normal_W), 0.0, 1.0);
}

} // namespace tactum
