// Four panels on a leaning wall: two height pictures, two patterns from formulas; 0.15 to 0.3 mm high.
#include <cmath>
#include <cstdint>
#include <numbers>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/height_image.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/reliefs.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

constexpr double kPanelWidth = 0.08, kPanelHeight = 0.056; // m
constexpr double kLean = 0.7;                              // rad, backward from upright
constexpr double kApart = 0.0006;  // m, between panels: a finger is carried across and feels a click
constexpr double kBefore = 0.0003; // m: of the panels before the wall
constexpr double kUvLength = 0.1;  // m: how long one unit of the texture coordinates is

// A relief tilts the force and lifts nothing. Where it curves by more than (1 - s mu)^2 / (1 + mu^2) over the
// depth of the finger (docs/physics/texture.md), the proxy holds before a crest and falls over it in one
// tick. A finger 1.3 mm deep feels every place of these.
constexpr double kRelief = 0.3e-3;                       // m, bricks and tiles
constexpr double kBrickEdge = 0.0024, kTileEdge = 0.002; // m, from the lowest to the highest place

// m. Whole repeats fill a panel. The low part, mortar or grout, lies around each repeat's corner.
constexpr double kBrick = 0.02, kCourse = 0.008, kMortar = 0.0016;
constexpr double kTile = 0.016, kGrout = 0.002;
constexpr double kThread = 0.008;

/// How far `x` is from the nearest multiple of `period`.
double fromLine(double x, double period) {
    return std::abs(x - period * std::round(x / period));
}

/// Distances to the middle lines of the upright and the level mortar; every other course is moved by half a
/// brick. m.
Eigen::Vector2d fromJoints(double x, double y) {
    const bool odd = int(std::floor(y / kCourse)) % 2 != 0;
    return {fromLine(x + (odd ? kBrick / 2 : 0), kBrick), fromLine(y, kCourse)};
}

/// From 0 on a middle line to 1 beyond the edge along both; rounded at the corners, too.
double abovePart(const Eigen::Vector2d& fromLines, double edge) {
    return smoothStep(0, edge, fromLines.x()) * smoothStep(0, edge, fromLines.y());
}

TextureLayer layer(std::string name, TextureSource source, double size, double height) {
    TextureLayer made;
    made.name = std::move(name);
    made.pattern.source = source;
    made.pattern.mapping = TextureMapping::Uv;
    made.pattern.size = size;
    made.strength = height;
    return made;
}

/// One brick and two courses; the bricks' faces are a little uneven.
double brickPart(double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
    const double uneven = std::sin(3 * a + std::sin(2 * b)) * std::sin(4 * b + std::sin(5 * a));
    return abovePart(fromJoints(u * kBrick, v * 2 * kCourse), kBrickEdge) * (0.9 + 0.1 * uneven);
}

double tilePart(double u, double v) {
    return abovePart({fromLine(u * kTile, kTile), fromLine(v * kTile, kTile)}, kTileEdge);
}

TextureLayer bricks() {
    TextureLayer made = layer("bricks", TextureSource::Image, kBrick, kRelief);
    made.pattern.image = heightImage("bricks", 160, 128, brickPart);
    return made;
}

TextureLayer tiles() {
    TextureLayer made = layer("tiles", TextureSource::Image, kTile, kRelief);
    made.pattern.image = heightImage("tiles", 96, 96, tilePart);
    return made;
}

TextureLayer threads() {
    return layer("threads", TextureSource::Weave, kThread, 0.2e-3);
}

TextureLayer grit() {
    TextureLayer made = layer("grit", TextureSource::Noise, 0.0015, 0.15e-3);
    made.pattern.octaves = 2;
    return made;
}

/// One texture; what is high and what is low may be two surfaces, of other colours and friction.
struct Panel {
    std::string name;
    TextureLayer layer;
    std::vector<double> xs, ys; ///< m: lines between cells
    Mesh::SurfaceAt surfaceAt;
    std::vector<Surface> surfaces;
};

/// From 0 to `end`, a line on both sides of each multiple of `period`.
std::vector<double> linesAround(double period, double halfWidth, double end) {
    std::vector<double> all{0};
    for (int i = 0; i * period < end + halfWidth; ++i)
        for (const double x : {i * period - halfWidth, i * period + halfWidth})
            if (x > 0 && x < end) all.push_back(x);
    all.push_back(end);
    return all;
}

Panel brickPanel() {
    return {"brick",
            bricks(),
            linesAround(kBrick / 2, kMortar / 2, kPanelWidth),
            linesAround(kCourse, kMortar / 2, kPanelHeight),
            [](double x, double y) { return Index(brickSurface(x, y)); },
            {surface("brick", {0.42f, 0.12f, 0.07f}, {.staticFriction = 0.6, .dynamicFriction = 0.5}),
             surface("mortar", {0.52f, 0.48f, 0.42f}, {.staticFriction = 0.7, .dynamicFriction = 0.6})}};
}

Panel tilePanel() {
    return {"tiles",
            tiles(),
            linesAround(kTile, kGrout / 2, kPanelWidth),
            linesAround(kTile, kGrout / 2, kPanelHeight),
            [](double x, double y) { return Index(tileSurface(x, y)); },
            {surface("tile", {0.10f, 0.32f, 0.42f}, {.staticFriction = 0.2, .dynamicFriction = 0.15}),
             surface("grout", {0.70f, 0.70f, 0.66f}, {.staticFriction = 0.35, .dynamicFriction = 0.3})}};
}

Panel plainPanel(const char* name, TextureLayer layer, const Eigen::Vector3f& colour,
                 const Material& material) {
    return {name,
            std::move(layer),
            evenly(0, kPanelWidth, 4),
            evenly(0, kPanelHeight, 4),
            [](double, double) { return Index(0); },
            {surface(name, colour, material)}};
}

Panel weavePanel() {
    return plainPanel("weave", threads(), {0.06f, 0.1f, 0.24f},
                      {.stiffness = 500, .staticFriction = 0.4, .dynamicFriction = 0.35});
}

Panel sandpaperPanel() {
    return plainPanel("sandpaper", grit(), {0.46f, 0.32f, 0.18f},
                      {.staticFriction = 0.8, .dynamicFriction = 0.7});
}

/// The edge of a panel, counter-clockwise seen from behind.
std::vector<Vec3> outlineOf(const Panel& panel) {
    const auto &xs = panel.xs, &ys = panel.ys;
    std::vector<Vec3> rim;
    for (std::size_t i = 0; i + 1 < ys.size(); ++i)
        rim.emplace_back(xs.front(), ys[i], 0);
    for (std::size_t i = 0; i + 1 < xs.size(); ++i)
        rim.emplace_back(xs[i], ys.back(), 0);
    for (std::size_t i = ys.size() - 1; i > 0; --i)
        rim.emplace_back(xs.back(), ys[i], 0);
    for (std::size_t i = xs.size() - 1; i > 0; --i)
        rim.emplace_back(xs[i], ys.front(), 0);
    return rim;
}

/// `place`: of its lower left corner on the wall's face, m.
SceneObject objectOf(const Panel& panel, const Eigen::Vector2d& place) {
    Mesh mesh;
    const auto uvAt = [](double x, double y) { return Uv(float(x / kUvLength), float(y / kUvLength)); };
    mesh.grid(
        panel.xs, panel.ys, [](double x, double y) { return Vec3(x, y, 0); }, panel.surfaceAt, uvAt);
    const std::size_t textured = panel.surfaces.size();
    mesh.fan({kPanelWidth / 2, kPanelHeight / 2, -0.9 * kBefore}, outlineOf(panel), Index(textured));
    std::vector<Surface> surfaces = panel.surfaces;
    surfaces.push_back(
        surface((panel.name + " back").c_str(), {0.30f, 0.30f, 0.28f}, panel.surfaces[0].material));
    SceneObject made = object(panel.name, mesh, std::move(surfaces));
    for (std::size_t i = 0; i < textured; ++i)
        made.surfaces[i].layers = {panel.layer};
    made.pose.rotation = Quat(Eigen::AngleAxisd(-kLean, Vec3::UnitX()));
    made.pose.translation = made.pose.rotate({place.x(), place.y(), kBefore});
    return made;
}

/// A wedge below the panels.
SceneObject wall() {
    const double side = kPanelWidth + 0.007, height = 2 * kPanelHeight + 0.014, low = -0.006;
    const auto onFace = [](double y) { return Vec3(0, y * std::cos(kLean), -y * std::sin(kLean)); };
    const Vec3 front = onFace(low), ridge = onFace(height + low);
    const Vec3 back(0, ridge.y(), ridge.z() - 0.012), foot(0, front.y(), back.z() - 0.012);
    Mesh mesh;
    std::array<Index, 4> left, right;
    std::size_t i = 0;
    for (const Vec3& p : {front, ridge, back, foot}) {
        left[i] = mesh.point(p - Vec3(side, 0, 0));
        right[i++] = mesh.point(p + Vec3(side, 0, 0));
    }
    for (std::size_t k = 0; k < 4; ++k)
        mesh.quad(left[k], right[k], right[(k + 1) % 4], left[(k + 1) % 4]);
    mesh.quad(left[0], left[1], left[2], left[3]);
    mesh.quad(right[0], right[3], right[2], right[1]);
    return object(
        "wall", mesh,
        {surface("plaster", {0.50f, 0.50f, 0.48f}, {.staticFriction = 0.4, .dynamicFriction = 0.35})});
}

/// Over brick and tiles, then over sandpaper and weave; 1.5 mm deep.
std::shared_ptr<const std::vector<FingerPoint>> acrossThePanels() {
    const double left = -kPanelWidth / 2, right = -left, in = 1.5e-3;
    const double high = 1.5 * kPanelHeight + kApart, low = 0.5 * kPanelHeight;
    const std::vector<FingerKey> keys{{0.0, {left, high, -8e-3}}, {0.25, {left, high, in}},
                                      {1.25, {right, high, in}},  {1.35, {right, high, -4e-3}},
                                      {1.7, {right, low, -4e-3}}, {1.8, {right, low, in}},
                                      {2.75, {left, low, in}},    {3.0, {left, low, -8e-3}}};
    return fingerPath(keys, [](const Vec3& p) { // z: how deep
        return Vec3(Eigen::AngleAxisd(-kLean, Vec3::UnitX()) *
                    Vec3(p.x(), p.y(), kBefore + kFingerRadius - p.z()));
    });
}

} // namespace

double brickHeight(double x, double y) {
    return kRelief * brickPart(x / kBrick, y / (2 * kCourse));
}

double tileHeight(double x, double y) {
    return kRelief * tilePart(x / kTile, y / kTile);
}

std::size_t brickSurface(double x, double y) {
    return fromJoints(x, y).minCoeff() < kMortar / 2;
}

std::size_t tileSurface(double x, double y) {
    return std::min(fromLine(x, kTile), fromLine(y, kTile)) < kGrout / 2;
}

Scene textureWall() {
    const double left = -kPanelWidth - kApart / 2, right = kApart / 2;
    const double high = kPanelHeight + kApart;
    Scene scene;
    scene.add(objectOf(brickPanel(), {left, high}));
    scene.add(objectOf(tilePanel(), {right, high}));
    scene.add(objectOf(weavePanel(), {left, 0}));
    scene.add(objectOf(sandpaperPanel(), {right, 0}));
    scene.add(wall());
    scene.finger = acrossThePanels();
    return scene;
}

} // namespace tactum::samples
