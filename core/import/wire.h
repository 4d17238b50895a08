// What the program and its import process say to each other. For this folder only.
#pragma once

#include <cstddef>

namespace tactum::wire {

/// Open in the import process: a socket that keeps packets apart, and memory for the scene.
inline constexpr int kTalk = 3, kSceneMemory = 4;

/// The first byte of a packet. The program says Go once; the rest comes from the import process.
enum class Word : char {
    Go = 'g',       ///< the limits are set
    Lacks = 'l',    ///< then text: a protection that this machine does not have
    Progress = 'p', ///< then a double from 0 to 1
    Fault = 'f',    ///< then the Error::Kind in one byte, and its text
    Done = 'd'      ///< then the length of the scene as std::uint64_t
};
inline constexpr std::size_t kLongest = 8192; ///< bytes of a packet

/// The exit code of a process that was refused memory.
inline constexpr int kOutOfMemory = 17;

} // namespace tactum::wire
