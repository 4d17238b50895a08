#include "core/bundle/bundle_readme.h"

#include <algorithm>

#include "core/base/numbers.h"

namespace tactum {
namespace {

constexpr const char* kFiles = R"(# A scene to be touched

Everything is in metres, seconds, newtons and radians, in one right-handed frame whose y axis points up.

| file | is |
|---|---|
| `scene.glb` | the scene: glTF 2.0, how it feels in the extension `TACTUM_haptics` of its materials |
| `scene.x3d`, `deviceinfo.x3d`, pictures in `maps` | the same for H3DAPI; what is lost on the way is in `report.md` |
| `finger.csv` | where the finger is: time `t` in s, `x,y,z` in m |
| `forces.csv` | what it must feel there, row by row: time, finger, proxy, and the force on the hand in N |
| `preview.png` | a picture |
| `report.md` | for each target what is kept, degraded or lost |
| `manifest.json` | name, length and SHA-256 of every file but itself |

The *finger* is where the hand is, and goes into what it touches. The *proxy* is the middle of a sphere that stays
outside; spring and damper pull the finger to it. A positive force pushes the finger. The forces are those before any
device's limit, for one haptic step a row, each as long as the time since the row before (the first one 1 ms).
)";

constexpr const char* kCheck = R"(
To hold another renderer against it: step through `finger.csv`, and compare with `forces.csv`. `tactum verify` does
so with the scene that is in the bundle; a difference below a millionth of a newton counts as none.
)";

} // namespace

std::string shortest(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

bool touchesAnything(const TouchTrace& rows) {
    return std::ranges::any_of(rows, [](const TouchRow& row) { return row.contacts > 0; });
}

double largestForceOf(const TouchTrace& rows) {
    double most = 0;
    for (const TouchRow& row : rows)
        most = std::max(most, row.force.norm());
    return most;
}

std::string bundleReadme(const Scene& scene, const TouchTrace& rows) {
    std::string text = kFiles;
    text += "\nRadius of the proxy here: " + shortest(scene.proxyRadius) + " m. " +
            std::to_string(rows.size()) + " steps, largest force " + shortest(largestForceOf(rows)) + " N.";
    if (!touchesAnything(rows)) text += " **The finger path touches nothing.**";
    return text + '\n' + kCheck;
}

} // namespace tactum
