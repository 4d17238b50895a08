// The self-test in real time: the real driver, the real libusb and an emulated Falcon, sound and with faults
// put in between driver and program.
#include <QTest>

#include "device/self_test/device_bench.h"
#include "device/self_test/self_test.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_device_bench {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr FalconBody::Hand kFree{.mass = 0.15, .stiffness = 0, .damping = 1.2};

struct Wrong {
    Vec3 scale{1, 1, 1}; ///< of the readings
    Vec3 motor{1, 1, 1};
    std::size_t late = 0; ///< ticks, of the commands
};

/// A device whose maker, or whose driver, got something wrong.
class WrongDevice final : public HapticDevice {
public:
    WrongDevice(std::unique_ptr<HapticDevice> device, const Wrong& wrong)
        : device_(std::move(device)), wrong_(wrong) {}

    DeviceInfo info() const override { return device_->info(); }
    Result<void> open() override { return device_->open(); }
    void close() override { device_->close(); }
    std::string trouble() const override { return device_->trouble(); }
    bool awaitFrame(std::int64_t until) noexcept override { return device_->awaitFrame(until); }
    void emergencyStop() noexcept override { device_->emergencyStop(); }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        onTheWay_[tick_ % onTheWay_.size()] = command.force;
        const Vec3 force = onTheWay_[(tick_ + onTheWay_.size() - wrong_.late) % onTheWay_.size()];
        ++tick_;
        DeviceSample sample = device_->exchange({force.cwiseProduct(wrong_.motor)}, dt);
        sample.position = sample.position.cwiseProduct(wrong_.scale);
        return sample;
    }

private:
    std::unique_ptr<HapticDevice> device_;
    Wrong wrong_;
    std::array<Vec3, 32> onTheWay_{};
    std::size_t tick_ = 0;
};

/// Leads the emulated grip as it is asked, and has no mass to hang.
class FalconPerson final : public TrialPerson {
public:
    explicit FalconPerson(EmulatedFalcon& falcon) : falcon_(falcon) {}

    bool does(TrialAsk what, const std::string&) override {
        const bool led = what == TrialAsk::Zero || what == TrialAsk::Right || what == TrialAsk::Up ||
                         what == TrialAsk::Toward;
        falcon_.setHand(led ? FalconBody::Hand{} : kFree);
        falcon_.putGrip(what == TrialAsk::Right    ? Vec3(kRulerWay, 0, 0)
                        : what == TrialAsk::Up     ? Vec3(0, kRulerWay, 0)
                        : what == TrialAsk::Toward ? Vec3(0, 0, kRulerWay)
                                                   : Vec3(0, 0, 0));
        return what != TrialAsk::Press;
    }
    std::optional<double> mass() override { return {}; }
    void hears(const std::string&) override {}

private:
    EmulatedFalcon& falcon_;
};

Result<SelfTestReport> reportOf(FalconBench& bench, const Wrong& wrong) {
    WrongDevice device(bench.opened(), wrong);
    FalconPerson person(*bench.device);
    DeviceBench trials(device);
    if (const auto started = trials.start(); !started) return tl::unexpected(started.error());
    DeviceInfo said = device.info();
    said.delay = 4; // ticks: what the emulated bus and its chip take is less
    return selfTest(trials, person, said, {.rest = 0.5, .shake = 8});
}

double valueOf(const SelfTestReport& report, const std::string& name) {
    for (const SelfTestFigure& figure : report.figures)
        if (figure.name == name) return figure.measured.value;
    return NAN;
}

QByteArray all(const SelfTestReport& report) {
    QByteArray text;
    for (const std::string& line : report.faults)
        text += QByteArray::fromStdString(line) + '\n';
    for (const std::string& line : report.leftOut)
        text += "left out: " + QByteArray::fromStdString(line) + '\n';
    for (const SelfTestFigure& figure : report.figures)
        text += QByteArray::fromStdString(figure.name) + ": " + QByteArray::number(figure.measured.value) +
                " +- " + QByteArray::number(figure.measured.error) + '\n';
    return text;
}

} // namespace

class TestDeviceBench : public QObject {
    Q_OBJECT

private slots:
    void aSoundFalconIsMeasured() {
        TACTUM_NEEDS_QUIET(); // a tick that comes late is a force that lasted longer
        FalconBench bench(1);
        const auto report = reportOf(bench, {});
        VERIFY_RESULT(report);
        const QByteArray text = all(*report);
        qInfo("%s", text.constData());
        QVERIFY2(report->faults.empty(), text);
        for (const char* axis : {"x", "y", "z"}) {
            const double mass = valueOf(*report, std::string("moving mass along ") + axis),
                         damping = valueOf(*report, std::string("damping along ") + axis);
            QVERIFY2(std::abs(mass / kFree.mass - 1) < 0.05, text);
            QVERIFY2(std::abs(damping / kFree.damping - 1) < 0.05, text);
        }
        QVERIFY2(!bench.device->overdriven(), text);
    }

    void eachPutInFaultIsNamed() {
        TACTUM_NEEDS_QUIET();
        FalconBench bench(1);
        const auto report = reportOf(bench, {.scale = {-1, 1.5, 1}, .motor = {-1, 1, -1}, .late = 6});
        VERIFY_RESULT(report);
        const QByteArray text = all(*report);
        qInfo("%s", text.constData());
        for (const char* sentence :
             {"x runs the other way", "y reads 1.50 times as far", "The motors push the other way along x.",
              "The motors push the other way along z.", "Forces come "})
            QVERIFY2(text.contains(sentence), text);
        QCOMPARE(report->faults.size(), std::size_t(5));
    }

    void aHandleThatIsThrownGetsNoForce() {
        FalconBench bench(1);
        WrongDevice device(bench.opened(), {});
        bench.device->setHand(kFree);
        bench.device->putGrip({0, -0.02, 0});
        DeviceBench trials(device);
        VERIFY_RESULT(trials.start());
        const auto throws = [](const TrialRow&, const Vec3&) -> Vec3 { return {0, 7, 0}; };
        const auto rows = trials.run(5, 8, throws);
        QVERIFY(!rows);
        COMPARE_CONTAINS(QByteArray::fromStdString(rows.error().text), "was faster than 1.5 m/s");
        QTRY_VERIFY(bench.device->force().isZero());
    }

    void aCableThatIsPulledEndsItWithASentence() {
        FalconBench bench(1);
        WrongDevice device(bench.opened(), {});
        DeviceBench trials(device);
        VERIFY_RESULT(trials.start());
        const auto zero = [](const TrialRow&, const Vec3&) -> Vec3 { return Vec3::Zero(); };
        VERIFY_RESULT(trials.run(0.1, 1, zero));
        bench.pull();
        const auto rows = trials.run(5, 1, zero);
        QVERIFY(!rows);
        COMPARE_CONTAINS(QByteArray::fromStdString(rows.error().text), "gives no readings");
    }
};

TACTUM_TEST(TestDeviceBench)

} // namespace test_device_bench

#include "test_device_bench.moc"
