#include "core/protocol/front.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/base/clock.h"
#include "core/base/text.h"

namespace tactum {
namespace {

constexpr int kLook = 50;                    ///< ms
constexpr std::size_t kDescriptorsKept = 64; ///< for everything that is not a connection

enum class Beginning { Right, Wrong, Unknown };

/// Of HTTP/2 without TLS.
constexpr std::string_view kPreface = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n";

Beginning judge(std::string_view seen, bool tls) {
    constexpr std::string_view kHandshake("\x16\x03", 2); // of TLS
    const std::string_view right = tls ? kHandshake : kPreface;
    const std::size_t count = std::min(seen.size(), right.size());
    if (seen.substr(0, count) != right.substr(0, count)) return Beginning::Wrong;
    return count == right.size() ? Beginning::Right : Beginning::Unknown;
}

/// Looks without taking.
Beginning beginningOf(int descriptor, bool tls) {
    std::array<char, 32> bytes;
    const ssize_t got = recv(descriptor, bytes.data(), bytes.size(), MSG_PEEK | MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR ? Beginning::Unknown : Beginning::Wrong;
    return got == 0 ? Beginning::Wrong : judge({bytes.data(), std::size_t(got)}, tls);
}

double seconds() {
    return 1e-9 * double(monotonicNanoseconds());
}

tl::unexpected<Error> cannotListen(const std::string& host, std::uint16_t port, const char* why) {
    return machineError("cannot listen at " + printable(host) + ":" + std::to_string(port) + " (" + why +
                        "): choose another address or port with --listen HOST:PORT");
}

std::uint16_t portOf(int socket) {
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
    const bool six = address.ss_family == AF_INET6;
    return ntohs(six ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                     : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

} // namespace

std::size_t descriptorsLeft() {
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    std::error_code fault;
    std::size_t open = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", fault))
        open += !entry.path().empty();
    return limit.rlim_cur > open ? std::size_t(limit.rlim_cur) - open : 0;
}

void raiseDescriptorLimit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    setrlimit(RLIMIT_NOFILE, &limit);
}

Result<void> Front::open(const std::string& host, std::uint16_t port) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int fault = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found))
        return cannotListen(host, port, gai_strerror(fault));
    int fault = EADDRNOTAVAIL;
    for (const addrinfo* one = found; one && listening_ < 0; one = one->ai_next) {
        const int socket = ::socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        if (bind(socket, one->ai_addr, one->ai_addrlen) == 0 && listen(socket, SOMAXCONN) == 0) {
            listening_ = socket;
            port_ = portOf(socket);
        } else {
            fault = errno;
            ::close(socket);
        }
    }
    freeaddrinfo(found);
    return listening_ >= 0 ? Result<void>() : cannotListen(host, port, std::strerror(fault));
}

void Front::begin(bool tls, HandOver handOver) {
    tls_ = tls;
    handOver_ = std::move(handOver);
    thread_ = std::thread([this] { run(); });
}

void Front::close() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
    while (!newcomers_.empty())
        drop(0);
    if (listening_ >= 0) ::close(std::exchange(listening_, -1));
}

void Front::run() {
    std::vector<pollfd> watched;
    while (!ending_) {
        watched.assign(1, {.fd = listening_, .events = POLLIN, .revents = 0});
        for (const Newcomer& newcomer : newcomers_)
            watched.push_back({.fd = newcomer.descriptor, .events = POLLIN, .revents = 0});
        poll(watched.data(), watched.size(), kLook);
        look(seconds());
        if (watched.front().revents) accept();
    }
}

/// Hands over who has begun rightly, drops who has not in time.
void Front::look(double now) {
    for (std::size_t i = newcomers_.size(); i-- > 0;) {
        const Beginning beginning = beginningOf(newcomers_[i].descriptor, tls_);
        if (beginning == Beginning::Right && hasRoom(now)) {
            handOver_(newcomers_[i].descriptor);
            newcomers_.erase(newcomers_.begin() + std::ptrdiff_t(i));
        } else if (beginning != Beginning::Unknown || now - newcomers_[i].since > kPatience) {
            drop(i);
        }
    }
}

/// To count them takes as long as there are many: not for each of a crowd.
bool Front::hasRoom(double now) {
    constexpr double kCountAgain = 0.05; // s
    if (counted_ < 0 || now - counted_ > kCountAgain) left_ = descriptorsLeft(), counted_ = now;
    return left_ > kDescriptorsKept;
}

void Front::drop(std::size_t index) {
    ::close(newcomers_[index].descriptor);
    newcomers_.erase(newcomers_.begin() + std::ptrdiff_t(index));
}

/// All that wait at the door; the oldest newcomer makes room.
void Front::accept() {
    constexpr int kAtOnce = 256;
    for (int i = 0; i < kAtOnce; ++i) {
        const int descriptor = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (descriptor < 0) {
            const bool none = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
            if (!none) return;
            if (newcomers_.empty()) { // gRPC has them all: wait for its time limits
                std::this_thread::sleep_for(std::chrono::milliseconds(kLook));
                return;
            }
            drop(0);
            continue;
        }
        left_ -= std::min<std::size_t>(left_, 1);
        const int yes = 1;
        setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
        if (newcomers_.size() >= kMostNewcomers) drop(0);
        newcomers_.push_back({descriptor, seconds()});
        if (beginningOf(descriptor, tls_) != Beginning::Unknown) look(seconds());
    }
}

} // namespace tactum
