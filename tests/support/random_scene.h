// Scenes at random that use every value an author can set, and whether two scenes are the same in all of
// them.
#pragma once

#include <random>

#include "core/base/single_precision.h"
#include "core/motion/motion_build.h"
#include "core/scene/scene.h"
#include "tests/support/random_mechanics.h"

namespace tactum::test {

/// Draws values; the same seed gives the same scene on every machine.
class SceneDice {
public:
    explicit SceneDice(unsigned seed) : random_(seed) {}

    Scene scene() {
        Scene scene;
        scene.proxyRadius = within(kProxyRadius);
        scene.reach = {choice<ReachMode>(kReachModes), within(kShellRadius)};
        if (chance(2)) {
            std::vector<FingerPoint> finger;
            for (int i = 0; i < 5; ++i)
                finger.push_back({i + unit(), vector(0.2)});
            scene.finger = std::make_shared<const std::vector<FingerPoint>>(std::move(finger));
        }
        for (int i = count(1, 4); i > 0; --i)
            scene.add(
                object(i > 1 && !scene.objects.empty() && chance(3) ? scene.objects[0].geometry : nullptr));
        if (chance(3)) MechanicsDice(random_).addTo(scene);
        return scene;
    }

private:
    int count(int low, int high) { return low + int(random_() % unsigned(high - low + 1)); }
    bool chance(unsigned oneIn) { return random_() % oneIn == 0; }
    double unit() { return double(random_()) / double(std::mt19937::max()); }
    double within(const Parameter& p) { return p.minimum + unit() * (p.maximum - p.minimum); }
    Vec3 vector(double size) {
        const double x = unit(), y = unit(), z = unit();
        return size * (Vec3(2 * x, 2 * y, 2 * z) - Vec3::Ones());
    }
    Quat rotation() {
        const Vec3 v = vector(1);
        return Quat(0.1 + unit(), v.x(), v.y(), v.z()).normalized();
    }
    std::string name(const char* kind) {
        static constexpr const char* kEndings[] = {"", " \"q\" <&>", " äöü 触覚", " /..\\", "'", " #1"};
        return kind + std::to_string(count(0, 99)) + kEndings[count(0, 5)];
    }
    template <class Choice> Choice choice(std::size_t size) { return Choice(random_() % size); }

    std::shared_ptr<const TextureImage> image() {
        const int width = count(1, 20), height = count(1, 20), bits = chance(2) ? 8 : 16;
        std::vector<std::uint16_t> texels;
        for (int i = 0; i < width * height; ++i)
            texels.push_back(std::uint16_t(bits == 8 ? random_() % 256 * 257 : random_() % 65536));
        return std::make_shared<const TextureImage>(width, height, texels, name("image"), bits);
    }
    /// Now and then of another mesh, and now and then the same once more.
    std::shared_ptr<const PaintedValues> painted() {
        if (lastPainted_ && chance(3)) return lastPainted_;
        std::vector<float> values(chance(8) ? std::size_t(count(1, 9)) : positions_);
        for (float& value : values)
            value = chance(5) ? float(count(0, 1)) : float(unit());
        return lastPainted_ = std::make_shared<const PaintedValues>(std::move(values));
    }
    TexturePattern pattern() {
        TexturePattern p;
        p.source = choice<TextureSource>(kTextureSources.size());
        p.mapping = choice<TextureMapping>(kTextureMappings.size());
        if (p.source == TextureSource::Image) p.image = image();
        if (p.source == TextureSource::Painted && !chance(8)) p.painted.values = painted();
        p.frame = {rotation(), vector(0.1)};
        for (const PatternField& field : kPatternFields)
            p.*field.value = within(*field.parameter);
        return p;
    }
    TextureLayer layer() {
        TextureLayer layer;
        layer.name = name("layer");
        layer.enabled = chance(2);
        layer.pattern = pattern();
        layer.target = choice<TextureTarget>(kTextureTargets.size());
        layer.strength = within(strengthParameter(layer.target));
        layer.blend = choice<TextureBlend>(kTextureBlends.size());
        layer.opacity = unit();
        if (chance(3)) layer.mask = pattern();
        layer.ownPlane = chance(4);
        return layer;
    }
    Surface surface() {
        Surface surface;
        surface.name = name("surface");
        for (const MaterialField& field : kMaterialFields)
            surface.material.*field.value = within(*field.parameter);
        surface.shading = {chance(2), choice<NormalSource>(2), within(kCreaseAngle)};
        for (int i = chance(2) ? 0 : count(1, 3); i > 0; --i)
            surface.layers.push_back(layer());
        surface.colour = vector(1).cwiseAbs().cast<float>();
        surface.sides = choice<Sides>(3);
        return surface;
    }
    /// Sound triangles, segments and points; corners that share or split their normals and coordinates.
    std::shared_ptr<const TriangleSoup> soup(std::size_t surfaces) {
        TriangleSoup soup;
        const bool exact = chance(2), normals = chance(2), uvs = chance(2);
        for (int i = count(4, 30); i > 0; --i) {
            const Vec3 p = vector(0.1);
            soup.positions.push_back(exact ? p : asSingle(p));
        }
        for (int i = count(1, 60); i > 0; --i) {
            const Index n = Index(soup.positions.size()), a = random_() % n;
            const Index b = (a + 1 + random_() % (n - 2)) % n;
            Index c = random_() % n;
            if (c == a || c == b) c = b;
            soup.triangles.push_back({a, chance(20) ? a : b, 0});
            auto& t = soup.triangles.back();
            t[2] = t[1] == a ? a : c;
            soup.surfaceOf.push_back(Index(random_() % surfaces));
            for (int corner = 0; corner < 3; ++corner) {
                const bool same = corner == 2 && t[1] == t[2], point = t[0] == t[2];
                const Eigen::Vector3f normal =
                    (vector(1) + Vec3(0, 0, 1.8)).normalized().cast<float>().normalized();
                const Eigen::Vector2f uv(float(unit() * 3),
                                         chance(5) ? 1e-7f * float(unit()) : float(unit()));
                const bool again = same || (point && corner > 0);
                if (normals) soup.cornerNormals.push_back(again ? soup.cornerNormals.back() : normal);
                if (uvs) soup.cornerUvs.push_back(again ? soup.cornerUvs.back() : uv);
            }
        }
        return std::make_shared<const TriangleSoup>(std::move(soup));
    }
    template <class Value, class Draw> Track<Value> track(Draw draw) {
        Track<Value> track;
        track.interpolation = choice<Interpolation>(3);
        double time = 0;
        for (int i = count(0, 5); i > 0; --i) {
            track.times.push_back(time);
            track.values.push_back(draw());
            if (track.interpolation == Interpolation::CubicSpline) {
                track.arriving.push_back(draw());
                track.leaving.push_back(draw());
            }
            time += chance(6) ? 0 : unit();
        }
        return track;
    }
    SceneObject object(std::shared_ptr<const TriangleSoup> shared) {
        SceneObject object;
        object.name = name("object");
        object.pose = {rotation(), vector(0.5)};
        object.visible = !chance(4);
        const std::size_t surfaces = std::size_t(count(1, 4));
        object.geometry = soup(surfaces);
        positions_ = object.geometry->positions.size();
        if (shared) {
            object.geometry = shared;
            positions_ = shared->positions.size();
            while (object.surfaces.size() <= std::ranges::max(shared->surfaceOf))
                object.surfaces.push_back(surface());
        }
        while (object.surfaces.size() < surfaces)
            object.surfaces.push_back(surface());
        if (chance(3))
            object.motion = std::make_shared<const Motion>(
                makeMotion(track<Vec3>([&] { return vector(0.1); }),
                           track<QuatCoefficients>([&] { return rotation().coeffs(); }), unit() * 6));
        return object;
    }

    std::mt19937 random_;
    std::size_t positions_ = 0; ///< of the mesh whose surfaces are drawn
    std::shared_ptr<const PaintedValues> lastPainted_;
};

/// The first difference in words; empty where every value is the same. Objects may have other ids, and what
/// is shared may be a copy.
std::string difference(const Scene& a, const Scene& b);

} // namespace tactum::test
