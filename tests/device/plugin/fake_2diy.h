// The board and the arms of a Haply 2DIY behind a pseudo-terminal, as Haply's hAPI speaks to it
// (device_set_parameters() and device_write_torques() of its Python and C++ editions, version 3 of the
// device): it knows where the handle is and turns that into angles by the law of cosines, where the driver
// turns angles into a place by crossing circles.
//
// That it is wrong itself would be shown by a board that hAPI's own programs do not move.
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <vector>

#include "core/base/vec.h"
#include "tests/device/serial/board_port.h"

namespace tactum::test {

class Fake2diy {
public:
    /// Plugged in; its port is found by the driver through HAPLY_2DIY.
    Fake2diy();
    ~Fake2diy();
    Fake2diy(const Fake2diy&) = delete;
    Fake2diy& operator=(const Fake2diy&) = delete;

    /// Of the handle from the middle of the workspace, m; frame D, whose y the arms do not have.
    void hold(const Vec3& position);
    /// N, frame D, of the newest torques.
    Vec3 pushed() const;
    /// Packets that hAPI would not send.
    int complaints() const { return complaints_; }

    void unplug();
    void plug();

private:
    void step();
    void takeWholePackets();
    void answer() const;

    BoardPort port_{"HAPLY_2DIY", "haply"};
    std::atomic<int> complaints_{0};
    std::vector<unsigned char> bytes_; ///< of the thread, as the next
    bool reset_ = false, wired_ = false;

    mutable std::mutex mutex_; ///< of the two below
    Vec3 handle_ = Vec3::Zero();
    std::array<float, 2> torques_{}; ///< N m, of the left motor and the right one
};

} // namespace tactum::test
