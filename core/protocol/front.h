// The door of the server: accepts, and hands over to gRPC only who begins as one that speaks its language.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <thread>

#include "core/base/result.h"

namespace tactum {

/// gRPC 1.51 never accepts again once it ran out of descriptors, and holds whoever connects and says nothing
/// for two minutes. So this accepts for it: a newcomer has a second to send the beginning of HTTP/2 or of
/// TLS, at most kMostNewcomers wait for that, the oldest goes first, and where descriptors are short all of
/// them.
class Front {
public:
    static constexpr std::size_t kMostNewcomers = 128;
    static constexpr double kPatience = 1; ///< s

    /// Takes the descriptor of a connection.
    using HandOver = std::function<void(int)>;

    Front() = default;
    ~Front() { close(); }
    Front(const Front&) = delete;
    Front& operator=(const Front&) = delete;

    /// Binds and listens; `port` 0: any that is free. Errors: an address that is none or not ours, or taken.
    Result<void> open(const std::string& host, std::uint16_t port);
    std::uint16_t port() const { return port_; }
    void begin(bool tls, HandOver handOver);
    void close();

private:
    struct Newcomer {
        int descriptor = -1;
        double since = 0; ///< s
    };

    void run();
    void accept();
    void look(double now);
    void drop(std::size_t index);
    bool hasRoom(double now);

    int listening_ = -1;
    std::uint16_t port_ = 0;
    bool tls_ = false;
    HandOver handOver_;
    std::deque<Newcomer> newcomers_;
    std::size_t left_ = 0; ///< descriptors, as they were counted, without those accepted since
    double counted_ = -1;  ///< s, when
    std::atomic<bool> ending_{false};
    std::thread thread_;
};

/// Of this process: how many descriptors may still be opened. Thread: any but real time.
std::size_t descriptorsLeft();
/// As many as the system lets a program have without asking.
void raiseDescriptorLimit();

} // namespace tactum
