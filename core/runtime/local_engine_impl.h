// What LocalEngine is made of. Private to its files.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/loop/realtime_thread.h"
#include "core/runtime/local_engine.h"
#include "core/runtime/servo_loop.h"

namespace tactum {

struct LocalEngine::Impl {
    /// Whether a counter goes on rising, as far as somebody looks.
    struct Beats {
        static constexpr std::int64_t kPatience = 500'000'000; ///< ns
        std::uint64_t seen = 0;
        std::int64_t since = 0; ///< ns, when it was first seen like that; 0: never
        bool still = false;

        bool stand(std::uint64_t count) {
            const std::int64_t now = monotonicNanoseconds();
            if (count != seen || since == 0) since = now;
            seen = count;
            return still = now - since > kPatience;
        }
    };
    struct PastScene {
        double until = 0; ///< s on the recorder's clock, when the next one came; 0: it is the present one
        RecordedScene recorded;
    };

    /// A device, its servo, and what the person decided for them.
    struct Side {
        explicit Side(std::unique_ptr<HapticDevice> theDevice) { take(std::move(theDevice)); }

        void take(std::unique_ptr<HapticDevice> another) {
            device = std::move(another);
            info = device->info();
            grasped = false;
            motors = {};
        }

        std::unique_ptr<HapticDevice> device;
        DeviceInfo info;
        DeviceWatchdog watchdog;
        RealtimeThread thread;
        LeftHeat motors; ///< of the device; the servo's while it runs
        Workspace workspace;
        bool deadMan = false;
        bool grasped = false;
        bool stuck = false; ///< its servo did not come back
        TouchTelemetry touch;
        ServoTelemetry servo;
        Beats beats;
    };
    std::vector<std::unique_ptr<Side>> sides; ///< one for each hand
    std::size_t spoken = 0;                   ///< whom the engine speaks of
    std::shared_ptr<Channels> channels;       ///< fresh at every start
    /// Every World that a loop may still see, oldest first; the last is the one to feel.
    std::vector<std::shared_ptr<const World>> kept;
    std::uint64_t publishedAfter = 0; ///< updates
    std::deque<PastScene> past;       ///< of the last minute, oldest first
    RealtimeThread proxyThread;
    std::optional<AwakeProcessors> awake; ///< while a real device is used
    /// By the device's name: who pulls a hot device out and puts it back has a hot device.
    std::map<std::string, LeftHeat> heat;
    double pace = 1;
    bool running = false;
    bool realtime = false;
    std::string priorityNote = "The loops have not been started.";
    ProxyTelemetry proxy;
    Beats proxyBeats;

    Result<void> openDevices();
    Result<void> startWatchdogs();
    Result<void> startLoops();
    Urgency leastUrgency() const;
    bool endLoops();
    void keepHeat();
    void handOver();
    void release(const World* world);
    void releaseRetired();
    void freshChannels();
    void remember(const World& world);
    void askForButton(std::size_t hand);
    void pollHand(std::size_t hand);
    void tellSpoken();
    double fastest() const;
    bool hasRealDevice() const;
};

} // namespace tactum
