// The serial port of a board that a test emulates: a pseudo-terminal behind a name that stays, as a link of
// udev's, while the board is pulled out and plugged in again.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <thread>

#include <QTemporaryDir>

namespace tactum::test {

/// Drivers find it by an environment variable, and some call the device by its name. Who owns it pulls it out
/// before anything that the board's step uses goes.
class BoardPort {
public:
    BoardPort(const char* variable, const char* name);
    ~BoardPort();
    BoardPort(const BoardPort&) = delete;
    BoardPort& operator=(const BoardPort&) = delete;

    /// `step` runs over and over on a thread of its own, until it is pulled out.
    void plug(std::function<void()> step);
    void unplug();
    const std::filesystem::path& path() const { return path_; }
    /// Of the pseudo-terminal: what the host has set is seen there.
    int master() const { return master_; }

    /// What the host has sent: what came within `patience`, or nothing.
    std::string_view hear(std::chrono::microseconds patience);
    /// To the host. A port that takes nothing ends the test.
    void say(std::string_view bytes) const;

private:
    const char* variable_;
    QTemporaryDir folder_;
    std::filesystem::path path_; ///< a link to the pseudo-terminal of the day
    int master_ = -1;
    std::array<char, 256> heard_{};
    std::thread thread_;
    std::atomic<bool> ends_{false};
};

} // namespace tactum::test
