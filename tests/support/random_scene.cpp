#include "tests/support/random_scene.h"

#include <algorithm>

namespace tactum::test {

namespace {

template <class Each>
std::string difference(const char* what, const std::vector<Each>& a, const std::vector<Each>& b) {
    if (a.size() != b.size()) return std::string("number of ") + what;
    const auto [x, y] = std::ranges::mismatch(a, b);
    return x == a.end() ? "" : what + (" " + std::to_string(x - a.begin()));
}

std::string difference(const Mechanics& a, const Mechanics& b) {
    std::string found = difference("bodies", a.bodies, b.bodies);
    if (found.empty()) found = difference("joints", a.joints, b.joints);
    if (found.empty()) found = difference("colliders", a.colliders, b.colliders);
    if (found.empty() && !a.bodies.empty() && a.gravity != b.gravity) found = "gravity";
    if (found.empty() && !a.bodies.empty() && a.airDensity != b.airDensity) found = "air density";
    return found;
}

} // namespace

std::string difference(const Scene& a, const Scene& b) {
    const auto sameImage = [](const auto& x, const auto& y) {
        if (!x || !y) return !x && !y;
        if (x->name() != y->name() || x->bits() != y->bits() || x->width() != y->width() ||
            x->height() != y->height())
            return false;
        for (int row = 0; row < x->height(); ++row)
            if (!std::equal(x->row(row), x->row(row) + x->width(), y->row(row))) return false;
        return true;
    };
    const auto samePattern = [&](TexturePattern x, TexturePattern y) {
        if (!sameImage(x.image, y.image)) return false;
        x.image = y.image = nullptr;
        return x == y;
    };
    if (a.proxyRadius != b.proxyRadius) return "proxy radius";
    if (a.reach != b.reach) return "reach";
    if (bool(a.finger) != bool(b.finger) || (a.finger && *a.finger != *b.finger)) return "finger path";
    if (const std::string found = difference(a.mechanics, b.mechanics); !found.empty()) return found;
    if (a.cameras != b.cameras) return "cameras";
    if (a.objects.size() != b.objects.size()) return "number of objects";
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        const SceneObject &x = a.objects[i], &y = b.objects[i];
        const std::string at = "object " + std::to_string(i) + ": ";
        if (x.name != y.name) return at + "name " + x.name + " | " + y.name;
        if (!(x.pose == y.pose)) return at + "pose";
        if (x.body != y.body) return at + "body";
        if (x.visible != y.visible) return at + "visible";
        if (x.group != y.group) return at + "group " + x.group + " | " + y.group;
        if (x.sets != y.sets) return at + "selection sets";
        if (bool(x.motion) != bool(y.motion) || (x.motion && !(*x.motion == *y.motion))) return at + "motion";
        if (x.geometry->positions != y.geometry->positions) return at + "positions";
        if (x.geometry->triangles != y.geometry->triangles) return at + "triangles";
        if (x.geometry->surfaceOf != y.geometry->surfaceOf) return at + "surfaceOf";
        if (x.geometry->cornerNormals != y.geometry->cornerNormals) return at + "normals";
        if (x.geometry->cornerUvs != y.geometry->cornerUvs) return at + "uvs";
        if (x.surfaces.size() != y.surfaces.size()) return at + "number of surfaces";
        for (std::size_t s = 0; s < x.surfaces.size(); ++s) {
            const Surface &p = x.surfaces[s], &q = y.surfaces[s];
            const std::string of = at + "surface " + std::to_string(s) + ": ";
            if (p.name != q.name) return of + "name";
            if (!(p.material == q.material)) return of + "material";
            if (!(p.shading == q.shading)) return of + "shading";
            if (p.sides != q.sides) return of + "sides";
            if (p.colour != q.colour) return of + "colour";
            if (p.layers.size() != q.layers.size()) return of + "number of layers";
            for (std::size_t l = 0; l < p.layers.size(); ++l) {
                TextureLayer u = p.layers[l], v = q.layers[l];
                if (!samePattern(u.pattern, v.pattern)) return of + "pattern";
                if (bool(u.mask) != bool(v.mask) || (u.mask && !samePattern(*u.mask, *v.mask)))
                    return of + "mask";
                u.pattern = v.pattern = {};
                u.mask.reset(), v.mask.reset();
                if (!(u == v)) return of + "layer";
            }
        }
    }
    return "";
}

} // namespace tactum::test
