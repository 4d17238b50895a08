// A mailbox that a forked device watchdog can stop: it lies in memory that both processes share.
#pragma once

#include <new>
#include <sys/mman.h>

#include "core/port/device_mailbox.h"

namespace tactum {

class SharedMailbox {
public:
    SharedMailbox() {
        memory_ =
            mmap(nullptr, sizeof(DeviceMailbox), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory_ == MAP_FAILED) throw std::bad_alloc();
        box_ = new (memory_) DeviceMailbox;
    }
    ~SharedMailbox() { munmap(memory_, sizeof(DeviceMailbox)); }
    SharedMailbox(const SharedMailbox&) = delete;
    SharedMailbox& operator=(const SharedMailbox&) = delete;

    DeviceMailbox* operator->() const noexcept { return box_; }

private:
    void* memory_;
    DeviceMailbox* box_;
};

} // namespace tactum
