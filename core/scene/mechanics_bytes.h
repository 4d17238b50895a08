// Bodies, joints and colliders as bytes: what the import process and recordings have in common.
#pragma once

#include "core/base/byte_stream.h"
#include "core/dynamics/mechanics.h"

namespace tactum {

/// Writes to a ByteOut, reads from a ByteIn and checks what it reads: references, modes, directions.
template <class Io> void mechanicsBytes(Io& io, Mechanics& mechanics);

} // namespace tactum
