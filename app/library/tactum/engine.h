// Devices that render a scene: the loops of the program, their safety, and the simulated hand.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tactum/error.h>
#include <tactum/export.h>
#include <tactum/step.h>
#include <tactum/vec.h>

namespace tactum::library {

class Scene;

/// A device that there is, or a remark about those that there are not.
struct Device {
    std::string id; ///< what Engine takes; empty: only a remark
    std::string name;
    bool usable = false;
    std::string sentence; ///< what it is, or why it is not usable and what to do
};

/// What is connected at this moment, usable ones first; "simulated" is always there. May take seconds: the
/// makers' libraries are asked too. Thread: any but real time, one at a time.
TACTUM_API std::vector<Device> devices();

/// Where the device's workspace lies in the scene.
struct Workspace {
    double scale = 1; ///< metres of the scene to a metre of the device, from 1e-3 to 1e4
    Vec3 offset{};    ///< m, of the device's centre
};

/// What the loops did last. World frame, SI.
struct EngineState {
    Vec3 finger;
    Vec3 proxy;
    Vec3 force;      ///< N, that the device was sent
    double gain = 0; ///< of the force: 0 none, 1 all
    /// Why there is no force, or less of it, in a few words; those of the program.
    const char* why = "";
    bool fault = false;         ///< it stays so until it is disarmed and armed again
    std::uint32_t buttons = 0;  ///< of the handle, a bit for each that is held
    std::uint64_t ticks = 0;    ///< of the servo
    std::uint64_t updates = 0;  ///< of the proxy
    std::uint64_t misses = 0;   ///< ticks that came more than one period late
    double rate = 0;            ///< Hz, of the servo over the last half second
    double updateMicros = 0;    ///< us, that an update of the proxy takes, the mean over it
    std::uint32_t contacts = 0; ///< of `contact`
    std::array<Contact, kMostContacts> contact{};

    std::span<const Contact> touched() const noexcept {
        return std::span(contact).first(contacts < kMostContacts ? contacts : kMostContacts);
    }
};

class Hand;

/// Drives devices against a scene, each of which is a hand. The loops run on threads of their own, as urgent
/// as the account is allowed; nothing here holds them up. Thread of every member, and of those of its hands:
/// any but real time, one at a time.
class TACTUM_API Engine {
public:
    /// `device`: an id of devices(). Error: there is none of this id, or it is not there any more.
    explicit Engine(const std::string& device = "simulated");
    Engine(Engine&& other) noexcept;
    Engine& operator=(Engine&& other) noexcept;
    ~Engine(); ///< as close()

    /// One more hand. Loops that run stop and start again, without force. Error: as of the constructor; there
    /// are four already; or the device's sentence, after which open() would try again with it.
    void addHand(const std::string& device);
    std::size_t hands() const;
    /// i < hands(); valid as long as the engine, wherever that is moved. Error: there is none.
    Hand hand(std::size_t i);

    /// Opens the devices and starts the loops, without force. Error: a device's sentence.
    void open();
    /// No force, the loops ended, the devices closed. Error: a device that does not come back. Safe to call
    /// twice.
    void close();
    bool isOpen() const;

    // Of the first hand, unless another thing is said.

    std::string deviceName() const;
    double maxForce() const; ///< N; no command exceeds it
    /// Why the device sends nothing that can be used, with what to do; empty while all is well.
    std::string trouble() const;
    /// What was granted of real-time priority, or why not and what helps.
    std::string priority() const;

    /// The scene as it is now is felt from the next update on, before or after open(). Contacts and friction
    /// stay where no shape changed. Error: a scene that cannot be touched; the one before stays then.
    void publish(const Scene& scene);
    /// Force of all hands on, which comes gently; off at once. Off is also the state after open(). A fault
    /// needs off and on again.
    void arm(bool on = true);
    bool armed() const;
    /// Error: what cannot be.
    void place(const Workspace& workspace);
    /// Adds a force, N, under all limits. Said again within 0.1 s, or it fades.
    void push(const Vec3& force);
    /// Puts the proxy onto the finger: after a jump of the hand.
    void restartProxy();
    /// Where the simulated hand goes, m in the frame of the device, in so many s with the least jerk. Nothing
    /// with another device.
    void leadHand(const Vec3& to, double seconds = 0);

    /// The newest there is. Call it some ten times a second or more: it also drops what the loops no longer
    /// use.
    EngineState state();

private:
    friend class Hand;
    struct State;
    std::unique_ptr<State> state_;
};

/// One hand of an engine: each member as the one of Engine.
class TACTUM_API Hand {
public:
    std::string deviceName() const;
    double maxForce() const;
    std::string trouble() const;
    void arm(bool on = true);
    bool armed() const;
    void place(const Workspace& workspace);
    void push(const Vec3& force);
    void restartProxy();
    /// Where it goes, if it is a simulated one.
    void lead(const Vec3& to, double seconds = 0);
    /// Updates are those of all hands.
    EngineState state();

private:
    friend class Engine;
    Hand(Engine::State& engine, std::size_t index) : engine_(&engine), index_(index) {}

    Engine::State* engine_;
    std::size_t index_;
};

} // namespace tactum::library
