// The program with a screen.
#include "app/display.h"
#include "app/screen.h"

namespace tactum {

Result<void> reachQt(char**) {
    return {};
}

Result<void> reachScreen(char**) {
    return checkDisplay();
}

} // namespace tactum
