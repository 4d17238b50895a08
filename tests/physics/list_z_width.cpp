// Writes the Z-width map as CSV: the baseline of test_stability_map, and what docs/stability.md draws.
#include <cstdio>

#include "core/safety/safe_stiffness.h"
#include "tests/physics/z_width.h"

using namespace tactum;
using namespace tactum::test;

int main() {
    std::puts("device,hand,rate,delay,first_failure,safe");
    for (const Bench& bench : mapLoops())
        std::printf("%s,%s,%g,%d,%.0f,%.0f\n", bench.device.name, bench.hand.name, bench.timing.rate,
                    bench.timing.delay, firstFailure(bench), safeStiffness(loopFigures(infoOf(bench))).value);
}
