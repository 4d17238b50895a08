// Whether a Force Dimension device pushes at all: its own safety takes the forces away without an error, and
// commands go on to succeed.
#pragma once

#include <atomic>
#include <string>

#include "device/vendor/dhd_api.h"

namespace tactum::dhd {

/// Looks at the device's status now and then, and gives the forces back where a machine took them, not a
/// person: at zero command, half a second after, so that whatever ran away has come to rest.
class ForceOutput {
public:
    /// Forces on, as open() has just switched them.
    void begin() noexcept;
    /// Once an exchange. False: they are off, or nobody can tell. The caller commands zero then, before and
    /// after. Thread: the servo's, real time but for the transfers of the library.
    bool look(const Api& api, char id) noexcept;
    /// Of the last look; kNoError when it went well. Thread: as look().
    int error() const noexcept { return error_; }
    /// Empty while they are on. Thread: any but real time.
    std::string trouble() const;

private:
    void takeIn(const Api& api, char id, const int* status) noexcept;

    static constexpr int kOn = -2; ///< no ForceOff
    std::atomic<int> off_{kOn};    ///< a ForceOff
    int exchanges_ = 0;            ///< since the last look
    int looks_ = 0;                ///< since they are off
    int error_ = kNoError;
};

} // namespace tactum::dhd
