// The haptic server: a stage behind a socket.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/protocol/credentials.h"
#include "core/protocol/service.h"

namespace tactum {

struct ServerSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0; ///< 0: any that is free
    /// TLS and a token; needed where `host` is not of this machine alone.
    std::optional<Credentials> credentials;
    ServiceSettings service;
};

/// Whether a host is reached from this machine alone: a literal address of the loopback, or localhost.
bool isLoopback(std::string_view host);

/// Start its stage first: that forks, and what gRPC holds would go along. Thread: one and the same, not real
/// time and of ordinary priority, for gRPC's threads inherit it.
class Server {
public:
    /// `stage` outlives it. Errors: an address that others can reach and no credentials; one that is taken.
    static Result<std::unique_ptr<Server>> start(Stage& stage, ServerSettings settings);
    /// Ends all calls.
    ~Server();
    std::uint16_t port() const;

private:
    struct Impl;
    explicit Server(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
