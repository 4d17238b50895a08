// What lies loose or hangs: balls on a table, dominoes, a bell on a rope, a marionette.
#include <cmath>

#include "resources/make_samples/samples.h"
#include "resources/make_samples/works.h"

namespace tactum::samples {
namespace {

const Look kBaize{{0.08f, 0.30f, 0.16f}}, kWood{{0.36f, 0.22f, 0.11f}}, kBone{{0.85f, 0.82f, 0.72f}};
const Look kBronze{{0.55f, 0.38f, 0.14f}}, kRope{{0.62f, 0.52f, 0.36f}}, kBlue{{0.12f, 0.22f, 0.50f}};
const Look kSkin{{0.80f, 0.58f, 0.42f}}, kRed{{0.62f, 0.10f, 0.08f}};

} // namespace

Scene ballTable() {
    Works works;
    works.still("cloth", kBaize, {block({0.184, 0.01, 0.14}, {0, -0.005, 0})});
    works.still(
        "rail", kWood,
        {block({0.2, 0.024, 0.008}, {0, 0.002, 0.074}), block({0.2, 0.024, 0.008}, {0, 0.002, -0.074}),
         block({0.008, 0.024, 0.14}, {0.096, 0.002, 0}), block({0.008, 0.024, 0.14}, {-0.096, 0.002, 0})});
    const Eigen::Vector3f colours[] = {{0.70f, 0.10f, 0.08f}, {0.80f, 0.62f, 0.10f}, {0.10f, 0.20f, 0.55f},
                                       {0.40f, 0.10f, 0.45f}, {0.80f, 0.35f, 0.06f}, {0.08f, 0.40f, 0.20f}};
    const double r = 0.011;
    works.body("cue ball", {Quat::Identity(), {-0.06, r, 0}}, 1700, kBone, {globe(r)});
    for (int row = 0, ball = 0; row < 3; ++row)
        for (int i = 0; i <= row; ++i, ++ball) {
            const Vec3 at(0.02 + row * 0.0192, r, (i - row / 2.0) * 0.0222);
            works.body("ball " + std::to_string(ball + 1), {Quat::Identity(), at}, 1700, {colours[ball]},
                       {globe(r)});
        }
    const std::vector<FingerKey> keys{{0.0, {-0.09, 0.04, 0}},       {0.3, {-0.09, 0.012, 0}},
                                      {0.7, {-0.02, 0.012, 0}},      {1.1, {-0.02, 0.03, 0.05}},
                                      {1.3, {-0.02, -0.0005, 0.05}}, {2.7, {-0.08, -0.0005, 0.045}},
                                      {2.9, {-0.08, 0.03, 0.05}}};
    return works.take(keys);
}

Scene dominoes() {
    Works works;
    works.still("table", kWood, {block({0.2, 0.008, 0.14}, {0, -0.004, 0})});
    const int count = 16;
    for (int i = 0; i < count; ++i) { // along an S
        const double s = i / double(count - 1), x = -0.08 + 0.16 * s, z = 0.035 * std::sin(6.2832 * s);
        const double slope = 0.035 * 6.2832 * std::cos(6.2832 * s) / 0.16;
        const Quat turn(Eigen::AngleAxisd(-std::atan(slope), Vec3::UnitY()));
        works.body("domino " + std::to_string(i + 1), {turn, {x, 0.0125, z}}, 1200, i % 2 ? kBone : kBlue,
                   {block({0.004, 0.025, 0.013})});
    }
    const std::vector<FingerKey> keys{{0.0, {-0.095, 0.05, -0.012}},  {0.3, {-0.095, 0.021, -0.008}},
                                      {0.8, {-0.075, 0.021, 0.006}},  {1.1, {-0.09, 0.03, 0.04}},
                                      {1.3, {-0.08, -0.0005, 0.055}}, {2.6, {0.03, -0.0005, 0.055}},
                                      {2.8, {0.03, 0.03, 0.055}}};
    return works.take(keys);
}

Scene bell() {
    Works works;
    const std::uint32_t gallows =
        works.still("gallows", kWood,
                    {block({0.16, 0.008, 0.1}, {0, -0.004, 0}), block({0.01, 0.18, 0.012}, {-0.07, 0.09, 0}),
                     block({0.01, 0.18, 0.012}, {0.07, 0.09, 0}), block({0.16, 0.01, 0.014}, {0, 0.185, 0})});
    BodyId above = kWorldBody;
    double y = 0.178;
    const double link = 0.016;
    for (int i = 0; i < 5; ++i, y -= link) {
        const std::string name = "rope " + std::to_string(i + 1);
        const BodyId piece = works.body(name, {Quat::Identity(), {0, y - link / 2, 0}}, 900, kRope,
                                        {capsule(0.0025, link - 0.005)});
        works.ball(name + " joint", above, piece, {0, y, 0}, above == kWorldBody ? gallows : 0).drives = {
            spring(true, 0, 2e-5), spring(true, 0, 2e-5), spring(true, 0, 2e-5)};
        for (int axis = 0; axis < 3; ++axis)
            works.last().drives[std::size_t(axis)].axis = axis;
        above = piece;
    }
    const BodyId brass = works.body(
        "bell", {Quat::Identity(), {0, y - 0.02, 0}}, 1500, kBronze,
        {globe(0.014, {0, 0.004, 0}), rod(0.016, 0.018, {0, -0.006, 0}), rod(0.021, 0.006, {0, -0.018, 0})});
    works.ball("bell joint", above, brass, {0, y, 0});
    const std::vector<FingerKey> keys{{0.0, {0.05, y - 0.02, 0.0}},  {0.5, {0.0, y - 0.02, 0.0}},
                                      {0.8, {-0.01, y - 0.02, 0.0}}, {1.25, {0.03, 0.04, 0.02}},
                                      {1.55, {0.03, -0.0005, 0.03}}, {2.7, {-0.03, -0.0005, 0.03}},
                                      {2.9, {-0.03, 0.03, 0.03}}};
    return works.take(keys);
}

Scene marionette() {
    Works works;
    const std::uint32_t cross = works.still(
        "cross", kWood,
        {block({0.16, 0.006, 0.012}, {0, 0.196, 0}), block({0.012, 0.006, 0.09}, {0, 0.196, 0.02})});
    works.still("stage", kWood, {block({0.18, 0.008, 0.1}, {0, -0.004, 0})});
    const auto limb = [&](const std::string& name, BodyId to, const Vec3& from, const Vec3& way,
                          double radius, const Look& look) {
        const Quat turn = Quat::FromTwoVectors(Vec3::UnitY(), way);
        const BodyId body = works.body(name, {turn, from + way / 2}, 600, look,
                                       {capsule(radius, std::max(1e-3, way.norm() - 2 * radius))});
        Joint& joint = works.ball(name + " joint", to, body, from);
        for (int axis = 0; axis < 3; ++axis) {
            joint.drives.push_back(spring(true, 0, 3e-5));
            joint.drives.back().axis = axis;
        }
        return body;
    };
    const BodyId chest =
        works.body("chest", {Quat::Identity(), {0, 0.105, 0}}, 600, kRed, {block({0.034, 0.036, 0.018})});
    const BodyId hips = limb("hips", chest, {0, 0.086, 0}, {0, -0.018, 0}, 0.008, kBlue);
    const BodyId head = works.body("head", {Quat::Identity(), {0, 0.141, 0}}, 600, kSkin, {globe(0.014)});
    works.ball("neck", chest, head, {0, 0.125, 0});
    const auto string = [&](const std::string& name, BodyId to, const Vec3& from, const Vec3& top) {
        const Vec3 way = top - from;
        const BodyId body = works.body(name, {Quat::FromTwoVectors(Vec3::UnitY(), way), from + way / 2}, 900,
                                       kRope, {capsule(0.0012, way.norm() - 0.006)});
        works.ball(name + " knot", to, body, from);
        works.ball(name + " peg", kWorldBody, body, top, cross);
    };
    string("head string", head, {0, 0.157, 0}, {0, 0.193, 0});
    for (const double side : {-1.0, 1.0}) {
        const std::string which = side < 0 ? "left " : "right ";
        const BodyId arm =
            limb(which + "arm", chest, {side * 0.021, 0.119, 0}, {side * 0.024, -0.008, 0}, 0.005, kRed);
        const BodyId hand =
            limb(which + "hand", arm, {side * 0.046, 0.111, 0}, {side * 0.026, 0, 0.004}, 0.0045, kSkin);
        const BodyId thigh = limb(which + "thigh", hips, {side * 0.010, 0.066, 0},
                                  {side * 0.004, -0.026, 0.004}, 0.006, kBlue);
        const BodyId shin =
            limb(which + "shin", thigh, {side * 0.014, 0.039, 0.004}, {0, -0.026, -0.002}, 0.0055, kBlue);
        limb(which + "foot", shin, {side * 0.014, 0.012, 0.002}, {side * 0.002, -0.002, 0.016}, 0.005, kWood);
        string(which + "hand string", hand, {side * 0.074, 0.116, 0.004}, {side * 0.074, 0.193, 0.0});
        string(which + "knee string", thigh, {side * 0.014, 0.044, 0.011}, {side * 0.004, 0.193, 0.06});
    }
    const std::vector<FingerKey> keys{{0.0, {0.05, 0.165, 0.04}},    {0.4, {0.055, 0.13, 0.006}},
                                      {0.75, {0.055, 0.095, 0.006}}, {1.1, {0.04, 0.05, 0.04}},
                                      {1.45, {0.05, -0.0005, 0.04}}, {2.7, {-0.05, -0.0005, 0.04}},
                                      {2.9, {-0.05, 0.03, 0.04}}};
    return works.take(keys);
}

} // namespace tactum::samples
