// What acts on the bodies of tactum simulate from outside: the pushes of the command line, and the keys of
// bodies that an animation leads.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "core/dynamics/dynamics.h"
#include "core/dynamics/lead.h"
#include "core/scene/scene.h"

namespace tactum {

/// What tables call each body: its name, and where another one before it has that, a number behind it that
/// makes it one that nobody has.
std::vector<std::string> tableNames(const std::vector<RigidBody>& bodies);

/// Pushes, each at a material point that is known once its time has come.
class Pushes {
public:
    /// Refers to all of them.
    Pushes(const std::vector<PushOption>& given, const Mechanism& mechanism, const Mechanics& mechanics)
        : given_(given), mechanism_(mechanism), mechanics_(mechanics), names_(tableNames(mechanism.bodies)),
          places_(given.size()) {}

    /// How much of a step from `time` on goes by before the first of them begins or ends, s.
    double untilChange(double time, double dt) const;
    /// Those that act from `time` on, until one begins or ends.
    const std::vector<AppliedForce>& at(double time, double dt, Dynamics& dynamics,
                                        const DynamicState& state);
    /// Those that met no body.
    std::size_t missed() const;
    /// A line for each that met its body only from afar.
    std::vector<std::string> strays() const;

private:
    struct Found {
        bool looked = false, found = false;
        Place place;
        double distance = 0; ///< m, from the point to what is pushed
        std::string body;
    };

    Found find(const PushOption& push, Dynamics& dynamics, const DynamicState& state) const;

    const std::vector<PushOption>& given_;
    const Mechanism& mechanism_;
    const Mechanics& mechanics_;
    std::vector<std::string> names_; ///< of the bodies
    std::vector<Found> places_;
    std::vector<AppliedForce> acting_;
};

/// Bodies that nothing moves but the keys of an object which moves with them.
class KeyedBodies {
public:
    /// Refers to the mechanism.
    KeyedBodies(const Scene& scene, const Mechanism& mechanism);

    /// They begin with the speed of their keys.
    void start(DynamicState& state);
    /// They will be where their keys have them after the next dt.
    void lead(double time, double dt, DynamicState& state);

private:
    struct Keyed {
        std::size_t body = 0; ///< of the mechanism
        std::shared_ptr<const Motion> motion;
        Pose rest, offset; ///< of the object at the time 0; of the body in the frame of the object
        Pose at(double time) const { return rest * motion->at(time) * offset; }
    };

    Leader leader_;
    std::vector<Keyed> all_;
    std::vector<Leader::Led> led_;
};

} // namespace tactum
