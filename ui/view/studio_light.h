// The light in which everything in the view is seen. Private to this folder.
#pragma once

#include <string>

#include <QColor>

#include "ui/view/view_camera.h"

class vtkActor;

namespace tactum {

/// From anywhere to the key light, of unit length, world frame.
Vec3 towardKeyLight(const ViewCamera& camera);

/// Lights an actor as in a photographer's studio that moves with the camera: a warm key light from the upper
/// left, a cool fill from the right, sky and floor, a rim, and two soft boxes that what is glossy mirrors.
/// Both sides of a surface are lit. The actor's diffuse colour is linear RGB; its ambient colour is added as
/// a glow; its specular part says how glossy it is: 0 chalk, 1 glaze. `tilt`: statements of GLSL that change
/// the normal `n` in the camera's frame, which faces the eye, or `diffuseColor`, before the light falls on
/// them.
void useStudioLight(vtkActor& actor, const std::string& tilt = {});

/// Gives an actor under the studio light the linear colours "bodyColour" and "bodyGlow" and the gloss
/// "bodyGloss" of its vertices, which its mapper hands on under these names, in the place of its own.
void useVertexColours(vtkActor& actor);

/// Draws the triangles of an actor as lines, or filled.
void showWireframe(vtkActor& actor, bool on);

/// A bubble: clear where one looks through it, seen at its rim. Nothing behind it is hidden, and of bubbles
/// of one colour it does not matter which is drawn first.
void useBubbleLight(vtkActor& actor);

/// Draws the actor in its diffuse colour as it is on the screen, without light.
void useNoLight(vtkActor& actor);

/// The diffuse colour of an actor under the studio light, from a colour as it is on the screen.
void setScreenColour(vtkActor& actor, const QColor& colour);

} // namespace tactum
