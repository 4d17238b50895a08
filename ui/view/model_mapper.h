// Draws a mesh, or a coarser one in its place, whole or cut open. Private to this folder.
#pragma once

#include <vtkOpenGLPolyDataMapper.h>
#include <vtkSmartPointer.h>

class vtkPolyData;

namespace tactum {

/// In windows that draw coarsely (GlWindow::setCoarse()) the coarser mesh is drawn where there is one, and
/// the shader of a relief is told by its uniform "feltQuick". All that is asked of the mapper but the picture
/// is of the exact mesh. Where a section cuts it, the studio light shows its insides in a plain tone, and
/// where little light comes to (GlWindow::occlusion()) it is darker. Thread: ui.
class ModelMapper : public vtkOpenGLPolyDataMapper {
public:
    static ModelMapper* New();
    vtkTypeMacro(ModelMapper, vtkOpenGLPolyDataMapper)

        /// Null: none. Shares the points of the exact mesh, so that nothing of them is sent twice.
        void setCoarse(vtkPolyData* mesh);

    void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
    ModelMapper();
    void ReplaceShaderLight(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                            vtkActor* actor) override;
    void ReplaceShaderClip(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                           vtkActor* actor) override;
    void SetPropertyShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override;

private:
    vtkSmartPointer<ModelMapper> coarse_;
};

} // namespace tactum
