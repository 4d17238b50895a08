// What a self-test does with a device and asks of the person who holds it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

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
    /// silent.
    virtual Result<std::vector<TrialRow>> run(double seconds, double limit, const TrialForce& force) = 0;
};

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
    /// True when it is done; false: the person leaves this out.
    virtual bool does(TrialAsk what, const std::string& words) = 0;
    /// Gives up everything that is still to come.
    virtual bool leaves() const { return false; }
    /// kg, of what hangs on the handle; asked for before Hang.
    virtual std::optional<double> mass() = 0;
    /// What is done now, without the person.
    virtual void hears(const std::string& words) = 0;
};

} // namespace tactum
