// Gamepads that vibrate, by SDL: which there are, and what one of them does.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/vibration/pad_motors.h"

namespace tactum {

struct Pad {
    std::string key;  ///< of this one, from day to day; of two of one kind without a number of their own the
                      ///< second has another
    std::string name; ///< for a person

    bool operator==(const Pad&) const = default;
};

/// All of SDL is on a thread of its own, without urgency: to open a pad and to speak to it may take a while,
/// and nobody waits for that. Only what was asked for last is played, and for no longer than kLasts, so that
/// neither a window that hangs nor one that has nothing more to say leaves a motor turning. Thread: ui.
class Pads {
public:
    static constexpr int kLasts = 150; ///< ms

    /// Begins to look. `told` hears of all that vibrate, in the order in which they came, whenever that
    /// changes, and once at first; on the other thread.
    explicit Pads(std::function<void(std::vector<Pad>)> told);
    /// The motors stand still before it returns.
    ~Pads();

    /// The one that plays, by its key; while it is not there, or for an empty key, the first.
    void use(const std::string& key);
    /// Never waits.
    void play(const MotorStrengths& strengths);

private:
    struct Opened;

    void run();
    void look();
    void add(int index);
    void remove(int instance);
    void tell();
    void drive();
    Opened* used();

    const std::function<void(std::vector<Pad>)> told_;
    std::atomic<std::uint32_t> strengths_ = 0; ///< of low and high, 16 bits each
    std::atomic<std::int64_t> until_ = 0;      ///< ns of the steady clock; then they count no more
    std::mutex mutex_;                         ///< of what follows
    std::condition_variable ends_;
    bool end_ = false;
    std::string key_;
    // On the other thread alone.
    std::vector<Opened> opened_;
    int driven_ = -1; ///< instance of the one that plays
    std::thread thread_;
};

} // namespace tactum
