// A serial port of the system: lines out and bytes in, without ever waiting.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// Thread of a member: where it does not say otherwise that of the servo, one at a time.
class SerialPort {
public:
    /// Raw, 115,200 baud, for nobody else. Errors: not there, not allowed, no serial port.
    /// Thread: any but real time.
    static Result<std::unique_ptr<SerialPort>> open(const std::filesystem::path& file);
    /// What has not gone out after a tenth of a second never does. Thread: any but real time.
    ~SerialPort();
    SerialPort(const SerialPort&) = delete;
    SerialPort& operator=(const SerialPort&) = delete;

    /// At most 128 bytes. A line that the system takes in part goes on with the next call, so that two lines
    /// never become a third one; false: this one was not taken.
    bool send(std::string_view line) noexcept;
    /// What has come, at most as much as there is room for.
    std::string_view receive(std::span<char> room) noexcept;
    /// Pulled out: nothing will ever come. Thread: any.
    bool gone() const noexcept { return gone_; }
    /// Past whatever is under way. Thread: any, also a signal handler; async-signal-safe.
    void sendNow(std::string_view line) const noexcept;

private:
    explicit SerialPort(int descriptor) : descriptor_(descriptor) {}
    long put(std::string_view bytes) noexcept;

    int descriptor_;
    std::array<char, 128> rest_{};
    std::size_t restSize_ = 0;
    std::atomic<bool> gone_{false};
};

} // namespace tactum
