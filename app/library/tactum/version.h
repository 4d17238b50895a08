// Which library this is.
#pragma once

#include <tactum/export.h>

namespace tactum::library {

/// Of the library that is running, e.g. "0.1.0". Programs go on with every one whose first two numbers are
/// those they were built with. Thread: any.
TACTUM_API const char* version() noexcept;

} // namespace tactum::library
