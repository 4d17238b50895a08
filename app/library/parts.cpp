#include "app/library/parts.h"

#include "app/library/support_folder.h"
#include "core/base/text.h"
#include "core/haptics/compile.h"
#include "core/import/import_scene.h"

namespace tactum::library {

const std::shared_ptr<SceneState>& Parts::state(const Scene& of) {
    if (!of.state_) refuse("this scene was moved elsewhere; assign another one to it first");
    return of.state_;
}

core::SceneObject& Parts::objectIn(SceneState& scene, ObjectId id) {
    if (core::SceneObject* object = scene.scene.find(id)) return *object;
    refuse("object " + std::to_string(id) + " is not in the scene any more");
}

core::Surface& Parts::surfaceIn(SceneState& scene, ObjectId object, std::size_t index) {
    auto& surfaces = objectIn(scene, object).surfaces;
    if (index < surfaces.size()) return surfaces[index];
    refuse("surface " + std::to_string(index) + " is not on its object any more");
}

core::TextureLayer& Parts::get(const Layer& of) {
    auto& layers = surfaceIn(*of.scene_, of.object_, of.surface_).layers;
    if (of.index_ < layers.size()) return layers[of.index_];
    refuse("layer " + std::to_string(of.index_) + " is not on its surface any more");
}

std::shared_ptr<const core::World> compiled(SceneState& of, const core::World* previous) {
    of.last = valueOf(compile(of.scene, previous ? previous : of.last.get()));
    return of.last;
}

void refuse(const std::string& sentence) {
    throw Error(Error::Kind::Input, sentence);
}

void refuse(const core::Error& error) {
    const bool machine = error.kind == core::Error::Kind::Machine;
    throw Error(machine ? Error::Kind::Machine : Error::Kind::Input, error.text);
}

std::vector<std::string> linesOf(const std::vector<Finding>& findings) {
    std::vector<std::string> lines;
    for (const Finding& finding : findings)
        lines.push_back(lineOf(finding));
    return lines;
}

SceneState opened(const std::filesystem::path& file) {
    auto loaded = valueOf(importScene(file, {}, {importProcess(), {}}));
    return {std::move(loaded.scene), linesOf(loaded.findings), file, nullptr};
}

std::vector<FingerPoint> outward(const std::vector<core::FingerPoint>& path) {
    std::vector<FingerPoint> points;
    points.reserve(path.size());
    for (const core::FingerPoint& point : path)
        points.push_back({point.t, outward(point.position)});
    return points;
}

std::vector<core::FingerPoint> inward(std::span<const FingerPoint> path) {
    std::vector<core::FingerPoint> points;
    points.reserve(path.size());
    for (const FingerPoint& point : path)
        points.push_back({point.t, inward(point.position)});
    if (points.empty() || !isFingerPath(points))
        refuse("path: its times have to rise, and its places to be finite and within 1e6 m of the origin");
    return points;
}

Contact outward(const core::ContactReport& report, ObjectId object) noexcept {
    return {outward(report.point), outward(report.normal), report.normalForce, object,
            report.surface,        report.slipping,        report.frictionless};
}

} // namespace tactum::library
