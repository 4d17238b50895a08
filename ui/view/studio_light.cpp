#include "ui/view/studio_light.h"

#include <array>
#include <cmath>
#include <string>

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

namespace tactum {

namespace {

// Replaces VTK's light loop in the fragment shader: one pass with fixed lights in the camera's frame costs
// less than a kit of five, which matters where the processor draws.
constexpr const char* kLight = R"(
    vec3 toEye = normalize(-vertexVC.xyz);
    vec3 facet = cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz));
    facet *= sign(dot(facet, toEye));
    vec3 n = dot(normalVCVSOutput, facet) < 0.0 ? -normalVCVSOutput : normalVCVSOutput;
    const vec3 toKey = vec3(-0.44, 0.66, 0.61);
    const vec3 toFill = vec3(0.83, 0.12, 0.54);
    float key = max(0.0, (dot(n, toKey) + 0.15) / 1.15);
    float fill = max(0.0, (dot(n, toFill) + 0.3) / 1.3);
    float facing = clamp(dot(n, toEye), 0.0, 1.0);
    vec3 light = mix(vec3(0.085, 0.08, 0.075), vec3(0.18, 0.2, 0.23), 0.5 + 0.5 * n.y)
               + 0.72 * key * vec3(1.0, 0.965, 0.91) + 0.14 * fill * vec3(0.78, 0.88, 1.0);
    float gloss = pow(max(0.0, dot(n, normalize(toKey + toEye))), 42.0);
    float rim = pow(1.0 - facing, 4.0) * (0.55 + 0.45 * n.y);
    vec3 linear = diffuseColor * light + vec3(0.13 * gloss) + vec3(0.11, 0.12, 0.14) * rim + ambientColor;
    gl_FragData[0] = vec4(pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2)), opacity);
)";

constexpr const char* kBubble = R"(
    vec3 toEye = normalize(-vertexVC.xyz);
    float facing = clamp(abs(dot(normalize(normalVCVSOutput), toEye)), 0.0, 1.0);
    float rim = 0.05 + 0.75 * pow(1.0 - facing, 2.5);
    float key = 0.75 + 0.25 * clamp(dot(normalVCVSOutput, vec3(-0.44, 0.66, 0.61)), -1.0, 1.0);
    gl_FragData[0] = vec4(pow(clamp(key * diffuseColor, 0.0, 1.0), vec3(1.0 / 2.2)), rim);
)";

} // namespace

void useBubbleLight(vtkActor& actor) {
    actor.ForceTranslucentOn(); // writes no depth
    actor.GetProperty()->BackfaceCullingOn();
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kBubble, false);
}

void useStudioLight(vtkActor& actor) {
    actor.GetProperty()->SetAmbient(1);
    actor.GetProperty()->SetAmbientColor(0, 0, 0);
    actor.GetProperty()->SetDiffuse(1);
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, kLight, false);
}

void useVertexColours(vtkActor& actor) {
    vtkShaderProperty& shaders = *actor.GetShaderProperty();
    const auto inVertex = [&](const char* where, const char* what) {
        shaders.AddVertexShaderReplacement(where, true, std::string(where) + "\n" + what, false);
    };
    const auto inFragment = [&](const char* where, const char* what) {
        shaders.AddFragmentShaderReplacement(where, true, std::string(where) + "\n" + what, false);
    };
    inVertex("//VTK::PositionVC::Dec",
             "in vec3 bodyColour; in vec3 bodyGlow; out vec3 colourOfBody; out vec3 glowOfBody;\n");
    inVertex("//VTK::PositionVC::Impl", "colourOfBody = bodyColour; glowOfBody = bodyGlow;\n");
    inFragment("//VTK::PositionVC::Dec", "in vec3 colourOfBody; in vec3 glowOfBody;\n");
    inFragment("//VTK::Color::Impl", "diffuseColor = colourOfBody; ambientColor = glowOfBody;\n");
}

void useNoLight(vtkActor& actor) {
    actor.GetProperty()->LightingOff();
}

void setScreenColour(vtkActor& actor, const QColor& colour) {
    std::array<double, 3> linear{colour.redF(), colour.greenF(), colour.blueF()};
    for (double& c : linear)
        c = std::pow(c, 2.2);
    actor.GetProperty()->SetDiffuseColor(linear.data());
}

} // namespace tactum
