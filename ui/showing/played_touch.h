// What a replay gives, in the force plot and as a trail in the view.
#pragma once

#include <vector>

#include <QString>

#include "core/recording/player.h"

namespace tactum {

class ForcePlot;
class SceneView;

/// Shows the servo ticks since the last call, with the haptic steps that belong to them; both are taken from
/// the player. `touched`: the name of the surface that is touched. Gives the ticks back. Thread: ui.
std::vector<TracePoint> showPlayed(Player& player, ForcePlot& plot, SceneView& view, const QString& touched);

/// Draws the other hands of the recording beside the first, with the names of their devices. Before
/// setHaptics(). Thread: ui.
void showPlayedHands(const Player& player, SceneView& view);

} // namespace tactum
