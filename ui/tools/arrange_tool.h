// Moving, turning and scaling the selected objects: by handles in the view, or by numbers.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "core/scene/order.h"
#include "ui/document/document.h"
#include "ui/view/scene_picker.h"

namespace tactum {

class SceneView;

/// About what objects turn and scale: the middle of them all, each one's own, that of the one selected last,
/// or the origin of the world.
enum class Pivot { Middle, Each, Last, World };

/// Objects whose surfaces are selected, all but those that are locked or would take something locked along. A
/// drag is one step of the history, and none when it is given up. Thread: ui.
class ArrangeTool : public QObject {
    Q_OBJECT
public:
    ArrangeTool(Document& document, SceneView& view, QObject* parent = nullptr);

    /// Whether it is the tool that is on: the handles are shown then.
    void setActive(bool active);
    void setPivot(Pivot pivot);
    /// Handles along the axes of the object that was selected last, instead of those of the world.
    void setOwnAxes(bool own);

    std::vector<ObjectId> objects() const;
    /// The object that was selected last; null: none.
    const SceneObject* active() const;
    /// Of its own box, in its own frame.
    const Bounds& boxOf(const SceneObject& object) const;
    /// The middle of that box. World frame.
    Vec3 middleOf(const SceneObject& object) const;

    /// Arranges the objects about the pivot, wherever `by` is about.
    void place(const Arrangement& by, Gesture gesture);
    /// Lets each fall onto what is beneath it, or on the ground; together what goes along together.
    void dropToGround();
    /// The other objects come into line with the one selected last, by a side of their boxes.
    void alignWithActive(int axis, BoxSide side);
    /// Three or more get even distances between their middles.
    void distributeEvenly(int axis);
    /// A click of the tool: takes the whole object, with Shift also.
    void choose(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    /// Why nothing can be arranged; empty when it can.
    QString whyNot() const;

signals:
    /// Why nothing was arranged, in one line.
    void refused(const QString& sentence);
    /// What moves by forces is among what is arranged: where it begins is what changes.
    void begun();

private:
    struct Group {
        GoingAlong along;
        Vec3 about = Vec3::Zero();
    };

    void begin();
    void drag(const Arrangement& by);
    void end();
    void apply(const Arrangement& by, Gesture gesture);
    void put(const QString& text, Scene next, Gesture gesture);
    void putInLine(const QString& text, const std::vector<Group>& moved, Scene next);
    void refresh();
    bool isFree(const GoingAlong& along) const;
    std::vector<Group> groups(bool each) const;
    static std::vector<GoingAlong> partsOf(const std::vector<Group>& groups);
    Vec3 pivotOf(const std::vector<ObjectId>& objects) const;
    Arrangement bounded(Arrangement by) const;
    QString textOf(const Arrangement& by) const;

    Document& document_;
    SceneView& view_;
    bool active_ = false, own_ = false, applying_ = false;
    Pivot pivot_ = Pivot::Middle;
    struct KnownBox {
        std::weak_ptr<const TriangleSoup>
            of; ///< several of one file may have one owner: they differ by address
        Bounds box;
    };
    mutable std::map<const TriangleSoup*, KnownBox> boxes_;
    // Of the drag that is under way.
    std::optional<Scene> before_;
    std::vector<Group> held_;
    Pose frame_;
    Gesture gesture_ = 0;
};

} // namespace tactum
