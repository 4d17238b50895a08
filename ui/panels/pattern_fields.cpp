#include "ui/panels/pattern_fields.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/surface/texture_matters.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/parameter_field.h"

namespace tactum {

PatternFields::PatternFields(const QString& prefix, Edit edit, QWidget* parent)
    : QWidget(parent), prefix_(prefix), edit_(std::move(edit)), imageRow_(makeImageRow()),
      mappingRow_(makeMappingRow()), hint_(new QLabel) {
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kRhythm);
    rows->addWidget(imageRow_);
    rows->addWidget(mappingRow_);
    hint_->setObjectName(prefix_ + QStringLiteral("pattern-hint"));
    hint_->setProperty("dimmed", true);
    hint_->setWordWrap(true);
    rows->addWidget(hint_);
    addFields();
}

QWidget* PatternFields::makeImageRow() {
    auto* body = new QWidget;
    auto* row = new QHBoxLayout(body);
    row->setContentsMargins(0, 0, 0, 0);
    imageName_ = new QLabel;
    imageName_->setObjectName(prefix_ + QStringLiteral("image-name"));
    imageName_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* choose = new QPushButton(tr("Choose..."));
    choose->setProperty("inRow", true);
    choose->setObjectName(prefix_ + QStringLiteral("image-choose"));
    choose->setToolTip(tr("A PNG, JPEG or TIFF picture of 8 or 16 bits; bright is high"));
    connect(choose, &QPushButton::clicked, this, &PatternFields::imageAsked);
    row->addWidget(imageName_, 1);
    row->addWidget(choose);
    return body;
}

QWidget* PatternFields::makeMappingRow() {
    auto* body = new QWidget;
    auto* row = new QHBoxLayout(body);
    row->setContentsMargins(0, 0, 0, 0);
    auto* list = new ChoiceBox("mapping", tr("Mapping"), kTextureMappings);
    list->setObjectName(prefix_ + QStringLiteral("mapping"));
    list->setToolTip(tr("How the flat pattern comes onto the surface"));
    connect(list, &QComboBox::activated, this, [this](int i) {
        edit_(
            tr("Mapping"), [i](TexturePattern& each) { each.mapping = TextureMapping(i); }, 0);
    });
    mapping_ = list;
    auto* label = new QLabel(tr("Mapping"));
    label->setBuddy(list);
    row->addWidget(label, 1);
    row->addWidget(list, 2);
    return body;
}

void PatternFields::addFields() {
    for (const PatternField& field : kPatternFields) {
        auto* row = new ParameterField(*field.parameter);
        connect(row, &ParameterField::edited, this, [this, &field](double value, Gesture gesture) {
            const QString what = wordsOf(field.parameter->label);
            edit_(
                what, [&](TexturePattern& each) { each.*field.value = field.parameter->clamped(value); },
                gesture);
        });
        if (!prefix_.isEmpty())
            for (auto* part : row->findChildren<QWidget*>())
                if (!part->objectName().isEmpty() && !part->objectName().startsWith(QStringLiteral("qt_")))
                    part->setObjectName(prefix_ + part->objectName());
        fields_.push_back(row);
        layout()->addWidget(row);
    }
}

void PatternFields::display(const TexturePattern& pattern, bool hasUvs) {
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        fields_[i]->setVisible(matters(kPatternFields[i], pattern));
        fields_[i]->setValue(pattern.*kPatternFields[i].value);
    }
    mappingRow_->setVisible(pattern.source != TextureSource::Painted);
    mapping_->setCurrentIndex(int(pattern.mapping));
    imageRow_->setVisible(pattern.source == TextureSource::Image);
    asksForImage_ = pattern.source == TextureSource::Image && !pattern.image;
    if (const TextureImage* image = pattern.image.get()) {
        imageName_->setText(QString::fromStdString(image->name()));
        imageName_->setToolTip(
            tr("%1 x %2, %3 bits").arg(image->width()).arg(image->height()).arg(image->bits()));
    } else {
        imageName_->setText(tr("No picture"));
        imageName_->setToolTip({});
    }
    describe(pattern, hasUvs);
}

void PatternFields::describe(const TexturePattern& pattern, bool hasUvs) {
    QString text;
    if (pattern.source == TextureSource::Painted)
        text = pattern.painted.values ? QString() : tr("Nothing is painted yet, so it is not felt.");
    else if (usesUvs(pattern) && !hasUvs)
        text = tr("The mesh has no texture coordinates, so it is not felt. Triplanar needs none.");
    else if (usesUvs(pattern))
        text = tr("It lies where the mesh's texture coordinates put it; the other mappings have a frame that "
                  "can be moved in the view.");
    hint_->setText(text);
    hint_->setVisible(!text.isEmpty());
}

} // namespace tactum
