// How the mouse moves the camera, as the person likes it.
#pragma once

namespace tactum {

/// What a button does to the camera; with Shift the middle one does the other of the two.
struct CameraManners {
    enum class Drag { None, Orbit, Pan };

    Drag middle = Drag::Orbit, right = Drag::None; ///< a click with the right button stays the menu's
    double turnSpeed = 1;                          ///< of half a turn for the shorter side of the view
    double zoomSpeed = 1;                          ///< of 13 % for a notch of the wheel; < 0: away is farther
    bool zoomToCursor = true;                      ///< else to the middle of the view
    bool flies = true;                             ///< is seen on its way to another place
    bool lags = false; ///< what the mouse leads, against the force on it; the pointer is hidden then
};

} // namespace tactum
