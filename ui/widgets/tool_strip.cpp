#include "ui/widgets/tool_strip.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "ui/base/style.h"
#include "ui/widgets/wrapping_row.h"

namespace tactum {

namespace {

QToolButton* buttonOf(QAction* action, const QString& text) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setObjectName(action->objectName() + QStringLiteral("-button"));
    button->setAccessibleName(action->text().remove(u'&'));
    button->setToolTip(action->toolTip());
    button->setCheckable(action->isCheckable());
    button->setChecked(action->isChecked());
    button->setEnabled(action->isEnabled());
    QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
    QObject::connect(action, &QAction::changed, button, [button, action] {
        button->setChecked(action->isChecked());
        button->setEnabled(action->isEnabled());
    });
    return button;
}

} // namespace

ToolStrip::ToolStrip(QWidget* parent)
    : QWidget(parent), content_(new QWidget(this)), row_(new WrappingRow(content_)) {
    setObjectName(QStringLiteral("tool-strip"));
    row_->setContentsMargins(kRhythm, kRhythm / 2, kRhythm, kRhythm / 2);
    row_->setSpacing(kRhythm / 2);
    content_->installEventFilter(this);
    setAttribute(Qt::WA_StyledBackground); // it lies over the view
    setProperty("strip", true);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    hide();
}

QSize ToolStrip::sizeHint() const {
    return row_->sizeHint();
}

void ToolStrip::layOut() {
    const int height = row_->heightForWidth(width());
    content_->resize(width(), height);
    setFixedHeight(height);
}

void ToolStrip::resizeEvent(QResizeEvent*) {
    layOut();
}

bool ToolStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        layOut();
    }
    return QWidget::eventFilter(watched, event);
}

void ToolStrip::addLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("dimmed", true);
    row_->addWidget(label);
}

void ToolStrip::addChoices(const QString& what, const QList<QAction*>& actions, const QStringList& names) {
    auto* list = new QComboBox;
    list->setFocusPolicy(Qt::TabFocus); // chosen by the mouse it leaves the keys to the view
    list->setAccessibleName(what);
    list->addItems(names);
    for (int i = 0; i < int(actions.size()); ++i) {
        list->setItemData(i, actions[i]->toolTip(), Qt::ToolTipRole);
        const auto follow = [list, i, action = actions[i]] {
            if (action->isChecked()) list->setCurrentIndex(i);
        };
        connect(actions[i], &QAction::toggled, list, follow);
        follow();
    }
    connect(list, &QComboBox::activated, this, [actions](int i) { actions[i]->trigger(); });
    row_->addWidget(list);
}

void ToolStrip::addAction(QAction* action, const QString& name) {
    row_->addWidget(buttonOf(action, name.isEmpty() ? action->text().remove(u'&') : name));
}

void ToolStrip::addMenu(const QString& name, const QString& what, const QList<QAction*>& actions) {
    auto* button = new QToolButton;
    button->setText(name);
    button->setToolTip(what);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    menu->addActions(actions);
    button->setMenu(menu);
    row_->addWidget(button);
}

void ToolStrip::addField(QWidget* field) {
    row_->addWidget(field);
}

void ToolStrip::addGap() {
    row_->addGap();
}

} // namespace tactum
