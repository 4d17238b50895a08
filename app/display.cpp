#include "app/display.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ui/view/surface_format.h"

namespace tactum {

namespace {

constexpr int kDraws = 0, kNoOpenGl = 1;

std::string_view given(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string displayName() {
    return std::string(given("DISPLAY").empty() ? given("WAYLAND_DISPLAY") : given("DISPLAY"));
}

// Qt cannot draw in 3-D on its displays without a screen.
bool isNamed() {
    const std::string_view platform = given("QT_QPA_PLATFORM");
    return !platform.starts_with("offscreen") && !platform.starts_with("minimal") && !displayName().empty();
}

// What Qt says of its end there is for nobody, and leaves no dump.
void dieSilently() {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    if (!std::freopen("/dev/null", "w", stderr)) _exit(kDraws);
}

[[noreturn]] void tryToDraw() {
    dieSilently();
    useViewSurfaceFormat();
    int argc = 1;
    char name[] = "tactum";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.create();
    _exit(context.create() && context.makeCurrent(&surface) ? kDraws : kNoOpenGl);
}

} // namespace

Result<void> checkDisplay() {
    if (!isNamed())
        return machineError("there is no display to draw on; use another verb, or start it under xvfb-run");
    const pid_t child = fork();
    if (child < 0) return {}; // too little of everything: what comes next says so better
    if (child == 0) tryToDraw();
    int status = 0;
    if (waitpid(child, &status, 0) != child) return {};
    if (!WIFEXITED(status))
        return machineError(
            "the display " + displayName() +
            " cannot be reached; check the variable DISPLAY and that you may use it, or start it "
            "under xvfb-run");
    if (WEXITSTATUS(status) != kDraws)
        return machineError("the display " + displayName() +
                            " has no OpenGL 3.2; install its driver, or Mesa's, or start it under xvfb-run");
    return {};
}

} // namespace tactum
