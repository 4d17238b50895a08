#include "ui/view/occlusion_texture.h"

#include <array>
#include <utility>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>

namespace tactum {

// A matrix goes to the card by columns, VTK's are by rows.
const char* const OcclusionTexture::kDeclared = R"(
#define sceneOccludes
uniform sampler3D occlusionCubes;
uniform mat4 viewToCubes;
uniform mat4 viewToScene;
uniform float occlusionOffset;
float opennessAt(vec3 place, vec3 normal) {
    vec4 around = texture(occlusionCubes, (viewToCubes * vec4(place + occlusionOffset * normal, 1.0)).xyz);
    return clamp(around.a + dot(around.rgb - 0.5, mat3(viewToScene) * normal), 0.0, 1.0);
}
)";

void OcclusionTexture::set(std::shared_ptr<const OcclusionVolume> volume) {
    volume_ = volume && !volume->empty() ? std::move(volume) : nullptr;
    loaded_ = false;
}

void OcclusionTexture::load(vtkOpenGLRenderWindow& window) {
    static constexpr std::array<std::uint8_t, 4> kOpen{128, 128, 128, 255};
    const std::array<int, 3> count = volume_ ? volume_->count : std::array<int, 3>{1, 1, 1};
    const std::uint8_t* values = volume_ ? volume_->values.data() : kOpen.data();
    texture_->ReleaseGraphicsResources(&window);
    texture_->SetContext(&window);
    texture_->SetWrapS(vtkTextureObject::ClampToEdge);
    texture_->SetWrapT(vtkTextureObject::ClampToEdge);
    texture_->SetWrapR(vtkTextureObject::ClampToEdge);
    texture_->SetMinificationFilter(vtkTextureObject::Linear);
    texture_->SetMagnificationFilter(vtkTextureObject::Linear);
    texture_->Create3DFromRaw(unsigned(count[0]), unsigned(count[1]), unsigned(count[2]), 4,
                              VTK_UNSIGNED_CHAR, const_cast<std::uint8_t*>(values));
    loaded_ = true;
}

void OcclusionTexture::activate(vtkOpenGLRenderWindow& window) {
    if (!loaded_) load(window);
    texture_->Activate();
}

void OcclusionTexture::deactivate() {
    texture_->Deactivate();
}

void OcclusionTexture::tell(vtkShaderProgram& program, vtkCamera& camera) const {
    if (!program.IsUniformUsed("occlusionCubes")) return;
    vtkNew<vtkMatrix4x4> toScene, toCubes, byColumns;
    vtkMatrix4x4::Invert(camera.GetViewTransformMatrix(), toScene);
    for (int row = 0; row < 3 && volume_; ++row) {
        const double side = volume_->voxel * volume_->count[std::size_t(row)];
        toCubes->SetElement(row, row, 1 / side);
        toCubes->SetElement(row, 3, -volume_->corner[row] / side);
    }
    vtkMatrix4x4::Multiply4x4(toCubes, toScene, toCubes);
    program.SetUniformi("occlusionCubes", texture_->GetTextureUnit());
    program.SetUniformf("occlusionOffset", volume_ ? float(volume_->offset()) : 0);
    vtkMatrix4x4::Transpose(toCubes, byColumns);
    program.SetUniformMatrix("viewToCubes", byColumns);
    vtkMatrix4x4::Transpose(toScene, byColumns);
    program.SetUniformMatrix("viewToScene", byColumns);
}

void OcclusionTexture::release(vtkOpenGLRenderWindow& window) {
    texture_->ReleaseGraphicsResources(&window);
    loaded_ = false;
}

} // namespace tactum
