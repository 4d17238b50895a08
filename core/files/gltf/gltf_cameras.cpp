#include "core/files/gltf/gltf_cameras.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/text.h"
#include "core/files/gltf/gltf_nodes.h"
#include "core/files/gltf/gltf_physics_values.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;

/// What other programs draw: parts of the way to what the camera looks at.
constexpr double kNearest = 1e-3, kFarthestParallel = 10;
/// Width for height of a parallel one: of a screen, for Blender makes its picture as wide as `xmag` says, and
/// as high as the picture's own form leaves.
constexpr double kWide = 16.0 / 9;

double numberOf(const Json* holder, const char* key) {
    return holder ? numberIn(*holder, key).value_or(0) : 0;
}

const char* lensOf(bool parallel) {
    return parallel ? "orthographic" : "perspective";
}

/// Without name and place; what the file does not say becomes 0, with which nothing is seen.
SavedCamera lensOf(const Json& json) {
    SavedCamera camera;
    const Json* type = member(json, "type");
    camera.parallel = type && *type == lensOf(true);
    const Json* lens = member(json, lensOf(camera.parallel));
    if (camera.parallel)
        camera.height = 2 * numberOf(lens, "ymag");
    else
        camera.angle = numberOf(lens, "yfov");
    camera.near = numberOf(lens, "znear");
    camera.far = numberOf(lens, "zfar");
    if (camera.far > 0 && camera.far <= camera.near)
        camera.near = camera.far = 0; // no way to see between them
    return camera;
}

/// As cameraJson() writes the planes of one that says none.
bool isAsItSuits(const SavedCamera& camera) {
    return camera.near == kNearest * camera.ahead &&
           camera.far == (camera.parallel ? kFarthestParallel * camera.ahead : 0);
}

class CameraWalk {
public:
    CameraWalk(const Source& source, const tinygltf::Model& model, const Json& root,
               const GltfMotions& motions, std::vector<Finding>& findings)
        : source_(source), model_(model), root_(root), motions_(motions), findings_(findings) {}

    std::vector<PlacedCamera> run() {
        for (const int node : sceneRoots(model_))
            visit(node, Affine::Identity(), true);
        return std::move(placed_);
    }

private:
    void visit(int index, const Affine& parent, bool isRoot) {
        const Json& node = root_["nodes"][std::size_t(index)];
        if (motions_.moves(index) || extensionOf(node, kPhysicsExtension)) return;
        const Affine here = parent * motions_.localAt(index, 0);
        if (member(node, "camera") && !member(node, "mesh")) place(index, node, here, isRoot);
        for (const int child : model_.nodes[std::size_t(index)].children)
            visit(child, here, false);
    }

    void place(int index, const Json& node, const Affine& here, bool isRoot) {
        const Json* all = member(root_, "cameras");
        const int camera = indexIn(node, "camera", all && all->is_array() ? all->size() : 0);
        PlacedCamera placed{{}, index, camera};
        if (camera >= 0) placed.camera = lensOf((*all)[std::size_t(camera)]);
        SavedCamera& read = placed.camera;
        read.name = wantedName(node, camera < 0 ? Json() : (*all)[std::size_t(camera)]);
        read.pose = isRoot && !member(node, "matrix")
                        ? rigidOf(source_, model_, index) // to the bit
                        : Pose{Quat(polarDecomposition(here.linear()).rotation).normalized(),
                               Vec3(here.translation())};
        const Json* ours = extensionOf(node);
        if (ours) read.pose = exactPose(*ours, read.pose).value_or(read.pose);
        const double ahead = numberOf(ours, "ahead");
        if (camera < 0) return leaveOut(read.name, "is none of the cameras of the file");
        if (!isCamera(read)) return leaveOut(read.name, "has no lens that anything could be seen by");
        if (placed_.size() >= kMaxCameras) return leaveOut(read.name, "is one more than there can be");
        read.name = freeName(read.name);
        read.ahead = ahead;
        if (isAsItSuits(read)) read.near = read.far = 0;
        placed_.push_back(std::move(placed));
    }

    void leaveOut(const std::string& name, const char* what) {
        findings_.push_back({Finding::Severity::Warning, "", "camera " + inQuotes(name) + " " + what,
                             "left out; give it another one where it comes from, and export it again"});
    }

    static std::string wantedName(const Json& node, const Json& camera) {
        std::string wanted;
        for (const Json* each : {&node, &camera})
            if (const Json* name = member(*each, "name"); name && name->is_string() && wanted.empty())
                wanted = printable(name->get<std::string>(), kLongestName);
        return wanted.empty() ? "camera" : wanted;
    }

    /// Of those that are kept, which are few: looking for one takes a step for each that has the same.
    std::string freeName(const std::string& wanted) {
        std::string name = wanted;
        for (int i = 2; !taken_.insert(name).second; ++i)
            name = wanted + " " + std::to_string(i);
        return name;
    }

    const Source& source_;
    const tinygltf::Model& model_;
    const Json& root_;
    const GltfMotions& motions_;
    std::vector<Finding>& findings_;
    std::set<std::string> taken_;
    std::vector<PlacedCamera> placed_;
};

} // namespace

std::vector<PlacedCamera> placedCameras(const Source& source, const tinygltf::Model& model, const Json& root,
                                        const GltfMotions& motions, std::vector<Finding>& findings) {
    return CameraWalk(source, model, root, motions, findings).run();
}

Json cameraJson(const SavedCamera& camera) {
    Json json =
        camera.keptCamera.json ? Json::parse(*camera.keptCamera.json, nullptr, false) : Json::object();
    if (!json.is_object()) json = Json::object();
    if (!camera.keptCamera.json) json["name"] = camera.name;
    json["type"] = lensOf(camera.parallel);
    json.erase(lensOf(!camera.parallel));
    Json& lens = json[lensOf(camera.parallel)];
    if (!lens.is_object()) lens = Json::object();
    if (numberIn(lens, "aspectRatio").value_or(1) <= 0) lens.erase("aspectRatio");
    const bool nearest = camera.near > 0 || (camera.parallel && camera.far > 0); // 0 is one of a parallel one
    lens["znear"] = nearest ? camera.near : kNearest * camera.ahead;
    if (!camera.parallel) {
        lens["yfov"] = camera.angle;
        lens.erase("zfar");
        if (camera.far > 0) lens["zfar"] = camera.far;
        return json;
    }
    const double before = numberOf(&lens, "ymag");
    const double wide = before > 0 ? numberIn(lens, "xmag").value_or(before) / before : kWide;
    lens["ymag"] = 0.5 * camera.height;
    lens["xmag"] = 0.5 * camera.height * (wide > 0 && std::isfinite(wide) ? wide : kWide);
    lens["zfar"] = camera.far > 0 ? camera.far : kFarthestParallel * camera.ahead;
    return json;
}

Json cameraNodeJson(const SavedCamera& camera) {
    const Json standing = nodePoseJson(camera.pose);
    const bool isExact = standing == poseJson(camera.pose);
    Json node{{"name", camera.name},
              {"extensions",
               {{kExtension,
                 {{"role", kCameraRole},
                  {"ahead", camera.ahead},
                  {"pose", isExact ? Json(nullptr) : poseJson(camera.pose)}}}}}};
    node.update(standing);
    return node;
}

} // namespace tactum
