// What an FBX file says about itself before anything of it is read: its version, its axes. For this folder
// only.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/vec.h"

namespace tactum {

/// Why this FBX cannot be read at all, as the end of a sentence: it is older than 7.0, or its bytes are in
/// the other order.
std::optional<std::string> fbxRefusal(std::string_view bytes);

/// One axis of a file: 0, 1, 2 for its x, y, z, and 1 or -1.
struct FbxAxis {
    int axis;
    int sign;
};

/// From the axes of a file to ours: x to the side (`side`, the file's CoordAxis), y up, z to the front. It
/// mirrors where the file is left-handed. Nothing when the three are no frame.
std::optional<Mat3> fromFbxAxes(const FbxAxis& side, const FbxAxis& up, const FbxAxis& front);

} // namespace tactum
