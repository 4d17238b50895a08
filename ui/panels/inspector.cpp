#include "ui/panels/inspector.h"

#include <algorithm>
#include <utility>

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>

#include "ui/base/style.h"
#include "ui/panels/parameter_field.h"
#include "ui/widgets/columns.h"
#include "ui/widgets/swatch.h"

namespace tactum {

namespace {

QLabel* dimmed(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("dimmed", true);
    label->setWordWrap(true);
    return label;
}

/// While an edit is announced some of those that are selected may be gone.
std::vector<const Surface*> selectedSurfaces(const Document& document) {
    std::vector<const Surface*> surfaces;
    for (const SurfaceRef ref : document.selected())
        if (const Surface* surface = document.surface(ref)) surfaces.push_back(surface);
    return surfaces;
}

/// Whether the selected surfaces differ in something.
template <class Of> bool isMixed(const Document& document, Of&& of) {
    const auto surfaces = selectedSurfaces(document);
    return std::ranges::any_of(surfaces,
                               [&](const Surface* each) { return of(*each) != of(*surfaces.front()); });
}

void check(QCheckBox& box, bool on, bool mixed) {
    box.setTristate(mixed);
    box.setCheckState(mixed ? Qt::PartiallyChecked : on ? Qt::Checked : Qt::Unchecked);
}

} // namespace

Inspector::Inspector(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    auto* body = new QWidget;
    auto* sections = columnIn(body, 3 * kRhythm);
    sections->setContentsMargins(12, kRhythm / 2, 12, kRhythm);
    sections->addWidget(makeSurfaceSection());
    sections->addWidget(makeSceneSection());
    sections->addStretch();
    columnIn(this, 0)->addWidget(scrolled(body));
    connect(&document_, &Document::changed, this, &Inspector::refresh);
    refresh({});
}

QWidget* Inspector::makeSurfaceSection() {
    auto* section = new QWidget;
    auto* rows = columnIn(section, kRhythm);
    auto* title = new QHBoxLayout;
    swatch_ = new QToolButton;
    swatch_->setObjectName("surface-colour");
    swatch_->setAutoRaise(true);
    swatch_->setAccessibleName(tr("Colour"));
    swatch_->setToolTip(tr("Another colour for the selected surfaces. It is only seen."));
    connect(swatch_, &QToolButton::clicked, this, &Inspector::colourAsked);
    heading_ = new QLabel;
    heading_->setProperty("heading", true);
    title->addWidget(swatch_);
    title->addWidget(heading_, 1);
    rows->addLayout(title);
    hint_ = dimmed(tr("Click a surface in the view (Q) or in the outliner to see and set how it feels."));
    rows->addWidget(hint_);
    locked_ = dimmed({});
    locked_->setObjectName("locked-hint");
    rows->addWidget(locked_);
    surfaceFields_ = new QWidget;
    auto* list = columnIn(surfaceFields_, kRhythm);
    for (const MaterialField& field : kMaterialFields) {
        auto* row = new ParameterField(*field.parameter);
        connect(row, &ParameterField::edited, this, [this, &field](double value, Gesture gesture) {
            document_.setMaterialValue(document_.selected(), field, value, gesture);
            refresh({SceneChange::What::Selection}); // what was typed may have been brought into range
        });
        fields_.push_back(row);
        list->addWidget(row);
    }
    list->addWidget(makeSidesRow());
    list->addWidget(makeShadingRows());
    rows->addWidget(surfaceFields_);
    return section;
}

QWidget* Inspector::makeSidesRow() {
    struct Choice {
        Sides sides;
        QString text, meaning;
    };
    const Choice choices[] = {
        {Sides::Both, tr("Both"), tr("Felt from whichever side it is met.")},
        {Sides::Front, tr("Front"), tr("Felt from the side that sees the corners counter-clockwise alone.")},
        {Sides::Back, tr("Back"), tr("Felt from the side that sees the corners clockwise alone.")},
        {Sides::None, tr("None"), tr("Seen, but not felt.")}};
    auto* section = new QWidget;
    auto* lines = columnIn(section, kRhythm / 2);
    lines->addWidget(new QLabel(tr("Felt from")));
    auto* row = new QHBoxLayout;
    row->setSpacing(kRhythm / 2);
    lines->addLayout(row);
    sides_ = new QButtonGroup(section);
    for (const Choice& choice : choices) {
        auto* button = new QToolButton;
        button->setText(choice.text);
        button->setToolTip(choice.meaning);
        button->setCheckable(true);
        button->setProperty("choice", true);
        button->setObjectName(QStringLiteral("sides-") + QString::fromUtf8(nameOf(choice.sides).data()));
        button->setAccessibleName(tr("Felt from: %1").arg(choice.text));
        sides_->addButton(button, int(choice.sides));
        row->addWidget(button, 1);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    connect(sides_, &QButtonGroup::idClicked, this,
            [this](int id) { document_.setSides(document_.selected(), Sides(id)); });
    return section;
}

template <class Change> void Inspector::editShading(Gesture gesture, Change&& change) {
    document_.editSurfaces(
        document_.selected(), SceneChange::What::Shading, tr("Force shading of %1"),
        [&](Surface& each) {
            change(each.shading);
            each.shading.creaseAngle = kCreaseAngle.clamped(each.shading.creaseAngle);
        },
        gesture);
    refresh({SceneChange::What::Selection}); // what was typed may have been brought into range
}

QWidget* Inspector::makeShadingRows() {
    auto* rows = new QWidget;
    auto* list = columnIn(rows, kRhythm);
    shading_ = new QCheckBox(tr("Force shading"));
    shading_->setObjectName("force-shading");
    shading_->setToolTip(tr("Facets feel as the round surface that they stand for (section 3)."));
    connect(shading_, &QCheckBox::clicked, this,
            [this](bool on) { editShading(0, [on](Shading& shading) { shading.on = on; }); });
    fileNormals_ = new QCheckBox(tr("With the normals of the mesh"));
    fileNormals_->setObjectName("file-normals");
    fileNormals_->setToolTip(tr("Off: normals are computed, and edges beyond the crease angle stay sharp."));
    connect(fileNormals_, &QCheckBox::clicked, this, [this](bool on) {
        editShading(0, [on](Shading& shading) {
            shading.normals = on ? NormalSource::File : NormalSource::Computed;
        });
    });
    creaseAngle_ = new ParameterField(kCreaseAngle);
    connect(creaseAngle_, &ParameterField::edited, this, [this](double value, Gesture gesture) {
        editShading(gesture, [value](Shading& shading) { shading.creaseAngle = value; });
    });
    for (QWidget* row : std::initializer_list<QWidget*>{shading_, fileNormals_, creaseAngle_})
        list->addWidget(row);
    return rows;
}

QWidget* Inspector::makeSceneSection() {
    auto* section = new QWidget;
    auto* rows = columnIn(section, kRhythm);
    auto* title = new QLabel(tr("Scene"));
    title->setProperty("heading", true);
    rows->addWidget(title);
    proxyRadius_ = new ParameterField(kProxyRadius);
    connect(proxyRadius_, &ParameterField::edited, &document_, &Document::setProxyRadius);
    rows->addWidget(proxyRadius_);
    return section;
}

void Inspector::setCeiling(const CeilingNow& ceiling, bool overridden) {
    const QString text = tr("Ceiling, the red tick: %1 N/m, %2")
                             .arg(numberText(ceiling.value, 0),
                                  overridden ? tr("overridden at your own risk") : ceiling.reason);
    if (std::exchange(ceilingText_, text) == text) return;
    for (std::size_t i = 0; i < fields_.size(); ++i)
        if (kMaterialFields[i].parameter == &kStiffness) fields_[i]->setCeiling(ceiling.value, text);
}

void Inspector::refresh(const SceneChange&) {
    refreshHeading();
    proxyRadius_->setValue(document_.scene().proxyRadius);
    if (const auto active = document_.selection(); !active || !document_.surface(*active)) return;
    refreshValues();
    refreshShading();
}

void Inspector::refreshValues() {
    const Surface& active = *document_.surface(*document_.selection());
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto value = kMaterialFields[i].value;
        fields_[i]->setValue(active.material.*value);
        fields_[i]->setMixed(isMixed(document_, [&](const Surface& each) { return each.material.*value; }));
    }
    const bool mixedSides = isMixed(document_, [](const Surface& each) { return each.sides; });
    sides_->setExclusive(!mixedSides);
    for (QAbstractButton* button : sides_->buttons())
        button->setChecked(!mixedSides && sides_->id(button) == int(active.sides));
}

// Only what makes a difference is shown.
void Inspector::refreshShading() {
    const SceneObject* object = document_.scene().find(document_.selection()->object);
    const Shading& shading = document_.surface(*document_.selection())->shading;
    const bool inFile = object && object->geometry && !object->geometry->cornerNormals.empty();
    check(*shading_, shading.on, isMixed(document_, [](const Surface& each) { return each.shading.on; }));
    check(*fileNormals_, shading.normals == NormalSource::File,
          isMixed(document_, [](const Surface& each) { return each.shading.normals; }));
    fileNormals_->setVisible(shading.on && inFile);
    creaseAngle_->setValue(shading.creaseAngle);
    creaseAngle_->setMixed(isMixed(document_, [](const Surface& each) { return each.shading.creaseAngle; }));
    creaseAngle_->setVisible(shading.on && !(inFile && shading.normals == NormalSource::File));
}

void Inspector::refreshHeading() {
    const auto selection = document_.selection();
    const Surface* surface = selection ? document_.surface(*selection) : nullptr;
    surfaceFields_->setVisible(surface);
    swatch_->setVisible(surface);
    hint_->setVisible(!surface);
    const auto count = document_.selected().size();
    heading_->setText(!surface    ? tr("No surface selected")
                      : count > 1 ? tr("%1 surfaces").arg(count)
                                  : QString::fromStdString(surface->name));
    refreshLocked();
    if (surface) swatch_->setIcon(swatchIcon(surface->colour));
}

void Inspector::refreshLocked() {
    const auto surfaces = selectedSurfaces(document_);
    const auto locked = std::size_t(std::ranges::count_if(surfaces, &Surface::locked));
    const bool all = !surfaces.empty() && locked == surfaces.size();
    surfaceFields_->setEnabled(!all);
    locked_->setVisible(locked > 0);
    locked_->setText(all ? tr("Locked: press L to unlock.")
                         : tr("%1 of %2 are locked and stay as they are.").arg(locked).arg(surfaces.size()));
}

} // namespace tactum
