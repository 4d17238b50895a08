#include "tests/physics/z_width.h"

#include <algorithm>
#include <cmath>

namespace tactum::test {
namespace {

/// The presses that fail first, by experience.
constexpr std::array kHardPresses{Press{0.3, 0}, Press{2.5, 0}, Press{1, 0.3}};

bool fails(const Bench& bench, double stiffness) {
    return std::any_of(kHardPresses.begin(), kHardPresses.end(), [&](const Press& press) {
        return !pressPlain(bench, press, stiffness, 2.5).still(bench.device.resolution);
    });
}

} // namespace

double firstFailure(const Bench& bench) {
    const double step = std::pow(2, 0.25);
    double low = kSoftestWall;
    if (fails(bench, low)) return low;
    double high = low;
    while (!fails(bench, high = std::min(low * step, kStiffestWall))) {
        if (high >= kStiffestWall) return high;
        low = high;
    }
    for (int i = 0; i < 2; ++i) {
        const double middle = std::sqrt(low * high);
        (fails(bench, middle) ? high : low) = middle;
    }
    return high;
}

std::vector<Bench> mapLoops() {
    std::vector<Bench> loops;
    for (const PlantProfile& device : {kTouch, kFalcon, kPremium})
        for (const HandProfile& hand : {kNoHand, kPinch, kGrasp, kFirm, kRigid})
            for (const double rate : {1000.0, 2000.0, 4000.0})
                for (const int delay : {0, 1, 2})
                    loops.push_back({lagging(device), hand, {.rate = rate, .delay = delay, .substeps = 10}});
    return loops;
}

} // namespace tactum::test
