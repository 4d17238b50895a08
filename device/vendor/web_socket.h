// A text conversation with a service on this machine. No other file knows Boost.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// What a page of the service at a port of this machine says, `path` "/version" for one; nothing where there
/// is none within `patience` ms. Thread: any but real time.
std::string httpGet(int port, const std::string& path, int patience);

/// Thread of its members: any but real time, one at a time.
class WebSocket {
public:
    /// With the service at a port of this machine, waiting for `patience` ms at most.
    static Result<WebSocket> connect(int port, int patience);
    ~WebSocket();
    WebSocket(WebSocket&& other) noexcept;
    WebSocket& operator=(WebSocket&& other) noexcept;

    /// False when the service is gone or does not take it in time; then it is closed.
    bool send(std::string_view text, int patience);
    /// The next message as a whole; false when it does not come in time; then it is closed.
    bool receive(std::string& text, int patience);

private:
    struct Impl;
    explicit WebSocket(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
