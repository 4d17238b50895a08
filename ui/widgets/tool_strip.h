// One row over the top of the view: what the tool that is on can be told.
#pragma once

#include <QList>
#include <QWidget>

class QAction;

namespace tactum {

class WrappingRow;

/// Lists, fields and buttons from left to right; what has no room goes on in a row below rather than being
/// cut off, taken from the panels or pushed together. Thread: ui.
class ToolStrip : public QWidget {
    Q_OBJECT
public:
    explicit ToolStrip(QWidget* parent = nullptr);

    /// Dimmed words in front of what follows.
    void addLabel(const QString& text);
    /// A list of actions of which one is on: `names` are shorter than the actions' own words.
    void addChoices(const QString& what, const QList<QAction*>& actions, const QStringList& names);
    /// A button with the action's words, or with a shorter name.
    void addAction(QAction* action, const QString& name = {});
    /// A button that shows several under one name; `what`: its tooltip.
    void addMenu(const QString& name, const QString& what, const QList<QAction*>& actions);
    void addField(QWidget* field);
    /// What follows is of another kind.
    void addGap();
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override; ///< a list that became wider

private:
    void layOut();

    QWidget* content_;
    WrappingRow* row_;
};

} // namespace tactum
