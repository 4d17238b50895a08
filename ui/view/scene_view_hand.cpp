// How the view's mouse takes the finger, leads it and lets it go.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {

constexpr double kGrabPixels = 24;
/// Of the model's diagonal: how far a finger that waits is off its box, and nearer where that is too far.
constexpr double kBesideFar = 0.15, kBesideNear = 0.06;
constexpr double kClearRadii = 4;                ///< of the proxy, at least
constexpr double kSeenAcross = 32, kSeenUp = 64; ///< pixels off the edges of the view, where bars lie
/// Hovers: a finger so near to the place that is pressed is pressed down there, and not taken from there.
constexpr double kOverPlace = 4;
constexpr double kFarthestBack = 10; ///< hovers, that what was pressed may come back
/// The proxy's sphere touches a slanting surface earlier, but on nearly every one later than this.
constexpr double kLeastSlant = 0.3, kGapReserve = 1.1;

} // namespace

bool SceneView::Impl::isNearFinger(QPointF cursor) const {
    const TouchState* led = ledTouch();
    if (!overlayVisible || !led) return false;
    const auto seen = camera().project(led->finger);
    return seen && lengthOf(*seen - cursor) <= kGrabPixels;
}

bool SceneView::Impl::takesFinger(QPointF cursor, const std::optional<PickHit>& hit) const {
    if (!isNearFinger(cursor)) return false;
    const double over = kOverPlace * HandTool::kHoverHeight * picker.bounds().diagonal();
    return !hit || (hit->point - ledTouch()->finger).norm() > over;
}

bool SceneView::Impl::lags() const {
    return manners.lags && drag == ViewDrag::Hand && hand.grip() != Grip::None;
}

QPointF SceneView::Impl::pushInPicture() const {
    const TouchState* led = ledTouch();
    return led ? QPointF(led->force.dot(camera().right()), -led->force.dot(camera().up())) : QPointF();
}

void SceneView::Impl::takeHold(QPointF cursor, const std::optional<PickHit>& hit) {
    drag = ViewDrag::Hand;
    lagging.begin(cursor);
    if (takesFinger(cursor, hit)) return setGrip(Grip::Drag, cursor);
    const double slant = std::abs(hit->normal.dot((hit->point - camera().eye()).normalized()));
    const double gap = kGapReserve * proxyRadius / std::max(slant, kLeastSlant);
    hand.beginStroke(cursor, hit->point, gap, camera(), picker.bounds(),
                     [this](const Vec3& from, const Vec3& to) { return picker.isFree(from, to); });
    goalMoved();
    emit view.handGrabbed(true);
}

void SceneView::Impl::setGrip(Grip grip, QPointF cursor) {
    hand.beginMove(grip, cursor);
    emit view.handGrabbed(true);
}

/// A tap that is under way can be given up as well, though nobody holds it any more.
void SceneView::Impl::leaveHand(bool givenUp) {
    const bool held = hand.grip() != Grip::None;
    if (givenUp && (held || hand.gliding()))
        hand.giveUp();
    else if (held)
        hand.end();
    else
        return;
    liftHand();
    if (held) emit view.handGrabbed(false);
}

/// Off the surface where the hand is through with it.
void SceneView::Impl::liftHand() {
    if (!hand.isDone()) return;
    hand.lift(clearPlace());
    goalMoved();
}

/// What gave way has come back against a hand that had lifted off.
void SceneView::Impl::liftAgain() {
    const TouchState* led = ledTouch();
    if (!hand.isUp() || !led || led->contacts == 0) return;
    const Vec3 place = clearPlace();
    if (place == hand.goal()) return; // there is no room
    hand.lift(place);
    goalMoved();
}

/// A place near the finger where nothing pushes it: over the contact; where there is no room, or no contact,
/// where the stroke came from, which the eye saw; and without either at the proxy, which is outside of
/// everything.
Vec3 SceneView::Impl::clearPlace() const {
    Vec3 normal = Vec3::Zero();
    const TouchState* led = ledTouch();
    for (int i = 0; led && i < led->contacts; ++i)
        normal += led->contact[std::size_t(i)].normal;
    const std::optional<Vec3>& off = hand.offSurface();
    if (normal.norm() < 1e-6) return off.value_or(hand.goal());
    normal.normalize();
    // What has given way, a key on its spring, comes back to where it was pressed.
    const double hover = HandTool::kHoverHeight * picker.bounds().diagonal();
    const double back = off ? (*off - led->proxy).dot(normal) : 0;
    const Vec3 over = led->proxy + std::clamp(back, hover, kFarthestBack * hover) * normal;
    return picker.isFree(led->proxy, over) ? over : off.value_or(led->proxy);
}

/// Goes on by itself while the hand has a way to go.
void SceneView::Impl::goalMoved() {
    emit view.handGoalMoved(hand.goal(), hand.time());
    if (!hand.moves() || glideTimer.isActive()) return;
    glideClock.start();
    glideTimer.start();
}

void SceneView::Impl::glide() {
    if (!hand.advance(1e-3 * double(glideClock.restart()))) return glideTimer.stop();
    if (hand.isDone()) return liftHand();
    goalMoved();
}

bool SceneView::Impl::nudgeKey(int key, double scale) {
    if (tool != ViewTool::Touch) return false;
    Vec3 steps = Vec3::Zero();
    switch (key) {
    case Qt::Key_Left:
        steps.x() = -1;
        break;
    case Qt::Key_Right:
        steps.x() = 1;
        break;
    case Qt::Key_Down:
        steps.y() = -1;
        break;
    case Qt::Key_Up:
        steps.y() = 1;
        break;
    case Qt::Key_PageDown:
        steps.z() = -1;
        break;
    case Qt::Key_PageUp:
        steps.z() = 1;
        break;
    default:
        return false;
    }
    hand.nudge(scale * steps, camera());
    goalMoved();
    return true;
}

bool SceneView::Impl::isSeen(const Vec3& p_W) const {
    const auto at = camera().project(p_W);
    const QRectF inside =
        QRectF({0, 0}, camera().size).adjusted(kSeenAcross, kSeenUp, -kSeenAcross, -kSeenUp);
    return at && inside.contains(*at) && picker.isClear(camera().eye(), p_W);
}

// To the right of the picture, where there is room in most windows; then before the model, where it is seen
// for certain; and last over a side of its box, for a model as large as the hand's reach.
std::optional<Vec3> SceneView::placeBeside(double reach) const {
    const Bounds& box = impl_->picker.bounds();
    if (box.empty()) return std::nullopt;
    const ViewCamera& camera = impl_->camera();
    const Vec3 right = camera.right(), up = camera.up();
    const auto place = [&](const Vec3& way, double part) {
        const double off = std::max(part * box.diagonal(), kClearRadii * impl_->proxyRadius);
        return Vec3(box.centre() + (0.5 * way.cwiseAbs().dot(box.high - box.low) + off) * way);
    };
    const double slant = std::numbers::sqrt2 / 2;
    for (const Vec3& way : {right, Vec3(-right), Vec3(slant * (right + up)), Vec3(slant * (up - right)), up,
                            Vec3(-up), Vec3(-camera.forward()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX()),
                            Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitX()), Vec3(-Vec3::UnitZ())})
        for (const double part : {kBesideFar, kBesideNear, 0.0})
            if (const Vec3 at = place(way, part); (reach <= 0 || at.norm() < reach) && impl_->isSeen(at))
                return at;
    // A model that fills the view, or the hand's reach: before it, as far out as can be.
    const QPointF middle(0.5 * camera.size.width(), 0.5 * camera.size.height());
    for (const double part : {0.9, 0.7, 0.5, 0.3})
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, -1), QPointF(0, 1)}) {
            const QPointF pixel = middle + part * QPointF(way.x() * middle.x(), way.y() * middle.y());
            if (const Vec3 at = camera.pointAtDepthOf(box.centre(), pixel);
                (reach <= 0 || at.norm() < reach) && impl_->isSeen(at))
                return at;
        }
    return place(Vec3::UnitX(), kBesideFar);
}

void SceneView::endTouch() {
    impl_->leaveHand(true);
    if (impl_->drag == ViewDrag::Hand) impl_->drag = ViewDrag::None;
}

} // namespace tactum
