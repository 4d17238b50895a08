#include "tests/device/serial/board_port.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <QByteArray>

namespace tactum::test {

BoardPort::BoardPort(const char* variable, const char* name)
    : variable_(variable), path_(folder_.filePath(name).toStdString()) {
    // By Qt: the watchdog of Qt Test reads the environment on a thread of its own, under the lock of Qt.
    qputenv(variable_, QByteArray::fromStdString(path_.string()));
}

BoardPort::~BoardPort() {
    unplug();
    qunsetenv(variable_);
}

void BoardPort::plug(std::function<void()> step) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) std::abort();
    std::filesystem::create_symlink(ptsname(master_), path_);
    ends_ = false;
    thread_ = std::thread([this, step = std::move(step)] {
        while (!ends_)
            step();
    });
}

void BoardPort::unplug() {
    if (master_ < 0) return;
    ends_ = true;
    thread_.join();
    close(std::exchange(master_, -1));
    std::filesystem::remove(path_);
}

std::string_view BoardPort::hear(std::chrono::microseconds patience) {
    using namespace std::chrono;
    const timespec soon{.tv_sec = 0, .tv_nsec = nanoseconds(patience).count()};
    pollfd ready{.fd = master_, .events = POLLIN, .revents = 0};
    if (ppoll(&ready, 1, &soon, nullptr) <= 0 || !(ready.revents & POLLIN)) return {};
    const ssize_t count = read(master_, heard_.data(), heard_.size());
    return {heard_.data(), std::size_t(std::max<ssize_t>(count, 0))};
}

void BoardPort::say(std::string_view bytes) const {
    if (write(master_, bytes.data(), bytes.size()) < 0) std::abort();
}

} // namespace tactum::test
