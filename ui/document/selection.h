// What a person has selected: surfaces, and triangles of one object.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "core/scene/surface_ref.h"

namespace tactum {

/// One or more surfaces of a scene, each once.
struct SurfaceRefs : std::vector<SurfaceRef> {
    SurfaceRefs() = default;
    SurfaceRefs(std::nullopt_t) {}
    SurfaceRefs(std::optional<SurfaceRef> perhaps) {
        if (perhaps) push_back(*perhaps);
    }
    SurfaceRefs(std::initializer_list<SurfaceRef> several) : std::vector<SurfaceRef>(several) {}
    SurfaceRefs(SurfaceRef one) : std::vector<SurfaceRef>{one} {}
    SurfaceRefs(std::vector<SurfaceRef> several) : std::vector<SurfaceRef>(std::move(several)) {}
};

/// Surfaces to be asked for one by one: a selection may hold thousands.
class SurfaceSet {
public:
    explicit SurfaceSet(const std::vector<SurfaceRef>& refs = {}) {
        for (const SurfaceRef ref : refs)
            add(ref);
    }
    bool has(SurfaceRef ref) const { return keys_.contains(keyOf(ref)); }
    /// False where it was in it already.
    bool add(SurfaceRef ref) { return keys_.insert(keyOf(ref)).second; }

private:
    static std::uint64_t keyOf(SurfaceRef ref) { return std::uint64_t(ref.object) << 32 | ref.surface; }

    std::unordered_set<std::uint64_t> keys_;
};

/// Triangles of one object, in rising order.
struct FaceSelection {
    ObjectId object = 0;
    std::vector<Index> faces;

    bool empty() const { return faces.empty(); }
    bool operator==(const FaceSelection&) const = default;
};

/// How what is chosen joins what is selected already.
enum class SelectMode { Replace, Add, Subtract };

/// `chosen` joined to `now`. Triangles of another object replace those that are selected, and cannot be taken
/// from them.
FaceSelection joined(const FaceSelection& now, const FaceSelection& chosen, SelectMode mode);
/// The last of `chosen` becomes the last of the result: the active one.
SurfaceRefs joined(const SurfaceRefs& now, const SurfaceRefs& chosen, SelectMode mode);

} // namespace tactum
