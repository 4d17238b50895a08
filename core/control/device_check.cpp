#include "core/control/device_check.h"

#include <limits>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace tactum {
namespace {

struct Figure {
    const char* name;
    const char* unit;
    double DeviceInfo::*value;
    double least, most;
};

// What is far beyond every device is no device's figure: a wrong unit, or memory that nobody filled.
constexpr Figure kFigures[] = {
    {"rate", "Hz", &DeviceInfo::rate, kSlowestRate, kFastestRate},
    {"largest force", "N", &DeviceInfo::maxForce, 0, 1e4},
    {"continuous force", "N", &DeviceInfo::continuousForce, 0, 1e4},
    {"largest stiffness", "N/m", &DeviceInfo::maxStiffness, 0, 1e9},
    {"workspace radius", "m", &DeviceInfo::workspaceRadius, 0, 1e3},
    {"position resolution", "m", &DeviceInfo::positionResolution, 0, 1},
    {"damping", "N s/m", &DeviceInfo::damping, 0, 1e6},
    {"damping of the hand", "N s/m", &DeviceInfo::handDamping, 0, 1e6},
    {"dry friction", "N", &DeviceInfo::dryFriction, 0, 1e4},
    {"amplifier lag", "s", &DeviceInfo::amplifierLag, 0, 1},
    {"delay", "ticks", &DeviceInfo::delay, 0, 100},
    {"trip speed", "m/s", &DeviceInfo::tripSpeed, 1e-3, 1e3},
};

} // namespace

Result<void> checkDevice(const DeviceInfo& device) {
    for (const Figure& figure : kFigures) {
        const double value = device.*figure.value;
        if (value >= figure.least && value <= figure.most) continue; // NaN is not
        std::string text = "The device " + printable(device.name) +
                           " cannot be used: its driver says that its " + figure.name + " is ";
        appendNumber(text, value);
        text += std::string(" ") + figure.unit + ", and it must be from ";
        appendNumber(text, figure.least);
        text += " to ";
        appendNumber(text, figure.most);
        return machineError(text + "; update the driver or choose another device.");
    }
    return {};
}

} // namespace tactum
