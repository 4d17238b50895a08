#include "ui/view/studio_light.h"

#include <sstream>
#include <string>

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include "ui/base/screen_colour.h"

namespace tactum {

namespace {

constexpr double kUsualGloss = 0.4;
const Vec3 kToKey(-0.44, 0.66, 0.61); ///< in the camera's frame: right, up, toward the eye

/// The statement of GLSL that names it.
std::string keyLine() {
    std::ostringstream line;
    line << "const vec3 toKey = vec3(" << kToKey.x() << ", " << kToKey.y() << ", " << kToKey.z() << ");";
    return line.str();
}

// Replaces VTK's light loop in the fragment shader: one pass with fixed lights in the camera's frame costs
// less than a kit of five, which matters where the processor draws.
constexpr const char* kNormal = R"(
    vec3 toEye = normalize(-vertexVC.xyz);
    vec3 facet = cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz));
    facet *= sign(dot(facet, toEye));
    vec3 n = dot(normalVCVSOutput, facet) < 0.0 ? -normalVCVSOutput : normalVCVSOutput;
)";

// A soft box is a lit rectangle in the direction that the surface mirrors; what is rough blurs its edges
// until little of it is left. Above 0.8 the curve bends towards white, so that what is bright keeps its
// colour.
constexpr const char* kLight = R"(
#ifdef sceneOccludes
    float open = opennessAt(vertexVC.xyz, n);
#else
    const float open = 1.0;
#endif
    const vec3 toFill = vec3(0.83, 0.12, 0.54), toLow = vec3(0.5, -0.62, 0.6);
    float key = max(0.0, (dot(n, toKey) + 0.15) / 1.15);
    float fill = max(0.0, (dot(n, toFill) + 0.3) / 1.3);
    float low = max(0.0, (dot(n, toLow) + 0.2) / 1.2);
    float facing = clamp(dot(n, toEye), 0.0, 1.0);
    vec3 light = open * mix(vec3(0.16, 0.15, 0.14), vec3(0.2, 0.22, 0.25), 0.5 + 0.5 * n.y)
               + mix(0.25, 1.0, open) * (0.72 * key * vec3(1.0, 0.965, 0.91) + 0.14 * fill * vec3(0.78, 0.88, 1.0)
                                        + 0.16 * low * vec3(1.0, 0.97, 0.93));
    float gloss = clamp(specularColor.x, 0.0, 1.0);
    float sharp = pow(max(0.0, dot(n, normalize(toKey + toEye))), mix(6.0, 70.0, gloss));
    vec3 mirrored = 2.0 * dot(n, toEye) * n - toEye;
    float blur = mix(0.75, 0.1, gloss);
    const vec3 keyAcross = vec3(0.811, 0.0, 0.585), keyUp = vec3(0.386, 0.748, -0.535);
    vec2 onKey = abs(vec2(dot(mirrored, keyAcross), dot(mirrored, keyUp)));
    vec2 onFill = abs(vec2(mirrored.z, mirrored.y - 0.15));
    vec2 key2 = 1.0 - smoothstep(vec2(0.3 - 0.3 * blur), vec2(0.3 + blur), onKey);
    vec2 fill2 = 1.0 - smoothstep(vec2(0.2, 0.5) - 0.2 * blur, vec2(0.2, 0.5) + blur, onFill);
    float boxes = key2.x * key2.y * step(0.0, dot(mirrored, toKey)) + 0.5 * fill2.x * fill2.y * step(0.0, mirrored.x);
    float fresnel = 0.25 + 0.75 * pow(1.0 - facing, 5.0);
    float rim = pow(1.0 - facing, 4.0) * (0.55 + 0.45 * n.y);
    vec3 linear = diffuseColor * light + open * vec3(mix(0.02, 0.13, gloss) * sharp + 0.45 * gloss * fresnel * boxes)
                + open * mix(0.5, 1.0, gloss) * vec3(0.11, 0.12, 0.14) * rim + ambientColor;
#ifdef modelIsCut
    if (!gl_FrontFacing)
        linear = (0.85 + 0.15 * facing) * mix(0.4 * diffuseColor, vec3(0.36, 0.115, 0.06), 0.7) + ambientColor;
#endif
    vec3 bright = max(linear - 0.8, 0.0);
    linear = min(linear, 0.8) + 0.2 * (1.0 - exp(-5.0 * bright));
    gl_FragData[0] = vec4(pow(max(linear, 0.0), vec3(1.0 / 2.2)), opacity);
)";

constexpr const char* kBubble = R"(
    vec3 toEye = normalize(-vertexVC.xyz);
    float facing = clamp(abs(dot(normalize(normalVCVSOutput), toEye)), 0.0, 1.0);
    float rim = 0.05 + 0.75 * pow(1.0 - facing, 2.5);
    float key = 0.75 + 0.25 * clamp(dot(normalVCVSOutput, toKey), -1.0, 1.0);
    gl_FragData[0] = vec4(pow(clamp(key * diffuseColor, 0.0, 1.0), vec3(1.0 / 2.2)), rim);
)";

} // namespace

Vec3 towardKeyLight(const ViewCamera& camera) {
    return (kToKey.x() * camera.right() + kToKey.y() * camera.up() - kToKey.z() * camera.forward())
        .normalized();
}

void useBubbleLight(vtkActor& actor) {
    actor.ForceTranslucentOn(); // writes no depth
    actor.GetProperty()->BackfaceCullingOn();
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, keyLine() + kBubble,
                                                            false);
}

void useStudioLight(vtkActor& actor, const std::string& tilt) {
    actor.GetProperty()->SetAmbient(1);
    actor.GetProperty()->SetAmbientColor(0, 0, 0);
    actor.GetProperty()->SetDiffuse(1);
    actor.GetProperty()->SetSpecular(kUsualGloss);
    actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                                            kNormal + tilt + keyLine() + kLight, false);
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
             "in vec3 bodyColour; in vec3 bodyGlow; in float bodyGloss;\n"
             "out vec3 colourOfBody; out vec3 glowOfBody; out float glossOfBody;\n");
    inVertex("//VTK::PositionVC::Impl",
             "colourOfBody = bodyColour; glowOfBody = bodyGlow; glossOfBody = bodyGloss;\n");
    inFragment("//VTK::PositionVC::Dec", "in vec3 colourOfBody; in vec3 glowOfBody; in float glossOfBody;\n");
    inFragment(
        "//VTK::Color::Impl",
        "diffuseColor = colourOfBody; ambientColor = glowOfBody; specularColor = vec3(glossOfBody);\n");
}

void showWireframe(vtkActor& actor, bool on) {
    actor.GetProperty()->SetRepresentation(on ? VTK_WIREFRAME : VTK_SURFACE);
}

void useNoLight(vtkActor& actor) {
    actor.GetProperty()->LightingOff();
}

void setScreenColour(vtkActor& actor, const QColor& colour) {
    const Vec3 linear = linearColour(colour).cast<double>();
    actor.GetProperty()->SetDiffuseColor(linear.x(), linear.y(), linear.z());
}

} // namespace tactum
