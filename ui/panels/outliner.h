// The tree of groups, objects and their surfaces.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QIcon>

#include "core/scene/bodies.h"
#include "ui/document/document.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

/// Follows the document and edits it: the eye shows and hides a group, an object or a surface, the lock keeps
/// a surface from edits, F2 or a double click renames, a drag of the row of an object or a group brings it
/// (with the others that are selected) elsewhere in the list, into a group or out of one, and the selection
/// goes both ways. What is folded stays so while the document is open.
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
    QTreeWidgetItem* groupItem(const std::string& name, QList<QTreeWidgetItem*>& items);
    void foldAgain();
    void refreshGroups();
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
    std::vector<QTreeWidgetItem*> chosenWholes(const SurfaceSet& selected) const;
    void showFound();
    void selectChosen();
    void showMoves(QTreeWidgetItem& item, Moves moves);
    void showEye(QTreeWidgetItem& item, bool visible, bool shown);
    void showLock(QTreeWidgetItem& item, bool locked);
    void rename(QTreeWidgetItem* item);
    void renameGroup(const std::string& group, const QString& name);
    void toggle(QTreeWidgetItem* item, int column);
    /// Where rows that are dragged would come.
    struct Gap {
        ObjectId before = 0;                   ///< 0: behind all
        std::string group;                     ///< that they would be in; empty: none
        int y = 0;                             ///< of the view
        const QTreeWidgetItem* onto = nullptr; ///< a group's row; null: between rows
    };
    std::vector<Gap> gaps() const;
    std::optional<Gap> gapAt(QPoint at) const;
    void bring(const std::vector<ObjectId>& objects, const std::set<std::string>& groups, const Gap& gap);
    bool showFoundIn(QTreeWidgetItem& row, bool above);
    std::vector<ObjectId> objectsOf(const QTreeWidgetItem* row) const;

    struct Icons {
        std::array<QIcon, 4> object; ///< by Moves
        QIcon group, eye, eyeOff, lock, lockOpen;
    };

    Document& document_;
    Icons icons_; ///< in the colours of the theme
    struct Listed {
        ObjectId id = 0;
        std::string group;
        std::vector<Row> rows; ///< of the object, then of its surfaces
        QTreeWidgetItem* item = nullptr;
    };
    std::vector<Listed> listed_; ///< what the tree shows, in its order
    std::map<std::string, QTreeWidgetItem*> groups_;
    std::set<std::string> folded_; ///< of the groups
    std::set<ObjectId> foldedObjects_;
    std::set<ObjectId> chosenObjects_; ///< by their own rows, the last time that rows were
    std::set<std::string> chosenGroups_;
    QString words_;                    ///< that are searched for
    bool filling_ = false;             ///< our own changes of the tree are no edits
    bool choosing_ = false;            ///< the rows show already what is being selected
    std::vector<ObjectId> held_;       ///< by the mouse
    std::set<std::string> heldGroups_; ///< those that are held as a whole, by their rows
    QPoint pressedAt_;
    std::optional<Gap> gap_;
};

/// The list below a field that searches in it.
QWidget* searchable(Outliner& outliner);

} // namespace tactum
