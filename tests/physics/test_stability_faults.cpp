// T12: whatever happens, in whatever order: the force is finite, never above the limit, gone within 10 ms of
// a fault until a person arms again, who does so soon, and the surface gives no more than the events allow.
// TACTUM_SEEDS=10000 runs them all.
#include <algorithm>
#include <cmath>
#include <limits>

#include <QMap>
#include <QTest>

#include "tests/physics/event.h"
#include "tests/physics/hand_script.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_stability_faults {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSeconds = 10;
constexpr double kGone = 0.01;   ///< s, from a fault to no force
constexpr double kEvent = 5e-3;  ///< J, that an event may give beyond what the person's side holds more
constexpr double kKick = 0.02;   ///< J, that next to no event makes by itself
constexpr double kGentle = 0.05; ///< m/s, of a resting hand while the scene changes
/// How the failures begin.
constexpr std::array kBounds{"not finite", "above the limit", "force after a fault", "gave", "thrown"};

/// Who renders: the product's servo, or a spring to the newest proxy, without anything that guards it.
enum class Renders { Servo, Unguarded };

enum class Happens { Stall, Unplug, Edit, Swap, SlowProxy, ClockJump, Glitch, Frozen, Nonsense, Rearm };

Material material(double stiffness, double friction) {
    Material result = rough(friction, 0.7 * friction);
    result.stiffness = stiffness;
    return result;
}

/// Worlds to edit between (the same shape) and to swap between.
using Worlds = std::vector<std::vector<std::shared_ptr<const World>>>;

Worlds makeWorlds(const std::vector<Soup>& soups) {
    Worlds worlds;
    for (const Soup& soup : soups) {
        std::vector<std::shared_ptr<const World>> same;
        for (const double stiffness : {200.0, 800.0, 3000.0})
            for (const double friction : {0.0, 0.5, 1.2}) {
                Scene scene = sceneOf(soup, material(stiffness, friction));
                const World* before = same.empty() ? nullptr : same.front().get();
                same.push_back(compile(scene, before).value());
            }
        worlds.push_back(same);
    }
    return worlds;
}

Soup shifted(const Soup& soup, double z) {
    return transformed(*soup, {Quat::Identity(), Vec3(0, 0, z)});
}

/// 20 cm wide, closed all around, so that a finger that sank in while there was no force is led out again:
/// its top has corners at the given height and a valley with its bottom in the origin.
Soup block(double height) {
    constexpr double kHalf = 0.1;
    const std::array<Vec3, 5> outline{Vec3::Zero(), Vec3(-kHalf, 0, height), Vec3(-kHalf, 0, -kHalf),
                                      Vec3(kHalf, 0, -kHalf), Vec3(kHalf, 0, height)};
    const Vec3 far(0, kHalf, 0);
    SoupBuilder builder;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        builder.quad(a - far, a + far, b + far, b - far);
        builder.triangle(-far, a - far, b - far);
        builder.triangle(far, b + far, a + far);
    }
    return builder.build();
}

/// One run of ten seconds.
class Schedule {
public:
    Schedule(std::uint64_t seed, bool gentle, Renders renders = Renders::Servo)
        : random_(seed), gentle_(gentle), bench_{kDevices[seed % kDevices.size()],
                                                 kHands[seed / 5 % kHands.size()],
                                                 {.delay = int(seed % 3), .jitter = 0.2, .substeps = 10}},
          proxy_(anyWorld(), 1000), servo_(infoOf(bench_), proxy_), loop_(bench_, control(renders), 3, seed),
          script_(seed, -0.005) {
        loop_.plant.place({0, 0, 0.005});
        loop_.tamper = [this](DeviceSample& sample) { spoil(sample); };
        loop_.warmUp();
    }

    void run();
    QString failure;             ///< none: empty
    long ticks = 0, pushing = 0; ///< of which with force
    int events() const { return events_; }
    int kicks = 0; ///< events with more than kKick
    int faults() const { return int(servo_.state.gate.faults()); }

private:
    const Worlds& worlds() const {
        static const Worlds all = makeWorlds({block(0), shifted(ball(0.05, 3), -0.052), block(0.036)});
        static const Worlds level =
            makeWorlds({sheet(0.1, 4), shifted(sheet(0.1), -0.004), shifted(sheet(0.1), 0.006)});
        return gentle_ ? level : all;
    }
    std::shared_ptr<const World> anyWorld() {
        shape_ = random_() % worlds().size();
        return worlds()[shape_][random_() % 9];
    }
    Control control(Renders renders) {
        if (renders == Renders::Servo) return servo_.control();
        return [this](const DeviceSample& sample, double dt) -> Vec3 {
            servo_(sample, dt);
            const LocalContactModel& model = servo_.model;
            return servo_.output.force = model.stiffness * (model.proxy - sample.position);
        };
    }
    void lead();
    void happen(Happens what);
    void spoil(DeviceSample& sample);
    void arm();
    bool mustBeSilent();
    void judge();
    double held() const;
    double made() const;

    Rng random_;
    bool gentle_;
    Bench bench_;
    std::size_t shape_ = 0;
    Proxy proxy_;
    Servo servo_;
    ClosedLoop loop_;
    HandScript script_;
    double next_ = 2, until_ = 0, spoiledSince_ = -1, disarmedUntil_ = 0;
    double noticed_ = -1;  ///< s, when the person switches off and on because of a fault; none: -1
    bool unarmed_ = false; ///< since the device was lost
    Happens spoiling_ = Happens::Rearm;
    Vec3 stuck_ = Vec3::Zero();
    double highest_ = -1e300, first_ = 0, eased_ = 0, last_ = 0; ///< J
    double least_ = 1e300, rise_ = 0;                            ///< J, of made() since the last event
    int events_ = 1;
};

double Schedule::held() const {
    const Plant& plant = loop_.plant;
    const HandProfile& hand = bench_.hand;
    const Axes x = hand.rigid ? plant.x : plant.handX;
    return (0.5 * hand.armStiffness * (x - plant.goal).square() +
            0.5 * hand.gripStiffness * (plant.x - x).square())
        .sum();
}

/// J: what was given and what the spring holds, less what surroundings on their way back may do.
double Schedule::made() const {
    const ServoState& servo = servo_.state;
    const Previous& last = servo.previous;
    const double stretch = last.touching ? (last.anchor_D - last.finger_D).norm() : 0;
    const RenderedSpring spring{.stiffness = servo.gate.gain() * servo.transition.rendered().stiffness,
                                .stretch = stretch,
                                .limit = servo.limiter.maxForce};
    return loop_.plant.given() + spring.stored() - eased_;
}

void Schedule::lead() {
    const Vec3 goal = gentle_ ? Vec3(0, 0, -std::min(0.02, 0.02 * loop_.time)) : script_.goal(1e-3);
    loop_.plant.setGoal(goal);
}

void Schedule::spoil(DeviceSample& sample) {
    if (loop_.time >= until_) {
        spoiledSince_ = -1;
        return;
    }
    switch (spoiling_) {
    case Happens::Unplug:
        sample.valid = false;
        break;
    case Happens::Nonsense:
        sample.position.y() = kNan;
        break;
    case Happens::Glitch:
        sample.position.x() += 32768 * std::max(bench_.device.resolution, 1e-5);
        break;
    case Happens::Frozen:
        sample.position = stuck_;
        break;
    default:
        break;
    }
}

void Schedule::happen(Happens what) {
    ++events_;
    kicks += rise_ > kKick;
    least_ = 1e300;
    rise_ = 0;
    switch (what) {
    case Happens::Stall:
        loop_.tick(uniform(random_, 0.002, 0.3));
        break;
    case Happens::ClockJump:
        loop_.tick(uniform(random_, 0.5, 2));
        break;
    case Happens::Edit:
        proxy_.world = worlds()[shape_][random_() % 9];
        break;
    case Happens::Swap:
        proxy_.world = anyWorld();
        break;
    case Happens::SlowProxy:
        proxy_.rate = std::pow(10, uniform(random_, 1.5, 3));
        proxy_.latency = uniform(random_, 0, 0.03);
        break;
    case Happens::Rearm:
        servo_.settings.armed = false;
        disarmedUntil_ = loop_.time + 0.05;
        break;
    default:
        spoiling_ = what;
        stuck_ = loop_.reading;
        spoiledSince_ = what == Happens::Frozen ? -1 : loop_.time;
        until_ = loop_.time + uniform(random_, 0.001, 0.2);
    }
}

/// A person who wants to go on: switches off and on soon after a fault, whether or not its cause is over.
void Schedule::arm() {
    if (noticed_ < 0 && isFault(servo_.state.gate.inhibit()))
        noticed_ = loop_.time + uniform(random_, 0.05, 0.4);
    if (noticed_ >= 0 && loop_.time > noticed_) {
        noticed_ = -1;
        servo_.settings.armed = false;
        disarmedUntil_ = loop_.time + 0.05;
    }
    if (servo_.settings.armed || loop_.time <= disarmedUntil_) return;
    servo_.settings.armed = true;
    unarmed_ = false;
}

/// Whatever the gate itself says: no force 10 ms after the readings went wrong or stayed away. When they are
/// right again there is none until somebody armed; where there were only none for a while it comes back
/// softly.
bool Schedule::mustBeSilent() {
    const bool lost = spoiledSince_ >= 0 && loop_.time < until_ && loop_.time - spoiledSince_ > kGone;
    unarmed_ = unarmed_ || (lost && servo_.settings.armed && spoiling_ != Happens::Unplug);
    return lost || unarmed_ || isFault(servo_.state.gate.inhibit());
}

void Schedule::judge() {
    const Vec3& force = servo_.output.force;
    ++ticks;
    pushing += force.isZero(0) ? 0 : 1;
    if (!force.allFinite()) failure = "not finite";
    if (force.norm() > bench_.device.maxForce) failure = "above the limit";
    if (mustBeSilent() && !force.isZero(0)) failure = "force after a fault";
    highest_ = std::max(highest_, held());
    // A surface on its way back pushes the hand before it, whatever the hand does meanwhile.
    if (servo_.state.transition.easing()) eased_ += 2 * force.norm() * kReturnSpeed * bench_.timing.period();
    // A reading that stands still looks like a finger at rest: what the force then does nobody can know here.
    if (loop_.time < until_ + 0.005 && spoiling_ == Happens::Frozen)
        eased_ += std::max(0.0, loop_.plant.given() - last_);
    last_ = loop_.plant.given();
    least_ = std::min(least_, made());
    rise_ = std::max(rise_, made() - least_);
    const double allowed = highest_ - first_ + events_ * kEvent + eased_;
    if (loop_.plant.given() > allowed)
        failure = QString("gave %1 mJ of %2").arg(1e3 * loop_.plant.given()).arg(1e3 * allowed);
    if (gentle_ && servo_.state.gate.faults() > 0) failure = "a fault without one";
    if (gentle_ && loop_.time > 2 && loop_.plant.velocity().norm() > kGentle)
        failure = QString("thrown at %1 m/s").arg(loop_.plant.velocity().norm());
}

void Schedule::run() {
    constexpr std::array kChanges{Happens::Edit, Happens::Swap, Happens::SlowProxy};
    first_ = held();
    while (loop_.time < kSeconds && failure.isEmpty()) {
        arm();
        if (loop_.time > next_) {
            next_ = loop_.time + uniform(random_, 0.05, 2);
            happen(gentle_ ? kChanges[random_() % kChanges.size()] : Happens(random_() % 10));
        }
        lead();
        loop_.tick();
        judge();
    }
    if (!failure.isEmpty()) failure += QString(" at %1 s").arg(loop_.time);
}

} // namespace

class TestStabilityFaults : public QObject {
    Q_OBJECT

private slots:
    void anythingMayHappen_data() {
        QTest::addColumn<bool>("gentle");
        QTest::newRow("faults of every kind, a busy hand") << false;
        QTest::newRow("changes of the scene, a resting hand") << true;
    }

    void anythingMayHappen() {
        QFETCH(bool, gentle);
        int bad = 0, faults = 0, events = 0, kicks = 0;
        long ticks = 0, pushing = 0;
        // One event in a thousand takes a thousand events to be judged.
        const int all = repeats("TACTUM_SEEDS", std::max(120, longOnly(400))),
                  count = gentle ? (all + 1) / 2 : all;
        for (int seed = 0; seed < count; ++seed) {
            Schedule schedule(std::uint64_t(seed), gentle);
            schedule.run();
            faults += schedule.faults();
            events += schedule.events();
            kicks += schedule.kicks;
            ticks += schedule.ticks;
            pushing += schedule.pushing;
            if (!schedule.failure.isEmpty() && ++bad < 20)
                qWarning("seed %d: %s", seed, qPrintable(schedule.failure));
        }
        qInfo("%d of %d, %d faults, %d of %d events made more than %g mJ, force in %.1f %% of the ticks", bad,
              count, faults, kicks, events, 1e3 * kKick, 100.0 * double(pushing) / double(ticks));
        QCOMPARE(bad, 0);
        QCOMPARE_LE(1000 * kicks, events);
        QCOMPARE_GT(2 * pushing, ticks); // there was something to take away
    }

    /// All that guards switched off: each of the bounds breaks.
    void unguardedItDoesNot() {
        QMap<QString, int> broken;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
            for (const bool gentle : {false, true}) {
                Schedule schedule(seed, gentle, Renders::Unguarded);
                schedule.run();
                for (const char* bound : kBounds)
                    broken[bound] += schedule.failure.startsWith(bound);
            }
        for (const char* bound : kBounds) {
            qInfo("%s: %d", bound, broken[bound]);
            QCOMPARE_GT(broken[bound], 0);
        }
    }
};

TACTUM_TEST(TestStabilityFaults)

} // namespace test_stability_faults

#include "test_stability_faults.moc"
