#include "ui/controllers/section_controller.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/base/numbers.h"
#include "ui/base/preferences.h"
#include "ui/base/words.h"
#include "ui/document/document.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

namespace {

constexpr std::array<const char*, 3> kAcross{"section-x", "section-y", "section-z"};
constexpr double kSameAxis = 1 - 1e-9; // cosine
/// Of the scene's diagonal about its middle: farther away a plane cuts nothing.
constexpr double kFarthestPlane = 1;
constexpr Parameter kSectionPlace{"section-place", "", "m", -2, 2, 1e-3, 0, 5, ""};

/// The normal, turned such that its largest number is positive: places along it are those of the world's
/// axis.
Vec3 countedAlong(const SectionPlane& plane) {
    const Vec3 normal = plane.normal();
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0 ? Vec3(-normal) : normal;
}

} // namespace

SectionController::SectionController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), strip_(new ToolStrip), place_(new NumberBox({})),
      unit_(new QLabel) {
    fillStrip();
    bench.on("section", this, [this](bool on) { cut(on); });
    for (std::size_t i = 0; i < kAcross.size(); ++i)
        bench.on(kAcross[i], this, [this, i] { cutAcross(int(i)); });
    bench.on("section-flip", this, [this] { turnOver(); });
    connect(place_, &NumberBox::typed, this, [this](double shown) { moveTo(shown / factor_); });
    connect(place_, &NumberBox::stepped, this, [this](double shown) { moveTo(shown / factor_); });
    connect(&bench_.view, &SceneView::sectionDragged, this, [this](const SectionPlane& plane) {
        if (!beforeDrag_) beforeDrag_ = bench_.view.section();
        set(plane);
    });
    connect(&bench_.view, &SceneView::handlesLeft, this, [this](bool givenUp) {
        const auto before = std::exchange(beforeDrag_, std::nullopt);
        if (before && givenUp) set(*before);
    });
    connect(&bench_.document, &Document::changed, this, [this](const SceneChange& change) {
        if (change.what == SceneChange::What::Everything) cut(false);
    });
    connect(&Preferences::instance(), &Preferences::changed, this, [this](Preferred id) {
        if (id == Preferred::Lengths) useUnit();
    });
    useUnit();
}

void SectionController::fillStrip() {
    strip_->setObjectName(QStringLiteral("section-strip"));
    strip_->addLabel(tr("Cut across"));
    const QStringList names{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    for (std::size_t i = 0; i < kAcross.size(); ++i)
        strip_->addAction(&bench_.actions[kAcross[i]], names[int(i)]);
    place_->setObjectName(asIs(kSectionPlace.key));
    place_->setAccessibleName(tr("Place of the plane along its normal"));
    place_->setToolTip(place_->accessibleName());
    strip_->addLabel(tr("at"));
    strip_->addField(place_);
    unit_->setProperty("dimmed", true);
    strip_->addField(unit_);
    strip_->addAction(&bench_.actions["section-flip"], tr("Other side"));
    strip_->addAction(&bench_.actions["section"], tr("Whole again"));
    bench_.strips().addWidget(strip_, 0, Qt::AlignLeft);
}

void SectionController::useUnit() {
    const DisplayUnit unit = displayUnit(kSectionPlace);
    const QSignalBlocker quiet(place_);
    factor_ = unit.factor;
    place_->setUnit(unit.name);
    unit_->setText(unit.name);
    place_->setDecimals(unit.decimals);
    place_->setRange(factor_ * kSectionPlace.minimum, factor_ * kSectionPlace.maximum);
    place_->setSingleStep(factor_ * kSectionPlace.step);
    show();
}

void SectionController::cut(bool on) {
    if (!on)
        bench_.view.setSection(std::nullopt);
    else if (!bench_.view.section())
        return cutAcross(0);
    show();
}

void SectionController::cutAcross(int axis) {
    if (bench_.view.bounds().empty()) return show();
    const Quat turned = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::Unit(axis));
    // The side that the eye is on is cut away, or nothing would be seen of the inside.
    const bool behind = Vec3::Unit(axis).dot(bench_.view.camera().forward()) > 0;
    const Quat side = behind ? Quat(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX())) : Quat::Identity();
    set({{turned * side, bench_.view.bounds().centre()}});
}

void SectionController::turnOver() {
    auto plane = bench_.view.section();
    if (!plane) return;
    plane->frame.rotation = plane->frame.rotation * Quat(Eigen::AngleAxisd(EIGEN_PI, Vec3::UnitX()));
    set(*plane);
}

void SectionController::moveTo(double place) {
    auto plane = bench_.view.section();
    if (!plane) return;
    const Vec3 along = countedAlong(*plane);
    plane->frame.translation += (place - along.dot(plane->frame.translation)) * along;
    set(*plane);
}

void SectionController::set(const SectionPlane& plane) {
    SectionPlane near = plane;
    const Bounds box = bench_.view.bounds();
    const double height = near.height(box.centre()), most = kFarthestPlane * box.diagonal();
    near.frame.translation += (height - std::clamp(height, -most, most)) * near.normal();
    bench_.view.setSection(near);
    show();
}

void SectionController::show() {
    const auto& plane = bench_.view.section();
    strip_->setVisible(plane.has_value());
    bench_.actions["section"].setChecked(plane.has_value());
    bench_.actions["section-flip"].setEnabled(plane.has_value());
    for (std::size_t i = 0; i < kAcross.size(); ++i)
        bench_.actions[kAcross[i]].setChecked(plane && std::abs(plane->normal()[int(i)]) > kSameAxis);
    if (!plane) return;
    const QSignalBlocker quiet(place_);
    place_->setValue(factor_ * countedAlong(*plane).dot(plane->frame.translation));
}

} // namespace tactum
