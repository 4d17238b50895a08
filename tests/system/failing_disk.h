// A disk that fails when a test wants it to: the calls of this program by which files are written go through
// failing_disk.cpp, which a test program links, on their way to the system.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactum::test {

struct DiskFault {
    enum class Kind {
        None,
        Fails,    ///< the call gives `error`
        Stays,    ///< it and all that come after it do
        Killed,   ///< the program is killed just before the call
        PowerCut, ///< so is the machine: only what was brought to the disk is there afterwards
    };
    Kind kind = Kind::None;
    int call = -1; ///< which one, from 0; -1 none
    int error = 0; ///< errno
    /// Of a power cut: whether names that were given since the folder was last brought to the disk are on it.
    bool namesSurvive = true;
    std::string missing =
        {}; ///< a call that this system does not know at all: it always gives `missingError`
    int missingError = 0;
    bool stutters = false; ///< writes take a thousand bytes at most, and signals interrupt every other call
};

/// From now on, until healDisk(), the calls of this thread are counted and fail as `fault` says. `folder`:
/// whose names a power cut may lose.
void spoilDisk(const DiskFault& fault, const std::filesystem::path& folder = {});
/// The calls that there were since, by name.
std::vector<std::string> healDisk();
/// Cuts the power now. Does not return.
[[noreturn]] void cutPower();

constexpr int kPowerWasCut = 86; ///< the exit code of a program whose machine lost its power

} // namespace tactum::test
