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

/// Why a camera is left out, of one and of several.
struct Reason {
    const char *one, *several;
};
constexpr Reason kNoneOfThem{"is none of the cameras of the file", "are none of the cameras of the file"};
constexpr Reason kNoPlace{"has a place that is none, or beyond 1e6 m",
                          "have a place that is none, or beyond 1e6 m"};
constexpr Reason kNoLens{"has no lens that anything could be seen by",
                         "have no lens that anything could be seen by"};
constexpr Reason kTooMany{"is one more than there can be", "are more than there can be"};

/// As many as a file has of them, in one sentence.
class LeftOutCameras {
public:
    void add(const std::string& name) {
        constexpr std::size_t kNamed = 3;
        if (++count_ <= kNamed) names_ += (names_.empty() ? "" : ", ") + inQuotes(name);
        if (count_ == kNamed + 1) names_ += " and others";
    }
    void say(const Reason& reason, std::vector<Finding>& findings) const {
        if (count_ == 0) return;
        const bool one = count_ == 1;
        const std::string sentence = one ? "camera " + names_ + " " + reason.one
                                         : counted(count_, "camera") + " " + reason.several + ": " + names_;
        findings.push_back({Finding::Severity::Warning, "", sentence,
                            one ? "left out; give it another one where it comes from, and export it again"
                                : "left out; correct them where they come from, and export them again"});
    }

private:
    std::size_t count_ = 0;
    std::string names_;
};

/// Numbers in it that are no such thing say nothing.
bool hasDamagedPlace(const Json& node) {
    return (member(node, "translation") && !vectorIn<3>(node, "translation")) ||
           (member(node, "rotation") && !vectorIn<4>(node, "rotation"));
}

class CameraWalk {
public:
    CameraWalk(const Source& source, const tinygltf::Model& model, const Json& root,
               const GltfMotions& motions)
        : source_(source), model_(model), root_(root), motions_(motions) {}

    std::vector<PlacedCamera> run(std::vector<Finding>& findings) {
        for (const int node : sceneRoots(model_))
            visit(node, Affine::Identity(), true);
        noneOfThem_.say(kNoneOfThem, findings);
        noPlace_.say(kNoPlace, findings);
        noLens_.say(kNoLens, findings);
        tooMany_.say(kTooMany, findings);
        return std::move(placed_);
    }

private:
    /// Nothing for `parent`: what stands on one without a place has none either.
    void visit(int index, const std::optional<Affine>& parent, bool isRoot) {
        const Json& node = root_["nodes"][std::size_t(index)];
        if (motions_.moves(index) || extensionOf(node, kPhysicsExtension)) return;
        const auto here = parent ? placeIfAny(source_, motions_, index, *parent) : std::nullopt;
        if (member(node, "camera") && !member(node, "mesh")) place(index, node, here, isRoot);
        for (const int child : model_.nodes[std::size_t(index)].children)
            visit(child, here, false);
    }

    void place(int index, const Json& node, const std::optional<Affine>& here, bool isRoot) {
        const Json* all = member(root_, "cameras");
        const int camera = indexIn(node, "camera", all && all->is_array() ? all->size() : 0);
        PlacedCamera placed{{}, index, camera};
        if (camera >= 0) placed.camera = lensOf((*all)[std::size_t(camera)]);
        SavedCamera& read = placed.camera;
        read.name = wantedName(node, camera < 0 ? Json() : (*all)[std::size_t(camera)]);
        if (!here || hasDamagedPlace(node)) return noPlace_.add(read.name);
        read.pose = isRoot && !member(node, "matrix")
                        ? rigidOf(source_, model_, index) // to the bit
                        : Pose{Quat(polarDecomposition(here->linear()).rotation).normalized(),
                               Vec3(here->translation())};
        const Json* ours = extensionOf(node);
        if (ours) read.pose = exactPose(*ours, read.pose).value_or(read.pose);
        const double ahead = numberOf(ours, "ahead");
        if (camera < 0) return noneOfThem_.add(read.name);
        if (!isCamera(read)) return noLens_.add(read.name);
        if (placed_.size() >= kMaxCameras) return tooMany_.add(read.name);
        read.name = freeName(read.name);
        read.ahead = ahead;
        if (isAsItSuits(read)) read.near = read.far = 0;
        placed_.push_back(std::move(placed));
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
    LeftOutCameras noneOfThem_, noPlace_, noLens_, tooMany_;
    std::set<std::string> taken_;
    std::vector<PlacedCamera> placed_;
};

} // namespace

std::vector<PlacedCamera> placedCameras(const Source& source, const tinygltf::Model& model, const Json& root,
                                        const GltfMotions& motions, std::vector<Finding>& findings) {
    return CameraWalk(source, model, root, motions).run(findings);
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
