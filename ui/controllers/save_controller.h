// Saving the scene, and not losing it.
#pragma once

#include <functional>

#include <QObject>
#include <QStringList>

#include "ui/controllers/workbench.h"

namespace tactum {

/// Thread: ui.
class SaveController : public QObject {
    Q_OBJECT
public:
    /// `samples`: files that are never written over.
    SaveController(const Workbench& bench, const QStringList& samples);

    /// Goes on when nothing would be lost by it, or when the person has saved or thrown away what would be.
    /// `intent`: "closing", "opening teapot.glb".
    void leave(const QString& intent, const std::function<void()>& goOn);
    /// Brings the title of the window and the recent files to the document's file.
    void showFile();

signals:
    /// Those that were opened last.
    void filesChanged();

private:
    void save();
    void saveAs();
    void askToOverwrite();
    void exportBundle();
    void goOnAfter(const QString& file);

    Workbench bench_;
    QStringList samples_;
    std::function<void()> afterSave_; ///< what the person wanted to do next
    QString wasSaved_;                ///< as it was told; no longer true after an edit
};

} // namespace tactum
