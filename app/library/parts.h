// What the public classes keep to themselves, and the ways between their plain values and those of the core.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <tactum/error.h>
#include <tactum/preset.h>
#include <tactum/scene.h>
#include <tactum/step.h>
#include <tactum/surface.h>
#include <tactum/vec.h>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/haptics/haptic_step.h"
#include "core/presets/preset.h"
#include "core/scene/findings.h"
#include "core/scene/scene.h"

namespace tactum::library {

/// What the library is made of, whose names are those of the public ones.
namespace core = ::tactum;

/// A scene with where it came from.
struct SceneState {
    core::Scene scene;
    std::vector<std::string> findings;
    std::filesystem::path source;            ///< empty: made by hand
    std::shared_ptr<const core::World> last; ///< compiled last: the next one shares its geometry
};

struct Preset::State {
    core::LoadedPreset loaded;
};

/// Makes handles, and looks behind them. Error where what they name is not there any more.
struct Parts {
    static Scene scene(std::shared_ptr<SceneState> state) { return Scene(std::move(state)); }
    static const std::shared_ptr<SceneState>& state(const Scene& of);
    static Object object(std::shared_ptr<SceneState> scene, ObjectId id) { return {std::move(scene), id}; }
    static bool isOf(const Object& object, const Scene& scene) { return object.scene_ == scene.state_; }
    static core::SceneObject& get(const Object& of) { return objectIn(*of.scene_, of.id_); }
    static Surface surface(const Object& of, std::size_t index) { return {of.scene_, of.id_, index}; }
    static core::Surface& get(const Surface& of) { return surfaceIn(*of.scene_, of.object_, of.index_); }
    static Layer layer(const Surface& of, std::size_t index) {
        return {of.scene_, of.object_, of.index_, index};
    }
    static core::TextureLayer& get(const Layer& of);
    static const core::Preset& get(const Preset& of) { return of.state_->loaded.preset; }

private:
    static core::SceneObject& objectIn(SceneState& scene, ObjectId id);
    static core::Surface& surfaceIn(SceneState& scene, ObjectId object, std::size_t index);
};

/// The World of the scene as it is now. Error: it cannot be touched.
std::shared_ptr<const core::World> compiled(SceneState& of, const core::World* previous = nullptr);

/// The input is at fault.
[[noreturn]] void refuse(const std::string& sentence);
/// What the core answers to a function of ours.
[[noreturn]] void refuse(const core::Error& error);

template <class T> T valueOf(Result<T> result) {
    if (!result) refuse(result.error());
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

std::vector<std::string> linesOf(const std::vector<Finding>& findings);
/// The reader of the core in a process of its own, and what it doubts.
SceneState opened(const std::filesystem::path& file);

inline core::Vec3 inward(const Vec3& v) noexcept {
    return {v.x, v.y, v.z};
}
inline Vec3 outward(const core::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}
std::vector<FingerPoint> outward(const std::vector<core::FingerPoint>& path);
/// Error: no path that a finger can take.
std::vector<core::FingerPoint> inward(std::span<const FingerPoint> path);
Contact outward(const core::ContactReport& report, ObjectId object) noexcept;

} // namespace tactum::library
