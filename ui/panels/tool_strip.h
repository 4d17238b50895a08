// One row above the view: what the tool that is on can be told.
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QHBoxLayout;

namespace tactum {

/// Buttons and fields from left to right. Thread: ui.
class ToolStrip : public QWidget {
    Q_OBJECT
public:
    explicit ToolStrip(QWidget* parent = nullptr);

    /// Dimmed words in front of what follows.
    void addLabel(const QString& text);
    /// Buttons of which one is on: `names` are shorter than the actions' own words.
    void addChoices(const QList<QAction*>& actions, const QStringList& names);
    /// A button with the action's words.
    void addAction(QAction* action);
    void addField(QWidget* field);
    /// What follows stands at the right end.
    void addStretch();

private:
    QHBoxLayout* row_;
};

} // namespace tactum
