// The tree of objects and their surfaces.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <QIcon>

#include "core/scene/bodies.h"
#include "ui/document/document.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

/// Follows the document and edits it: the eye shows and hides an object or a surface, the lock keeps a
/// surface from edits, F2 or a double click renames, a drag of an object's row brings it (with the others
/// that are selected) elsewhere in the list, and the selection goes both ways.
class Outliner : public HintedTree {
    Q_OBJECT
public:
    explicit Outliner(Document& document, QWidget* parent = nullptr);

    /// Shows only what has this in its name: objects, with their surfaces, and surfaces, below their objects.
    void search(const QString& words);
    /// Selects what is found.
    void selectFound();
    /// Begins to edit the name of what was selected last: of the object where all of it is selected.
    void renameSelected();

signals:
    /// For what is selected, at a place of the screen.
    void menuAsked(const QPoint& at);

protected:
    bool keepsEditKeys() const override { return false; }
    void changeEvent(QEvent* event) override; ///< another theme
    void contextMenuEvent(QContextMenuEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override; ///< and where a dragged row would come

private:
    void follow(const SceneChange& change);
    void rebuild();
    /// Brings the rows to what the document says: only those that show something else now are changed.
    void refresh();
    QTreeWidgetItem* addObject(const SceneObject& object);
    /// What a row shows.
    struct Row {
        std::string name;
        bool visible = true, shown = true, locked = false;
        Eigen::Vector3f colour = Eigen::Vector3f::Zero(); ///< of a surface
        Moves moves = Moves::Never;                       ///< of an object

        bool operator==(const Row&) const = default;
    };
    std::vector<Row> rowsOf(const SceneObject& object) const;
    void fill(QTreeWidgetItem& item, const Row& row);
    QTreeWidgetItem* itemOf(SurfaceRef ref) const;
    bool hasSameRows(const Scene& scene) const;
    void showSelection();
    void showFound();
    void selectChosen();
    void showMoves(QTreeWidgetItem& item, Moves moves);
    void showEye(QTreeWidgetItem& item, bool visible, bool shown);
    void showLock(QTreeWidgetItem& item, bool locked);
    void rename(QTreeWidgetItem* item);
    void toggle(QTreeWidgetItem* item, int column);
    int gapAt(int y) const;
    int topOf(int gap) const;
    void bring(const std::vector<ObjectId>& objects, int gap);

    struct Icons {
        std::array<QIcon, 4> object; ///< by Moves
        QIcon eye, eyeOff, lock, lockOpen;
    };

    Document& document_;
    Icons icons_; ///< in the colours of the theme
    struct Listed {
        ObjectId id = 0;
        std::vector<Row> rows; ///< of the object, then of its surfaces
    };
    std::vector<Listed> listed_; ///< what the tree shows, in its order
    QString words_;              ///< that are searched for
    bool filling_ = false;       ///< our own changes of the tree are no edits
    bool choosing_ = false;      ///< the rows show already what is being selected
    std::vector<ObjectId> held_; ///< by the mouse
    QPoint pressedAt_;
    std::optional<int> gap_; ///< between objects, from 0, where they would come
};

/// The list below a field that searches in it.
QWidget* searchable(Outliner& outliner);

} // namespace tactum
