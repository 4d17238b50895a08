// What the panel of layers does to the layers.
#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QStandardPaths>

#include "core/files/images/read_image.h"
#include "ui/document/layer_mapping.h"
#include "ui/panels/layer_panel.h"

namespace tactum {

namespace {

using Changed = SceneChange::What;

QString askForPicture(QWidget* parent) {
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileDialog::getOpenFileName(parent, QObject::tr("Choose a picture"),
                                        QDir(pictures).exists() ? pictures : QString(),
                                        QObject::tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff)"));
}

} // namespace

void LayerPanel::edit(const QString& what, const std::function<void(TextureLayer&)>& change,
                      Gesture gesture) {
    const TextureLayer* now = layer();
    if (!now) return;
    const QString text = tr("%1 of layer %2").arg(what, QString::fromStdString(now->name));
    document_.editSurfaces(
        *shown_, Changed::Layers, text,
        [&](Surface& each) {
            TextureLayer& to = each.layers[std::size_t(current_)];
            const TexturePattern before = to.pattern;
            change(to);
            fitNewMapping(to.pattern, before);
        },
        gesture);
    refresh(); // what was typed may have been brought into range
}

void LayerPanel::editList(const QString& text, const std::function<void(TextureLayers&)>& change) {
    if (!shown_) return;
    document_.editSurfaces(*shown_, Changed::Layers, text, [&](Surface& each) { change(each.layers); });
    refresh();
}

// A mapping that gets a frame for the first time gets one that fits.
void LayerPanel::fitNewMapping(TexturePattern& pattern, const TexturePattern& before) const {
    if (pattern.mapping == before.mapping || !hasFrame(pattern) || !(pattern.frame == Pose{})) return;
    const SceneObject* object = document_.scene().find(shown_->object);
    if (object && object->geometry) pattern = fitted(pattern, *object->geometry, shown_->surface);
}

/// Whether one more layer would be felt; says so where not.
bool LayerPanel::haveRoom(const SurfaceRefs& refs) {
    for (const SurfaceRef ref : refs)
        if (const Surface* of = document_.surface(ref); of && of->layers.size() >= kMaxTextureLayers) {
            emit failed(tr("%1 has %2 layers, and more are not felt. Remove one first.")
                            .arg(QString::fromStdString(of->name))
                            .arg(of->layers.size()));
            return false;
        }
    return true;
}

void LayerPanel::addOn(const SurfaceRefs& refs,
                       const std::function<TextureLayer(const TextureLayers&)>& make) {
    QString name;
    if (!haveRoom(refs)) return;
    for (const SurfaceRef ref : refs)
        if (const Surface* of = document_.surface(ref); of && name.isEmpty())
            name = QString::fromStdString(make(of->layers).name);
    document_.editSurfaces(refs, Changed::Layers, tr("Layer %1 on %2").arg(name, QStringLiteral("%1")),
                           [&](Surface& each) { each.layers.push_back(make(each.layers)); });
    const Surface* of = surface();
    if (of && std::ranges::find(refs, *shown_) != refs.end()) setCurrentLayer(int(of->layers.size()) - 1);
}

void LayerPanel::add(TextureSource source) {
    const SurfaceRefs refs = document_.selected();
    addOn(refs, [source](const TextureLayers& among) { return newLayer(source, among); });
}

void LayerPanel::addCopy(const TextureLayer& of) {
    addOn(document_.selected(), [&of](const TextureLayers& among) {
        TextureLayer copy = of;
        copy.name = freshLayerName(among, of.name);
        return copy;
    });
}

void LayerPanel::askForImage() {
    const SurfaceRefs refs = document_.selected();
    const QString file = refs.empty() ? QString() : askForPicture(this);
    if (!file.isEmpty()) addImage(refs, file);
}

void LayerPanel::addImage(const SurfaceRefs& on, const QString& file) {
    const bool locked = std::ranges::all_of(on, [this](SurfaceRef ref) {
        const Surface* of = document_.surface(ref);
        return !of || of->locked;
    });
    if (locked) return emit failed(tr("The surface is locked, so it gets no layer; unlock it first (L)."));
    readImage(file, [this, on](const std::shared_ptr<const TextureImage>& image) {
        const bool uvs = hasUvs(on);
        addOn(on,
              [&](const TextureLayers& among) { return newLayer(TextureSource::Image, among, uvs, image); });
    });
}

void LayerPanel::readImage(const QString& file,
                           std::function<void(std::shared_ptr<const TextureImage>)> use) {
    reading_.start([this, use = std::move(use), path = std::filesystem::path(file.toStdU16String())](
                       const Progress&) -> BackgroundJob::Delivery {
        auto read = std::make_shared<Result<LoadedImage>>(tactum::readImage(path));
        return [this, use, read] {
            if (!*read) return emit failed(QString::fromStdString(read->error().text));
            use((*read)->image);
            if (!(*read)->note.empty()) emit noted(QString::fromStdString((*read)->note));
        };
    });
}

void LayerPanel::chooseImage(bool ofMask) {
    if (!layer()) return;
    const QString file = askForPicture(this);
    if (file.isEmpty()) return;
    const auto wanted = std::pair(shown_, current_);
    readImage(file, [this, ofMask, wanted](const std::shared_ptr<const TextureImage>& image) {
        if (wanted != std::pair(shown_, current_)) return; // another layer was chosen meanwhile
        edit(tr("Picture"), [&](TextureLayer& each) {
            TexturePattern* pattern = ofMask ? (each.mask ? &*each.mask : nullptr) : &each.pattern;
            if (pattern) pattern->image = image;
        });
    });
}

void LayerPanel::duplicate() {
    const TextureLayer* now = layer();
    if (!now || !haveRoom(*shown_)) return;
    TextureLayer copy = *now;
    const auto place = std::size_t(current_ + 1);
    copy.name = freshLayerName(known_, now->name);
    editList(tr("Duplicate layer %1").arg(QString::fromStdString(now->name)),
             [&](TextureLayers& layers) { layers.insert(layers.begin() + std::ptrdiff_t(place), copy); });
    if (canEdit()) setCurrentLayer(int(place));
}

void LayerPanel::remove() {
    const TextureLayer* now = layer();
    if (!now) return;
    const int place = current_;
    editList(tr("Remove layer %1").arg(QString::fromStdString(now->name)),
             [&](TextureLayers& layers) { layers.erase(layers.begin() + place); });
}

void LayerPanel::moveLayer(int from, int to) {
    const int count = int(known_.size());
    if (from == to || from < 0 || to < 0 || from >= count || to >= count) return;
    editList(tr("Move layer %1").arg(QString::fromStdString(known_[std::size_t(from)].name)),
             [&](TextureLayers& layers) { tactum::moveLayer(layers, from, to); });
}

void LayerPanel::toggleShown(int number) {
    if (number >= int(known_.size())) return;
    const TextureLayer& of = known_[std::size_t(number)];
    const bool on = !of.enabled;
    editList((on ? tr("Switch layer %1 on") : tr("Switch layer %1 off")).arg(QString::fromStdString(of.name)),
             [&](TextureLayers& layers) { layers[std::size_t(number)].enabled = on; });
}

void LayerPanel::rename(int number, const QString& name) {
    if (name.isEmpty() || number >= int(known_.size())) return refresh();
    const std::string& before = known_[std::size_t(number)].name;
    editList(tr("Rename layer %1 to %2").arg(QString::fromStdString(before), name),
             [&](TextureLayers& layers) { layers[std::size_t(number)].name = name.toStdString(); });
}

std::optional<MappingFrame> LayerPanel::mappingFrame() const {
    const TextureLayer* now = layer();
    const SceneObject* object = shown_ ? document_.scene().find(shown_->object) : nullptr;
    if (!now || !object || !canEdit() || !hasFrame(now->pattern)) return std::nullopt;
    const TexturePattern& of = now->pattern;
    MappingFrame frame{of.mapping, object->pose * of.frame, of.size, 1, {of.offsetU, of.offsetV}, of.rotation,
                       of.radius};
    if (of.source == TextureSource::Image && of.image)
        frame.proportion = double(of.image->height()) / of.image->width();
    return frame;
}

void LayerPanel::setMappingFrame(const MappingFrame& frame, Gesture gesture) {
    const SceneObject* object = shown_ ? document_.scene().find(shown_->object) : nullptr;
    if (!object || !canEdit()) return;
    const Quat back = object->pose.rotation.conjugate();
    const Pose inBody{unitLength(back * frame.pose.rotation),
                      object->pose.applyInverse(frame.pose.translation)};
    edit(
        tr("Mapping"),
        [&](TextureLayer& each) {
            each.pattern.frame = inBody;
            each.pattern.size = kTextureSize.clamped(frame.size);
            each.pattern.radius = kTextureRadius.clamped(frame.radius);
        },
        gesture);
}

} // namespace tactum
