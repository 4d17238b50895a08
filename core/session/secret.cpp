#include "core/session/secret.h"

#include <sys/random.h>

namespace tactum {

Result<std::string> makeSecret() {
    std::string bytes(16, '\0');
    if (getrandom(bytes.data(), bytes.size(), 0) != ssize_t(bytes.size()))
        return machineError("This system gives no random numbers: without them nobody can be told apart.");
    return bytes;
}

std::string hexOf(std::string_view bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        text += kDigits[byte >> 4];
        text += kDigits[byte & 15];
    }
    return text;
}

bool sameSecret(std::string_view secret, std::string_view given) {
    if (secret.empty() || secret.size() != given.size()) return false;
    volatile unsigned char difference = 0; // volatile: no compiler may leave early
    for (std::size_t i = 0; i < secret.size(); ++i)
        difference = static_cast<unsigned char>(difference | (secret[i] ^ given[i]));
    return difference == 0;
}

} // namespace tactum
