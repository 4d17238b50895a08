// The invariants of the proxy over random soups, sizes, paths and feels.

#include <QTest>

#include "tests/core/proxy/felt_rig.h"
#include "tests/core/proxy/random_trial.h"
#include "tests/support/test_program.h"

namespace test_random_soups {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kSteps = 120;

struct Trial {
    explicit Trial(std::uint64_t number) : rng(0x5eed0000 + number) {
        radius = std::pow(10, uniform(rng, -4.5, -1.5));
        half = radius * uniform(rng, 2, 15);
        soup = someSoup(rng, half);
        material = someMaterial(rng);
        shaded = rng() % 4 == 0;
        if (shaded && rng() % 2) soup = withNormals(soup, [&](const Vec3&) { return direction(rng); });
        stride = radius * std::pow(10, uniform(rng, -2, 0.5));
        start = freePlace();
        world = shadedWorld(soup, material, radius, shaded);
    }

    bool isPlain() const { return !shaded; }
    bool isFrictionless() const { return material == frictionless(); }

    // Outside of everything, often among it.
    Vec3 freePlace() {
        for (int i = 0; i < 20; ++i)
            if (const Vec3 p = inBox(rng, 1.2 * half); clearance(*soup, p) > radius) return p;
        return Vec3(0, 0, 3 * half + 2 * radius);
    }

    Rng rng;
    double radius, half, stride;
    Soup soup;
    Material material;
    bool shaded;
    Vec3 start;
    std::shared_ptr<const World> world;
};

bool freezes(const Trial& trial, const Hand& hand, Rng& rng) {
    const Vec3 proxy = hand.state.proxy.position;
    return couldComeNearer(proxy, hand.finger(), trial.radius, rng, [&](const Vec3& way) {
        for (std::size_t k = 0; k < trial.soup->triangles.size(); ++k)
            if (sweepSphere(triangleOf(*trial.soup, k), proxy, way, trial.radius) <= 1) return false;
        return true;
    });
}

// What is wrong with a step that has just been made; empty when nothing is.
QString faultOf(const Trial& trial, const Hand& hand, const Vec3& before) {
    const Vec3 proxy = hand.state.proxy.position, finger = hand.finger();
    if (!proxy.allFinite() || !hand.output().force.allFinite()) return "is not finite";
    const double inside = trial.radius - clearance(*trial.soup, proxy);
    if (inside > kPushOut * trial.radius) return QString("is %1 r inside").arg(inside / trial.radius);
    const double growth = (proxy - finger).norm() - (before - finger).norm();
    if (trial.isPlain() && growth > kPushOut * trial.radius)
        return QString("retreats by %1 r").arg(growth / trial.radius);
    return {};
}

// The first thing that goes wrong in a trial, and where.
QString faultIn(Trial& trial) {
    Hand hand(trial.world), again(trial.world);
    Rng rng(trial.rng());
    Vec3 before = trial.start;
    return firstFault(
        somePath(trial.rng, trial.start, kSteps, trial.half, trial.stride),
        [&](int i, const Vec3& finger) {
            before = i > 0 ? hand.state.proxy.position : finger;
            return hand.to(finger).proxy == again.to(finger).proxy;
        },
        [&](int, const Vec3&) { return faultOf(trial, hand, before); },
        [&](int, const Vec3&) {
            return trial.isPlain() && trial.isFrictionless() && freezes(trial, hand, rng);
        });
}

} // namespace

class RandomSoupsTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepKeepsTheInvariants();
    void whatFrozeOnceDoesNot_data();
    void whatFrozeOnceDoesNot();
};

void RandomSoupsTest::everyStepKeepsTheInvariants() {
    const QString fault = failures(20'000, [](std::uint64_t number) {
        Trial trial(number);
        return faultIn(trial);
    });
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

// Curved guesses that led from corner to corner of a spike until no round was left, in each step anew.
void RandomSoupsTest::whatFrozeOnceDoesNot_data() {
    QTest::addColumn<quint64>("number");
    for (const quint64 number : {213217, 336887})
        QTest::addRow("soup %llu", number) << number;
}

void RandomSoupsTest::whatFrozeOnceDoesNot() {
    QFETCH(const quint64, number);
    Trial trial(number);
    QCOMPARE(faultIn(trial), QString());
}

TACTUM_TEST(RandomSoupsTest)

} // namespace test_random_soups

#include "test_random_soups.moc"
