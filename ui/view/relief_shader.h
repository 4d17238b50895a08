// The relief of a surface in the fragment shader: what feel() says of its height, for every pixel. Private to
// this folder.
#pragma once

#include <string>
#include <vector>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "ui/view/relief.h"
#include "ui/view/relief_tile.h"

class vtkActor;
class vtkPolyDataMapper;

namespace tactum {

/// What an actor under the studio light has put on: it tilts the light's normals by the slope of the height,
/// as the felt planes are tilted by it, and darkens hollows. The program of the shader depends on which
/// layers there are; numbers are uniforms, so that one that changes costs no compiling. Thread: ui.
class ReliefShader {
public:
    /// Null: takes it off again. The mapper's data have corners of their own where relief->corners says so;
    /// see giveCorners().
    void wear(vtkActor& actor, vtkPolyDataMapper& mapper, const std::shared_ptr<const Relief>& relief,
              ReliefTiles& tiles);
    const Relief* worn() const { return relief_.get(); }

private:
    void setProgram(vtkActor& actor, vtkPolyDataMapper& mapper, const Relief* relief);

    std::shared_ptr<const Relief> relief_;
    std::string program_; ///< empty: none
    std::vector<std::string> samplers_;
};

/// Gives data, whose vertices are three to a triangle of a surface of the relief's soup, and then others, the
/// numbers that the relief needs at corners: texture coordinates, and values for each painted pattern.
void giveCorners(vtkPolyData& data, Index surface, const Relief& relief);

} // namespace tactum
