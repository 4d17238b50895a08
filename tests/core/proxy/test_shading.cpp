// Force shading (section 3) through whole haptic steps: facets that feel round, and what it costs in energy.

#include <QTest>

#include "core/geometry/corner_normals.h"
#include "core/proxy/felt_planes.h"
#include "tests/core/proxy/felt_rig.h"
#include "tests/support/compare.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

Q_DECLARE_METATYPE(tactum::test::Soup)

namespace test_shading {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kR = 0.05;      // of the prism's corners
constexpr double kInside = 3e-3; // of the finger, below the corners
constexpr double kStep = 1e-4;   // of the finger, from update to update

Vec3 around(double s, double radius) {
    return {radius * std::cos(2 * kPi * s), 0.001, radius * std::sin(2 * kPi * s)};
}

Round roundThePrism(const Soup& prism, double proxyRadius, bool shaded) {
    Hand hand(shadedWorld(prism, frictionless(), proxyRadius, shaded));
    const double radius = kR - kInside;
    return goAround(
        hand, around(0, 1.2 * kR), int(2 * kPi * radius / kStep), [&](double s) { return around(s, radius); },
        [](double s) { return Vec3(std::cos(2 * kPi * s), 0, std::sin(2 * kPi * s)); });
}

// Every facet a little outward, so that no two share a corner.
Soup exploded(const TriangleSoup& soup, double way) {
    auto result = std::make_shared<TriangleSoup>(soup);
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const Triangle t = triangleOf(soup, i);
        const Vec3 normal = (t.b - t.a).cross(t.c - t.a).normalized();
        for (Index corner : soup.triangles[i])
            result->positions[corner] += way * normal;
    }
    return result;
}

Soup flipped(const TriangleSoup& soup) {
    auto result = std::make_shared<TriangleSoup>(soup);
    for (auto& normal : result->cornerNormals)
        normal = -normal;
    return result;
}

// Mirrored in x with the corners in their old order: the facets now look inward.
Soup mirrored(const TriangleSoup& soup) {
    auto result = std::make_shared<TriangleSoup>(soup);
    for (Vec3& p : result->positions)
        p.x() = -p.x();
    for (auto& normal : result->cornerNormals)
        normal.x() = -normal.x();
    return result;
}

Soup withRandomNormals(const Soup& soup, Rng& rng) {
    auto result = std::make_shared<TriangleSoup>(*soup);
    for (std::size_t i = 0; i < 3 * soup->triangles.size(); ++i)
        result->cornerNormals.push_back(direction(rng).cast<float>());
    return result;
}

// A right-angled valley along y whose normals lean along it by a slope.
Soup leaningGroove(double slope) {
    auto soup = std::make_shared<TriangleSoup>(*wedge(0.5 * kPi, 0.1));
    for (std::size_t i = 0; i < soup->triangles.size(); ++i) {
        const Triangle t = triangleOf(*soup, i);
        Vec3 up = (t.b - t.a).cross(t.c - t.a).normalized();
        if (up.z() < 0) up = -up;
        for (int k = 0; k < 3; ++k)
            soup->cornerNormals.push_back((up - slope * Vec3::UnitY()).normalized().cast<float>());
    }
    return soup;
}

Soup smoothed(const Soup& soup) {
    auto result = std::make_shared<TriangleSoup>(*soup);
    result->cornerNormals = cornerNormalsOf(*soup, kPi).value();
    return result;
}

QString text(const Round& round) {
    return QString("%1 degrees off, jumps of %2 degrees, %3 mJ, %4 N, %5 rounds")
        .arg(round.worstDirection)
        .arg(round.largestJump)
        .arg(1e3 * round.energy)
        .arg(round.most)
        .arg(round.rounds);
}

} // namespace

class ShadingTest : public QObject {
    Q_OBJECT

private slots:
    void prismFeelsRound_data();
    void prismFeelsRound();
    void whatIsLeftIsTheProxysRadius();
    void theWayRoundMakesNoDifference();
    void gapsAreNotFelt();
    void ballFeelsRound_data();
    void ballFeelsRound();
    void loopsGiveNoEnergy_data();
    void loopsGiveNoEnergy();
    void creviceHoldsUpToTheFeltNormals();
    void grooveLeansAlong();
    void frictionAlongALeaningGroove_data();
    void frictionAlongALeaningGroove();
    void hollowComesToRest();
    void frictionConeStandsOnTheFeltNormal();
    void aFingerOutsideIsFree();
    void anythingGoes();
    void whatSticksStandsStill();
};

// Figure 6: the finger on a circle inside a ten-sided prism.
void ShadingTest::prismFeelsRound_data() {
    QTest::addColumn<double>("radius");
    for (double radius : {1e-4, 5e-4, 1e-3, 2e-3})
        QTest::addRow("proxy of %g mm", 1e3 * radius) << radius;
}

void ShadingTest::prismFeelsRound() {
    QFETCH(double, radius);
    const Soup prism = roundPipe(kR, 0.1, 10);
    const Round flat = roundThePrism(prism, radius, false), round = roundThePrism(prism, radius, true);
    qInfo() << "flat:" << text(flat);
    qInfo() << "shaded:" << text(round);
    QVERIFY2(flat.largestJump > 30, qPrintable(text(flat)));
    QVERIFY2(round.worstDirection <= 1, qPrintable(text(round)));
    QVERIFY2(round.largestJump <= 1, qPrintable(text(round)));
    QVERIFY2(std::abs(round.energy) < 1e-9, qPrintable(text(round)));
    QVERIFY2(round.rounds <= 8, qPrintable(text(round)));
}

// The normal between two corners points from the axis to the foot, and the proxy is r above that: the force
// passes the axis at r sin(a), a being the angle of the normal to the facet's, at most half of a tenth turn.
void ShadingTest::whatIsLeftIsTheProxysRadius() {
    const Soup prism = roundPipe(kR, 0.1, 10);
    for (double radius : {2e-3, 5e-3, 8e-3}) {
        const Round round = roundThePrism(prism, radius, true);
        const double expected = std::asin(radius * std::sin(kPi / 10) / (kR - kInside)) * 180 / kPi;
        QVERIFY2(std::abs(round.worstDirection - expected) <= 0.01, qPrintable(text(round)));
    }
}

void ShadingTest::theWayRoundMakesNoDifference() {
    const Soup prism = roundPipe(kR, 0.1, 10);
    for (const Soup& soup : {flipped(*prism), mirrored(*prism), flipped(*mirrored(*prism))}) {
        const Round round = roundThePrism(soup, 1e-3, true);
        QVERIFY2(round.worstDirection <= 1 && round.largestJump <= 1, qPrintable(text(round)));
    }
}

// Facets that do not meet: every edge is a seam, and the hypothetical surface bridges it.
void ShadingTest::gapsAreNotFelt() {
    const Soup prism = roundPipe(kR, 0.1, 10);
    for (double gap : {1e-7, 1e-6, 1e-5}) {
        const Round round = roundThePrism(exploded(*prism, gap), 1e-3, true);
        QVERIFY2(round.worstDirection <= 1 && round.largestJump <= 1, qPrintable(text(round)));
        QVERIFY2(round.rounds <= 16, qPrintable(text(round)));
    }
}

void ShadingTest::ballFeelsRound_data() {
    prismFeelsRound_data();
}

// 320 triangles, along great and small circles that no edge follows.
void ShadingTest::ballFeelsRound() {
    QFETCH(double, radius);
    const auto world = shadedWorld(roundBall(kR, 2), frictionless(), radius);
    for (double height : {0.0, 0.3, 0.8}) {
        Hand hand(world);
        const Quat turn(Eigen::AngleAxisd(0.4, Vec3(1, 0.3, 0.2).normalized()));
        const auto out = [&](double s) {
            return Vec3(turn * Vec3(std::sqrt(1 - height * height) * std::cos(2 * kPi * s), height,
                                    std::sqrt(1 - height * height) * std::sin(2 * kPi * s)));
        };
        const Round round = goAround(
            hand, 1.2 * kR * out(0), int(2 * kPi * kR / kStep),
            [&](double s) { return Vec3((kR - kInside) * out(s)); }, out);
        qInfo() << text(round);
        QVERIFY2(round.worstDirection <= 2 && round.largestJump <= 1, qPrintable(text(round)));
        QVERIFY2(round.rounds <= 12, qPrintable(text(round)));
    }
}

void ShadingTest::loopsGiveNoEnergy_data() {
    QTest::addColumn<Soup>("soup");
    QTest::newRow("ball") << roundBall(kR, 2);
    QTest::newRow("prism") << roundPipe(kR, 0.1, 10);
    QTest::newRow("hollow prism") << roundPipe(kR, 0.1, 10);
    QTest::newRow("egg-crate") << smoothed(eggCrate(0.05, 40, 0.001, 0.02));
}

// 100 mm around at 2 N, both ways: what the felt surface gives to the hand is at most 1 mJ.
void ShadingTest::loopsGiveNoEnergy() {
    QFETCH(Soup, soup);
    const QString name = QTest::currentDataTag();
    const double depth = 2 / kStiffness.initial, loop = 0.1 / (2 * kPi), r = 1e-3;
    const bool crate = name == "egg-crate", hollow = name == "hollow prism";
    const double top = crate ? r : hollow ? -kR * std::cos(kPi / 10) + r : kR + r;
    double most = 0;
    for (double sense : {1.0, -1.0}) {
        Hand hand(shadedWorld(soup, frictionless(), r));
        const auto place = [&](double s) {
            const double x = loop * std::cos(2 * kPi * s), y = loop * std::sin(2 * kPi * s * sense);
            const double bent = crate ? top : std::copysign(std::sqrt(top * top - x * x), top);
            return Vec3(x, y, bent - depth);
        };
        const Round round = goAround(hand, place(0) + Vec3(0, 0, 2 * depth), 1000, place,
                                     [](double) { return Vec3(0, 0, 1); });
        most = std::max(most, std::abs(round.energy));
        QVERIFY2(round.most > 1, qPrintable(text(round)));
        QVERIFY2(std::abs(round.energy) <= 1e-3, qPrintable(text(round)));
    }
    qInfo() << "at most" << 1e3 * most << "mJ a round";
}

// Between two prisms side by side the proxy stays at the place that its facets give while the force lies
// between the normals that are felt there, which are degrees away from those of the facets.
void ShadingTest::creviceHoldsUpToTheFeltNormals() {
    const double half = 0.0535, r = 5e-3, apothem = kR * std::cos(kPi / 10), facet = kPi / 10;
    const Soup prism = roundPipe(kR, 0.1, 10);
    const Soup two = together(*transformed(*prism, {Quat::Identity(), {-half, 0, 0}}),
                              *transformed(*prism, {Quat::Identity(), {half, 0, 0}}));
    const auto world = shadedWorld(two, frictionless(), r);
    const Vec3 seat(0, 0.001, (apothem + r - half * std::cos(facet)) / std::sin(facet));
    const double felt = std::atan2(seat.z() - r * std::sin(facet), half - r * std::cos(facet));
    QCOMPARE_GT(std::abs(felt - facet), 0.05);
    for (double angle : {felt + 0.01, 0.5 * kPi, kPi - felt - 0.01, felt - 0.01, kPi - felt + 0.01}) {
        const bool holds = angle > felt && angle < kPi - felt;
        const Vec3 push = -0.003 * Vec3(std::cos(angle), 0, std::sin(angle));
        Hand hand(world);
        hand.to(seat + Vec3(0, 0, 0.01));
        hand.go(seat - Vec3(0, 0, 0.003), 0.05);
        QVERIFY2((hand.output().proxy - seat).norm() < 1 * kMicrometre,
                 qPrintable(QString("%1 %2 %3 instead of %4")
                                .arg(hand.output().proxy.x())
                                .arg(hand.output().proxy.y())
                                .arg(hand.output().proxy.z())
                                .arg(seat.z())));
        hand.go(seat + push, 0.02);
        for (int i = 0; i < 20; ++i)
            hand.to(seat + push);
        const double left = (hand.output().proxy - seat).norm();
        QVERIFY2(holds ? left < 1 * kMicrometre : left > 5 * kMicrometre,
                 qPrintable(QString("force at %1 degrees: %2 um").arg(angle * 180 / kPi).arg(1e6 * left)));
    }
}

// Both faces of a groove lean along it: so does the force, and the proxy stays on both.
void ShadingTest::grooveLeansAlong() {
    const double s = 0.2, r = 1e-3;
    const Soup soup = leaningGroove(s);
    Hand hand(shadedWorld(soup, frictionless(), r));
    hand.to({0, 0.003, 4e-3});
    hand.go({0, 0.003, 0}, 0.05, [&](const Hand& h) {
        if (h.output().contacts != 0) QCOMPARE_LT(clearance(*soup, h.output().proxy), r + kMicrometre);
    });
    for (int i = 0; i < 5; ++i)
        hand.to(hand.finger());
    const Vec3 force = hand.output().force;
    QCOMPARE_LT(std::abs(force.y() / force.z() + s * std::numbers::sqrt2), 1e-5);
    COMPARE_NEAR(hand.output().proxy.z(), r * std::numbers::sqrt2, 1e-8, "m");
    // The multipliers hold the finger: each face takes its part of the depth.
    QCOMPARE(hand.output().contacts, 2);
    for (int i = 0; i < 2; ++i)
        COMPARE_NEAR(hand.output().contact[std::size_t(i)].normalForce, force.z() / std::numbers::sqrt2, 1e-6,
                     "N");
    // Uphill along the groove the sub-goal is above both faces. It goes back onto them.
    ProxyState state = hand.state.proxy;
    const NearestPoint uphill = updateFelt(
        state,
        {hand.world().obstacles, {}, {state.contacts.data(), 2}, r, hand.finger() + Vec3(0, 0.002, 0), 0});
    QCOMPARE_GT(uphill.x.y(), 1e-3);
    double height = 1;
    for (int i = 0; i < 2; ++i)
        height = std::min(height, state.contacts[i].normal.dot(uphill.x) + state.contacts[i].gap);
    QCOMPARE_LT(std::abs(height), 1e-9);
}

void ShadingTest::frictionAlongALeaningGroove_data() {
    QTest::addColumn<double>("slope");
    for (double slope : {0.0, 0.2, 0.5, 0.8})
        QTest::addRow("slope %g", slope) << slope;
}

// In a right-angled groove whose normals lean along it by the slope s the force leans by s sqrt 2, and a hand
// that slides has to overcome that, b v, and mu times what each face bears: f_z / sqrt 2, by (1 + s^2) / (1 -
// s mu) more uphill and by (1 + s^2) / (1 + s mu) downhill, for the cone of friction stands about the leaning
// normal.
void ShadingTest::frictionAlongALeaningGroove() {
    QFETCH(double, slope);
    const double r = 1e-3, v = 0.05;
    const Soup groove = leaningGroove(slope);
    for (const double sign : {1.0, -1.0})
        for (const double mu : {0.0, 0.3})
            for (const double b : {0.0, 5.0}) {
                Hand hand(shadedWorld(groove, rough(mu, mu, b), r));
                hand.to({0, -sign * 0.01, 4e-3});
                hand.go({0, -sign * 0.01, 0}, 0.05);
                hand.go({0, sign * 0.02, 0}, v);
                const Vec3 force = hand.output().force;
                const double drag = -sign * force.y() - sign * slope * std::numbers::sqrt2 * force.z();
                const double onSlope = (1 + slope * slope) / (1 - sign * slope * mu);
                const double expected = mu * onSlope * force.z() / std::numbers::sqrt2 + b * v;
                QVERIFY2(std::abs(drag - expected) < 0.003 * expected + 1e-4,
                         qPrintable(QString("mu %1, b %2: %3 instead of %4")
                                        .arg(sign * mu)
                                        .arg(b)
                                        .arg(drag)
                                        .arg(expected)));
            }
}

// Deeper than the radius of curvature, where going straight for the sub-goal would swing ever wider.
void ShadingTest::hollowComesToRest() {
    const Soup crate = smoothed(eggCrate(0.01, 60, 0.0003, 0.002));
    for (double depth : {0.5e-3, 2e-3, 5e-3}) {
        Hand hand(shadedWorld(crate, frictionless(), 2e-4));
        hand.to({0.0011, 0.0007, 0.003});
        hand.go({0.0013, 0.0016, -depth}, 0.05);
        for (int i = 0; i < 20; ++i)
            hand.to(hand.finger());
        const Vec3 rest = hand.output().proxy;
        for (int i = 0; i < 50; ++i)
            QCOMPARE(hand.to(hand.finger()).proxy, rest);
    }
}

// A plane whose normals all lean by the slope s, as a real slope: the force leans as they do, and friction
// holds by mu around them, so that up the slope it takes (s + mu) / (1 - s mu), and down (mu - s) / (1 + s
// mu).
void ShadingTest::frictionConeStandsOnTheFeltNormal() {
    const double s = 0.3, mu = 0.2, depth = 1e-3;
    const Soup leaning = withNormals(sheet(0.05), [&](const Vec3&) { return Vec3(-s, 0, 1).normalized(); });
    for (double sign : {1.0, -1.0}) {
        Hand hand(shadedWorld(leaning, rough(mu, mu), 1e-3));
        hand.to({0, 0, 2e-3});
        hand.go({0, 0, 1e-3 - depth}, 0.05);
        double largest = -10, worst = 0; // of the normal force, N
        hand.go(hand.finger() + Vec3(sign * 0.004, 0, 0), 1e-3, [&](const Hand& h) {
            largest = std::max(largest, -sign * h.output().force.x() / h.output().force.z());
            worst = std::max(worst, std::abs(h.output().contact[0].normalForce - kStiffness.initial * depth));
        });
        QCOMPARE_LT(worst, 1e-3);
        COMPARE_NEAR(largest, (mu + sign * s) / (1 - sign * s * mu), 0.001, "");
    }
}

// Felt planes lean, but they hold nobody who is above the facet: no step pulls a finger back in.
void ShadingTest::aFingerOutsideIsFree() {
    const Soup leaning = withNormals(sheet(0.05), [](const Vec3&) { return Vec3(-1, 0, 1).normalized(); });
    for (const Material& material : {frictionless(), rough(0.5, 0.3)}) {
        Hand hand(shadedWorld(leaning, material, 1e-3));
        hand.to({0, 0, 2e-3});
        hand.go({0, 0, 0}, 0.05);
        int outside = 0;
        hand.go({0.008, 0, 2e-3}, 0.05, [&](const Hand& h) {
            if (h.finger().z() <= 1e-3) return;
            ++outside;
            QCOMPARE(h.output().force, Vec3(Vec3::Zero()));
        });
        QCOMPARE_GT(outside, 10);
    }
}

// Random normals on random soups: the proxy stays outside, every run gives the same bits, and it comes to
// rest with the finger.
void ShadingTest::anythingGoes() {
    Rng rng(91);
    const double r = 1e-3;
    int moving = 0;
    for (int run = 0; run < 24; ++run) {
        const Soup plain = run % 3 == 0   ? ball(0.008, 2)
                           : run % 3 == 1 ? eggCrate(0.012, 20, 0.0015, 0.006)
                                          : randomSoup(rng, 200, 0.01);
        const auto world = shadedWorld(withRandomNormals(plain, rng), frictionless(), r);
        Hand hand(world), again(world);
        Vec3 finger(0, 0, 0.02), target = finger;
        for (int i = 0; i < 3000; ++i) {
            if (i % 120 == 0) target = inBox(rng, 0.01);
            const Vec3 way = target - finger;
            if (i % 120 < 40) finger += way * std::min(1.0, 1.5e-4 / std::max(way.norm(), 1e-12));
            const Vec3 before = hand.output().proxy;
            const HapticOutput& output = hand.to(finger);
            QVERIFY(output.force.allFinite());
            QVERIFY2(clearance(*plain, output.proxy) >= r - kMicrometre, qPrintable(QString::number(run)));
            QCOMPARE(again.to(finger).proxy, output.proxy);
            moving += i % 120 == 119 && output.proxy != before;
        }
    }
    QCOMPARE(moving, 0);
}

// The same with friction and a finger several radii deep: once it rests, so does the proxy, to the last bit.
void ShadingTest::whatSticksStandsStill() {
    for (int run = 0; run < 240; ++run) {
        Rng rng(7000 + std::uint64_t(run));
        const Soup plain = run % 3 == 0   ? ball(0.008, 2)
                           : run % 3 == 1 ? eggCrate(0.012, 20, 0.0015, 0.006)
                                          : randomSoup(rng, 200, 0.01);
        const double mu = uniform(rng, 0.1, 1.5), part = uniform(rng, 0.3, 1);
        const double viscosity = run % 4 == 3 ? uniform(rng, 0, 5) : 0;
        const Soup soup = withRandomNormals(plain, rng);
        Hand hand(shadedWorld(soup, rough(mu, part * mu, viscosity), 1e-3));
        hand.to({0, 0, 0.02});
        for (int press = 0; press < 5; ++press) {
            hand.go(inBox(rng, 0.008), 0.1);
            for (int i = 0; i < 250; ++i)
                hand.to(hand.finger());
            const Vec3 rest = hand.output().proxy;
            for (int i = 0; i < 20; ++i)
                hand.to(hand.finger());
            const double way = (hand.output().proxy - rest).norm();
            QVERIFY2(way <= 1e-12,
                     qPrintable(QString("soup %1, press %2: %3 m").arg(run).arg(press).arg(way)));
        }
    }
}

TACTUM_TEST(ShadingTest)

} // namespace test_shading

#include "test_shading.moc"
