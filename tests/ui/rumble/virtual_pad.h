// A gamepad that is not there: SDL lists it as any other, and what its motors are told is noted.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace tactum {

/// Of SDL's own making; what stands behind SDL_JoystickRumble() is the test's. Thread: any, one.
class VirtualPad {
public:
    /// What the motors were told: 0 to 1, and when, in s of the steady clock.
    struct Told {
        double t, low, high;
    };

    /// It is plugged in. `kind` is as its maker's number: two of one are alike. Without motors it is a
    /// joystick as many are.
    explicit VirtualPad(const char* name, std::uint16_t kind = 1, bool motors = true);
    ~VirtualPad(); ///< unplugs it
    void unplug();

    /// Each change, oldest first.
    std::vector<Told> told() const;
    /// The last one; zero before the first.
    Told last() const;

private:
    struct Motors;

    std::unique_ptr<Motors> motors_;
    int instance_ = -1;
};

} // namespace tactum
