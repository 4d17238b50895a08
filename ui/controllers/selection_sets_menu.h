// Selection sets: the menu and the button that keep, select and change them.
#pragma once

#include <functional>
#include <string>

#include <QObject>
#include <QStringList>

#include "core/scene/scene.h"
#include "ui/controllers/workbench.h"

class QMenu;
class QToolButton;

namespace tactum {

/// Thread: ui.
class SelectionSetsMenu : public QObject {
    Q_OBJECT
public:
    /// `place`: the menu that gets one of the sets inside it.
    SelectionSetsMenu(const Workbench& bench, QMenu& place);

    /// A button with the same menu.
    QToolButton* makeButton();
    /// Of all sets there are, rising.
    QStringList names() const;
    /// Selects its triangles; nothing for a name that no set has.
    void select(const QString& name);

private:
    using Does = void (SelectionSetsMenu::*)(const QString&);

    void fill(QMenu& menu);
    void addVerb(QMenu& menu, const QString& verb, const char* id, bool possible, Does does);
    QString askFor(const QString& title, const QString& now, const QString& taken);
    void keep();
    void add(const QString& name);
    void replace(const QString& name);
    void rename(const QString& name);
    void remove(const QString& name);
    void edit(const QString& text, const std::function<void(Scene&)>& change);

    Workbench bench_;
};

} // namespace tactum
