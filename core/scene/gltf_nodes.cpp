#include "core/scene/gltf_nodes.h"

#include <set>

#include <Eigen/SVD>

#include "core/scene/soup_builder.h"

namespace tactum {
namespace {

using Affine = Eigen::Affine3d;

class NodeWalk {
public:
    NodeWalk(const Source& source, const tinygltf::Model& model)
        : source_(source), model_(model), visited_(model.nodes.size(), 0) {}

    std::vector<PlacedMesh> run() {
        for (int root : roots())
            visit(root, Affine::Identity(), 1);
        return std::move(placed_);
    }

private:
    std::vector<int> roots() const {
        if (!model_.scenes.empty()) {
            const bool named =
                model_.defaultScene >= 0 && std::size_t(model_.defaultScene) < model_.scenes.size();
            return model_.scenes[named ? std::size_t(model_.defaultScene) : 0].nodes;
        }
        std::set<int> children;
        for (const tinygltf::Node& node : model_.nodes)
            children.insert(node.children.begin(), node.children.end());
        std::vector<int> found;
        for (int i = 0; i < int(model_.nodes.size()); ++i)
            if (!children.contains(i)) found.push_back(i);
        return found;
    }

    void visit(int index, const Affine& parent, int depth) {
        constexpr int kDeepest = 64;
        const std::string where = "nodes[" + std::to_string(index) + "] ";
        if (index < 0 || std::size_t(index) >= model_.nodes.size())
            source_.fail(where + "is used but not there; re-export the file");
        if (std::exchange(visited_[std::size_t(index)], 1))
            source_.fail(where + "is its own ancestor or has two parents; re-export the file");
        if (depth > kDeepest) source_.fail(where + "lies deeper than 64 levels; flatten the hierarchy");
        const tinygltf::Node& node = model_.nodes[std::size_t(index)];
        const Affine here = parent * transformOf(node, where);
        if (!here.matrix().allFinite() || !isCoordinate(here.matrix().cwiseAbs().maxCoeff()))
            source_.fail(where + "has a transform beyond 1e6 m; scale the model");
        if (node.mesh >= 0) place(node, here, where);
        for (int child : node.children)
            visit(child, here, depth + 1);
    }

    Affine transformOf(const tinygltf::Node& node, const std::string& where) const {
        Affine local = Affine::Identity();
        if (node.matrix.size() == 16) {
            local.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data()); // column-major, as glTF
            if (local.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
                source_.fail(where + "has a matrix that is not affine; re-export the file");
            return local;
        }
        if (node.translation.size() == 3) local.translate(Vec3(node.translation.data()));
        if (node.rotation.size() == 4) {
            const Quat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
            if (!(rotation.norm() > 1e-6)) source_.fail(where + "has no usable rotation; re-export the file");
            local.rotate(rotation.normalized());
        }
        if (node.scale.size() == 3) local.scale(Vec3(node.scale.data()));
        return local;
    }

    void place(const tinygltf::Node& node, const Affine& here, const std::string& where) {
        if (std::size_t(node.mesh) >= model_.meshes.size())
            source_.fail(where + "names a mesh that is not there");
        const RigidAndStretch parts = polarDecomposition(here.linear());
        PlacedMesh placed;
        placed.name = node.name.empty() ? model_.meshes[std::size_t(node.mesh)].name : node.name;
        placed.mesh = node.mesh;
        placed.stretch = parts.stretch;
        placed.pose.rotation = Quat(parts.rotation).normalized();
        placed.pose.translation = here.translation();
        placed_.push_back(std::move(placed));
    }

    const Source& source_;
    const tinygltf::Model& model_;
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

std::vector<PlacedMesh> placedMeshes(const Source& source, const tinygltf::Model& model) {
    return NodeWalk(source, model).run();
}

} // namespace tactum
