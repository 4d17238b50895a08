#include "core/files/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/SVD>

#include "core/files/gltf/gltf_motion.h"
#include "core/files/gltf/gltf_standards.h"
#include "core/files/readers.h"
#include "core/geometry/soup_builder.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;

std::string whereIsNode(int node) {
    return "nodes[" + std::to_string(node) + "] ";
}

class NodeWalk {
public:
    NodeWalk(const Source& source, const tinygltf::Model& model, const GltfMotions& motions)
        : source_(source), model_(model), motions_(motions), visited_(model.nodes.size(), 0) {}

    std::vector<PlacedMesh> run() {
        for (int root : sceneRoots(model_))
            visit(root, Affine::Identity(), 1);
        return std::move(placed_);
    }

private:
    /// Whether nothing but cameras stands there and below: a place that is none is theirs to say.
    bool visit(int index, const Affine& parent, int depth) {
        constexpr int kDeepest = 64;
        const std::string where = whereIsNode(index);
        if (index < 0 || std::size_t(index) >= model_.nodes.size())
            source_.fail(where + "is used but not there; re-export the file");
        if (std::exchange(visited_[std::size_t(index)], 1))
            source_.fail(where + "is its own ancestor or has two parents; re-export the file");
        if (depth > kDeepest) source_.fail(where + "lies deeper than 64 levels; flatten the hierarchy");
        const tinygltf::Node& node = model_.nodes[std::size_t(index)];
        const bool isCamera =
            node.mesh < 0 && node.camera >= 0 && !node.extensions.contains(kPhysicsExtension);
        Affine here = parent;
        std::optional<ReadFault> fault;
        try {
            here = standingAt(source_, motions_, index, parent);
        } catch (const ReadFault& found) {
            if (!isCamera) throw;
            fault = found;
        }
        chain_.push_back(index);
        if (node.mesh >= 0) placeAll(node, here, where);
        bool seesAlone = isCamera;
        for (int child : node.children)
            seesAlone = visit(child, here, depth + 1) && seesAlone;
        chain_.pop_back();
        if (fault && !seesAlone) throw *fault;
        return seesAlone;
    }

    /// One, or as many as the extension says.
    void placeAll(const tinygltf::Node& node, const Affine& here, const std::string& where) {
        const auto instanced = node.extensions.find(kInstancing);
        if (instanced == node.extensions.end()) return place(node, here, where, std::nullopt);
        const tinygltf::Value& attributes = instanced->second.Get("attributes");
        const auto attribute = [&](const char* name, std::size_t width) -> std::optional<GltfAccessor> {
            if (!attributes.IsObject() || !attributes.Has(name)) return std::nullopt;
            if (!attributes.Get(name).IsInt())
                source_.fail(where + "has instances whose " + name + " names no accessor; export it again");
            return GltfAccessor(source_, model_, attributes.Get(name).GetNumberAsInt(), width);
        };
        const auto translation = attribute("TRANSLATION", 3), rotation = attribute("ROTATION", 4),
                   scale = attribute("SCALE", 3);
        std::optional<std::size_t> count;
        for (const auto* each : {&translation, &rotation, &scale})
            if (*each && count.value_or((*each)->size()) != (*each)->size())
                source_.fail(where +
                             "has attributes of its instances that are not of one length; export it again");
            else if (*each)
                count = (*each)->size();
        if (!count) return place(node, here, where, std::nullopt);
        for (std::size_t i = 0; i < *count; ++i) {
            Affine instance = Affine::Identity();
            if (translation) instance.translate(vectorOf<3>(*translation, i));
            if (rotation) {
                const QuatCoefficients q = vectorOf<4>(*rotation, i);
                if (!isUsable(q)) source_.fail(where + "has an instance without a usable rotation");
                instance.rotate(Quat(q).normalized());
            }
            if (scale) instance.scale(vectorOf<3>(*scale, i));
            if (!instance.matrix().allFinite() || !isCoordinate(instance.matrix().cwiseAbs().maxCoeff()))
                source_.fail(where + "has an instance beyond 1e6 m; scale the model");
            place(node, here, where, instance);
            placed_.back().name += " " + std::to_string(i + 1);
        }
    }

    template <int N> static Eigen::Matrix<double, N, 1> vectorOf(const GltfAccessor& from, std::size_t i) {
        Eigen::Matrix<double, N, 1> v;
        for (int k = 0; k < N; ++k)
            v[k] = from.number(i, std::size_t(k));
        return v;
    }

    void place(const tinygltf::Node& node, const Affine& here, const std::string& where,
               const std::optional<Affine>& instance) {
        demandBounded(source_, placed_.size() + 1, 0);
        if (std::size_t(node.mesh) >= model_.meshes.size())
            source_.fail(where + "names a mesh that is not there");
        const tinygltf::Mesh& mesh = model_.meshes[std::size_t(node.mesh)];
        PlacedMesh placed;
        placed.name = node.name.empty() ? mesh.name : node.name;
        placed.node = chain_.back();
        placed.mesh = node.mesh;
        if (!instance) placed.rest = poseAbove();
        placed.deforms = node.skin >= 0 || std::ranges::any_of(mesh.primitives, [](const auto& primitive) {
                             return !primitive.targets.empty();
                         });
        const auto mover =
            std::find_if(chain_.rbegin(), chain_.rend(), [&](int i) { return motions_.moves(i); });
        if (mover == chain_.rend() && chain_.size() == 1 && isRigid(chain_[0]) && !instance)
            placed.pose = rigidOf(source_, model_, chain_[0]); // to the bit
        else if (mover == chain_.rend())
            placeAtRest(placed, instance ? here * *instance : here);
        else
            placeOnMover(placed, mover.base(), instance.value_or(Affine::Identity()));
        placed_.push_back(std::move(placed));
    }

    std::optional<Pose> poseAbove() const {
        std::optional<Pose> pose;
        for (std::size_t i = 0; i + 1 < chain_.size(); ++i) {
            if (!isRigid(chain_[i]) || motions_.moves(chain_[i])) return std::nullopt;
            const Pose local = rigidOf(source_, model_, chain_[i]);
            pose = pose ? *pose * local : local;
        }
        return pose;
    }

    bool isRigid(int index) const {
        const tinygltf::Node& node = model_.nodes[std::size_t(index)];
        return node.matrix.empty() &&
               (node.scale.empty() || scaleOf(model_, index).diagonal() == Vec3::Ones());
    }

    static void placeAtRest(PlacedMesh& placed, const Affine& here) {
        const RigidAndStretch parts = polarDecomposition(here.linear());
        placed.stretch = parts.stretch;
        placed.pose.rotation = Quat(parts.rotation).normalized();
        placed.pose.translation = here.translation();
    }

    // The body's frame is that of the last node that moves; all below it goes into the vertices.
    void placeOnMover(PlacedMesh& placed, std::vector<int>::const_iterator below, const Affine& instance) {
        GltfMotions::Course course = motions_.courseOf({chain_.cbegin(), below});
        Affine rest(scaleOf(model_, *std::prev(below)));
        for (auto node = below; node != chain_.cend(); ++node)
            rest = rest * transformOf(source_, model_, *node);
        rest = rest * instance;
        const Mat3 stretch = course.stretch * rest.linear();
        placed.pose = course.rest;
        placed.stretch = stretch.isIdentity(1e-12) ? Mat3::Identity().eval() : stretch;
        placed.offset = course.stretch * rest.translation();
        placed.bends = course.bends;
        if (course.motion) placed.motion = std::make_shared<const Motion>(std::move(*course.motion));
    }

    const Source& source_;
    const tinygltf::Model& model_;
    const GltfMotions& motions_;
    std::vector<int> chain_; ///< from the root to the node being visited
    std::vector<char> visited_;
    std::vector<PlacedMesh> placed_;
};

} // namespace

RigidAndStretch polarDecomposition(const Mat3& a) {
    if (a.isIdentity(1e-12)) return {Mat3::Identity(), Mat3::Identity()};
    const Eigen::JacobiSVD<Mat3> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) = -u.col(2);
    const Mat3 rotation = u * svd.matrixV().transpose();
    const Mat3 stretch = rotation.transpose() * a;
    return {rotation, stretch.isIdentity(1e-12) ? Mat3::Identity().eval() : stretch};
}

std::vector<int> sceneRoots(const tinygltf::Model& model) {
    if (!model.scenes.empty()) {
        const bool named = model.defaultScene >= 0 && std::size_t(model.defaultScene) < model.scenes.size();
        return model.scenes[named ? std::size_t(model.defaultScene) : 0].nodes;
    }
    std::set<int> children;
    for (const tinygltf::Node& node : model.nodes)
        children.insert(node.children.begin(), node.children.end());
    std::vector<int> found;
    for (int i = 0; i < int(model.nodes.size()); ++i)
        if (!children.contains(i)) found.push_back(i);
    return found;
}

std::vector<PlacedMesh> placedMeshes(const Source& source, const tinygltf::Model& model,
                                     const GltfMotions& motions) {
    return NodeWalk(source, model, motions).run();
}

Affine standingAt(const Source& source, const GltfMotions& motions, int index, const Affine& parent) {
    const Affine here = parent * motions.localAt(index, 0);
    if (!here.matrix().allFinite() || !isCoordinate(here.matrix().cwiseAbs().maxCoeff()))
        source.fail(whereIsNode(index) + "has a transform beyond 1e6 m; scale the model");
    return here;
}

std::optional<Affine> placeIfAny(const Source& source, const GltfMotions& motions, int index,
                                 const Affine& parent) {
    try {
        return standingAt(source, motions, index, parent);
    } catch (const ReadFault&) {
        return std::nullopt;
    }
}

Affine transformOf(const Source& source, const tinygltf::Model& model, int index) {
    const tinygltf::Node& node = model.nodes[std::size_t(index)];
    if (node.matrix.size() != 16) {
        const Pose pose = rigidOf(source, model, index);
        return Eigen::Translation3d(pose.translation) * pose.rotation * scaleOf(model, index);
    }
    Affine local;
    local.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data()); // column-major, as glTF
    if (local.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
        source.fail(whereIsNode(index) + "has a matrix that is not affine; re-export the file");
    return local;
}

Pose rigidOf(const Source& source, const tinygltf::Model& model, int index) {
    const tinygltf::Node& node = model.nodes[std::size_t(index)];
    Pose pose;
    if (node.translation.size() == 3) pose.translation = Vec3(node.translation.data());
    if (node.rotation.size() != 4) return pose;
    const QuatCoefficients rotation(node.rotation.data()); // x, y, z, w, as glTF
    if (!isUsable(rotation)) source.fail(whereIsNode(index) + "has no usable rotation; re-export the file");
    pose.rotation = unitLength(Quat(rotation));
    return pose;
}

bool needsUnitLength(const QuatCoefficients& rotation) {
    return std::abs(rotation.norm() - 1) > 1 / 127.0;
}

bool isUsable(const QuatCoefficients& rotation) {
    return rotation.norm() > 1e-6 && std::isfinite(rotation.norm());
}

Eigen::AlignedScaling3d scaleOf(const tinygltf::Model& model, int index) {
    const tinygltf::Node& node = model.nodes[std::size_t(index)];
    return Eigen::AlignedScaling3d(node.scale.size() == 3 ? Vec3(node.scale.data()) : Vec3::Ones().eval());
}

} // namespace tactum
