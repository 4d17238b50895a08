#include "device/polhem/serial_port.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "core/base/realtime.h"
#include "core/base/text.h"

namespace tactum {
namespace {

std::string whyNot(int error) {
    switch (error) {
    case EACCES:
    case EPERM:
        return "you have no permission to use it: install the rule resources/udev/70-tactum.rules in "
               "/etc/udev/rules.d and plug it in again.";
    case EBUSY:
        return "another program has it: end that one.";
    case ENOENT:
    case ENXIO:
    case ENODEV:
        return "it is not there any more: plug it in again.";
    default:
        return std::string(std::strerror(error)) + ": plug it in again.";
    }
}

bool makeRaw(int descriptor) {
    termios settings{};
    if (tcgetattr(descriptor, &settings) != 0) return false;
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD; // no modem's lines
    return cfsetspeed(&settings, B115200) == 0 && tcsetattr(descriptor, TCSANOW, &settings) == 0 &&
           tcflush(descriptor, TCIOFLUSH) == 0;
}

} // namespace

Result<std::unique_ptr<SerialPort>> SerialPort::open(const std::filesystem::path& file) {
    assertNotRealtime();
    const int descriptor = ::open(file.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    const bool raw = descriptor >= 0 && makeRaw(descriptor);
    if (!raw) {
        const int error = errno;
        if (descriptor >= 0) ::close(descriptor);
        return machineError("The serial port " + inQuotes(file.string()) +
                            " cannot be used: " + whyNot(error));
    }
    ioctl(descriptor, TIOCEXCL);
    return std::unique_ptr<SerialPort>(new SerialPort(descriptor));
}

/// A port whose board hangs would keep whoever closes it for half a minute.
SerialPort::~SerialPort() {
    int waiting = 0;
    for (int i = 0; i < 100 && ioctl(descriptor_, TIOCOUTQ, &waiting) == 0 && waiting > 0; ++i)
        usleep(1000);
    if (waiting > 0) tcflush(descriptor_, TCOFLUSH);
    ioctl(descriptor_, TIOCNXCL);
    ::close(descriptor_);
}

/// How many were taken.
long SerialPort::put(std::string_view bytes) noexcept {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR) gone_ = true;
    return std::max<ssize_t>(count, 0);
}

bool SerialPort::send(std::string_view line) noexcept {
    if (restSize_ > 0) {
        const auto taken = std::size_t(put({rest_.data(), restSize_}));
        std::memmove(rest_.data(), rest_.data() + taken, restSize_ - taken);
        restSize_ -= taken;
    }
    if (restSize_ > 0 || line.size() > rest_.size()) return false;
    const auto taken = std::size_t(put(line));
    if (taken == 0) return false;
    restSize_ = line.size() - taken;
    std::copy_n(line.data() + taken, restSize_, rest_.data());
    return true;
}

std::string_view SerialPort::receive(std::span<char> room) noexcept {
    const ssize_t count = ::read(descriptor_, room.data(), room.size());
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) gone_ = true; // hung up
    return {room.data(), std::size_t(std::max<ssize_t>(count, 0))};
}

void SerialPort::sendNow(std::string_view line) const noexcept {
    [[maybe_unused]] const ssize_t count = ::write(descriptor_, line.data(), line.size());
}

} // namespace tactum
