// Meshes from formulas, piece by piece.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace tactum::samples {

using Uv = Eigen::Vector2f;

class Mesh {
public:
    /// Rounded to 1 nm, so that a mesh closes where its formula comes round, and to the numbers of glTF
    /// files, so that a scene is what its file says.
    Index point(const Vec3& p, const Uv& uv = Uv::Zero());
    void triangle(Index a, Index b, Index c, Index surface = 0);
    /// Counter-clockwise seen from outside, as all here.
    void quad(Index a, Index b, Index c, Index d, Index surface = 0);
    void box(const Vec3& low, const Vec3& high, Index surface = 0);
    void box(const Vec3& low, const Vec3& high, const Pose& place, Index surface = 0);
    /// Cells between the lines `us` and `vs`; a cell asks for its surface with its middle. Where the mesh has
    /// texture coordinates, `uvAt` gives them.
    using Place = std::function<Vec3(double u, double v)>;
    using SurfaceAt = std::function<Index(double u, double v)>;
    using UvAt = std::function<Uv(double u, double v)>;
    void grid(const std::vector<double>& us, const std::vector<double>& vs, const Place& place,
              const SurfaceAt& surfaceAt = {}, const UvAt& uvAt = {});

    /// Closes a rim, counter-clockwise seen from outside, with triangles that meet at `apex`.
    void fan(const Vec3& apex, const std::vector<Vec3>& rim, Index surface = 0,
             const std::function<Uv(const Vec3&)>& uvAt = {});

    /// With normals where it has texture coordinates: programs show a bump only where there are both. They
    /// are the mean of the facets around a corner, but for those beyond an edge of more than 30 degrees.
    std::shared_ptr<const TriangleSoup> soup() const;

private:
    TriangleSoup soup_;
    std::vector<Uv> uvs_;
    bool hasUvs_ = false;
};

/// `count` even steps from `low` to `high`.
std::vector<double> evenly(double low, double high, int count);

Surface surface(std::string name, const Eigen::Vector3f& colour, const Material& material = {});
SceneObject object(std::string name, const Mesh& mesh, std::vector<Surface> surfaces);

/// 0 below `low`, 1 above `high`, smooth between.
double smoothStep(double low, double high, double x);

} // namespace tactum::samples
