// Cameras that are kept with the scene: the menu that looks from them, keeps and changes them.
#pragma once

#include <functional>
#include <vector>

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
    /// What can be done with each of them; not while a recording is shown.
    struct Verb {
        const char* id;
        QString text, sentence;
        std::function<void(const QString& name)> does;
    };

    explicit CamerasMenu(const Workbench& bench);

    std::vector<Verb> verbs();

    /// Of all there are, in their order.
    QStringList names() const;
    /// Looks from there; nothing for a name that none has.
    void show(const QString& name);

private:
    void addKeys();
    void fill(QMenu& menu);
    QString askFor(const QString& title, const QString& now, const QString& taken);
    void keep();
    void remove(const QString& name);
    void put(const QString& text, const QString& name);
    void rename(const QString& name);

    Workbench bench_;
};

} // namespace tactum
