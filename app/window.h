// The windowed program: puts device, engine, document and window together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace tactum {

struct WindowRequest {
    std::optional<std::filesystem::path> scene; ///< to open
    std::string connect;                        ///< HOST:PORT of a haptic server; empty: the device is here
    std::filesystem::path credentials;          ///< folder of its certificate.pem and token; empty: none
};

/// Opens the window, and runs until it is closed. Returns the exit code.
/// Thread: main, before any Qt application exists.
int runWindow(int argc, char** argv, const WindowRequest& request);

} // namespace tactum
