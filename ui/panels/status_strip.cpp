#include "ui/panels/status_strip.h"

#include <algorithm>
#include <span>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "core/loop/urgency.h"
#include "ui/base/language.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/widgets/force_meter.h"

namespace tactum {

namespace {

/// Rates are those of the last half second; each new text lays the whole strip out and draws the window.
constexpr int kRates = 500;    // ms
constexpr int kDevicePart = 5; // of the whole width at most, where that is more than it needs

QString kilohertz(double hertz) {
    return hertz < 9950 ? numberText(hertz, 0) + QStringLiteral(" Hz")
                        : numberText(1e-3 * hertz, 1) + QStringLiteral(" kHz");
}

QString contactsMeaning() {
    return StatusStrip::tr("What is touched, and whether friction holds or slides");
}

QString countText(int contacts) {
    return StatusStrip::tr("%1 %2").arg(contacts).arg(contacts == 1 ? StatusStrip::tr("contact")
                                                                    : StatusStrip::tr("contacts"));
}

/// What the contacts do, in words: a contact with friction either holds or slides.
QString mannerText(const HapticOutput& out) {
    const std::span known(out.contact.data(), std::size_t(std::min(out.contacts, kMaxModelPlanes)));
    if (std::ranges::all_of(known, &ContactReport::frictionless)) return {};
    const bool slips = std::ranges::all_of(known, [](const auto& c) { return c.slipping || c.frictionless; });
    return QStringLiteral(" \u00b7 ") + (slips ? StatusStrip::tr("slip") : StatusStrip::tr("stick"));
}

} // namespace

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("statusStrip"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kRhythm, kRhythm / 2, kRhythm, kRhythm / 2);
    row->setSpacing(2 * kRhythm);
    device_ = addReading(QStringLiteral("status-device"), tr("The device, and whether it may push"),
                         tr("Simulated hand \u00b7 forces off"));
    servo_ = addReading(
        QStringLiteral("status-servo"),
        tr("Servo loop: ticks a second, and the largest deviation of a period over the last half second"),
        QStringLiteral("servo 1000 Hz \u00b19999 \u00b5s"));
    proxy_ = addReading(QStringLiteral("status-proxy"),
                        tr("Proxy loop: updates a second, and the mean time of one"),
                        QStringLiteral("proxy 99.9 kHz  99.9 \u00b5s"));
    contacts_ = addReading(QStringLiteral("status-contacts"), contactsMeaning(),
                           QStringLiteral("the upper front edge \u00b7 stick"));
    force_ = new ForceMeter;
    row->addWidget(force_);
    note_ = new QLabel;
    note_->setObjectName(QStringLiteral("status-note"));
    note_->setProperty("dimmed", true);
    note_->setMinimumWidth(1); // gives way before the figures do; its tooltip has it all
    row->addWidget(note_, 1);
    arm_ = new QPushButton;
    arm_->setObjectName(QStringLiteral("arm-again"));
    arm_->setFocusPolicy(Qt::NoFocus);
    arm_->hide();
    row->addWidget(arm_);
    connect(arm_, &QPushButton::clicked, this, &StatusStrip::armPressed);
    stop_ = new QPushButton(tr("STOP"));
    stop_->setObjectName(QStringLiteral("stop"));
    stop_->setToolTip(tr("Forces off at once. Also: hold Esc for half a second."));
    stop_->setFocusPolicy(Qt::NoFocus);
    row->addWidget(stop_);
    connect(stop_, &QPushButton::clicked, this, &StatusStrip::stopPressed);
}

QLabel* StatusStrip::addReading(const QString& name, const QString& meaning, const QString& widest) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setToolTip(meaning);
    label->setFont(figureFont());
    // Wide enough for its longest text, so that nothing moves when figures change.
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest));
    layout()->addWidget(label);
    return label;
}

void StatusStrip::display(const Engine& engine) {
    const bool on = engine.running() && engine.armed();
    showDevice(engine.device().name, !engine.running() ? tr("not running")
                                     : on              ? tr("forces on")
                                                       : tr("forces off"));
    stop_->setEnabled(on || othersPush_);
    const ServoTelemetry& servo = engine.servo();
    const ProxyTelemetry& proxy = engine.proxy();
    if (!sinceRates_.isValid() || sinceRates_.elapsed() >= kRates) {
        sinceRates_.start();
        servo_->setText(
            tr("servo %1 \u00b1%2 \u00b5s").arg(kilohertz(servo.rate), numberText(servo.jitterMicros, 0)));
        proxy_->setText(
            tr("proxy %1  %2 \u00b5s").arg(kilohertz(proxy.rate), numberText(proxy.updateMicros, 1)));
    }
    showTouch(proxy, servo, engine.device());
    const bool idle = proxy.output.contacts == 0 && !hovered_.isEmpty();
    showNote(!fault_.isEmpty()   ? fault_
             : !quiet_.isEmpty() ? quiet_
             : idle              ? hovered_
                                 : priorityWords(engine.priorityNote()));
}

/// Whether it may push is never cut off; the name is, where there is little room.
void StatusStrip::showDevice(const std::string& name, const QString& state) {
    const QFontMetrics metrics = device_->fontMetrics();
    const QString words = wordsOf(name), after = QStringLiteral(" \u00b7 ") + state;
    const int room = deviceRoom() - metrics.horizontalAdvance(after);
    device_->setText(metrics.elidedText(words, Qt::ElideRight, room) + after);
    device_->setToolTip(
        QStringLiteral("%1%2\n%3").arg(words, after, tr("The device, and whether it may push")));
}

/// It is the same for hours, and is shown sixty times a second.
QString StatusStrip::priorityWords(const std::string& english) {
    if (english != english_) priority_ = wordsInside(english_ = english, kUrgencyWords);
    return priority_;
}

void StatusStrip::display(const ProxyTelemetry& proxy, const ServoTelemetry& servo,
                          const DeviceInfo& device) {
    showDevice(device.name, tr("recorded"));
    stop_->setEnabled(false);
    servo_->setText(tr("servo %1").arg(kilohertz(servo.rate)));
    proxy_->setText(tr("proxy %1").arg(kilohertz(proxy.rate)));
    showTouch(proxy, servo, device);
    showNote(tr("A recording is played: the device gets no force."));
}

void StatusStrip::showTouch(const ProxyTelemetry& proxy, const ServoTelemetry& servo,
                            const DeviceInfo& device) {
    const HapticOutput& out = proxy.output;
    QString what = tr("free"), manner;
    if (out.contacts > 0) {
        what = touched_.isEmpty() ? countText(out.contacts) : touched_;
        manner = mannerText(out);
    }
    const QFontMetrics metrics = contacts_->fontMetrics();
    const int room = contacts_->minimumWidth() - metrics.horizontalAdvance(manner);
    contacts_->setText(metrics.elidedText(what, Qt::ElideRight, room) + manner);
    contacts_->setToolTip(out.contacts > 0
                              ? touched_.isEmpty()
                                    ? contactsMeaning()
                                    : tr("%1: %2 (T selects it)").arg(touched_, countText(out.contacts))
                              : contactsMeaning());
    force_->setForce(servo.force.norm(), std::max(0.1, device.maxForce));
}

void StatusStrip::showNote(const QString& note) {
    note_->setText(note_->fontMetrics().elidedText(note, Qt::ElideRight, note_->width()));
    note_->setToolTip(note);
}

void StatusStrip::setFault(const QString& sentences, const QString& remedy) {
    arm_->setText(remedy);
    arm_->setToolTip(sentences); // which say what to do
    if (sentences == fault_) return;
    fault_ = sentences;
    const bool fault = !fault_.isEmpty();
    showReadings();
    arm_->setVisible(fault);
    setProperty("fault", fault);
    repolish(*this);
}

int StatusStrip::deviceRoom() const {
    return std::max(device_->minimumWidth(), width() / kDevicePart);
}

/// What is always there beside the device.
int StatusStrip::least() const {
    const QMargins margins = layout()->contentsMargins();
    return margins.left() + margins.right() + stop_->sizeHint().width() + note_->minimumWidth() +
           2 * layout()->spacing();
}

QSize StatusStrip::minimumSizeHint() const {
    const int gap = layout()->spacing();
    return {least() + device_->minimumWidth() + force_->minimumWidth() + contacts_->minimumWidth() + 2 * gap,
            layout()->minimumSize().height()};
}

/// The first are wanted most. Under a fault they make room for its sentences; nothing runs that they could
/// tell.
void StatusStrip::showReadings() {
    int room = fault_.isEmpty() ? width() - least() - deviceRoom() : 0;
    for (QWidget* each : {static_cast<QWidget*>(force_), static_cast<QWidget*>(contacts_),
                          static_cast<QWidget*>(servo_), static_cast<QWidget*>(proxy_)}) {
        const int wanted = each->minimumWidth() + layout()->spacing();
        each->setVisible(wanted <= room);
        room -= wanted;
    }
}

void StatusStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showReadings();
}

} // namespace tactum
