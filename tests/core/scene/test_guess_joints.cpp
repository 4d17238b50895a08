// Hinges and sliders guessed for shapes whose axis is known, wherever they lie.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/scene/arrange.h"
#include "core/scene/bodies.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_guess_joints {

using namespace tactum;
using namespace tactum::test;

namespace {

TriangleSoup disc(double radius, double thickness) {
    TriangleSoup soup;
    constexpr Index kSides = 24;
    for (Index i = 0; i < kSides; ++i)
        for (const double end : {-0.5, 0.5}) {
            const double a = 2 * std::numbers::pi * i / kSides;
            soup.positions.push_back({radius * std::cos(a), radius * std::sin(a), end * thickness});
        }
    for (Index i = 0; i < 2 * kSides; ++i)
        soup.triangles.push_back({i, (i + 1) % (2 * kSides), (i + 2) % (2 * kSides)});
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return soup;
}

/// A thing that moves, what stands around it, and its axis.
struct Case {
    const char* name;
    AxisKind kind;
    TriangleSoup thing;
    std::vector<std::pair<Vec3, Vec3>> still; ///< sizes of boxes, and their middles
    Vec3 axis, at;                            ///< a place on it
};

std::vector<Case> cases() {
    using enum AxisKind;
    return {
        {"a door at its post",
         Hinge,
         box({0.08, 0.13, 0.008}),
         {{{0.01, 0.2, 0.02}, {-0.046, 0, 0}}},
         Vec3::UnitY(),
         {-0.04, 0, 0.004}},
        {"a square door at its post",
         Hinge,
         box({0.1, 0.1, 0.008}),
         {{{0.01, 0.2, 0.02}, {-0.056, 0, 0}}},
         Vec3::UnitY(),
         {-0.05, 0, 0.004}},
        {"a lid on the back of a box",
         Hinge,
         box({0.1, 0.01, 0.06}, {0, 0.03, 0}),
         {{{0.1, 0.04, 0.004}, {0, 0.004, -0.028}}},
         Vec3::UnitX(),
         {0, 0.025, -0.03}},
        {"a flap below a beam",
         Hinge,
         box({0.12, 0.05, 0.004}, {0, -0.03, 0}),
         {{{0.14, 0.01, 0.01}, {0, 0, 0}}},
         Vec3::UnitX(),
         {0, -0.005, 0.002}},
        {"a wheel", Hinge, disc(0.05, 0.01), {{{0.02, 0.2, 0.02}, {0, 0, -0.03}}}, Vec3::UnitZ(), {0, 0, 0}},
        {"a knob", Hinge, disc(0.01, 0.03), {{{0.1, 0.1, 0.01}, {0, 0, -0.02}}}, Vec3::UnitZ(), {0, 0, 0}},
        {"a drawer between walls",
         Slider,
         box({0.1, 0.04, 0.08}),
         {{{0.12, 0.01, 0.08}, {0, 0.026, 0}},
          {{0.12, 0.01, 0.08}, {0, -0.026, 0}},
          {{0.01, 0.06, 0.08}, {0.056, 0, 0}},
          {{0.01, 0.06, 0.08}, {-0.056, 0, 0}},
          {{0.12, 0.06, 0.01}, {0, 0, -0.046}}},
         Vec3::UnitZ(),
         {0, 0, 0}},
        {"a button in a plate",
         Slider,
         box({0.02, 0.02, 0.02}),
         {{{0.03, 0.01, 0.02}, {0, 0.016, 0}},
          {{0.03, 0.01, 0.02}, {0, -0.016, 0}},
          {{0.01, 0.02, 0.02}, {0.016, 0, 0}},
          {{0.01, 0.02, 0.02}, {-0.016, 0, 0}}},
         Vec3::UnitZ(),
         {0, 0, 0}},
        {"a sledge on a long rail",
         Slider,
         box({0.03, 0.02, 0.02}, {0, 0.02, 0}),
         {{{0.3, 0.018, 0.02}, {0, 0, 0}}},
         Vec3::UnitX(),
         {0, 0.02, 0}},
        {"a stick in the open", Slider, box({0.01, 0.2, 0.01}), {}, Vec3::UnitY(), {0, 0, 0}},
    };
}

} // namespace

class TestGuessJoints : public QObject {
    Q_OBJECT

private slots:
    // Upright, and turned with all around it.
    void theAxisIsTheKnownOne() {
        Arrangement turned;
        turned.move = {0.1, 0.2, -0.1};
        turned.turn = Quat(Eigen::AngleAxisd(0.6, Vec3(2, -1, 1).normalized()));
        for (const Case& each : cases())
            for (const Arrangement& by : {Arrangement{}, turned}) {
                Scene scene;
                const ObjectId id = add(scene, each.name, each.thing, by.apply(Pose{}));
                for (const auto& [size, middle] : each.still)
                    add(scene, "still", box(size, middle), by.apply(Pose{}));
                const BodyId body = makeBody(scene, id);
                const AxisJoint guess = guessedJoint(scene, body, each.kind);
                QVERIFY2(std::abs(guess.axis.dot(by.turn * each.axis)) > 1 - 1e-9, each.name);
                const Vec3 off = guess.at - by.apply(each.at);
                const double away = (off - off.dot(guess.axis) * guess.axis).norm();
                QVERIFY2(away < 0.0101, qPrintable(QStringLiteral("%1: %2 m").arg(each.name).arg(away)));
                QCOMPARE_GT(guess.damping, 0);
                QCOMPARE_GE(guessedJoints(scene, body, each.kind).size(), std::size_t(3));
            }
    }
};

TACTUM_TEST(TestGuessJoints)

} // namespace test_guess_joints

#include "test_guess_joints.moc"
