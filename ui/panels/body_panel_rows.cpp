// The rows of the body panel for paths, and for what others meet.
#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "core/dynamics/path_places.h"
#include "core/scene/colliders.h"
#include "ui/base/words.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/choice_box.h"

namespace tactum {
namespace {

constexpr int kCurveParts = 200; // of a path, as it is drawn

} // namespace

QWidget* BodyPanel::makeColliderRow() {
    colliderRow_ = new QWidget;
    auto* row = new QHBoxLayout(colliderRow_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(tr("Met as")));
    form_ = new ChoiceBox("collider-form", tr("As what others meet it"), {});
    for (const ColliderFormName& each : kColliderForms) {
        form_->addItem(wordsOf(each.label));
        form_->setItemData(form_->count() - 1, wordsOf(each.sentence), Qt::ToolTipRole);
    }
    form_->setPlaceholderText(tr("None of these, or several"));
    form_->setToolTip(tr("As what other bodies meet it; View > What bodies meet draws it."));
    connect(form_, &QComboBox::activated, this, [this](int which) {
        const SceneObject* chosen = object();
        if (!chosen) return;
        document_.editBodies(tr("What bodies meet of %1").arg(heading_->text()),
                             [which, id = chosen->id](Scene& scene) {
                                 setColliderForm(scene, id, kColliderForms[std::size_t(which)].form);
                             });
        refresh();
    });
    row->addWidget(form_, 1);
    return colliderRow_;
}

/// Nothing is chosen of what is of another form.
void BodyPanel::refreshForm(const SceneObject* chosen) {
    const bool meets = chosen && !chosen->motion && !document_.scene().mechanics.bodies.empty();
    colliderRow_->setVisible(meets);
    if (!meets || !isVisible()) return;
    const auto form = colliderFormOf(document_.scene(), chosen->id);
    const auto row =
        std::ranges::find_if(kColliderForms, [&](const auto& each) { return each.form == form; });
    form_->setCurrentIndex(row == kColliderForms.end() ? -1 : int(row - kColliderForms.begin()));
}

QWidget* BodyPanel::makePathRow() {
    pathRow_ = new QWidget;
    auto* row = new QHBoxLayout(pathRow_);
    row->setContentsMargins(0, 0, 0, 0);
    closed_ = new QCheckBox(tr("Closed"));
    closed_->setObjectName(QStringLiteral("path-closed"));
    closed_->setToolTip(tr("The last point leads to the first again; else its ends are stops"));
    connect(closed_, &QCheckBox::clicked, this, [this](bool closed) {
        editJoint(tr("Path"), 0,
                  [closed](AxisJoint& joint) { joint.path.closed = closed, joint.path.ups.clear(); });
    });
    pick_ = new QToolButton;
    pick_->setText(tr("Pick points"));
    pick_->setObjectName(QStringLiteral("path-pick"));
    pick_->setCheckable(true);
    pick_->setProperty("choice", true);
    pick_->setToolTip(
        tr("A new path through the places of the model that are clicked, until this is clicked again"));
    connect(pick_, &QToolButton::toggled, this, [this] { picked_.clear(); });
    auto* fewer = new QToolButton;
    fewer->setText(QStringLiteral("\u2212"));
    fewer->setObjectName(QStringLiteral("path-fewer"));
    fewer->setToolTip(tr("Take the last point of the path away"));
    fewer->setAccessibleName(fewer->toolTip());
    connect(fewer, &QToolButton::clicked, this, [this] {
        auto now = path();
        if (!now || now->points.size() < 3) return;
        now->points.pop_back();
        setPath(now->points, 0);
    });
    row->addWidget(closed_);
    row->addStretch();
    row->addWidget(pick_);
    row->addWidget(fewer);
    return pathRow_;
}

std::optional<PathMark> BodyPanel::path() const {
    const auto joint = axisJointOf(document_.scene(), body(), which_);
    if (!isVisible() || !joint || joint->kind != AxisKind::Path) return std::nullopt;
    PathMark mark{joint->path.points, joint->path.closed, {}};
    for (const Pose& place : placesAlong(joint->path, kCurveParts))
        mark.curve.push_back(place.translation);
    return mark;
}

void BodyPanel::setPath(const std::vector<Vec3>& points, Gesture gesture) {
    editJoint(tr("Path"), gesture, [&](AxisJoint& joint) {
        if (joint.path.ups.size() != points.size()) joint.path.ups.clear();
        joint.path.points = points;
    });
}

bool BodyPanel::picksPath() const {
    return pick_->isVisible() && pick_->isChecked();
}

/// From the second on there is a path.
void BodyPanel::addPathPoint(const Vec3& p_W) {
    picked_.push_back(p_W);
    const std::size_t least = closed_->isChecked() ? 3 : 2;
    if (picked_.size() >= least) setPath(picked_, 0);
}

} // namespace tactum
