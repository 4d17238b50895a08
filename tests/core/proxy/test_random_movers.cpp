// The invariants of the proxy among random bodies that move by themselves, rest, and move again.

#include <QTest>

#include "core/proxy/carry_bounds.h"
#include "tests/core/proxy/carry_stage.h"
#include "tests/core/proxy/random_trial.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_random_movers {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kSteps = 160;
// All bodies move for some steps and rest for some.
constexpr int kPhase = 20;
// What passes over the proxy may come as near as this before it is left out, in radii; it is felt again once
// there is a way back for half of it.
constexpr double kNearest = 0.5 * (1 - kMaxGive);

struct Trial {
    explicit Trial(std::uint64_t number)
        : rng(0x70eed000 + number), half(kRadius * uniform(rng, 2, 10)), material(someMaterial(rng)),
          slide(kRadius * std::pow(10, uniform(rng, -2, 0.3))), turn(std::pow(10, uniform(rng, -3, -0.5))),
          stride(kRadius * std::pow(10, uniform(rng, -2, 0.5))) {
        const int bodies = 1 + int(rng() % 3);
        for (int i = 0; i < bodies; ++i) {
            closed.push_back(rng() % 3 == 0);
            soups.push_back(closed.back() ? dentedBall(rng, half) : someSoup(rng, half));
        }
        rests = bodies > 1 && rng() % 2; // the last of them does
        outward = rng() % 2;
    }

    // Two that are told the same must do the same.
    void furnish(Stage& stage) const {
        for (std::size_t i = 0; i < soups.size(); ++i)
            rests&& i + 1 == soups.size() ? stage.addStatic(soups[i]) : void(stage.addMover(soups[i]));
    }
    int movers() const { return int(soups.size()) - int(rests); }

    Rng rng;
    double half;
    Material material;
    double slide, turn, stride;
    std::vector<Soup> soups;
    std::vector<bool> closed;
    bool rests, outward;
};

struct Observer {
    Observer(Trial& theTrial, Stage& theStage) : trial(theTrial), stage(theStage) {}

    Pose poseOf(std::size_t body) const {
        return int(body) < trial.movers() ? stage.pose(int(body)) : Pose();
    }
    bool hasPassed(std::size_t body) const {
        const auto end = stage.state.passed.begin() + stage.state.passedCount;
        return std::any_of(stage.state.passed.begin(), end,
                           [&](const PassedBody& p) { return p.body == body; });
    }
    // To what is felt, in radii.
    double clear() const {
        double least = 1e300;
        for (std::size_t i = 0; i < trial.soups.size(); ++i)
            if (!hasPassed(i))
                least =
                    std::min(least, clearance(*trial.soups[i], poseOf(i).applyInverse(stage.state.position)));
        return least / kRadius;
    }
    bool isFree(const Vec3& way) const {
        for (std::size_t i = 0; i < trial.soups.size(); ++i) {
            const Vec3 from = poseOf(i).applyInverse(stage.state.position);
            const Vec3 way_B = poseOf(i).rotation.conjugate() * way;
            for (std::size_t k = 0; k < trial.soups[i]->triangles.size(); ++k)
                if (sweepSphere(triangleOf(*trial.soups[i], k), from, way_B, kRadius) <= 1) return false;
        }
        return true;
    }
    bool freezes(const Vec3& finger) {
        return couldComeNearer(stage.state.position, finger, kRadius, trial.rng,
                               [this](const Vec3& way) { return isFree(way); });
    }

    // It starts outside; what passed over it is felt again on the side from which it came.
    bool isWithinABody() const {
        for (std::size_t i = 0; i < trial.soups.size(); ++i)
            if (trial.closed[i] && !hasPassed(i) &&
                isInside(*trial.soups[i], poseOf(i).applyInverse(stage.state.position)))
                return true;
        return false;
    }

    // What a step that has just been made did wrong.
    QString faultOf(const ProxyReport& report, const Vec3& before, const Vec3& finger, bool moving) {
        const Vec3 proxy = stage.state.position;
        if (!proxy.allFinite()) return "is not finite";
        const double now = clear();
        if (now < kNearest) return QString("keeps %1 r only").arg(now);
        if (isWithinABody()) return "is within a closed body";
        const bool had = wasClear;
        wasClear = now >= 1 - kPushOut && stage.state.passedCount == 0;
        if (!had || report.squeezed || report.passed) return {};
        if (!wasClear) return QString("is %1 r inside").arg(1 - now);
        const double growth = (proxy - finger).norm() - (before - finger).norm();
        if (!moving && growth > kPushOut * kRadius) return QString("retreats by %1 r").arg(growth / kRadius);
        return {};
    }

    Trial& trial;
    Stage& stage;
    bool wasClear = false;
};

bool isMoving(int step) {
    return step / kPhase % 2 == 0;
}

/// In all trials.
struct Counted {
    int steps = 0, clear = 0, squeezed = 0;
};

// The first thing that goes wrong in a trial, and where.
QString faultIn(Trial& trial, Counted& counted) {
    Stage stage(trial.material), again(trial.material);
    trial.furnish(stage);
    trial.furnish(again);
    const Vec3 start(0, 0, 2.5 * trial.half + 2 * kRadius);
    stage.startAt(start);
    again.startAt(start);
    Observer observer(trial, stage);
    Vec3 before = start;
    ProxyReport report;
    const auto moveBodies = [&] {
        for (int m = 0; m < trial.movers(); ++m) {
            const Pose to = wandered(stage.pose(m), trial.rng, trial.slide, trial.turn, trial.half);
            stage.put(m, to);
            again.put(m, to);
        }
    };
    return firstFault(
        somePath(trial.rng, start, kSteps, trial.half, trial.stride),
        [&](int i, const Vec3& finger) {
            if (isMoving(i)) moveBodies();
            before = stage.state.position;
            report = stage.step(finger);
            again.step(finger);
            return again.state.position == stage.state.position;
        },
        [&](int i, const Vec3& finger) {
            const QString fault = observer.faultOf(report, before, finger, isMoving(i));
            ++counted.steps;
            counted.clear += observer.wasClear;
            counted.squeezed += report.squeezed;
            return fault;
        },
        [&](int i, const Vec3& finger) {
            return !isMoving(i) && observer.wasClear && trial.material == frictionless() &&
                   observer.freezes(finger);
        });
}

} // namespace

class RandomMoversTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepKeepsTheInvariants();
};

void RandomMoversTest::everyStepKeepsTheInvariants() {
    Counted counted;
    const QString fault = failures(3'000, [&](std::uint64_t number) {
        Trial trial(number);
        return faultIn(trial, counted);
    });
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    qInfo("of %d steps %d clear, %d squeezed", counted.steps, counted.clear, counted.squeezed);
    // Else the invariants would say nothing, for a step that squeezes is excused from them.
    QCOMPARE_GT(counted.clear, 0.8 * counted.steps);
    QCOMPARE_LT(counted.squeezed, 0.01 * counted.steps);
}

TACTUM_TEST(RandomMoversTest)

} // namespace test_random_movers

#include "test_random_movers.moc"
