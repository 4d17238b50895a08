// The self-test in real time: the real driver, the real libusb and an emulated Falcon, sound and with faults
// put in between driver and program.
#include <thread>

#include <QTest>

#include "core/port/stop_button.h"
#include "core/self_test/device_bench.h"
#include "core/self_test/self_test.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/device/falcon/wrong_falcon.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_device_bench {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Leads the emulated grip as it is asked, and has no mass to hang.
class FalconPerson final : public TrialPerson {
public:
    explicit FalconPerson(EmulatedFalcon& falcon) : falcon_(falcon) {}

    bool does(TrialAsk what, const TrialWords&) override {
        doAsAsked(falcon_, what);
        return what != TrialAsk::Press;
    }
    std::optional<double> mass(double) override { return {}; }
    void hears(const TrialWords&) override {}

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
        if (figure.name.english() == name) return figure.measured.value;
    return NAN;
}

QByteArray all(const SelfTestReport& report) {
    QByteArray text;
    for (const TrialWords& line : report.faults)
        text += QByteArray::fromStdString(line.english()) + '\n';
    for (const TrialWords& line : report.leftOut)
        text += "left out: " + QByteArray::fromStdString(line.english()) + '\n';
    for (const SelfTestFigure& figure : report.figures)
        text += QByteArray::fromStdString(figure.name.english()) + ": " +
                QByteArray::number(figure.measured.value) + " +- " +
                QByteArray::number(figure.measured.error) + '\n';
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
            QVERIFY2(std::abs(mass / kFreeGrip.mass - 1) < 0.05, text);
            QVERIFY2(std::abs(damping / kFreeGrip.damping - 1) < 0.05, text);
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
        bench.device->setHand(kFreeGrip);
        bench.device->putGrip({0, -0.02, 0});
        DeviceBench trials(device);
        VERIFY_RESULT(trials.start());
        const auto throws = [](const TrialRow&, const Vec3&) -> Vec3 { return {0, 7, 0}; };
        const auto rows = trials.run(5, 8, throws);
        QVERIFY(!rows);
        COMPARE_CONTAINS(QByteArray::fromStdString(rows.error().text), "was faster than 1.5 m/s");
        QTRY_VERIFY(bench.device->force().isZero());
    }

    void endedFromOutsideItHasNoForceAtOnce() {
        FalconBench bench(1);
        WrongDevice device(bench.opened(), {});
        DeviceBench trials(device);
        VERIFY_RESULT(trials.start());
        const auto holds = [](const TrialRow&, const Vec3&) -> Vec3 { return {0, 1, 0}; };
        std::thread person([&] {
            while (!(trials.look().runs && trials.look().force.y() > 0.5))
                std::this_thread::yield();
            trials.end();
        });
        const auto rows = trials.run(60, 8, holds);
        person.join();
        QVERIFY(!rows);
        COMPARE_CONTAINS(QByteArray::fromStdString(rows.error().text), "has no force any more");
        QTRY_VERIFY(bench.device->force().isZero());
        QVERIFY(!trials.run(1, 8, holds)); // nor ever again
    }

    /// The button that ends all force ends an experiment that has some, and not the one that counts the
    /// buttons.
    void theStopButtonEndsWhatHasForce() {
        FalconBench bench(1);
        const auto stop = std::make_shared<StopSwitch>();
        stop->buttons = 1;
        StopButton device(bench.opened(), stop);
        DeviceBench trials(device);
        VERIFY_RESULT(trials.start());
        const auto holds = [](const TrialRow&, const Vec3&) -> Vec3 { return {0, 1, 0}; };
        VERIFY_RESULT(trials.run(0.1, 8, holds));
        bench.device->setButtons(1);
        const auto counted = trials.run(0.3, 0, holds);
        VERIFY_RESULT(counted);
        QCOMPARE(counted->back().buttons, 1U);
        QVERIFY(stop->pressed);
        const auto rows = trials.run(5, 8, holds);
        QVERIFY(!rows);
        COMPARE_CONTAINS(QByteArray::fromStdString(rows.error().text), "was stopped by its own button");
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
