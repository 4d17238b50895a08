#include "ui/document/document.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "core/scene/groups.h"
#include "core/scene/placing.h"
#include "ui/base/numbers.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

Surface* find(Scene& scene, SurfaceRef ref) {
    SceneObject* object = scene.find(ref.object);
    return object && ref.surface < object->surfaces.size() ? &object->surfaces[ref.surface] : nullptr;
}

/// Where an edit finds an object; nullptr when it is gone.
std::function<SceneObject*(Scene&)> atObject(ObjectId id) {
    return [id](Scene& scene) { return scene.find(id); };
}

} // namespace

bool SceneChange::touchesShape() const {
    return what == What::Everything || what == What::Objects || what == What::Surfaces ||
           what == What::ProxyRadius;
}

Gesture newGesture() {
    static Gesture last = 0;
    return ++last;
}

/// A step of the history.
class Document::Step : public QUndoCommand {
public:
    using QUndoCommand::QUndoCommand;
    /// The scene on the other side of it.
    virtual void applyTo(Scene& scene) const = 0;
    /// The same of one that may be made of several, which are taken back from the last to the first.
    static void apply(const QUndoCommand& step, bool back, Scene& scene) {
        if (const auto* own = dynamic_cast<const Step*>(&step)) return own->applyTo(scene);
        const int count = step.childCount();
        for (int i = 0; i < count; ++i)
            apply(*step.child(back ? count - 1 - i : i), back, scene);
    }
};

/// What the history will say once of a step while the scene is so already.
struct Document::Already {
    bool redone = false, undone = false;
};

/// The one command: undo and redo are the same exchange of values.
template <class T> class Document::Exchange : public Step {
public:
    Exchange(Document& document, const QString& text, std::vector<Place<T>> places, std::vector<T> values,
             SceneChange change, Gesture gesture, Already already = {})
        : Step(text), document_(document), places_(std::move(places)), values_(std::move(values)),
          change_(change), gesture_(gesture), already_(already) {}

    /// As redo() does, before the history has it.
    void tryOut() {
        exchange();
        already_.redone = true;
    }
    void redo() override {
        if (!std::exchange(already_.redone, false)) go();
    }
    void undo() override {
        if (!std::exchange(already_.undone, false)) go();
    }
    void applyTo(Scene& scene) const override {
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (T* there = places_[i](scene)) *there = values_[i];
    }

    int id() const override { return gesture_ == 0 ? -1 : gesture_; }

    /// This one already holds the values from before the gesture, and the scene holds the newest.
    bool mergeWith(const QUndoCommand* next) override {
        const auto* other = dynamic_cast<const Exchange*>(next);
        if (!other || other->change_ != change_ || other->places_.size() != places_.size()) return false;
        setObsolete(changesNothing(document_.scene_, places_, values_));
        return true;
    }

    static bool changesNothing(Scene& scene, const std::vector<Place<T>>& places,
                               const std::vector<T>& values) {
        for (std::size_t i = 0; i < places.size(); ++i)
            if (const T* now = places[i](scene); now && !(*now == values[i])) return false;
        return true;
    }

protected:
    Document& document() { return document_; }

private:
    void go() {
        // The values are those of before the trial.
        if (document_.trial_.get() != this) document_.giveUpTrial(document_.trying_);
        exchange();
    }
    void exchange() {
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (T* now = places_[i](document_.scene_)) std::swap(*now, values_[i]);
        document_.announce(change_);
    }

    Document& document_;
    std::vector<Place<T>> places_;
    std::vector<T> values_; ///< one for each place
    SceneChange change_;
    Gesture gesture_;
    Already already_;
};

/// The file that shapes are from changes with them, there and back.
class Document::NewGeometry final : public Exchange<Scene> {
public:
    NewGeometry(Document& document, const QString& text, Scene scene, Source source)
        : Exchange(document, text, {[](Scene& now) { return &now; }}, {std::move(scene)},
                   {SceneChange::What::Objects}, 0),
          source_(std::move(source)) {}

    void redo() override {
        std::swap(document().source_, source_);
        Exchange::redo();
    }
    void undo() override {
        std::swap(document().source_, source_);
        Exchange::undo();
    }

private:
    Source source_;
};

/// Objects that have come, and as what their file was taken.
class Document::Arrival final : public Exchange<Scene> {
public:
    Arrival(Document& document, const QString& text, Scene scene, std::optional<TakenFile> taken)
        : Exchange(document, text, {[](Scene& now) { return &now; }}, {std::move(scene)},
                   {SceneChange::What::Objects}, 0),
          taken_(std::move(taken)) {}
    const TakenFile* taken() const { return taken_ ? &*taken_ : nullptr; }

    // What was selected when it came is selected again where it goes and nothing else is left selected.
    void redo() override {
        if (gone_.empty()) before_ = document().selected_;
        Exchange::redo();
        if (!gone_.empty()) document().setSelection(std::exchange(gone_, {}));
    }
    void undo() override {
        const SurfaceRefs selected = document().selected_;
        Exchange::undo();
        if (!document().selected_.empty()) return;
        gone_ = selected;
        document().setSelection(before_);
    }

private:
    std::optional<TakenFile> taken_;
    SurfaceRefs before_, gone_;
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&job_, &BackgroundJob::progressed, this, &Document::openProgressed);
    connect(&saving_, &BackgroundJob::progressed, this, &Document::saveProgressed);
    connect(&editing_, &BackgroundJob::progressed, this, &Document::editProgressed);
    connect(&saving_, &BackgroundJob::finished, this, [this] {
        if (nextSaves_.empty()) return;
        const auto next = std::move(nextSaves_.front());
        nextSaves_.pop_front();
        next();
    });
}

template <class T>
void Document::edit(const QString& text, std::vector<Place<T>> places, std::vector<T> values,
                    SceneChange change, Gesture gesture) {
    if (Exchange<T>::changesNothing(scene_, places, values)) return;
    auto step =
        std::make_unique<Exchange<T>>(*this, text, std::move(places), std::move(values), change, gesture);
    if (trying_ == 0 || gesture != trying_) {
        keepTrial(trying_);
        history_.push(step.release());
        return;
    }
    step->tryOut();
    if (!trial_ || !trial_->mergeWith(step.get())) {
        if (trial_) history_.push(trial_.release());
        trial_ = std::move(step);
    } else if (trial_->isObsolete()) {
        trial_.reset();
    }
}

template <class T>
void Document::edit(const QString& text, Place<T> place, T value, SceneChange change, Gesture gesture) {
    edit<T>(text, std::vector{std::move(place)}, std::vector<T>{std::move(value)}, change, gesture);
}

const Surface* Document::surface(SurfaceRef ref) const {
    return find(const_cast<Scene&>(scene_), ref);
}

SceneHistory Document::stepsAround(int most) const {
    SceneHistory around;
    Scene scene = scene_;
    const auto add = [&](std::vector<SceneHistory::Step>& steps, const QUndoCommand& step, bool back) {
        Step::apply(step, back, scene);
        steps.push_back({step.text().toStdString(), scene});
    };
    if (trial_) add(around.done, *trial_, true);
    const Scene present = scene;
    const int now = history_.index();
    for (int i = now - 1; i >= std::max(0, now - most); --i)
        add(around.done, *history_.command(i), true);
    scene = present;
    for (int i = now; !trial_ && i < std::min(history_.count(), now + most); ++i)
        add(around.undone, *history_.command(i), false);
    std::ranges::reverse(around.done);
    std::ranges::reverse(around.undone);
    return around;
}

// Its steps change nothing while they are put onto the history, and those that are undone not either while
// it comes back over them.
void Document::adoptRecovered(LoadedScene loaded, const FileStamp& file, bool own,
                              const SceneHistory& history) {
    job_.cancel();
    adopt(std::move(loaded), file);
    own_ = own;
    const auto push = [this](const SceneHistory::Step& step, Already already) {
        history_.push(new Exchange<Scene>(*this, QString::fromStdString(step.text),
                                          {[](Scene& scene) { return &scene; }}, {step.scene},
                                          {SceneChange::What::Objects}, 0, already));
    };
    for (const SceneHistory::Step& step : history.done)
        push(step, {.redone = true});
    for (const SceneHistory::Step& step : history.undone | std::views::reverse)
        push(step, {.redone = true, .undone = true});
    history_.setIndex(int(history.done.size()));
    history_.resetClean(); // no step leads to what is in the file
    emit opened();
}

std::vector<Finding> Document::findings() const {
    std::vector<Finding> now;
    for (const FileFinding& said : findings_) {
        const SceneObject* object = scene_.find(said.object);
        if (said.object != 0 && !object) continue;
        now.push_back(said.finding);
        if (object) now.back().object = object->name;
    }
    return now;
}

void Document::editSurfaces(const SurfaceRefs& refs, SceneChange::What what, const QString& text,
                            const std::function<void(Surface&)>& change, Gesture gesture) {
    std::vector<Place<Surface>> places;
    std::vector<Surface> values;
    for (const SurfaceRef ref : refs) {
        const Surface* now = surface(ref);
        if (!now || (now->locked && what != SceneChange::What::Names)) continue;
        places.push_back([ref](Scene& scene) { return find(scene, ref); });
        change(values.emplace_back(*now));
    }
    if (places.empty()) return;
    edit<Surface>(text.contains(QStringLiteral("%1")) ? text.arg(namesOf(refs)) : text, std::move(places),
                  std::move(values), {what, refs.front()}, gesture);
}

QString Document::namesOf(const SurfaceRefs& refs) const {
    const Surface* only = refs.size() == 1 ? surface(refs.front()) : nullptr;
    return only ? asIs(only->name) : tr("%1 surfaces").arg(refs.size());
}

void Document::setMaterialValue(const SurfaceRefs& refs, const MaterialField& field, double value,
                                Gesture gesture) {
    editSurfaces(
        refs, SceneChange::What::Material, tr("%1 of %2").arg(wordsOf(field.parameter->label), "%1"),
        [&](Surface& each) { each.material = withValue(each.material, field, value); }, gesture);
}

void Document::setShading(const SurfaceRefs& refs, const Shading& shading, Gesture gesture) {
    Shading safe = shading;
    safe.creaseAngle = kCreaseAngle.clamped(shading.creaseAngle);
    editSurfaces(
        refs, SceneChange::What::Shading, tr("Force shading of %1"),
        [&](Surface& each) { each.shading = safe; }, gesture);
}

void Document::setSides(const SurfaceRefs& refs, Sides sides) {
    editSurfaces(refs, SceneChange::What::Sides, tr("Felt sides of %1"),
                 [&](Surface& each) { each.sides = sides; });
}

void Document::setFeel(const SurfaceRefs& refs, const Feel& like, const QString& text) {
    const auto usesPaint = [](const TextureLayer& layer) {
        return layer.pattern.painted.values || (layer.mask && layer.mask->painted.values);
    };
    std::vector<TextureLayer> bare = like.surface.layers;
    std::erase_if(bare, usesPaint);
    SurfaceRefs free;
    for (const SurfaceRef ref : refs)
        if (const Surface* each = surface(ref); each && !each->locked) free.push_back(ref);
    std::size_t i = 0;
    editSurfaces(free, SceneChange::What::Shading, text, [&](Surface& each) {
        const SceneObject* object = scene_.find(free[i++].object);
        each.material = like.surface.material;
        each.shading = like.surface.shading;
        each.sides = like.surface.sides;
        each.layers = object->geometry == like.soup ? like.surface.layers : bare;
    });
}

Gesture Document::beginTrial() {
    keepTrial(trying_);
    return trying_ = newGesture();
}

void Document::keepTrial(Gesture gesture) {
    if (gesture != trying_) return;
    trying_ = 0;
    if (trial_) history_.push(trial_.release());
}

void Document::giveUpTrial(Gesture gesture) {
    if (gesture != trying_) return;
    trying_ = 0;
    if (const auto step = std::move(trial_)) step->undo();
}

void Document::setSurfacesVisible(const SurfaceRefs& refs, bool visible) {
    editSurfaces(refs, SceneChange::What::Surfaces, visible ? tr("Show %1") : tr("Hide %1"),
                 [&](Surface& each) { each.visible = visible; });
}

void Document::setLocked(const SurfaceRefs& refs, bool locked) {
    editSurfaces(refs, SceneChange::What::Names, locked ? tr("Lock %1") : tr("Unlock %1"),
                 [&](Surface& each) { each.locked = locked; });
}

void Document::isolate(const SurfaceRefs& refs) {
    editObjects(tr("Show %1 alone").arg(namesOf(refs)), {SceneChange::What::Objects},
                [alone = SurfaceSet(refs)](SceneObject& object) {
                    object.visible = false;
                    for (Index i = 0; i < object.surfaces.size(); ++i) {
                        const bool shown = alone.has({object.id, i});
                        object.surfaces[i].visible = shown;
                        object.visible = object.visible || shown;
                    }
                });
}

void Document::setProxyRadius(double metres, Gesture gesture) {
    edit<double>(
        tr("Proxy radius"), [](Scene& scene) { return &scene.proxyRadius; }, kProxyRadius.clamped(metres),
        {SceneChange::What::ProxyRadius}, gesture);
}

void Document::setReach(Reach reach, Gesture gesture) {
    reach.shell = kShellRadius.clamped(reach.shell);
    edit<Reach>(
        tr("Reach of the hand"), [](Scene& scene) { return &scene.reach; }, reach, {SceneChange::What::Names},
        gesture);
}

void Document::editObjects(const QString& text, SceneChange change,
                           const std::function<void(SceneObject&)>& each) {
    auto objects = scene_.objects;
    for (SceneObject& object : objects)
        each(object);
    edit<std::vector<SceneObject>>(
        text, [](Scene& scene) { return &scene.objects; }, std::move(objects), change);
}

void Document::changeObjectNow(ObjectId id, const QString& text,
                               const std::function<void(SceneObject&)>& change) {
    const SceneObject* now = scene_.find(id);
    if (!now) return;
    SceneObject value = *now;
    change(value);
    edit<SceneObject>(text, atObject(id), std::move(value), {SceneChange::What::Objects});
}

void Document::renameObject(ObjectId id, const QString& name) {
    auto place = [id](Scene& scene) {
        SceneObject* object = scene.find(id);
        return object ? &object->name : nullptr;
    };
    edit<std::string>(tr("Rename to %1").arg(name), place, name.toStdString(), {SceneChange::What::Names});
}

void Document::renameSurface(SurfaceRef ref, const QString& name) {
    editSurfaces(ref, SceneChange::What::Names, tr("Rename to %1").arg(name),
                 [&](Surface& each) { each.name = name.toStdString(); });
}

void Document::setVisible(ObjectId id, bool visible) {
    const SceneObject* object = scene_.find(id);
    if (!object) return;
    changeObjectNow(id, (visible ? tr("Show %1") : tr("Hide %1")).arg(asIs(object->name)),
                    [&](SceneObject& each) { each.visible = visible; });
}

void Document::showAll() {
    editObjects(tr("Show all"), {SceneChange::What::Objects}, [](SceneObject& object) {
        object.visible = true;
        for (Surface& each : object.surfaces)
            each.visible = true;
    });
}

void Document::editScene(const QString& text, SceneChange::What what,
                         const std::function<void(Scene&)>& change, Gesture gesture) {
    Scene value = scene_;
    change(value);
    edit<Scene>(
        text, [](Scene& scene) { return &scene; }, std::move(value), {what}, gesture);
}

void Document::editBodies(const QString& text, const std::function<void(Scene&)>& change, Gesture gesture) {
    editScene(
        text, SceneChange::What::Bodies,
        [&](Scene& scene) {
            change(scene);
            gatherGroups(scene); // a body is in one group
        },
        gesture);
}

void Document::replaceScene(const QString& text, const Scene& scene) {
    edit<Scene>(text, [](Scene& now) { return &now; }, scene, {SceneChange::What::Objects});
}

bool Document::justUpdated() const {
    const int last = history_.index() - 1;
    return last >= 0 && dynamic_cast<const NewGeometry*>(history_.command(last));
}

const Document::TakenFile* Document::justAdded() const {
    const int last = history_.index() - 1;
    const auto* step = last >= 0 ? dynamic_cast<const Arrival*>(history_.command(last)) : nullptr;
    return step ? step->taken() : nullptr;
}

const TakenAs* Document::takenAs() const {
    if (trial_ || history_.canRedo()) return nullptr;
    if (const TakenFile* added = justAdded()) return &added->as;
    return source_.taken && (history_.isClean() || justUpdated()) ? &*source_.taken : nullptr;
}

void Document::arrive(const QString& text, Scene next, std::optional<TakenFile> taken) {
    keepTrial(trying_);
    history_.push(new Arrival(*this, text, std::move(next), std::move(taken)));
}

void Document::takeGeometry(Updated updated) {
    if (!updated.told.changed) {
        if (!updated.source.taken) updated.source.taken = source_.taken;
        source_ = std::move(updated.source); // there is nothing to take back
        return;
    }
    keepTrial(trying_);
    const QString name = QString::fromStdU16String(updated.source.file.path.filename().u16string());
    history_.push(new NewGeometry(*this, tr("Update geometry from %1").arg(name), std::move(updated.scene),
                                  std::move(updated.source)));
}

void Document::scaleScene(double factor) {
    Scene scaled = scene_;
    fitDiagonal(scaled, factor * boundsOf(scene_).diagonal());
    edit<Scene>(tr("Scale the scene"), [](Scene& scene) { return &scene; }, std::move(scaled),
                {SceneChange::What::Everything});
}

Scene Document::fitted(Scene scene) {
    if (!fitsHand(boundsOf(scene).diagonal())) fitDiagonal(scene, kHandDiagonal);
    return scene;
}

void Document::fit(const Scene& fitted) {
    if (fitted == scene_) return;
    const double before = boundsOf(scene_).diagonal();
    edit<Scene>(tr("Scale to fit the hand"), [](Scene& scene) { return &scene; }, fitted,
                {SceneChange::What::Everything});
    emit noted(tr("The model was %1 across and has been scaled to %2 so that it fits a hand. "
                  "Undo brings its own size back.")
                   .arg(lengthText(before), lengthText(kHandDiagonal)));
}

void Document::announce(const SceneChange& change) {
    if (change.touchesShape())
        for (const SceneObject& object : scene_.objects)
            lastId_ = std::max(lastId_, object.id);
    emit changed(change);
    keepSelection(change);
}

} // namespace tactum
