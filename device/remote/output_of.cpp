#include "device/remote/output_of.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMost = 1 << 20;

/// Reads until the other end is closed; false when that took too long, or came to too much.
bool readAll(int from, int patience, std::string& text) {
    const auto end = Clock::now() + std::chrono::milliseconds(patience);
    while (text.size() < kMost) {
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

/// 0 when it did not start.
pid_t start(const std::string& program, std::vector<std::string>& arguments, int to) {
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, to, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int refused = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return refused ? 0 : child;
}

} // namespace

std::string outputOf(const std::string& program, std::vector<std::string> arguments, int patience) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return {};
    const pid_t child = start(program, arguments, ends[1]);
    close(ends[1]);
    std::string text;
    const bool whole = child > 0 && readAll(ends[0], patience, text);
    close(ends[0]);
    if (child == 0) return {};
    if (!whole) kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    return whole && WIFEXITED(status) && WEXITSTATUS(status) == 0 ? text : std::string();
}

} // namespace tactum
