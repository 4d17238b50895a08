#include "ui/view/model_mapper.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include "ui/view/gl_window.h"

namespace tactum {

vtkStandardNewMacro(ModelMapper);

// Places as they are: a relief is at places, and to move and scale them would carry it elsewhere.
ModelMapper::ModelMapper() {
    SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

void ModelMapper::setCoarse(vtkPolyData* mesh) {
    if (mesh == (coarse_ ? coarse_->GetInput() : nullptr)) return;
    Modified();
    if (!mesh) {
        coarse_ = nullptr;
        return;
    }
    coarse_ = vtkSmartPointer<ModelMapper>::New();
    coarse_->ScalarVisibilityOff();
    coarse_->SetInputData(mesh);
}

void ModelMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor) {
    auto* window = GlWindow::SafeDownCast(renderer->GetRenderWindow());
    if (!window) return Superclass::RenderPiece(renderer, actor);
    if (coarse_ && window->coarse() >= Coarse::Meshes) {
        coarse_->SetClippingPlanes(GetClippingPlanes());
        return coarse_->RenderPiece(renderer, actor);
    }
    window->occlusion().activate(*window);
    Superclass::RenderPiece(renderer, actor);
    window->occlusion().deactivate();
}

void ModelMapper::SetPropertyShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer,
                                              vtkActor* actor) {
    Superclass::SetPropertyShaderParameters(cells, renderer, actor);
    auto* window = GlWindow::SafeDownCast(renderer->GetRenderWindow());
    if (!window) return;
    window->occlusion().tell(*cells.Program, *renderer->GetActiveCamera());
    if (cells.Program->IsUniformUsed("feltQuick"))
        cells.Program->SetUniformi("feltQuick", window->drawsCoarse());
}

void ModelMapper::ReplaceShaderLight(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                                     vtkActor* actor) {
    if (GlWindow::SafeDownCast(renderer->GetRenderWindow())) {
        std::string text = shaders[vtkShader::Fragment]->GetSource();
        vtkShaderProgram::Substitute(text, "//VTK::Light::Dec",
                                     std::string(OcclusionTexture::kDeclared) + "//VTK::Light::Dec");
        shaders[vtkShader::Fragment]->SetSource(text);
    }
    Superclass::ReplaceShaderLight(std::move(shaders), renderer, actor);
}

void ModelMapper::ReplaceShaderClip(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
                                    vtkActor* actor) {
    if (GetNumberOfClippingPlanes() > 0) {
        std::string text = shaders[vtkShader::Fragment]->GetSource();
        vtkShaderProgram::Substitute(text, "//VTK::Clip::Dec", "#define modelIsCut\n//VTK::Clip::Dec");
        shaders[vtkShader::Fragment]->SetSource(text);
    }
    Superclass::ReplaceShaderClip(std::move(shaders), renderer, actor);
}

void ModelMapper::ReleaseGraphicsResources(vtkWindow* window) {
    if (coarse_) coarse_->ReleaseGraphicsResources(window);
    Superclass::ReleaseGraphicsResources(window);
}

} // namespace tactum
