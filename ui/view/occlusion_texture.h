// A baked occlusion on the card, for the studio light. Private to this folder.
#pragma once

#include <memory>

#include <vtkNew.h>
#include <vtkTextureObject.h>

#include "ui/view/occlusion_bake.h"

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace tactum {

/// Of one window. Shaders that have kDeclared know the openness at a place of a surface, which is 1 where
/// there is no volume. Thread: ui, but for set() with the window's context.
class OcclusionTexture {
public:
    /// Goes where a fragment shader declares; defines `sceneOccludes`.
    static const char* const kDeclared;

    void set(std::shared_ptr<const OcclusionVolume> volume);
    const OcclusionVolume* volume() const { return volume_.get(); }
    void activate(vtkOpenGLRenderWindow& window);
    void deactivate();
    /// While it is active, to a program that is bound; nothing where the program does not ask.
    void tell(vtkShaderProgram& program, vtkCamera& camera) const;
    void release(vtkOpenGLRenderWindow& window);

private:
    void load(vtkOpenGLRenderWindow& window);

    std::shared_ptr<const OcclusionVolume> volume_; ///< null: nothing takes light away
    vtkNew<vtkTextureObject> texture_;
    bool loaded_ = false;
};

} // namespace tactum
