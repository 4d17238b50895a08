#include "ui/panels/parameter_field.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/value_slider.h"

namespace tactum {

namespace {

// Steps of the wheel or of an arrow key that follow each other this fast are one edit.
constexpr int kRunOfSteps = 800; // ms

/// "800 N/m", or "0.60" of what has no unit.
QString shownValue(double shown, const DisplayUnit& unit) {
    const QString number = numberText(shown, decimalsFor(shown, unit.decimals));
    return unit.name.isEmpty() ? number : number + u' ' + unit.name;
}

} // namespace

ParameterField::ParameterField(const Parameter& parameter, QWidget* parent)
    : QWidget(parent), parameter_(parameter), box_(new NumberBox({})), slider_(new ValueSlider(parameter)),
      reset_(new QToolButton), unitLabel_(new QLabel), hint_(new QLabel) {
    auto* label = new QLabel(wordsOf(parameter.label));
    label->setBuddy(box_);
    label->installEventFilter(this);
    reset_->setIcon(icon(QStringLiteral("reset")));
    reset_->setIconSize({12, 12});
    hint_->setProperty("limit", true);
    hint_->hide();
    layOut(label);
    wire();
    value_ = parameter.initial;
    useUnit();
}

void ParameterField::useUnit() {
    unit_ = displayUnit(parameter_);
    unitLabel_->setText(unit_.name);
    const QSignalBlocker quiet(box_);
    box_->setUnit(unit_.name);
    box_->setDecimals(unit_.decimals);
    box_->setRange(unit_.factor * parameter_.minimum, unit_.factor * parameter_.maximum);
    box_->setSingleStep(unit_.factor * parameter_.step);
    describe();
    setValue(value_);
}

void ParameterField::layOut(QLabel* label) {
    unitLabel_->setProperty("dimmed", true);
    unitLabel_->setMinimumWidth(5 * kRhythm);
    box_->setFixedWidth(9 * kRhythm);
    QSizePolicy keepsPlace = reset_->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    reset_->setSizePolicy(keepsPlace);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kRhythm / 2);
    grid->setVerticalSpacing(0);
    grid->addWidget(label, 0, 0);
    grid->addWidget(reset_, 0, 1);
    grid->addWidget(box_, 0, 2);
    grid->addWidget(unitLabel_, 0, 3);
    grid->addWidget(slider_, 1, 0, 1, 4);
    grid->addWidget(hint_, 2, 0, 1, 4);
    grid->setColumnStretch(0, 1);
}

void ParameterField::setCompact(int width) {
    compact_ = true;
    unitLabel_->setMinimumWidth(0);
    box_->setFixedWidth(width);
    QSizePolicy given = reset_->sizePolicy();
    given.setRetainSizeWhenHidden(false);
    reset_->setSizePolicy(given);
    reset_->hide();
}

void ParameterField::wire() {
    connect(box_, &NumberBox::typed, this, [this](double shown) { edit(shown / unit_.factor, 0); });
    connect(box_, &NumberBox::stepped, this,
            [this](double shown) { edit(shown / unit_.factor, stepGesture()); });
    connect(box_, &NumberBox::outOfRange, this, &ParameterField::showLimit);
    connect(box_, &NumberBox::notUnderstood, this, &ParameterField::showMistake);
    connect(slider_, &ValueSlider::notched, box_, &NumberBox::stepBy);
    connect(slider_, &QSlider::sliderPressed, this, [this] { gesture_ = newGesture(); });
    connect(slider_, &QSlider::valueChanged, this, &ParameterField::followSlider);
    connect(reset_, &QToolButton::clicked, this, [this] { edit(parameter_.initial, 0); });
    connect(&Preferences::instance(), &Preferences::changed, this, [this](Preferred id) {
        if (id == Preferred::Lengths || id == Preferred::Stiffnesses) useUnit();
    });
}

void ParameterField::describe() {
    const auto shown = [&](double value) { return numberText(value, decimalsFor(value, unit_.decimals)); };
    const QString range = tr("%1 to %2, default %3")
                              .arg(shown(box_->minimum()), shownValue(box_->maximum(), unit_),
                                   shown(unit_.factor * parameter_.initial));
    // Rich text, so that long sentences wrap.
    setToolTip(QStringLiteral("<p><b>%1</b><br>%2</p><p>%3%4</p>")
                   .arg(wordsOf(parameter_.label).toHtmlEscaped(),
                        wordsOf(parameter_.sentence).toHtmlEscaped(), range,
                        ceilingText_.isEmpty() ? QString() : QStringLiteral("<br>") + ceilingText_));
    const QString key = asIs(parameter_.key);
    box_->setObjectName(key);
    slider_->setObjectName(key + QStringLiteral("-slider"));
    reset_->setObjectName(key + QStringLiteral("-reset"));
    hint_->setObjectName(key + QStringLiteral("-hint"));
    box_->setAccessibleName(wordsOf(parameter_.label));
    box_->setAccessibleDescription(wordsOf(parameter_.sentence));
    slider_->setAccessibleName(tr("%1, slider").arg(wordsOf(parameter_.label)));
    reset_->setAccessibleName(tr("Reset %1").arg(wordsOf(parameter_.label)));
    reset_->setToolTip(
        tr("Back to the default, %1").arg(shownValue(unit_.factor * parameter_.initial, unit_)));
}

void ParameterField::edit(double value, Gesture gesture) {
    hint_->hide();
    emit edited(value, gesture);
}

void ParameterField::showLimit(double typed) {
    const double limit = typed > box_->maximum() ? box_->maximum() : box_->minimum();
    hint_->setText((typed > limit ? tr("At most %1") : tr("At least %1")).arg(shownValue(limit, unit_)));
    hint_->show();
}

void ParameterField::showMistake(const QString& typed) {
    const QString unit = unit_.name.isEmpty() ? tr("a number") : tr("a number in %1").arg(unit_.name);
    hint_->setText(tr("\u201c%1\u201d is not %2").arg(typed.left(20), unit));
    hint_->show();
}

void ParameterField::setValue(double value) {
    value_ = value;
    if (unit_.factor * value != box_->value()) hint_->hide();
    const QSignalBlocker quiet(box_);
    box_->setValue(unit_.factor * value);
    slider_->display(value);
    reset_->setVisible(!compact_ && value != parameter_.initial);
}

void ParameterField::setMixed(bool mixed) {
    const QSignalBlocker quiet(box_);
    box_->setMixed(mixed);
    slider_->setEnabled(!mixed);
    if (mixed) reset_->setVisible(!compact_);
}

void ParameterField::setCeiling(std::optional<double> ceiling, const QString& meaning) {
    ceilingText_ = ceiling ? meaning : QString();
    slider_->setCeiling(ceiling);
    describe();
}

bool ParameterField::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick) edit(parameter_.initial, 0);
    return QWidget::eventFilter(watched, event);
}

void ParameterField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) reset_->setIcon(icon(QStringLiteral("reset")));
    QWidget::changeEvent(event);
}

void ParameterField::followSlider() {
    const Gesture gesture = slider_->isSliderDown() ? gesture_ : stepGesture();
    edit(slider_->current(), gesture);
}

Gesture ParameterField::stepGesture() {
    if (!sinceStep_.isValid() || sinceStep_.elapsed() > kRunOfSteps) gesture_ = newGesture();
    sinceStep_.start();
    return gesture_;
}

} // namespace tactum
