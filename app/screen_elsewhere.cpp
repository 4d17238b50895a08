// The program without a screen.
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <unistd.h>

#include "app/picture.h"
#include "app/screen.h"
#include "app/window.h"

namespace tactum {

Result<void> reachScreen(char** argv) {
    std::error_code fault;
    const auto program =
        std::filesystem::read_symlink("/proc/self/exe", fault).parent_path() / "tactum-window";
    if (!fault) execv(program.c_str(), argv);
    return machineError(program.string() + ": cannot be started (" + std::strerror(errno) +
                        "); install the program again");
}

// Nobody comes here: reachScreen() stands before.
int runWindow(int, char**, const std::optional<std::filesystem::path>&) {
    assert(false);
    return 3;
}

Result<void> writePicture(const Scene&, const TouchTrace&, const std::filesystem::path& file) {
    return machineError(file.string() + ": cannot be drawn by this program; start tactum-window");
}

} // namespace tactum
