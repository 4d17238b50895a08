// What lies beside the library: the process that reads files, and presets.
#pragma once

#include <filesystem>

namespace tactum::library {

/// tactum-import of this library, which both have to be of one version. Empty where there is none: then it is
/// that of the program, or of the tree that it was built from. Thread: any but real time.
std::filesystem::path importProcess();
/// The folder of the presets. Thread: any but real time.
std::filesystem::path presetFolder();

} // namespace tactum::library
