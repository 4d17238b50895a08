#include "ui/study/staircase_fields.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>

#include "core/base/numbers.h"
#include "ui/base/words.h"

namespace tactum {

namespace {

constexpr int kFinerThanTheField = 3; // decimals: thresholds are finer than what an author sets
constexpr int kListed = 24;           // rows of the open list

/// What stands over the numbers of one kind in the list.
QString headingOf(const SceneValue& value) {
    switch (value.inside()) {
    case SceneValue::Inside::Layer:
    case SceneValue::Inside::Mask:
        return StaircaseFields::tr("Layer %1").arg(value.index() + 1);
    case SceneValue::Inside::Joint:
        return StaircaseFields::tr("Joint %1").arg(value.index() + 1);
    case SceneValue::Inside::Itself:
        break;
    }
    if (value.owner() == SceneValue::Owner::Surface) return StaircaseFields::tr("Surface");
    return value.owner() == SceneValue::Owner::Object ? StaircaseFields::tr("Body")
                                                      : StaircaseFields::tr("Scene");
}

void addHeading(QComboBox& list, const QString& text) {
    list.addItem(text);
    auto* item = static_cast<QStandardItemModel*>(list.model())->item(list.count() - 1);
    item->setFlags(Qt::NoItemFlags);
    QFont bold = item->font();
    bold.setBold(true);
    item->setFont(bold);
}

/// What there is in the scene, and that of the rule, under headings.
void fill(QComboBox& list, const Scene& scene, const StaircaseRule& rule) {
    std::vector<SceneValue> values = valuesIn(scene);
    const auto own = valueOf(rule);
    if (own && std::ranges::find(values, *own) == values.end()) values.push_back(*own);
    QString heading;
    for (const SceneValue& value : values) {
        if (const QString next = headingOf(value); next != heading) addHeading(list, heading = next);
        const QString unit = displayUnit(value.parameter()).name;
        list.addItem(unit.isEmpty() ? wordsFor(value) : QStringLiteral("%1 (%2)").arg(wordsFor(value), unit),
                     asIs(value.path()));
    }
    if (!own) list.addItem(asIs(rule.parameter), asIs(rule.parameter)); // until another one is chosen
    list.setCurrentIndex(list.findData(asIs(own ? own->path() : rule.parameter)));
}

/// All, then each name once; `now` stays among them although the scene has it no more.
void fill(QComboBox& list, const QString& all, QStringList names, const std::string& now) {
    if (!now.empty()) names << asIs(now);
    names.removeAll(QString());
    names.removeDuplicates();
    list.addItem(all);
    list.addItems(names);
    list.setCurrentIndex(now.empty() ? 0 : 1 + int(names.indexOf(asIs(now))));
}

std::string chosenIn(const QComboBox& list) {
    return list.currentIndex() <= 0 ? std::string() : list.currentText().toStdString();
}

} // namespace

QString wordsFor(const SceneValue& value) {
    const QString label = wordsOf(value.parameter().label);
    const qulonglong number = value.index() + 1;
    switch (value.inside()) {
    case SceneValue::Inside::Layer:
        return StaircaseFields::tr("Layer %1: %2").arg(number).arg(label);
    case SceneValue::Inside::Mask:
        return StaircaseFields::tr("Layer %1, mask: %2").arg(number).arg(label);
    case SceneValue::Inside::Joint:
        return StaircaseFields::tr("Joint %1: %2").arg(number).arg(label);
    case SceneValue::Inside::Itself:
        break;
    }
    return label;
}

StaircaseRule withLevelsFor(StaircaseRule rule, const Parameter& parameter, double now) {
    const double middle = 0.5 * (parameter.minimum + parameter.maximum);
    rule.reference = parameter.clamped(now);
    if (parameter.maximum - rule.reference < parameter.step) rule.reference = middle; // nothing is above it
    const double wanted = std::max(std::abs(rule.reference), 10 * parameter.step);
    rule.largest = std::min(wanted, parameter.maximum - rule.reference);
    rule.smallest = 0;
    rule.start = rule.largest / 2;
    rule.ratio = false;
    rule.steps = {rule.largest / 5, rule.largest / 10, rule.largest / 20};
    return rule;
}

StaircaseFields::StaircaseFields(const StaircaseRule& rule, const std::vector<Scene>& conditions,
                                 QWidget* parent)
    : QGroupBox(tr("Staircase"), parent), first_(rule),
      scene_(conditions.empty() ? Scene() : conditions.front()) {
    auto* form = new QFormLayout(this);
    addParameters(*form);
    addPlaces(*form);
    addLevels(*form);
    addCounts(*form);
    showLevels(rule);
    enablePlaces();
    filling_ = false;
}

void StaircaseFields::addParameters(QFormLayout& form) {
    form.addRow(tr("Parameter"), parameter_ = box("study-parameter"));
    parameter_->setMaxVisibleItems(kListed);
    fill(*parameter_, scene_, first_);
    connect(parameter_, &QComboBox::currentIndexChanged, this, &StaircaseFields::chooseParameter);
}

void StaircaseFields::addPlaces(QFormLayout& form) {
    QStringList objects, surfaces;
    for (const SceneObject& object : scene_.objects) {
        objects << asIs(object.name);
        for (const Surface& surface : object.surfaces)
            surfaces << asIs(surface.name);
    }
    form.addRow(tr("Object"), object_ = box("study-object"));
    fill(*object_, tr("All objects"), objects, first_.object);
    form.addRow(tr("Surface"), surface_ = box("study-surface"));
    fill(*surface_, tr("All surfaces"), surfaces, first_.surface);
    for (QComboBox* each : {object_, surface_})
        connect(each, &QComboBox::currentIndexChanged, this, &StaircaseFields::tell);
}

void StaircaseFields::addLevels(QFormLayout& form) {
    form.addRow(compares_ =
                    check("study-compares", tr("Two intervals: one has the reference"), first_.compares));
    form.addRow(tr("Reference value"), reference_ = number("study-reference"));
    form.addRow(tr("First difference"), start_ = number("study-start"));
    form.addRow(tr("Smallest difference"), smallest_ = number("study-smallest"));
    form.addRow(tr("Largest difference"), largest_ = number("study-largest"));
    form.addRow(tr("Steps, the next after each reversal"), steps_ = new QLineEdit);
    steps_->setObjectName(QStringLiteral("study-steps"));
    connect(steps_, &QLineEdit::textChanged, this, &StaircaseFields::tell);
    form.addRow(ratio_ = check("study-ratio", tr("Steps multiply and divide"), first_.ratio));
}

void StaircaseFields::addCounts(QFormLayout& form) {
    form.addRow(tr("Right answers to go down"), down_ = whole("study-down", 1, 4, first_.down));
    form.addRow(tr("Ends after reversals"), reversals_ = whole("study-reversals", 1, 1000, first_.reversals));
    form.addRow(tr("Threshold of the last"), used_ = whole("study-used", 1, 1000, first_.used));
    form.addRow(tr("At most trials"), trials_ = whole("study-trials", 1, kMaxTrials, first_.trials));
}

QComboBox* StaircaseFields::box(const char* name) {
    auto* combo = new QComboBox;
    combo->setObjectName(QString::fromLatin1(name));
    // A long name is no reason for a wide dialog.
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(16);
    return combo;
}

QDoubleSpinBox* StaircaseFields::number(const char* name) {
    auto* spin = new QDoubleSpinBox;
    spin->setObjectName(QString::fromLatin1(name));
    connect(spin, &QDoubleSpinBox::valueChanged, this, &StaircaseFields::tell);
    return spin;
}

QSpinBox* StaircaseFields::whole(const char* name, int least, int most, int now) {
    auto* spin = new QSpinBox;
    spin->setObjectName(QString::fromLatin1(name));
    spin->setRange(least, most);
    spin->setValue(now);
    connect(spin, &QSpinBox::valueChanged, this, &StaircaseFields::tell);
    return spin;
}

QCheckBox* StaircaseFields::check(const char* name, const QString& text, bool on) {
    auto* tick = new QCheckBox(text);
    tick->setObjectName(QString::fromLatin1(name));
    tick->setChecked(on);
    connect(tick, &QCheckBox::toggled, this, &StaircaseFields::tell);
    return tick;
}

void StaircaseFields::tell() {
    if (!filling_) emit edited();
}

/// Levels of another parameter mean nothing for this one.
void StaircaseFields::chooseParameter() {
    StaircaseRule next = first_;
    next.parameter = parameter_->currentData().toString().toStdString();
    if (const auto value = valueOf(next)) {
        const Parameter& parameter = value->parameter();
        const double now =
            value->in(scene_, {chosenIn(*object_), chosenIn(*surface_)}).value_or(parameter.initial);
        filling_ = true;
        showLevels(withLevelsFor(next, parameter, now));
        enablePlaces();
        filling_ = false;
    }
    tell();
}

void StaircaseFields::showLevels(const StaircaseRule& rule) {
    const auto value = valueOf(rule);
    const Parameter& parameter = value ? value->parameter() : kStiffness;
    unit_ = displayUnit(parameter);
    const double least = unit_.factor * parameter.minimum, most = unit_.factor * parameter.maximum;
    const auto show = [&](QDoubleSpinBox& spin, double low, double high, double now) {
        spin.setDecimals(unit_.decimals + kFinerThanTheField);
        spin.setRange(low, high);
        spin.setSingleStep(unit_.factor * parameter.step);
        spin.setSuffix(unit_.name.isEmpty() ? QString() : u' ' + unit_.name);
        spin.setValue(unit_.factor * now);
    };
    show(*reference_, least, most, rule.reference);
    for (const auto& [spin, now] :
         {std::pair(start_, rule.start), {smallest_, rule.smallest}, {largest_, rule.largest}})
        show(*spin, 0, most - least, now);
    ratio_->setChecked(rule.ratio);
    QStringList steps;
    for (const double step : rule.steps)
        steps << QString::number(rule.ratio ? step : unit_.factor * step, 'g', 12);
    steps_->setText(steps.join(QStringLiteral("; ")));
}

void StaircaseFields::enablePlaces() {
    const auto value = valueOf(rule());
    object_->setEnabled(!value || value->owner() != SceneValue::Owner::Scene);
    surface_->setEnabled(!value || value->owner() == SceneValue::Owner::Surface);
}

StaircaseRule StaircaseFields::rule() const {
    StaircaseRule rule;
    rule.parameter = parameter_->currentData().toString().toStdString();
    rule.object = chosenIn(*object_);
    rule.surface = chosenIn(*surface_);
    rule.compares = compares_->isChecked();
    rule.reference = reference_->value() / unit_.factor;
    rule.start = start_->value() / unit_.factor;
    rule.smallest = smallest_->value() / unit_.factor;
    rule.largest = largest_->value() / unit_.factor;
    rule.ratio = ratio_->isChecked();
    rule.steps.clear();
    for (const QString& step : steps_->text().split(u';', Qt::SkipEmptyParts))
        rule.steps.push_back(parseNumber(step.trimmed().toStdString()).value_or(0) /
                             (rule.ratio ? 1 : unit_.factor));
    rule.down = down_->value();
    rule.reversals = reversals_->value();
    rule.used = used_->value();
    rule.trials = trials_->value();
    return rule;
}

} // namespace tactum
