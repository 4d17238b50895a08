// What a ray through the view meets, answered by the bounding-sphere hierarchy.
#pragma once

#include <future>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/collision/sphere_tree.h"
#include "core/haptics/body_places.h"
#include "core/scene/scene.h"
#include "core/scene/surface_ref.h"
#include "ui/view/section_plane.h"
#include "ui/view/view_camera.h"

namespace tactum {

struct PickHit {
    SurfaceRef surface;
    Index triangle = 0;          ///< of the object's geometry
    Vec3 point = Vec3::Zero();   ///< world frame
    Vec3 normal = Vec3::UnitZ(); ///< of the triangle by the order of its corners, world frame, unit length
    double distance = 0;         ///< from the ray's origin, m
};

/// Points that span a scene in the world frame: enough to fit a view to it, few enough to do so at once.
std::vector<Vec3> spanningPoints(const Scene& scene);

/// Keeps a hierarchy for each geometry of a scene, built aside on other threads. Thread: ui.
class ScenePicker {
public:
    /// A hierarchy that is still being built is not asked, or is waited for.
    enum class Patience { Now, Wait };

    /// Geometry that was there before keeps its hierarchy.
    void setScene(const Scene& scene);
    const Bounds& bounds() const { return bounds_; }
    /// Objects are elsewhere now, until the next scene; bounds() stays as it was.
    void put(std::span<const PlacedObject> places);
    /// All others are where the scene has them.
    void putNoOthers(std::span<const PlacedObject> places);

    /// What it cuts away is not there for a ray; nothing: all is whole.
    void setSection(const std::optional<SectionPlane>& plane) { section_ = plane; }

    /// The nearest visible surface along the ray, within `reach`, m.
    std::optional<PickHit> cast(const Ray& ray, Patience patience,
                                double reach = std::numeric_limits<double>::infinity()) const;
    /// The geometry of an object; null when it is not there.
    std::shared_ptr<const TriangleSoup> soupOf(ObjectId object) const;
    /// Whether nothing lies between two points. World frame.
    bool isFree(const Vec3& from, const Vec3& to) const;
    /// Whether not even a visible body's box does: known at once, whatever is still being built.
    bool isClear(const Vec3& from, const Vec3& to) const;

private:
    using Tree = std::shared_future<std::shared_ptr<const SphereTree>>;
    struct Target {
        ObjectId object;
        Pose pose; ///< X_WB
        std::shared_ptr<const TriangleSoup> soup;
        Tree tree;
        bool visible;
        std::vector<Sides> sides;       ///< None for surfaces that are not visible
        Bounds box;                     ///< world frame
        std::optional<Bounds> own = {}; ///< body frame; of one that was put elsewhere
        Pose rest = {};                 ///< X_WB, where the scene has it
    };

    static void put(Target& target, const Pose& pose);
    using Known = std::unordered_multimap<std::size_t, const Target*>;
    Target targetOf(const SceneObject& object, const Known& known) const;
    /// Trees for targets that have none, on another thread.
    void buildTrees(std::vector<Target>& targets);
    /// From where to where a ray goes through what is there of a box; an empty span: it does not.
    std::pair<double, double> spanOf(const Bounds& box, const Ray& ray) const;
    std::optional<PickHit> castAt(const Target& target, const Ray& ray, double reach) const;

    std::vector<Target> targets_;
    std::vector<std::future<void>> builders_;
    Bounds bounds_;
    std::optional<SectionPlane> section_;
};

} // namespace tactum
