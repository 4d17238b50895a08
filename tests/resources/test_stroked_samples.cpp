// The samples with a texture under the simulated hand, in the loop that a person is in: what a tick changes,
// and whether the hand gets on.
//
// The judge is the formula that a picture was made of, stroked by the same finger by a micrometre at a time
// (tests/support/slow_slide.h). It would be wrong if the finger hardly touched, or if the relief were so flat
// that nothing of it could be missed: how long it touches, and how much of the force is the relief's, is
// looked at.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <QTest>

#include "core/haptics/compile.h"
#include "resources/make_samples/reliefs.h"
#include "resources/make_samples/samples.h"
#include "tests/physics/as_connected.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/slow_slide.h"
#include "tests/support/test_program.h"

namespace test_stroked_samples {

using namespace tactum;
using namespace tactum::test;

namespace {

// From so far within a piece on the formula is stroked, and so much farther on it is judged: what was before
// is forgotten by then. m
constexpr double kBegins = 3e-3, kSettles = 3e-3;
// Ticks at the edge of friction's cone, in which one of the two just does not go on.
constexpr int kChance = 5;
constexpr std::array kThem{kPinch, kGrasp, kFirm};
constexpr double kPush = 1; ///< N, of the hand, beside what its own path asks for

struct Tick {
    Vec3 finger = Vec3::Zero(), proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero();   ///< of the haptic step, N
    Vec3 command = Vec3::Zero(); ///< that left for the device, N
};

struct Stroke {
    std::vector<Tick> ticks;
    std::uint64_t faults = 0, oscillations = 0;
};

/// The hand is led along the sample's own finger path and pushes along `in` beside.
Stroke stroked(const Scene& scene, const HandProfile& hand, const Vec3& in) {
    Proxy proxy(compile(scene).value(), 2000);
    Servo servo(connectedInfo(kOmegaConnected), proxy);
    servo.settings.grasped = hand.gripDamping >= kGrasp.gripDamping;
    ClosedLoop loop(benchOf(kOmegaConnected, hand), servo.control(), 3);
    loop.plant.place(scene.finger->front().position);
    loop.plant.setGoal(scene.finger->front().position);
    loop.warmUp();
    Stroke stroke;
    for (const FingerPoint& point : *scene.finger) {
        loop.plant.setGoal(point.position + kPush / hand.armStiffness * in);
        loop.tick();
        stroke.ticks.push_back(
            {proxy.state.proxy.finger, proxy.output.proxy, proxy.output.force, loop.command});
    }
    stroke.faults = servo.state.gate.faults();
    stroke.oscillations = servo.state.schedule.oscillations();
    return stroke;
}

/// What is felt of a flat piece of a sample, in its own axes.
struct Piece {
    Scene scene;
    Vec3 in;   ///< where the hand pushes
    Pose pose; ///< x and y along the piece, z out of it, from where its formula counts
    /// How far the finger is inside of it, m.
    std::function<double(const Vec3& finger)> inside;
    std::function<double(double x, double y)> height;
    std::function<Material(double x, double y)> material;

    Vec3 inIt(const Vec3& p) const { return pose.applyInverse(p); }
    SlowSlide slide() const {
        constexpr double kStep = 1e-7;
        return {[this](const Eigen::Vector2d& at) -> Eigen::Vector2d {
                    const double x = at.x(), y = at.y();
                    return Eigen::Vector2d(height(x + kStep, y) - height(x - kStep, y),
                                           height(x, y + kStep) - height(x, y - kStep)) /
                           (2 * kStep);
                },
                [this](const Eigen::Vector2d& at) { return material(at.x(), at.y()); }};
    }
};

Vec3 ontoTheWall() {
    return Eigen::AngleAxisd(-0.7, Vec3::UnitX()) * -Vec3::UnitZ();
}

constexpr double kRadius = 1e-3;                      // m: of the samples' proxy
constexpr double kPanel = 0.08, kPanelHeight = 0.056; // m

/// One panel of the wall. The clicks at its edges are the mesh's own.
Piece panel(std::size_t which, double (*height)(double, double), std::size_t (*surface)(double, double)) {
    Piece piece;
    piece.scene = samples::textureWall();
    piece.in = ontoTheWall();
    const SceneObject& object = piece.scene.objects[which];
    piece.pose = object.pose;
    piece.inside = [](const Vec3& finger) {
        return std::min({finger.x(), kPanel - finger.x(), finger.y(), kPanelHeight - finger.y()});
    };
    piece.height = height;
    piece.material = [surfaces = object.surfaces, surface](double x, double y) {
        return surfaces[surface(x, y)].material;
    };
    return piece;
}

Piece coin() {
    Piece piece;
    piece.scene = samples::reliefCoin();
    piece.in = -Vec3::UnitY();
    piece.pose.rotation = Quat(Eigen::AngleAxisd(-0.5 * std::numbers::pi, Vec3::UnitX()));
    piece.pose.translation = {0, 7e-3, 0};
    piece.inside = [](const Vec3& finger) { return 44e-3 - finger.head<2>().norm(); };
    piece.height = samples::coinHeight;
    piece.material = [material = piece.scene.objects[0].surfaces[0].material](double, double) {
        return material;
    };
    return piece;
}

Piece pieceOf(const QString& name) {
    if (name == "brick") return panel(0, samples::brickHeight, samples::brickSurface);
    if (name == "tiles") return panel(1, samples::tileHeight, samples::tileSurface);
    return coin();
}

} // namespace

class TestStrokedSamples : public QObject {
    Q_OBJECT

private slots:
    void aPictureIsFeltAsItsFormula_data() {
        QTest::addColumn<QString>("piece");
        QTest::addColumn<int>("hand");
        for (const char* piece : {"brick", "tiles", "coin"})
            for (int hand = 0; hand < int(kThem.size()); ++hand)
                QTest::addRow("%s, %s", piece, kThem[std::size_t(hand)].name) << piece << hand;
    }

    /// Tick by tick along the surface, for the finger that the loop led.
    void aPictureIsFeltAsItsFormula() {
        QFETCH(QString, piece);
        QFETCH(int, hand);
        const Piece on = pieceOf(piece);
        const Stroke stroke = stroked(on.scene, kThem[std::size_t(hand)], on.in);
        SlowSlide slide = on.slide();
        double step = 0, rightStep = 0, off = 0, relief = 0;
        int judged = 0, stops = 0, rightStops = 0;
        Eigen::Vector2d last = Eigen::Vector2d::Zero(), lastRight = last, lastFinger = last;
        bool was = false;
        for (const Tick& tick : stroke.ticks) {
            const Vec3 finger = on.inIt(tick.finger), proxy = on.inIt(tick.proxy);
            const double depth = kRadius - finger.z();
            const Eigen::Vector2d right = slide.to(finger.head<2>(), on.inside(finger) > kBegins ? depth : 0);
            const Eigen::Vector2d felt = (proxy - finger).head<2>();
            const bool is = on.inside(finger) > kBegins + kSettles && depth > 0.2e-3;
            if (is && was) {
                const double stiffness = tick.force.norm() / (tick.proxy - tick.finger).norm();
                const double way = (finger.head<2>() - lastFinger).norm();
                step = std::max(step, stiffness * (felt - last).norm());
                rightStep = std::max(rightStep, stiffness * (right - lastRight).norm());
                off = std::max(off, std::min((felt - right).norm(), (felt - lastRight).norm()) / depth);
                relief = std::max(relief, right.norm() / depth);
                const auto stands = [&](const Eigen::Vector2d& now, const Eigen::Vector2d& before) {
                    return way > 1e-5 && (now + finger.head<2>() - before - lastFinger).norm() < 0.01 * way;
                };
                stops += stands(felt, last), rightStops += stands(right, lastRight), ++judged;
            }
            was = is, last = felt, lastRight = right, lastFinger = finger.head<2>();
        }
        qInfo("%d ticks, off by %.3f of the depth, step %.3f of %.3f N, %d of %d stops, relief %.2f", judged,
              off, step, rightStep, stops, rightStops, relief);
        QCOMPARE_GT(judged, 400);
        QCOMPARE_GT(relief, 0.4);
        QCOMPARE_LT(off, 0.08);
        QCOMPARE_LT(step, 1.2 * rightStep);
        QCOMPARE_LE(stops, rightStops + kChance);
    }

    void theHandGetsOn_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("hand");
        for (const char* name : {"texture-wall", "layered-leather", "relief-coin"})
            for (int hand = 0; hand < int(kThem.size()); ++hand)
                QTest::addRow("%s, %s", name, kThem[std::size_t(hand)].name) << name << hand;
    }

    /// Of a whole stroke, what leaves for the device. A seam that held whatever pushed along the table had
    /// taken all of its 12 N, and steep flanks under friction let go of up to 3 N at once.
    void theHandGetsOn() {
        QFETCH(QString, name);
        QFETCH(int, hand);
        const Vec3 in = name == "texture-wall" ? ontoTheWall() : Vec3(-Vec3::UnitY());
        const Scene scene = name == "texture-wall"      ? samples::textureWall()
                            : name == "layered-leather" ? samples::layeredLeather()
                                                        : samples::reliefCoin();
        const Stroke stroke = stroked(scene, kThem[std::size_t(hand)], in);
        double push = 0, step = 0, farthest = -1, aim = -1;
        for (std::size_t i = 0; i < stroke.ticks.size(); ++i) {
            const Vec3& command = stroke.ticks[i].command;
            push = std::max(push, command.norm());
            if (i > 0) step = std::max(step, (command - stroke.ticks[i - 1].command).norm());
            farthest = std::max(farthest, stroke.ticks[i].proxy.x());
            aim = std::max(aim, (*scene.finger)[i].position.x());
        }
        qInfo("at most %.2f N, %.2f N in a tick, %.1f of %.1f mm", push, step, 1e3 * farthest, 1e3 * aim);
        QCOMPARE_EQ(stroke.faults, 0u);
        QCOMPARE_EQ(stroke.oscillations, 0u);
        QCOMPARE_LT(push, 3.2);
        QCOMPARE_LT(step, 0.8);
        QCOMPARE_GT(farthest, aim - 5e-3);
    }
};

TACTUM_TEST(TestStrokedSamples)

} // namespace test_stroked_samples

#include "test_stroked_samples.moc"
