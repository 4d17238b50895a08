// A scene that others see and may change, too: what a window asks an engine at a haptic server beyond what
// every engine tells.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace tactum {

/// Thread of every member: that of the engine's.
class SharedScene {
public:
    virtual ~SharedScene() = default;

    /// Of the server, as the person named it.
    virtual std::string place() const = 0;
    /// Why the server's scene is another one than was published.
    enum class Arrival : std::uint8_t {
        Begun,   ///< it was there when the connection was made, and nothing had been published
        Changed, ///< somebody else has changed it
        Another, ///< the server that was found has a scene of its own, and another had been published
        Refused  ///< what was published was not taken
    };
    struct Arrived {
        Arrival why = Arrival::Begun;
        Scene scene;
    };
    /// The server's scene where it is not what was published: once each, the newest.
    virtual std::optional<Arrived> arrived() = 0;
    /// Why what was published or ordered was not done: one sentence, once.
    virtual std::optional<std::string> refused() = 0;
    /// What another client did to the force: one sentence, once.
    virtual std::optional<std::string> forceSaid() = 0;
    /// Who edits, and switches the force on.
    virtual bool holdsPen() const = 0;
    /// Its name; empty: nobody.
    virtual std::string penHolder() const = 0;
    /// It is had at once where nobody has it; else its holder is asked.
    virtual void askForPen() = 0;
    /// Who asks for it, once for each time.
    virtual std::optional<std::string> penAskedBy() = 0;
    /// Who waits for it; empty: nobody any more.
    virtual std::string penAsker() const = 0;
    virtual void givePen(const std::string& to) = 0;
    /// How many clients there are, this one too.
    virtual std::size_t attending() const = 0;
};

} // namespace tactum
