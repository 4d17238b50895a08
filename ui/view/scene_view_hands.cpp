// Several hands in the view: those beside the one whose touch is shown in full.
#include "ui/view/scene_view_impl.h"
#include "ui/view/view_labels.h"

namespace tactum {

const TouchState* SceneView::Impl::ledTouch() const {
    if (mark.led) return touch ? &*touch : nullptr;
    for (const Beside& other : beside)
        if (other.mark.led) return &other.touch;
    return nullptr;
}

void SceneView::setHands(const HandMark& mark, const std::vector<HandBeside>& hands) {
    auto& beside = impl_->beside;
    bool moved = beside.size() != hands.size();
    if (std::exchange(impl_->mark, mark).number != mark.number) {
        impl_->overlay.setTheme(impl_->theme(), mark.number);
        if (impl_->loupe) impl_->loupe->picture.marks().setTheme(impl_->theme(), mark.number);
        moved = true;
    }
    beside.resize(hands.size());
    for (std::size_t i = 0; i < hands.size(); ++i) {
        const HandBeside& hand = hands[i];
        Impl::Beside& shown = beside[i];
        if (!shown.overlay) {
            shown.overlay = std::make_unique<TouchOverlay>(*impl_->stage.touch, *impl_->stage.ghost);
            shown.overlay->setVisible(impl_->overlayVisible);
            shown.overlay->setScale(impl_->touchScale);
        }
        if (moved) shown.overlay->setTheme(impl_->theme(), hand.mark.number);
        shown.mark = hand.mark;
        const TouchState next = touchState(hand.touch, hand.servo, hand.forceLimit, hand.armed);
        const double unseen = kUnseenPixels * impl_->finestPixel(next.proxy);
        if (!moved && shown.touch.looksLike(next, unseen)) continue;
        shown.touch = next;
        moved = true;
    }
    if (moved) changed();
}

Drop SceneView::Impl::shadows() const {
    return [this](const Ray& ray, double reach) -> std::optional<double> {
        const auto hit = picker.cast(ray, ScenePicker::Patience::Now, reach);
        return hit ? std::optional(hit->distance) : std::nullopt;
    };
}

void SceneView::Impl::placeBeside(const ViewCamera& camera) {
    for (Beside& other : beside) {
        other.overlay->setMarks(felt.options().normals, felt.options().planes);
        other.overlay->setStylus(felt.options().stylus);
        other.overlay->update(other.touch, camera, proxyRadius, shadows());
    }
}

void SceneView::Impl::drawBeside(QPainter& painter, const ViewCamera& camera) const {
    if (!overlayVisible) return;
    for (const Beside& other : beside)
        drawHandLabels(painter, other.touch, camera, theme(), {other.mark.number, other.mark.name});
}

} // namespace tactum
