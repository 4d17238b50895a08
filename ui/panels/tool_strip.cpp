#include "ui/panels/tool_strip.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/style.h"

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

ToolStrip::ToolStrip(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
    setObjectName(QStringLiteral("tool-strip"));
    row_->setContentsMargins(kRhythm, kRhythm / 2, kRhythm, kRhythm / 2);
    row_->setSpacing(kRhythm / 2);
    hide();
}

void ToolStrip::addLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("dimmed", true);
    row_->addWidget(label);
}

void ToolStrip::addChoices(const QList<QAction*>& actions, const QStringList& names) {
    for (qsizetype i = 0; i < actions.size(); ++i) {
        QToolButton* button = buttonOf(actions[i], names[i]);
        button->setProperty("choice", true);
        row_->addWidget(button);
    }
}

void ToolStrip::addAction(QAction* action) {
    row_->addWidget(buttonOf(action, action->text().remove(u'&')));
}

void ToolStrip::addField(QWidget* field) {
    row_->addWidget(field);
}

void ToolStrip::addStretch() {
    row_->addStretch(1);
}

} // namespace tactum
