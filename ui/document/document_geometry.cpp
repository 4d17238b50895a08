// The document and the model that its geometry is from: shapes that another program has changed.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/text.h"
#include "core/files/source.h"
#include "core/import/import_scene.h"
#include "core/scene/carry_feel.h"
#include "core/scene/groups.h"
#include "core/scene/keep_places.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

bool areOfOneKind(const std::filesystem::path& a, const std::filesystem::path& b) {
    return lowerCase(a.extension().string()) == lowerCase(b.extension().string());
}

std::size_t surfacesOf(const Scene& scene) {
    std::size_t count = 0;
    for (const SceneObject& object : scene.objects)
        count += object.surfaces.size();
    return count;
}

/// What neither the feel nor the places tell.
void sayWhatTheFileLacks(std::vector<Finding>& findings, const Scene& now, const Scene& onto, bool placed) {
    using Severity = Finding::Severity;
    if (!placed)
        findings.push_back({Severity::Note, "", "objects are where and as large as the file has them",
                            "move them again where you had moved them"});
    if (now.kept.foreign && !onto.kept.foreign)
        findings.push_back({Severity::Note, "",
                            "what other programs had put into the file before is left out",
                            "save under another name, and take it from there"});
}

/// Beside other notes, for a size that nobody meant is easily overlooked.
void sayTheSize(std::vector<Finding>& findings, const GeometryUpdate& told) {
    if (told.axes)
        findings.push_back({Finding::Severity::Warning, "",
                            "the file says no unit, and that of before would make it far larger or smaller "
                            "than it was: another one is taken",
                            "choose in the bar over the view if that is wrong"});
}

/// What came into the scene besides the file that it began with; of a new scene, what the file that is read
/// has no name for.
std::vector<ObjectId> fromElsewhere(const Scene& now, const std::optional<Scene>& file, const Scene& onto) {
    const auto hasName = [&](const SceneObject& object) {
        return std::ranges::any_of(onto.objects, [name = plainName(object.name)](const SceneObject& other) {
            return plainName(other.name) == name;
        });
    };
    std::vector<ObjectId> others;
    for (const SceneObject& object : now.objects)
        if (file ? !file->find(object.id) : !hasName(object)) others.push_back(object.id);
    return others;
}

/// What is arranged with them and is theirs: of bodies those that move nothing else.
GoingAlong partsOf(const Scene& scene, const std::vector<ObjectId>& objects) {
    GoingAlong parts = goingAlong(scene, objects);
    parts.objects = objects;
    std::erase_if(parts.bodies, [&](BodyId body) {
        return std::ranges::any_of(scene.objects, [&](const SceneObject& object) {
            return object.body == body && !parts.has(object.id);
        });
    });
    return parts;
}

/// What is from elsewhere, under its numbers, beside the new shapes.
void putBack(Scene& onto, const Scene& whole, const std::vector<ObjectId>& others) {
    if (others.empty()) return;
    ObjectId largest = 0;
    for (const Scene* scene : {&std::as_const(onto), &whole})
        for (const SceneObject& object : scene->objects)
            largest = std::max(largest, object.id);
    for (SceneObject& object : onto.objects)
        if (std::ranges::find(others, object.id) != others.end()) object.id = ++largest;
    Scene rest;
    rest.mechanics = whole.mechanics;
    rest.mechanics.bodies.clear(), rest.mechanics.joints.clear(), rest.mechanics.colliders.clear();
    addCopies(rest, whole, partsOf(whole, others));
    const std::size_t before = onto.objects.size();
    addScene(onto, std::move(rest), largest);
    for (std::size_t i = 0; i < others.size(); ++i)
        onto.objects[before + i].id = others[i],
                              onto.objects[before + i].group = whole.find(others[i])->group;
    gatherGroups(onto);
}

/// A mesh that is as it was is the one that is there: nothing of it has to be made anew, nor is it an edit.
void shareMeshes(const Scene& now, Scene& onto) {
    for (SceneObject& object : onto.objects)
        if (const SceneObject* same = now.find(object.id); same && *same->geometry == *object.geometry)
            object.geometry = same->geometry;
}

bool isAnotherSize(double grown) {
    constexpr double kOther = 3; // of units that are guessed, the nearest differ by 2.5
    return std::abs(std::log(grown)) > std::log(kOther);
}

} // namespace

/// A file that was read and taken as something.
struct Document::NewShapes {
    LoadedScene loaded;
    Source source;
    GeometryUpdate told;
    bool known = false; ///< of the source's format, so that its frame is the same
};

Result<Document::NewShapes> Document::readShapes(const Source& source, const std::filesystem::path& file,
                                                 const AxesChoice& choice, bool chosen,
                                                 const Progress& progress) {
    const FileStamp stamp(file);
    auto loaded = importScene(file, progress);
    if (!loaded) return tl::unexpected(loaded.error());
    if (!(FileStamp(file) == stamp))
        return inputError(shownPath(file) + ": another program is writing it; update again when it is done");
    NewShapes shapes;
    shapes.known = source.as && areOfOneKind(file, source.file.path);
    const double units = boundsOf(loaded->scene).diagonal();
    const double before = shapes.known ? boundsOf(*source.as).diagonal() : 0;
    AxesChoice axes = choice;
    std::optional<double> bySize;
    if (shapes.known && !chosen) {
        bySize = loaded->unitGuessed ? unitBySize(units, source.axes.unit, before) : std::nullopt;
        axes = {bySize.value_or(source.axes.unit), source.axes.zUp};
    }
    auto taken = takeAs(*loaded, axes);
    shapes.told.file = file;
    if (taken && shapes.known && before > 0 && units > 0)
        shapes.told.grown = units * (taken->unitOpen ? source.axes.unit : 1) / before;
    if (bySize) shapes.told.axesBefore = source.axes, shapes.told.axes = taken->axes;
    const bool asks = chosen || bySize || isAnotherSize(shapes.told.grown);
    if (taken && shapes.known && !chosen) taken->by = bySize ? TakenAs::By::Size : TakenAs::By::Before;
    shapes.source = {stamp, taken ? taken->axes : FileAxes(), loaded->scene,
                     taken && asks ? taken : std::nullopt};
    shapes.loaded = std::move(*loaded);
    return shapes;
}

Result<Document::Updated> Document::updated(const Scene& whole, const Source& source, NewShapes shapes) {
    LoadedScene& loaded = shapes.loaded;
    Scene& onto = loaded.scene;
    const bool known = source.as || source.file.path.empty();
    const auto others = known ? fromElsewhere(whole, source.as, onto) : std::vector<ObjectId>();
    Scene now = whole;
    tactum::removeObjects(now, others);
    Updated updated{{}, std::move(shapes.source), std::move(shapes.told)};
    GeometryUpdate& told = updated.told;
    std::vector<Finding>& findings = told.findings;
    if (shapes.known)
        findings = keepPlaces(*source.as, now, onto);
    else {
        if (!loaded.ours) onto = fitted(std::move(onto));
        keepIds(now, onto);
    }
    shareMeshes(now, onto);
    CarriedFeel carried = carryFeel(now, onto, &source.gone);
    if (carried.surfaces + carried.back == 0)
        return inputError(shownPath(told.file) +
                          ": no surface has the name of one in the scene; name the materials alike");
    std::ranges::move(carried.findings, std::back_inserter(findings));
    sayTheSize(findings, told);
    sayWhatTheFileLacks(findings, now, onto, shapes.known);
    // Notes about meshes were there before; what is wrong with one is looked for anew, and listed as a
    // problem.
    std::ranges::copy_if(loaded.findings, std::back_inserter(findings), [](const Finding& finding) {
        return finding.severity != Finding::Severity::Note && !saysHealth(finding);
    });
    told.withFeel = carried.surfaces + carried.back;
    told.back = carried.back;
    told.surfacesLost = carried.surfacesLost;
    told.layersLost = carried.layersLost;
    told.bodiesLost = carried.bodiesLost;
    told.surfaces = surfacesOf(onto);
    told.surfacesBefore = surfacesOf(now);
    updated.source.gone = std::move(carried.gone);
    putBack(onto, whole, others);
    updated.scene = std::move(onto);
    return updated;
}

void Document::takeOtherwise(const AxesChoice& choice) {
    if (const TakenFile* added = justAdded())
        startAdding({{added->file, choice}}, history_.index());
    else if (justUpdated())
        startUpdate(source_.file.path, choice, true);
    else
        reopen(choice);
}

void Document::startUpdate(const std::filesystem::path& file, const AxesChoice& choice, bool chosen) {
    editing_.start([=, this, now = scene_, source = source_,
                    of = scenes_](const Progress& progress) -> BackgroundJob::Delivery {
        auto shapes = readShapes(source, file, choice, chosen, progress);
        auto result = std::make_shared<Result<Updated>>(shapes ? updated(now, source, std::move(*shapes))
                                                               : tl::unexpected(shapes.error()));
        return [=, this] {
            if (!*result) return emit editEnded(QString::fromStdString(result->error().text));
            if (of != scenes_ || !(scene_ == now))
                return emit editEnded(tr("%1 was left out: the scene was edited meanwhile. Update it again.")
                                          .arg(QString::fromStdU16String(file.filename().u16string())));
            Updated& updated = **result;
            updated.told.changed = !(updated.scene == scene_) || !(updated.source.axes == source_.axes);
            const GeometryUpdate told = updated.told;
            takeGeometry(std::move(updated));
            emit editEnded({});
            emit geometryUpdated(told);
        };
    });
    emit editProgressed(0, -1);
}

} // namespace tactum
