// What turns: a windmill, a crank with its piston, a turntable; and a car that a rocket drives along its
// track.
#include <cmath>

#include "resources/make_samples/samples.h"
#include "resources/make_samples/works.h"

namespace tactum::samples {
namespace {

const Look kWood{{0.42f, 0.26f, 0.13f}}, kStone{{0.55f, 0.53f, 0.48f}}, kCloth{{0.86f, 0.80f, 0.66f}};
const Look kSteel{{0.45f, 0.50f, 0.56f}}, kBrass{{0.75f, 0.55f, 0.20f}}, kRed{{0.62f, 0.10f, 0.08f}};
const Look kVinyl{{0.03f, 0.03f, 0.035f}, {.stiffness = 800, .staticFriction = 0.5, .dynamicFriction = 0.4}};

Piece lying(Piece piece) { // along z
    return turned(std::move(piece), 90, Vec3::UnitX());
}

} // namespace

Scene windmill() {
    Works works;
    const Vec3 hub(0, 0.11, 0.03);
    works.still("meadow", {{0.25f, 0.40f, 0.16f}}, {block({0.18, 0.006, 0.12}, {0, -0.003, 0})});
    const std::uint32_t tower =
        works.still("tower", kStone,
                    {rod(0.022, 0.06, {0, 0.03, 0}), rod(0.018, 0.05, {0, 0.085, 0}),
                     globe(0.02, {0, 0.112, 0}), lying(rod(0.003, 0.03, {0, 0.11, 0.02}))});
    std::vector<Piece> cross{lying(rod(0.007, 0.01))}, sails;
    for (int i = 0; i < 4; ++i) {
        const Quat turn(Eigen::AngleAxisd(0.5 * 3.14159265358979 * i + 0.2, Vec3::UnitZ()));
        for (auto [piece, to] : {std::pair{block({0.003, 0.076, 0.004}, {0, 0.04, 0}), &cross},
                                 {block({0.018, 0.055, 0.002}, {0.008, 0.048, 0}), &sails}}) {
            piece.pose = Pose{turn, turn * piece.pose.translation};
            to->push_back(piece);
        }
    }
    std::vector<Piece> all = cross;
    all.insert(all.end(), sails.begin(), sails.end());
    const BodyId mill = works.body("sails", {Quat::Identity(), hub}, 600, kCloth, all);
    works.hinge("axle", kWorldBody, mill, hub, Vec3::UnitZ(), tower).drives = {
        motor(true, 1.5, 400, 1000)}; // the wind
    // 18 m of a mill, drawn a hundredth as large, whose 14 t are 14 g to the finger.
    works.scale(0.01, 1e6, 1e6, 1);
    const std::vector<FingerKey> keys{{0.0, {0.04, 0.18, 0.03}},    {0.6, {0.04, 0.10, 0.03}},
                                      {1.0, {0.04, 0.06, 0.03}},    {1.3, {0.06, 0.03, 0.04}},
                                      {1.5, {0.06, -0.0005, 0.04}}, {2.6, {-0.06, -0.0005, 0.04}},
                                      {2.8, {-0.06, 0.03, 0.04}}};
    return works.take(keys);
}

Scene crank() {
    Works works;
    const Vec3 axle(-0.05, 0.05, 0), pin = axle + Vec3(0, 0.02, 0);
    const double reach = std::sqrt(0.07 * 0.07 - 0.02 * 0.02);
    const Vec3 piston = axle + Vec3(reach, 0, 0.011);
    const std::uint32_t frame = works.still("frame", kWood,
                                            {block({0.2, 0.008, 0.09}, {0, -0.004, 0}),
                                             block({0.016, 0.05, 0.012}, {-0.05, 0.025, -0.018}),
                                             lying(rod(0.004, 0.014, {-0.05, 0.05, -0.011})),
                                             block({0.077, 0.004, 0.03}, {0.0465, 0.0355, 0.011}),
                                             block({0.077, 0.004, 0.03}, {0.0465, 0.0645, 0.011}),
                                             block({0.012, 0.06, 0.03}, {0.091, 0.03, 0.011})});
    const BodyId wheel = works.body("wheel", {Quat::Identity(), axle}, 4000, kSteel,
                                    {lying(rod(0.032, 0.008)), lying(rod(0.0025, 0.03, {0, 0.02, 0.015})),
                                     globe(0.007, {0, 0.02, 0.032})});
    const Vec3 mid = 0.5 * (pin + axle + Vec3(reach, 0, 0)) + Vec3(0, 0, 0.011);
    const Quat along(Eigen::AngleAxisd(std::atan2(-0.02, reach), Vec3::UnitZ()));
    const BodyId rod =
        works.body("connecting rod", {along, mid}, 2700, kBrass, {block({0.078, 0.009, 0.006})});
    const BodyId plug =
        works.body("piston", {Quat::Identity(), piston}, 2700, kRed, {block({0.03, 0.022, 0.024})});
    Joint& bearing = works.hinge("axle", kWorldBody, wheel, axle, Vec3::UnitZ(), frame);
    bearing.drives = {motor(true, 0, 2e-4, 1)};
    bearing.frictions = {{true, 0, 0.008}}; // what it weighs does not turn it
    works.hinge("crank pin", wheel, rod, pin + Vec3(0, 0, 0.011), Vec3::UnitZ());
    works.hinge("piston pin", rod, plug, piston, Vec3::UnitZ());
    works.slider("cylinder", kWorldBody, plug, piston, Vec3::UnitX(), frame).frictions = {{false, 0, 0.1}};
    return works.take(2.5, [&](double t) { // behind the knob, one and a half times around
        const double come = smoothStep(0, 0.4, t), go = smoothStep(2.1, 2.5, t);
        const double a = 9.4 * smoothStep(0.4, 2.1, t) - 0.6;
        const Vec3 round = axle + Vec3(0.02 * std::sin(a), 0.02 * std::cos(a), 0.032);
        return Vec3(round + Vec3(0, 0, 0.03) * (1 - come + go));
    });
}

Scene turntable() {
    Works works;
    const std::uint32_t box = works.still(
        "box", kWood, {block({0.18, 0.02, 0.16}, {0, 0.01, 0}), rod(0.012, 0.006, {0, 0.023, 0})});
    const BodyId disc = works.body("record", {Quat::Identity(), {0, 0.030, 0}}, 1500, kVinyl,
                                   {rod(0.072, 0.006), rod(0.0025, 0.014, {0, 0.007, 0})});
    works.trim(disc, "label", kRed, {rod(0.024, 0.0004, {0, 0.0032, 0})});
    works.trim(disc, "mark", kCloth, {block({0.02, 0.0004, 0.003}, {0.05, 0.0032, 0})});
    works.hinge("bearing", kWorldBody, disc, {0, 0.03, 0}, Vec3::UnitY(), box).drives = {
        motor(true, -3.49, 0.01, 0.012)}; // 33 1/3 a minute; a finger can hold it
    const std::vector<FingerKey> keys{{0.0, {0.05, 0.06, 0}},
                                      {0.5, {0.05, 0.032, 0}},
                                      {1.3, {0.05, 0.032, 0.001}},
                                      {2.1, {0.03, 0.0325, 0.04}},
                                      {2.6, {0.03, 0.06, 0.04}}};
    return works.take(keys);
}

Scene rocketCar() {
    Works works;
    const std::uint32_t track = works.still(
        "track", kStone,
        {block({0.2, 0.006, 0.06}, {0, -0.003, 0}), block({0.006, 0.03, 0.06}, {0.097, 0.009, 0}),
         block({0.006, 0.03, 0.06}, {-0.097, 0.009, 0}), block({0.188, 0.004, 0.006}, {0, 0.002, 0})});
    const Vec3 at(-0.066, 0.022, 0);
    const BodyId car =
        works.body("car", {Quat::Identity(), at}, 900, kRed,
                   {block({0.05, 0.014, 0.03}), block({0.022, 0.012, 0.024}, {-0.004, 0.013, 0})});
    works.trim(car, "rocket", kSteel, {turned(capsule(0.007, 0.03, {-0.012, 0.022, 0}), 90, Vec3::UnitZ())});
    works.trim(car, "wheels", kVinyl,
               {lying(rod(0.009, 0.005, {0.015, -0.008, 0.0175})),
                lying(rod(0.009, 0.005, {-0.015, -0.008, 0.0175})),
                lying(rod(0.009, 0.005, {0.015, -0.008, -0.0175})),
                lying(rod(0.009, 0.005, {-0.015, -0.008, -0.0175}))});
    Joint& rail = works.slider("rail", kWorldBody, car, at, Vec3::UnitX(), track);
    rail.limits.push_back(within(false, 0, 0.1));
    rail.drives = {motor(false, 0.6, 1.5, 0.35)}; // a thrust of 0.35 N
    const std::vector<FingerKey> keys{{0.0, {0.09, 0.07, 0}},    {0.5, {0.088, 0.024, 0}},
                                      {1.4, {-0.02, 0.024, 0}},  {2.2, {0.04, 0.024, 0}},
                                      {2.5, {0.06, 0.05, 0.02}}, {2.9, {0.06, 0.08, 0}}};
    return works.take(keys);
}

} // namespace tactum::samples
