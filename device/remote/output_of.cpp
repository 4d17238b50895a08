#include "device/remote/output_of.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/child_program.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMax = 1 << 20;

/// Reads until the other end is closed; false when that took too long, or came to too much.
bool readAll(int from, int patience, std::string& text) {
    const auto end = Clock::now() + std::chrono::milliseconds(patience);
    while (text.size() < kMax) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        pollfd line{.fd = from, .events = POLLIN, .revents = 0};
        if (left <= 0 || poll(&line, 1, int(left)) == 0) return false;
        std::array<char, 4096> part{};
        const ssize_t got = read(from, part.data(), part.size());
        if (got == 0) return true;
        if (got > 0) text.append(part.data(), std::size_t(got));
    }
    return false;
}

} // namespace

std::string outputOf(const std::string& program, std::vector<std::string> arguments, int patience) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    pid_t child = 0;
    const bool started = startChild({.program = program,
                                     .arguments = std::move(arguments),
                                     .silent = {STDIN_FILENO, STDERR_FILENO},
                                     .descriptors = {{ends[1], STDOUT_FILENO}},
                                     .environment = {}},
                                    child) == 0;
    close(ends[1]);
    std::string text;
    const bool whole = started && readAll(ends[0], patience, text);
    close(ends[0]);
    if (!started) return {};
    if (!whole) kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    return whole && WIFEXITED(status) && WEXITSTATUS(status) == 0 ? text : std::string();
}

} // namespace tactum
