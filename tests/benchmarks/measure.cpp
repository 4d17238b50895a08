#include "tests/benchmarks/measure.h"

#include <algorithm>
#include <chrono>

#include "core/haptics/compile.h"
#include "tests/benchmarks/one_core.h"
#include "tests/benchmarks/subjects.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#endif

namespace tactum::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kCountedRows = 2000;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void forEachMaterial(Scene& scene, auto&& change) {
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces)
            change(surface.material);
}

void nothing(Scene&) {}

void friction(Scene& scene) {
    forEachMaterial(scene, [](Material& material) {
        material.staticFriction = 0.5;
        material.dynamicFriction = 0.4;
        material.viscosity = 1;
    });
}

// Each row at its fastest: what the machine did besides drops out.
void keepFastest(TouchTrace& fastest, const TouchTrace& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        fastest[i].updateNs = std::min(fastest[i].updateNs, rows[i].updateNs);
}

TouchTrace fastestOf(int repetitions, const World& world, const std::vector<FingerPoint>& finger) {
    const OneCore pinned;
    TouchTrace fastest = replay(world, finger);
    for (int i = 1; i < repetitions; ++i)
        keepFastest(fastest, replay(world, finger));
    return fastest;
}

double meanRounds(const TouchTrace& rows) {
    double sum = 0;
    for (const TouchRow& row : rows)
        sum += row.rounds;
    return sum / double(rows.size());
}

std::size_t hierarchyBytes(const World& world) {
    std::size_t bytes = 0;
    for (const Obstacle& obstacle : world.obstacles)
        bytes += obstacle.mesh->tree.bytes();
    return bytes;
}

void shading(Scene& scene) {
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces)
            surface.shading.on = true;
}

void texture(Scene& scene) {
    TextureLayer layer;
    layer.pattern.size = 5e-3;
    layer.strength = 5e-5;
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces)
            surface.layers = {layer};
}

} // namespace

const std::vector<Effect>& effects() {
    static const std::vector<Effect> all{
        {"smooth", nothing}, {"friction", friction}, {"shading", shading}, {"texture", texture}};
    return all;
}

Result<Figures> measure(const Scene& scene, const Effect& effect, const std::vector<FingerPoint>& finger,
                        int repetitions, bool judge) {
    Scene felt = scene;
    effect.apply(felt);
    const auto begin = Clock::now();
    const auto world = compile(felt);
    if (!world) return tl::unexpected(world.error());
    Figures figures;
    figures.buildSeconds = secondsSince(begin);
    figures.effect = effect.name;
    figures.triangles = triangleCount(felt);
    figures.bytesPerTriangle = double(hierarchyBytes(**world)) / double(figures.triangles);
    const TouchTrace fastest = fastestOf(repetitions, **world, finger);
    figures.update = updateTimes(fastest);
    figures.rounds = meanRounds(fastest);
    if (judge) figures.exactness = test::exactnessOf(soupOf(felt), felt.proxyRadius, fastest);
    return figures;
}

std::size_t replayCounted(const Scene& scene, const Effect& effect, std::vector<FingerPoint> finger) {
    Scene felt = scene;
    effect.apply(felt);
    const auto world = compile(felt);
    if (!world) return 0;
    finger.resize(std::min(finger.size(), kCountedRows));
    CALLGRIND_START_INSTRUMENTATION;
    const TouchTrace rows = replay(**world, finger);
    CALLGRIND_STOP_INSTRUMENTATION;
    return rows.size();
}

} // namespace tactum::bench
