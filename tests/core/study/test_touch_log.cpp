// The log of the touch: each column against a state that was made on purpose.
#include <algorithm>

#include <QTest>

#include "core/study/touch_log.h"
#include "tests/core/study/log_table.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_touch_log {

using namespace tactum;
using namespace tactum::test;

namespace {

Soup plate() {
    return SoupBuilder().quad({-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}).build();
}

/// A finger on a plate of 800 N/m at z = 0, driven at 1 kHz by the functions that the loops call, on a device
/// of 3 N.
class LoggedHand {
public:
    explicit LoggedHand(double friction) : hand_(worldOf(friction)), servo_(device()) {
        settings_.overrideCeiling = true;
        rest({0, 0, 0.005});
    }
    void forces(bool on) {
        settings_.armed = on;
        rest(hand_.finger());
    }
    /// Straight down, as deep below where the proxy rests; and along the plate from there.
    void press(double depth) { go({0, 0, kRadius - depth}); }
    void pull(double way) { slide(hand_.finger() + Vec3(way, 0, 0)); }

    const World& world() const { return hand_.world(); }
    std::map<std::string, std::string> row() const { return row(world().scene.get()); }
    std::map<std::string, std::string> row(const Scene* names) const {
        std::string csv = TouchLog::header();
        TouchLog log(1);
        log.add(csv, {.t = tick_.t - kMillisecond, .finger = tick_.finger}, {});
        log.add(csv, tick_, {.scene = names});
        return tableOf(csv).at(0);
    }

private:
    static constexpr double kRadius = 1e-3; // m

    static std::shared_ptr<const World> worldOf(double friction) {
        Scene scene = test::sceneOf(plate(), rough(friction, friction), kRadius);
        scene.objects[0].name = "table";
        scene.objects[0].surfaces[0].name = "top";
        return compile(scene).value();
    }
    static DeviceInfo device() {
        DeviceInfo info;
        info.maxForce = 3;
        return info;
    }
    void go(const Vec3& to) {
        slide(to);
        rest(to);
    }
    void slide(const Vec3& to) {
        const Vec3 from = hand_.finger();
        constexpr int kSteps = 200;
        for (int i = 1; i <= kSteps; ++i)
            step(from + (to - from) * (double(i) / kSteps));
    }
    void rest(const Vec3& at) {
        for (int i = 0; i < 1000; ++i)
            step(at);
    }
    void step(const Vec3& finger) {
        hand_.to(finger);
        LocalContactModel model = hand_.state.model;
        model.anchoring = servo_.gate.anchoring();
        const DeviceSample sample{.position = finger, .valid = true};
        const ServoOutput output = servoStep(servo_, settings_, {.sample = sample, .fresh = true}, model);
        note(telemetry_, output, servo_);
        tick_ = tracePoint(tick_.t + kMillisecond, telemetry_, output, model,
                           touchedPlace(hand_.output(), hand_.world()));
    }

    Hand hand_;
    ServoState servo_;
    ServoSettings settings_;
    ServoTelemetry telemetry_;
    TracePoint tick_;
};

} // namespace

class TestTouchLog : public QObject {
    Q_OBJECT

private slots:
    void theTouchIsARowForEachTick();
    void aTouchSaysWhatIsTouched();
    void aTouchSaysStickOrSlip();
    void aTouchSaysWhatWasWantedAndWhatWasSent();
    void aTouchSaysOfWhichStimulus();
};

void TestTouchLog::theTouchIsARowForEachTick() {
    std::string csv = TouchLog::header();
    TouchLog every(1), third(3);
    std::string thinned = csv;
    for (int i = 0; i < 10; ++i) {
        TracePoint tick;
        tick.t = 0.25 + 0.001 * i;
        tick.finger = {0.002 * i, 0, -1}, tick.proxy = {0, 1, 2}, tick.force = {0, 0, 0.5 * i};
        tick.touching = i > 4;
        every.add(csv, tick, {.trial = 3, .interval = 2, .hand = 2});
        third.add(thinned, tick, {.trial = 3, .interval = 2});
    }
    const auto table = tableOf(csv);
    QCOMPARE(table.size(), std::size_t(9)); // the first tick has no velocity
    auto last = table.back();
    QCOMPARE(last["format"], std::string("1.1"));
    QCOMPARE(last["trial"], std::string("3"));
    QCOMPARE(last["interval"], std::string("2"));
    QCOMPARE(last["hand"], std::string("2"));
    COMPARE_NEAR(std::stod(last["t_s"]), 0.259, 1e-12, "s");
    COMPARE_NEAR(std::stod(last["velocity_x_m_per_s"]), 2, 1e-9, "m/s");
    QCOMPARE(last["finger_z_m"], std::string("-1"));
    QCOMPARE(last["proxy_y_m"], std::string("1"));
    QCOMPARE(last["force_z_N"], std::string("4.5"));
    QCOMPARE(last["touching"], std::string("1"));
    QCOMPARE(tableOf(thinned).size(), std::size_t(3));
    every.interrupt();
    std::string rows;
    every.add(rows, {.t = 0.26}, {.trial = 4});
    QCOMPARE(rows, std::string());
}

void TestTouchLog::aTouchSaysWhatIsTouched() {
    LoggedHand hand(0.5);
    hand.forces(true);
    auto row = hand.row();
    for (const char* column : {"contacts", "wanted_z_N", "force_z_N", "normal_N", "tangential_N"})
        QCOMPARE(row[column], std::string("0"));
    QCOMPARE(row["object"] + row["surface"], std::string());
    QCOMPARE(row["friction"], std::string("none"));
    hand.press(1e-3);
    row = hand.row();
    QCOMPARE(row["contacts"], std::string("1"));
    QCOMPARE(row["object"], std::string("table"));
    QCOMPARE(row["surface"], std::string("top"));
    QCOMPARE(row["friction"], std::string("stick"));
    QCOMPARE(row["scene_revision"], std::to_string(hand.world().revision));
    row = hand.row(nullptr); // of a scene that nobody knows
    QCOMPARE(row["contacts"], std::string("1"));
    QCOMPARE(row["object"] + row["surface"], std::string());
}

void TestTouchLog::aTouchSaysStickOrSlip() {
    LoggedHand hand(0.5);
    hand.forces(true);
    hand.press(1e-3);
    // 800 N/m: 0.8 N into the plate, of which friction holds 0.4.
    hand.pull(2e-4);
    auto row = hand.row();
    QCOMPARE(row["friction"], std::string("stick"));
    COMPARE_NEAR(std::stod(row["normal_N"]), 0.8, 0.004, "N");
    COMPARE_NEAR(std::stod(row["tangential_N"]), 0.16, 0.004, "N");
    COMPARE_NEAR(std::stod(row["force_x_N"]), -0.16, 0.004, "N");
    hand.pull(4e-3);
    row = hand.row();
    QCOMPARE(row["friction"], std::string("slip"));
    COMPARE_NEAR(std::stod(row["normal_N"]), 0.8, 0.004, "N");
    COMPARE_NEAR(std::stod(row["tangential_N"]), 0.4, 0.004, "N");
    LoggedHand smooth(0);
    smooth.forces(true);
    smooth.press(1e-3);
    QCOMPARE(smooth.row()["friction"], std::string("smooth"));
}

void TestTouchLog::aTouchSaysWhatWasWantedAndWhatWasSent() {
    LoggedHand hand(0);
    hand.press(1e-3); // with the forces off
    auto row = hand.row();
    QCOMPARE(row["gain"], std::string("0"));
    QCOMPARE(row["force_z_N"], std::string("0"));
    COMPARE_NEAR(std::stod(row["wanted_z_N"]), 0.8, 1e-6, "N");
    hand.forces(true);
    hand.press(1e-3);
    row = hand.row();
    QCOMPARE(row["gain"], std::string("1"));
    QCOMPARE(row["clipped"], std::string("0"));
    COMPARE_NEAR(std::stod(row["wanted_z_N"]), 0.8, 1e-6, "N");
    COMPARE_NEAR(std::stod(row["force_z_N"]), 0.8, 1e-6, "N");
    hand.press(5e-3); // 4 N, of which the device gives 3
    row = hand.row();
    QCOMPARE(row["clipped"], std::string("1"));
    COMPARE_NEAR(std::stod(row["wanted_z_N"]), 4, 1e-6, "N");
    COMPARE_NEAR(std::stod(row["force_z_N"]), 3, 1e-6, "N");
    hand.forces(false);
    row = hand.row();
    COMPARE_NEAR(std::stod(row["wanted_z_N"]), 4, 1e-6, "N");
    QCOMPARE(row["gain"], std::string("0"));
    QCOMPARE(row["clipped"], std::string("0"));
    QCOMPARE(row["force_z_N"], std::string("0"));
}

void TestTouchLog::aTouchSaysOfWhichStimulus() {
    std::string csv = TouchLog::header();
    TouchLog log(1);
    const TouchMoment moment{.trial = 4, .interval = 1, .hand = 1, .condition = "soft", .value = 3e-4};
    log.add(csv, {.t = 1}, moment);
    log.add(csv, {.t = 1.001, .revision = 12}, moment);
    log.add(csv, {.t = 1.002, .revision = 13}, {.condition = "stiff, \"2\""});
    auto first = tableOf(csv).at(0);
    QCOMPARE(first["condition"], std::string("soft"));
    QCOMPARE(std::stod(first["value"]), 3e-4);
    QCOMPARE(first["scene_revision"], std::string("12"));
    COMPARE_CONTAINS(csv, std::string(",\"stiff, \"\"2\"\"\",,13,"));
    // Each row has a cell for each column.
    const auto cells = [](std::string_view line) { return std::ranges::count(line, ','); };
    const std::string row = csv.substr(csv.find('\n') + 1);
    QCOMPARE(cells(row.substr(0, row.find('\n'))), cells(TouchLog::header()));
}

} // namespace test_touch_log

using test_touch_log::TestTouchLog;
TACTUM_TEST(TestTouchLog)
#include "test_touch_log.moc"
