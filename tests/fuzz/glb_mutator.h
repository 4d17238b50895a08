// Changes what is inside a glb and keeps its container right, so that the changes reach the readers of the
// parts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tactum::fuzz {

/// libFuzzer's own change of some bytes, in place: it gives the new length.
using MutateBytes = std::size_t (*)(std::uint8_t* data, std::size_t size, std::size_t maxSize);

/// Another glb made of this one; one of a random scene where `glb` is none.
std::string mutatedGlb(std::string_view glb, unsigned seed, MutateBytes mutateBytes);

} // namespace tactum::fuzz
