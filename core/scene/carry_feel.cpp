#include "core/scene/carry_feel.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/scene/groups.h"
#include "core/scene/surface_colours.h"

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

/// Whether every vertex is where that of the same number was, in its own frame, but for rounding, a move and
/// a size: files round, and are of another unit.
bool areOneShape(const TriangleSoup& a, const TriangleSoup& b) {
    if (&a == &b) return true;
    constexpr double kRounding = 1e-4; // of the size; what four decimals of a file leave of it
    const Bounds boxA = boundsOf(a), boxB = boundsOf(b);
    const double sizeA = boxA.diagonal(), sizeB = boxB.diagonal();
    if (sizeA == 0 || sizeB == 0) return sizeA == sizeB;
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        if (((a.positions[i] - boxA.low) / sizeA - (b.positions[i] - boxB.low) / sizeB).norm() > kRounding)
            return false;
    return true;
}

/// Whether the middle of each lies within the box around the other, in W.
bool areInOnePlace(const SceneObject& a, const SceneObject& b) {
    const auto boxOf = [](const SceneObject& object) {
        Bounds box;
        for (const Vec3& p : object.geometry->positions)
            box.add(object.pose.apply(p));
        return box;
    };
    const auto holds = [](const Bounds& box, const Vec3& p) {
        const double rounding = 1e-6 * box.diagonal();
        return ((p - box.low).array() >= -rounding).all() && ((box.high - p).array() >= -rounding).all();
    };
    const Bounds boxA = boxOf(a), boxB = boxOf(b);
    return holds(boxA, boxB.centre()) && holds(boxB, boxA.centre());
}

class Carrier {
public:
    /// `gone`: feel of surfaces that the scene had before.
    Carrier(const Scene& from, const std::vector<SceneObject>* gone) : from_(from), keeps_(gone) {
        for (const SceneObject& object : from.objects)
            for (const Surface& surface : object.surfaces)
                named_[plainName(surface.name)].push_back({&object, &surface});
        if (!gone) return;
        for (const SceneObject& object : *gone)
            for (const Surface& surface : object.surfaces)
                gone_.push_back({&object, &surface});
    }

    CarriedFeel carry(Scene& onto) {
        oneAlone_ = onlySurfaceOf(onto) ? onlySurfaceOf(from_) : std::nullopt;
        for (SceneObject& object : onto.objects) {
            givesColours_ = !isColoured(object);
            for (Surface& surface : object.surfaces) {
                if (const auto namesake = namesakeOf(object, surface)) {
                    ++carried_.surfaces;
                    give(*namesake, object, surface);
                } else if (const auto before = goneAs(object, surface)) {
                    ++carried_.back;
                    give(*before, object, surface);
                } else if (const auto likely = likelyPartnerOf(object, surface)) {
                    ++carried_.surfaces;
                    give(*likely, object, surface);
                } else
                    say(Severity::Warning, object.name,
                        "surface " + surface.name + " has no partner; it feels as it did",
                        "give it the name that it had, or set its feel by hand");
            }
        }
        carrySets(onto);
        carryGroups(onto);
        sayWhatIsLeft(onto);
        onto.proxyRadius = from_.proxyRadius;
        onto.reach = from_.reach;
        if (!onto.finger) onto.finger = from_.finger;
        for (SavedCamera camera : from_.cameras) {
            camera.kept = camera.keptCamera = {}; // of another file
            putCamera(onto, std::move(camera));
        }
        return std::move(carried_);
    }

private:
    static std::optional<Place> onlySurfaceOf(const Scene& scene) {
        if (scene.objects.size() != 1 || scene.objects[0].surfaces.size() != 1) return std::nullopt;
        return Place{&scene.objects[0], &scene.objects[0].surfaces[0]};
    }

    /// By both names.
    std::optional<Place> namesakeOf(const SceneObject& object, const Surface& surface) const {
        const auto found = named_.find(plainName(surface.name));
        if (found == named_.end()) return std::nullopt;
        for (const Place& place : found->second)
            if (plainName(place.object->name) == plainName(object.name)) return place;
        return std::nullopt;
    }

    std::optional<Place> likelyPartnerOf(const SceneObject& object, const Surface& surface) const {
        if (const auto found = named_.find(plainName(surface.name)); found != named_.end()) {
            const std::vector<Place>& places = found->second;
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

    /// By both names, for much may have come since.
    std::optional<Place> goneAs(const SceneObject& object, const Surface& surface) const {
        const auto same = std::ranges::find_if(gone_, [&](const Place& place) {
            return plainName(place.object->name) == plainName(object.name) &&
                   plainName(place.surface->name) == plainName(surface.name);
        });
        return same == gone_.end() ? std::nullopt : std::optional(*same);
    }

    /// Corner for corner: a value for each vertex of one is for those of the other.
    static bool haveSameCorners(const TriangleSoup& a, const TriangleSoup& b) {
        return a.positions.size() == b.positions.size() && a.triangles == b.triangles;
    }

    enum class Paint { Fits, OnAnotherShape, OtherVertices, OtherObject };

    /// What becomes of a value for each vertex.
    Paint paintOf(const SceneObject& from, const SceneObject& onto) const {
        if (!haveSameCorners(*from.geometry, *onto.geometry)) return Paint::OtherVertices;
        const bool sameShape = areOneShape(*from.geometry, *onto.geometry);
        const bool sameName = plainName(from.name) == plainName(onto.name);
        if (!sameName && !(oneAlone_ && sameShape) && !areInOnePlace(from, onto)) return Paint::OtherObject;
        return sameShape ? Paint::Fits : Paint::OnAnotherShape;
    }

    void give(const Place& from, const SceneObject& object, Surface& surface) {
        const Surface& partner = *from.surface;
        used_.insert(&partner);
        surface.material = partner.material;
        surface.shading = partner.shading;
        surface.sides = partner.sides;
        surface.visible = partner.visible;
        surface.locked = partner.locked;
        if (givesColours_) surface.colour = partner.colour;
        giveLayers(from, object, surface);
    }

    void giveLayers(const Place& from, const SceneObject& object, Surface& surface) {
        surface.layers.clear();
        std::size_t painted = 0, withoutUvs = 0;
        for (const TextureLayer& layer : from.surface->layers) {
            const bool isPainted = layer.pattern.source == TextureSource::Painted ||
                                   (layer.mask && layer.mask->source == TextureSource::Painted);
            const Paint paint = isPainted ? paintOf(*from.object, object) : Paint::Fits;
            painted += isPainted;
            if (paint == Paint::OtherVertices || paint == Paint::OtherObject) continue;
            withoutUvs += usesUvs(layer.pattern) && object.geometry->cornerUvs.empty();
            surface.layers.push_back(layer);
        }
        if (painted > 0) sayPaint(paintOf(*from.object, object), painted, object, surface);
        CountedFindings counted(carried_.findings, object.name);
        counted.add(Severity::Warning, withoutUvs, "layer",
                    "of surface " + surface.name + " lies on texture coordinates, which the mesh has not",
                    "export it with them, or choose another mapping");
    }

    void sayPaint(Paint paint, std::size_t layers, const SceneObject& object, const Surface& surface) {
        if (paint == Paint::Fits) return;
        if (paint != Paint::OnAnotherShape) carried_.layersLost += layers;
        CountedFindings counted(carried_.findings, object.name);
        counted.add(Severity::Warning, layers, "painted layer",
                    "of surface " + surface.name +
                        (paint == Paint::OnAnotherShape
                             ? " carried vertex by vertex onto a shape that is not the same"
                         : paint == Paint::OtherVertices ? " left out, for the vertices are others"
                                                         : " left out, for it was painted on another object"),
                    paint == Paint::OnAnotherShape ? "look whether the paint lies where it should"
                                                   : "paint it again");
    }

    /// By the names of the objects.
    void carryGroups(Scene& onto) {
        std::map<std::string, std::string> groups;
        for (const SceneObject& from : from_.objects)
            groups.try_emplace(plainName(from.name), from.group);
        for (SceneObject& object : onto.objects)
            if (const auto found = groups.find(plainName(object.name)); found != groups.end())
                object.group = found->second;
        gatherGroups(onto);
    }

    /// By the names of the objects; triangles that are not those of before are in no set.
    void carrySets(Scene& onto) {
        for (const SceneObject& from : from_.objects) {
            if (from.sets.empty()) continue;
            const auto named = [&](const SceneObject& object) {
                return plainName(object.name) == plainName(from.name);
            };
            const auto same = oneAlone_ ? onto.objects.begin() : std::ranges::find_if(onto.objects, named);
            if (same != onto.objects.end() && haveSameCorners(*from.geometry, *same->geometry))
                same->sets = from.sets;
            else {
                std::string names;
                for (const NamedTriangles& each : from.sets)
                    names += (names.empty() ? "" : ", ") + each.name;
                say(Severity::Warning, from.name,
                    "selection sets left out, for the triangles are others: " + names,
                    "select their triangles again, and keep them under the same names");
            }
        }
    }

    void sayWhatIsLeft(const Scene& onto) {
        for (const SceneObject& object : from_.objects)
            keepWhatIsLeft(object);
        for (const Place& place : gone_)
            if (!used_.contains(place.surface)) keepAsGone(*place.object, *place.surface);
        carried_.bodiesLost = onto.mechanics.bodies.empty() ? from_.mechanics.bodies.size() : 0;
        if (carried_.bodiesLost > 0)
            say(Severity::Warning, "", counted(carried_.bodiesLost, "body") + " left out",
                "make the bodies again, for they are made of shapes");
    }

    void keepWhatIsLeft(const SceneObject& object) {
        for (const Surface& surface : object.surfaces) {
            if (used_.contains(&surface)) continue;
            ++carried_.surfacesLost;
            keepAsGone(object, surface);
            say(Severity::Warning, object.name,
                "surface " + surface.name + " of the scene with the feel has no partner",
                keeps_ ? "its feel is kept for when the file has it again" : "its feel is not in the result");
        }
    }

    /// The newest of a name comes first, and is found first.
    void keepAsGone(const SceneObject& object, const Surface& surface) {
        SceneObject alone = object;
        alone.surfaces = {surface};
        carried_.gone.push_back(std::move(alone));
    }

    void say(Severity severity, const std::string& object, std::string sentence, const char* remedy) {
        carried_.findings.push_back({severity, object, std::move(sentence), remedy});
    }

    const Scene& from_;
    const bool keeps_; ///< what finds no partner now
    std::vector<Place> gone_;
    std::map<std::string, std::vector<Place>> named_;
    std::set<const Surface*> used_;
    std::optional<Place> oneAlone_; ///< of `from`, where neither scene has another
    bool givesColours_ = false;     ///< to the object that gets feel now: its file says none
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

CarriedFeel carryFeel(const Scene& from, Scene& onto, const std::vector<SceneObject>* gone) {
    return Carrier(from, gone).carry(onto);
}

} // namespace tactum
