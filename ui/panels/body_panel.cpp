#include "ui/panels/body_panel.h"

#include <algorithm>
#include <array>

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "core/dynamics/path_places.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/parameter_field.h"
#include "ui/panels/world_fields.h"
#include "ui/widgets/columns.h"

namespace tactum {
namespace {

constexpr std::array<Parameter, 3> kPlace{{
    {"joint-x", QT_TR_NOOP("At x"), "m", -1, 1, 1e-3, 0, 4,
     QT_TR_NOOP("A place on the axis of the joint, in the world.")},
    {"joint-y", QT_TR_NOOP("At y"), "m", -1, 1, 1e-3, 0, 4,
     QT_TR_NOOP("A place on the axis of the joint, in the world.")},
    {"joint-z", QT_TR_NOOP("At z"), "m", -1, 1, 1e-3, 0, 4,
     QT_TR_NOOP("A place on the axis of the joint, in the world.")},
}};

constexpr double kSamePlace = 1e-9; // m

/// Buttons of which one is down, each with its number.
struct NamedButton {
    QString text, meaning;
    const char* name;
};
QWidget* buttonRow(QButtonGroup& group, std::initializer_list<NamedButton> buttons) {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kRhythm / 2);
    for (const NamedButton& each : buttons) {
        auto* button = new QToolButton;
        button->setText(each.text);
        button->setToolTip(each.meaning);
        button->setAccessibleName(each.meaning);
        button->setObjectName(QLatin1String(each.name));
        button->setCheckable(true);
        button->setProperty("choice", true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        group.addButton(button, int(group.buttons().size()));
        row->addWidget(button, 1);
    }
    return widget;
}

BodyPanel::Hold holdOf(const Scene& scene, BodyId body, std::size_t which) {
    if (body == kWorldBody) return BodyPanel::Hold::Still;
    const auto joint = axisJointOf(scene, body, which);
    if (!joint) return BodyPanel::Hold::Loose;
    return joint->kind == AxisKind::Hinge    ? BodyPanel::Hold::Hinge
           : joint->kind == AxisKind::Slider ? BodyPanel::Hold::Slider
                                             : BodyPanel::Hold::Path;
}

/// Down is the one along which the axis lies; none for any other direction.
int axisAlong(const Vec3& axis) {
    int along = 0;
    return axis.cwiseAbs().maxCoeff(&along) > 1 - 1e-9 ? along : -1;
}

} // namespace

BodyPanel::BodyPanel(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
    auto* page = new QWidget;
    auto* sections = columnIn(page, kRhythm);
    sections->setContentsMargins(12, kRhythm / 2, 12, kRhythm);
    heading_ = new QLabel;
    heading_->setProperty("heading", true);
    hint_ = dimmedLine(tr("Select an object to give it a mass, a hinge or a slider."));
    others_ = dimmedLine({});
    others_->setObjectName(QStringLiteral("other-joints"));
    world_ = new WorldFields(document_);
    for (QWidget* each : std::initializer_list<QWidget*>{heading_, hint_, makeHoldRow(), makeBodyRows(),
                                                         makeColliderRow(), others_, makeJointRows(), world_})
        sections->addWidget(each);
    sections->addStretch();
    columnIn(this, 0)->addWidget(scrolled(page));
    connect(&document_, &Document::changed, this, &BodyPanel::refresh);
    refresh();
}

QWidget* BodyPanel::makeHoldRow() {
    hold_ = new QButtonGroup(this);
    holdRow_ = buttonRow(*hold_, {{tr("Still"), tr("It stands still."), "hold-still"},
                                  {tr("Loose"), tr("It falls, lies, and is pushed."), "hold-loose"},
                                  {tr("Hinge"), tr("It turns about one axis."), "hold-hinge"},
                                  {tr("Slider"), tr("It slides along one axis."), "hold-slider"},
                                  {tr("Path"), tr("It rides on a curve."), "hold-path"}});
    for (QAbstractButton* each : hold_->buttons()) { // five of them in the narrowest dock
        each->setProperty("tight", true);
        each->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    connect(hold_, &QButtonGroup::idClicked, this, [this](int id) { hold(Hold(id)); });
    return holdRow_;
}

QWidget* BodyPanel::makeBodyRows() {
    bodyRows_ = new QWidget;
    auto* rows = columnIn(bodyRows_, kRhythm);
    for (const BodyField& field : kBodyFields) {
        auto* row = new ParameterField(*field.parameter);
        connect(row, &ParameterField::edited, this, [this, &field](double value, Gesture gesture) {
            const QString text = tr("%1 of %2").arg(wordsOf(field.parameter->label), heading_->text());
            document_.editBodies(
                text,
                [&, id = body(), safe = field.parameter->clamped(value)](Scene& scene) {
                    RigidBody* each = findBody(scene, id);
                    if (!each) return;
                    if (field.parameter == &kBodyMass)
                        setMass(*each, safe);
                    else
                        each->*field.value = safe;
                },
                gesture);
            refresh();
        });
        bodyFields_.push_back(row);
        rows->addWidget(row);
    }
    return bodyRows_;
}

QWidget* BodyPanel::makeAxisRow() {
    axis_ = new QButtonGroup(this);
    auto* row = buttonRow(*axis_, {{tr("X"), tr("Along x of the world"), "axis-x"},
                                   {tr("Y"), tr("Along y of the world"), "axis-y"},
                                   {tr("Z"), tr("Along z of the world"), "axis-z"}});
    connect(axis_, &QButtonGroup::idClicked, this, [this](int id) {
        editJoint(tr("Axis"), 0, [id](AxisJoint& joint) { joint.axis = Vec3::Unit(id); });
    });
    auto* guess = new QToolButton;
    guess->setText(tr("Guess"));
    guess->setObjectName(QStringLiteral("axis-guess"));
    guess->setToolTip(
        tr("Axis and place as the form of the object suggests them; again: the next likely ones"));
    connect(guess, &QToolButton::clicked, this, [this] {
        editJoint(tr("Axis"), 0, [this](AxisJoint& joint) {
            // The likeliest; from that one the next.
            const auto guesses = guessedJoints(document_.scene(), body(), joint.kind);
            const auto now = std::ranges::find_if(guesses, [&](const AxisJoint& each) {
                return each.axis.isApprox(joint.axis) && (each.at - joint.at).norm() < kSamePlace;
            });
            const AxisJoint& next = now == guesses.end() || now + 1 == guesses.end() ? guesses[0] : now[1];
            joint.axis = next.axis, joint.at = next.at;
        });
    });
    row->layout()->addWidget(guess);
    return row;
}

QWidget* BodyPanel::makeJointRows() {
    jointRows_ = new QWidget;
    auto* rows = columnIn(jointRows_, kRhythm);
    rows->addWidget(makeWhichRow());
    auto* fixed = new QHBoxLayout;
    fixed->addWidget(new QLabel(tr("Fixed to")));
    to_ = new ChoiceBox("joint-to", tr("Fixed to"), {});
    connect(to_, &QComboBox::activated, this, [this](int row) {
        editJoint(tr("What it is fixed to"), 0,
                  [to = choices_[std::size_t(row)]](AxisJoint& joint) { joint.to = to; });
    });
    fixed->addWidget(to_, 1);
    rows->addLayout(fixed);
    rows->addWidget(makePathRow());
    lineRows_ = new QWidget;
    rows->addWidget(lineRows_);
    auto* line = columnIn(lineRows_, kRhythm);
    line->addWidget(new QLabel(tr("Axis")));
    line->addWidget(makeAxisRow());
    for (int i = 0; i < 3; ++i) {
        auto* row = new ParameterField(kPlace[std::size_t(i)]);
        row->setCompact();
        connect(row, &ParameterField::edited, this, [this, i](double value, Gesture gesture) {
            editJoint(tr("Place"), gesture,
                      [&](AxisJoint& joint) { joint.at[i] = kPlace[std::size_t(i)].clamped(value); });
        });
        places_.push_back(row);
        line->addWidget(row);
    }
    addAxisFields(AxisKind::Hinge, jointRows_);
    addAxisFields(AxisKind::Slider, jointRows_);
    return jointRows_;
}

/// A body has one joint at first; others close loops.
QWidget* BodyPanel::makeWhichRow() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    joints_ = new ChoiceBox("joint-which", tr("Which of its joints"), {});
    connect(joints_, &QComboBox::activated, this, [this](int index) {
        which_ = std::size_t(index);
        refresh();
    });
    row->addWidget(new QLabel(tr("Joint")));
    row->addWidget(joints_, 1);
    const auto button = [&](const QString& text, const char* name, const QString& meaning, auto does) {
        auto* made = new QToolButton;
        made->setText(text);
        made->setObjectName(QLatin1String(name));
        made->setToolTip(meaning);
        made->setAccessibleName(meaning);
        connect(made, &QToolButton::clicked, this, does);
        row->addWidget(made);
    };
    button(tr("+"), "joint-add", tr("One more joint, as those that close a loop"), [this] { addJoint(); });
    button(QStringLiteral("\u2212"), "joint-remove", tr("Take this joint away"), [this] {
        document_.editBodies(tr("A joint of %1 away").arg(heading_->text()),
                             [&, id = body()](Scene& scene) { removeJoint(scene, id, which_); });
    });
    return widget;
}

void BodyPanel::addJoint() {
    const std::size_t count = jointsOf(document_.scene(), body());
    document_.editBodies(tr("One more joint of %1").arg(heading_->text()), [&, id = body()](Scene& scene) {
        setAxisJoint(scene, id, guessedJoint(scene, id, AxisKind::Hinge), count);
    });
    which_ = count;
    refresh();
}

void BodyPanel::addAxisFields(AxisKind kind, QWidget* rows) {
    for (const AxisField& field : kAxisFields) {
        const Parameter& parameter = field.of(kind);
        auto* row = new ParameterField(parameter);
        connect(row, &ParameterField::edited, this,
                [this, &field, &parameter](double value, Gesture gesture) {
                    editJoint(wordsOf(parameter.label), gesture,
                              [&](AxisJoint& joint) { setFigure(joint, field, value); });
                });
        axisRows_.push_back({&field, kind, row});
        rows->layout()->addWidget(row);
    }
}

const SceneObject* BodyPanel::object() const {
    const auto selection = document_.selection();
    return selection ? document_.scene().find(selection->object) : nullptr;
}

BodyId BodyPanel::body() const {
    const SceneObject* found = object();
    return found ? found->body : kWorldBody;
}

void BodyPanel::hold(Hold hold) {
    const SceneObject* chosen = object();
    if (!chosen) return refuse(tr("Nothing is selected; select the object first (Q)."));
    if (chosen->motion)
        return refuse(tr("%1 moves by its keys; it cannot be pushed.").arg(asIs(chosen->name)));
    const QString texts[] = {tr("%1 stands still"), tr("%1 is loose"), tr("%1 on a hinge"),
                             tr("%1 on a slider"), tr("%1 on a path")};
    const bool still = chosen->body == kWorldBody;
    const QString name = asIs(chosen->name);
    if (holdOf(document_.scene(), chosen->body, which_) != hold)
        document_.editBodies(texts[int(hold)].arg(name),
                             [hold, which = which_, id = chosen->id](Scene& scene) {
                                 BodyId held = scene.find(id)->body;
                                 if (hold == Hold::Still) return makeStill(scene, held);
                                 if (held == kWorldBody) held = makeBody(scene, id);
                                 if (hold == Hold::Loose) return setLoose(scene, held);
                                 const AxisKind kind = hold == Hold::Hinge    ? AxisKind::Hinge
                                                       : hold == Hold::Slider ? AxisKind::Slider
                                                                              : AxisKind::Path;
                                 setAxisJoint(scene, held, guessedJoint(scene, held, kind), which);
                             });
    refresh();
    if (still && body() != kWorldBody) emit freed(name);
}

void BodyPanel::editJoint(const QString& what, Gesture gesture,
                          const std::function<void(AxisJoint&)>& change) {
    auto joint = axisJointOf(document_.scene(), body(), which_);
    if (!joint) return;
    change(*joint);
    if (joint->kind == AxisKind::Path && placesAlong(joint->path, 1).empty())
        return refuse(tr("No smooth curve goes through these points; move them farther apart."));
    document_.editBodies(
        tr("%1 of %2").arg(what, heading_->text()),
        [&, id = body()](Scene& scene) { setAxisJoint(scene, id, *joint, which_); }, gesture);
    refresh(); // what was typed may have been brought into range
}

void BodyPanel::refuse(const QString& sentence) {
    refresh(); // what was typed or clicked is not so
    emit failed(sentence);
}

std::optional<JointMark> BodyPanel::mark() const {
    const SceneObject* chosen = object();
    const auto joint = axisJointOf(document_.scene(), body(), which_);
    if (!isVisible() || !chosen || !joint || joint->kind == AxisKind::Path) return std::nullopt;
    const Vec3 middle = chosen->pose.apply(tactum::boundsOf(*chosen->geometry).centre());
    return JointMark{joint->kind == AxisKind::Hinge,
                     joint->at,
                     joint->axis,
                     middle,
                     joint->low,
                     joint->high,
                     joint->low > -kUnbounded,
                     joint->high < kUnbounded};
}

std::optional<MassMark> BodyPanel::mass() const {
    const RigidBody* found = findBody(document_.scene(), body());
    if (!isVisible() || !found) return std::nullopt;
    return massMark(found->pose * Pose{found->inertiaFrame, found->centre}, found->mass, found->inertia);
}

void BodyPanel::setMark(const JointMark& mark, Gesture gesture) {
    editJoint(tr("Joint"), gesture, [&](AxisJoint& joint) {
        joint.at = mark.at, joint.axis = mark.axis;
        joint.low = mark.hasLow ? mark.low : -kUnbounded;
        joint.high = mark.hasHigh ? mark.high : kUnbounded;
    });
}

void BodyPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refreshForm(object());
    emit marked();
}

void BodyPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit marked();
}

void BodyPanel::refresh() {
    const SceneObject* chosen = object();
    heading_->setText(chosen ? asIs(chosen->name) : tr("No object selected"));
    hint_->setVisible(!chosen);
    world_->setVisible(!chosen && !document_.scene().mechanics.bodies.empty());
    holdRow_->setVisible(chosen);
    const RigidBody* found = findBody(document_.scene(), body());
    const std::size_t joints = found ? jointsOf(document_.scene(), found->id) : 0;
    if (chosen ? chosen->id != shown_ : shown_ != 0) which_ = 0;
    shown_ = chosen ? chosen->id : 0;
    which_ = std::min(which_, joints > 0 ? joints - 1 : 0);
    const auto joint = found ? axisJointOf(document_.scene(), found->id, which_) : std::nullopt;
    if (chosen) hold_->button(int(holdOf(document_.scene(), chosen->body, which_)))->setChecked(true);
    bodyRows_->setVisible(found);
    refreshForm(chosen);
    jointRows_->setVisible(joint.has_value());
    others_->setVisible(found && !joint && joints > 0);
    others_->setText(
        tr("Held by %n joint(s) of another kind, which stay as they are in the file.", nullptr, int(joints)));
    for (std::size_t i = 0; found && i < bodyFields_.size(); ++i)
        bodyFields_[i]->setValue(found->*kBodyFields[i].value);
    if (joint) refreshJoint(*joint);
    emit marked();
}

void BodyPanel::refreshJoint(const AxisJoint& joint) {
    refreshOthers(body(), joint.to);
    const QSignalBlocker quiet(joints_);
    joints_->clear();
    for (std::size_t i = 0; i < jointsOf(document_.scene(), body()); ++i) {
        const auto each = axisJointOf(document_.scene(), body(), i);
        const QString kind = !each                            ? tr("other")
                             : each->kind == AxisKind::Hinge  ? tr("hinge")
                             : each->kind == AxisKind::Slider ? tr("slider")
                                                              : tr("path");
        joints_->addItem(QStringLiteral("%1: %2").arg(i + 1).arg(kind));
    }
    joints_->setCurrentIndex(int(which_));
    const bool rides = joint.kind == AxisKind::Path;
    lineRows_->setVisible(!rides);
    pathRow_->setVisible(rides);
    closed_->setChecked(rides && joint.path.closed);
    if (!rides) pick_->setChecked(false);
    const int along = axisAlong(joint.axis);
    axis_->setExclusive(along >= 0);
    for (QAbstractButton* button : axis_->buttons())
        button->setChecked(axis_->id(button) == along);
    for (int i = 0; i < 3; ++i)
        places_[std::size_t(i)]->setValue(joint.at[i]);
    for (const AxisRow& each : axisRows_) {
        const Parameter& parameter = each.field->of(each.kind);
        each.row->setVisible((each.kind == AxisKind::Hinge) == (joint.kind == AxisKind::Hinge));
        each.row->setValue(std::clamp(joint.*each.field->value, parameter.minimum, parameter.maximum));
    }
}

/// The world, and the other bodies by their names.
void BodyPanel::refreshOthers(BodyId own, BodyId to) {
    const QSignalBlocker quiet(to_);
    to_->clear();
    choices_ = {kWorldBody};
    to_->addItem(tr("what stands still"));
    for (const RigidBody& each : document_.scene().mechanics.bodies) {
        if (each.id == own) continue;
        choices_.push_back(each.id);
        to_->addItem(asIs(each.name));
    }
    to_->setCurrentIndex(int(std::ranges::find(choices_, to) - choices_.begin()));
}

} // namespace tactum
