#include "tests/core/protocol/slow_link.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace tactum::test {
namespace {

using Clock = std::chrono::steady_clock;

sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

/// One direction: a thread takes what comes and says when it is due, another one hands it on.
class Way {
public:
    Way(int from, int to, double delay, double jitter)
        : taker_([=, this] { take(from, delay, jitter); }), giver_([=, this] { give(to); }) {}
    void swallow() { swallowing_ = true; }
    void join() {
        taker_.join();
        giver_.join();
    }

private:
    struct Bytes {
        Clock::time_point due;
        std::string bytes; ///< none: the other side has ended
    };

    void take(int from, double delay, double jitter) {
        std::mt19937 random{std::uint32_t(from)};
        std::uniform_real_distribution<double> more(0, std::max(jitter, 1e-12));
        Clock::time_point last{};
        std::string bytes(1 << 16, '\0');
        for (bool ended = false; !ended;) {
            const ssize_t got = recv(from, bytes.data(), bytes.size(), 0);
            ended = got <= 0;
            const auto way = std::chrono::duration<double>(delay + more(random));
            last = std::max(last, Clock::now() + std::chrono::duration_cast<Clock::duration>(way));
            const std::lock_guard lock(mutex_);
            queue_.push_back({last, bytes.substr(0, ended ? 0 : std::size_t(got))});
            changed_.notify_all();
        }
    }
    void give(int to) {
        while (true) {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return !queue_.empty(); });
            const Bytes next = std::move(queue_.front());
            queue_.pop_front();
            lock.unlock();
            std::this_thread::sleep_until(next.due);
            if (next.bytes.empty()) break;
            if (swallowing_) continue;
            for (std::size_t at = 0; at < next.bytes.size();) {
                const ssize_t put = send(to, next.bytes.data() + at, next.bytes.size() - at, MSG_NOSIGNAL);
                if (put <= 0) break;
                at += std::size_t(put);
            }
        }
        shutdown(to, SHUT_WR);
    }

    std::atomic<bool> swallowing_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Bytes> queue_;
    std::thread taker_, giver_;
};

} // namespace

struct SlowLink::Impl {
    Impl(std::uint16_t port, double seconds, double more) : to(port), delay(seconds), jitter(more) {}

    std::uint16_t to;
    double delay, jitter;
    int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    std::mutex mutex;
    std::vector<int> sockets;
    std::vector<std::unique_ptr<Way>> ways;
    std::thread accepting;

    void connectThrough(int client) {
        const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const sockaddr_in address = loopback(to);
        const int on = 1;
        for (const int each : {client, server})
            setsockopt(each, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        if (connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
            shutdown(client, SHUT_RDWR);
        const std::lock_guard lock(mutex);
        sockets.insert(sockets.end(), {client, server});
        ways.push_back(std::make_unique<Way>(client, server, delay, jitter));
        ways.push_back(std::make_unique<Way>(server, client, delay, jitter));
    }
};

SlowLink::SlowLink(std::uint16_t to, double delay, double jitter)
    : impl_(std::make_unique<Impl>(to, delay, jitter)) {
    const sockaddr_in any = loopback(0);
    bind(impl_->listener, reinterpret_cast<const sockaddr*>(&any), sizeof any);
    listen(impl_->listener, 16);
    impl_->accepting = std::thread([this] {
        for (int client = 0; (client = accept(impl_->listener, nullptr, nullptr)) >= 0;)
            impl_->connectThrough(client);
    });
}

SlowLink::~SlowLink() {
    shutdown(impl_->listener, SHUT_RDWR);
    impl_->accepting.join();
    for (const int each : impl_->sockets)
        shutdown(each, SHUT_RDWR);
    for (const auto& way : impl_->ways)
        way->join();
    for (const int each : impl_->sockets)
        close(each);
    close(impl_->listener);
}

void SlowLink::swallow() {
    const std::lock_guard lock(impl_->mutex);
    for (const auto& way : impl_->ways)
        way->swallow();
}

std::uint16_t SlowLink::port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    getsockname(impl_->listener, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

} // namespace tactum::test
