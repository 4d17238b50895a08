#include "ui/panels/device_trial_page.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "core/runtime/engine.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/engine/health_words.h"
#include "ui/widgets/columns.h"
#include "ui/widgets/force_meter.h"

namespace tactum {

namespace {

constexpr int kFramesPerTrialFigure = 6;

struct Words {
    Trial trial;
    const char* name;
    const char* button;
    const char* task;
};
constexpr std::array<Words, 3> kTrialWords{{
    {Trial::Spring, "trial-spring-button", QT_TR_NOOP("Spring"),
     QT_TR_NOOP(
         "Bring the finger to the middle. From there a gentle spring draws it back, wherever you go.")},
    {Trial::Wall, "trial-wall-button", QT_TR_NOOP("Wall"),
     QT_TR_NOOP(
         "A stiff wall stands to the right of the middle. Push against it: it holds and does not buzz.")},
    {Trial::Friction, "trial-friction-button", QT_TR_NOOP("Friction"),
     QT_TR_NOOP("A plate lies below the middle. Press on it and stroke: it holds, then lets go and slides.")},
}};

QLabel* trialWords(const char* name, bool dimmed) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setProperty("dimmed", dimmed);
    label->setWordWrap(true);
    return label;
}

} // namespace

DeviceTrialPage::DeviceTrialPage(QWidget* parent)
    : QWidget(parent), task_(trialWords("trial-task", false)), state_(trialWords("trial-state", false)),
      limits_(trialWords("trial-limits", true)), force_(new ForceMeter),
      end_(new QPushButton(tr("Back to my scene"))) {
    auto* column = columnIn(this, kRhythm);
    auto* row = new QHBoxLayout;
    row->setSpacing(kRhythm / 2);
    column->addLayout(row);
    for (std::size_t i = 0; i < kTrialWords.size(); ++i) {
        auto* button = buttons_[i] = new QToolButton;
        button->setObjectName(QLatin1String(kTrialWords[i].name));
        button->setText(tr(kTrialWords[i].button));
        button->setToolTip(tr(kTrialWords[i].task));
        button->setAccessibleName(tr("Try: %1").arg(button->text()));
        button->setCheckable(true);
        button->setProperty("choice", true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button, 1);
        connect(button, &QToolButton::clicked, this, [this, i] {
            setTrial(trial_); // until whoever decides says so
            emit chosen(kTrialWords[i].trial);
        });
    }
    force_->setObjectName(QStringLiteral("trial-force"));
    end_->setObjectName(QStringLiteral("trial-end-button"));
    for (QWidget* each : std::initializer_list<QWidget*>{task_, state_, force_, limits_, end_})
        column->addWidget(each);
    column->addStretch();
    connect(end_, &QPushButton::clicked, this, &DeviceTrialPage::endPressed);
    setTrial({});
}

void DeviceTrialPage::setTrial(std::optional<Trial> trial) {
    trial_ = trial;
    for (std::size_t i = 0; i < kTrialWords.size(); ++i)
        buttons_[i]->setChecked(trial == kTrialWords[i].trial);
    task_->setText(trial ? tr(kTrialWords[std::size_t(*trial)].task)
                         : tr("Three small scenes to feel whether a device works as it should. Your own "
                              "scene waits, unchanged."));
    state_->setVisible(trial.has_value());
    end_->setEnabled(trial.has_value());
    frames_ = 0;
}

void DeviceTrialPage::display(const Engine& engine) {
    force_->setForce(engine.servo().force.norm(), std::max(0.1, engine.device().maxForce));
    if (frames_++ % kFramesPerTrialFigure) return;
    state_->setText(engine.armed() ? tr("The forces are on.")
                                   : tr("The forces are off. Hold the handle, then arm."));
    showLimits(engine);
}

void DeviceTrialPage::showLimits(const Engine& engine) {
    const DeviceInfo& device = engine.device();
    const CeilingNow ceiling = ceilingNow(engine.servo(), device);
    QString force = tr("At most %1 N").arg(numberText(device.maxForce, 1));
    if (device.continuousForce > 0 && device.continuousForce < device.maxForce)
        force += tr(", %1 N for ever").arg(numberText(device.continuousForce, 1));
    limits_->setText(
        tr("%1. Stiffness up to %2 N/m, %3.").arg(force, numberText(ceiling.value, 0), ceiling.reason));
}

} // namespace tactum
