// A World that Python steps: the compiled scene, with the one finger that is in it.
#pragma once

#include <memory>
#include <mutex>
#include <optional>

#include "app/python/run_record.h"
#include "core/haptics/body_places.h"
#include "core/haptics/haptic_step.h"
#include "core/haptics/replay.h"

namespace tactum::python {

/// Where the finger goes in one step. World frame, SI.
struct FingerMove {
    Vec3 finger = Vec3::Zero();
    double dt = 1e-3;             ///< s, > 0
    std::optional<Vec3> velocity; ///< else the way since the step before, over dt
};

/// One step after the other through the very function that the loops, the tests and `tactum touch` call.
/// Thread: one at a time, without the GIL; who comes while another one steps is refused (Turn).
class LiveWorld {
public:
    LiveWorld(std::shared_ptr<const World> world, bool records);

    /// The right to step. Failure while another thread has it.
    class Turn {
    public:
        explicit Turn(LiveWorld& of);

    private:
        std::unique_lock<std::mutex> lock_;
    };

    HapticOutput step(const FingerMove& move);
    /// Every point of a path; the first one comes a millisecond after the beginning, as in replay(), or at
    /// its time where there were steps before. Error: cancelled, or a path that begins before now.
    Result<TouchTrace> follow(const std::vector<FingerPoint>& path, const Progress& progress);
    /// Goes on in another World: contacts stay where the shape did.
    void enter(std::shared_ptr<const World> world);
    /// As it was at first, in the World of now.
    void restart();

    /// Where the last step has put each object that forces move. Before the first one: none.
    std::vector<PlacedObject> places() const;
    /// How a body moved in the last step, while the finger touched as it did. Failure for one that no force
    /// moves.
    BodyReading readingOf(BodyId body);

    const std::shared_ptr<const World>& world() const { return world_; }
    double time() const { return time_; }
    /// Failure where it does not record.
    Recording recording(const std::string& reason) const;

private:
    std::shared_ptr<const World> world_;
    std::unique_ptr<SimState> state_ = std::make_unique<SimState>(); // large
    std::optional<Vec3> before_;                                     ///< the finger of the last step
    HapticOutput felt_;                                              ///< in it
    std::optional<BodyPlaces> readings_;                             ///< of the World of now; made when asked
    double time_ = 0;                                                ///< s at the end of the last step
    std::optional<RunRecord> record_;
    std::mutex turn_;
};

} // namespace tactum::python
