#include "app/terminal_progress.h"

#include <cstdio>

#include <unistd.h>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(500), kPause = std::chrono::milliseconds(100);
constexpr std::size_t kLongest = 60; // characters: a line that wraps cannot be taken back
constexpr const char* kEraseLine = "\r\x1b[K";

} // namespace

TerminalProgress::TerminalProgress(std::string what)
    : what_(printable(what, kLongest)), due_(Clock::now() + kPatience) {
    if (isatty(STDERR_FILENO)) progress_.report = [this](double fraction) { show(fraction); };
}

TerminalProgress::~TerminalProgress() {
    if (shown_) std::fputs(kEraseLine, stderr);
}

void TerminalProgress::show(double fraction) {
    const auto now = Clock::now();
    if (now < due_) return;
    due_ = now + kPause;
    shown_ = true;
    std::fprintf(stderr, "%s%s ... %d %%", kEraseLine, what_.c_str(), int(100 * fraction));
    std::fflush(stderr);
}

} // namespace tactum
