// The two shapes in which values cross threads: the newest one (TripleBuffer) and every one (SpscQueue).
// Both have one writer thread and one reader thread, never wait, never allocate after construction.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tactum {

/// The newest value of one writer for one reader.
/// Thread: real time, wait-free on both sides; write() on one thread only, read() on one thread only.
/// Three slots: the writer owns one, the reader owns one, the third lies in the middle with a bit that
/// says whether it is newer than the reader's. (A seqlock reader can livelock under a busy writer of
/// lower priority; this cannot.)
template <class T> class TripleBuffer {
    // Eigen's vectors are plain in fact but not in the type system's words, so this asks for no more.
    static_assert(std::is_trivially_destructible_v<T>, "what crosses threads is a small plain value");

public:
    void write(const T& value) noexcept {
        slots_[writing_].value = value;
        writing_ = middle_.exchange(std::uint8_t(writing_ | kFresh), std::memory_order_acq_rel) & kIndex;
    }

    /// Takes the newest value if there is one; returns whether there was. The value stays readable.
    bool update() noexcept {
        if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
        reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
        return true;
    }

    /// The value of the last update().
    const T& value() const noexcept { return slots_[reading_].value; }

    const T& read() noexcept {
        update();
        return value();
    }

private:
    static constexpr std::uint8_t kFresh = 4, kIndex = 3;
    struct alignas(64) Slot {
        T value{};
    };
    std::array<Slot, 3> slots_{};
    std::uint8_t writing_ = 0;
    alignas(64) std::atomic<std::uint8_t> middle_{1};
    alignas(64) std::uint8_t reading_ = 2;
};

/// Every value of one writer for one reader, in order; `Capacity` a power of two.
/// Thread: real time, wait-free on both sides. push() says false when full: the writer counts the loss.
template <class T, std::size_t Capacity> class SpscQueue {
    static_assert(Capacity > 0 && (Capacity & (Capacity - 1)) == 0, "a power of two");
    static_assert(std::is_trivially_destructible_v<T>, "what crosses threads is a small plain value");

public:
    bool push(const T& value) noexcept {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail - head_.load(std::memory_order_acquire) == Capacity) return false;
        items_[tail & (Capacity - 1)] = value;
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }

    bool pop(T& value) noexcept {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head == tail_.load(std::memory_order_acquire)) return false;
        value = items_[head & (Capacity - 1)];
        head_.store(head + 1, std::memory_order_release);
        return true;
    }

private:
    std::array<T, Capacity> items_{};
    alignas(64) std::atomic<std::size_t> tail_{0};
    alignas(64) std::atomic<std::size_t> head_{0};
};

} // namespace tactum
