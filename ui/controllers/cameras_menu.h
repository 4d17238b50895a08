// Cameras that are kept with the scene: the menu that looks from them, keeps and changes them.
#pragma once

#include <functional>

#include <QObject>
#include <QStringList>

#include "core/scene/scene.h"
#include "ui/controllers/workbench.h"

class QMenu;

namespace tactum {

/// Keeping, updating, renaming and removing are one step of the history each; looking is none. Thread: ui.
class CamerasMenu : public QObject {
    Q_OBJECT
public:
    explicit CamerasMenu(const Workbench& bench);

    /// Of all there are, in their order.
    QStringList names() const;
    /// Looks from there; nothing for a name that none has.
    void show(const QString& name);

private:
    void addKeys();
    void fill(QMenu& menu);
    QString askFor(const QString& title, const QString& now);
    void keep();
    void put(const QString& text, const QString& name);
    void rename(const QString& name);

    Workbench bench_;
};

} // namespace tactum
