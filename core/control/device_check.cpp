#include "core/control/device_check.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/device_figures.h"

namespace tactum {
Result<void> checkDevice(const DeviceInfo& device) {
    for (const DeviceFigure& figure : kDeviceFigures) {
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
