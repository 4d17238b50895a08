// A roller coaster: three cars on a closed track with a hill, a loop and banked turns.
#include <cmath>
#include <numbers>

#include "core/dynamics/path_curve.h"
#include "resources/make_samples/samples.h"
#include "resources/make_samples/works.h"

namespace tactum::samples {
namespace {

const Look kRail{{0.62f, 0.10f, 0.08f}}, kPost{{0.80f, 0.80f, 0.78f}}, kGrass{{0.20f, 0.34f, 0.14f}};
const Look kSeat{{0.05f, 0.05f, 0.06f}};
const std::array<Look, 3> kPaint{{{{0.85f, 0.60f, 0.08f}}, {{0.10f, 0.30f, 0.62f}}, {{0.12f, 0.45f, 0.22f}}}};

constexpr double kPi = std::numbers::pi;
constexpr double kLow = 0.02, kTop = 0.085, kLoop = 0.022; // heights of valley and hill, radius of the loop
constexpr double kEnd = 0.075;                             // where the straights end

Vec3 rounded(const Vec3& p) { // so that the last digit of a formula does not change the file
    return (p * 1e6).array().round() / 1e6 + 0.0;
}

/// Points with their ups, one after the other.
class TrackLayout {
public:
    JointPath make() {
        path_.closed = true;
        straightOverTheHill();
        turn({kEnd, 0, 0.003}, 0.047, 0, 0.006);
        straightToTheLoop();
        loop();
        straightFromTheLoop();
        turn({-kEnd, 0, -0.003}, 0.053, kPi, 0.018);
        return std::move(path_);
    }

private:
    void add(const Vec3& point, const Vec3& up = Vec3::UnitY()) {
        path_.points.push_back(rounded(point));
        path_.ups.push_back(rounded(up));
    }
    /// The hill begins at its foot and is as wide as the straight is long.
    void straightOverTheHill() {
        constexpr double kFoot = -0.055, kFar = 0.07;
        for (double x = -kEnd; x < kEnd - 1e-9; x += 0.01) {
            const double part = std::clamp((x - kFoot) / (kFar - kFoot), 0.0, 1.0);
            add({x, kLow + (kTop - kLow) * std::pow(std::sin(kPi * part), 2), 0.05});
        }
    }
    /// Half a circle to the left about a point; it leans in and rises between its ends.
    void turn(const Vec3& centre, double radius, double from, double rise) {
        constexpr int kSteps = 14;
        for (int i = 0; i < kSteps; ++i) {
            const double part = double(i) / kSteps, a = from + kPi * part, lean = std::sin(kPi * part);
            const Vec3 out(std::sin(a), 0, std::cos(a));
            const Vec3 at = centre + radius * out;
            add({at.x(), kLow + rise * lean * lean, at.z()}, Vec3::UnitY() - 0.9 * lean * out);
        }
    }
    void straightToTheLoop() {
        for (double x = kEnd; x > 0.015; x -= 0.012)
            add({x, kLow, -0.044});
    }
    /// Once around, and aside so that it does not meet itself.
    void loop() {
        constexpr int kSteps = 24;
        for (int i = 0; i <= kSteps; ++i) {
            const double a = 2 * kPi * i / kSteps, aside = smoothStep(0, 2 * kPi, a);
            add({-kLoop * std::sin(a), kLow + kLoop * (1 - std::cos(a)), -0.044 - 0.012 * aside},
                {std::sin(a), std::cos(a), 0});
        }
    }
    void straightFromTheLoop() {
        for (double x = -0.015; x > -kEnd + 1e-9; x -= 0.012)
            add({x, kLow, -0.056});
    }

    JointPath path_;
};

/// A round bar beside the curve.
void sweep(Mesh& mesh, const PathCurve& curve, const Vec3& beside, double radius) {
    constexpr int kSides = 6;
    const int rings = int(std::lround(curve.length() / 0.003));
    std::vector<std::vector<Index>> all;
    for (int r = 0; r < rings; ++r) {
        const Pose at = curve.at(curve.length() * r / rings).pose;
        std::vector<Index>& ring = all.emplace_back();
        for (int i = 0; i < kSides; ++i) {
            const double a = 2 * kPi * i / kSides;
            ring.push_back(
                mesh.point(at.apply(beside + Vec3(0, radius * std::cos(a), radius * std::sin(a)))));
        }
    }
    for (int r = 0; r < rings; ++r)
        for (int i = 0; i < kSides; ++i) {
            const auto& here = all[std::size_t(r)];
            const auto& next = all[std::size_t((r + 1) % rings)];
            const std::size_t k = std::size_t(i), l = std::size_t((i + 1) % kSides);
            mesh.quad(here[k], here[l], next[l], next[k]);
        }
}

Mesh railsOf(const PathCurve& curve) {
    Mesh mesh;
    sweep(mesh, curve, {0, 0, 0.0045}, 0.0008);
    sweep(mesh, curve, {0, 0, -0.0045}, 0.0008);
    sweep(mesh, curve, {0, -0.004, 0}, 0.0014);
    const int ties = int(std::lround(curve.length() / 0.010));
    for (int i = 0; i < ties; ++i)
        mesh.box({-0.0007, -0.0036, -0.0042}, {0.0007, -0.0008, 0.0042},
                 curve.at(curve.length() * i / ties).pose);
    return mesh;
}

/// Wherever the track lies rather than hangs.
std::vector<Piece> postsOf(const PathCurve& curve) {
    std::vector<Piece> posts;
    const int count = int(std::lround(curve.length() / 0.026));
    for (int i = 0; i < count; ++i) {
        const Pose at = curve.at(curve.length() * i / count).pose;
        const Vec3 top = at.apply({0, -0.0045, 0});
        if ((at.rotation * Vec3::UnitY()).y() < 0.45) continue;
        posts.push_back(rod(0.0016, top.y(), {top.x(), top.y() / 2, top.z()}));
    }
    return posts;
}

std::vector<Piece> carPieces() {
    return {block({0.017, 0.006, 0.0105}, {0, 0.0045, 0}),
            block({0.004, 0.005, 0.0105}, {-0.0065, 0.010, 0})};
}

} // namespace

Scene rollerCoaster() {
    Works works;
    const JointPath path = TrackLayout().make();
    const PathCurve curve = PathCurve::through(path).value();
    works.still("ground", kGrass, {block({0.29, 0.006, 0.15}, {0, -0.003, 0})});
    works.decor("rails", kRail, railsOf(curve));
    works.trim(kWorldBody, "posts", kPost, postsOf(curve));
    // In the valley before the hill, one behind the other; the last one waits in the turn.
    const double front = curve.nearest({Quat::Identity(), Vec3(-0.062, kLow, 0.05)});
    std::vector<Vec3> places;
    for (int i = 0; i < 3; ++i) {
        const Pose at = curve.at(front - 0.021 * i).pose;
        const BodyId car =
            works.body("car " + std::to_string(i + 1), at, 4000, kPaint[std::size_t(i)], carPieces());
        works.trim(car, "seat " + std::to_string(i + 1), kSeat,
                   {block({0.006, 0.002, 0.008}, {-0.001, 0.0085, 0})});
        Joint& rides = works.ride("track " + std::to_string(i + 1), car, path);
        rides.frictions = {{false, 0, 0.0015}};
        places.push_back(at.translation);
        if (i == 0) continue;
        Joint& coupling = works.ball("coupling " + std::to_string(i), BodyId(i), car, at.translation);
        coupling.frameA = coupling.frameB = Pose{};
        JointLimit length;
        length.min = length.max = (places[std::size_t(i)] - places[std::size_t(i - 1)]).norm();
        length.stiffness = 3000, length.damping = 0.3;
        coupling.limits = {length};
    }
    Scene scene = works.take(3.6, [&](double t) { // behind the last car, up the hill, and away
        const double way = front - 0.07 + 0.185 * smoothStep(0.5, 1.7, t);
        const double away = 1 - smoothStep(0, 0.5, t) + smoothStep(1.75, 2.1, t);
        return Vec3(curve.at(way).pose.apply({0, 0.005, 0}) + Vec3(0, 0.06, 0.03) * away);
    });
    scene.mechanics.airDensity = 1.2;
    return scene;
}

} // namespace tactum::samples
