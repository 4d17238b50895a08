// How long a test waits for what has to come: however slow the machine is, and no longer than that.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace tactum::test {

/// How long somebody has waited for a processor since the machine was started, in s, as the kernel counts it;
/// negative where it does not.
inline double crowdedFor() {
    std::FILE* const file = std::fopen("/proc/pressure/cpu", "r");
    if (!file) return -1;
    long long micros = -1;
    const int found = std::fscanf(file, "some %*s %*s %*s total=%lld", &micros);
    std::fclose(file);
    return found == 1 ? 1e-6 * double(micros) : -1;
}

/// For one wait. Only time in which the processors had room for everybody wears it out. Who waited in vain
/// once has failed: what comes after it in the same program waits less, so that a cause that all share is
/// told soon.
class Patience {
public:
    bool isOver() {
        const bool crowded = crowdedBefore_ >= 0;
        const double passed = std::chrono::duration<double>(Clock::now() - begun_).count();
        const double most = ranOut() ? kMaxAgain : kMax;
        const double room = crowded ? (ranOut() ? kRoomAgain : kRoom) : most;
        if (passed < std::min(room, most)) return false;
        if (passed < most && crowded && passed - (crowdedFor() - crowdedBefore_) < room) return false;
        return ranOut() = true;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr double kRoom = 15, kRoomAgain = 3; ///< s, in which nobody waited for a processor
    static constexpr double kMax = 60, kMaxAgain = 15;  ///< s

    /// Whether a wait of this program was in vain.
    static bool& ranOut() {
        static bool is = false;
        return is;
    }

    Clock::time_point begun_ = Clock::now();
    double crowdedBefore_ = crowdedFor();
};

/// True as soon as the condition holds, false when it did not for as long as Patience has. Handles no events.
template <class Condition> bool eventually(Condition condition) {
    for (Patience patience; !condition(); std::this_thread::sleep_for(std::chrono::milliseconds(1)))
        if (patience.isOver()) return condition();
    return true;
}

} // namespace tactum::test
