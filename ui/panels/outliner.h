// The tree of objects and their surfaces.
#pragma once

#include "ui/document.h"
#include "ui/panels/hinted_tree.h"

namespace tactum {

/// Follows the document and edits it: the eye shows and hides an object, F2 or a double click renames, and
/// the selection goes both ways.
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
    void selectCurrent();
    void rename(QTreeWidgetItem* item);
    void toggleEye(QTreeWidgetItem* item, int column);

    Document& document_;
    bool filling_ = false; ///< our own changes of the tree are no edits
};

} // namespace tactum
