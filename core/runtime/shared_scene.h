// A scene that others see and may change, too: what a window asks an engine at a haptic server beyond what
// every engine tells.
#pragma once

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
    /// A scene that was there before this window, or that somebody else has made of it: once each, the
    /// newest.
    virtual std::optional<Scene> arrived() = 0;
    /// Why what was published or ordered was not done: one sentence, once.
    virtual std::optional<std::string> refused() = 0;
    /// Who edits, and switches the force on.
    virtual bool holdsPen() const = 0;
    /// Its name; empty: nobody.
    virtual std::string penHolder() const = 0;
    /// It is had at once where nobody has it; else its holder is asked.
    virtual void askForPen() = 0;
    /// Who asks for it, once for each time.
    virtual std::optional<std::string> penAskedBy() = 0;
    virtual void givePen(const std::string& to) = 0;
    /// How many clients there are, this one too.
    virtual std::size_t attending() const = 0;
};

} // namespace tactum
