// What gives way to a finger and comes back, or stays: a cabinet, keys, a kettle with a lid, a micro-sensor.
#include <cmath>

#include "resources/make_samples/samples.h"
#include "resources/make_samples/works.h"

namespace tactum::samples {
namespace {

const Look kOak{{0.50f, 0.34f, 0.17f}}, kPale{{0.75f, 0.60f, 0.40f}}, kBrass{{0.75f, 0.55f, 0.20f}};
const Look kIvory{{0.88f, 0.85f, 0.76f}}, kEbony{{0.05f, 0.045f, 0.04f}}, kTin{{0.30f, 0.42f, 0.50f}};
const Look kSilicon{{0.30f, 0.33f, 0.45f}}, kGold{{0.80f, 0.62f, 0.22f}};

} // namespace

Scene cabinet() {
    Works works;
    const std::uint32_t frame = works.still(
        "cabinet", kOak,
        {block({0.19, 0.008, 0.07}, {0, 0.004, 0}), block({0.19, 0.008, 0.07}, {0, 0.146, 0}),
         block({0.008, 0.134, 0.07}, {-0.091, 0.075, 0}), block({0.008, 0.134, 0.07}, {0.091, 0.075, 0}),
         block({0.174, 0.134, 0.006}, {0, 0.075, -0.032}), block({0.006, 0.134, 0.058}, {0.005, 0.075, 0})});
    constexpr double kOpen = 0.5, kOut = 0.02; // rad and m: as they stand at the beginning
    const Vec3 edge(-0.086, 0.075, 0.04);
    const Quat open(Eigen::AngleAxisd(kOpen, -Vec3::UnitY()));
    const BodyId door =
        works.body("door", {open, edge}, 700, kPale,
                   {block({0.086, 0.13, 0.008}, {0.044, 0, 0}), globe(0.006, {0.078, 0, 0.011})});
    Joint& hinge = works.hinge("hinge", kWorldBody, door, edge, -Vec3::UnitY(), frame);
    hinge.limits.push_back(within(true, -kOpen, 1.9 - kOpen));
    hinge.drives = {spring(true, 0, 8e-4), detents(true, 0.25, 0.008)};
    hinge.frictions = {{true, 0, 0.002}};
    for (int i = 0; i < 2; ++i) {
        const Vec3 at(0.0475, 0.042 + 0.066 * i, i * kOut);
        const std::string name = i == 0 ? "lower drawer" : "upper drawer";
        const BodyId drawer =
            works.body(name, {Quat::Identity(), at}, 500, kPale,
                       {block({0.072, 0.06, 0.008}, {0, 0, 0.04}),
                        block({0.066, 0.004, 0.06}, {0, -0.026, 0.006}), globe(0.006, {0, 0, 0.05})});
        Joint& rail = works.slider(name + " rail", kWorldBody, drawer, at, Vec3::UnitZ(), frame);
        rail.limits.push_back(within(false, -i * kOut, 0.055 - i * kOut));
        rail.drives = {spring(false, 0, 1), detents(false, 0.01, 0.5)};
        rail.frictions = {{false, 0, 0.2}};
    }
    const std::vector<FingerKey> keys{
        {0.0, {-0.035, 0.10, 0.13}}, {0.35, {-0.035, 0.10, 0.085}}, {0.8, {-0.035, 0.10, 0.056}},
        {1.2, {-0.035, 0.10, 0.12}}, {1.7, {0.05, 0.118, 0.11}},    {2.1, {0.05, 0.118, 0.046}},
        {2.45, {0.05, 0.16, 0.06}},  {2.8, {0.05, 0.1495, 0.01}},   {3.0, {0.05, 0.16, 0.0}}};
    return works.take(keys);
}

Scene keyboard() {
    Works works;
    const std::uint32_t bed = works.still(
        "bed", kOak,
        {block({0.18, 0.01, 0.12}, {0, -0.018, 0}), block({0.18, 0.034, 0.014}, {0, 0.004, -0.053}),
         block({0.008, 0.03, 0.12}, {-0.086, 0.002, 0}), block({0.008, 0.03, 0.12}, {0.086, 0.002, 0})});
    const auto key = [&](const std::string& name, double x, double y, const Look& look, const Vec3& size,
                         double from) {
        const Vec3 hinge(x, y, -0.046);
        const BodyId body = works.body(name, {Quat::Identity(), hinge}, 700, look,
                                       {block(size, {0, 0, from + size.z() / 2})});
        Joint& joint = works.hinge(name + " pivot", kWorldBody, body, hinge, Vec3::UnitX(), bed);
        joint.limits.push_back(within(true, 0, 0.09));
        joint.drives = {spring(true, 0.4, 4e-3, -0.15)}; // 0.6 N to leave its rest, 1 N at its end
    };
    const char* white[] = {"C", "D", "E", "F", "G", "A", "B", "c"};
    for (int i = 0; i < 8; ++i)
        key(white[i], (i - 3.5) * 0.0205, 0, kIvory, {0.0195, 0.01, 0.09}, 0.006);
    for (const auto& [name, at] :
         {std::pair{"C sharp", 0.5}, {"D sharp", 1.5}, {"F sharp", 3.5}, {"G sharp", 4.5}, {"A sharp", 5.5}})
        key(name, (at - 3.5) * 0.0205, 0.011, kEbony, {0.010, 0.009, 0.052}, 0.006);
    const std::vector<FingerKey> keys{
        {0.0, {-0.072, 0.03, 0.035}},   {0.25, {-0.072, 0.0, 0.035}},  {0.7, {-0.072, 0.0, 0.034}},
        {0.8, {-0.072, 0.014, 0.035}},  {1.1, {-0.031, 0.014, 0.035}}, {1.2, {-0.031, -0.001, 0.035}},
        {1.6, {-0.031, -0.001, 0.034}}, {1.7, {-0.031, 0.014, 0.035}}, {2.1, {0.031, 0.014, 0.035}},
        {2.2, {0.031, -0.001, 0.035}},  {2.6, {0.031, -0.001, 0.034}}, {2.8, {0.031, 0.03, 0.035}}};
    return works.take(keys);
}

Scene kettle() {
    Works works;
    works.still("table", kOak, {block({0.18, 0.008, 0.14}, {0, -0.004, 0})});
    const std::uint32_t pot = works.still(
        "kettle", kTin,
        {rod(0.042, 0.05, {0, 0.025, 0}), turned(capsule(0.008, 0.05, {0.052, 0.036, 0}), -50, Vec3::UnitZ()),
         turned(capsule(0.005, 0.022, {-0.052, 0.042, 0}), 90, Vec3::UnitZ()),
         turned(capsule(0.005, 0.022, {-0.052, 0.014, 0}), 90, Vec3::UnitZ()),
         capsule(0.005, 0.028, {-0.064, 0.028, 0})});
    const Vec3 edge(-0.036, 0.0535, 0);
    const BodyId lid = works.body("lid", {Quat::Identity(), edge}, 2500, kTin,
                                  {rod(0.036, 0.005, {0.036, 0, 0}), rod(0.004, 0.012, {0.036, 0.008, 0})});
    works.trim(lid, "knob", kBrass, {globe(0.009, {0.036, 0.02, 0})});
    Joint& hinge = works.hinge("hinge", kWorldBody, lid, edge, Vec3::UnitZ(), pot);
    hinge.limits.push_back(within(true, 0, 1.8));
    hinge.frictions = {{true, 0, 1e-3}};
    return works.take(2.9, [&](double t) { // under the knob, up with it, down again
        const double come = smoothStep(0, 0.5, t), lift = smoothStep(0.5, 1.5, t) - smoothStep(1.6, 2.4, t);
        const double away = smoothStep(2.4, 2.9, t), a = 0.2 + 1.0 * lift;
        const Vec3 round = edge + 0.0435 * Vec3(std::cos(a), std::sin(a), 0);
        return Vec3(round + Vec3(0.03, 0.01, 0) * (1 - come + away));
    });
}

Scene microSensor() {
    Works works;
    const std::uint32_t frame = works.still(
        "frame", kSilicon,
        {block({0.17, 0.02, 0.014}, {0, 0, 0.063}), block({0.17, 0.02, 0.014}, {0, 0, -0.063}),
         block({0.014, 0.02, 0.112}, {0.078, 0, 0}), block({0.014, 0.02, 0.112}, {-0.078, 0, 0})});
    // 1.7 mm of silicon and gold, drawn 100 times as large: 0.15 mg that swing at 5 to 12 kHz. A newton of
    // the finger is a hundredth of one there, and a second two milliseconds.
    const BodyId mass = works.body("test mass", {}, 2330, kGold, {block({0.09, 0.012, 0.06})});
    works.scale(100, 1e-6, 1, 2e-3);
    std::vector<Piece> beams;
    for (const double x : {-0.06, 0.06})
        for (const double z : {-0.022, 0.022})
            beams.push_back(block({0.032, 0.002, 0.004}, {x, 0, z}));
    works.trim(kWorldBody, "flexures", kSilicon, beams);
    Joint& flexures = works.ball("flexures", kWorldBody, mass, Vec3::Zero(), frame);
    flexures.limits.clear();
    for (const auto& [axis, stiffness] : {std::pair{0, 900.0}, {1, 150.0}, {2, 400.0}}) {
        flexures.drives.push_back(spring(false, stiffness, 8e-4)); // N/m, N s/m
        flexures.drives.back().axis = axis;
        flexures.drives.push_back(spring(true, 0.4, 4e-7)); // N m/rad, as drawn
        flexures.drives.back().axis = axis;
    }
    const std::vector<FingerKey> keys{{0.0, {0.02, 0.03, 0.01}},    {0.3, {0.02, 0.0, 0.01}},
                                      {1.6, {-0.02, 0.0, -0.01}},   {1.9, {-0.02, 0.03, -0.01}},
                                      {2.3, {0.0, 0.02, 0.062}},    {2.5, {0.0, 0.0098, 0.062}},
                                      {2.7, {0.03, 0.0098, 0.062}}, {2.9, {0.03, 0.03, 0.062}}};
    return works.take(keys);
}

} // namespace tactum::samples
