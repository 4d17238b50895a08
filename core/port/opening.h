// Who watches a device being made ready: the window's wizard, the command line, a test.
#pragma once

#include <string_view>

namespace tactum {

/// Thread of its members: the one that prepares the device, a worker.
class Opening {
public:
    virtual ~Opening() = default;

    /// The next step begins, one of HapticDevice::steps(). `request`: what the person has to do now, a
    /// sentence; empty when only to wait. May be called again for the same step with another `request`.
    virtual void begin(std::string_view step, std::string_view request = {}) = 0;
    /// How much of the step is done, 0 to 1.
    virtual void progress(double part) = 0;
    /// The person gives up: end soon, with zero force.
    virtual bool cancelled() const = 0;
};

/// Nobody watches: what needs a person's hand fails with its sentence instead of waiting.
class Unattended final : public Opening {
public:
    void begin(std::string_view, std::string_view) override {}
    void progress(double) override {}
    bool cancelled() const override { return true; }
};

} // namespace tactum
