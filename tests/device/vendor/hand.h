// A servo for tests of drivers: one command again and again, a thousand times a second.
#pragma once

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/port/haptic_device.h"
#include "tests/support/patience.h"

namespace tactum::test {

struct Hand {
    explicit Hand(HapticDevice& theDevice, const Vec3& theForce = Vec3::Zero())
        : device(theDevice), force(theForce) {}

    void tick() {
        last = device.exchange({force}, 1e-3);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    void forTicks(int ticks) {
        for (int i = 0; i < ticks; ++i)
            tick();
    }
    /// Ticks until it is so; false when it never is.
    bool until(const std::function<bool()>& isSo) {
        for (Patience patience; !patience.isOver();) {
            tick();
            if (isSo()) return true;
        }
        return false;
    }

    HapticDevice& device;
    Vec3 force;
    DeviceSample last;
};

/// Notes what the wizard would show.
struct Watcher final : Opening {
    void begin(std::string_view step, std::string_view what) override {
        if (steps.empty() || steps.back() != step) steps.emplace_back(step);
        request = what;
        if (onRequest && !what.empty()) onRequest(what);
    }
    void progress(double part) override { parts.push_back(part); }
    bool cancelled() const override { return givesUp; }

    std::vector<std::string> steps;
    std::string request;
    std::vector<double> parts;
    std::function<void(std::string_view)> onRequest;
    bool givesUp = false;
};

} // namespace tactum::test
