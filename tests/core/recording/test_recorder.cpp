// The flight recorder: what the engine did is stepped through again bit for bit, from the beginning, from the
// middle and after its rings went round, with edits, swaps, moving bodies and faults in it.
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include <QTest>

#include "core/haptics/compile.h"
#include "core/recording/events.h"
#include "core/recording/player.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/runtime/probe_device.h"
#include "tests/realtime/bumpy_scene.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_recorder {

using namespace tactum;

namespace {

constexpr double kForEver = std::numeric_limits<double>::infinity();

/// A hand that strokes a rough plate while its material is edited, other plates come, a body passes through
/// it, the forces go on and off, a button is asked for and the proxy is put elsewhere.
struct Felt {
    RecordedRun run;
    ServoTelemetry servo; ///< when it ended
};

Felt feltRun(std::uint64_t ticks) {
    const auto target = std::make_shared<HandTarget>();
    LocalEngine engine(std::make_unique<SimulatedHand>(target));
    const auto first = bumpyPlate(1), second = bumpyPlate(2);
    std::shared_ptr<const World> world = compile(bumpyScene(first, 0)).value();
    engine.publish(world);
    if (!engine.start()) return {};
    engine.setArmed(true);
    int frame = 0;
    (void)eventually([&] {
        engine.poll();
        target->write({.position = wanderingFinger(4e-3 * double(++frame))});
        if (frame % 20 == 0) {
            world = compile(bumpyScene(frame % 200 < 100 ? first : second, frame), world.get()).value();
            engine.publish(world);
        }
        if (frame % 170 == 0) engine.restartProxy();
        if (frame % 300 == 0) engine.setArmed(frame % 600 == 0);
        engine.setDeadMan(frame % 250 > 240); // nobody holds the button
        return engine.servo().ticks >= ticks;
    });
    engine.stop();
    return {engine.recorded(), engine.servo()};
}

std::shared_ptr<const RecordedRun> shared(RecordedRun run) {
    return std::make_shared<const RecordedRun>(std::move(run));
}

ReplayCheck replayed(RecordedRun run) {
    auto player = Player::open(shared(std::move(run)));
    if (!player) return {.differ = 1, .first = player.error().text};
    player->advanceTo(kForEver);
    return player->check();
}

} // namespace

class TestRecorder : public QObject {
    Q_OBJECT

    RecordedRun run_;
    ServoTelemetry servo_; ///< live, at its end

private slots:
    void initTestCase() {
        const Felt felt = feltRun(6000);
        run_ = felt.run;
        servo_ = felt.servo;
        QCOMPARE_GE(run_.servo.rows.size(), 6000);
        QCOMPARE_GT(run_.proxy.rows.size(), 6000);
        QCOMPARE_GT(run_.scenes.size(), 10);
        QCOMPARE_GE(run_.proxyStates.size(), 4);
        QCOMPARE_GE(run_.servoStates.size(), 4);
    }

    void theWholeRunGivesTheSameBits() {
        const ReplayCheck check = replayed(run_);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(check.proxySteps, run_.proxy.rows.size());
        QCOMPARE(check.servoSteps, run_.servo.rows.size());
        int touching = 0, pushed = 0;
        for (const ProxyRow& row : run_.proxy.rows)
            touching += row.contacts > 0;
        for (const ServoRow& row : run_.servo.rows)
            pushed += vectorOf(row.force).norm() > 0;
        QCOMPARE_GT(touching, 1000);
        QCOMPARE_GT(pushed, 500);
    }

    // A plate that is pushed and falls, stopped, slowed, stepped and put back: live, whole and from the
    // middle.
    void bodiesThatForcesMoveGiveTheSameBits() {
        const auto target = std::make_shared<HandTarget>();
        LocalEngine engine(std::make_unique<SimulatedHand>(target));
        Scene scene = bumpyScene(bumpyPlate(1), 0);
        RigidBody body;
        body.id = 1;
        body.mass = 0.5;
        body.inertia = Vec3::Constant(1e-3);
        scene.objects[0].body = 1;
        scene.mechanics.bodies = {body};
        scene.mechanics.gravity = {0, 0, -0.05};
        engine.publish(compile(scene).value());
        QVERIFY(engine.start());
        engine.setArmed(true);
        int frame = 0;
        BodiesState slowed;
        (void)eventually([&] {
            engine.poll();
            target->write({.position = wanderingFinger(4e-3 * double(++frame))});
            if (frame % 97 == 0) engine.beginBodies();
            if (frame % 50 == 0) engine.setPace(frame % 150 == 0 ? 0 : frame % 100 == 0 ? 0.1 : 1);
            if (frame % 7 == 0) engine.stepBodies();
            return engine.servo().ticks >= 4000;
        });
        engine.stop();
        engine.poll();
        const BodiesState last = engine.proxy().bodies;
        const auto run = shared(engine.recorded());
        int paused = 0, slow = 0, begun = 0, touching = 0;
        for (const ProxyRow& row : run->proxy.rows) {
            paused += row.pace == 0, slow += row.pace == 0.1, touching += row.contacts > 0;
            begun += (row.flags & ProxyRow::Begin) != 0;
        }
        QVERIFY2(paused > 0 && slow > 0 && begun > 0 && touching > 0,
                 "the run does not hold what it is about");
        auto player = Player::open(run);
        QVERIFY2(player.has_value(), player ? "" : player.error().text.c_str());
        player->advanceTo(kForEver);
        QVERIFY2(player->check().differ == 0, player->check().first.c_str());
        QVERIFY(player->proxy().bodies.qs > 0);
        QCOMPARE(player->proxy().bodies.q, last.q);
        player->seek(0.5 * (run->begin() + run->end()));
        player->advanceTo(kForEver);
        QVERIFY2(player->check().differ == 0, player->check().first.c_str());
        QCOMPARE_GT(player->check().proxySteps, 1000);
        QCOMPARE(player->proxy().bodies.q, last.q);
    }

    void theGuardIsSeenAsItWasSeenLive() {
        auto player = Player::open(shared(run_));
        QVERIFY(player.has_value());
        player->advanceTo(kForEver);
        const ServoTelemetry &live = servo_, &again = player->servo();
        QCOMPARE_GE(live.ticks, 6000);
        QCOMPARE_GT(live.pauses, 0);
        QCOMPARE(again.ticks, live.ticks);
        QCOMPARE(again.finger, live.finger);
        QCOMPARE(again.force, live.force);
        QCOMPARE(again.inhibit, live.inhibit);
        QCOMPARE(again.gain, live.gain);
        QCOMPARE(again.faults, live.faults);
        QCOMPARE(again.pauses, live.pauses);
        QCOMPARE(again.lastPause, live.lastPause);
        QCOMPARE(again.clamped, live.clamped);
        QCOMPARE(again.invalidSamples, live.invalidSamples);
        QCOMPARE(again.oscillations, live.oscillations);
        QCOMPARE(again.stiffnessScale, live.stiffnessScale);
        QCOMPARE(again.heat, live.heat);
        QCOMPARE(again.energy, live.energy);
        QCOMPARE(again.passivityDamping, live.passivityDamping);
        QCOMPARE(again.ceiling.value, live.ceiling.value);
    }

    void fromTheMiddleToo() {
        auto player = Player::open(shared(run_));
        QVERIFY(player.has_value());
        const double length = run_.end() - run_.begin();
        for (const double part : {0.9, 0.1, 0.5, 0.7, 0.3}) {
            player->seek(run_.begin() + part * length);
            QCOMPARE_LT(player->check().servoSteps, 3000); // from a kept state, not from the beginning
            player->advanceTo(player->time() + 0.2 * length);
            QVERIFY2(player->check().differ == 0, player->check().first.c_str());
            QCOMPARE_GT(player->check().proxySteps, 0);
        }
    }

    void whatIsCutOffAtTheFrontDoesNotMatter() {
        RecordedRun cut = run_;
        trim(cut, 2);
        QCOMPARE_GT(cut.proxy.first, 0);
        QCOMPARE_GT(cut.servo.first, 0);
        QCOMPARE_LT(cut.scenes.size(), run_.scenes.size());
        QCOMPARE_LT(cut.end() - cut.begin(), 5);
        const ReplayCheck check = replayed(cut);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(check.servoSteps, cut.servo.rows.size());
    }

    void whatHasNoRowsCanBeCut() {
        RecordedRun none;
        trim(none);
        QVERIFY(none.proxy.rows.empty());
        QVERIFY(none.servo.rows.empty());
        RecordedRun half = run_;
        half.servo = {};
        trim(half);
        QVERIFY(!half.proxy.rows.empty());
        QVERIFY(half.servo.rows.empty());
        half = run_;
        half.proxy = {};
        trim(half);
        QVERIFY(half.proxyStates.empty());
    }

    /// A copy may be made while a step is under way whose state was kept already.
    void aStateWithoutItsRowIsLeftOut() {
        RecordedRun early = run_;
        early.proxyStates.push_back(early.proxyStates.back());
        early.proxyStates.back().row = early.proxy.end();
        early.servoStates.push_back(early.servoStates.back());
        early.servoStates.back().row = early.servo.end();
        trim(early);
        QVERIFY(early.proxyStates.back().row < early.proxy.end());
        QVERIFY(early.servoStates.back().row < early.servo.end());
        QCOMPARE(replayed(early).differ, 0u);
    }

    /// A device that is there and silent: no haptic step any more, and the last ones are minutes old by the
    /// time somebody asks.
    void ticksWithoutStepsAreKept() {
        RecordedRun silent = run_;
        const double last = silent.proxy.rows.back().time;
        const ServoRow tick = silent.servo.rows.back();
        for (int i = 1; i < 6500; ++i) {
            if (i % 100 == 0) {
                silent.servoStates.push_back(silent.servoStates.back());
                silent.servoStates.back().row = silent.servo.end();
            }
            silent.servo.rows.push_back(tick);
            silent.servo.rows.back().time = last + 0.01 * i;
        }
        trim(silent);
        QVERIFY(!silent.proxy.rows.empty());
        QCOMPARE_GT(silent.servo.rows.size(), 5900);
        QVERIFY(Player::open(shared(silent)).has_value());
    }

    void oneBitIsFound() {
        RecordedRun forged = run_;
        auto& force = forged.proxy.rows[3000].force[1];
        force = std::nextafter(force, 1.0);
        ReplayCheck check = replayed(forged);
        QCOMPARE(check.differ, 1u);
        COMPARE_BEGINS(check.first, "haptic step 3000 at ");

        forged = run_;
        auto& push = forged.servo.rows[2000].force[2];
        push = std::nextafter(push, 1.0);
        check = replayed(forged);
        QCOMPARE(check.differ, 1u);
        COMPARE_BEGINS(check.first, "servo tick 2000 at ");
    }

    void whatWasDoneIsListed() {
        int edits = 0, armed = 0, restarts = 0;
        for (const RecordedEvent& event : eventsOf(run_)) {
            edits += event.text == "the scene was edited";
            armed += event.text == "forces on" || event.text == "forces off";
            restarts += event.text == "the proxy was put on the finger";
        }
        QCOMPARE_GT(edits, 10);
        QCOMPARE_GE(armed, 2);
        QCOMPARE_GE(restarts, 2);
    }

    void faultsAreReplayed() {
        const auto probe = std::make_shared<Probe>();
        LocalEngine engine(std::make_unique<ProbeDevice>(probe));
        engine.publish(compile(bumpyScene(bumpyPlate(1), 3)).value());
        QVERIFY(engine.start().has_value());
        engine.setArmed(true);
        const auto ticks = [&] {
            engine.poll();
            return engine.servo().ticks;
        };
        QVERIFY(eventually([&] { return ticks() > 500; }));
        probe->height = 0;
        QVERIFY(eventually([&] { return ticks() > 1500; }));
        probe->nonsense = true;
        QVERIFY(eventually([&] { return ticks() > 0 && engine.servo().faults > 0; }));
        const std::uint64_t after = ticks() + 1200;
        QVERIFY(eventually([&] { return ticks() > after; }));
        const RecordedRun run = engine.recorded(); // while the loops go on
        const ReplayCheck check = replayed(run);
        QVERIFY2(check.differ == 0, check.first.c_str());
        const auto events = eventsOf(run);
        QVERIFY(std::ranges::any_of(events, &RecordedEvent::fault));
    }

    /// The motors were hot before the first row, and the limit is lower from the first force on.
    void aRunThatBeganHotGivesTheSameBits() {
        const auto probe = std::make_shared<Probe>();
        probe->continuousForce = 0.05;
        LocalEngine engine(std::make_unique<ProbeDevice>(probe));
        engine.publish(compile(bumpyScene(bumpyPlate(1), 3)).value());
        QVERIFY(engine.start().has_value());
        const auto polled = [&] {
            engine.poll();
            return engine.servo();
        };
        engine.setArmed(true);
        QVERIFY(eventually([&] { return polled().ticks > 300 && engine.proxy().updates > 10; }));
        probe->height = 0;
        QVERIFY(eventually([&] { return polled().heat > 0.9; }));
        engine.stop();
        probe->height = 0.01;
        QVERIFY(engine.start().has_value());
        engine.setArmed(true);
        QVERIFY(eventually([&] { return polled().ticks > 300 && engine.proxy().updates > 10; }));
        probe->height = 0;
        QVERIFY(eventually([&] { return polled().force.norm() > 0; }));
        const std::uint64_t after = polled().ticks + 300;
        QVERIFY(eventually([&] { return polled().ticks > after; }));
        engine.stop();
        const RecordedRun run = engine.recorded();
        QCOMPARE(run.servo.first, 0u);
        auto player = Player::open(shared(run));
        QVERIFY(player.has_value());
        player->advanceTo(kForEver);
        QVERIFY2(player->check().differ == 0, player->check().first.c_str());
        QCOMPARE(player->servo().heat, polled().heat);
    }

    void aWriterThatOvertakesTheReaderLosesNoSense() {
        struct Pair {
            std::uint64_t number = 0, twice = 0;
        };
        constexpr std::size_t kRows = 20'000;
        RecordRing<Pair> ring(kRows);
        std::atomic<bool> done{false};
        std::thread writer([&] {
            for (std::uint64_t i = 0; !done; ++i) {
                ring.push({i, 2 * i});
                if (i % 300 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
            }
        });
        std::uint64_t seen = 0, torn = 0, dropped = 0;
        for (std::uint64_t end = 0; end < 10 * kRows;) {
            const auto copied = ring.copy();
            for (std::size_t k = 0; k < copied.rows.size(); ++k)
                torn += copied.rows[k].number != copied.first + k ||
                        copied.rows[k].twice != 2 * (copied.first + k);
            end = copied.end();
            seen += copied.rows.size();
            dropped += end > kRows && copied.rows.size() < kRows;
        }
        done = true;
        writer.join();
        QCOMPARE(torn, 0u);
        QCOMPARE_GT(seen, 0);
        QCOMPARE_GT(dropped, 0); // it was overtaken, and noticed
        const auto last = ring.copy();
        QVERIFY(last.rows.size() == std::min<std::size_t>(kRows, last.end()));
    }
};

TACTUM_TEST(TestRecorder)

} // namespace test_recorder

#include "test_recorder.moc"
