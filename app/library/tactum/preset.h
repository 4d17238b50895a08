// A named feel that can be given to any surface.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <tactum/export.h>

namespace tactum::library {

/// Immutable; copies share what they hold, and what is moved from is a copy. Thread: any but real time.
class TACTUM_API Preset {
public:
    /// Of a name that presets() lists, or of a file *.tactum-preset. Error: there is none, or the file is at
    /// fault.
    explicit Preset(const std::filesystem::path& nameOrFile);
    Preset(const Preset&) = default;
    Preset& operator=(const Preset&) = default;

    /// What people call it.
    std::string name() const;
    /// What of the file could not become a part of it, a sentence each.
    std::vector<std::string> notes() const;

private:
    friend struct Parts;
    struct State;
    std::shared_ptr<const State> state_;
};

/// The names of those that come with the library, sorted. Thread: any but real time.
TACTUM_API std::vector<std::string> presets();

} // namespace tactum::library
