// The two directions of bulk bytes: the same calls write values and read them back.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/byte_archive.h"
#include "core/base/result.h"
#include "core/base/vec.h"

namespace tactum {

/// Thrown at the first byte that cannot be right; never leaves the function that began the reading.
struct ByteFault {
    Error error;
};

/// Writes. Takes its values without const, as ByteIn does, and changes none.
class ByteOut {
public:
    static constexpr bool kReads = false;

    virtual ~ByteOut() = default;

    template <PlainNumber T> void operator()(T& value) { append(&value, sizeof value); }
    template <class T, int N> void operator()(Eigen::Matrix<T, N, 1>& v) { append(v.data(), sizeof(T) * N); }
    void operator()(Pose& pose) { (*this)(pose.rotation.coeffs()), (*this)(pose.translation); }
    void operator()(std::string& text) {
        std::uint64_t size = text.size();
        (*this)(size);
        append(text.data(), text.size());
    }
    /// The length of a list, whose items take at least so many bytes.
    template <class T> void count(std::vector<T>& list, std::size_t) {
        std::uint64_t size = list.size();
        (*this)(size);
    }
    /// A list of plain values as they lie in memory.
    template <class T> void bulk(std::vector<T>& list) {
        count(list, sizeof(T));
        append(list.data(), list.size() * sizeof(T));
    }
    void demand(bool, const char*) {}

    virtual void append(const void* from, std::size_t count) = 0;
};

/// Into memory.
class StringOut final : public ByteOut {
public:
    std::string bytes;

    void append(const void* from, std::size_t count) override {
        bytes.append(static_cast<const char*>(from), count);
    }
};

/// Reads; throws ByteFault with the place.
class ByteIn {
public:
    static constexpr bool kReads = true;

    /// `name`: of what is read, for the person; `offset`: of the bytes in it; `remedy`: ends every sentence.
    ByteIn(std::string_view bytes, std::string name, std::size_t offset, std::string remedy)
        : bytes_(bytes), name_(std::move(name)), remedy_(std::move(remedy)), offset_(offset) {}

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
        demand(size <= left(), "a text is longer than all there is");
        text.assign(bytes_.substr(at_, size));
        at_ += size;
    }
    template <class T> void count(std::vector<T>& list, std::size_t least) { list.resize(length(least)); }
    template <class T> void bulk(std::vector<T>& list) {
        const std::size_t size = length(sizeof(T));
        if (const void* place = rest().data(); reinterpret_cast<std::uintptr_t>(place) % alignof(T) == 0) {
            const T* first =
                static_cast<const T*>(place); // copied at once: gigabytes need not be zeroed first
            list.assign(first, first + size);
            at_ += size * sizeof(T);
        } else {
            list.resize(size);
            take(list.data(), size * sizeof(T));
        }
    }
    void demand(bool holds, const char* what) const {
        if (!holds) fail(what);
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw ByteFault{{Error::Kind::Input,
                         name_ + ": byte " + std::to_string(offset_ + at_) + ": " + what + "; " + remedy_}};
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::string_view rest() const { return bytes_.substr(at_); }

private:
    std::size_t length(std::size_t least) {
        std::uint64_t size = 0;
        (*this)(size);
        demand(size <= left() / least, "a list is longer than all there is");
        return size;
    }
    void take(void* to, std::size_t count) {
        demand(count <= left(), "it ends too early");
        if (count > 0) std::memcpy(to, bytes_.data() + at_, count);
        at_ += count;
    }

    std::string_view bytes_;
    std::string name_, remedy_;
    std::size_t offset_, at_ = 0;
};

/// An enumerator, of which there are `count`.
template <class Io, class Choice> void choose(Io& io, Choice& choice, std::size_t count) {
    io(choice);
    io.demand(std::size_t(choice) < count, "it names a choice that there is not");
}

} // namespace tactum
