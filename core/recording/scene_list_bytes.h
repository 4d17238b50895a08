// The scenes of a recording as bytes: everything that is felt, each thing once. For this folder only.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/byte_stream.h"
#include "core/runtime/recorded_run.h"
#include "core/scene/known_parts.h"

namespace tactum {

/// With all geometry and images but what is in `elsewhere`: who reads them has to find it.
std::string sceneBytes(const std::vector<RecordedScene>& scenes, const KnownParts& elsewhere);
/// Whether a recording of these is small enough to be self-contained.
bool areSmall(const std::vector<RecordedScene>& scenes);

/// Throws ByteFault. Whatever is not in the file is looked for in `known`, which is filled, once, by
/// `find`.
std::vector<RecordedScene> readScenes(ByteIn& in, const std::function<KnownParts()>& find);

} // namespace tactum
