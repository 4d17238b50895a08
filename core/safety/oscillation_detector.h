// Notices a limit cycle: the finger shaken to and fro faster than a hand can.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/vec.h"

namespace tactum {

/// Counts half swings along each axis that are too fast for a hand (20 to 300 Hz) and 0.2 mm wide or more.
/// Three in a row, none below six tenths of the widest and a sixteenth of a second long together, are a limit
/// cycle. What a tap sets ringing dies away, a texture shakes less, a hand is slower. Frame D, SI. Thread:
/// real time.
class OscillationDetector {
public:
    /// True once for each limit cycle, a tenth of a second after it began at the latest.
    bool operator()(const Vec3& position, double dt) noexcept;
    void forget() noexcept { *this = {}; }

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) { visit(self.axes_); }

private:
    struct Axis {
        double low = 0, high = 0; ///< of the swing that goes on, m
        double sinceTurn = 0;     ///< s, since the last turn was noticed
        double lastSwing = 0;     ///< m
        double widest = 0;        ///< m, of the half swings that count
        double lasted = 0;        ///< s, of them
        int halfSwings = 0;       ///< that count
        int direction = 0;        ///< +1 rising, -1 falling, 0 not known yet
        bool begun = false;

        static void fields(auto& visit, auto& self) {
            visit(self.low, self.high, self.sinceTurn, self.lastSwing, self.widest, self.lasted,
                  self.halfSwings, self.direction, self.begun);
        }
        bool add(double x, double dt) noexcept;
        void turn(double swing, double dt) noexcept;
    };
    std::array<Axis, 3> axes_{};
};

} // namespace tactum
