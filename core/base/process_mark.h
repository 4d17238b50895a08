// Which run of which program something belongs to, and whether that run is still going on.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tactum {

/// Tells one run of a program from every other. A process id alone does not: it is given again after a while,
/// and another machine, or another container, has the same ones.
struct ProcessMark {
    std::string host;  ///< name of the machine; letters, digits, '-' and '.'
    std::string boot;  ///< of this start of the machine
    std::string space; ///< in which the ids are given: a container has its own
    std::uint64_t pid = 0;
    std::uint64_t began = 0; ///< clock ticks after the start of the machine

    bool operator==(const ProcessMark&) const = default;
};

/// Of the process that asks. Thread: any but real time.
ProcessMark ownMark();

/// As a part of a file name, without '_' inside its five parts, and back.
std::string nameOf(const ProcessMark& mark);
std::optional<ProcessMark> markNamed(std::string_view name);

/// Whoever leaves a mark where other machines see it shows this often that it is alive; one that was silent
/// for `kSilence` counts as ended.
inline constexpr std::chrono::seconds kSignOfLife{120}, kSilence{600};

/// Whether that run has ended. On this machine the system knows; elsewhere only the last sign of life tells.
/// Thread: any but real time.
bool hasEnded(const ProcessMark& mark, std::filesystem::file_time_type lastSign);

} // namespace tactum
