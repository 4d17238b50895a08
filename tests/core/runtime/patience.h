// Waits for what other threads will do.
#pragma once

#include "tests/support/patience.h"

namespace tactum {

using test::eventually;

} // namespace tactum
