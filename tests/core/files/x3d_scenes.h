// Random scenes under names that try to break a format: for writers.
#pragma once

#include "tests/core/surface/texture_rig.h"
#include "tests/support/random_scene.h"

namespace tactum::test {

inline const std::vector<std::string> kHostileNames{"",
                                                    "lid",
                                                    "lid",
                                                    "<a b=\"c\">&amp;'",
                                                    "]]>",
                                                    "-->",
                                                    "\"quoted\\\"",
                                                    "\x01\x02",
                                                    "\xFF\xFE\xC0",
                                                    "\xEF\xBF\xBF\xEF\xBF\xBE",
                                                    "na\nme\t\r",
                                                    "../../etc",
                                                    "CON",
                                                    "1",
                                                    "T\xC3\xA4sse",
                                                    "${x}",
                                                    "a|b `c` *d*",
                                                    std::string(500, 'x'),
                                                    std::string("nul\0byte", 8)};

inline Image noiseImage(Rng& rng) {
    return imageOf(
        4 + int(rng() % 30), 4 + int(rng() % 30), [&](double, double) { return uniform(rng, 0, 1); },
        rng() % 2 ? 8 : 16);
}

inline std::shared_ptr<const Motion> randomMotion(Rng& rng) {
    Track<Vec3> slide;
    Track<QuatCoefficients> turn;
    slide.interpolation = Interpolation(rng() % 3);
    turn.interpolation = Interpolation(rng() % 3);
    double time = 0;
    for (int i = 0; i < 4; ++i, time += uniform(rng, 0.1, 1)) {
        slide.times.push_back(time);
        slide.values.push_back(inBox(rng, 0.05));
        turn.times.push_back(time);
        turn.values.push_back(Quat(Eigen::AngleAxisd(uniform(rng, 0, 3), direction(rng))).coeffs());
        for (auto* slopes : {&slide.arriving, &slide.leaving})
            if (slide.interpolation == Interpolation::CubicSpline) slopes->push_back(inBox(rng, 0.1));
        for (auto* slopes : {&turn.arriving, &turn.leaving})
            if (turn.interpolation == Interpolation::CubicSpline) slopes->push_back(QuatCoefficients::Zero());
    }
    return std::make_shared<const Motion>(makeMotion(slide, turn, rng() % 4 ? time : 0));
}

/// Repeats of at least 5 cm: pictures of finer ones would only take long.
inline void widen(TexturePattern& pattern) {
    pattern.size = std::max(pattern.size, 0.05);
    pattern.octaves = std::min(pattern.octaves, 3.0);
}

/// Any scene under hostile names, with textures that are quickly flattened.
inline Scene randomHapticScene(Rng& rng) {
    Scene scene = SceneDice(unsigned(rng())).scene();
    const auto rename = [&](std::string& name) { name = kHostileNames[rng() % kHostileNames.size()]; };
    for (SceneObject& object : scene.objects) {
        rename(object.name);
        for (Surface& surface : object.surfaces) {
            rename(surface.name);
            for (TextureLayer& layer : surface.layers) {
                rename(layer.name);
                widen(layer.pattern);
                if (layer.mask) widen(*layer.mask);
            }
        }
    }
    return scene;
}

} // namespace tactum::test
