// A value that a forked child changes for its parent as well.
#pragma once

#include <new>

#include <sys/mman.h>

namespace tactum::test {

/// T has to be one that two processes may use at once: an atomic, or a struct of them.
template <class T> class SharedValue {
public:
    SharedValue() {
        void* place = mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (place == MAP_FAILED) throw std::bad_alloc();
        value_ = new (place) T{};
    }
    ~SharedValue() { munmap(value_, sizeof(T)); }
    SharedValue(const SharedValue&) = delete;
    SharedValue& operator=(const SharedValue&) = delete;

    T& operator*() { return *value_; }
    const T& operator*() const { return *value_; }
    T* operator->() { return value_; }
    const T* operator->() const { return value_; }

private:
    T* value_ = nullptr;
};

} // namespace tactum::test
