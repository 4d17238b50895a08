// list_spheres SCENE: every sphere of the first object's hierarchy as CSV, for the figures of docs/physics.
// A child of the root has depth 0; `branch` is the one of these that it lies below; nx is 0 without planes.

#include <iostream>

#include "core/base/numbers.h"
#include "core/collision/sphere_tree.h"
#include "core/files/load_scene.h"

namespace tactum {

namespace {

using Node = SphereTree::Node;

std::string rowOf(const Node& node, const Vec3& origin, int i, int depth, int branch) {
    std::string row =
        std::to_string(depth) + ',' + std::to_string(branch) + ',' + (node.child[i] < 0 ? '1' : '0');
    const Vec3 centre = origin + Vec3(node.x[i], node.y[i], node.z[i]);
    for (const double coordinate : centre) {
        row += ',';
        appendNumber(row, coordinate);
    }
    for (const LaneArray* lane :
         {&node.radius, &node.nx, &node.ny, &node.nz, &node.offset, &node.thickness}) {
        row += ',';
        appendNumber(row, double((*lane)[i]));
    }
    return row;
}

void list(const SphereTree& tree, std::size_t index, int depth, int branch) {
    const Node& node = tree.nodes()[index];
    for (int i = 0; i < SphereTree::kWidth; ++i) {
        if (node.radius[i] < 0) continue;
        const int below = depth == 0 ? i : branch;
        std::cout << rowOf(node, tree.origin(), i, depth, below) << '\n';
        if (node.child[i] >= 0) list(tree, std::size_t(node.child[i]), depth + 1, below);
    }
}

int run(const std::filesystem::path& file) {
    const auto loaded = loadScene(file);
    if (!loaded) {
        std::cerr << loaded.error().text << '\n';
        return 1;
    }
    std::cout << "depth,branch,leaf,x,y,z,radius,nx,ny,nz,offset,thickness\n";
    if (loaded->scene.objects.empty()) return 0;
    const SphereTree tree(*loaded->scene.objects.front().geometry);
    if (!tree.nodes().empty()) list(tree, 0, 0, 0);
    return std::cout.flush() ? 0 : 1;
}

} // namespace

} // namespace tactum

int main(int count, char** words) {
    if (count == 2) return tactum::run(words[1]);
    std::cerr << "list_spheres SCENE: every sphere of its hierarchy as CSV\n";
    return 2;
}
