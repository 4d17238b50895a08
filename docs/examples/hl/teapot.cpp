// The teapot as one would draw it with GL, and a hand that presses it: teapot HOST:PORT teapot.obj
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "frames.h"

namespace {

/// Every face of an OBJ as a polygon, corner by corner.
hl::List listOf(const char* file) {
    std::ifstream in(file);
    std::vector<hl::Vec> points;
    const hl::List list = hl::newList();
    for (std::string line, word; std::getline(in, line);) {
        std::istringstream words(line);
        words >> word;
        if (word == "v") {
            hl::Vec p;
            words >> p[0] >> p[1] >> p[2];
            points.push_back(p);
        } else if (word == "f") {
            hl::begin(hl::Polygon);
            while (words >> word) {
                const hl::Vec& p = points.at(std::stoul(word) - 1);
                hl::vertex(p[0], p[1], p[2]);
            }
            hl::end();
        }
    }
    hl::endList();
    return list;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) return std::puts("teapot HOST:PORT teapot.obj"), 2;
    hl::Context context(argv[1], "teapot");
    if (!context.open()) return ended(false, "no server");
    const hl::List teapot = listOf(argv[2]);
    hl::material(hl::Stiffness, 600);
    hl::material(hl::StaticFriction, 0.3);
    hl::material(hl::DynamicFriction, 0.2);
    hl::beginFrame();
    const hl::Instance pot = hl::callList(teapot);
    if (!hl::endFrame()) return ended(false, "the teapot was refused");
    // From in front of its belly inward, until it is felt.
    hl::leadHand(0, 0.04, 0.15);
    run(0.5, [](double) { return std::abs(hl::state().finger[2] - 0.15) < 0.01; });
    hl::arm(true);
    const bool felt = run(30, [](double time) {
        hl::leadHand(0, 0.04, 0.15 - std::min(0.12, 0.12 * time));
        return hl::state().gain == 1 && hl::state().force[2] > 0.3;
    });
    std::printf("%.2f N out of its belly\n", hl::state().force[2]);
    bool touched = false;
    for (hl::Event event; hl::nextEvent(event);)
        touched = touched || (event.kind == hl::Event::Touch && event.instance == pot);
    return ended(felt && touched, "teapot");
}
