// The document's selection, and the edits that change which triangles are of which surface.
#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "core/geometry/surfaces.h"
#include "core/paint/carry.h"
#include "core/scene/selection_sets.h"
#include "core/scene/surface_colours.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

/// What most of the triangles are of.
Index mainSurfaceOf(const SceneObject& object, const TriangleSet& faces) {
    std::vector<std::size_t> counts(object.surfaces.size());
    for (const Index face : faces)
        ++counts[object.geometry->surfaceOf[face]];
    return Index(std::ranges::max_element(counts) - counts.begin());
}

/// "lid 2": `name` with the first number that no surface of the object has.
std::string freshName(const SceneObject& object, const std::string& name) {
    for (int number = 2;; ++number) {
        std::string fresh = name + " " + std::to_string(number);
        if (std::ranges::find(object.surfaces, fresh, &Surface::name) == object.surfaces.end()) return fresh;
    }
}

std::vector<std::size_t> countTriangles(const TriangleSoup& soup, std::size_t surfaces) {
    std::vector<std::size_t> counts(surfaces);
    for (const Index surface : soup.surfaceOf)
        ++counts[surface];
    return counts;
}

/// Without the surfaces that have a triangle in the object's mesh and none in `soup`, the same mesh with
/// triangles on other surfaces.
SceneObject regrouped(SceneObject object, const TriangleSoup& soup) {
    const auto before = countTriangles(*object.geometry, object.surfaces.size());
    const auto after = countTriangles(soup, object.surfaces.size());
    std::vector<Index> number;
    std::vector<Surface> kept;
    for (std::size_t i = 0; i < after.size(); ++i) {
        number.push_back(Index(kept.size()));
        if (after[i] > 0 || before[i] == 0) kept.push_back(std::move(object.surfaces[i]));
    }
    object.surfaces = std::move(kept);
    object.geometry = std::make_shared<const TriangleSoup>(renumbered(soup, number));
    return object;
}

/// The triangles as a surface of their own, the last one, in another colour. Those of locked surfaces stay
/// where they are.
Result<SceneObject> split(SceneObject object, const TriangleSet& faces) {
    TriangleSet free;
    std::ranges::copy_if(faces, std::back_inserter(free), [&](Index face) {
        return !object.surfaces[object.geometry->surfaceOf[face]].locked;
    });
    if (free.empty()) return inputError("The selected triangles are of locked surfaces; unlock them first.");
    const Index main = mainSurfaceOf(object, free);
    if (free.size() == countTriangles(*object.geometry, object.surfaces.size())[main] &&
        object.geometry->surfaceOf[free.front()] == main)
        return inputError("The selected triangles are all of " + object.surfaces[main].name +
                          ": it is a surface of its own already.");
    const TriangleSoup soup = withSurface(*object.geometry, free, Index(object.surfaces.size()));
    Surface part = object.surfaces[mainSurfaceOf(object, free)];
    part.name = freshName(object, part.name);
    part.colour = colourApartFrom(object.surfaces);
    object.surfaces.push_back(std::move(part));
    return regrouped(std::move(object), soup);
}

/// One surface in the place of the lowest, like the active one.
SceneObject merge(SceneObject object, const MergedSurfaces& merged, Index active) {
    std::vector<Surface> kept(merged.count);
    for (std::size_t i = 0; i < object.surfaces.size(); ++i)
        if (merged.newNumber[i] != merged.merged || i == active)
            kept[merged.newNumber[i]] = std::move(object.surfaces[i]);
    object.surfaces = std::move(kept);
    object.geometry = std::make_shared<const TriangleSoup>(renumbered(*object.geometry, merged.newNumber));
    return object;
}

} // namespace

std::optional<SurfaceRef> Document::selection() const {
    return selected_.empty() ? std::nullopt : std::optional(selected_.back());
}

std::vector<ObjectId> Document::selectedObjects() const {
    std::set<ObjectId> chosen;
    for (const SurfaceRef ref : selected_)
        chosen.insert(ref.object);
    std::vector<ObjectId> objects;
    for (const SceneObject& object : scene_.objects)
        if (chosen.contains(object.id)) objects.push_back(object.id);
    return objects;
}

void Document::selectObjects(const std::vector<ObjectId>& objects, SelectMode mode) {
    SurfaceRefs all;
    for (const ObjectId id : objects)
        if (const SceneObject* object = scene_.find(id))
            for (Index i = 0; i < Index(object->surfaces.size()); ++i)
                all.push_back({id, i});
    select(all, mode);
}

void Document::select(const SurfaceRefs& refs, SelectMode mode) {
    lost_.clear();
    setSelection(joined(selected_, refs, mode));
}

void Document::setSelection(SurfaceRefs refs) {
    std::erase_if(refs, [this](SurfaceRef ref) { return !surface(ref); });
    if (refs == selected_) return;
    selected_ = std::move(refs);
    rememberNames();
    emit changed({SceneChange::What::Selection});
}

void Document::rememberNames() {
    selectedNames_.clear();
    for (const SurfaceRef ref : selected_)
        selectedNames_.push_back(surface(ref) ? surface(ref)->name : std::string());
}

/// The surface of that name; where there is none, a reference to nothing.
SurfaceRef Document::named(SurfaceRef ref, const std::string& name) const {
    const SceneObject* object = scene_.find(ref.object);
    if (!object || (ref.surface < object->surfaces.size() && object->surfaces[ref.surface].name == name))
        return ref;
    const auto found = std::ranges::find(object->surfaces, name, &Surface::name);
    return {ref.object, Index(found - object->surfaces.begin())};
}

void Document::selectFaces(FaceSelection faces, SelectMode mode) {
    FaceSelection next = joined(faces_, faces, mode);
    const SceneObject* object = scene_.find(next.object);
    if (!object || next.empty() || next.faces.back() >= object->geometry->triangles.size()) next = {};
    if (next == faces_) return;
    faces_ = std::move(next);
    emit changed({SceneChange::What::Selection});
}

SceneTriangles Document::selectedTriangles() const {
    if (!faces_.empty()) return {{faces_.object, faces_.faces}};
    SceneTriangles all;
    const SurfaceSet chosen(selected_);
    for (const ObjectId id : selectedObjects()) {
        const auto& surfaceOf = scene_.find(id)->geometry->surfaceOf;
        TriangleSet triangles;
        for (Index t = 0; t < surfaceOf.size(); ++t)
            if (chosen.has({id, surfaceOf[t]})) triangles.push_back(t);
        if (!triangles.empty()) all[id] = std::move(triangles);
    }
    return all;
}

std::size_t Document::selectTriangles(const SceneTriangles& triangles) {
    SurfaceRefs touched;
    bool whole = true;
    for (const auto& [id, set] : triangles) {
        const SceneObject& object = *scene_.find(id);
        const auto all = countTriangles(*object.geometry, object.surfaces.size());
        std::vector<std::size_t> taken(all.size());
        for (const Index t : set)
            ++taken[object.geometry->surfaceOf[t]];
        for (Index i = 0; i < all.size(); ++i) {
            if (taken[i] == 0) continue;
            touched.push_back({id, i});
            whole = whole && taken[i] == all[i];
        }
    }
    if (whole || triangles.empty()) {
        selectFaces({});
        select(touched);
        return 0;
    }
    const auto active = selection();
    auto chosen = active ? triangles.find(active->object) : triangles.end();
    if (chosen == triangles.end())
        chosen = std::ranges::max_element(triangles, {}, [](const auto& part) { return part.second.size(); });
    std::erase_if(touched, [&](SurfaceRef ref) { return ref.object != chosen->first; });
    select(touched);
    selectFaces({chosen->first, chosen->second});
    return triangles.size() - 1;
}

// Meshes with other triangles than before have lost what was selected of them. Where triangles went to other
// surfaces the numbers of all may be others: a surface is known by its name.
void Document::keepSelection(const SceneChange& change) {
    if (change.what == SceneChange::What::Names) rememberNames();
    const auto followed = [&](SurfaceRefs refs, const std::vector<std::string>& names) {
        for (std::size_t i = 0; i < refs.size() && i < names.size(); ++i)
            refs[i] = named(refs[i], names[i]);
        return refs;
    };
    const SurfaceRefs now = followed(selected_, selectedNames_), back = followed(lost_, lostNames_);
    const auto exists = [this](SurfaceRef ref) { return surface(ref) != nullptr; };
    if (!std::ranges::all_of(now, exists)) {
        lost_ = selected_;
        lostNames_ = selectedNames_;
        setSelection(now);
    } else if (!lost_.empty() && std::ranges::all_of(back, exists)) {
        lost_.clear();
        setSelection(joined(now, back, SelectMode::Add));
    } else {
        setSelection(now);
    }
    if (change.touchesShape() && !faces_.empty()) selectFaces({}, SelectMode::Replace);
}

SceneObject withGeometry(SceneObject object, std::shared_ptr<const TriangleSoup> geometry) {
    const auto before = std::exchange(object.geometry, std::move(geometry));
    const auto carry = [&](TexturePattern& pattern) {
        pattern.painted.values = carriedPaint(pattern.painted.values, *before, *object.geometry);
    };
    for (Surface& surface : object.surfaces)
        for (TextureLayer& layer : surface.layers) {
            carry(layer.pattern);
            if (layer.mask) carry(*layer.mask);
        }
    carrySets(*before, object);
    return object;
}

void Document::setObject(const SceneObject& object, const QString& text) {
    changeObjectNow(object.id, text, [&](SceneObject& each) { each = object; });
}

void Document::changeObject(ObjectId id, const QString& text, const ObjectWork& work,
                            const std::function<void()>& then) {
    const SceneObject* object = scene_.find(id);
    if (!object) return;
    editing_.start(
        [this, text, work, then, before = *object](const Progress& progress) -> BackgroundJob::Delivery {
            auto after = std::make_shared<Result<SceneObject>>(work(before, progress));
            return [this, text, then, before, after] {
                if (!*after) return emit editEnded(QString::fromStdString(after->error().text));
                const SceneObject* now = scene_.find(before.id);
                if (!now || !(*now == before))
                    return emit editEnded(
                        tr("%1 was left out: the object was changed meanwhile. Do it again.").arg(text));
                changeObjectNow(before.id, text, [&](SceneObject& each) { each = std::move(**after); });
                if (then) then();
                emit editEnded({});
            };
        });
}

void Document::splitSelection() {
    if (faces_.empty()) return;
    const ObjectId id = faces_.object;
    changeObject(
        id, tr("Split off %n triangle(s)", nullptr, int(faces_.faces.size())),
        [faces = faces_.faces](const SceneObject& object, const Progress&) { return split(object, faces); },
        [this, id] {
            select(SurfaceRef{id, Index(scene_.find(id)->surfaces.size() - 1)});
        });
}

void Document::mergeSelected() {
    const auto active = selection();
    if (!active) return;
    std::vector<Index> surfaces;
    for (const SurfaceRef ref : selected_)
        if (ref.object == active->object && !surface(ref)->locked) surfaces.push_back(ref.surface);
    if (surfaces.size() < 2 || surface(*active)->locked)
        return emit editEnded(tr("Select two or more surfaces of one object that are not locked, and merge "
                                 "them then."));
    const auto count = Index(scene_.find(active->object)->surfaces.size());
    const MergedSurfaces merged = mergeSurfaces(count, surfaces);
    changeObject(
        active->object, tr("Merge %1").arg(namesOf(selected_)),
        [merged, like = active->surface](const SceneObject& whole, const Progress&) {
            return Result<SceneObject>(merge(whole, merged, like));
        },
        [this, place = SurfaceRef{active->object, merged.merged}] { select(place); });
}

} // namespace tactum
