#include "ui/panels/device_live.h"

#include <algorithm>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "core/runtime/engine.h"
#include "core/safety/motor_heat.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/workspace_picture.h"
#include "ui/widgets/button_lamps.h"
#include "ui/widgets/columns.h"
#include "ui/widgets/force_meter.h"
#include "ui/widgets/level_bar.h"

namespace tactum {

namespace {

constexpr int kFramesPerFigure = 6; // more often nobody reads them

QString millimetres(const Vec3& p) {
    return DeviceLive::tr("%1, %2, %3 mm")
        .arg(numberText(1e3 * p.x(), 1), numberText(1e3 * p.y(), 1), numberText(1e3 * p.z(), 1));
}

QString rateText(double rate, double nominal) {
    return DeviceLive::tr("%1 of %2 Hz").arg(numberText(rate, 0), numberText(nominal, 0));
}

} // namespace

DeviceLive::DeviceLive(QWidget* parent)
    : QWidget(parent), picture_(new WorkspacePicture), force_(new ForceMeter), heatBar_(new LevelBar),
      lamps_(new ButtonLamps), lampWord_(new QLabel(tr("Buttons"))), trouble_(new QLabel),
      grip_(new ChoiceBox("device-grip", tr("How you hold the handle"), {})),
      stop_(new ChoiceBox("device-stop-button", tr("Button that ends all force"), {})) {
    columnIn(this, kRhythm);
    layout()->addWidget(picture_);
    position_ = addRow(tr("Handle"), "device-position",
                       tr("Where the device says that its handle is: to the right, up, and toward you"));
    rate_ =
        addRow(tr("Rate"), "device-rate", tr("Readings and forces a second, and how many there should be"));
    force_->setObjectName(QStringLiteral("device-force"));
    force_->setToolTip(tr("The force on the handle, and the most that this device may give"));
    layout()->addWidget(force_);
    heat_ = addRow(tr("Motors"), "device-heat",
                   tr("An estimate from the forces so far; 100 % is what the motors bear for ever. From 70 % "
                      "on the limit falls to the continuous force."));
    heatBar_->setToolTip(heat_->toolTip());
    layout()->addWidget(heatBar_);
    auto* lamps = new QHBoxLayout;
    lamps->addWidget(lampWord_, 1);
    lamps->addWidget(lamps_);
    static_cast<QVBoxLayout*>(layout())->addLayout(lamps);
    grip_->addItems({tr("Lightly, with the fingers"), tr("With the whole hand")});
    addChoice(tr("How you hold it"), grip_);
    addChoice(tr("This button ends all force"), stop_);
    trouble_->setObjectName(QStringLiteral("device-trouble"));
    trouble_->setProperty("limit", true);
    trouble_->setWordWrap(true);
    layout()->addWidget(trouble_);
    static_cast<QVBoxLayout*>(layout())->addStretch();
    connect(stop_, &QComboBox::activated, this,
            [this](int row) { emit stopButtonChosen(row > 0 ? std::uint32_t(1) << (row - 1) : 0); });
    connect(grip_, &QComboBox::activated, this, [this](int row) { emit graspChosen(row == 1); });
}

void DeviceLive::addChoice(const QString& words, QComboBox* box) {
    auto* label = new QLabel(words);
    label->setBuddy(box);
    layout()->addWidget(label);
    layout()->addWidget(box);
}

QLabel* DeviceLive::addRow(const QString& word, const char* name, const QString& meaning) {
    auto* label = new QLabel(word);
    auto* value = new QLabel;
    value->setObjectName(QLatin1String(name));
    value->setFont(figureFont());
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setAccessibleName(word);
    for (QLabel* each : {label, value})
        each->setToolTip(QStringLiteral("<p>%1</p>").arg(meaning));
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(value, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    return value;
}

void DeviceLive::display(const Engine& engine) {
    const ServoTelemetry& servo = engine.servo();
    const DeviceInfo& device = engine.device();
    picture_->setHandle(servo.handle_D, device.workspaceRadius);
    force_->setForce(servo.force.norm(), std::max(0.1, device.maxForce));
    lamps_->setButtons(device.buttons, servo.buttons);
    if (frames_++ % kFramesPerFigure) return;
    position_->setText(millimetres(servo.handle_D));
    rate_->setText(rateText(servo.rate, device.rate));
    heat_->setText(tr("%1 % warm").arg(numberText(100 * servo.heat, 0)));
    heatBar_->setLevel(servo.heat, kWarmMotors, 1, tr("%1 %").arg(numberText(100 * kWarmMotors, 0)));
    const QString trouble = QString::fromStdString(engine.trouble() + ' ' + engine.caution()).trimmed();
    trouble_->setText(trouble);
    trouble_->setVisible(!trouble.isEmpty());
}

void DeviceLive::setGrasped(bool grasped, bool possible) {
    const QSignalBlocker quiet(grip_);
    grip_->setCurrentIndex(grasped ? 1 : 0);
    grip_->setEnabled(possible);
    grip_->setToolTip(
        possible
            ? tr("A whole hand calms the device, so that surfaces may be up to 1.7 times as stiff. Held more "
                 "loosely than said they may shake: after three times the light grip is assumed again, "
                 "until you choose anew. It is remembered for this device.")
            : tr("Nobody holds a simulated hand."));
}

void DeviceLive::setStopButton(std::uint32_t button, int count, bool possible) {
    const QSignalBlocker quiet(stop_);
    stop_->clear();
    stop_->addItem(tr("No button"));
    for (int i = 0; i < count; ++i) {
        stop_->addItem(tr("Button %1").arg(i + 1));
        if (button >> i & 1) stop_->setCurrentIndex(i + 1);
    }
    lampWord_->setText(count > 0 ? tr("Buttons") : tr("No buttons"));
    stop_->setEnabled(possible && count > 0);
    stop_->setToolTip(
        !possible    ? tr("A simulated hand needs no stop: Esc ends its force as well.")
        : count == 0 ? tr("This device has no button.")
                     : tr("The forces go off within a millisecond and stay off until you switch them on."));
}

} // namespace tactum
