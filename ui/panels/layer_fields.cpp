#include "ui/panels/layer_fields.h"

#include <algorithm>
#include <array>

#include <QCheckBox>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/surface/texture_matters.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/parameter_field.h"
#include "ui/panels/pattern_fields.h"

namespace tactum {

namespace {

/// A label at the left and a list at the right.
QWidget* rowOf(const QString& layerText, QWidget* list) {
    auto* body = new QWidget;
    auto* row = new QHBoxLayout(body);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(layerText);
    label->setBuddy(list);
    row->addWidget(label, 1);
    row->addWidget(list, 2);
    return body;
}

QLabel* headingOf(const QString& layerText) {
    auto* label = new QLabel(layerText);
    label->setProperty("heading", true);
    label->setContentsMargins(0, kRhythm / 2, 0, 0);
    return label;
}

/// A pattern for a source that was another one before: what both have stays.
TexturePattern withSource(TexturePattern pattern, TextureSource source) {
    pattern.source = source;
    return pattern;
}

} // namespace

LayerFields::LayerFields(Edit edit, QWidget* parent) : QWidget(parent), edit_(std::move(edit)) {
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kRhythm);
    addChanges(*rows);
    addPattern(*rows);
    addMask(*rows);
}

void LayerFields::addChanges(QLayout& rows) {
    auto* target = new ChoiceBox("layer-target", tr("Changes"), kTextureTargets);
    target->setToolTip(
        tr("What the layer changes: the height of the surface, or a value of its material. Its "
           "strength begins anew where the unit is another one."));
    connect(target, &QComboBox::activated, this, [this](int i) {
        edit_(
            tr("Target"), [i](TextureLayer& each) { each = withTarget(each, TextureTarget(i)); }, 0);
    });
    target_ = target;
    rows.addWidget(rowOf(tr("Changes"), target));
    const auto strengthField = [&](const Parameter& parameter) {
        auto* field = new ParameterField(parameter);
        connect(field, &ParameterField::edited, this, [this, &parameter](double value, Gesture gesture) {
            edit_(
                wordsOf(parameter.label),
                [&](TextureLayer& each) {
                    if (&strengthParameter(each.target) == &parameter)
                        each.strength = parameter.clamped(value);
                },
                gesture);
        });
        rows.addWidget(field);
        return field;
    };
    height_ = strengthField(kTextureHeight);
    ratio_ = strengthField(kTextureRatio);
    ownPlane_ = new QCheckBox(tr("A constraint plane of its own"));
    ownPlane_->setObjectName(QStringLiteral("layer-own-plane"));
    ownPlane_->setToolTip(
        tr("Off: the layer joins those below it, and one plane leans as they do together. On: "
           "a plane for this layer alone (section 4.3)."));
    connect(ownPlane_, &QCheckBox::clicked, this, [this](bool on) {
        edit_(
            tr("Own plane"), [on](TextureLayer& each) { each.ownPlane = on; }, 0);
    });
    rows.addWidget(ownPlane_);
    auto* blend = new ChoiceBox("layer-blend", tr("Blend"), kTextureBlends);
    blend->setToolTip(tr("How the layer joins what lies below it"));
    connect(blend, &QComboBox::activated, this, [this](int i) {
        edit_(
            tr("Blend"), [i](TextureLayer& each) { each.blend = TextureBlend(i); }, 0);
    });
    blend_ = blend;
    blendRow_ = rowOf(tr("Blend"), blend);
    rows.addWidget(blendRow_);
    opacity_ = new ParameterField(kTextureOpacity);
    connect(opacity_, &ParameterField::edited, this, [this](double value, Gesture gesture) {
        edit_(
            tr("Opacity"), [&](TextureLayer& each) { each.opacity = kTextureOpacity.clamped(value); },
            gesture);
    });
    rows.addWidget(opacity_);
}

void LayerFields::addPattern(QLayout& rows) {
    rows.addWidget(headingOf(tr("Pattern")));
    auto* source = new ChoiceBox("layer-source", tr("Source"), kTextureSources);
    connect(source, &QComboBox::activated, this, &LayerFields::chooseSource);
    source_ = source;
    rows.addWidget(rowOf(tr("Source"), source));
    pattern_ =
        new PatternFields({}, [this](const QString& what, const PatternFields::Change& change, Gesture g) {
            edit_(
                what, [&](TextureLayer& each) { change(each.pattern); }, g);
        });
    connect(pattern_, &PatternFields::imageAsked, this, [this] { emit imageAsked(false); });
    rows.addWidget(pattern_);
}

void LayerFields::addMask(QLayout& rows) {
    rows.addWidget(headingOf(tr("Mask")));
    std::array<NamedChoice, kTextureSources.size() + 1> choices{{{"none", "None"}}};
    std::ranges::copy(kTextureSources, choices.begin() + 1);
    auto* source = new ChoiceBox("mask-source", tr("Mask"), choices);
    source->setToolTip(tr("Where the layer counts: all where the mask is light, nothing where it is dark"));
    connect(source, &QComboBox::activated, this, &LayerFields::chooseMask);
    maskSource_ = source;
    rows.addWidget(rowOf(tr("Source"), source));
    paintMask_ = new QToolButton;
    paintMask_->setText(tr("Paint the mask"));
    paintMask_->setObjectName(QStringLiteral("mask-paint"));
    paintMask_->setAccessibleName(tr("Paint the mask"));
    paintMask_->setToolTip(tr("On: the brush paints the mask. Off: it paints the layer itself."));
    paintMask_->setCheckable(true);
    paintMask_->setProperty("choice", true);
    connect(paintMask_, &QToolButton::toggled, this, &LayerFields::paintsMaskChanged);
    rows.addWidget(paintMask_);
    const auto edit = [this](const QString& what, const PatternFields::Change& change, Gesture gesture) {
        edit_(
            tr("%1 of the mask").arg(what),
            [&](TextureLayer& each) {
                if (each.mask) change(*each.mask);
            },
            gesture);
    };
    mask_ = new PatternFields(QStringLiteral("mask-"), edit);
    connect(mask_, &PatternFields::imageAsked, this, [this] { emit imageAsked(true); });
    rows.addWidget(mask_);
}

void LayerFields::chooseSource(int source) {
    const auto wanted = TextureSource(source);
    edit_(
        tr("Source"), [&](TextureLayer& each) { each.pattern = withSource(each.pattern, wanted); }, 0);
    if (wanted == TextureSource::Image && pattern_->asksForImage()) emit imageAsked(false);
}

void LayerFields::chooseMask(int choice) {
    edit_(
        tr("Mask"),
        [&](TextureLayer& each) {
            if (choice == 0)
                each.mask.reset();
            else
                each.mask = withSource(each.mask.value_or(TexturePattern{}), TextureSource(choice - 1));
        },
        0);
    if (choice == 1 + int(TextureSource::Image) && mask_->asksForImage()) emit imageAsked(true);
}

bool LayerFields::paintsMask() const {
    return paintMask_->isChecked();
}

void LayerFields::display(const TextureLayer& layer, bool hasUvs) {
    const bool isHeight = layer.target == TextureTarget::Height;
    target_->setCurrentIndex(int(layer.target));
    height_->setVisible(isHeight && strengthMatters(layer));
    ratio_->setVisible(!isHeight);
    (isHeight ? height_ : ratio_)->setValue(layer.strength);
    ownPlane_->setVisible(isHeight);
    ownPlane_->setChecked(layer.ownPlane);
    blend_->setCurrentIndex(int(layer.blend));
    blendRow_->setVisible(!layer.ownPlane || !isHeight); // a plane of its own joins nothing
    opacity_->setValue(layer.opacity);
    source_->setCurrentIndex(int(layer.pattern.source));
    pattern_->display(layer.pattern, hasUvs);
    displayMask(layer, hasUvs);
}

void LayerFields::displayMask(const TextureLayer& layer, bool hasUvs) {
    maskSource_->setCurrentIndex(layer.mask ? 1 + int(layer.mask->source) : 0);
    mask_->setVisible(layer.mask.has_value());
    // A choice only where both can be painted.
    paintMask_->setVisible(layer.mask && layer.mask->source == TextureSource::Painted &&
                           layer.pattern.source == TextureSource::Painted);
    if (layer.mask) mask_->display(*layer.mask, hasUvs);
}

} // namespace tactum
