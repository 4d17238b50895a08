#include "ui/showing/played_touch.h"

#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace tactum {

namespace {
constexpr double kSlice = 0.016; // s
}

/// In slices as long as a frame: plot and trail take the contacts of one haptic step for each of them.
std::vector<TracePoint> showPlayed(Player& player, std::size_t hand, ForcePlot& plot, SceneView& view,
                                   const QString& touched) {
    std::vector<TracePoint> ticks = player.takeTrace(hand);
    const std::vector<ReplayedStep> steps = player.takeSteps(hand);
    std::vector<TracePoint> slice;
    std::size_t passed = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        slice.push_back(ticks[i]);
        if (i + 1 < ticks.size() && ticks[i].t - slice.front().t < kSlice) continue;
        while (passed < steps.size() && steps[passed].row->time <= ticks[i].t)
            ++passed;
        const HapticOutput& touch = passed > 0 ? steps[passed - 1].output : player.proxy().output;
        plot.take(slice, touch, player.run().hand(hand).device.maxForce, player.proxy().rate, {}, touched);
        view.addTrail(slice, touch);
        slice.clear();
    }
    return ticks;
}

void showPlayedHands(const Player& player, std::size_t shown, SceneView& view) {
    const RecordedRun& run = player.run();
    const auto markOf = [&](std::size_t hand) {
        return HandMark{.number = hand, .name = QString::fromStdString(run.hand(hand).device.name)};
    };
    std::vector<HandBeside> beside;
    for (std::size_t hand = 0; hand < run.hands(); ++hand)
        if (hand != shown)
            beside.push_back(
                {markOf(hand), player.touch(hand), player.servo(hand), run.hand(hand).device.maxForce, true});
    view.setHands(markOf(shown), beside);
    view.setHaptics(player.proxy(), player.servo(shown), run.hand(shown).device.maxForce, true);
}

} // namespace tactum
