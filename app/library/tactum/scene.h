// A scene: opened or made of arrays, changed, touched and written.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tactum/error.h>
#include <tactum/export.h>
#include <tactum/preset.h>
#include <tactum/surface.h>
#include <tactum/vec.h>

namespace tactum::library {

// Thread of everything here: any but real time, one at a time for one scene.

/// Three places in the vertices, counter-clockwise from the front.
using Triangle = std::array<std::uint32_t, 3>;

/// A mesh of a scene, with its place and its surfaces: what is set here changes the scene. It is an Error to
/// ask one that is not in the scene any more.
class TACTUM_API Object {
public:
    Object(const Object&) = default; // as Layer
    Object& operator=(const Object&) = default;

    /// Names it for its whole life, from 1: Contact::object.
    std::uint32_t id() const noexcept { return id_; }
    std::string name() const;
    /// Where its frame is, at the time 0.
    Pose pose() const;
    /// With what hangs on it. Error: farther than 1e6 m, or a rotation without a length.
    void setPose(const Pose& pose);
    void setVisible(bool visible); ///< else it is neither seen nor felt

    std::vector<Vec3> vertices() const; ///< m, its own frame; a copy
    std::vector<Triangle> triangles() const;

    std::vector<Surface> surfaces() const;
    /// The first one of this name. Error: there is none.
    Surface surface(std::string_view name) const;
    /// A number of all its surfaces: Surface::set().
    void set(std::string_view key, double value);
    void apply(const Preset& preset); ///< to all its surfaces

private:
    friend struct Parts;
    TACTUM_INTERNAL Object(std::shared_ptr<SceneState> scene, std::uint32_t id);

    std::shared_ptr<SceneState> scene_;
    std::uint32_t id_;
};

/// How a file is taken that says neither unit nor axis.
struct OpenOptions {
    double unit = 1;             ///< m that one unit of it is, from 1e-6 to 1e6
    bool zUp = false;            ///< z points up in it, else y
    std::optional<double> fit{}; ///< m, that the diagonal of the scene is made, from 1e-6 to 1e6
};

/// What a finger felt at one row of a path. World frame, SI.
struct TouchRow {
    double t = 0; ///< s
    Vec3 finger;
    Vec3 proxy;                 ///< which stays outside
    Vec3 force;                 ///< N on the finger, before any device's limit
    std::uint32_t contacts = 0; ///< planes that push

    bool operator==(const TouchRow&) const = default;
};

/// What can be touched: objects with surfaces, in SI units, y up. A copy is a scene of its own, which is
/// cheap: meshes are shared. One that was moved from can only be assigned to or destroyed; else it is an
/// Error.
class TACTUM_API Scene {
public:
    Scene(); ///< an empty one
    /// Any file that the program opens: glTF, bundles, OBJ, PLY, STL, OFF, X3D, FBX, DAE, 3DS, 3MF. It is
    /// read by a process of its own, tactum-import, that a broken file cannot leave. Error: file, place and
    /// remedy.
    static Scene open(const std::filesystem::path& file, const OpenOptions& options = {});
    Scene(const Scene& other);
    Scene(Scene&& other) noexcept;
    Scene& operator=(const Scene& other);
    Scene& operator=(Scene&& other) noexcept;
    ~Scene();

    std::vector<Object> objects() const;
    /// The first one of this name. Error: there is none.
    Object object(std::string_view name) const;
    /// A new object. `surfaces`: of each triangle the place of its surface, below 10000; empty: all have one.
    /// What is at fault with the mesh is repaired as in a file and told in findings(). Error: arrays that are
    /// no mesh.
    Object addMesh(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                   std::span<const std::uint32_t> surfaces = {}, std::string_view name = "mesh");
    void remove(const Object& object); ///< with what hangs on it

    /// A number of the scene ("proxy-radius" in m, "air-density", "force-scale", "time-scale") or of all
    /// surfaces.
    void set(std::string_view key, double value);
    double get(std::string_view key) const; ///< of the scene alone
    void apply(const Preset& preset);       ///< to all surfaces

    /// The stroke that shows what there is to feel; empty where there is none.
    std::vector<FingerPoint> path() const;
    /// Error: times that do not rise, a number that is not finite, a place farther than 1e6 m.
    void setPath(std::span<const FingerPoint> path);

    /// What the reader repaired, left out or doubts, a sentence each.
    std::vector<std::string> findings() const;
    /// What may be wrong with it, a sentence each: what `tactum check` says.
    std::vector<std::string> check() const;

    /// What is felt along a path, to the bit what `tactum touch` says; an empty one is the scene's own.
    /// Error: no path.
    std::vector<TouchRow> touch(std::span<const FingerPoint> path = {}) const;

    /// As .glb, which opens again bit for bit; whole or not at all.
    void save(const std::filesystem::path& file) const;
    /// Written by the ending: .glb, .gltf, .tactum or .zip (bundles), .x3d, .obj, .ply, .stl, .off. What is
    /// degraded or lost there, a sentence each.
    std::vector<std::string> convert(const std::filesystem::path& file) const;

private:
    friend struct Parts;
    TACTUM_INTERNAL explicit Scene(std::shared_ptr<SceneState> state);

    std::shared_ptr<SceneState> state_;
};

/// A scene with the finger path that proves how it feels.
struct Bundle {
    Scene scene;
    std::vector<FingerPoint> finger;
    std::vector<Vec3> forces; ///< N: what each of its points must feel, before any device's limit
};

/// Opens a .tactum or .zip that the program has exported. Error: a file that is missing, changed, or no
/// bundle.
TACTUM_API Bundle openBundle(const std::filesystem::path& file);

} // namespace tactum::library
