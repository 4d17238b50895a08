#include "core/port/device_check.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/port/device_figures.h"

namespace tactum {
namespace {

std::string rangeFault(const char* name, double value, const char* unit, double least, double most) {
    std::string text = std::string("its ") + name + " is ";
    appendNumber(text, value);
    text += std::string(" ") + unit + ", and it must be from ";
    appendNumber(text, least);
    text += " to ";
    appendNumber(text, most);
    return text;
}

} // namespace

std::string impossibleFigure(const DeviceInfo& device) {
    for (const DeviceFigure& figure : kDeviceFigures)
        if (const double value = device.*figure.value;
            !(value >= figure.least && value <= figure.most)) // NaN is not
            return rangeFault(figure.name, value, figure.unit, figure.least, figure.most);
    if (device.buttons < 0 || device.buttons > kMaxButtons)
        return rangeFault("number of buttons", device.buttons, "", 0, kMaxButtons);
    return {};
}

Result<void> checkDevice(const DeviceInfo& device) {
    const std::string fault = impossibleFigure(device);
    if (fault.empty()) return {};
    return machineError("The device " + printable(device.name) + " cannot be used: its driver says that " +
                        fault + "; update the driver or choose another device.");
}

} // namespace tactum
