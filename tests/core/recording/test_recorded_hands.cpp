// Two hands in one World, recorded: what one lifts and the other lets go is stepped through again to the bit
// for each, and a file holds both.
#include <cmath>

#include <QTest>

#include "core/recording/events.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/core/runtime/patience.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_recorded_hands {

using namespace tactum;

namespace {

constexpr double kForEver = 1e9, kStep = 5e-4;
constexpr int kEvery[] = {2, 3};            // steps from tick to tick: each servo has its own rate
constexpr int kAbsent = 3000, kBack = 3400; // steps between which the second device is silent
constexpr int kBegin = 6000, kSteps = 8000;

DeviceInfo deviceOf(std::size_t hand) {
    return {.name = hand == 0 ? "Left" : "Right",
            .maxForce = 8,
            .rate = 1 / (kStep * kEvery[hand]),
            .damping = 1e5,
            .tripSpeed = 20};
}

/// One hand's side of both loops.
struct Side {
    explicit Side(std::size_t which) : servo(deviceOf(which)), side(which == 0 ? -1 : 1) {}

    /// Into its side of the box and out again, and a little up and down.
    Vec3 at(double time) const {
        const double depth = 1e-3 * (1 + 2 * std::sin(3 * time + side));
        return {side * (test::kBoxHalf + test::kFingertip - depth), 2e-3 * std::sin(7 * time), 0};
    }
    void tick(double time, double dt, bool valid, const LocalContactModel& model) {
        ServoRow row{.time = time,
                     .dt = dt,
                     .apart = dt,
                     .position = tripleOf(at(time)),
                     .model = recorder.proxyCount(),
                     .flags = std::uint32_t(ServoRow::Armed) | std::uint32_t(ServoRow::Fresh) |
                              (valid ? ServoRow::Valid : 0u)};
        recorder.begin(row, servo);
        const ServoOutput output = stepFrom(row, servo, model);
        note(row, output, servo);
        recorder.end(row);
        finger = output.finger;
    }
    ProxyRow row(double time, const World& world, const LocalContactModel& model, bool begin) const {
        return {.time = time,
                .dt = kStep,
                .coupling = {finger.coupling.stiffness, finger.coupling.force, finger.coupling.delay},
                .finger = tripleOf(finger.position),
                .velocity = tripleOf(finger.velocity),
                .world = world.revision,
                .anchoring = finger.anchoring,
                .flags = (finger.valid ? 0u : std::uint32_t(ProxyRow::Absent)) |
                         (finger.anchoring != model.anchoring ? std::uint32_t(ProxyRow::Found) : 0u) |
                         (begin ? std::uint32_t(ProxyRow::Begin) : 0u)};
    }

    Recorder recorder{1000, 2000, 0};
    ServoState servo;
    FingerSample finger;
    double side;
};

RecordedRun runOfTwo() {
    const auto world = compile(test::boxOnFloor(0.05, {.stiffness = 500, .staticFriction = 0.8})).value();
    std::array<Side, 2> sides{Side(0), Side(1)};
    auto first = std::make_unique<SimState>();
    std::vector<HandState> others(1);
    HandState* const states[] = {first.get(), others.data()};
    for (int i = 0; i < kSteps; ++i) {
        const double time = kStep * i;
        std::array<ProxyRow, 2> rows;
        std::array<HapticOutput, 2> outputs;
        for (std::size_t k = 0; k < 2; ++k) {
            Side& side = sides[k];
            const bool silent = k == 1 && i >= kAbsent && i < kBack;
            if (i % kEvery[k] == 0) side.tick(time, kStep * kEvery[k], !silent, states[k]->model);
            rows[k] = side.row(time, *world, states[k]->model, i == kBegin);
        }
        sides[0].recorder.begin(rows[0], *first);
        sides[1].recorder.begin(rows[1], others[0]);
        stepFrom(rows, *world, *first, others, outputs);
        for (std::size_t k = 0; k < 2; ++k) {
            note(rows[k], outputs[k]);
            sides[k].recorder.end(rows[k]);
        }
    }
    RecordedRun run = sides[0].recorder.copy();
    run.others.push_back(sides[1].recorder.copy());
    run.device = deviceOf(0), run.others[0].device = deviceOf(1);
    run.scenes = {{numbersOf(*world), world->scene}};
    trim(run);
    return run;
}

ReplayCheck replayed(const RecordedRun& run) {
    auto player = Player::open(std::make_shared<const RecordedRun>(run));
    if (!player) return {.differ = 1, .first = player.error().text};
    player->advanceTo(kForEver);
    return player->check();
}

std::string refusal(const RecordedRun& run) {
    const auto read = parseRecording(recordingBytes({run, "a test", {}}), "hands.tactum-recording");
    return read ? std::string() : read.error().text;
}

} // namespace

class TestRecordedHands : public QObject {
    Q_OBJECT

    RecordedRun run_;

private slots:
    void initTestCase() {
        run_ = runOfTwo();
        QCOMPARE(run_.hands(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            const HandRecord& hand = run_.hand(i);
            int pressing = 0, pushed = 0;
            for (const ProxyRow& row : hand.proxy.rows)
                pressing += row.contacts > 0;
            for (const ServoRow& row : hand.servo.rows)
                pushed += vectorOf(row.force).norm() > 0;
            QCOMPARE(hand.proxy.rows.size(), std::size_t(kSteps));
            QCOMPARE_GT(pressing, kSteps / 4);
            QCOMPARE_GT(pushed, kSteps / 16);
        }
        QCOMPARE_GT(run_.servo.rows.size(), run_.others[0].servo.rows.size());
    }

    void bothGiveTheSameBits() {
        const ReplayCheck check = replayed(run_);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(check.proxySteps, 2 * run_.proxy.rows.size());
        QCOMPARE(check.servoSteps, run_.servo.rows.size() + run_.others[0].servo.rows.size());
    }

    /// As the loops themselves make it, with a copy while they go on.
    void whatAnEngineOfTwoDidGivesTheSameBits() {
        const std::array targets{std::make_shared<HandTarget>(), std::make_shared<HandTarget>()};
        LocalEngine engine(std::make_unique<SimulatedHand>(targets[0]));
        engine.publish(compile(test::boxOnFloor(0.05, {.stiffness = 300, .staticFriction = 0.8})).value());
        VERIFY_RESULT(engine.start());
        VERIFY_RESULT(engine.addDevice(std::make_unique<SimulatedHand>(targets[1])));
        engine.setAllArmed(true);
        int frame = 0;
        QVERIFY(eventually([&] {
            engine.poll();
            const double depth = 4e-3 * std::sin(0.01 * ++frame);
            for (const std::size_t i : {std::size_t(0), std::size_t(1)})
                targets[i]->write(
                    {.position = {(i == 0 ? -1 : 1) * (test::kBoxHalf + test::kFingertip - depth), 0, 0}});
            if (frame % 400 == 0) engine.hand(1).setArmed(frame % 800 == 0);
            if (frame % 500 == 0) engine.beginBodies();
            return engine.hand(1).servo().ticks >= 4000;
        }));
        const RecordedRun run = engine.recorded();
        engine.stop();
        QCOMPARE(run.hands(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i)
            QCOMPARE_GT(std::ranges::count_if(run.hand(i).proxy.rows,
                                              [](const ProxyRow& row) { return row.contacts > 0; }),
                        100);
        const ReplayCheck check = replayed(run);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(check.servoSteps, run.servo.rows.size() + run.others[0].servo.rows.size());
        QCOMPARE_GT(check.servoSteps, std::uint64_t(7000));
    }

    void aReplayedTickSaysWhatItsHandTouched() {
        auto player = Player::open(std::make_shared<const RecordedRun>(run_));
        VERIFY_RESULT(player);
        player->advanceTo(kForEver);
        for (std::size_t i = 0; i < 2; ++i) {
            int touched = 0;
            for (const TracePoint& tick : player->takeTrace(i)) {
                QCOMPARE(tick.touched.contacts > 0,
                         run_.scenes[0].scene->find(tick.touched.object) != nullptr);
                QCOMPARE(tick.touched.contacts > 0, tick.touched.friction != ContactFriction::None);
                touched += tick.touched.contacts > 0;
            }
            QCOMPARE_GT(touched, kSteps / 16);
        }
    }

    void fromTheMiddleToo() {
        auto player = Player::open(std::make_shared<const RecordedRun>(run_));
        VERIFY_RESULT(player);
        player->advanceTo(kForEver);
        const BodiesState last = player->proxy().bodies;
        const Vec3 right = player->touch(1).output.proxy;
        for (const double part : {0.9, 0.3, 0.5}) {
            player->seek(run_.begin() + part * (run_.end() - run_.begin()));
            player->advanceTo(kForEver);
            QVERIFY2(player->check().differ == 0, player->check().first.c_str());
            QCOMPARE_LT(player->check().proxySteps, 2 * run_.proxy.rows.size());
            QCOMPARE(player->proxy().bodies.q, last.q);
            QCOMPARE(player->touch(1).output.proxy, right);
        }
    }

    void whatIsCutOffAtTheFrontDoesNotMatter() {
        RecordedRun cut = run_;
        trim(cut, 1);
        QCOMPARE_GT(cut.proxy.first, std::uint64_t(0));
        QCOMPARE(cut.others[0].proxy.first, cut.proxy.first);
        const ReplayCheck check = replayed(cut);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(check.proxySteps, 2 * cut.proxy.rows.size());
    }

    /// One after the other the rings are copied: of the second there is more, or a state that the first
    /// lacks.
    void whatOneRingHasAloneIsLeftOut() {
        RecordedRun uneven = run_;
        uneven.proxy.rows.resize(uneven.proxy.rows.size() - 5); // ticks of the other name them
        uneven.others[0].proxyStates.erase(uneven.others[0].proxyStates.begin());
        trim(uneven);
        QCOMPARE(uneven.others[0].proxy.end(), uneven.proxy.end());
        QCOMPARE(uneven.proxyStates.size(), uneven.others[0].proxyStates.size());
        const ReplayCheck check = replayed(uneven);
        QVERIFY2(check.differ == 0, check.first.c_str());
    }

    void aFileHoldsBoth() {
        const std::string bytes = recordingBytes({run_, "two hands", {}});
        const auto read = parseRecording(bytes, "hands.tactum-recording");
        VERIFY_RESULT(read);
        QCOMPARE(read->run.hands(), std::size_t(2));
        QCOMPARE(read->run.others[0].device.name, std::string("Right"));
        const ReplayCheck check = replayed(read->run);
        QVERIFY2(check.differ == 0, check.first.c_str());
        QCOMPARE(recordingBytes(*read), bytes);
    }

    /// A program that knows of one hand alone need not know of others to read it.
    void aFileOfOneHandIsOfAFormatOfItsOwn() {
        RecordedRun one = run_;
        one.others.clear();
        const std::string bytes = recordingBytes({one, "one hand", {}});
        QCOMPARE(int(bytes[8]), 20);
        COMPARE_LACKS(bytes.substr(0, 4000), "others");
        QCOMPARE(int(recordingBytes({run_, "two hands", {}})[8]), 21);
    }

    void oneBitOfTheSecondIsFound() {
        RecordedRun forged = run_;
        auto& force = forged.others[0].proxy.rows[500].force[1];
        force = std::nextafter(force, 1.0);
        ReplayCheck check = replayed(forged);
        QCOMPARE(check.differ, std::uint64_t(1));
        COMPARE_BEGINS(check.first, "hand 2: haptic step 500 at ");
    }

    void whoseDoingItWasIsListed() {
        const std::vector<RecordedEvent> events = eventsOf(run_);
        const auto has = [&](std::string_view text) {
            return std::ranges::any_of(events, [&](const RecordedEvent& e) { return e.text == text; });
        };
        QVERIFY(has("hand 2: the device did not answer"));
        QVERIFY(!has("hand 1: the device did not answer"));
        QVERIFY(has("the bodies began anew"));
    }

    void handsThatCannotBeAreRefused() {
        RecordedRun uneven = run_;
        uneven.others[0].proxy.rows[700].world += 1;
        COMPARE_CONTAINS(refusal(uneven), "have not the same haptic steps");
        RecordedRun broken = run_;
        broken.others[0].servo.rows[100].scale = -1;
        COMPARE_CONTAINS(refusal(broken), "hand 2: servo tick 100");
        RecordedRun many = run_;
        many.others.resize(std::size_t(kMaxHands), run_.others[0]);
        COMPARE_CONTAINS(refusal(many), "more hands than can be");
    }
};

TACTUM_TEST(TestRecordedHands)

} // namespace test_recorded_hands

#include "test_recorded_hands.moc"
