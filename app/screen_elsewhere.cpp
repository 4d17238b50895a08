// The program without a screen.
#include <cassert>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <unistd.h>

#include "app/picture.h"
#include "app/screen.h"
#include "app/window.h"
#include "core/base/child_program.h"

namespace tactum {

Result<void> reachScreen(char** argv) {
    execv(programBeside("tactum-window").c_str(), argv);
    return machineError(std::string("tactum-window: cannot be started (") + std::strerror(errno) +
                        "); install the program again");
}

// Nobody comes here: reachScreen() stands before.
int runWindow(int, char**, const WindowRequest&) {
    assert(false);
    return 3;
}

Result<void> writePicture(const Scene&, const TouchTrace&, const std::filesystem::path& file) {
    return machineError(file.string() + ": cannot be drawn by this program; start tactum-window");
}

} // namespace tactum
