#include "app/library/support_folder.h"

#include <dlfcn.h>

#include <tactum/version.h>

namespace tactum::library {
namespace {

namespace fs = std::filesystem;

/// Beside the library itself, wherever that was loaded from: it may be moved as a whole. Nothing where there
/// is no such file.
fs::path beside(const char* name) {
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&version), &info) == 0 || !info.dli_fname) return {};
    std::error_code fault;
    const fs::path library = fs::weakly_canonical(info.dli_fname, fault);
    const fs::path file = library.parent_path() / TACTUM_SUPPORT_FOLDER / name;
    return fs::exists(file, fault) ? file : fs::path();
}

} // namespace

fs::path importProcess() {
    return beside("tactum-import");
}

fs::path presetFolder() {
    const fs::path folder = beside("presets");
    return folder.empty() ? fs::path(TACTUM_PRESETS) : folder;
}

} // namespace tactum::library
