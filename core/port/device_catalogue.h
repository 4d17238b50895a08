// What devices there are, for a window that must not know the drivers.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum {

struct DeviceListing {
    std::string id; ///< names it in settings and on the command line: "falcon:1-4.2"; empty: only a remark
    std::string name;
    bool usable = false;
    std::string sentence;   ///< what it is and can do, or why it is not usable and what to do
    bool forbidden = false; ///< not usable because the system does not let this person use it
    std::string lacks{};    ///< a file of the person's own that it wants and has not: "firmware (*.bin)"

    bool operator==(const DeviceListing&) const = default;
};

/// The figures of a device that a maker's library drives, by what it calls itself; while that is not known,
/// "", those of its family. Thread: any but real time.
using FiguresOf = std::function<Result<DeviceInfo>(std::string_view model)>;

class DeviceCatalogue {
public:
    virtual ~DeviceCatalogue() = default;

    /// What is there at this moment, the built-in devices first. May take tens of milliseconds.
    /// Thread: any but real time, one at a time.
    virtual std::vector<DeviceListing> list() = 0;
    /// Not yet prepared. Thread: as list().
    virtual Result<std::unique_ptr<HapticDevice>> make(const std::string& id) = 0;
    /// Keeps a copy of the file that a device lacks where its driver finds it. The answer is a sentence of
    /// what it was and where it is now. Errors: another file than it wants. Thread: as list().
    virtual Result<std::string> supply(const std::string& id, const std::filesystem::path& file) = 0;
    /// Lays measured figures (the text of a profile) over those that are kept of the person for devices of
    /// this name, and so the next make() has them; what the text does not name stays, and what was kept
    /// before is kept beside it. The answer is a sentence of where they are. Errors: there is no such
    /// profile. Thread: as list().
    virtual Result<std::string> keepFigures(const std::string& name, const std::string& profile) = 0;
};

} // namespace tactum
