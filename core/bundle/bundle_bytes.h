// The bytes of a bundle on the disk. For this folder only.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"

namespace tactum {

Result<std::string> bundleBytes(const std::filesystem::path& file);

} // namespace tactum
