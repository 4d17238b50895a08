#include "core/base/scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace tactum {

ScratchFolder::ScratchFolder(std::string_view purpose) {
    std::error_code fault;
    const std::filesystem::path all = std::filesystem::temp_directory_path(fault);
    std::string name = (all / ("tactum-" + std::string(purpose) + "-XXXXXX")).string();
    if (!fault && mkdtemp(name.data())) path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code fault;
    if (!path_.empty()) std::filesystem::remove_all(path_, fault);
}

} // namespace tactum
