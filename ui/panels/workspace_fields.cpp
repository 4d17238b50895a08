#include "ui/panels/workspace_fields.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/base/style.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/parameter_field.h"
#include "ui/widgets/columns.h"

namespace tactum {

namespace {

/// In the order of the rows of a list.
constexpr std::array<int, 6> kAxes{1, -1, 2, -2, 3, -3};
constexpr double kReach = 0.4;       // of the workspace's radius, that a motion has to go
constexpr double kMinReach = 0.01;   // m
constexpr double kUsualReach = 0.03; // m, where the radius is not known

QString axisName(int axis) {
    const QString names[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    return (axis > 0 ? WorkspaceFields::tr("device %1") : WorkspaceFields::tr("device -%1"))
        .arg(names[std::size_t(std::abs(axis) - 1)]);
}

QPushButton* fieldButton(const QString& text, const char* name, const QString& meaning) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(meaning);
    return made;
}

} // namespace

WorkspaceFields::WorkspaceFields(QWidget* parent)
    : QWidget(parent), hint_(new QLabel(tr("A simulated hand has no workspace to lay: the mouse leads it in "
                                           "the scene itself. Connect a device."))),
      fields_(new QWidget), scale_(new ParameterField(kWorkspaceScale)),
      reach_(new ChoiceBox("workspace-reach", tr("Reach"), kReachChoices)),
      shell_(new ParameterField(kShellRadius)),
      beyond_(new QLabel(tr("Beyond the shell: the workspace moves."))),
      clutch_(new ChoiceBox("workspace-clutch", tr("Clutch"), {})),
      bump_(new QCheckBox(tr("Take the workspace along at its edge"))) {
    hint_->setProperty("dimmed", true);
    hint_->setWordWrap(true);
    columnIn(this, kRhythm)->addWidget(hint_);
    layout()->addWidget(fields_);
    layout()->addWidget(makeReach()); // of the scene: also for who has no device here
    static_cast<QVBoxLayout*>(layout())->addStretch();
    auto* column = columnIn(fields_, kRhythm);
    column->addWidget(scale_);
    column->addWidget(makeAxes());
    column->addWidget(makeCapture());
    auto* row = new QGridLayout;
    auto* label = new QLabel(tr("Clutch"));
    label->setBuddy(clutch_);
    clutch_->setToolTip(tr("While this button is held the handle moves and the finger stays"));
    row->addWidget(label, 0, 0);
    row->addWidget(clutch_, 0, 1);
    row->setColumnStretch(1, 1);
    column->addLayout(row);
    bump_->setObjectName(QStringLiteral("workspace-bump"));
    bump_->setToolTip(tr("The workspace drifts along when the finger is pressed against its edge"));
    column->addWidget(bump_);
    centre_ = fieldButton(tr("Re-centre"), "workspace-centre-button",
                          tr("The middle of the workspace comes to the middle of the model"));
    fit_ = fieldButton(tr("Fit to the model"), "workspace-fit-button",
                       tr("Centred, and scaled so that the workspace takes in the model"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(centre_, 1);
    buttons->addWidget(fit_, 1);
    column->addLayout(buttons);
    connect(scale_, &ParameterField::edited, this, [this](double value) {
        Workspace next = workspace_;
        next.scale = kWorkspaceScale.clamped(value);
        set(next);
    });
    connect(clutch_, &QComboBox::activated, this, [this](int chosen) {
        Workspace next = workspace_;
        next.clutch = chosen > 0 ? std::uint32_t(1) << (chosen - 1) : 0;
        set(next);
    });
    connect(bump_, &QCheckBox::clicked, this, [this](bool on) {
        Workspace next = workspace_;
        next.bump = on;
        set(next);
    });
    connect(centre_, &QPushButton::clicked, this, &WorkspaceFields::centrePressed);
    connect(fit_, &QPushButton::clicked, this, &WorkspaceFields::fitPressed);
    show({}, 0, 0, false);
}

QWidget* WorkspaceFields::makeAxes() {
    const QString names[] = {tr("To the right (x)"), tr("Up (y)"), tr("Toward you (z)")};
    auto* section = new QWidget;
    auto* grid = new QGridLayout(section);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(kRhythm / 2);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const QString key = QStringLiteral("workspace-axis-%1").arg(i + 1);
        axes_[i] = new ChoiceBox(qPrintable(key), names[i], {});
        for (const int axis : kAxes)
            axes_[i]->addItem(axisName(axis));
        axes_[i]->setToolTip(tr("Which axis of the device goes there. Each is used once: the one that had it "
                                "before gets this one's."));
        auto* label = new QLabel(names[i]);
        label->setBuddy(axes_[i]);
        grid->addWidget(label, int(i), 0);
        grid->addWidget(axes_[i], int(i), 1);
        connect(axes_[i], &QComboBox::activated, this, [this, i](int row) { choose(i, row); });
    }
    grid->setColumnStretch(1, 1);
    return section;
}

QWidget* WorkspaceFields::makeCapture() {
    capturing_ =
        fieldButton(tr("Set the axes by moving"), "workspace-capture",
                    tr("Move the handle to the right, up and toward you: the axes follow from that"));
    task_ = new QLabel;
    task_->setObjectName(QStringLiteral("workspace-task"));
    task_->setProperty("heading", true);
    task_->setWordWrap(true);
    taskBar_ = new QProgressBar;
    taskBar_->setRange(0, 100);
    taskBar_->setTextVisible(false);
    taskBar_->setAccessibleName(tr("How far the handle has gone"));
    auto* section = new QWidget;
    auto* column = columnIn(section, kRhythm / 2);
    for (QWidget* each : std::initializer_list<QWidget*>{capturing_, task_, taskBar_})
        column->addWidget(each);
    connect(capturing_, &QPushButton::clicked, this, [this] {
        if (capturing())
            endCapture();
        else
            beginCapture();
    });
    return section;
}

QWidget* WorkspaceFields::makeReach() {
    reach_->setToolTip(
        tr("How a hand reaches beyond the device's workspace: not at all, by pulling beyond a "
           "border that is felt, or by a drift too slow to be noticed. It belongs to the scene "
           "and is for every hand."));
    beyond_->setObjectName(QStringLiteral("workspace-beyond"));
    beyond_->setProperty("limit", true);
    beyond_->setWordWrap(true);
    beyond_->hide();
    auto* section = new QWidget;
    auto* column = columnIn(section, kRhythm / 2);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Reach"));
    label->setBuddy(reach_);
    row->addWidget(label);
    row->addWidget(reach_, 1);
    column->addLayout(row);
    column->addWidget(shell_);
    column->addWidget(beyond_);
    connect(reach_, &QComboBox::activated, this, [this](int chosen) {
        emit reachChosen({ReachMode(chosen), sceneReach_.shell}, 0);
    });
    connect(shell_, &ParameterField::edited, this, [this](double value, Gesture gesture) {
        emit reachChosen({sceneReach_.mode, value}, gesture);
    });
    return section;
}

void WorkspaceFields::showReach(const Reach& reach) {
    sceneReach_ = reach;
    const QSignalBlocker quiet(reach_);
    reach_->setCurrentIndex(int(reach.mode));
    shell_->setValue(reach.shell);
    shell_->setVisible(reach.mode == ReachMode::Rate);
}

void WorkspaceFields::set(const Workspace& workspace) {
    workspace_ = workspace;
    emit edited(workspace);
}

void WorkspaceFields::choose(std::size_t which, int row) {
    Workspace next = workspace_;
    next.axes = withAxis(next.axes, which, kAxes[std::size_t(row)]);
    set(next);
}

void WorkspaceFields::show(const Workspace& workspace, int buttons, double radius, bool possible) {
    if (!possible) capture_.reset();
    workspace_ = workspace;
    radius_ = radius;
    possible_ = possible;
    hint_->setVisible(!possible);
    fields_->setVisible(possible);
    scale_->setValue(workspace.scale);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const QSignalBlocker quiet(axes_[i]);
        axes_[i]->setCurrentIndex(int(std::ranges::find(kAxes, int(workspace.axes[i])) - kAxes.begin()));
    }
    const QSignalBlocker quiet(clutch_);
    clutch_->clear();
    clutch_->addItem(tr("No button"));
    for (int i = 0; i < buttons; ++i) {
        clutch_->addItem(tr("Button %1").arg(i + 1));
        if (workspace.clutch >> i & 1) clutch_->setCurrentIndex(i + 1);
    }
    clutch_->setEnabled(buttons > 0);
    bump_->setChecked(workspace.bump);
    showCapture();
}

void WorkspaceFields::beginCapture() {
    if (!possible_) return;
    capture_.emplace(radius_ > 0 ? std::max(kMinReach, kReach * radius_) : kUsualReach);
    showCapture();
    emit captureBegun();
}

void WorkspaceFields::endCapture() {
    capture_.reset();
    showCapture();
}

void WorkspaceFields::follow(const Vec3& handle, double border) {
    beyond_->setVisible(possible_ && border > 0 && handle.norm() > border);
    if (!capture_) return;
    if (!capture_->add(handle)) {
        taskBar_->setValue(int(100 * capture_->progress()));
        return;
    }
    if (!capture_->complete()) return showCapture();
    Workspace next = workspace_;
    next.axes = capture_->axes();
    endCapture();
    set(next);
}

void WorkspaceFields::showCapture() {
    const QString tasks[] = {tr("1 of 3: move the handle to the right"), tr("2 of 3: move the handle up"),
                             tr("3 of 3: move the handle toward you"), QString()};
    task_->setVisible(capturing());
    taskBar_->setVisible(capturing());
    taskBar_->setValue(0);
    if (capturing()) task_->setText(tasks[capture_->step()]);
    capturing_->setText(capturing() ? tr("Leave the axes as they were") : tr("Set the axes by moving"));
}

} // namespace tactum
