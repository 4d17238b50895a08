#include "device/remote/wire.h"

#include <algorithm>
#include <cerrno>
#include <poll.h>
#include <sys/socket.h>

namespace tactum::wire {

Text textOf(std::string_view words) {
    Text text{};
    std::copy_n(words.begin(), std::min(words.size(), text.size() - 1), text.begin());
    return text;
}

std::string stringOf(const Text& text) {
    return {text.begin(), std::find(text.begin(), text.end(), '\0')};
}

Packet infoPacket(const DeviceInfo& info) {
    Packet packet{.kind = Kind::Info, .text = textOf(info.name)};
    for (std::size_t i = 0; i < packet.figures.size(); ++i)
        packet.figures[i] = info.*kDeviceFigures[i].value;
    packet.buttons = info.buttons;
    packet.real = info.real;
    packet.measuresVelocity = info.measuresVelocity;
    return packet;
}

DeviceInfo infoOf(const Packet& packet) {
    DeviceInfo info{.name = stringOf(packet.text)};
    for (std::size_t i = 0; i < packet.figures.size(); ++i)
        info.*kDeviceFigures[i].value = packet.figures[i];
    info.buttons = packet.buttons;
    info.real = packet.real != 0;
    info.measuresVelocity = packet.measuresVelocity != 0;
    return info;
}

Packet donePacket(const Result<void>& result) {
    if (result) return {.kind = Kind::Done};
    return {.kind = Kind::Done, .value = double(result.error().kind), .text = textOf(result.error().text)};
}

Result<void> resultOf(const Packet& packet) {
    if (packet.value == 0) return {};
    const auto isKind = [&](Error::Kind kind) { return packet.value == double(kind); };
    if (isKind(Error::Kind::Input)) return inputError(stringOf(packet.text));
    return machineError(stringOf(packet.text));
}

bool send(int socket, const Packet& packet) {
    ssize_t sent = 0;
    do
        sent = ::send(socket, &packet, sizeof(packet), MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == ssize_t(sizeof(packet));
}

News receive(int socket, int patience, Packet& packet) {
    pollfd line{.fd = socket, .events = POLLIN, .revents = 0};
    if (poll(&line, 1, patience) <= 0) return News::None;
    const ssize_t got = recv(socket, &packet, sizeof(packet), MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return News::None;
    return got == ssize_t(sizeof(packet)) ? News::Packet : News::Gone;
}

} // namespace tactum::wire
