// A scene that a loop of one's own steps.
#pragma once

#include <memory>

#include <tactum/export.h>
#include <tactum/step.h>
#include <tactum/vec.h>

namespace tactum::library {

class Scene;

/// A scene compiled for touch, with the one finger that is in it. One thread steps it; another one may
/// meanwhile change what it is made of. Two Worlds have nothing to do with each other.
class TACTUM_API World {
public:
    /// Thread: any but real time. Error: a scene that cannot be touched.
    explicit World(const Scene& scene);
    World(World&& other) noexcept;
    World& operator=(World&& other) noexcept;
    ~World();

    /// The finger moves to `finger` (m) in `dt` (s, from 1e-6 to 1) at the velocity of this way: hapticStep,
    /// the function that the loops of the program call. The same steps give the same bits. What cannot be (a
    /// number that is not finite, another dt, a place farther than 1e6 m) changes nothing and gives no force.
    /// Thread: real time, one at a time. Neither allocates, locks, throws nor waits.
    Step step(const Vec3& finger, double dt = 1e-3) noexcept;
    /// The same at a velocity that was measured, m/s, up to 1e13.
    Step step(const Vec3& finger, const Vec3& velocity, double dt) noexcept;

    /// Begins anew at the next step: no contact, and bodies that move are where `time` (s) puts them.
    /// Thread: as step().
    void restart(double time = 0) noexcept;
    /// s, at the end of the last step. Thread: as step().
    double time() const noexcept;

    /// The scene as it is now is felt from one of the next steps on. Contacts and friction stay where no
    /// shape changed. Only what is new is compiled: a change of feel takes microseconds. Error: a scene that
    /// cannot be touched; the one before stays then. Thread: any but real time, one at a time, also beside
    /// step().
    void update(const Scene& scene);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tactum::library
