// A finger that lies beside an edge or a corner by little of the radius: everywhere around it the proxy is
// about as near, and its plain steps are short. Where it belongs is known all the same: on the ray from the
// edge through the finger.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_near_edges {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kTrials = 400;

/// The half-plane z = 0, x <= 0, its rim in pieces of `piece` metres along y.
Soup blade(double piece) {
    constexpr double kHalf = 0.02, kDeep = 0.03;
    SoupBuilder builder;
    for (double y = -kHalf; y < kHalf; y += piece) {
        const double end = std::min(y + piece, kHalf);
        builder.quad({-kDeep, y, 0}, {0, y, 0}, {0, end, 0}, {-kDeep, end, 0});
    }
    return builder.build();
}

Vec3 around(double angle) {
    return {std::cos(angle), 0, std::sin(angle)};
}

/// Where a finger is beside the rim: how far along, at which angle from straight out, how near.
struct Beside {
    double along, angle, distance;

    Vec3 foot() const { return along * Vec3::UnitY(); }
    Vec3 at(double far) const { return foot() + far * around(angle); }
};

Beside somewhere(Rng& rng, double radius) {
    return {uniform(rng, -0.2, 0.2) * radius, uniform(rng, -1.5, 1.5),
            radius * std::pow(10, uniform(rng, -3.5, -0.5))};
}

} // namespace

class NearEdgesTest : public QObject {
    Q_OBJECT

private slots:
    void theProxyGoesAroundAtOnce_data();
    void theProxyGoesAroundAtOnce();
    void aSmallSlideAlongARimIsNotTakenForARoll();
};

void NearEdgesTest::theProxyGoesAroundAtOnce_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("piece");
    for (double radius : {0.5e-3, 1e-3, 2e-3, 5e-3})
        for (double piece : {0.3e-3, 1e-3, 40e-3})
            QTest::addRow("r %g mm, pieces of %g mm", 1e3 * radius, 1e3 * piece) << radius << piece;
}

// From anywhere around a rim to anywhere else, in one step.
void NearEdgesTest::theProxyGoesAroundAtOnce() {
    QFETCH(double, radius);
    QFETCH(double, piece);
    const Soup soup = blade(piece);
    Rng rng(19);
    double worst = 0;
    int over = 0, bound = 0, mostRounds = 0;
    for (int i = 0; i < kTrials; ++i) {
        ProxyRig rig(soup, radius);
        const Beside from = somewhere(rng, radius), to = somewhere(rng, radius);
        rig.startAt(from.at(1.5 * radius));
        rig.walk(from.at(1.5 * radius), from.at(from.distance), 0.5 * radius, 2);
        const ProxyReport report = rig.step(to.at(to.distance));
        const double off = (rig.position() - to.at(radius)).norm();
        worst = std::max(worst, off);
        over += off > 50 * kMicrometre;
        bound += report.boundHit;
        mostRounds = std::max(mostRounds, report.rounds);
    }
    qInfo("worst %.3f um, %d of %d over 50 um, %d without rounds left, at most %d rounds", 1e6 * worst, over,
          kTrials, bound, mostRounds);
    QCOMPARE(over, 0);
    QCOMPARE(bound, 0);
}

// What is left to go along a rim is known exactly; only the way around it is a guess.
void NearEdgesTest::aSmallSlideAlongARimIsNotTakenForARoll() {
    constexpr double kRadius = 5e-3;
    ProxyRig rig(blade(40e-3), kRadius);
    const Beside from{0, 1.4, 7e-6}, to{2e-6, -1.2, 7e-6};
    rig.startAt(from.at(1.5 * kRadius));
    rig.walk(from.at(1.5 * kRadius), from.at(from.distance), kRadius, 2);
    rig.step(to.at(to.distance));
    QCOMPARE_LT((rig.position() - to.at(kRadius)).norm(), 50 * kMicrometre);
}

TACTUM_TEST(NearEdgesTest)

} // namespace test_near_edges

#include "test_near_edges.moc"
