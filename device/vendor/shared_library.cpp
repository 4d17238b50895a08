#include "device/vendor/shared_library.h"

#include <cstdlib>
#include <dlfcn.h>
#include <utility>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr std::size_t kLongestReason = 200;

/// Why the loader refused, which names the library that another one needs and does not find.
std::string loaderReason() {
    const char* reason = dlerror();
    return reason ? printable(reason, kLongestReason) : "no reason given";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

} // namespace

Result<SharedLibrary> SharedLibrary::open(const LibraryWanted& wanted) {
    const char* named = std::getenv(wanted.variable.c_str());
    const std::vector<std::string> files = named && *named ? std::vector<std::string>{named} : wanted.files;
    std::string reason;
    for (const std::string& file : files) {
        // Unloading a library whose threads still run would crash the program: it stays.
        if (void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE))
            return SharedLibrary(handle, file, wanted);
        if (reason.empty()) reason = loaderReason();
    }
    return machineError("The library of " + wanted.name + " cannot be loaded (tried " +
                        printable(joined(files), kLongestReason) + "; " + reason + "): " + wanted.remedy +
                        " Where it lies elsewhere, set " + wanted.variable + " to its file.");
}

SharedLibrary::SharedLibrary(void* handle, std::string file, LibraryWanted wanted)
    : handle_(handle), file_(std::move(file)), wanted_(std::move(wanted)) {}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)), file_(std::move(other.file_)),
      wanted_(std::move(other.wanted_)), missing_(std::move(other.missing_)) {}

SharedLibrary::~SharedLibrary() {
    if (handle_) dlclose(handle_);
}

void* SharedLibrary::address(const char* symbol) const {
    return dlsym(handle_, symbol);
}

Result<void> SharedLibrary::complete() const {
    if (missing_.empty()) return {};
    return machineError("The library of " + wanted_.name + " (" + printable(file_, kLongestReason) +
                        ") has no function " + missing_ +
                        ", so it is another one or too old: " + wanted_.remedy);
}

} // namespace tactum
