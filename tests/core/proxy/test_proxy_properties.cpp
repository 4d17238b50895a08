// What must hold at every step, whatever the geometry and the path.

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"
#include "tests/support/test_program.h"

namespace test_proxy_properties {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kRadius = 1e-3;
// A proxy that a sweep stopped a skin too near is pushed out again, by a little more between tilted planes.
constexpr double kPushOut = 2 * kSkin * kRadius;

// A hand that wanders: smooth strokes, rests, and now and then a jump.
class Wanderer {
public:
    Wanderer(std::uint64_t seed, double half) : rng_(seed), half_(half), at_(2 * half * Vec3::UnitZ()) {}

    Vec3 next() {
        if (rng_() % 40 == 0) target_ = inBox(rng_, half_);
        if (rng_() % 400 == 0) return at_ = inBox(rng_, half_);
        if (rng_() % 5 == 0) return at_; // holds still for a step
        const Vec3 way = target_ - at_;
        return at_ += way * std::min(1.0, kHandSpeed * kMillisecond / std::max(way.norm(), 1e-12));
    }
    Vec3 start() const { return at_; }

private:
    Rng rng_;
    double half_;
    Vec3 at_, target_ = Vec3::Zero();
};

std::vector<std::pair<QString, Soup>> manySoups() {
    Rng rng(71);
    std::vector<std::pair<QString, Soup>> soups;
    for (int i = 0; i < 8; ++i)
        soups.emplace_back(QString("random %1").arg(i), randomSoup(rng, 40 + 40 * i, 0.01));
    soups.emplace_back("ball", ball(0.008, 3));
    soups.emplace_back("egg-crate", eggCrate(0.012, 30, 0.0015, 0.006));
    soups.emplace_back("fine egg-crate", eggCrate(0.012, 60, 0.0004, 0.0011));
    soups.emplace_back("pit", pit(evenRays(12, 0.6), 0.02));
    soups.emplace_back("crack", crack(0.02, 0.0013, 0.004));
    return soups;
}

// Whether a straight free move brings the proxy nearer to the finger by more than a micrometre.
bool couldComeNearer(const ProxyRig& rig, const Vec3& finger, Rng& rng) {
    const Vec3 gap = finger - rig.position();
    for (int i = 0; i < 60; ++i) {
        const Vec3 toward = (i == 0 ? gap : (gap.normalized() + 1.5 * inBox(rng, 1))).normalized();
        const double length = std::min(gap.norm(), std::pow(10, uniform(rng, -5.5, -3)));
        if ((gap - length * toward).norm() > gap.norm() - 1.1 * kMicrometre) continue;
        bool free = true;
        for (std::size_t k = 0; k < rig.soup().triangles.size() && free; ++k)
            free = sweepSphere(triangleOf(rig.soup(), k), rig.position(), length * toward, kRadius) > 1;
        if (free) return true;
    }
    return false;
}

} // namespace

class ProxyPropertiesTest : public QObject {
    Q_OBJECT

private slots:
    void staysOutside();
    void neverRetreatsFromTheFinger();
    void neverLocksUp();
    void farFromTheOriginItComesToRest();
    void givesTheSameBits();
    void whatItKnowsOfContactsIsWhatItWouldSee();
    void doesNotDependOnScale();
    void frictionKeepsOutsideToo();
};

void ProxyPropertiesTest::staysOutside() {
    for (const auto& [name, soup] : manySoups()) {
        ProxyRig rig(soup, kRadius);
        Wanderer hand(72, 0.012);
        rig.startAt(hand.start());
        for (int i = 0; i < 3000; ++i) {
            rig.step(hand.next());
            const double clear = clearance(*soup, rig.position());
            QVERIFY2(clear >= kRadius - kMicrometre,
                     qPrintable(
                         QString("%1, step %2: %3 um inside").arg(name).arg(i).arg((kRadius - clear) * 1e6)));
        }
    }
}

void ProxyPropertiesTest::neverRetreatsFromTheFinger() {
    for (const auto& [name, soup] : manySoups()) {
        ProxyRig rig(soup, kRadius);
        Wanderer hand(73, 0.012);
        rig.startAt(hand.start());
        for (int i = 0; i < 10000; ++i) {
            const Vec3 finger = hand.next();
            const double before = (rig.position() - finger).norm();
            rig.step(finger);
            const double growth = (rig.position() - finger).norm() - before;
            QVERIFY2(growth <= kPushOut,
                     qPrintable(QString("%1, step %2: %3 nm").arg(name).arg(i).arg(growth * 1e9)));
        }
    }
}

void ProxyPropertiesTest::neverLocksUp() {
    Rng rng(74);
    for (const auto& [name, soup] : manySoups()) {
        ProxyRig rig(soup, kRadius);
        Wanderer hand(75, 0.012);
        rig.startAt(hand.start());
        for (int i = 0; i < 1500; ++i) {
            const Vec3 finger = hand.next();
            rig.step(finger);
            if (i % 5 || !couldComeNearer(rig, finger, rng)) continue;
            const Vec3 before = rig.position();
            rig.step(finger);
            QVERIFY2(rig.position() != before, qPrintable(QString("%1 freezes at step %2").arg(name).arg(i)));
        }
    }
}

// Where a double does not tell a picometre apart rounds must not go on for one.
void ProxyPropertiesTest::farFromTheOriginItComesToRest() {
    for (const double far : {1e4, 1e5}) {
        const Vec3 offset(far, -far, far);
        const Soup soup = transformed(*eggCrate(0.02, 40, 0.002, 0.01), {Quat::Identity(), offset});
        ProxyRig rig(soup, kRadius);
        Vec3 finger = offset + Vec3(0, 0, 0.01);
        rig.startAt(finger);
        Rng rng(76);
        int spent = 0, steps = 0;
        for (int i = 0; i < 20; ++i) {
            const Vec3 from = finger,
                       target = offset + Vec3(uniform(rng, -0.015, 0.015), uniform(rng, -0.015, 0.015),
                                              uniform(rng, -0.004, 0));
            for (int k = 1; k <= 100; ++k, ++steps) {
                finger = from + 0.01 * k * (target - from);
                spent += rig.step(finger).boundHit;
                QCOMPARE_GE(clearance(*soup, rig.position()), kRadius - kMicrometre);
            }
        }
        QVERIFY2(spent <= steps / 1000, qPrintable(QString("%1 of %2").arg(spent).arg(steps)));
    }
}

void ProxyPropertiesTest::givesTheSameBits() {
    for (const auto& [name, soup] : manySoups()) {
        ProxyRig first(soup, kRadius, rough(0.4, 0.3, 0.5)), second(soup, kRadius, rough(0.4, 0.3, 0.5));
        Wanderer hand(76, 0.012), again(76, 0.012);
        first.startAt(hand.start());
        second.startAt(again.start());
        for (int i = 0; i < 2000; ++i) {
            first.step(hand.next());
            second.step(again.next());
            QVERIFY2(first.position() == second.position(), qPrintable(name));
            QCOMPARE(first.state.contactCount, second.state.contactCount);
        }
    }
}

// Wrong would be a test in which the first one never begins where it ended: it would look each time as well.
void ProxyPropertiesTest::whatItKnowsOfContactsIsWhatItWouldSee() {
    int known = 0;
    for (const auto& [name, soup] : manySoups())
        for (const Material& material : {frictionless(), rough(0.4, 0.3, 0)}) {
            ProxyRig knowing(soup, kRadius, material), looking(soup, kRadius, material);
            Wanderer hand(78, 0.012);
            knowing.startAt(hand.start());
            looking.startAt(hand.start());
            for (int i = 0; i < 2000; ++i) {
                const Vec3 finger = hand.next();
                known += knowing.state.contactCount > 0 && knowing.state.seenFrom == knowing.position();
                looking.state.seenFrom = kNowhere;
                knowing.step(finger);
                looking.step(finger);
                QVERIFY2(knowing.position() == looking.position(), qPrintable(name));
                QCOMPARE(knowing.state.contactCount, looking.state.contactCount);
                for (int k = 0; k < knowing.state.contactCount; ++k) {
                    const Contact &a = knowing.state.contacts[std::size_t(k)],
                                  &b = looking.state.contacts[std::size_t(k)];
                    QVERIFY2(a.normal == b.normal && a.gap == b.gap && a.lambda == b.lambda,
                             qPrintable(name));
                }
            }
        }
    QVERIFY2(known > 10000, qPrintable(QString::number(known)));
}

// A thousand times smaller or larger, the radius too: the path scales, there is no hidden length.
void ProxyPropertiesTest::doesNotDependOnScale() {
    const std::vector<std::pair<QString, Soup>> soups{{"ball", ball(0.008, 2)},
                                                      {"egg-crate", eggCrate(0.012, 30, 0.0015, 0.006)},
                                                      {"pit", pit(evenRays(6, 0.6), 0.02)}};
    for (const auto& [name, soup] : soups)
        for (double scale : {1e-3, 1e3}) {
            ProxyRig rig(soup, kRadius), scaled(transformed(*soup, {}, scale), scale * kRadius);
            Vec3 finger(0, 0, 0.012);
            rig.startAt(finger);
            scaled.startAt(scale * finger);
            Rng rng(77);
            for (int stroke = 0; stroke < 20; ++stroke) {
                const Vec3 target = 0.0095 * (finger.normalized() + 0.2 * direction(rng)).normalized() *
                                    (name == "pit" ? -0.5 : 1.0);
                for (int i = 1; i <= 60; ++i) {
                    const Vec3 at = finger + (target - finger) * (i / 60.0);
                    rig.step(at);
                    scaled.step(scale * at);
                    const double error = (scaled.position() / scale - rig.position()).norm();
                    QVERIFY2(error < 1e-9 * 0.012,
                             qPrintable(QString("%1 times %2: %3").arg(name).arg(scale).arg(error)));
                }
                finger = target;
            }
        }
}

void ProxyPropertiesTest::frictionKeepsOutsideToo() {
    for (const auto& [name, soup] : manySoups()) {
        ProxyRig rig(soup, kRadius, rough(0.6, 0.4, 1));
        Wanderer hand(78, 0.012);
        rig.startAt(hand.start());
        for (int i = 0; i < 2000; ++i) {
            const Vec3 finger = hand.next();
            const double before = (rig.position() - finger).norm();
            rig.step(finger);
            QVERIFY2(clearance(*soup, rig.position()) >= kRadius - kMicrometre, qPrintable(name));
            QVERIFY2((rig.position() - finger).norm() <= before + kPushOut, qPrintable(name));
        }
    }
}

TACTUM_TEST(ProxyPropertiesTest)

} // namespace test_proxy_properties

#include "test_proxy_properties.moc"
