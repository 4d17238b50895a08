#include "ui/panels/device_steps.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/base/style.h"
#include "ui/engine/device_link.h"
#include "ui/widgets/columns.h"

namespace tactum {

namespace {

/// Icon and word of a state: never the colour alone.
struct Mark {
    QString icon;
    QColor colour;
    QString word;
};

Mark markOf(StepState state) {
    switch (state) {
    case StepState::Doing:
        return {QStringLiteral("chevron-right"), theme().accent, DeviceSteps::tr("now")};
    case StepState::Done:
        return {QStringLiteral("check"), theme().contact, DeviceSteps::tr("done")};
    case StepState::Failed:
        return {QStringLiteral("error"), theme().fault, DeviceSteps::tr("failed")};
    case StepState::Waiting:
        break;
    }
    return {{}, theme().textDimmed, {}};
}

QWidget* stepRowOf(const Preparation::Step& step) {
    const Mark mark = markOf(step.state);
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kRhythm);
    auto* sign = new QLabel;
    sign->setFixedWidth(16);
    if (!mark.icon.isEmpty()) sign->setPixmap(icon(mark.icon, mark.colour).pixmap(16, 16));
    auto* name = new QLabel(step.name);
    name->setWordWrap(true);
    name->setProperty("dimmed", step.state == StepState::Waiting);
    name->setProperty("heading", step.state == StepState::Doing);
    name->setProperty("limit", step.state == StepState::Failed);
    auto* word = new QLabel(mark.word);
    word->setProperty("dimmed", step.state != StepState::Failed);
    word->setProperty("limit", step.state == StepState::Failed);
    line->addWidget(sign, 0, Qt::AlignTop);
    line->addWidget(name, 1);
    line->addWidget(word, 0, Qt::AlignTop);
    return row;
}

QString signature(const Preparation& preparation) {
    QString text;
    for (const Preparation::Step& step : preparation.steps)
        text += step.name + u'|' + QString::number(int(step.state)) + u'\n';
    return text;
}

QString stepHeadingOf(const Preparation& preparation) {
    switch (preparation.state) {
    case Preparation::State::Failed:
        return DeviceSteps::tr("%1 could not be made ready").arg(preparation.name);
    case Preparation::State::GivenUp:
        return DeviceSteps::tr("%1: given up").arg(preparation.name);
    default:
        return DeviceSteps::tr("Making %1 ready").arg(preparation.name);
    }
}

QLabel* words(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    return label;
}

} // namespace

DeviceSteps::DeviceSteps(QWidget* parent)
    : QWidget(parent), heading_(words("device-preparing")), request_(words("device-request")),
      bar_(new QProgressBar), failure_(words("device-failure")), giveUp_(new QPushButton(tr("Give up"))),
      again_(new QPushButton(tr("Try again"))) {
    heading_->setProperty("heading", true);
    failure_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setObjectName(QStringLiteral("device-progress"));
    bar_->setAccessibleName(tr("How much of the step is done"));
    giveUp_->setObjectName(QStringLiteral("device-give-up"));
    again_->setObjectName(QStringLiteral("device-again"));
    auto* column = columnIn(this, kRhythm);
    column->addWidget(heading_);
    rows_ = new QVBoxLayout;
    rows_->setSpacing(kRhythm / 2);
    column->addLayout(rows_);
    for (QWidget* each : std::initializer_list<QWidget*>{request_, bar_, failure_})
        column->addWidget(each);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(giveUp_);
    buttons->addWidget(again_);
    buttons->addStretch();
    column->addLayout(buttons);
    connect(giveUp_, &QPushButton::clicked, this, &DeviceSteps::giveUpPressed);
    connect(again_, &QPushButton::clicked, this, &DeviceSteps::againPressed);
    hide();
}

void DeviceSteps::show(const Preparation& preparation) {
    using State = Preparation::State;
    const State state = preparation.state;
    const bool running = state == State::Running;
    heading_->setText(stepHeadingOf(preparation));
    fillRows(preparation);
    request_->setText(preparation.request);
    request_->setVisible(running && !preparation.request.isEmpty());
    bar_->setValue(int(1000 * preparation.progress));
    bar_->setVisible(running);
    failure_->setText(preparation.failure);
    failure_->setVisible(state == State::Failed);
    giveUp_->setVisible(running);
    giveUp_->setEnabled(!preparation.givingUp);
    giveUp_->setText(preparation.givingUp ? tr("Giving up") : tr("Give up"));
    again_->setVisible(state == State::Failed || state == State::GivenUp);
    setVisible(running || state == State::Failed || state == State::GivenUp);
}

void DeviceSteps::fillRows(const Preparation& preparation) {
    const QString now = signature(preparation);
    if (now == shown_) return;
    shown_ = now;
    while (auto* item = rows_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // whoever tells of another theme goes through a list of all widgets
        delete item;
    }
    QStringList heard;
    for (const Preparation::Step& step : preparation.steps) {
        rows_->addWidget(stepRowOf(step));
        heard << QStringLiteral("%1 %2").arg(step.name, markOf(step.state).word).trimmed();
    }
    setAccessibleName(heard.join(QStringLiteral(", ")));
}

void DeviceSteps::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) shown_.clear();
    QWidget::changeEvent(event);
}

} // namespace tactum
