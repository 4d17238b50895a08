#include "core/base/host_port.h"

#include <algorithm>
#include <cctype>

#include "core/base/numbers.h"

namespace tactum {

std::optional<HostPort> hostPortOf(std::string_view text) {
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos) return {};
    const std::string_view digits = text.substr(colon + 1);
    std::string_view host = text.substr(0, colon);
    const auto isDigit = [](unsigned char c) { return std::isdigit(c) != 0; };
    const auto number = parseNumber(digits);
    if (!number || *number > 65535 || !std::ranges::all_of(digits, isDigit)) return {};
    if (host.size() > 1 && host.front() == '[' && host.back() == ']')
        host = host.substr(1, host.size() - 2);
    else if (host.find(':') != host.npos)
        return {};
    const auto isSpace = [](unsigned char c) { return std::isspace(c) != 0; };
    if (host.empty() || std::ranges::any_of(host, isSpace)) return {};
    return HostPort{std::string(host), std::uint16_t(*number)};
}

} // namespace tactum
