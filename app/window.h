// The windowed program: puts device, engine, document and window together.
#pragma once

#include <filesystem>
#include <optional>

namespace tactum {

/// Opens the window, on a scene when one is given, and runs until it is closed. Returns the exit code.
/// Thread: main, before any Qt application exists.
int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& scene);

} // namespace tactum
