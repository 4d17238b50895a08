// The large parts of scenes, told by what is in them: whoever has one already need not be sent it again.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "core/scene/scene.h"

namespace tactum {

/// Calls `each` with every shared part of an object: its geometry, its motion, the images and the painted
/// values of its layers. None is null; one may come several times.
template <class Each> void forEachPart(const SceneObject& object, Each each) {
    const auto part = [&](const auto& shared) {
        if (shared) each(shared);
    };
    const auto pattern = [&](const TexturePattern& of) { part(of.image), part(of.painted.values); };
    part(object.geometry), part(object.motion);
    for (const Surface& surface : object.surfaces)
        for (const TextureLayer& layer : surface.layers) {
            pattern(layer.pattern);
            if (layer.mask) pattern(*layer.mask);
        }
}

// 64 bits of everything that is in it; never 0.
std::uint64_t fingerprintOf(const TriangleSoup& soup);
std::uint64_t fingerprintOf(const TextureImage& image);
std::uint64_t fingerprintOf(const PaintedValues& painted);
std::uint64_t fingerprintOf(const Motion& motion);

/// Those of one kind.
template <class T> class KnownTable {
public:
    bool empty() const { return parts_.empty(); }
    /// `print`: where it is known already, for it takes as long as reading all of it.
    void add(const std::shared_ptr<const T>& part, std::uint64_t print = 0) {
        const auto [place, isNew] = prints_.try_emplace(part.get(), print);
        if (!isNew) return;
        if (print == 0) place->second = fingerprintOf(*part);
        parts_.emplace(place->second, part);
    }
    /// 0 of one that was not added.
    std::uint64_t printOf(const T* part) const {
        const auto found = prints_.find(part);
        return found == prints_.end() ? 0 : found->second;
    }
    /// Null when there is none.
    std::shared_ptr<const T> find(std::uint64_t print) const {
        const auto found = parts_.find(print);
        return found == parts_.end() ? nullptr : found->second;
    }

private:
    std::unordered_map<std::uint64_t, std::shared_ptr<const T>> parts_;
    std::unordered_map<const T*, std::uint64_t> prints_;
};

/// Thread: one at a time, any but real time.
class KnownParts {
public:
    KnownParts() = default;
    /// Those of this scene. `before`: what of them is there need not be read again.
    explicit KnownParts(const Scene& scene, const KnownParts& before = {}) { add(scene, before); }
    void add(const Scene& scene, const KnownParts& before = {}) {
        for (const SceneObject& object : scene.objects)
            forEachPart(object, [&]<class T>(const std::shared_ptr<const T>& part) {
                std::get<KnownTable<T>>(tables_).add(part, before.of<T>().printOf(part.get()));
            });
    }
    template <class T> const KnownTable<T>& of() const { return std::get<KnownTable<T>>(tables_); }

private:
    std::tuple<KnownTable<TriangleSoup>, KnownTable<TextureImage>, KnownTable<PaintedValues>,
               KnownTable<Motion>>
        tables_;
};

} // namespace tactum
