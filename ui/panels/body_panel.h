// How the selected object moves: its mass, and the hinge or slider that holds it.
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/scene/bodies.h"
#include "ui/document/document.h"
#include "ui/view/joint_gizmo.h"
#include "ui/view/mass_mark.h"
#include "ui/view/path_gizmo.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace tactum {

class ParameterField;
class WorldFields;

/// Generated from kBodyFields and kAxisFields; every edit goes through the document and can be undone.
class BodyPanel : public QWidget {
    Q_OBJECT
public:
    /// How an object is held; the buttons have these numbers.
    enum class Hold { Still, Loose, Hinge, Slider, Path };

    explicit BodyPanel(Document& document, QWidget* parent = nullptr);

    /// Of the selected object.
    void hold(Hold hold);
    BodyId body() const;

    /// The joint that is shown, for the view; nothing while nobody sees the panel.
    std::optional<JointMark> mark() const;
    /// The mass of the selected body, likewise.
    std::optional<MassMark> mass() const;
    /// The path that is shown, likewise; for setPath() as the view was dragged.
    std::optional<PathMark> path() const;
    void setPath(const std::vector<Vec3>& points, Gesture gesture);
    /// Whether a click on the model is the next point of the path.
    bool picksPath() const;
    void addPathPoint(const Vec3& p_W);
    /// As the view was dragged.
    void setMark(const JointMark& mark, Gesture gesture);

signals:
    /// mark() and mass() may be others.
    void marked();
    /// What stood still may move from now on: the object of that name.
    void freed(const QString& name);
    /// Why nothing was done, in one line.
    void failed(const QString& sentence);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct AxisRow {
        const AxisField* field;
        AxisKind kind;
        ParameterField* row;
    };

    QWidget* makeHoldRow();
    QWidget* makeBodyRows();
    QWidget* makeColliderRow();
    QWidget* makeJointRows();
    QWidget* makeWhichRow();
    QWidget* makeAxisRow();
    QWidget* makePathRow();
    void addJoint();
    void addAxisFields(AxisKind kind, QWidget* rows);
    void editJoint(const QString& what, Gesture gesture, const std::function<void(AxisJoint&)>& change);
    void refuse(const QString& sentence);
    void refresh();
    void refreshForm(const SceneObject* chosen);
    void refreshJoint(const AxisJoint& joint);
    void refreshOthers(BodyId own, BodyId to);
    const SceneObject* object() const;

    Document& document_;
    QLabel *heading_, *hint_, *others_;
    WorldFields* world_;
    QWidget *holdRow_, *bodyRows_, *colliderRow_, *jointRows_;
    QButtonGroup *hold_, *axis_;
    QComboBox *to_, *joints_, *form_;
    std::vector<ParameterField*> bodyFields_; ///< in the order of kBodyFields
    std::vector<ParameterField*> places_;     ///< x, y, z of the joint
    std::vector<AxisRow> axisRows_;
    std::vector<BodyId> choices_; ///< of `to_`
    ObjectId shown_ = 0;
    std::size_t which_ = 0;        ///< of the joints that hold it
    QWidget *lineRows_, *pathRow_; ///< of an axis, of a path
    QCheckBox* closed_;
    QToolButton* pick_;
    std::vector<Vec3> picked_; ///< points of the path that is being picked
};

} // namespace tactum
