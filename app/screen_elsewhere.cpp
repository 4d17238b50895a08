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

Result<void> reachQt(char** argv) {
    execv(programBeside("tactum-window").c_str(), argv);
    return machineError(std::string("tactum-window: cannot be started (") + std::strerror(errno) +
                        "); install the program again");
}

Result<void> reachScreen(char** argv) {
    return reachQt(argv);
}

// Nobody comes here: reachScreen() or reachQt() stands before.
int runWindow(int, char**, const WindowRequest&) {
    assert(false);
    return 3;
}

Result<int> runReport(const ReportOptions& options) {
    return machineError(options.out.string() + ": cannot be written by this program; start tactum-window");
}

Result<void> writePicture(const Scene&, const TouchTrace&, const std::filesystem::path& file) {
    return machineError(file.string() + ": cannot be drawn by this program; start tactum-window");
}

Result<void> writeVideo(const std::shared_ptr<const RecordedRun>&, const std::filesystem::path& file, int,
                        bool) {
    return machineError(file.string() + ": cannot be drawn by this program; start tactum-window");
}

} // namespace tactum
