#include "ui/panels/device_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include "core/runtime/engine.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/engine/device_link.h"
#include "ui/panels/device_connect.h"
#include "ui/panels/device_live.h"
#include "ui/panels/device_trial_page.h"
#include "ui/panels/hand_list.h"
#include "ui/panels/workspace_fields.h"
#include "ui/widgets/columns.h"

namespace tactum {

namespace {

QWidget* paged(QWidget* page) {
    auto* body = new QWidget;
    auto* column = columnIn(body, 0);
    column->setContentsMargins(12, kRhythm, 12, kRhythm);
    column->addWidget(page);
    return scrolled(body);
}

} // namespace

DevicePanel::DevicePanel(DeviceLink& link, QWidget* parent)
    : QWidget(parent), link_(link), name_(new QLabel), state_(new QLabel), arm_(new QPushButton(tr("Arm"))),
      hands_(new HandList(link)), pages_(new QStackedWidget), connect_(new DeviceConnect(link)),
      live_(new DeviceLive), workspace_(new WorkspaceFields), trial_(new DeviceTrialPage) {
    setObjectName(QStringLiteral("device-panel"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = columnIn(this, kRhythm);
    column->addWidget(makeHead());
    column->addWidget(hands_);
    column->addWidget(makePages());
    column->addWidget(pages_, 1);
    for (QWidget* page : std::initializer_list<QWidget*>{connect_, live_, workspace_, trial_})
        pages_->addWidget(paged(page));
    showPage(Page::Connect);
}

QWidget* DevicePanel::makeHead() {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(12, kRhythm, 12, 0);
    row->setSpacing(kRhythm);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    name_->setObjectName(QStringLiteral("device-name"));
    name_->setProperty("heading", true);
    name_->setWordWrap(true);
    state_->setObjectName(QStringLiteral("device-state"));
    state_->setProperty("dimmed", true);
    state_->setWordWrap(true);
    words->addWidget(name_);
    words->addWidget(state_);
    row->addLayout(words, 1);
    arm_->setObjectName(QStringLiteral("device-arm"));
    row->addWidget(arm_, 0, Qt::AlignTop);
    connect(arm_, &QPushButton::clicked, this, [this] { emit armPressed(!armed_); });
    return head;
}

QWidget* DevicePanel::makePages() {
    const QString names[] = {tr("Connect"), tr("Live"), tr("Workspace"), tr("Try it")};
    auto* tabs = new QWidget;
    auto* row = new QHBoxLayout(tabs);
    row->setContentsMargins(12, 0, 12, 0);
    row->setSpacing(kRhythm / 2);
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < tabs_.size(); ++i) {
        auto* tab = tabs_[i] = new QToolButton;
        tab->setObjectName(QStringLiteral("device-page-%1").arg(i));
        tab->setText(names[i]);
        tab->setAccessibleName(tr("Page %1").arg(names[i]));
        tab->setCheckable(true);
        tab->setProperty("choice", true);
        tab->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        tab->setStyleSheet(QStringLiteral("padding: 3px 2px;")); // four have to fit a narrow dock
        group->addButton(tab, int(i));
        row->addWidget(tab, int(names[i].size()));
    }
    connect(group, &QButtonGroup::idClicked, this, [this](int id) { showPage(Page(id)); });
    return tabs;
}

void DevicePanel::showPage(Page page) {
    tabs_[std::size_t(page)]->setChecked(true);
    pages_->setCurrentIndex(int(page));
}

void DevicePanel::display(const Engine& engine, const QString& remedy) {
    workspace_->follow(engine.servo().handle_D, engine.servo().border);
    if (visibleRegion().isEmpty()) return; // behind another tab, for instance
    showState(engine, remedy);
    hands_->display();
    if (live_->isVisible()) live_->display(engine);
    if (trial_->isVisible()) trial_->display(engine);
}

void DevicePanel::showState(const Engine& engine, const QString& remedy) {
    armed_ = link_.hands().anyArmed();
    name_->setText(wordsOf(engine.device().name));
    const QString stop = tr("STOP: hold Esc");
    state_->setText(!engine.running() ? tr("it does not run")
                    : armed_          ? tr("forces on \u00b7 %1").arg(stop)
                                      : tr("forces off"));
    arm_->setText(armed_ ? tr("Forces off") : remedy.isEmpty() ? tr("Arm") : remedy);
    arm_->setToolTip(armed_ ? tr("The device gets no force. Also: hold Esc for half a second.")
                            : tr("Let the device push. Hold the handle: the force comes softly."));
    arm_->setEnabled(engine.running());
}

} // namespace tactum
