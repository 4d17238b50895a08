// Objects that come into the scene, are doubled, renamed, and go: commands, dropped files, and what is told.
#pragma once

#include <optional>

#include <QObject>
#include <QStringList>

#include "ui/controllers/workbench.h"

class QMenu;
class QPoint;
class QWidget;

namespace tactum {

class ArrangeTool;
class HandLink;
class Outliner;
struct PickHit;
struct SceneAddition;

/// Thread: ui.
class PartsController : public QObject {
    Q_OBJECT
public:
    /// `samples`: scenes that may come in, too.
    PartsController(const Workbench& bench, ArrangeTool& arranging, HandLink& hand, Outliner& outliner,
                    QStringList samples);

    void fillSamples(QMenu& menu);
    /// What is dropped on a scene comes into it; one alone without a scene is opened.
    void drop(const QStringList& files);
    /// Of what is there in the view.
    void askInView(const std::optional<PickHit>& hit, const QPoint& at);

signals:
    /// It is to be opened, in the place of the scene.
    void opens(const QString& file);

private:
    void askToAdd();
    void add(const QStringList& files);
    void showAdded(const SceneAddition& addition);
    void duplicate();
    void removeSelected();
    void showMenu(const QPoint& at, QWidget& over);

    Workbench bench_;
    ArrangeTool& arranging_;
    HandLink& hand_;
    QStringList samples_;
    QString dropped_;      ///< the one model that is being added because it was dropped
    bool grabbed_ = false; ///< the finger in the view
};

} // namespace tactum
