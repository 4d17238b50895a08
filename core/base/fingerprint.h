// Tells bytes apart and finds damage; no protection against malice.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace tactum {

/// FNV-1a over words of eight bytes.
class Fingerprint {
public:
    void add(const void* bytes, std::size_t count) {
        const char* at = static_cast<const char*>(bytes);
        for (; count >= 8; at += 8, count -= 8)
            mix(at, 8);
        if (count > 0) mix(at, count);
    }
    template <class T> void add(const std::vector<T>& values) {
        const std::uint64_t count = values.size();
        add(&count, sizeof count);
        add(values.data(), values.size() * sizeof(T));
    }
    std::uint64_t value() const { return hash_; }

private:
    void mix(const char* at, std::size_t count) {
        std::uint64_t word = 0;
        std::memcpy(&word, at, count);
        hash_ = std::rotl((hash_ ^ word) * 0x100000001b3u, 29);
    }
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace tactum
