// HOST:PORT, as a person writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tactum {

struct HostPort {
    std::string host; ///< without the brackets that an address of version 6 has
    std::uint16_t port = 0;
};

/// "[::1]:51270" and "localhost:0" alike; nothing for what is none. Thread: any but real time.
std::optional<HostPort> hostPortOf(std::string_view text);

} // namespace tactum
