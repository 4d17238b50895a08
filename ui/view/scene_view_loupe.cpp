// When the view draws the contact from nearby, and when it does not any more.
#include "ui/view/pane_mark.h"
#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {
constexpr int kStays = 1000;     // ms after the last contact
constexpr int kStillEvery = 250; // ms: where nothing moves, what lay over its place may have gone
} // namespace

SceneView::Impl::Loupe::Loupe(GlWindow& window, ViewStage& stage) : picture(window, stage) {
    due.setSingleShot(true);
    due.setTimerType(Qt::PreciseTimer);
}

void SceneView::setLoupe(const LoupeLook& look) {
    impl_->loupeLook = look;
    impl_->askForLoupe();
}

void SceneView::Impl::showLoupe(bool on) {
    if (on == (loupe != nullptr)) return;
    if (on) {
        loupe = std::make_unique<Loupe>(view.renderWindow(), stage);
        loupe->picture.marks().setTheme(theme(), mark.number);
        QObject::connect(&loupe->due, &QTimer::timeout, &view, [this] { drawLoupe(); });
        return;
    }
    view.makeCurrent();
    loupe.reset();
    view.doneCurrent();
    emit view.loupeLeft();
}

void SceneView::Impl::askForLoupe() {
    if (loupe && loupe->open && !loupe->due.isActive()) loupe->due.start(loupe->pause);
}

void SceneView::Impl::watchLoupe() {
    if (!loupe) return;
    if (showsTouch() && touch->contacts > 0) {
        loupe->lastTouched.start();
        const bool still = loupe->drawn.isValid() && loupe->drawn.elapsed() > kStillEvery;
        if (!std::exchange(loupe->open, true) || still) askForLoupe();
    } else if (loupe->open && (!showsTouch() || loupe->lastTouched.elapsed() >= kStays)) {
        loupe->open = false;
        loupe->due.stop();
        emit view.loupeLeft();
    }
}

// A picture of the exact model is no measure for those in motion, which are of the coarse one.
void SceneView::Impl::drawLoupe() {
    loupe->drawn.start();
    const QSizeF size(loupeLook.side, loupeLook.side);
    if (!view.context() || !showsTouch() || view.width() < size.width() || view.height() < size.height())
        return;
    const bool quick = view.quality() == PictureQuality::Quick;
    const ViewPane& from = panes[panes.used()]; // wherever the pointer is meanwhile
    const ViewCamera close = closeUp(from.camera, touch->proxy, loupeLook.times, size);
    TouchOverlay& touching = loupe->picture.marks();
    touching.setVisible(true);
    touching.setScale(touchScale);
    touching.setMarks(felt.options().normals, felt.options().planes);
    touching.setStylus(felt.options().stylus);
    touching.update(*touch, close, proxyRadius, shadows());
    view.makeCurrent();
    const auto before = std::chrono::steady_clock::now();
    const QImage picture = loupe->picture.draw(close, shownTo(from.camera), view.devicePixelRatioF(),
                                               quick ? coarseInMotion() : Coarse::None);
    if (quick) loupe->pause = loupePause(std::chrono::steady_clock::now() - before);
    view.doneCurrent();
    const QPointF contact = from.camera.project(touch->proxy).value_or(QPointF());
    emit view.loupeDrawn(picture, contact + from.place.topLeft(),
                         panes.isDivided() ? paneName(panes.used(), from.camera) : QString());
}

} // namespace tactum
