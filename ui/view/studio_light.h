// The light in which everything in the view is seen. Private to this folder.
#pragma once

#include <QColor>

class vtkActor;

namespace tactum {

/// Lights an actor as in a photographer's studio that moves with the camera: a warm key light from the upper
/// left, a cool fill from the right, sky and floor, and a rim. Both sides of a surface are lit. The actor's
/// diffuse colour is linear RGB; its ambient colour is added as a glow.
void useStudioLight(vtkActor& actor);

/// Gives an actor under the studio light the linear colours "bodyColour" and "bodyGlow" of its vertices,
/// which its mapper hands on under these names, in the place of its own.
void useVertexColours(vtkActor& actor);

/// A bubble: clear where one looks through it, seen at its rim. Nothing behind it is hidden, and of bubbles
/// of one colour it does not matter which is drawn first.
void useBubbleLight(vtkActor& actor);

/// Draws the actor in its diffuse colour as it is on the screen, without light.
void useNoLight(vtkActor& actor);

/// The diffuse colour of an actor under the studio light, from a colour as it is on the screen.
void setScreenColour(vtkActor& actor, const QColor& colour);

} // namespace tactum
