#include "ui/panels/preset_form.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "ui/base/style.h"

namespace tactum {

namespace {

QLineEdit* addLine(QFormLayout& form, const QString& label, const char* name, const QString& hint) {
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setAccessibleName(label);
    line->setPlaceholderText(hint);
    form.addRow(label, line);
    return line;
}

} // namespace

PresetForm::PresetForm(const Surface& surface, QWidget* parent) : QDialog(parent), surface_(surface) {
    setObjectName(QStringLiteral("preset-form"));
    setWindowTitle(tr("Save as preset"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(52 * kRhythm);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(2 * kRhythm, 2 * kRhythm, 2 * kRhythm, 2 * kRhythm);
    form->setVerticalSpacing(kRhythm);
    name_ = addLine(*form, tr("Name"), "preset-name", tr("What it feels like"));
    name_->setText(QString::fromStdString(surface.name));
    name_->selectAll();
    category_ = addLine(*form, tr("Category"), "preset-category", tr("Wood, metal, ..."));
    source_ =
        addLine(*form, tr("Source"), "preset-source", tr("Measured by, taken from; empty: set by hand"));
    link_ = addLine(*form, tr("Link"), "preset-link", tr("https://... or a DOI"));
    const auto addBox = [&](const QString& text, bool on) {
        auto* box = new QCheckBox(text);
        box->setChecked(on);
        form->addRow(QString(), box);
        return box;
    };
    values_ = addBox(tr("Stiffness, damping, friction and viscosity"), true);
    layers_ = addBox(tr("Layers of texture"), !surface.layers.empty());
    shading_ = addBox(tr("Force shading"), surface.shading.on);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    QPushButton* save = buttons->button(QDialogButtonBox::Save);
    const auto enable = [this, save] {
        const bool any = values_->isChecked() || layers_->isChecked() || shading_->isChecked();
        save->setEnabled(any && !name_->text().trimmed().isEmpty());
    };
    connect(name_, &QLineEdit::textChanged, this, enable);
    for (QCheckBox* box : {values_, layers_, shading_})
        connect(box, &QCheckBox::toggled, this, enable);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    enable();
}

LoadedPreset PresetForm::made() const {
    PresetSource source{source_->text().trimmed().toStdString(), link_->text().trimmed().toStdString(),
                        false};
    if (source.words.empty() && source.link.empty())
        source.words = tr("Set by hand: no source").toStdString();
    LoadedPreset made = presetOf(surface_, name_->text().trimmed().toStdString(), source);
    Preset& preset = made.preset;
    preset.category = category_->text().trimmed().toStdString();
    const auto leaveOut = [&](const QCheckBox* box, const char* part, auto& value) {
        if (box->isChecked()) return;
        value.reset();
        preset.sources.erase(part);
    };
    leaveOut(shading_, kShadingPart, preset.shading);
    leaveOut(layers_, kLayersPart, preset.layers);
    if (!layers_->isChecked()) made.notes.clear();
    if (values_->isChecked()) return made;
    preset.values = {};
    std::erase_if(preset.sources,
                  [](const auto& each) { return each.first != kShadingPart && each.first != kLayersPart; });
    return made;
}

} // namespace tactum
