// The invariants of the proxy over random soups whose surfaces are felt from one side alone, or from none.

#include <QTest>

#include "tests/core/proxy/random_trial.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_random_sides {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kSteps = 120;

struct Trial {
    // All surfaces felt from `sides`, or each as it comes.
    Trial(std::uint64_t number, std::optional<Sides> all)
        : rng(0x51de5000 + number), radius(std::pow(10, uniform(rng, -4.5, -1.5))),
          half(radius * uniform(rng, 2, 15)), stride(radius * std::pow(10, uniform(rng, -2, 0.5))) {
        auto mixed = std::make_shared<TriangleSoup>(*(all ? dentedBall(rng, half) : someSoup(rng, half)));
        for (Index& surface : mixed->surfaceOf)
            surface = all ? 0 : Index(rng() % 4);
        soup = mixed;
        material = someMaterial(rng);
        Scene scene = sceneOf(soup, material, radius);
        scene.objects[0].surfaces.resize(all ? 1 : 4, scene.objects[0].surfaces[0]);
        for (int i = 0; i < int(scene.objects[0].surfaces.size()); ++i)
            scene.objects[0].surfaces[std::size_t(i)].sides = all.value_or(Sides(i));
        for (const Surface& surface : scene.objects[0].surfaces)
            sides.push_back(surface.sides);
        world = compile(scene).value();
    }

    Sides sidesOf(std::size_t triangle) const { return sides[soup->surfaceOf[triangle]]; }
    bool isFeltFrom(std::size_t triangle, const Vec3& p) const {
        return isFelt(sidesOf(triangle), triangleOf(*soup, triangle), p);
    }
    // To all that is felt from anywhere.
    double clear(const Vec3& p) const {
        double least = 1e300;
        for (std::size_t k = 0; k < soup->triangles.size(); ++k)
            if (sidesOf(k) != Sides::None) least = std::min(least, toTriangle(k, p));
        return least;
    }
    double toTriangle(std::size_t k, const Vec3& p) const {
        return (p - closestPoint(triangleOf(*soup, k), p).point).norm();
    }
    bool isClear(double distance) const { return distance >= (1 - kPushOut) * radius; }
    bool freezes(const Vec3& proxy, const Vec3& finger) {
        return couldComeNearer(proxy, finger, radius, rng, [&](const Vec3& way) {
            for (std::size_t k = 0; k < soup->triangles.size(); ++k)
                if (isFeltFrom(k, proxy) && sweepSphere(triangleOf(*soup, k), proxy, way, radius) <= 1)
                    return false;
            return true;
        });
    }

    Rng rng;
    double radius, half, stride;
    Soup soup;
    Material material;
    std::vector<Sides> sides;
    std::shared_ptr<const World> world;
};

// Of what was felt from where the proxy was, and is from where it is and from the finger, nothing reaches
// into it. With a finger on the other side it may go there around an edge, and come back through what it then
// was behind of.
bool keepsClear(const Trial& trial, const Vec3& before, const Vec3& now, const Vec3& finger) {
    for (std::size_t k = 0; k < trial.soup->triangles.size(); ++k)
        if (trial.isFeltFrom(k, before) && trial.isFeltFrom(k, now) && trial.isFeltFrom(k, finger) &&
            !trial.isClear(trial.toTriangle(k, now)))
            return false;
    return true;
}

// What is felt from both sides is never passed; what is felt from one, not from there in a short step.
QString faultOf(Trial& trial, const Vec3& before, const Vec3& proxy, const Vec3& finger) {
    if (!proxy.allFinite()) return "is not finite";
    for (std::size_t k = 0; k < trial.soup->triangles.size(); ++k)
        if (trial.sidesOf(k) == Sides::Both && !trial.isClear(trial.toTriangle(k, proxy)))
            return QString("is %1 r inside").arg(1 - trial.toTriangle(k, proxy) / trial.radius);
    const double growth = (proxy - finger).norm() - (before - finger).norm();
    if (growth > kPushOut * trial.radius) return QString("retreats by %1 r").arg(growth / trial.radius);
    const bool isShort = (proxy - before).norm() < 0.5 * trial.radius;
    if (isShort && trial.isClear(trial.clear(before)) && !keepsClear(trial, before, proxy, finger))
        return "comes through from where it is felt";
    return {};
}

template <class Also> QString faultIn(Trial& trial, const Vec3& start, Also&& also) {
    Hand hand(trial.world), again(trial.world);
    Vec3 before = start;
    return firstFault(
        somePath(trial.rng, start, kSteps, trial.half, trial.stride),
        [&](int i, const Vec3& finger) {
            before = i > 0 ? hand.state.proxy.position : finger;
            return hand.to(finger).proxy == again.to(finger).proxy;
        },
        [&](int, const Vec3& finger) {
            const QString fault = faultOf(trial, before, hand.output().proxy, finger);
            return fault.isEmpty() ? also(hand.output().proxy) : fault;
        },
        [&](int, const Vec3& finger) {
            const Vec3 proxy = hand.output().proxy;
            return trial.material == frictionless() && trial.isClear(trial.clear(proxy)) &&
                   trial.freezes(proxy, finger);
        });
}

} // namespace

class RandomSidesTest : public QObject {
    Q_OBJECT

private slots:
    void mixedSoups();
    void whatIsFeltFromOutsideIsNeverEntered();
    void whatIsFeltFromInsideIsNeverLeft();
};

void RandomSidesTest::mixedSoups() {
    const QString fault = failures(2'000, [](std::uint64_t number) {
        Trial trial(number, {});
        Vec3 start(0, 0, 3 * trial.half + 2 * trial.radius);
        for (int i = 0; i < 20; ++i)
            if (const Vec3 p = inBox(trial.rng, 1.2 * trial.half); clearance(*trial.soup, p) > trial.radius)
                start = p;
        return faultIn(trial, start, [](const Vec3&) { return QString(); });
    });
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void RandomSidesTest::whatIsFeltFromOutsideIsNeverEntered() {
    const QString fault = failures(1'000, [](std::uint64_t number) {
        Trial trial(number, Sides::Front);
        return faultIn(trial, Vec3(0, 0, 1.5 * trial.half + 2 * trial.radius), [&](const Vec3& proxy) {
            const bool isOut = trial.isClear(trial.clear(proxy)) && !isInside(*trial.soup, proxy);
            return isOut ? QString() : QString("is within");
        });
    });
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

// From outside it comes in freely; once it was within, clear of the wall, it stays so.
void RandomSidesTest::whatIsFeltFromInsideIsNeverLeft() {
    int held = 0, tried = 0;
    const QString fault = failures(2'000, [&](std::uint64_t number) {
        Trial trial(number, Sides::Back);
        ++tried;
        bool isHeld = false;
        return faultIn(trial, Vec3(0, 0, 1.5 * trial.half + 2 * trial.radius), [&](const Vec3& proxy) {
            const bool isIn = trial.isClear(trial.clear(proxy)) && isInside(*trial.soup, proxy);
            if (isHeld && !isIn) return QString("got out");
            held += isIn && !isHeld;
            isHeld |= isIn;
            return QString();
        });
    });
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QCOMPARE_GT(held, tried / 10);
}

TACTUM_TEST(RandomSidesTest)

} // namespace test_random_sides

#include "test_random_sides.moc"
