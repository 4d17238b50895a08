// How far work is, for a person at a terminal.
#pragma once

#include <chrono>
#include <string>

#include "core/base/progress.h"

namespace tactum {

/// One line on standard error, from half a second of work on and gone at its end. Says nothing where standard
/// error is no terminal. Thread: whichever works, one.
class TerminalProgress {
public:
    /// `what`: the work and its file, "reading teapot.obj".
    explicit TerminalProgress(std::string what);
    ~TerminalProgress();
    TerminalProgress(const TerminalProgress&) = delete;
    TerminalProgress& operator=(const TerminalProgress&) = delete;

    const Progress& progress() const { return progress_; }

private:
    void show(double fraction);

    using Clock = std::chrono::steady_clock;

    std::string what_;
    Clock::time_point due_; ///< when it is shown next
    bool shown_ = false;
    Progress progress_;
};

} // namespace tactum
