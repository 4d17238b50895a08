// What stands between a device and the servo: its figures, its axes, the time of its readings, its button.
#include <QTest>

#include "core/port/device_figures.h"
#include "core/port/device_frame.h"
#include "core/port/own_limit.h"
#include "core/port/reading_clock.h"
#include "core/port/stop_button.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_device_parts {

using namespace tactum;
using test::refusal;

namespace {

constexpr double kTick = 1e-3; // s
constexpr std::int64_t kMs = 1'000'000;

/// Notes what it is asked.
struct Noting final : HapticDevice {
    std::vector<std::string> calls;
    std::uint32_t held = 0;
    Vec3 sent = Vec3::Zero(), announced = Vec3::Zero();
    double dt = 0;
    std::int64_t until = 0;

    DeviceInfo figures{.name = "noting"};

    DeviceInfo info() const override { return figures; }
    std::vector<std::string> steps() const override { return {"one", "two"}; }
    Result<void> prepare(Opening&) override { return machineError("no preparation"); }
    Result<void> open() override { return machineError("no opening"); }
    void close() override { calls.emplace_back("close"); }
    std::string trouble() const override { return "a trouble"; }
    void announce(const DeviceCommand& command) noexcept override { announced = command.force; }
    bool awaitFrame(std::int64_t moment) noexcept override {
        until = moment;
        return true;
    }
    DeviceSample exchange(const DeviceCommand& command, double time) noexcept override {
        sent = command.force;
        dt = time;
        DeviceSample sample;
        sample.buttons = held;
        sample.position = Vec3(1, 2, 3);
        return sample;
    }
    void emergencyStop() noexcept override { calls.emplace_back("stop"); }
};

DeviceSample at(std::int64_t ns) {
    DeviceSample sample;
    sample.valid = true;
    sample.at = ns;
    return sample;
}

} // namespace

class TestDeviceParts : public QObject {
    Q_OBJECT

private slots:
    void figuresHaveTheirBounds() {
        const auto set = [](double DeviceInfo::*value, double to) {
            DeviceInfo info;
            info.*value = to;
            return impossibleFigure(info);
        };
        for (const DeviceFigure& figure : kDeviceFigures) {
            QVERIFY2(set(figure.value, figure.least).empty(), figure.key);
            QVERIFY2(set(figure.value, figure.most).empty(), figure.key);
            const double width = figure.most - figure.least;
            for (const double wrong : {figure.least - 1e-9 * width, figure.most + 1e-9 * width, std::nan("")})
                COMPARE_BEGINS(std::string_view(set(figure.value, wrong)),
                               std::string_view("its " + std::string(figure.name) + " is "));
        }
        // Those that people see, and what no device has.
        const auto boundsOf = [](std::string_view key) {
            for (const DeviceFigure& figure : kDeviceFigures)
                if (figure.key == key) return std::pair{figure.least, figure.most};
            return std::pair{0.0, 0.0};
        };
        using Bounds = std::pair<double, double>;
        QVERIFY(boundsOf("rate_Hz") == Bounds(150, 10000));
        QVERIFY(boundsOf("max_force_N") == Bounds(0, 1e4));
        QVERIFY(boundsOf("max_stiffness_N_per_m") == Bounds(0, 1e9));
        QVERIFY(boundsOf("trip_speed_m_per_s") == Bounds(1e-3, 1e3));
        QCOMPARE(set(&DeviceInfo::rate, 149),
                 std::string("its rate is 149 Hz, and it must be from 150 to 10000"));
        DeviceInfo info;
        for (const int fine : {0, 31}) {
            info.buttons = fine;
            VERIFY_RESULT(checkDevice(info));
        }
        for (const int wrong : {-1, 32}) {
            info.buttons = wrong;
            COMPARE_CONTAINS(refusal(checkDevice(info)), "its number of buttons is");
        }
    }

    /// Axis by axis: which of the device's it is, and its sense.
    void axesAreTurned() {
        const DeviceFrame frame{2, {-2, 3, 1}, Vec3(10, 20, 30)};
        QCOMPARE(frame.turned(Vec3(1, 2, 3)), Vec3(-2, 3, 1));
        QCOMPARE(frame.turnedBack(Vec3(-2, 3, 1)), Vec3(1, 2, 3));
        QCOMPARE(frame.pointInWorld(Vec3(1, 2, 3)), Vec3(6, 26, 32));
        QCOMPARE(frame.pointInDevice(Vec3(6, 26, 32)), Vec3(1, 2, 3));
        QCOMPARE(frame.wayInWorld(Vec3(1, 2, 3)), Vec3(-4, 6, 2));
        QCOMPARE(frame.wayInDevice(Vec3(-4, 6, 2)), Vec3(1, 2, 3));
        QCOMPARE(DeviceFrame{}.pointInWorld(Vec3(1, 2, 3)), Vec3(1, 2, 3));
    }

    void readingsAreAsFarApartAsTheyWereMeasured() {
        ReadingClock clock;
        clock(at(1000 * kMs), kTick, 1000 * kMs);
        COMPARE_NEAR(clock(at(1003 * kMs), kTick, 1001 * kMs), 3e-3, 1e-12, "s"); // whatever the ticks
        QCOMPARE(clock(at(1003 * kMs), kTick, 1002 * kMs), 0.0);                  // once more
        QCOMPARE(clock(at(1002 * kMs), kTick, 1003 * kMs), 0.0);                  // or an older one
        // After a standstill the machine may have slept, which the readings' clock does not count.
        clock(at(1004 * kMs), kTick, 1004 * kMs);
        COMPARE_NEAR(clock(at(1005 * kMs), 0.5, 1504 * kMs), 0.5, 1e-12, "s");
        COMPARE_NEAR(clock(at(1006 * kMs), 0.009, 1513 * kMs), 1e-3, 1e-12, "s"); // 9 ms are none
    }

    /// Who does not say when it was measured: the longest that it can be.
    void withoutATimeTheLongestCounts() {
        ReadingClock clock;
        COMPARE_NEAR(clock(at(0), kTick, 1000 * kMs), kTick, 1e-12, "s");
        COMPARE_NEAR(clock(at(0), kTick, 1004 * kMs), 4e-3, 1e-12, "s");
        COMPARE_NEAR(clock(at(0), 6e-3, 1005 * kMs), 6e-3, 1e-12, "s");
        // What brought nothing adds up.
        COMPARE_NEAR(clock(DeviceSample{}, kTick, 1006 * kMs), 1e-3, 1e-12, "s");
        COMPARE_NEAR(clock(DeviceSample{}, kTick, 1008 * kMs), 3e-3, 1e-12, "s");
        COMPARE_NEAR(clock(at(0), kTick, 1009 * kMs), 4e-3, 1e-12, "s");
        COMPARE_NEAR(clock(at(0), kTick, 1010 * kMs), 1e-3, 1e-12, "s");
        // The first that says it has none before it to compare with.
        COMPARE_NEAR(clock(at(1011 * kMs), kTick, 1012 * kMs), 2e-3, 1e-12, "s");
    }

    void theStopButtonHandsEverythingElseOn() {
        auto made = std::make_unique<Noting>();
        Noting& noting = *made;
        const auto stop = std::make_shared<StopSwitch>();
        StopButton device(std::move(made), stop);
        QCOMPARE(device.info().name, std::string("noting"));
        QCOMPARE(device.steps().size(), std::size_t(2));
        QCOMPARE(refusal(device.open()), std::string("no opening"));
        Opening* none = nullptr;
        QCOMPARE(refusal(device.prepare(*none)), std::string("no preparation"));
        QCOMPARE(device.trouble(), std::string("a trouble"));
        QVERIFY(device.awaitFrame(77));
        QCOMPARE(noting.until, std::int64_t(77));
        device.close();
        device.emergencyStop();
        QCOMPARE(noting.calls, (std::vector<std::string>{"close", "stop"}));
        const DeviceSample sample = device.exchange({Vec3(1, 2, 3)}, 0.002);
        QCOMPARE(sample.position, Vec3(1, 2, 3));
        QCOMPARE(noting.sent, Vec3(1, 2, 3));
        QCOMPARE(noting.dt, 0.002);
        QVERIFY(!sample.stopped);
    }

    void aLimitOfOnesOwnIsAFigureOfTheDevice() {
        const auto limited = [](double most, double forEver, double wanted) {
            auto device = std::make_unique<Noting>();
            device->figures = {.name = "strong", .maxForce = most, .continuousForce = forEver, .rate = 4000};
            return OwnLimit(std::move(device), wanted).info();
        };
        const DeviceInfo weaker = limited(8, 3, 2.5);
        QCOMPARE(weaker.maxForce, 2.5);
        QCOMPARE(weaker.continuousForce, 2.5);
        QCOMPARE(weaker.rate, 4000.0);
        QCOMPARE(weaker.name, std::string("strong"));
        QCOMPARE(limited(8, 1.5, 2.5).continuousForce, 1.5);
        QCOMPARE(limited(8, 0, 2.5).continuousForce, 0.0); // for ever as much as at all
        QCOMPARE(limited(2, 1, 2.5).maxForce, 2.0);
    }

    void theStopButtonEndsAllForceUntilSomebodySaysOtherwise() {
        auto made = std::make_unique<Noting>();
        Noting& noting = *made;
        const auto stop = std::make_shared<StopSwitch>();
        StopButton device(std::move(made), stop);
        const DeviceCommand push{Vec3(1, 0, 0)};
        noting.held = 3;
        QVERIFY(!device.exchange(push, kTick).stopped); // none of them is a stop button
        stop->buttons = 4;
        QVERIFY(!device.exchange(push, kTick).stopped);
        QVERIFY(!stop->pressed);
        noting.held = 5;
        QVERIFY(device.exchange(push, kTick).stopped);
        QVERIFY(stop->pressed);
        device.announce(push);
        QCOMPARE(noting.announced, Vec3(0, 0, 0));
        noting.held = 0;
        QVERIFY(device.exchange(push, kTick).stopped);
        QCOMPARE(noting.sent, Vec3(0, 0, 0));
        stop->pressed = false;
        QVERIFY(!device.exchange(push, kTick).stopped);
        QCOMPARE(noting.sent, Vec3(1, 0, 0));
        device.announce(push);
        QCOMPARE(noting.announced, Vec3(1, 0, 0));
    }
};

TACTUM_TEST(TestDeviceParts)

} // namespace test_device_parts

#include "test_device_parts.moc"
