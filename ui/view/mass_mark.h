// Where the mass of a body is, drawn over the model: the even ellipsoid that has its mass and moments.
#pragma once

#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

struct MassMark {
    Pose pose;                ///< X_W of its principal axes, at the centre of mass, at the time 0
    Vec3 half = Vec3::Zero(); ///< m, half lengths of the ellipsoid along them

    bool operator==(const MassMark&) const = default;
};

/// Of moments I about the principal axes: a_x^2 = 5 (I_y + I_z - I_x) / 2 m. Thread: any.
MassMark massMark(const Pose& principal_W, double mass, const Vec3& moments);

/// The three ellipses of the principal planes and a dot at the centre. Thread: ui.
void drawMass(QPainter& painter, const MassMark& mark, const ViewCamera& camera, const Theme& theme);

} // namespace tactum
