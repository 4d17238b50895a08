// What is the matter with the scene, where it is, and what to do about it.
#pragma once

#include <vector>

#include "core/health/examine.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

/// The reader's findings and those of examine(), looked for on a worker whenever shapes change. Activating
/// one selects its object and shows its place. A row that a safe repair can repair has a button for it: one
/// undoable step, made on a worker too.
class Problems : public HintedTree {
    Q_OBJECT
public:
    explicit Problems(Document& document, QWidget* parent = nullptr);

    void cancelRepair() { repairing_.cancel(); }

signals:
    void counted(int problems);
    /// To be looked at: triangles of an object, and the ball around them in the frame of its body.
    void placeAsked(tactum::ObjectId object, const tactum::Problem& problem);
    /// What was shown last is no longer to be seen.
    void placeGone();
    void repairProgressed(double fraction, double secondsLeft);
    /// One line for the person; also when nothing could be repaired.
    void repaired(const QString& sentence);

private:
    void check();
    void fill(Examined examined);
    void add(const PlacedFinding& found);
    void addButton(QTreeWidgetItem* item, const PlacedFinding& found);
    void show(QTreeWidgetItem* item);
    void repair(const PlacedFinding& found);
    void finishRepair(const SceneObject& before, const SceneObject& after, const Result<Repaired>& result);

    Document& document_;
    BackgroundJob job_, repairing_;
    std::vector<KnownMesh> known_;
    std::vector<PlacedFinding> rows_; ///< in the order of the items
    bool showing_ = false;            ///< a place, by a click on its row
};

} // namespace tactum
