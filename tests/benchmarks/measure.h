// One mesh under one finger: everything that the tables say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/haptics/replay.h"
#include "core/scene/finger_path.h"
#include "core/scene/scene.h"
#include "tests/support/exactness.h"

namespace tactum::bench {

/// A feel that is measured: what it sets on a scene that is smooth otherwise.
struct Effect {
    const char* name;
    void (*apply)(Scene& scene);
};

/// Smooth first; then one effect at a time.
const std::vector<Effect>& effects();

struct Figures {
    std::string mesh, effect;
    std::size_t triangles = 0;
    double loadSeconds = 0, buildSeconds = 0;
    double bytesPerTriangle = 0;              ///< of the hierarchy
    UpdateTimes update;                       ///< of each row's fastest repetition
    double rounds = 0;                        ///< of move and update, mean
    std::optional<double> instructions;       ///< an update, mean
    std::optional<test::Exactness> exactness; ///< only where the proxy is frictionless
};

/// Compiles the scene with the effect and replays the finger that many times. Prints nothing.
Result<Figures> measure(const Scene& scene, const Effect& effect, const std::vector<FingerPoint>& finger,
                        int repetitions, bool judge);

/// The first rows of a replay, for a tool that counts instructions; nothing is measured here.
/// Returns how many updates ran.
std::size_t replayCounted(const Scene& scene, const Effect& effect, std::vector<FingerPoint> finger);

} // namespace tactum::bench
