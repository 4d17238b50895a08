// Plain values as bytes and back: little-endian, nothing in between, the same list of fields both ways.
//
// A type says once what it consists of, in a static member or a free function `fields(visit, value)` that
// calls visit(value.a, value.b, ...). ByteWriter and ByteReader are the two visitors.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#include "core/base/vec.h"

namespace tactum {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie in memory");

template <class T>
concept PlainNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// A T to read into, or a const one to write: `void fields(auto& visit, MaybeConst<T> auto& value)`.
template <class T, class Plain>
concept MaybeConst = std::is_same_v<std::remove_const_t<T>, Plain>;

template <class T, class Visitor>
concept HasOwnFields = requires(Visitor& visit, T& value) {
    T::fields(visit, value);
};

namespace detail {

/// Takes every kind of value apart down to its numbers, which go to Visitor::number().
template <class Visitor> class Fields {
public:
    template <class... T> void operator()(T&... values) noexcept { (visit(values), ...); }

private:
    Visitor& self() noexcept { return static_cast<Visitor&>(*this); }

    template <class T> void visit(T& value) noexcept {
        using Plain = std::remove_const_t<T>;
        if constexpr (PlainNumber<Plain>)
            self().number(value);
        else if constexpr (std::is_same_v<Plain, Quat>)
            (*this)(value.coeffs()[0], value.coeffs()[1], value.coeffs()[2], value.coeffs()[3]);
        else if constexpr (std::is_same_v<Plain, Pose>)
            (*this)(value.rotation, value.translation);
        else if constexpr (HasOwnFields<T, Visitor>)
            Plain::fields(self(), value);
        else if constexpr (
            requires { value.coeffRef(0); } || requires { value.coeff(0); })
            for (Eigen::Index i = 0; i < value.size(); ++i)
                visit(value[i]);
        else
            fields(self(), value);
    }
    template <class T, std::size_t N> void visit(std::array<T, N>& values) noexcept {
        for (T& value : values)
            visit(value);
    }
    template <class T, std::size_t N> void visit(const std::array<T, N>& values) noexcept {
        for (const T& value : values)
            visit(value);
    }
};

} // namespace detail

/// Writes into a room of fixed size. Thread: real time.
class ByteWriter : public detail::Fields<ByteWriter> {
public:
    explicit ByteWriter(std::span<std::byte> room) noexcept : room_(room) {}

    template <PlainNumber T> void number(const T& value) noexcept { put(&value, sizeof value); }
    /// A number that may be infinite.
    void unbounded(const double& value) noexcept { number(value); }
    /// An index: from 0 to below `end`.
    void index(const int& value, int) noexcept { number(value); }
    /// The first `count` of an array, and how many they are.
    template <class T, std::size_t N>
    void counted(const std::array<T, N>& values, const int& count) noexcept {
        number(count);
        for (int i = 0; i < count; ++i)
            (*this)(values[std::size_t(i)]);
    }

    std::size_t size() const noexcept { return size_; }
    bool fits() const noexcept { return size_ <= room_.size(); }

private:
    void put(const void* from, std::size_t bytes) noexcept {
        if (size_ + bytes <= room_.size()) std::memcpy(room_.data() + size_, from, bytes);
        size_ += bytes;
    }

    std::span<std::byte> room_;
    std::size_t size_ = 0;
};

/// What a reader says of doubles that are not finite.
enum class NotFinite : std::uint8_t { Allowed, Refused };

/// Reads what a ByteWriter wrote. At the first byte that cannot be right everything stops: the values from
/// there on stay as they were. Thread: real time.
class ByteReader : public detail::Fields<ByteReader> {
public:
    ByteReader(std::span<const std::byte> bytes, NotFinite rule) noexcept : bytes_(bytes), rule_(rule) {}

    template <PlainNumber T> void number(T& value) noexcept {
        T read{};
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            take(&byte, 1);
            good_ = good_ && byte <= 1;
            read = byte == 1;
        } else {
            take(&read, sizeof read);
        }
        if constexpr (std::is_floating_point_v<T>)
            good_ = good_ && (rule_ == NotFinite::Allowed || std::isfinite(read));
        if (good_) value = read;
    }
    void unbounded(double& value) noexcept {
        double read = 0;
        take(&read, sizeof read);
        good_ = good_ && !std::isnan(read);
        if (good_) value = read;
    }
    void index(int& value, int end) noexcept {
        int read = 0;
        number(read);
        good_ = good_ && read >= 0 && read < end;
        if (good_) value = read;
    }
    template <class T, std::size_t N> void counted(std::array<T, N>& values, int& count) noexcept {
        int read = 0;
        number(read);
        good_ = good_ && read >= 0 && std::size_t(read) <= N;
        for (int i = 0; good_ && i < read; ++i)
            (*this)(values[std::size_t(i)]);
        if (good_) count = read;
    }

    bool good() const noexcept { return good_; }
    /// Whether all was right and nothing is left over.
    bool complete() const noexcept { return good_ && at_ == bytes_.size(); }

private:
    void take(void* to, std::size_t bytes) noexcept {
        good_ = good_ && bytes <= bytes_.size() - at_;
        if (!good_) return;
        std::memcpy(to, bytes_.data() + at_, bytes);
        at_ += bytes;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    bool good_ = true;
    NotFinite rule_;
};

} // namespace tactum
