// What our MetadataSets are called: the writer's mark, by which the reader knows its names again.
#pragma once

namespace tactum {

inline constexpr const char* kX3dObjectSet = "Tactum object";
inline constexpr const char* kX3dSurfaceSet = "Tactum surface";

} // namespace tactum
