#include "core/archive/sha256.h"

#include <fstream>
#include <iterator>

#include <sha2.h>

namespace tactum {

std::string sha256(std::string_view bytes) {
    char digits[SHA256_DIGEST_STRING_LENGTH];
    return SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), digits);
}

std::string fingerprintOf(const std::filesystem::path& file) {
    std::error_code unknown;
    std::ifstream in(file, std::ios::binary);
    if (!std::filesystem::is_regular_file(file, unknown) || !in) return {};
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    return in.bad() ? std::string() : sha256(bytes);
}

} // namespace tactum
