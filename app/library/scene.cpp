#include <tactum/scene.h>

#include "app/library/parts.h"
#include "app/library/values.h"
#include "core/base/text.h"
#include "core/bundle/bundle.h"
#include "core/bundle/write_scene.h"
#include "core/files/save_scene.h"
#include "core/haptics/replay.h"
#include "core/scene/bodies.h"
#include "core/scene/placing.h"

namespace tactum::library {
namespace {

namespace fs = std::filesystem;

constexpr double kLeast = 1e-6, kMost = 1e6; ///< of a unit and of a diagonal, m

bool isLength(double value) {
    return value >= kLeast && value <= kMost;
}

void place(core::Scene& scene, const OpenOptions& options) {
    if (!isLength(options.unit)) refuse("unit: is not from 1e-6 to 1e6 m");
    if (options.fit && !isLength(*options.fit)) refuse("fit: is not from 1e-6 to 1e6 m");
    if (options.unit != 1) scaleScene(scene, options.unit, core::Vec3::Zero());
    if (options.zUp && !turnUpright(scene))
        refuse("zUp: the scene has bodies, which stand as their gravity is; leave it out");
    if (options.fit) fitDiagonal(scene, *options.fit);
}

std::vector<core::FingerPoint> pathFor(const core::Scene& scene, std::span<const FingerPoint> path) {
    if (!path.empty()) return inward(path);
    if (!scene.finger) refuse("path: the scene has none of its own; give one");
    return *scene.finger;
}

} // namespace

Scene::Scene() : state_(std::make_shared<SceneState>()) {}
Scene::Scene(std::shared_ptr<SceneState> state) : state_(std::move(state)) {}
Scene::Scene(const Scene& other) : state_(std::make_shared<SceneState>(*Parts::state(other))) {}
Scene::Scene(Scene&& other) noexcept = default;
Scene& Scene::operator=(const Scene& other) {
    state_ = std::make_shared<SceneState>(*Parts::state(other));
    return *this;
}
Scene& Scene::operator=(Scene&& other) noexcept = default;
Scene::~Scene() = default;

Scene Scene::open(const fs::path& file, const OpenOptions& options) {
    SceneState state = opened(file);
    place(state.scene, options);
    return Scene(std::make_shared<SceneState>(std::move(state)));
}

std::vector<Object> Scene::objects() const {
    std::vector<Object> all;
    for (const core::SceneObject& object : Parts::state(*this)->scene.objects)
        all.push_back(Parts::object(state_, object.id));
    return all;
}

Object Scene::object(std::string_view name) const {
    for (const core::SceneObject& object : Parts::state(*this)->scene.objects)
        if (object.name == name) return Parts::object(state_, object.id);
    refuse("the scene has no object " + inQuotes(name));
}

void Scene::remove(const Object& object) {
    if (!Parts::isOf(object, *this)) refuse("the object is of another scene");
    Parts::get(object); // is there
    core::Scene& scene = Parts::state(*this)->scene;
    removeMechanics(scene, object.id());
    std::erase_if(scene.objects, [&](const core::SceneObject& one) { return one.id == object.id(); });
}

void Scene::set(std::string_view key, double value) {
    core::Scene& scene = Parts::state(*this)->scene;
    if (has(sceneNumbers(), key)) return setNumber(scene, sceneNumbers(), key, value);
    named(surfaceNumbers(), key);
    for (Object& object : objects())
        object.set(key, value);
}

double Scene::get(std::string_view key) const {
    return named(sceneNumbers(), key).get(Parts::state(*this)->scene);
}

void Scene::apply(const Preset& preset) {
    for (Object& object : objects())
        object.apply(preset);
}

std::vector<FingerPoint> Scene::path() const {
    const auto& path = Parts::state(*this)->scene.finger;
    return path ? outward(*path) : std::vector<FingerPoint>();
}

void Scene::setPath(std::span<const FingerPoint> path) {
    Parts::state(*this)->scene.finger =
        path.empty() ? nullptr : std::make_shared<const std::vector<core::FingerPoint>>(inward(path));
}

std::vector<std::string> Scene::findings() const {
    return Parts::state(*this)->findings;
}

std::vector<std::string> Scene::check() const {
    return linesOf(validate(Parts::state(*this)->scene));
}

std::vector<TouchRow> Scene::touch(std::span<const FingerPoint> path) const {
    const auto points = pathFor(Parts::state(*this)->scene, path);
    std::vector<TouchRow> rows;
    rows.reserve(points.size());
    for (const core::TouchRow& row : replay(*compiled(*state_), points))
        rows.push_back({row.t, outward(row.finger), outward(row.proxy), outward(row.force),
                        std::uint32_t(row.contacts)});
    return rows;
}

void Scene::save(const fs::path& file) const {
    if (lowerCase(file.extension().string()) != std::string(".") + kSceneEnding)
        refuse(file.string() + ": a scene is saved as .glb; convert() writes other formats");
    valueOf(saveScene(Parts::state(*this)->scene, file, {}, 0));
}

std::vector<std::string> Scene::convert(const fs::path& file) const {
    OutputPlaces places{file, {}, {}};
    if (const SceneState& state = *Parts::state(*this); !state.source.empty())
        places.inputs.push_back(state.source);
    std::vector<std::string> lines;
    for (const Loss& loss : valueOf(writeScene(state_->scene, places)).losses)
        if (loss.kind != LossKind::Kept) lines.push_back(lineOf(loss));
    return lines;
}

Bundle openBundle(const fs::path& file) {
    SceneState state = opened(file);
    core::Bundle bundle = valueOf(core::openBundle(file, std::move(state.scene)));
    state.scene = std::move(bundle.scene);
    std::vector<Vec3> forces;
    forces.reserve(bundle.forces.size());
    for (const core::Vec3& force : bundle.forces)
        forces.push_back(outward(force));
    return {Parts::scene(std::make_shared<SceneState>(std::move(state))), outward(bundle.finger),
            std::move(forces)};
}

} // namespace tactum::library
