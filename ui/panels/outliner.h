// The tree of objects and their surfaces.
#pragma once

#include "ui/document.h"
#include "ui/panels/hinted_tree.h"

namespace tactum {

/// Follows the document and edits it: the eye shows and hides an object or a surface, the lock keeps a
/// surface from edits, F2 or a double click renames, and the selection goes both ways.
class Outliner : public HintedTree {
    Q_OBJECT
public:
    explicit Outliner(Document& document, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    void follow(const SceneChange& change);
    void rebuild();
    QTreeWidgetItem* addObject(const SceneObject& object);
    void showSelection();
    void selectChosen();
    static void showEye(QTreeWidgetItem& item, bool visible, bool shown);
    static void showLock(QTreeWidgetItem& item, bool locked);
    void rename(QTreeWidgetItem* item);
    void toggle(QTreeWidgetItem* item, int column);

    Document& document_;
    bool filling_ = false;  ///< our own changes of the tree are no edits
    bool choosing_ = false; ///< the rows show already what is being selected
};

} // namespace tactum
