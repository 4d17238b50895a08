#include "ui/panels/health_panel.h"

#include <algorithm>

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include "core/safety/force_gate.h"
#include "core/safety/motor_heat.h"
#include "core/safety/passivity.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/panels/event_list.h"
#include "ui/widgets/level_bar.h"
#include "ui/widgets/period_chart.h"

namespace tactum {

namespace {

constexpr int kColumn = 156, kHealthGap = 2 * kRhythm, kHealthMargin = 12; // pixels

QString wrapped(const QString& sentences) {
    return QStringLiteral("<p>%1</p>").arg(sentences.toHtmlEscaped());
}

/// Its own line, or the right end of one.
QLabel* figure(const QString& name, const QString& meaning) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setFont(figureFont());
    label->setToolTip(wrapped(meaning));
    return label;
}

QLabel* sentence(const QString& name, const QString& meaning) {
    QLabel* label = figure(name, meaning);
    label->setProperty("dimmed", true);
    label->setWordWrap(true);
    return label;
}

/// A word at the left, its figure at the right.
void addRow(QVBoxLayout* rows, const QString& word, QLabel* value) {
    auto* label = new QLabel(word);
    label->setToolTip(value->toolTip());
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setAccessibleName(word);
    auto* row = new QHBoxLayout;
    row->setSpacing(kRhythm);
    row->addWidget(label);
    row->addWidget(value, 1);
    rows->addLayout(row);
}

QString inKilohertz(double hertz) {
    return hertz < 9950 ? numberText(hertz, 0) : numberText(1e-3 * hertz, 1) + QStringLiteral("k");
}

QString shortTime(double micros) {
    return micros < 1000 ? HealthPanel::tr("%1 \u00b5s").arg(numberText(micros, 0))
                         : HealthPanel::tr("%1 ms").arg(numberText(1e-3 * micros, 0));
}

QString healthRateText(double rate, double nominal) {
    return HealthPanel::tr("%1 of %2 Hz").arg(inKilohertz(rate), inKilohertz(nominal));
}

/// Red words where something wants attention.
void setAlarming(QLabel* label, bool alarming) {
    if (label->property("limit").toBool() == alarming) return;
    label->setProperty("limit", alarming);
    repolish(*label);
}

} // namespace

HealthPanel::HealthPanel(QWidget* parent)
    : QScrollArea(parent), body_(new QWidget), grid_(new QGridLayout(body_)) {
    setObjectName(QStringLiteral("health"));
    setAccessibleName(tr("Health of the loops"));
    setWidget(body_);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    grid_->setContentsMargins(kHealthMargin, kRhythm / 2, kHealthMargin, kRhythm / 2);
    grid_->setHorizontalSpacing(kHealthGap);
    grid_->setVerticalSpacing(kHealthGap);
    addLoops();
    addPeriods();
    addEnergy();
    addStiffness();
    addEvents();
}

QVBoxLayout* HealthPanel::addSection(const QString& title) {
    auto* section = new QWidget(body_);
    section->setMinimumWidth(kColumn);
    section->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* rows = new QVBoxLayout(section);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kRhythm / 2);
    auto* heading = new QLabel(title);
    heading->setProperty("heading", true);
    rows->addWidget(heading);
    sections_.push_back(section);
    return rows;
}

void HealthPanel::addLoops() {
    QVBoxLayout* rows = addSection(tr("Loops"));
    servo_ = figure(QStringLiteral("health-servo"),
                    tr("Ticks a second of the loop that commands the device, and how many there should be. "
                       "Fewer: close what else keeps the machine busy, or allow real-time priority."));
    proxy_ = figure(QStringLiteral("health-proxy"),
                    tr("Updates a second of the loop that moves the proxy, and how many there should be. "
                       "Fewer: the scene is heavy. The force stays smooth; details come later."));
    gap_ = figure(QStringLiteral("health-gap"),
                  tr("The longest time between two ticks of the servo in the last seconds: so long the force "
                     "stood still. After %1 ms it is taken away until the ticks come again.")
                      .arg(numberText(1e3 * kStall, 0)));
    late_ = sentence(
        QStringLiteral("health-late"),
        tr("Ticks that came more than a period late. The machine's are those in which the loop itself had "
           "hardly worked: no program can help it. Our own are worth a report."));
    fidelity_ = sentence(
        QStringLiteral("health-fidelity"),
        tr("When the proxy loop cannot keep up, textures are left out first, then force shading, then all "
           "but the nearest planes. What was left out comes back by itself. Hide objects to help it."));
    addRow(rows, tr("Servo"), servo_);
    addRow(rows, tr("Proxy"), proxy_);
    addRow(rows, tr("Worst gap"), gap_);
    rows->addWidget(late_);
    rows->addWidget(fidelity_);
    rows->addStretch();
}

void HealthPanel::addPeriods() {
    QVBoxLayout* rows = addSection(tr("Periods"));
    auto* title = rows->takeAt(0)->widget();
    auto* line = new QHBoxLayout;
    const QString meaning = tr(
        "How far the servo's periods were from their length in the last seconds, on logarithmic axes. Bars "
        "far to the right lower the stiffness ceiling. Real-time priority moves them to the left.");
    spread_ = figure(QStringLiteral("health-spread"), meaning);
    spread_->setProperty("dimmed", true);
    line->addWidget(title);
    line->addWidget(spread_, 1, Qt::AlignRight);
    rows->addLayout(line);
    periods_ = new PeriodChart;
    periods_->setToolTip(meaning);
    rows->addWidget(periods_, 1);
}

void HealthPanel::addEnergy() {
    QVBoxLayout* rows = addSection(tr("Energy and motors"));
    energy_ = figure(QStringLiteral("health-energy"),
                     tr("Energy that the surface gave the hand beyond what it took. A real surface gives "
                        "none: above 1 mJ the finger is damped until it is taken back. If that happens "
                        "often, lower the stiffness or hold the handle more firmly."));
    damping_ = figure(QStringLiteral("health-damping"),
                      tr("Damping that takes such energy back, now. 0: the surface is passive by itself."));
    heat_ = figure(QStringLiteral("health-heat"),
                   tr("Heat of the motors; 100 % is what they bear for ever. From 70 % on the limit falls "
                      "from the peak force to the continuous one. Press less, or let them cool."));
    energyBar_ = new LevelBar;
    energyBar_->setToolTip(energy_->toolTip());
    heatBar_ = new LevelBar;
    heatBar_->setToolTip(heat_->toolTip());
    addRow(rows, tr("Given"), energy_);
    rows->addWidget(energyBar_);
    addRow(rows, tr("Damping now"), damping_);
    addRow(rows, tr("Motors"), heat_);
    rows->addWidget(heatBar_);
    rows->addStretch();
}

void HealthPanel::addStiffness() {
    QVBoxLayout* rows = addSection(tr("Stiffness"));
    const QString meaning =
        tr("The stiffness up to which device, hand and sampling stay calm. Stiffer surfaces are "
           "rendered with it. A firmer grip, a faster servo and a device with more damping raise it.");
    ceiling_ = figure(QStringLiteral("health-ceiling"), meaning);
    reason_ = sentence(QStringLiteral("health-reason"), meaning);
    stiffest_ = figure(QStringLiteral("health-stiffest"),
                       tr("The stiffest visible surface of the scene, the bar; the mark is the ceiling."));
    rendered_ = figure(QStringLiteral("health-rendered"),
                       tr("The stiffness that the hand gets of what it touches now."));
    stiffnessBar_ = new LevelBar;
    stiffnessBar_->setToolTip(stiffest_->toolTip());
    override_ = new QCheckBox(tr("Render above the ceiling\nat my own risk"));
    override_->setObjectName(QStringLiteral("health-override"));
    override_->setToolTip(wrapped(tr("Surfaces are rendered as stiff as the author wants them. The device "
                                     "may shake; the guard stays on. Off again with the next start.")));
    addRow(rows, tr("Ceiling"), ceiling_);
    rows->addWidget(reason_);
    addRow(rows, tr("Stiffest"), stiffest_);
    rows->addWidget(stiffnessBar_);
    addRow(rows, tr("Rendered now"), rendered_);
    rows->addWidget(override_);
    rows->addStretch();
    connect(override_, &QCheckBox::clicked, this, [this](bool on) {
        override_->setChecked(!on); // until whoever decides says so
        emit overrideAsked(on);
    });
}

void HealthPanel::addEvents() {
    QVBoxLayout* rows = addSection(tr("Last events"));
    events_ = new EventList;
    rows->addWidget(events_, 1);
}

void HealthPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
}

/// The last section takes what is left of its row.
void HealthPanel::arrange() {
    const int count = int(sections_.size());
    const int fit = (viewport()->width() - 2 * kHealthMargin + kHealthGap) / (kColumn + kHealthGap);
    const int columns = std::clamp(fit, 1, count);
    if (columns == columns_) return;
    columns_ = columns;
    for (QWidget* section : sections_)
        grid_->removeWidget(section);
    for (int i = 0; i < count; ++i) {
        const int column = i % columns;
        grid_->addWidget(sections_[std::size_t(i)], i / columns, column, 1,
                         i + 1 == count ? columns - column : 1);
        grid_->setColumnStretch(i, i < columns ? 1 : 0);
    }
}

void HealthPanel::display(const ServoTelemetry& servo, const ProxyTelemetry& proxy,
                          const DeviceInfo& device) {
    displayLoops(servo, proxy, device);
    displayPeriods(servo, device);
    displayEnergy(servo);
}

void HealthPanel::displayLoops(const ServoTelemetry& servo, const ProxyTelemetry& proxy,
                               const DeviceInfo& device) {
    servo_->setText(healthRateText(servo.rate, device.rate));
    proxy_->setText(healthRateText(proxy.rate, kUpdatesPerTick * device.rate));
    gap_->setText(tr("%1 ms").arg(numberText(1e3 / device.rate + 1e-3 * servo.periods.longest, 1)));
    late_->setText(tr("Late ticks: %1").arg(lateWords(servo, recorded_)));
    QString words = fidelityWords(proxy.fidelity);
    if (proxy.stepsDown > 0)
        words += proxy.stepsDown == 1 ? tr(" Lowered once.") : tr(" Lowered %1 times.").arg(proxy.stepsDown);
    fidelity_->setText(words);
    setAlarming(fidelity_, proxy.fidelity != Fidelity::Full);
}

void HealthPanel::displayPeriods(const ServoTelemetry& servo, const DeviceInfo& device) {
    periods_->setPeriods(servo.periods, 1e6 / device.rate);
    constexpr double kLast = PeriodHistogram::kBounds.back();
    const double most = servo.periods.quantile(0.999);
    spread_->setText(most > kLast ? tr("more than 0.1 % > %1").arg(shortTime(kLast))
                                  : tr("99.9 % < %1").arg(shortTime(most)));
}

void HealthPanel::displayEnergy(const ServoTelemetry& servo) {
    const double given = std::max(0.0, 1e3 * servo.energy), threshold = 1e3 * kPassivityThreshold;
    energy_->setText(tr("%1 mJ").arg(numberText(given, 2)));
    energyBar_->setLevel(given, threshold, 2 * threshold, tr("%1 mJ").arg(numberText(threshold, 0)));
    damping_->setText(tr("%1 N s/m").arg(numberText(servo.passivityDamping, 1)));
    setAlarming(damping_, servo.passivityDamping > 0);
    heat_->setText(tr("%1 % warm").arg(numberText(100 * servo.heat, 0)));
    rendered_->setText(servo.rendered > 0 ? tr("%1 N/m").arg(numberText(servo.rendered, 0)) : tr("nothing"));
    heatBar_->setLevel(servo.heat, kWarmMotors, 1, tr("%1 %").arg(numberText(100 * kWarmMotors, 0)));
}

void HealthPanel::displayCeiling(const CeilingNow& ceiling, const Stiffest& stiffest, bool overridden) {
    ceiling_->setText(tr("%1 N/m").arg(numberText(ceiling.value, 0)));
    reason_->setText(overridden ? tr("overridden at your own risk") : ceiling.reason);
    setAlarming(reason_, overridden);
    stiffest_->setText(stiffest.value > 0 ? tr("%1 N/m").arg(numberText(stiffest.value, 0))
                                          : tr("nothing yet"));
    stiffest_->setAccessibleDescription(stiffest.name);
    stiffnessBar_->setLevel(stiffest.value, ceiling.value, 1.25 * std::max(stiffest.value, ceiling.value),
                            tr("ceiling"));
    override_->setChecked(overridden);
}

void HealthPanel::setRecorded(bool recorded) {
    recorded_ = recorded;
    override_->setEnabled(!recorded);
}

void HealthPanel::setEvents(const std::deque<HealthEvent>& events) {
    events_->setEvents(events);
}

} // namespace tactum
