#include <tactum/error.h>
#include <tactum/version.h>

namespace tactum::library {

Error::Error(Kind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}
Error::~Error() = default;

const char* version() noexcept {
    return TACTUM_VERSION;
}

} // namespace tactum::library
