// What is kept of a glTF file beside values that came into a scene of another file.
#pragma once

namespace tactum {

/// As `Kept::index`: the element is there, and nothing that it names by a number.
inline constexpr int kOfAnotherFile = -2;

} // namespace tactum
