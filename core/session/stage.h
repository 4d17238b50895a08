// One scene on one or several devices, for several clients at once: revisions, the pen, heartbeats, and what
// happens as events.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "core/base/progress.h"
#include "core/haptics/body_places.h"
#include "core/port/hand_target.h"
#include "core/runtime/engine_report.h"
#include "core/runtime/local_engine.h"
#include "core/session/attendance.h"

namespace tactum {

/// What happened. The kinds are those of the protocol.
struct StageEvent {
    enum class Kind : std::uint8_t {
        Touch = 1,
        Leave,
        Pressed,
        Released,
        Force,
        Scene,
        Pen,
        PenAsked,
        Attends,
        Lost, ///< some that a client was too slow for; of the protocol alone
        Detent
    };
    Kind kind = Kind::Touch;
    std::int64_t at = 0;  ///< ns of monotonicNanoseconds()
    std::size_t hand = 0; ///< whose touch, button or force; of no other kind
    ObjectId object = 0;
    std::uint32_t button = 0;
    int detent = 0; ///< counted from where the joint's drive rests
    std::uint64_t revision = 0;
    std::string text{};   ///< safe to print
    std::string client{}; ///< whose doing it is; empty: of none
    ClientId only = 0;    ///< for this client alone; 0: for all
};

/// What one hand does.
struct StageHand {
    bool armed = false;
    std::string trouble; ///< HapticDevice::trouble()
    TouchTelemetry touch;
    ServoTelemetry servo;
    std::vector<ObjectId> objects; ///< of each contact of its touch
};

/// The newest of everything. SI, world frame.
struct StageState {
    std::int64_t at = 0;        ///< ns of monotonicNanoseconds()
    std::uint64_t revision = 0; ///< of the scene that is felt; 0: of none
    EngineReport engine;
    std::vector<StageHand> hands; ///< in the order of Stage::devices()
    std::vector<PlacedObject> bodies;
    std::vector<AtDetent> detents;
    std::size_t attending = 0;
    ClientId pen = 0;      ///< who has it; 0: nobody
    std::string penHolder; ///< its name
    std::string penAsker;  ///< who waits for it; empty: nobody
};

/// What a change did.
struct StageChange {
    std::uint64_t revision = 0;
    std::vector<ObjectId> added; ///< that were not there before, in their order
    std::uint64_t feltAfter = 0; ///< Engine::publishedAfter()
};

class Stage {
public:
    /// Called from the stage's thread, every millisecond while somebody attends. It may not wait.
    using Listener = std::function<void(const StageState&, std::span<const StageEvent>)>;
    /// A change of the scene: makes all of it or says why not. May be called again for a newer scene.
    using Edit = std::function<Result<void>(Scene&)>;

    /// `hand`: of the simulated hand, else null.
    Stage(std::unique_ptr<HapticDevice> device, std::shared_ptr<HandTarget> hand, Scene scene);
    /// One more, before start(). Errors: there are kMaxHands.
    Result<void> addHand(std::unique_ptr<HapticDevice> device, std::shared_ptr<HandTarget> hand);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Starts the loops, and after them the thread of the stage: forks before it has more than one thread.
    Result<void> start();
    /// The one before is not called any more when this returns.
    void listen(Listener listener);

    // Thread of all below: any but real time, several at once.

    struct Welcome {
        ClientId id = 0;
        std::string key;
        bool pen = false;
    };
    Result<Welcome> join(std::string_view name, bool wantsPen);
    /// What it held fades.
    void leave(ClientId id);
    void heard(ClientId id);
    ClientId whoHas(std::string_view key) const;
    bool hasPen(ClientId id) const;
    std::string penHolder() const; ///< its name; empty: nobody

    /// Changes the scene, whole or not at all, for who has the pen or finds it free. `base`: only if the
    /// scene is still of this revision; 0: whichever. What takes long, new shapes, happens beside everything
    /// else: until it is done the old scene is felt, and others may change it.
    Result<StageChange> change(ClientId who, std::uint64_t base, const Edit& edit,
                               const Progress& progress = {});
    struct Scenery {
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const World> world;
        std::uint64_t revision = 0;
    };
    Scenery scenery() const;

    /// Which hands an order is for; none: all of them.
    using OfHand = std::optional<std::size_t>;

    /// All force ends, now, whoever says so.
    void stop(ClientId who);
    /// Forces on or off; for who has the pen.
    Result<void> arm(ClientId who, bool on, OfHand of = {});
    Result<void> askForPen(ClientId who);
    Result<void> passPen(ClientId who, std::string_view name);
    /// Engine::push(), for who has the pen; from others, or on a hand that there is not, it is nothing.
    void push(ClientId who, std::size_t hand, const Vec3& force);
    /// For who has the pen: an order to the engine.
    Result<void> order(ClientId who, const std::function<void(Engine&)>& order);
    /// For who has the pen: an order to a hand, or to each. Errors: there is no such hand; the order's first.
    Result<void> order(ClientId who, OfHand of, const std::function<Result<void>(LocalEngine::Hand)>& order);
    /// For who has the pen: where a simulated hand goes. A jump is made once for each number that this
    /// client gives it.
    Result<void> leadHand(ClientId who, std::size_t hand, HandGoal goal);
    /// Engine::recorded().
    RecordedRun recorded() const;

    /// Of each hand, as they were when the loops started.
    const std::vector<DeviceInfo>& devices() const { return devices_; }
    bool armed() const; ///< any hand
    std::size_t attending() const;

private:
    struct Felt {
        std::uint64_t revision = 0;
        std::shared_ptr<const World> world;
    };

    double now() const;
    void run();
    void tick(StageState& state, std::vector<StageEvent>& events);
    void watchHearts();
    void watchContacts(std::size_t hand, const StageHand& now);
    void watchDevice(std::size_t hand, const ServoTelemetry& now);
    void watchDetents(const StageState& state);
    void fill(StageState& state);
    void fill(StageHand& state, LocalEngine::Hand hand, const World* felt);
    const Felt* feltNow(std::uint64_t worldRevision);
    void take(Scene scene, std::shared_ptr<const World> world);
    void say(StageEvent event);
    void letGo(const std::string& name, const std::string& what);
    std::string nameOf(ClientId id) const;

    mutable std::mutex mutex_; ///< of everything below, the engine too
    std::condition_variable wake_;
    LocalEngine engine_;
    std::vector<DeviceInfo> devices_;
    struct Side {
        explicit Side(std::shared_ptr<HandTarget> target) : lead(std::move(target)) {}

        std::shared_ptr<HandTarget> lead; ///< null: it leads itself
        struct Jump {
            ClientId who = 0;
            std::uint32_t theirs = 0, ours = 0; ///< its number to the client, and to the hand
        } jump;
        // As it was told last.
        std::vector<ObjectId> touched;
        std::uint32_t buttons = 0;
        InhibitReason why = InhibitReason::NotArmed;
    };
    std::vector<Side> sides_; ///< of each hand
    Attendance attendance_;
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const World> world_;
    std::uint64_t revision_ = 0;
    std::deque<Felt> felt_; ///< published and perhaps felt, oldest first
    std::unique_ptr<BodyPlaces> places_;
    std::uint64_t placesOf_ = 0;     ///< revision of the World
    std::vector<StageEvent> events_; ///< that were not told yet
    std::vector<AtDetent> detents_;
    std::uint64_t detentsOf_ = 0; ///< revision of the scene
    bool ending_ = false;
    std::mutex telling_; ///< of the listener, while it is called; taken alone
    Listener listener_;
    std::thread thread_;
};

} // namespace tactum
