// Rate control in the closed loop: every device that the program ships, in hands that pull beyond the border,
// let go there, and are led into a wall that nobody knew of. Wrong if the workspace did not move: then
// nothing is reached, which each test asks first.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/as_connected.h"
#include "tests/physics/servo.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_stability_rate {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kScale = 4, kShell = 0.02, kBeyond = 0.012, kWatched = 0.5;
constexpr double kHeight = 0.8;     ///< m, of the device's centre above the sheet: a steady pull comes there
constexpr double kMostGiven = 1e-3; ///< J: where the passivity observer begins to damp
constexpr double kGrows = 1.5;      ///< s, in which a pull comes

/// Peak to peak, in the last half second.
struct Still {
    double low = 1e300, high = -1e300, force = 0, given = 0, jump = 0, peak = 0;
    double motion() const { return high - low; }
};

/// A hand whose arm wants to be somewhere along z, and the workspace that it leads.
struct Pulled {
    Pulled(const Connected& device, const HandProfile& hand, Surroundings& around)
        : bench(benchOf(device, hand)), info(infoWith(device)), servo(info, around),
          loop(bench, servo.control()) {
        servo.lay({.scale = kScale, .offset = {0, 0, kHeight}, .reach = {ReachMode::Rate, kShell}});
        const Vec3 edge(0, 0, -border());
        loop.plant.place(edge);
        loop.plant.setGoal(edge);
        loop.warmUp();
        begin_ = loop.plant.given();
    }
    static DeviceInfo infoWith(const Connected& device) {
        DeviceInfo info = connectedInfo(device);
        info.continuousForce = 0; // warm motors give way to a pull for ever, which is no swing
        return info;
    }
    double border() const { return std::min(kShell, kShellMost * info.workspaceRadius); }
    bool held() const { return bench.hand.mass > 0; }
    /// Where nobody holds it, a muscle pulls at the device itself. `part`: 0 to 1.
    void pull(double part) {
        if (held())
            loop.plant.setGoal({0, 0, -(border() + part * kBeyond)});
        else
            loop.plant.voluntary.z() = -part * (0.2 * info.maxForce + info.dryFriction);
    }
    void letGo() {
        loop.plant.voluntary.setZero();
        loop.plant.setGoal(Vec3::Zero());
    }
    double excess() const { return -loop.plant.x[2] - border(); }
    template <class Each> Still watch(double seconds, Each&& each) {
        Still still;
        const double end = loop.time + seconds;
        double last = loop.command.norm();
        loop.run(seconds, [&](const ClosedLoop& now) {
            each(now.time - (end - seconds));
            still.given = std::max(still.given, now.plant.given() - begin_);
            still.jump = std::max(still.jump, std::abs(now.command.norm() - last));
            still.peak = std::max(still.peak, now.command.norm());
            last = now.command.norm();
            if (now.time < end - kWatched) return;
            still.low = std::min(still.low, now.plant.x[2]);
            still.high = std::max(still.high, now.plant.x[2]);
            still.force = now.command.z();
        });
        return still;
    }
    /// A pull that grows and stays, `seen()` after each tick.
    template <class Seen> Still pullFor(double seconds, Seen&& seen) {
        return watch(seconds, [&](double since) {
            pull(std::min(1.0, since / kGrows));
            seen();
        });
    }

    Bench bench;
    DeviceInfo info;
    Servo servo;
    ClosedLoop loop;

private:
    double begin_ = 0; ///< J, that the loop had given before
};

QByteArray told(const Pulled& pulled, const Still& still) {
    return QString("%1, %2: %3 um, %4 N, %5 mJ, %6 N a tick")
        .arg(pulled.bench.device.name, pulled.bench.hand.name)
        .arg(1e6 * still.motion())
        .arg(still.force)
        .arg(1e3 * still.given)
        .arg(still.jump)
        .toUtf8();
}

constexpr std::array kHeld{kNoHand, kPinch, kGrasp, kFirm};

} // namespace

class TestStabilityRate : public QObject {
    Q_OBJECT

private slots:
    static void eachDevice() {
        QTest::addColumn<int>("device");
        for (int i = 0; i < int(kConnected.size()); ++i)
            QTest::addRow("%s", kConnected[std::size_t(i)].key.data()) << i;
    }

    void whoPullsIsHeldStillAndLetGoComesHome_data() { eachDevice(); }
    void whoPullsIsHeldStillAndLetGoComesHome() {
        QFETCH(int, device);
        const Connected& connected = kConnected[std::size_t(device)];
        for (const HandProfile& hand : kHeld) {
            GivenModel nothing({});
            nothing.model.valid = true;
            Pulled pulled(connected, hand, nothing);
            const double count = pulled.bench.device.resolution, begin = pulled.servo.output.frame.offset.z();
            const Still out = pulled.pullFor(5, [] {});
            QVERIFY2(pulled.servo.output.frame.offset.z() < begin - 0.1, told(pulled, out));
            QVERIFY2(out.force > 0, told(pulled, out));
            QVERIFY2(out.motion() <= 2 * count, told(pulled, out));
            QVERIFY2(out.given <= kMostGiven, told(pulled, out));
            pulled.letGo();
            const Still home = pulled.watch(6, [](double) {});
            const double there = pulled.servo.output.frame.offset.z();
            QVERIFY2(home.motion() <= 2 * count, told(pulled, home));
            QVERIFY2(home.given <= kMostGiven, told(pulled, home));
            pulled.loop.run(0.5);
            // Dry friction may hold it where the spring is weaker; there the workspace goes on as slowly.
            const double most = kScale * rateSpeed(pulled.info.dryFriction / kBorderStiffness) * 0.5;
            QVERIFY2(std::abs(pulled.servo.output.frame.offset.z() - there) <= most + 1e-9,
                     told(pulled, home));
        }
    }

    void aWallThatIsReachedIsPressedAndHoldsStill_data() { eachDevice(); }
    void aWallThatIsReachedIsPressedAndHoldsStill() {
        QFETCH(int, device);
        const Connected& connected = kConnected[std::size_t(device)];
        Material material = frictionless();
        material.stiffness = 500;
        for (const HandProfile& hand : kHeld) {
            Proxy proxy(worldOf(sheet(0.1), material, 1e-3), 1000, 1e-3);
            Pulled pulled(connected, hand, proxy);
            const double count = pulled.bench.device.resolution;
            double before = 0; // m beyond the border, when it is reached
            const Still still = pulled.pullFor(14, [&] {
                if (proxy.output.contacts == 0) before = pulled.excess();
            });
            const QByteArray all = told(pulled, still) + QString(", %1 mm beyond before it and %2 then")
                                                             .arg(1e3 * before)
                                                             .arg(1e3 * pulled.excess())
                                                             .toUtf8();
            qInfo("%s", all.constData());
            QVERIFY2(proxy.output.contacts > 0, all);
            QVERIFY2(still.motion() <= 2 * count, all);
            QVERIFY2(still.given <= kMostGiven, all);
            QVERIFY2(still.peak <= pulled.info.maxForce, all);
            // The workspace leads to the wall and not into it, or it would go on until the wall had pushed
            // the hand back to the border. What it went while nobody knew of the wall is all that the hand
            // gives way by.
            const double unknown = kRateMost * 3e-3, stuck = pulled.info.dryFriction / kBorderStiffness;
            QVERIFY2(pulled.excess() >= before - unknown - stuck - 2 * count, all);
        }
    }
};

TACTUM_TEST(TestStabilityRate)

} // namespace test_stability_rate

#include "test_stability_rate.moc"
