// What a file means that says neither its unit nor which axis is up.
#pragma once

#include <optional>

#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/document/taken_as.h"

namespace tactum {

class ImportBar;
class TouchHint;

/// Thread: ui.
class ImportController : public QObject {
    Q_OBJECT
public:
    /// The bar of recordings lies at the same edge of the view, and what the view hints at stays above both.
    ImportController(const Workbench& bench, ImportBar& bar, const QWidget& playbackBar, TouchHint& hint);

private:
    void connectCommands();
    void connectDocument();
    std::optional<FileAxes> shownAxes() const;
    void takeOtherwise(const FileAxes& axes);
    void endAsking();
    void show();
    void keepFootFree();
    void showCommands(const TakenAs* taken);

    Workbench bench_;
    ImportBar& bar_;
    const QWidget& playbackBar_;
    TouchHint& hint_;
    bool seen_ = false;             ///< the person has closed the bar
    std::optional<FileAxes> asked_; ///< as which the file is being read again
    QString fitted_;                ///< what was last noted of the document
};

} // namespace tactum
