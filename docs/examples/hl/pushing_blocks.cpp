// A game of pushing blocks: what moves them is the server, the program only says that they are there and
// draws where they are. pushing_blocks HOST:PORT
#include <algorithm>

#include "frames.h"

namespace {

/// A box about its middle, corners counter-clockwise from outside.
hl::List box(double x, double y, double z) {
    constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                  {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    const hl::List list = hl::newList();
    hl::begin(hl::Quads);
    for (const auto& face : kFaces)
        for (const int corner : face)
            hl::vertex(corner & 4 ? x / 2 : -x / 2, corner & 2 ? y / 2 : -y / 2, corner & 1 ? z / 2 : -z / 2);
    hl::end();
    hl::endList();
    return list;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::puts("pushing_blocks HOST:PORT"), 2;
    hl::Context context(argv[1], "pushing blocks");
    if (!context.open()) return ended(false, "no server");
    const hl::List floor = box(0.4, 0.02, 0.2), block = box(0.03, 0.03, 0.03);
    hl::proxyRadius(4e-3);
    hl::leadHand(-0.06, 0.016, 0);
    // Not before the finger is there: what comes to be around it is felt from inside.
    const auto isThere = [] { return hl::state().finger[0] < -0.05 && hl::state().finger[1] > 0.015; };
    if (!run(5, [&](double) { return isThere(); })) return ended(false, "the hand did not come");
    hl::beginFrame();
    hl::pushMatrix();
    hl::translate(0, -0.01, 0);
    hl::callList(floor);
    hl::popMatrix();
    hl::Instance first = 0, second = 0;
    for (const double x : {0.0, 0.05}) {
        hl::pushMatrix();
        hl::translate(x, 0.0151, 0);
        hl::mass(0.05);
        (x == 0 ? first : second) = hl::callList(block);
        hl::popMatrix();
    }
    if (!hl::endFrame()) return ended(false, "the blocks were refused");
    run(1, [](double) { return false; });
    hl::arm(true);
    hl::Place one, two;
    const bool pushed = run(30, [&](double time) {
        hl::leadHand(std::min(0.08, -0.06 + 0.05 * time), 0.016, 0);
        return hl::placeOf(first, one) && hl::placeOf(second, two) && one.position[0] > 0.03 &&
               two.position[0] > 0.06;
    });
    std::printf("the first block is at %.0f mm, the second at %.0f mm\n", 1e3 * one.position[0],
                1e3 * two.position[0]);
    return ended(pushed, "pushing blocks");
}
