// Where a window's haptic server is, and how the window is called there.
#pragma once

#include <string>

namespace tactum {

struct RemoteSettings {
    std::string target{};               ///< HOST:PORT
    std::string name = "window";        ///< for the other clients
    std::string certificate{}, token{}; ///< of a server on another machine: PEM, and its token
    double stateRate = 60;              ///< Hz
    double patience = 5;                ///< s, that start() waits for an answer
};

} // namespace tactum
