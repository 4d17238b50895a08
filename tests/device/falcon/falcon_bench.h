// What the tests of the Falcon share: one in a socket, a firmware of no meaning, and a person at hand.
#pragma once

#include <atomic>
#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <QTemporaryDir>
#include <QTest>

#include "device/falcon/falcon.h"
#include "device/falcon/falcon_line.h"
#include "tests/device/falcon/boot_stream.h"
#include "tests/device/falcon/emulated_falcon.h"

namespace tactum::test {

inline constexpr int kSocket = 2;

/// Does what the driver asks for, and may give up at a step.
class Person : public Opening {
public:
    explicit Person(std::shared_ptr<EmulatedFalcon> device) : device_(std::move(device)) {}

    void begin(std::string_view step, std::string_view request) override {
        if (steps.empty() || steps.back() != step) steps.emplace_back(step);
        if (step == givesUpAt) gaveUp = true;
        if (request.empty()) return;
        asked = request;
        if (homes) device_->homeByHand();
    }
    void progress(double part) override { most = std::max(most, part); }
    bool cancelled() const override { return gaveUp; }

    std::vector<std::string> steps;
    std::string asked, givesUpAt;
    double most = 0;
    bool homes = true;
    std::atomic<bool> gaveUp{false};

private:
    std::shared_ptr<EmulatedFalcon> device_;
};

struct FalconBench {
    explicit FalconBench(double hurry = 20, int theSocket = kSocket)
        : socket(theSocket), device(std::make_shared<EmulatedFalcon>(hurry)) {
        const auto bytes = makeBootStream();
        std::ofstream(firmware(), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        plug();
    }
    ~FalconBench() { EmulatedBus::the().unplugAll(); }
    FalconBench(const FalconBench&) = delete;
    FalconBench& operator=(const FalconBench&) = delete;

    void plug() const { EmulatedFalcon::plug(socket, device); }
    void pull() const { EmulatedBus::the().unplug(socket); }
    static void unplug() { EmulatedBus::the().unplug(kSocket); }
    UsbPlace place() const { return {kFalconUsb, 1, 0, "1-" + std::to_string(socket)}; }
    std::string firmware() const { return (folder.path() + "/made-up.bin").toStdString(); }
    static DeviceInfo profile() {
        return {.name = "Novint Falcon",
                .maxForce = 8,
                .workspaceRadius = 0.04,
                .positionResolution = 5e-5,
                .damping = 0.5,
                .handDamping = 2};
    }
    std::unique_ptr<Falcon> driver() const {
        FalconSettings all = settings;
        all.firmware = firmware();
        return std::make_unique<Falcon>(place(), profile(), all);
    }
    /// One that is ready to be felt, as it is when it was in use before.
    std::unique_ptr<Falcon> opened() const {
        device->startFirmware(true);
        device->putGrip(Vec3::Zero());
        auto falcon = driver();
        return falcon->open() ? std::move(falcon) : nullptr;
    }

    QTemporaryDir folder;
    FalconSettings settings;
    int socket;
    std::shared_ptr<EmulatedFalcon> device;
};

/// What exchanges brought.
struct Run {
    int valid = 0;
    DeviceSample last;
};

/// Exchanges as if 1 ms apart, and fast enough for a chip in a hurry to have answered between; when the
/// machine was busy with others, as far apart as they were: the hand went on meanwhile.
inline Run exchange(Falcon& falcon, int times, const Vec3& force = Vec3::Zero()) {
    using Clock = std::chrono::steady_clock;
    thread_local auto last = Clock::now();
    Run run;
    for (int i = 0; i < times; ++i) {
        const auto now = Clock::now();
        const double elapsed = std::chrono::duration<double>(now - std::exchange(last, now)).count();
        run.last = falcon.exchange({force}, std::max(1e-3, elapsed));
        run.valid += run.last.valid && run.last.position.allFinite(); // what is no number cannot be true
        std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    return run;
}

} // namespace tactum::test

namespace QTest {

template <> inline char* toString(const tactum::FalconLegs& legs) {
    return qstrdup(QByteArray::number(legs[0]) + ' ' + QByteArray::number(legs[1]) + ' ' +
                   QByteArray::number(legs[2]));
}

} // namespace QTest
