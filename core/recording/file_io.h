// The two directions of a recording's bulk: the same calls write it and read it back. For this folder only.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/byte_archive.h"
#include "core/base/result.h"
#include "core/base/vec.h"

namespace tactum {

/// Thrown at the first fault of a file; readRecording() catches it. Never leaves the folder.
struct RecordingFault {
    Error error;
};

/// FNV-1a over words of eight bytes: finds damage and tells files apart; no protection against malice.
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

/// Appends.
class FileOut {
public:
    static constexpr bool kReads = false;

    std::string bytes;

    template <PlainNumber T> void operator()(T& value) { put(&value, sizeof value); }
    template <class T, int N> void operator()(Eigen::Matrix<T, N, 1>& v) { put(v.data(), sizeof(T) * N); }
    void operator()(Pose& pose) { (*this)(pose.rotation.coeffs()), (*this)(pose.translation); }
    void operator()(std::string& text) {
        std::uint64_t size = text.size();
        (*this)(size);
        bytes += text;
    }
    /// The length of a list, whose items take at least so many bytes.
    template <class T> void count(std::vector<T>& list, std::size_t) {
        std::uint64_t size = list.size();
        (*this)(size);
    }
    /// A list of plain values as they lie in memory.
    template <class T> void bulk(std::vector<T>& list) {
        count(list, sizeof(T));
        put(list.data(), list.size() * sizeof(T));
    }
    void demand(bool, const char*) {}

private:
    void put(const void* from, std::size_t count) { bytes.append(static_cast<const char*>(from), count); }
};

/// Reads; throws RecordingFault with the name of the file and the place in it.
class FileIn {
public:
    static constexpr bool kReads = true;

    /// `offset`: of the bytes in the file.
    FileIn(std::string_view bytes, std::string file, std::size_t offset)
        : bytes_(bytes), file_(std::move(file)), offset_(offset) {}

    template <PlainNumber T> void operator()(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            take(&byte, 1);
            demand(byte <= 1, "a switch is neither on nor off");
            value = byte == 1;
        } else {
            take(&value, sizeof value);
        }
        if constexpr (std::is_floating_point_v<T>) demand(std::isfinite(value), "a number is not finite");
    }
    template <class T, int N> void operator()(Eigen::Matrix<T, N, 1>& v) {
        for (int i = 0; i < N; ++i)
            (*this)(v[i]);
    }
    void operator()(Pose& pose) {
        (*this)(pose.rotation.coeffs()), (*this)(pose.translation);
        demand(std::abs(pose.rotation.norm() - 1) < 1e-6, "a rotation is not of unit length");
    }
    void operator()(std::string& text) {
        std::uint64_t size = 0;
        (*this)(size);
        demand(size <= left(), "a text is longer than the file");
        text.assign(bytes_.substr(at_, size));
        at_ += size;
    }
    template <class T> void count(std::vector<T>& list, std::size_t least) {
        std::uint64_t size = 0;
        (*this)(size);
        demand(size <= left() / least, "a list is longer than the file");
        list.resize(size);
    }
    template <class T> void bulk(std::vector<T>& list) {
        count(list, sizeof(T));
        take(list.data(), list.size() * sizeof(T));
    }
    void demand(bool holds, const char* what) const {
        if (!holds) fail(what);
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw RecordingFault{{Error::Kind::Input, file_ + ": byte " + std::to_string(offset_ + at_) + ": " +
                                                      what + "; the recording is damaged, use another one"}};
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::string_view rest() const { return bytes_.substr(at_); }

private:
    void take(void* to, std::size_t count) {
        demand(count <= left(), "it ends too early");
        if (count > 0) std::memcpy(to, bytes_.data() + at_, count);
        at_ += count;
    }

    std::string_view bytes_;
    std::string file_;
    std::size_t offset_, at_ = 0;
};

/// An enumerator, of which there are `count`.
template <class Io, class Choice> void choose(Io& io, Choice& choice, std::size_t count) {
    io(choice);
    io.demand(std::size_t(choice) < count, "it names a choice that there is not");
}

} // namespace tactum
