#include "ui/document.h"

#include <algorithm>
#include <utility>

#include "ui/numbers.h"

namespace tactum {

namespace {

// What a hand at a desktop device can go around, in metres; and what a mesh outside of it is scaled to.
constexpr double kSmallest = 0.02, kLargest = 0.5, kFitted = kHandDiagonal;

Surface* find(Scene& scene, SurfaceRef ref) {
    SceneObject* object = scene.find(ref.object);
    return object && ref.surface < object->surfaces.size() ? &object->surfaces[ref.surface] : nullptr;
}

/// Where an edit finds a part of a surface; nullptr when the surface is gone.
template <class T> std::function<T*(Scene&)> inSurface(SurfaceRef ref, T Surface::*part) {
    return [ref, part](Scene& scene) {
        Surface* found = find(scene, ref);
        return found ? &(found->*part) : nullptr;
    };
}

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), qsizetype(view.size()));
}

} // namespace

bool SceneChange::touchesShape() const {
    return what == What::Everything || what == What::Objects || what == What::ProxyRadius;
}

Gesture newGesture() {
    static Gesture last = 0;
    return ++last;
}

/// The one command: undo and redo are the same exchange of values.
template <class T> class Document::Exchange final : public QUndoCommand {
public:
    Exchange(Document& document, const QString& text, Place<T> place, T value, SceneChange change,
             Gesture gesture)
        : QUndoCommand(text), document_(document), place_(std::move(place)), value_(std::move(value)),
          change_(change), gesture_(gesture) {}

    void redo() override { exchange(); }
    void undo() override { exchange(); }

    int id() const override { return gesture_ == 0 ? -1 : gesture_; }

    /// This one already holds the value from before the gesture, and the scene holds the newest.
    bool mergeWith(const QUndoCommand* next) override {
        const auto* other = dynamic_cast<const Exchange*>(next);
        if (!other || other->change_ != change_) return false;
        if (const T* now = place_(document_.scene_)) setObsolete(*now == value_);
        return true;
    }

private:
    void exchange() {
        if (T* now = place_(document_.scene_)) std::swap(*now, value_);
        document_.announce(change_);
    }

    Document& document_;
    Place<T> place_;
    T value_;
    SceneChange change_;
    Gesture gesture_;
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&job_, &BackgroundJob::progressed, this, &Document::openProgressed);
    connect(&saving_, &BackgroundJob::progressed, this, &Document::saveProgressed);
    connect(&saving_, &BackgroundJob::finished, this, [this] {
        if (nextSaves_.empty()) return;
        const auto next = std::move(nextSaves_.front());
        nextSaves_.pop_front();
        next();
    });
}

template <class T>
void Document::edit(const QString& text, Place<T> place, T value, SceneChange change, Gesture gesture) {
    const T* now = place(scene_);
    if (!now || *now == value) return;
    history_.push(new Exchange<T>(*this, text, std::move(place), std::move(value), change, gesture));
}

const Surface* Document::surface(SurfaceRef ref) const {
    return find(const_cast<Scene&>(scene_), ref);
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

void Document::select(std::optional<SurfaceRef> ref) {
    lost_.reset();
    setSelection(ref);
}

void Document::setSelection(std::optional<SurfaceRef> ref) {
    if (ref && !surface(*ref)) ref.reset();
    if (ref == selection_) return;
    selection_ = ref;
    emit changed({SceneChange::What::Selection});
}

void Document::setMaterialValue(SurfaceRef ref, const MaterialField& field, double value, Gesture gesture) {
    const Surface* now = surface(ref);
    if (!now) return;
    edit<Material>(tr("%1 of %2").arg(text(field.parameter->label), text(now->name)),
                   inSurface(ref, &Surface::material), withValue(now->material, field, value),
                   {SceneChange::What::Material, ref}, gesture);
}

void Document::setShading(SurfaceRef ref, const Shading& shading, Gesture gesture) {
    const Surface* now = surface(ref);
    if (!now) return;
    Shading safe = shading;
    safe.creaseAngle = kCreaseAngle.clamped(shading.creaseAngle);
    edit<Shading>(tr("Force shading of %1").arg(text(now->name)), inSurface(ref, &Surface::shading), safe,
                  {SceneChange::What::Shading, ref}, gesture);
}

void Document::setSides(SurfaceRef ref, Sides sides) {
    const Surface* now = surface(ref);
    if (!now) return;
    edit<Sides>(tr("Felt sides of %1").arg(text(now->name)), inSurface(ref, &Surface::sides), sides,
                {SceneChange::What::Sides, ref});
}

void Document::setProxyRadius(double metres, Gesture gesture) {
    edit<double>(
        tr("Proxy radius"), [](Scene& scene) { return &scene.proxyRadius; }, kProxyRadius.clamped(metres),
        {SceneChange::What::ProxyRadius}, gesture);
}

void Document::renameObject(ObjectId id, const QString& name) {
    auto place = [id](Scene& scene) {
        SceneObject* object = scene.find(id);
        return object ? &object->name : nullptr;
    };
    edit<std::string>(tr("Rename to %1").arg(name), place, name.toStdString(), {SceneChange::What::Names});
}

void Document::renameSurface(SurfaceRef ref, const QString& name) {
    edit<std::string>(tr("Rename to %1").arg(name), inSurface(ref, &Surface::name), name.toStdString(),
                      {SceneChange::What::Names});
}

void Document::setVisible(ObjectId id, bool visible) {
    const SceneObject* object = scene_.find(id);
    if (!object) return;
    auto place = [id](Scene& scene) {
        SceneObject* found = scene.find(id);
        return found ? &found->visible : nullptr;
    };
    edit<bool>((visible ? tr("Show %1") : tr("Hide %1")).arg(text(object->name)), place, visible,
               {SceneChange::What::Objects});
}

void Document::showAll() {
    auto objects = scene_.objects;
    for (auto& object : objects)
        object.visible = true;
    edit<std::vector<SceneObject>>(tr("Show all"), [](Scene& scene) { return &scene.objects; },
                                   std::move(objects), {SceneChange::What::Objects});
}

void Document::removeObject(ObjectId id) {
    const SceneObject* object = scene_.find(id);
    if (!object) return;
    const QString name = text(object->name);
    auto objects = scene_.objects;
    std::erase_if(objects, [id](const SceneObject& other) { return other.id == id; });
    edit<std::vector<SceneObject>>(tr("Remove %1").arg(name), [](Scene& scene) { return &scene.objects; },
                                   std::move(objects), {SceneChange::What::Objects});
}

void Document::setGeometry(ObjectId id, std::shared_ptr<const TriangleSoup> geometry, const QString& text) {
    auto place = [id](Scene& scene) {
        SceneObject* object = scene.find(id);
        return object ? &object->geometry : nullptr;
    };
    edit<std::shared_ptr<const TriangleSoup>>(text, place, std::move(geometry), {SceneChange::What::Objects});
}

void Document::scaleScene(double factor) {
    Scene scaled = scene_;
    fitDiagonal(scaled, factor * boundsOf(scene_).diagonal());
    edit<Scene>(tr("Scale the scene"), [](Scene& scene) { return &scene; }, std::move(scaled),
                {SceneChange::What::Everything});
}

Scene Document::fitted(Scene scene) {
    const double diagonal = boundsOf(scene).diagonal();
    if (diagonal < kSmallest || diagonal > kLargest) fitDiagonal(scene, kFitted);
    return scene;
}

void Document::fit(const Scene& fitted) {
    if (fitted == scene_) return;
    const double before = boundsOf(scene_).diagonal();
    edit<Scene>(tr("Scale to fit the hand"), [](Scene& scene) { return &scene; }, fitted,
                {SceneChange::What::Everything});
    emit noted(tr("The model was %1 across and has been scaled to %2 so that it fits a hand. "
                  "Undo brings its own size back.")
                   .arg(lengthText(before), lengthText(kFitted)));
}

void Document::announce(const SceneChange& change) {
    emit changed(change);
    if (selection_ && !surface(*selection_)) {
        lost_ = selection_;
        setSelection(std::nullopt);
    } else if (lost_ && surface(*lost_)) {
        setSelection(std::exchange(lost_, std::nullopt));
    }
}

} // namespace tactum
