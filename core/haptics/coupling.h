// The hand's side of the spring between the finger and what it pushes.
#pragma once

#include <limits>

namespace tactum {

/// What of the force of a virtual coupling (Colgate 1995) the hand really gets: the bodies get the opposite
/// of that, and no more.
struct Coupling {
    double stiffness = std::numeric_limits<double>::infinity(); ///< N/m, that is rendered at most
    double force = std::numeric_limits<double>::infinity();     ///< N, that the device can give at most
    /// s, from where finger and body are to the force on the hand that answers. A spring that answers so late
    /// makes energy; a damper of stiffness times delay on the body's side takes it where it is made.
    double delay = 0;
};

} // namespace tactum
