#include "core/scene/carry_feel.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

namespace tactum {
namespace {

using Severity = Finding::Severity;

bool feelTheSame(const Surface& a, const Surface& b) {
    return a.material == b.material && a.shading == b.shading && a.layers == b.layers && a.sides == b.sides;
}

/// A surface of `from`, with the object that it is of.
struct Place {
    const SceneObject* object;
    const Surface* surface;
};

class Carrier {
public:
    explicit Carrier(const Scene& from) : from_(from) {
        for (const SceneObject& object : from.objects)
            for (const Surface& surface : object.surfaces)
                named_[plainName(surface.name)].push_back({&object, &surface});
    }

    CarriedFeel carry(Scene& onto) {
        oneAlone_ = onlySurfaceOf(onto) ? onlySurfaceOf(from_) : std::nullopt;
        for (SceneObject& object : onto.objects)
            for (Surface& surface : object.surfaces) {
                if (const auto partner = partnerOf(object, surface))
                    give(*partner, object, surface);
                else
                    say(Severity::Warning, object.name,
                        "surface " + surface.name + " has no partner; it feels as it did",
                        "give it the name that it had, or set its feel by hand");
            }
        sayWhatIsLeft(onto);
        onto.proxyRadius = from_.proxyRadius;
        if (!onto.finger) onto.finger = from_.finger;
        return std::move(carried_);
    }

private:
    static std::optional<Place> onlySurfaceOf(const Scene& scene) {
        if (scene.objects.size() != 1 || scene.objects[0].surfaces.size() != 1) return std::nullopt;
        return Place{&scene.objects[0], &scene.objects[0].surfaces[0]};
    }

    std::optional<Place> partnerOf(const SceneObject& object, const Surface& surface) const {
        if (const auto found = named_.find(plainName(surface.name)); found != named_.end()) {
            const std::vector<Place>& places = found->second;
            for (const Place& place : places)
                if (plainName(place.object->name) == plainName(object.name)) return place;
            if (std::ranges::all_of(places, [&](const Place& place) {
                    return feelTheSame(*place.surface, *places.front().surface);
                }))
                return places.front();
        }
        if (oneAlone_) return oneAlone_; // a mesh file is called as the person calls it
        if (object.surfaces.size() != 1) return std::nullopt;
        const auto same = std::ranges::find_if(from_.objects, [&](const SceneObject& other) {
            return plainName(other.name) == plainName(object.name) && other.surfaces.size() == 1;
        });
        if (same == from_.objects.end()) return std::nullopt;
        return Place{&*same, &same->surfaces.front()};
    }

    /// Corner for corner: a value for each vertex of one is for those of the other.
    static bool haveSameCorners(const TriangleSoup& a, const TriangleSoup& b) {
        return a.positions.size() == b.positions.size() && a.triangles == b.triangles;
    }

    void give(const Place& from, const SceneObject& object, Surface& surface) {
        const Surface& partner = *from.surface;
        used_.insert(&partner);
        ++carried_.surfaces;
        surface.material = partner.material;
        surface.shading = partner.shading;
        surface.sides = partner.sides;
        surface.visible = partner.visible;
        surface.locked = partner.locked;
        surface.layers.clear();
        std::size_t painted = 0, withoutUvs = 0;
        for (const TextureLayer& layer : partner.layers) {
            const bool isPainted = layer.pattern.source == TextureSource::Painted ||
                                   (layer.mask && layer.mask->source == TextureSource::Painted);
            if (isPainted && !haveSameCorners(*from.object->geometry, *object.geometry)) {
                ++painted;
                continue;
            }
            withoutUvs += usesUvs(layer.pattern) && object.geometry->cornerUvs.empty();
            surface.layers.push_back(layer);
        }
        CountedFindings counted(carried_.findings, object.name);
        counted.add(Severity::Warning, painted, "painted layer",
                    "of surface " + surface.name + " left out, for the vertices are others",
                    "paint it again");
        counted.add(Severity::Warning, withoutUvs, "layer",
                    "of surface " + surface.name + " lies on texture coordinates, which the mesh has not",
                    "export it with them, or choose another mapping");
    }

    void sayWhatIsLeft(const Scene& onto) {
        for (const SceneObject& object : from_.objects)
            for (const Surface& surface : object.surfaces)
                if (!used_.contains(&surface))
                    say(Severity::Warning, object.name,
                        "surface " + surface.name + " of the scene with the feel has no partner",
                        "its feel is not in the result");
        if (!from_.mechanics.bodies.empty() && onto.mechanics.bodies.empty())
            say(Severity::Warning, "", counted(from_.mechanics.bodies.size(), "body") + " left out",
                "make the bodies again, for they are made of shapes");
    }

    void say(Severity severity, const std::string& object, std::string sentence, const char* remedy) {
        carried_.findings.push_back({severity, object, std::move(sentence), remedy});
    }

    const Scene& from_;
    std::map<std::string, std::vector<Place>> named_;
    std::set<const Surface*> used_;
    std::optional<Place> oneAlone_; ///< of `from`, where neither scene has another
    CarriedFeel carried_;
};

} // namespace

std::string plainName(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || dot == 0 || name.size() - dot != 4) return name;
    const bool numbered = std::all_of(name.begin() + std::ptrdiff_t(dot) + 1, name.end(), [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
    });
    return numbered ? name.substr(0, dot) : name;
}

CarriedFeel carryFeel(const Scene& from, Scene& onto) {
    return Carrier(from).carry(onto);
}

} // namespace tactum
