// The program that a Falcon is given each time its power comes on: the person's own copy, found and checked.
// Its licence does not let it be passed on, so that none comes with this program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace tactum {

struct FalconFirmware {
    std::vector<std::uint8_t> bytes;
    std::filesystem::path file;
    std::string name; ///< of one that is known by its fingerprint; empty: another one
};

/// How long a boot stream of the device's processor (TI 28x: key, entry point, blocks, a block of no length)
/// is by its own account. 0: it is none, or goes on after these bytes.
std::size_t bootStreamLength(std::span<const std::uint8_t> bytes);

/// Refuses a file that is no boot stream to its last byte. Thread: any but real time.
Result<FalconFirmware> readFalconFirmware(const std::filesystem::path& file);

/// Files, and folders with files *.bin, in the order in which they are looked at.
std::vector<std::filesystem::path> falconFirmwarePlaces();

/// The file that the person chose, else the one that TACTUM_FALCON_FIRMWARE names: these have to be good.
/// Else the first good one of the places; in a folder those that are known come first. The error says where
/// a person gets one and where to put it. Thread: any but real time.
Result<FalconFirmware>
findFalconFirmware(const std::filesystem::path& chosen,
                   const std::vector<std::filesystem::path>& places = falconFirmwarePlaces());

/// Copies a person's file to the first of the places, if it is firmware of a Falcon. The answer names the
/// copy. Thread: any but real time.
Result<FalconFirmware> keepFalconFirmware(const std::filesystem::path& file);

} // namespace tactum
