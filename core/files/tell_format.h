// The format of a file without a name, by how it begins.
#pragma once

#include <string_view>

namespace tactum {

/// The ending that a file with these bytes would have; empty for what cannot be told. What begins like
/// nothing else is taken for OBJ, which has no beginning. Thread: any but real time.
std::string_view toldEnding(std::string_view bytes);

} // namespace tactum
