// The one place where a reader's fault becomes a line for the person. For readers only.
#pragma once

#include <new>
#include <string>

#include "core/files/source.h"

namespace tactum {

/// What `read` gives, which becomes a Result<Value>; the ReadFault that it throws; or, when there is not
/// enough memory for it, a line that names the file and says so in the words of `noMemory`, with the remedy.
template <class Value, class Read>
Result<Value> guarded(const std::filesystem::path& file, const char* noMemory, const Read& read) {
    try {
        return read();
    } catch (const ReadFault& fault) {
        return tl::unexpected<Error>(fault.error);
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(file) + ": not enough memory " + noMemory);
    }
}

} // namespace tactum
