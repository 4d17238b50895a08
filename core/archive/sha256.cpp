#include "core/archive/sha256.h"

#include <sha2.h>

namespace tactum {

std::string sha256(std::string_view bytes) {
    char digits[SHA256_DIGEST_STRING_LENGTH];
    return SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits);
}

} // namespace tactum
