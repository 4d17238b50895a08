// Waits for what other threads will do: a test that passes does not depend on how fast the machine is.
#pragma once

#include <chrono>
#include <thread>

namespace tactum {

/// True as soon as the condition holds; false when it did not for half a minute.
template <class Condition> bool eventually(Condition condition) {
    for (int i = 0; i < 30'000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

} // namespace tactum
