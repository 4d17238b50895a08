#include "ui/panels/place_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QLabel>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/panels/parameter_field.h"
#include "ui/tools/arrange_tool.h"
#include "ui/widgets/columns.h"

namespace tactum {
namespace {

constexpr double kFarthest = 2; // m
constexpr double kHalfTurn = std::numbers::pi;
constexpr const char* kMiddle = QT_TR_NOOP("Where the middle of its box is, in the world.");
constexpr const char* kTurned = QT_TR_NOOP("Turned about x, then y, then z of the world.");

constexpr std::array<Parameter, 3> kWhere{{
    {"place-x", QT_TR_NOOP("Place x"), "m", -kFarthest, kFarthest, 1e-3, 0, 6, kMiddle},
    {"place-y", QT_TR_NOOP("Place y"), "m", -kFarthest, kFarthest, 1e-3, 0, 6, kMiddle},
    {"place-z", QT_TR_NOOP("Place z"), "m", -kFarthest, kFarthest, 1e-3, 0, 6, kMiddle},
}};
constexpr std::array<Parameter, 3> kAngles{{
    {"turn-x", QT_TR_NOOP("Turned about x"), "rad", -kHalfTurn, kHalfTurn, kHalfTurn / 180, 0, 4, kTurned},
    {"turn-y", QT_TR_NOOP("Turned about y"), "rad", -kHalfTurn, kHalfTurn, kHalfTurn / 180, 0, 4, kTurned},
    {"turn-z", QT_TR_NOOP("Turned about z"), "rad", -kHalfTurn, kHalfTurn, kHalfTurn / 180, 0, 4, kTurned},
}};
constexpr Parameter kLongestSide{"longest-side",
                                 QT_TR_NOOP("Longest side"),
                                 "m",
                                 1e-4,
                                 kFarthest,
                                 1e-3,
                                 0.1,
                                 6,
                                 QT_TR_NOOP("Of its own box; the other sides keep the proportion.")};
constexpr Parameter kScale{
    "scale",
    QT_TR_NOOP("Scale"),
    "",
    0.01,
    100,
    0.1,
    1,
    4,
    QT_TR_NOOP("How much larger than when it was selected; textures and masses stay.")};

constexpr double kSameTurn = 1e-9; // of the numbers of a quaternion

} // namespace

Vec3 anglesOf(const Quat& rotation) {
    const Mat3 r = rotation.normalized().toRotationMatrix();
    const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
    if (std::abs(r(2, 0)) > 1 - 1e-12) return {0, y, std::atan2(-r(0, 1), r(1, 1))};
    return {std::atan2(r(2, 1), r(2, 2)), y, std::atan2(r(1, 0), r(0, 0))};
}

Quat rotationOf(const Vec3& angles) {
    return Quat(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

PlacePanel::PlacePanel(Document& document, ArrangeTool& tool, QWidget* parent)
    : QWidget(parent), document_(document), tool_(tool) {
    auto* page = new QWidget;
    auto* sections = columnIn(page, kRhythm);
    sections->setContentsMargins(12, kRhythm / 2, 12, kRhythm);
    heading_ = new QLabel;
    heading_->setProperty("heading", true);
    hint_ = dimmedLine(tr("Select an object to move, turn and scale it: here, or with the tool Move (M)."));
    extent_ = dimmedLine({});
    extent_->setObjectName(QStringLiteral("extent"));
    rows_ = new QWidget;
    auto* rows = columnIn(rows_, kRhythm);
    for (int i = 0; i < 3; ++i)
        places_[std::size_t(i)] = add(rows_, kWhere[std::size_t(i)],
                                      [this, i](double value, Gesture gesture) { move(i, value, gesture); });
    for (int i = 0; i < 3; ++i)
        angles_[std::size_t(i)] = add(rows_, kAngles[std::size_t(i)],
                                      [this, i](double value, Gesture gesture) { turn(i, value, gesture); });
    size_ =
        add(rows_, kLongestSide, [this](double value, Gesture gesture) { resize(value / size(), gesture); });
    scale_ = add(rows_, kScale,
                 [this](double value, Gesture gesture) { resize(value * sizeWhenShown_ / size(), gesture); });
    rows->addWidget(extent_);
    for (QWidget* each : std::initializer_list<QWidget*>{heading_, hint_, rows_})
        sections->addWidget(each);
    sections->addStretch();
    columnIn(this, 0)->addWidget(scrolled(page));
    connect(&document_, &Document::changed, this, &PlacePanel::refresh);
    refresh();
}

ParameterField* PlacePanel::add(QWidget* rows, const Parameter& parameter,
                                const std::function<void(double, Gesture)>& edited) {
    auto* field = new ParameterField(parameter);
    field->setCompact(9 * kRhythm); // a metre in micrometres
    connect(field, &ParameterField::edited, this, [this, edited, &parameter](double value, Gesture gesture) {
        if (tool_.active()) edited(parameter.clamped(value), gesture);
        refresh(); // what was typed may have been brought into range
    });
    rows->layout()->addWidget(field);
    return field;
}

void PlacePanel::move(int axis, double value, Gesture gesture) {
    Arrangement by;
    by.move[axis] = value - tool_.middleOf(*tool_.active())[axis];
    tool_.place(by, gesture);
}

void PlacePanel::turn(int axis, double angle, Gesture gesture) {
    Vec3 wanted = angles();
    wanted[axis] = angle;
    Arrangement by;
    by.turn = unitLength(rotationOf(wanted) * tool_.active()->pose.rotation.conjugate());
    typed_ = wanted; // refresh() forgets them where they are not what came of it
    tool_.place(by, gesture);
}

void PlacePanel::resize(double factor, Gesture gesture) {
    Arrangement by;
    by.scale = factor;
    tool_.place(by, gesture);
}

double PlacePanel::size() const {
    const Bounds& box = tool_.boxOf(*tool_.active());
    return box.empty() ? kLongestSide.minimum
                       : std::max(kLongestSide.minimum, (box.high - box.low).maxCoeff());
}

/// As they were typed, where several would do.
Vec3 PlacePanel::angles() const {
    const Quat& now = tool_.active()->pose.rotation;
    if (typed_ && 1 - std::abs(rotationOf(*typed_).dot(now)) < kSameTurn) return *typed_;
    return anglesOf(now);
}

void PlacePanel::refresh() {
    const SceneObject* object = tool_.active();
    const auto count = document_.selectedObjects().size();
    const QString name = object ? QString::fromStdString(object->name) : QString();
    heading_->setText(!object     ? tr("No object selected")
                      : count > 1 ? tr("%1 objects, the figures of %2").arg(count).arg(name)
                                  : name);
    hint_->setVisible(!object);
    rows_->setVisible(object);
    const ObjectId before = std::exchange(shown_, object ? object->id : 0);
    if (!object) return;
    if (shown_ != before) {
        typed_.reset();
        sizeWhenShown_ = size();
    }
    const Vec3 middle = tool_.middleOf(*object), turned = angles();
    for (int i = 0; i < 3; ++i) {
        places_[std::size_t(i)]->setValue(middle[i]);
        angles_[std::size_t(i)]->setValue(turned[i]);
    }
    size_->setValue(size());
    scale_->setValue(size() / sizeWhenShown_);
    const Bounds& box = tool_.boxOf(*object);
    const Vec3 sides = box.empty() ? Vec3(Vec3::Zero()) : Vec3(box.high - box.low);
    extent_->setText(tr("%1 \u00d7 %2 \u00d7 %3")
                         .arg(lengthText(sides.x()), lengthText(sides.y()), lengthText(sides.z())));
}

} // namespace tactum
