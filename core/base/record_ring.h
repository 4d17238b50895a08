// The last rows of a loop: one thread writes for ever, another copies what it finds.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "core/base/realtime.h"

namespace tactum {

/// Rows in the order in which they came.
template <class Row> struct NumberedRows {
    std::uint64_t first = 0; ///< number of the first, counted from the first that was ever written
    std::vector<Row> rows;

    std::uint64_t end() const { return first + rows.size(); }
};

/// Keeps the newest `capacity` rows. The writer never waits and never fails; a reader that is overtaken drops
/// the rows that may have been written over while it copied them. Rows lie in memory as words that are stored
/// and loaded one by one as atomics, so that what is dropped was no data race either.
template <class Row> class RecordRing {
    static_assert(std::is_trivially_copyable_v<Row> && sizeof(Row) % sizeof(std::uint64_t) == 0);

public:
    /// Thread: any but real time.
    explicit RecordRing(std::size_t capacity)
        : capacity_(capacity),
          words_(static_cast<std::uint64_t*>(std::calloc(capacity * kWords, sizeof(std::uint64_t)))) {
        if (!words_) throw std::bad_alloc();
    }

    /// All of its memory, so that the writer meets no page fault. Thread: any but real time, before the first
    /// push().
    void touch() noexcept { std::memset(words_.get(), 0, bytes()); }

    /// Thread: real time, one writer; wait-free.
    void push(const Row& row) noexcept {
        begun_.store(count_ + 1, std::memory_order_relaxed);
        Words words;
        std::memcpy(words.data(), &row, sizeof row);
        std::uint64_t* slot = words_.get() + slot_ * kWords;
        // Released one by one: who sees a new word sees, too, that this row was begun.
        for (std::size_t i = 0; i < kWords; ++i)
            std::atomic_ref(slot[i]).store(words[i], std::memory_order_release);
        slot_ = slot_ + 1 == capacity_ ? 0 : slot_ + 1;
        written_.store(++count_, std::memory_order_release);
    }

    /// The newest rows, at most `most`. Thread: any but real time, while the writer goes on.
    NumberedRows<Row> copy(std::uint64_t most = ~std::uint64_t(0)) const {
        assertNotRealtime();
        const std::uint64_t end = written_.load(std::memory_order_acquire);
        NumberedRows<Row> copied{end - std::min({end, std::uint64_t(capacity_), most}), {}};
        copied.rows.reserve(std::size_t(end - copied.first));
        for (std::uint64_t number = copied.first; number < end; ++number)
            copied.rows.push_back(load(number));
        const std::uint64_t begun = begun_.load(std::memory_order_relaxed);
        const std::uint64_t whole = begun > capacity_ ? begun - capacity_ : 0;
        if (whole > copied.first) {
            copied.rows.erase(copied.rows.begin(),
                              copied.rows.begin() + std::ptrdiff_t(std::min(whole, end) - copied.first));
            copied.first = std::min(whole, end);
        }
        return copied;
    }

    std::size_t bytes() const noexcept { return capacity_ * kWords * sizeof(std::uint64_t); }

private:
    static constexpr std::size_t kWords = sizeof(Row) / sizeof(std::uint64_t);
    using Words = std::array<std::uint64_t, kWords>;

    Row load(std::uint64_t number) const {
        std::uint64_t* slot = words_.get() + std::size_t(number % capacity_) * kWords;
        Words words;
        for (std::size_t i = 0; i < kWords; ++i)
            words[i] = std::atomic_ref(slot[i]).load(std::memory_order_acquire);
        Row row;
        std::memcpy(static_cast<void*>(&row), words.data(), sizeof row);
        return row;
    }

    std::size_t capacity_;
    /// From calloc, which takes no page of the machine before something is written to it.
    struct Free {
        void operator()(std::uint64_t* words) const noexcept { std::free(words); }
    };
    std::unique_ptr<std::uint64_t[], Free> words_;
    std::size_t slot_ = 0; ///< the writer's own, as is count_
    std::uint64_t count_ = 0;
    alignas(64) std::atomic<std::uint64_t> begun_{0};
    std::atomic<std::uint64_t> written_{0};
};

} // namespace tactum
