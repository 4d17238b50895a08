// What a self-test does with a device and asks of the person who holds it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/self_test/words.h"

namespace tactum {

/// One tick. Frame D, SI.
struct TrialRow {
    double time = 0; ///< s, since the experiment began
    Vec3 position = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< that was commanded in this tick, before any delay
    std::uint32_t buttons = 0;
    bool valid = false; ///< something new was read
};

/// The force of the next tick, N, by the newest reading. Called in the device's loop: it neither allocates
/// nor waits.
using TrialForce = std::function<Vec3(const TrialRow& newest, const Vec3& velocity)>;

/// A device that experiments are made with. Thread of all members: one, not real time.
class TrialBench {
public:
    virtual ~TrialBench() = default;

    /// Runs so many seconds and gives all of their ticks. No force is longer than `limit` N. Between two
    /// calls the device has none. Errors: it is too fast, as when a motor of the wrong sign throws it; it is
    /// silent; its own button stopped it, unless `limit` is 0: what has no force is not stopped.
    virtual Result<std::vector<TrialRow>> run(double seconds, double limit, const TrialForce& force) = 0;
};

/// What is tried, in this order. kTrialParts names them for the person.
enum class TrialPart { Rest, Ruler, Motors, Dynamics, Weight, Buttons };
inline constexpr const char* kTrialParts[] = {trial_words::kRest,   trial_words::kRuler,
                                              trial_words::kMotors, trial_words::kDynamics,
                                              trial_words::kWeight, trial_words::kButtons};

/// What the person does next.
enum class TrialAsk {
    LetGo,  ///< nobody holds the handle, nothing hangs on it
    Zero,   ///< the handle at the beginning of a ruler
    Right,  ///< so far to the right of it (kRulerWay)
    Up,     ///< the same upwards
    Toward, ///< the same toward the person
    Hang,   ///< a known mass hangs on the handle
    Press   ///< each button once, while it runs
};

/// m, along the ruler.
inline constexpr double kRulerWay = 0.04;

class TrialPerson {
public:
    virtual ~TrialPerson() = default;
    /// The next part begins, which may have nothing to ask for.
    virtual void begins(TrialPart) {}
    /// True when it is done; false: the person leaves this out.
    virtual bool does(TrialAsk what, const TrialWords& words) = 0;
    /// Gives up everything that is still to come.
    virtual bool leaves() const { return false; }
    /// kg, of what the person can hang on the handle, at most `heaviest`; asked for before Hang. nullopt: it
    /// is left out.
    virtual std::optional<double> mass(double heaviest) = 0;
    /// What is done now, without the person.
    virtual void hears(const TrialWords& words) = 0;
};

} // namespace tactum
