#include "ui/view/relief_shader.h"

#include <algorithm>
#include <array>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include "core/surface/painted_sample.h"
#include "core/surface/procedural_texture.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

// A vec4 is a TextureField: the gradient in the body frame and, last, the value. The words of the functions
// are those of texture_field.h, texture_mapping.cpp, texture_feel.cpp and procedural_texture.cpp, where the
// why is.
constexpr const char* kFunctions = R"(
uniform int feltQuick; // ModelMapper says it
in vec3 feltPlace;
flat in mat3 feltToView;
vec3 feltAlongX, feltAlongY;
vec4 feltOf(float number, vec3 gradient) { return vec4(gradient, number); }
vec4 feltTimes(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz, a.w * b.w); }
vec4 feltMixed(vec4 a, vec4 b, vec4 weight) { return a + feltTimes(weight, b - a); }
vec3 feltGradient(float number) { return dFdx(number) * feltAlongX + dFdy(number) * feltAlongY; }
vec3 feltFramed(int p, vec3 place) {
    vec4 at = vec4(place, 1.0);
    return vec3(dot(feltNumbers[p], at), dot(feltNumbers[p + 1], at), dot(feltNumbers[p + 2], at));
}
vec2 feltFlat(int p, vec2 metres) {
    vec2 from = metres - feltNumbers[p + 4].xy;
    return vec2(dot(feltNumbers[p + 3].xy, from), dot(feltNumbers[p + 3].zw, from));
}
vec4 feltOnto(int p, vec3 flatSample, vec3 alongU, vec3 alongV) {
    vec4 perMetre = feltNumbers[p + 3];
    return feltOf(flatSample.x, dot(flatSample.yz, perMetre.xz) * alongU +
                                dot(flatSample.yz, perMetre.yw) * alongV);
}
vec3 feltBody(int p, vec3 framed) {
    return framed.x * feltNumbers[p].xyz + framed.y * feltNumbers[p + 1].xyz +
           framed.z * feltNumbers[p + 2].xyz;
}
vec3 feltLattice(vec2 at, uint seed) {
    vec2 low = floor(at), t = at - low;
    uvec2 cell = uvec2(ivec2(low));
    uint left = cell.x * 0x9E3779B1u, right = left + 0x9E3779B1u;
    uint below = cell.y * 0x85EBCA77u + seed * 0xC2B2AE3Du, above = below + 0x85EBCA77u;
    uvec4 h = uvec4(left, right, left, right) ^ uvec4(below, below, above, above);
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    vec4 turn = vec4((h ^ (h >> 16)) & 15u) * 0.39269908169872414;
    vec4 gx = cos(turn), gy = sin(turn);
    vec4 heights = gx * vec4(t.x, t.x - 1.0, t.x, t.x - 1.0) + gy * vec4(t.y, t.y, t.y - 1.0, t.y - 1.0);
    vec2 fade = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    vec2 fadeSlope = 30.0 * t * t * (t - 1.0) * (t - 1.0);
    vec3 n00 = vec3(heights.x, gx.x, gy.x), n10 = vec3(heights.y, gx.y, gy.y);
    vec3 n01 = vec3(heights.z, gx.z, gy.z), n11 = vec3(heights.w, gx.w, gy.w);
    vec3 alongLower = n10 - n00, alongUpper = n11 - n01;
    vec3 lower = n00 + fade.x * alongLower, up = n01 + fade.x * alongUpper - lower;
    vec3 sum = lower + fade.y * up;
    float byX = fadeSlope.x * (alongLower.x + fade.y * (alongUpper.x - alongLower.x));
    return 1.4142135623730951 * (sum + vec3(0.0, byX, fadeSlope.y * up.x));
}
vec3 feltNoise(int p, vec2 at) {
    vec3 sum = vec3(0.5, 0.0, 0.0);
    float cells = 1.0;
    uint seed = uint(feltNumbers[p + 5].x);
    for (int i = 0; i < 8; ++i) {
        float amplitude = feltNumbers[p + 6 + i / 4][i % 4];
        if (amplitude == 0.0 || (feltQuick > 0 && i > 1)) break;
        sum += amplitude * vec3(1.0, cells, cells) * feltLattice(cells * at, seed + uint(i));
        cells *= 2.0;
    }
    return sum;
}
)";

/// `$` stands for the pattern's number, `@` for where its numbers begin.
constexpr const char* kTiled = R"(
vec3 feltFlat$(vec2 at) { return texture(feltTile$, at).xyz; }
vec3 feltKept$(vec3 weight) { return weight; } // to choose costs more than to look up
)";
constexpr const char* kNoisy = R"(
vec3 feltFlat$(vec2 at) { return feltNoise(@, at); }
vec3 feltKept$(vec3 weight) {
    return feltQuick > 0 ? max(weight - 0.5 * max(weight.x, max(weight.y, weight.z)), 0.0) : weight;
}
)";
/// Value and slope at the corners, both linear between them.
constexpr const char* kPainted = R"(
vec4 feltPattern$(vec3 place, vec3 n) { return feltOf(clamp(feltPainted$.w, 0.0, 1.0), feltPainted$.xyz); }
)";
constexpr const char* kOnUvs = R"(
vec4 feltPattern$(vec3 place, vec3 n) {
    float metresPerUv = feltNumbers[@ + 5].y;
    return feltOnto(@, feltFlat$(feltFlat(@, metresPerUv * feltUvs)), metresPerUv * feltGradient(feltUvs.x),
                    metresPerUv * feltGradient(feltUvs.y));
}
)";
constexpr const char* kTriplanar = R"(
vec4 feltPattern$(vec3 place, vec3 n) {
    vec3 p = feltFramed(@, place);
    vec3 side = vec3(dot(feltNumbers[@].xyz, n), dot(feltNumbers[@ + 1].xyz, n), dot(feltNumbers[@ + 2].xyz, n));
    vec3 weight = max(side * side * side * side - 1e-4, 0.0);
    weight = feltKept$(weight);
    weight /= weight.x + weight.y + weight.z;
    vec4 sum = vec4(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        if (weight[axis] == 0.0) continue;
        int u = (axis + 1) % 3, v = (axis + 2) % 3;
        float sign = side[axis] < 0.0 ? -1.0 : 1.0;
        sum += weight[axis] * feltOnto(@, feltFlat$(feltFlat(@, vec2(sign * p[u], p[v]))),
                                       sign * feltNumbers[@ + u].xyz, feltNumbers[@ + v].xyz);
    }
    return sum;
}
)";
constexpr const char* kPlanar = R"(
vec4 feltPattern$(vec3 place, vec3 n) {
    return feltOnto(@, feltFlat$(feltFlat(@, feltFramed(@, place).xy)), feltNumbers[@].xyz, feltNumbers[@ + 1].xyz);
}
)";
constexpr const char* kCylindrical = R"(
vec4 feltPattern$(vec3 place, vec3 n) {
    vec3 p = feltFramed(@, place);
    float radius = feltNumbers[@ + 4].z, metresPerRadian = feltNumbers[@ + 4].w, pole = 0.01 * radius;
    vec3 around = vec3(-p.y, p.x, 0.0) / max(dot(p.xy, p.xy), pole * pole);
    return feltOnto(@, feltFlat$(feltFlat(@, vec2(metresPerRadian * atan(p.y, p.x), p.z))),
                    metresPerRadian * feltBody(@, around), feltNumbers[@ + 2].xyz);
}
)";
constexpr const char* kSpherical = R"(
vec4 feltPattern$(vec3 place, vec3 n) {
    vec3 p = feltFramed(@, place);
    float radius = feltNumbers[@ + 4].z, metresPerRadian = feltNumbers[@ + 4].w, pole = 0.01 * radius;
    float across = length(p.xy), away = max(across, 1e-3 * pole);
    vec3 around = vec3(-p.y, p.x, 0.0) / max(dot(p.xy, p.xy), pole * pole);
    vec3 north = vec3(-p.xy * p.z / away, across) / max(dot(p, p), pole * pole);
    vec2 metres = vec2(metresPerRadian * atan(p.y, p.x), radius * atan(p.z, across));
    return feltOnto(@, feltFlat$(feltFlat(@, metres)), metresPerRadian * feltBody(@, around),
                    radius * feltBody(@, north));
}
)";

/// Tilts `n`, which faces the eye, and darkens what lies low. Hollows see less of the sky than what stands
/// out.
constexpr const char* kTilt = R"(
    vec3 feltX = dFdx(feltPlace), feltY = dFdy(feltPlace), feltFacet = cross(feltX, feltY);
    float feltArea = dot(feltFacet, feltFacet);
    feltAlongX = feltArea > 0.0 ? cross(feltY, feltFacet) / feltArea : vec3(0.0);
    feltAlongY = feltArea > 0.0 ? cross(feltFacet, feltX) / feltArea : vec3(0.0);
    vec3 feltNormal = transpose(feltToView) * n;
    vec4 felt = feltHeight(feltPlace, feltNormal);
    felt.xyz -= dot(felt.xyz, feltNormal) * feltNormal;
    felt.xyz /= max(length(felt.xyz), 1.0);
    n = normalize(n - feltToView * felt.xyz);
    vec2 feltRange = feltNumbers[0].xy;
    diffuseColor *= mix(0.55, 1.05, clamp((felt.w - feltRange.x) / max(feltRange.y - feltRange.x, 1e-9), 0.0, 1.0));
)";

constexpr int kNumbersOfAll = 1, kNumbersOfLayer = 1, kNumbersOfPattern = 8; // vec4 each
constexpr const char *kUvArray = "feltUv", *kPaintArray = "feltPaint";

/// Text with the numbers of a pattern in it.
std::string numbered(std::string text, std::size_t pattern, int first) {
    const auto put = [&](char mark, const std::string& number) {
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
            text.replace(at, 1, number);
    };
    put('$', std::to_string(pattern));
    put('@', std::to_string(first));
    return text;
}

const char* mappedText(const CompiledPattern& pattern) {
    switch (pattern.mapping) {
    case TextureMapping::Uv:
    case TextureMapping::UvUnit:
        return kOnUvs;
    case TextureMapping::Triplanar:
        return kTriplanar;
    case TextureMapping::Cylindrical:
        return kCylindrical;
    case TextureMapping::Spherical:
        return kSpherical;
    case TextureMapping::Planar:
        break;
    }
    return kPlanar;
}

/// Every pattern and mask, in the order of the layers.
std::vector<const CompiledPattern*> patternsOf(const TextureStack& stack) {
    std::vector<const CompiledPattern*> patterns;
    for (const CompiledLayer& layer : stack.layers) {
        patterns.push_back(&layer.pattern);
        if (layer.mask) patterns.push_back(&*layer.mask);
    }
    return patterns;
}

int firstNumber(const TextureStack& stack, std::size_t pattern) {
    return kNumbersOfAll + kNumbersOfLayer * int(stack.layers.size()) + kNumbersOfPattern * int(pattern);
}

const char* blendText(TextureBlend blend) {
    switch (blend) {
    case TextureBlend::Subtract:
        return "below -= feltTimes(weight, change);";
    case TextureBlend::Multiply:
        return "below = feltTimes(below, feltMixed(vec4(0.0, 0.0, 0.0, 1.0), value, weight));";
    case TextureBlend::Maximum:
        return "below = feltMixed(below, change.w > below.w ? change : below, weight);";
    case TextureBlend::Minimum:
        return "below = feltMixed(below, change.w < below.w ? change : below, weight);";
    case TextureBlend::Replace:
        return "below = feltMixed(below, change, weight);";
    case TextureBlend::Add:
        break;
    }
    return "below += feltTimes(weight, change);";
}

std::string layersText(const TextureStack& stack) {
    std::string text =
        "vec4 feltHeight(vec3 place, vec3 n) {\n    vec4 below = vec4(0.0), value, weight, change;\n";
    std::size_t pattern = 0;
    for (std::size_t i = 0; i < stack.layers.size(); ++i) {
        const std::string numbers = "feltNumbers[" + std::to_string(kNumbersOfAll + i) + "]";
        text += "    value = feltPattern" + std::to_string(pattern++) +
                "(place, n);\n    change = " + numbers + ".x * value;\n    weight = " + numbers + ".y * ";
        text += stack.layers[i].mask ? "feltPattern" + std::to_string(pattern++) + "(place, n);\n"
                                     : "vec4(0.0, 0.0, 0.0, 1.0);\n";
        text += std::string("    ") + blendText(stack.layers[i].blend) + "\n";
    }
    return text + "    return below;\n}\n";
}

/// What goes from corners to pixels.
struct Handed {
    std::string attribute, type, varying;
};

std::vector<Handed> handedOf(const Relief& relief) {
    std::vector<Handed> handed;
    const auto patterns = patternsOf(*relief.stack);
    if (std::ranges::any_of(patterns, [](const CompiledPattern* p) { return usesUvs(*p); }))
        handed.push_back({kUvArray, "vec2", "feltUvs"});
    for (std::size_t i = 0; i < patterns.size(); ++i)
        if (patterns[i]->source == TextureSource::Painted)
            handed.push_back({kPaintArray + std::to_string(i), "vec4", "feltPainted" + std::to_string(i)});
    return handed;
}

std::string fragmentText(const Relief& relief) {
    std::string text = kFunctions;
    for (const Handed& handed : handedOf(relief))
        text += "in " + handed.type + " " + handed.varying + ";\n";
    const auto patterns = patternsOf(*relief.stack);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const CompiledPattern& pattern = *patterns[i];
        const int first = firstNumber(*relief.stack, i);
        if (pattern.source == TextureSource::Painted) {
            text += numbered(kPainted, i, first);
            continue;
        }
        text += numbered(repeats(pattern) ? kTiled : kNoisy, i, first);
        text += numbered(mappedText(pattern), i, first);
    }
    return text + layersText(*relief.stack);
}

/// Declarations of the vertex shader, and its statements.
std::array<std::string, 2> vertexText(const Relief& relief) {
    std::string declared = "out vec3 feltPlace;\nflat out mat3 feltToView;\n",
                done = "feltPlace = vertexMC.xyz;\nfeltToView = mat3(MCVCMatrix);\n";
    for (const Handed& handed : handedOf(relief)) {
        declared += "in " + handed.type + " " + handed.attribute + ";\nout " + handed.type + " " +
                    handed.varying + ";\n";
        done += handed.varying + " = " + handed.attribute + ";\n";
    }
    return {declared, done};
}

using Numbers = std::vector<std::array<float, 4>>;

std::array<float, 4> four(double a, double b, double c, double d) {
    return {float(a), float(b), float(c), float(d)};
}

/// How high each octave of noise is, as noise() has it.
std::array<double, 8> amplitudesOf(const CompiledPattern& pattern, double smallestFeature) {
    std::array<double, 8> amplitudes{};
    const double grain = 1 / pattern.repeatsPerMetre.rowwise().norm().maxCoeff();
    double height = 0.5 / (2 - 2 / double(1 << pattern.octaves));
    for (int i = 0; i < pattern.octaves; ++i, height /= 2)
        amplitudes[std::size_t(i)] = height * kept(grain / double(1 << i), smallestFeature);
    return amplitudes;
}

void addNumbers(Numbers& numbers, const CompiledPattern& pattern, double smallestFeature) {
    for (int row = 0; row < 3; ++row) {
        const Vec3 axis = pattern.axes.row(row);
        numbers.push_back(four(axis.x(), axis.y(), axis.z(), -axis.dot(pattern.origin)));
    }
    const auto& flat = pattern.repeatsPerMetre;
    numbers.push_back(four(flat(0, 0), flat(0, 1), flat(1, 0), flat(1, 1)));
    numbers.push_back(four(pattern.offset.x(), pattern.offset.y(), pattern.radius, pattern.metresPerRadian));
    numbers.push_back(four(pattern.seed, pattern.metresPerUv, 0, 0));
    const auto a = pattern.source == TextureSource::Noise ? amplitudesOf(pattern, smallestFeature)
                                                          : std::array<double, 8>{};
    numbers.push_back(four(a[0], a[1], a[2], a[3]));
    numbers.push_back(four(a[4], a[5], a[6], a[7]));
}

Numbers numbersOf(const Relief& relief) {
    Numbers numbers{four(relief.low, relief.high, 0, 0)};
    for (const CompiledLayer& layer : relief.stack->layers)
        numbers.push_back(four(layer.strength, layer.opacity, 0, 0));
    for (const CompiledPattern* pattern : patternsOf(*relief.stack))
        addNumbers(numbers, *pattern, relief.smallestFeature);
    return numbers;
}

constexpr const char *kAtVertex = "//VTK::PositionVC::Dec", *kInVertex = "//VTK::PositionVC::Impl",
                     *kAtFragment = "//VTK::Picking::Dec";

std::string after(const char* place, const std::string& text) {
    return std::string(place) + "\n" + text;
}

vtkSmartPointer<vtkFloatArray> arrayOf(const std::string& name, int components, std::size_t vertices) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(vtkIdType(vertices));
    array->FillValue(0);
    return array;
}

} // namespace

void ReliefShader::setProgram(vtkActor& actor, vtkPolyDataMapper& mapper, const Relief* relief) {
    const std::string text = relief ? fragmentText(*relief) : std::string();
    if (text == program_) return;
    program_ = text;
    vtkShaderProperty& shaders = *actor.GetShaderProperty();
    mapper.RemoveAllVertexAttributeMappings();
    shaders.ClearAllVertexShaderReplacements();
    shaders.ClearAllFragmentShaderReplacements();
    shaders.GetFragmentCustomUniforms()->RemoveAllUniforms();
    useStudioLight(actor, relief ? kTilt : "");
    if (!relief) return;
    const auto [declared, done] = vertexText(*relief);
    shaders.AddVertexShaderReplacement(kAtVertex, true, after(kAtVertex, declared), false);
    shaders.AddVertexShaderReplacement(kInVertex, true, after(kInVertex, done), false);
    shaders.AddFragmentShaderReplacement(kAtFragment, true, after(kAtFragment, text), false);
    for (const Handed& handed : handedOf(*relief))
        mapper.MapDataArrayToVertexAttribute(handed.attribute.c_str(), handed.attribute.c_str(),
                                             vtkDataObject::FIELD_ASSOCIATION_POINTS);
}

void ReliefShader::wear(vtkActor& actor, vtkPolyDataMapper& mapper,
                        const std::shared_ptr<const Relief>& relief, ReliefTiles& tiles) {
    setProgram(actor, mapper, relief.get());
    for (const std::string& sampler : std::exchange(samplers_, {}))
        actor.GetProperty()->RemoveTexture(sampler.c_str());
    relief_ = relief;
    if (!relief) return;
    const Numbers numbers = numbersOf(*relief);
    static_assert(sizeof(Numbers::value_type) == sizeof(float[4]));
    actor.GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform4fv(
        "feltNumbers", int(numbers.size()), reinterpret_cast<const float(*)[4]>(numbers.data()));
    const auto patterns = patternsOf(*relief->stack);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (!repeats(*patterns[i])) continue;
        samplers_.push_back("feltTile" + std::to_string(i));
        actor.GetProperty()->SetTexture(samplers_.back().c_str(),
                                        tiles.of(*patterns[i], relief->smallestFeature));
    }
}

void giveCorners(vtkPolyData& data, Index surface, const Relief& relief) {
    const TriangleSoup& soup = *relief.stack->soup;
    const auto vertices = std::size_t(data.GetNumberOfPoints());
    const auto give = [&](const std::string& name, int components, auto numbersAt) {
        const auto array = arrayOf(name, components, vertices);
        std::size_t vertex = 0;
        for (Index f = 0; f < Index(soup.triangles.size()) && vertex + 3 <= vertices; ++f) {
            const auto& t = soup.triangles[f];
            if (soup.surfaceOf[f] != surface || t[0] == t[1] || t[1] == t[2]) continue;
            for (std::size_t k = 0; k < 3; ++k, ++vertex)
                std::copy_n(numbersAt(f, k), components, array->GetPointer(components * vtkIdType(vertex)));
        }
        data.GetPointData()->AddArray(array);
    };
    if (!soup.cornerUvs.empty())
        give(kUvArray, 2,
             [&](Index f, std::size_t k) { return soup.cornerUvs[3 * std::size_t(f) + k].data(); });
    const auto patterns = patternsOf(*relief.stack);
    std::array<Vec3, 3> slopes;
    std::array<float, 4> numbers;
    for (std::size_t i = 0; i < patterns.size(); ++i)
        if (patterns[i]->source == TextureSource::Painted)
            give(kPaintArray + std::to_string(i), 4, [&](Index f, std::size_t k) {
                if (k == 0) slopes = paintedSlopes(*patterns[i], f);
                numbers = four(slopes[k].x(), slopes[k].y(), slopes[k].z(),
                               (*patterns[i]->painted)[soup.triangles[f][k]]);
                return numbers.data();
            });
}

} // namespace tactum
