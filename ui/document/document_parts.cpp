// The document and the objects that come into it, are doubled, and go.
#include <algorithm>

#include "core/import/import_scene.h"
#include "core/scene/groups.h"
#include "core/scene/object_bounds.h"
#include "core/scene/placing.h"
#include "core/scene/standing.h"
#include "ui/document/document.h"

namespace tactum {

/// What is about to come in.
struct Document::ReadPart {
    Scene scene;
    std::vector<Finding> findings;
    std::filesystem::path file; ///< empty: it was made here
    std::optional<TakenAs> taken;
};
struct Document::ReadParts {
    std::vector<ReadPart> parts;
    SceneAddition told;
};

QString Document::title() const {
    return path().empty() ? tr("New scene") : QString::fromStdU16String(path().filename().u16string());
}

std::filesystem::path Document::takenFile() const {
    const TakenFile* added = justAdded();
    return added ? added->file : source_.file.path;
}

double Document::takenAcross() const {
    const TakenFile* added = justAdded();
    return (added ? boundsOf(scene_, added->objects) : boundsOf(scene_)).diagonal();
}

QString Document::namesOf(const std::vector<ObjectId>& objects) const {
    const SceneObject* only = objects.size() == 1 ? scene_.find(objects.front()) : nullptr;
    return only ? QString::fromStdString(only->name) : tr("%1 objects").arg(objects.size());
}

Document::ReadParts Document::readParts(const std::vector<FileToAdd>& files, const Progress& progress) {
    ReadParts read;
    const double count = double(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& [file, choice] = files[i];
        auto loaded = importScene(file, partOf(progress, double(i) / count, double(i + 1) / count));
        if (progress.isCancelled()) return {{}, {{}, {}, {}, {loaded ? "cancelled" : loaded.error().text}}};
        if (!loaded) {
            read.told.refused.push_back(loaded.error().text);
            continue;
        }
        auto taken = takeAs(*loaded, choice);
        if (const double across = boundsOf(loaded->scene).diagonal(); !loaded->ours && !fitsHand(across)) {
            loaded->scene = fitted(std::move(loaded->scene));
            read.told.scaled.emplace_back(file, across);
        }
        read.told.files.push_back(file);
        read.parts.push_back({std::move(loaded->scene), std::move(loaded->findings), file, taken});
    }
    return read;
}

// What is there is looked at when it comes in: it may be edited while files are read.
void Document::startAdding(const std::vector<FileToAdd>& files, std::optional<int> inPlaceOf) {
    if (files.empty()) return;
    if (!isOpen()) begin({});
    adding_ = true;
    job_.start([=, this, of = scenes_](const Progress& progress) -> BackgroundJob::Delivery {
        auto read = std::make_shared<ReadParts>(readParts(files, progress));
        return [=, this] {
            if (read->parts.empty())
                return emit openFailed(QString::fromStdString(read->told.refused.front()));
            const bool edited = of != scenes_ || (inPlaceOf && (inPlaceOf != history_.index() || !takenAs()));
            if (edited)
                return emit openFailed(
                    tr("%1 was left out: the scene was edited meanwhile. Add it again.")
                        .arg(QString::fromStdU16String(files[0].file.filename().u16string())));
            if (inPlaceOf) history_.undo();
            bringIn(std::move(read->parts), std::move(read->told));
        };
    });
    emit openProgressed(0, -1);
}

void Document::add(Scene scene) {
    if (scene.objects.empty()) return;
    if (!isOpen()) begin({});
    std::vector<ReadPart> parts;
    parts.push_back({std::move(scene), {}, {}, {}});
    bringIn(std::move(parts), {});
}

void Document::bringIn(std::vector<ReadPart> parts, SceneAddition told) {
    Scene next = scene_;
    for (ReadPart& part : parts) {
        moveScene(part.scene, wayToRoom(next, boundsOf(part.scene)));
        std::vector<std::string> names;
        for (const SceneObject& object : part.scene.objects)
            names.push_back(object.name);
        const std::vector<ObjectId> ids = addScene(next, std::move(part.scene), lastId_);
        lastId_ = std::max(lastId_, ids.empty() ? 0 : ids.back());
        for (Finding& finding : part.findings) {
            const auto at = std::ranges::find(names, finding.object) - names.begin();
            // What is said of the whole file goes when its first object goes.
            const std::size_t which = std::size_t(at) < names.size() ? std::size_t(at) : 0;
            if (!ids.empty()) findings_.push_back({std::move(finding), ids[which]});
        }
        told.objects.insert(told.objects.end(), ids.begin(), ids.end());
    }
    std::optional<TakenFile> taken;
    if (parts.size() == 1 && parts[0].taken) taken = {parts[0].file, *parts[0].taken, told.objects};
    const QString what = told.files.size() > 1 ? tr("%1 files").arg(told.files.size())
                         : told.files.size() == 1
                             ? QString::fromStdU16String(told.files[0].filename().u16string())
                         : told.objects.size() > 1 ? tr("%1 objects").arg(told.objects.size())
                                                   : QString::fromStdString(next.objects.back().name);
    arrive(tr("Add %1").arg(what), std::move(next), std::move(taken));
    selectFaces({});
    selectObjects(told.objects);
    emit added(told);
}

void Document::duplicate(const std::vector<ObjectId>& objects) {
    const GoingAlong along = goingAlong(scene_, objects);
    if (along.objects.empty()) return;
    Scene moved = scene_, next = scene_;
    arrange(moved, along, {.move = wayBeside(scene_, boundsOf(scene_, along.objects))});
    const std::vector<ObjectId> copies = addCopies(next, moved, along, lastId_);
    gatherGroups(next);
    std::vector<ObjectId> chosen;
    for (std::size_t i = 0; i < copies.size(); ++i)
        if (std::ranges::find(objects, along.objects[i]) != objects.end()) chosen.push_back(copies[i]);
    arrive(tr("Duplicate %1").arg(namesOf(objects)), std::move(next), {});
    selectFaces({});
    selectObjects(chosen);
}

Removed Document::removeObjects(const std::vector<ObjectId>& objects) {
    std::vector<ObjectId> known = objects;
    std::erase_if(known, [this](ObjectId id) { return !scene_.find(id); });
    if (known.empty()) return {};
    Removed removed;
    const QString text = tr("Remove %1").arg(namesOf(known));
    editScene(text, SceneChange::What::Objects,
              [&](Scene& scene) { removed = tactum::removeObjects(scene, known); });
    return removed;
}

} // namespace tactum
