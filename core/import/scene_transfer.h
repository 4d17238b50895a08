// A loaded scene as bytes: what the import process hands over, and the check of every byte of it. For this
// folder.
#pragma once

#include <string_view>

#include "core/base/byte_stream.h"
#include "core/files/load_scene.h"

namespace tactum {

/// Everything that a reader gives. Thread: any but real time.
void writeTransfer(ByteOut& out, const LoadedScene& loaded);

/// Trusts nothing: whoever wrote the bytes may have been taken over by the file that it read. What comes back
/// keeps every promise of scene.h: indices inside their lists, finite numbers, names that are safe to print.
/// Throws ByteFault; memory stays within some times the bytes.
LoadedScene readTransfer(std::string_view bytes);

} // namespace tactum
