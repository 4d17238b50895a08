// The board and the arm of a Polhem behind a pseudo-terminal, as its maker's firmware and programs have them:
//   Of2020: polhem_teensy.ino in forsslund/polhemstylus, tmp/winworks-2020-11-04: a buffer of 64 bytes,
//   answers of
//     63, no force after 0.1 s without a line that it understands, nor with a motor's current above 6 A;
//   Of2021: the same with answers of 64 bytes, as uhaptikfabriken.h 0.2 of 2021-03-23 reads them;
//   Of2023: hfab_protocol.h and hfab_serial.cpp of forsslund/hfabapi 0.5, as of 2026-06. Its firmware is not
//     published: what is here takes what lies between brackets, and keeps a current until it gets another
//     one.
// The arm goes from where the finger is to its angles, by crossing circles from the finger inward, where the
// driver goes from the angles outward; its weight is the slope of its height over places, not over angles.
//
// The maker's own programs move it: API 0.5 with the newer firmware, micro API 0.2 with that of 2021,
// unchanged and compiled against a pseudo-terminal of it, say where it is, how the stylus points and what it
// is pushed with, to what their numbers hold (2026-11-27). What would show that it is wrong is a real board.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

#include "core/base/vec.h"
#include "tests/device/serial/board_port.h"

namespace tactum::test {

class FakePolhem {
public:
    enum class Firmware { Of2020, Of2021, Of2023 };

    /// Plugged in; its port is found by the driver through TACTUM_POLHEM.
    explicit FakePolhem(Firmware firmware);
    ~FakePolhem();
    FakePolhem(const FakePolhem&) = delete;
    FakePolhem& operator=(const FakePolhem&) = delete;

    void hold(const Vec3& finger); ///< m, frame D, from the middle of the workspace
    /// rad: the wrist, about the forearm, bent, about the stylus; at first it is straight. The firmware of
    /// places does not know of the last.
    void turn(const Vec3& wrist);
    Vec3 forearm() const; ///< its direction, frame D
    /// N, frame D, on the finger: what is left of the motors' when they have lifted the arm. Without any
    /// current nobody is pushed, for the arm only hangs.
    Vec3 pushed() const;
    /// Lines that the maker's programs do not send, nor Tactum's greeting.
    int complaints() const { return complaints_; }

    void unplug();
    void plug();
    const std::filesystem::path& port() const { return port_.path(); }

    // What boards should not do. They hold for the next answers.
    std::atomic<bool> mute{false};       ///< answers nothing
    std::atomic<bool> inPieces{false};   ///< each answer in three pieces, after a while each
    std::atomic<int> model{1};           ///< of Of2023
    std::atomic<int> error{0};           ///< likewise
    void sayInstead(std::string answer); ///< every time; empty: no more

private:
    using Clock = std::chrono::steady_clock;

    void step();
    void takeByte(char byte);
    void takeLine();
    void takeCurrents();
    void answer();
    std::string placeAnswer() const;
    std::string countAnswer() const;

    const Firmware firmware_;
    BoardPort port_{"TACTUM_POLHEM", "polhem"};
    std::atomic<int> complaints_{0};
    std::string line_; ///< of the thread
    bool askedForPlaces_ = false;
    Clock::time_point understood_; ///< the last line

    mutable std::mutex mutex_; ///< of what follows
    Vec3 finger_ = Vec3::Zero();
    Vec3 wrist_ = Vec3::Zero();
    Vec3 force_ = Vec3::Zero();         ///< N, frame of the maker
    std::array<int, 3> milliamperes_{}; ///< of Of2023
    std::string instead_;
};

} // namespace tactum::test
