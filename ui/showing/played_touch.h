// What a replay gives, in the force plot and as a trail in the view.
#pragma once

#include <vector>

#include <QString>

#include "core/recording/player.h"

namespace tactum {

class ForcePlot;
class SceneView;

// Of a hand of the recording, below player.run().hands(), of which the player speaks. Thread: ui.

/// Shows the servo ticks since the last call, with the haptic steps that belong to them; both are taken from
/// the player. `touched`: the name of the surface that is touched. Gives the ticks back.
std::vector<TracePoint> showPlayed(Player& player, std::size_t hand, ForcePlot& plot, SceneView& view,
                                   const QString& touched);

/// Draws it, and the other hands beside it, with the names of their devices.
void showPlayedHands(const Player& player, std::size_t hand, SceneView& view);

} // namespace tactum
