// A list of bounded length without allocation; room that is not used costs nothing.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace tactum {

/// At most `Room` values in one piece of memory. An array of as many would have to be filled with initial
/// values first, each time. Thread: real time.
template <class T, std::size_t Room> class InplaceVector {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    static constexpr std::size_t room() noexcept { return Room; }
    std::size_t size() const noexcept { return size_; }
    void clear() noexcept { size_ = 0; }
    void push(const T& value) noexcept {
        assert(size_ < Room);
        std::construct_at(begin() + size_, value);
        ++size_;
    }
    T& operator[](std::size_t i) noexcept { return begin()[i]; }
    const T& operator[](std::size_t i) const noexcept { return begin()[i]; }
    std::span<T> all() noexcept { return {begin(), size_}; }
    std::span<const T> all() const noexcept { return {begin(), size_}; }

private:
    T* begin() noexcept { return reinterpret_cast<T*>(room_); }
    const T* begin() const noexcept { return reinterpret_cast<const T*>(room_); }

    alignas(T) std::byte room_[Room * sizeof(T)];
    std::size_t size_ = 0;
};

} // namespace tactum
