#include "ui/panels/layer_panel.h"

#include <algorithm>
#include <utility>

#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/panels/flat_swatch.h"
#include "ui/panels/layer_chooser.h"
#include "ui/panels/layer_fields.h"
#include "ui/panels/layer_list.h"
#include "ui/panels/layer_profile.h"
#include "ui/panels/profile_chart.h"
#include "ui/widgets/columns.h"

namespace tactum {

namespace {

using What = SceneChange::What;

constexpr int kMaxRows = 4; // of the list: what is beneath needs the room

} // namespace

LayerPanel::LayerPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), heading_(new QLabel), hint_(new QLabel), buttons_(new QWidget),
      body_(new QWidget), feel_(new QWidget), scroll_(new QScrollArea), list_(new LayerList),
      fields_(new LayerFields([this](const QString& what, const LayerFields::Change& change,
                                     Gesture gesture) { edit(what, change, gesture); })),
      swatch_(new FlatSwatch), chart_(new ProfileChart) {
    setObjectName(QStringLiteral("layer-panel"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = columnIn(this, kRhythm / 2);
    column->setContentsMargins(0, kRhythm / 2, 0, 0);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(12, 0, kRhythm / 2, 0);
    heading_->setProperty("heading", true);
    heading_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    top->addWidget(heading_, 1);
    top->addWidget(buttons_);
    column->addLayout(top);
    hint_->setProperty("dimmed", true);
    hint_->setWordWrap(true);
    hint_->setObjectName(QStringLiteral("layer-hint"));
    hint_->setContentsMargins(12, 0, 12, 0);
    column->addWidget(hint_);
    auto* inside = columnIn(body_, kRhythm / 2);
    inside->addWidget(list_);
    inside->addWidget(makeLower(), 1);
    column->addWidget(body_, 1);
    column->addStretch();
    connectList();
    connect(fields_, &LayerFields::imageAsked, this, &LayerPanel::chooseImage);
    connect(fields_, &LayerFields::paintsMaskChanged, this, &LayerPanel::announceCurrent);
    connect(&document_, &Document::changed, this, &LayerPanel::follow);
    connect(&reading_, &BackgroundJob::progressed, this, &LayerPanel::readProgressed);
    connect(&reading_, &BackgroundJob::finished, this, &LayerPanel::readEnded);
    connect(&profiling_, &BackgroundJob::finished, this, [this] {
        if (std::exchange(profileAgain_, false)) drawProfile();
    });
    follow({});
}

QWidget* LayerPanel::makeLower() {
    auto* lower = new QWidget;
    auto* column = columnIn(lower, kRhythm / 2);
    auto* row = new QHBoxLayout(feel_);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(kRhythm);
    row->addWidget(swatch_, 0, Qt::AlignTop);
    row->addWidget(chart_, 1);
    column->addWidget(feel_);
    auto* padded = new QWidget;
    columnIn(padded, 0)->addWidget(fields_);
    padded->layout()->setContentsMargins(12, kRhythm / 2, 12, kRhythm);
    static_cast<QVBoxLayout*>(padded->layout())->addStretch();
    scroll_->setWidget(padded);
    scroll_->setWidgetResizable(true);
    scroll_->setFocusPolicy(Qt::NoFocus); // it follows the field that has the keys
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(scroll_, 1);
    return lower;
}

void LayerPanel::addButtons(const Actions& actions) {
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* add = new QToolButton;
    auto* chooser = new LayerChooser(actions, this);
    connect(chooser, &LayerChooser::layerChosen, this, &LayerPanel::addCopy);
    connect(add, &QToolButton::clicked, chooser, [chooser, add] { chooser->openUnder(*add); });
    add->setObjectName(QStringLiteral("layer-add"));
    add->setAccessibleName(tr("Add a layer"));
    add->setToolTip(tr("Add a layer to all selected surfaces"));
    add->setText(tr("Add"));
    row->addWidget(add);
    for (const char* id : {"layer-duplicate", "layer-up", "layer-down", "mapping", "layer-remove"}) {
        auto* button = new QToolButton;
        button->setDefaultAction(&actions[id]);
        button->setIconSize({16, 16});
        button->setObjectName(QLatin1String(id) + QStringLiteral("-button"));
        button->setAccessibleName(actions[id].text().remove(u'&'));
        row->addWidget(button);
    }
}

void LayerPanel::connectList() {
    connect(list_, &LayerList::chosen, this, &LayerPanel::setCurrentLayer);
    connect(list_, &LayerList::showAsked, this, &LayerPanel::toggleShown);
    connect(list_, &LayerList::soloAsked, this, &LayerPanel::toggleSolo);
    connect(list_, &LayerList::moveAsked, this, &LayerPanel::moveLayer);
    connect(list_, &LayerList::removeAsked, this, &LayerPanel::remove);
    connect(list_, &LayerList::duplicateAsked, this, &LayerPanel::duplicate);
    // Later: an editor that closes with the window speaks when the panel is half gone.
    connect(list_, &LayerList::renameAsked, this, &LayerPanel::rename, Qt::QueuedConnection);
}

const Surface* LayerPanel::surface() const {
    return shown_ ? document_.surface(*shown_) : nullptr;
}

const TextureLayer* LayerPanel::layer() const {
    const Surface* of = surface();
    return of && current_ < int(of->layers.size()) ? &of->layers[std::size_t(current_)] : nullptr;
}

std::optional<int> LayerPanel::currentLayer() const {
    return layer() ? std::optional(current_) : std::nullopt;
}

bool LayerPanel::maskIsEdited() const {
    const TextureLayer* now = layer();
    if (!now || !now->mask || now->mask->source != TextureSource::Painted) return false;
    return now->pattern.source != TextureSource::Painted || fields_->paintsMask();
}

bool LayerPanel::canEdit() const {
    const Surface* of = surface();
    return of && !of->locked;
}

void LayerPanel::setCurrentLayer(int number) {
    current_ = number;
    refresh();
}

void LayerPanel::follow(const SceneChange& change) {
    const bool concerns = change.what == What::Layers || change.what == What::Selection ||
                          change.what == What::Names || change.touchesShape();
    if (!concerns) return;
    const auto active = document_.selection();
    if (std::exchange(shown_, active) != active) {
        const Surface* now = surface();
        known_ = now ? now->layers : TextureLayers{};
        current_ = std::max(0, int(known_.size()) - 1);
        if (solo_ && solo_->surface != active) setSolo(std::nullopt);
    }
    keepSolo(change);
    keepCurrent();
    refresh();
}

// Undo and redo move layers behind the panel's back.
void LayerPanel::keepCurrent() {
    const Surface* now = surface();
    if (!now || now->layers.empty()) {
        current_ = 0;
        return;
    }
    std::optional<int> place;
    if (known_.empty()) current_ = int(now->layers.size()) - 1; // the topmost, where there was none
    if (current_ < int(known_.size()))
        place = followed(now->layers, known_.size(), current_, known_[std::size_t(current_)]);
    current_ = std::clamp(place.value_or(current_), 0, int(now->layers.size()) - 1);
}

void LayerPanel::keepSolo(const SceneChange& change) {
    if (!solo_) return;
    const Surface* now = document_.surface(solo_->surface);
    if (!now || (change.touchesShape() && now->layers != soloKnown_)) return setSolo(std::nullopt);
    const auto place =
        followed(now->layers, soloKnown_.size(), solo_->layer, soloKnown_[std::size_t(solo_->layer)]);
    soloKnown_ = now->layers;
    setSolo(place ? std::optional(SoloLayer{solo_->surface, *place}) : std::nullopt);
}

void LayerPanel::setSolo(std::optional<SoloLayer> solo) {
    if (solo == solo_) return;
    solo_ = solo;
    const Surface* now = solo ? document_.surface(solo->surface) : nullptr;
    soloKnown_ = now ? now->layers : TextureLayers{};
    emit soloChanged(solo_);
}

void LayerPanel::toggleSolo(int number) {
    if (!shown_ || number >= int(known_.size())) return;
    const SoloLayer wanted{*shown_, number};
    setSolo(solo_ == wanted ? std::nullopt : std::optional(wanted));
    refresh();
}

TextureLayers LayerPanel::feltLayers() const {
    const Surface* of = surface();
    if (!of) return {};
    return solo_ && solo_->surface == *shown_ ? alone(of->layers, solo_->layer) : of->layers;
}

void LayerPanel::refresh() {
    const Surface* of = surface();
    known_ = of ? of->layers : TextureLayers{};
    const TextureLayer* now = layer();
    const bool solos = solo_ && shown_ == solo_->surface;
    list_->setRows(std::min(kMaxRows, int(known_.size())));
    list_->display(known_, currentLayer(), solos ? std::optional(solo_->layer) : std::nullopt);
    body_->setEnabled(canEdit());
    buttons_->setEnabled(canEdit());
    scroll_->setVisible(now);
    feel_->setVisible(now);
    list_->setVisible(now);
    body_->setVisible(now);
    if (now) fields_->display(*now, hasUvs(*shown_));
    describe();
    drawGround();
    drawProfile();
    announceCurrent();
    emit displayed();
}

void LayerPanel::describe() {
    const Surface* of = surface();
    heading_->setText(of ? QString::fromStdString(of->name) : tr("No surface"));
    QString text;
    if (!of)
        text =
            tr("Layers of haptic texture on a surface: what they change by how much, in which order. Click a "
               "surface in the view (Q) or in the outliner, or drop a picture on the model.");
    else if (of->locked)
        text = tr("The surface is locked: press L to unlock it.");
    else if (of->layers.empty())
        text = tr(
            "No layer yet. Add one with the button above, or drop a picture (PNG, JPEG, TIFF) on the model "
            "or here.");
    hint_->setText(text);
    hint_->setVisible(!text.isEmpty());
}

void LayerPanel::announceCurrent() {
    const Announced now{shown_, currentLayer(), maskIsEdited()};
    if (std::exchange(announced_, now) != now) emit currentLayerChanged();
}

bool LayerPanel::hasUvs(const SurfaceRefs& refs) const {
    return std::ranges::all_of(refs, [this](SurfaceRef ref) {
        const SceneObject* object = document_.scene().find(ref.object);
        return object && object->geometry && !object->geometry->cornerUvs.empty();
    });
}

void LayerPanel::drawGround() {
    const SceneObject* object = shown_ ? document_.scene().find(shown_->object) : nullptr;
    const TextureLayer* now = layer();
    if (!object || !now) return;
    swatch_->display(feltLayers(), now->target, object->geometry, shown_->surface);
}

void LayerPanel::setWorld(std::shared_ptr<const World> world) {
    const bool moved = !world_ || !world || world_->shapeRevision != world->shapeRevision;
    world_ = std::move(world);
    if (moved) drawProfile();
}

void LayerPanel::take(std::span<const TracePoint> points, double bodiesTime) {
    if (stroke_.add(points, bodiesTime)) drawProfile();
}

void LayerPanel::drawProfile() {
    const TextureLayer* now = layer();
    if (!now || !world_) return;
    if (stroke_.points().empty())
        return chart_->displayNone(
            tr("Stroke the model with the finger (W, then drag): what the layers are along the "
               "way appears here."));
    if (profiling_.running()) {
        profileAgain_ = true;
        return;
    }
    profiling_.start([this, stroke = stroke_.points(), world = world_, ref = *shown_, layers = feltLayers(),
                      target = now->target](const Progress& progress) -> BackgroundJob::Delivery {
        auto profile =
            std::make_shared<LayerProfile>(profileAlong(stroke, *world, ref, layers, target, progress));
        return [this, profile] {
            if (profile->any())
                chart_->display(std::move(*profile));
            else
                chart_->displayNone(
                    tr("The last stroke was not on this surface. Stroke it with the finger."));
        };
    });
}

} // namespace tactum
