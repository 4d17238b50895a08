// A way to a server that takes its time: bytes arrive whole and in order, later by a delay and up to a
// jitter.
#pragma once

#include <cstdint>
#include <memory>

namespace tactum::test {

/// Forwards every connection to a port of this machine. What TCP hides from both ends, losses above all, it
/// has not: there a packet that comes again is a delay of a round trip and more.
class SlowLink {
public:
    /// Both in s; each way.
    SlowLink(std::uint16_t to, double delay, double jitter);
    ~SlowLink();
    SlowLink(const SlowLink&) = delete;
    SlowLink& operator=(const SlowLink&) = delete;

    std::uint16_t port() const;
    /// From now on nothing goes through the connections that there are, and neither side is told.
    void swallow();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum::test
