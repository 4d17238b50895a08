#include "tests/device/contract/rigs.h"

#include <dlfcn.h>
#include <functional>
#include <map>
#include <new>
#include <thread>

#include <QByteArray>
#include <QTemporaryDir>

#include "device/recorded_hand.h"
#include "device/remote/remote_device.h"
#include "device/simulated_hand.h"
#include "device/vendor/force_dimension.h"
#include "device/vendor/haply_inverse3.h"
#include "device/vendor/open_haptics.h"
#include "device/wooden_haptics/wooden_haptics.h"
#include "tests/device/contract/board_rigs.h"
#include "tests/device/falcon/falcon_bench.h"
#include "tests/device/remote/served_device.h"
#include "tests/device/vendor/fake_dhd.h"
#include "tests/device/vendor/fake_haply.h"
#include "tests/device/vendor/fake_hd.h"
#include "tests/device/wooden_haptics/emulated_wooden_haptics.h"

namespace tactum::test {
namespace {

Result<DeviceInfo> benchFigures(std::string_view) {
    return benchProfile();
}

/// The memory of a library that stands in for a maker's, as new.
template <class Fake> Fake& freshFake(const char* file, const char* symbol) {
    void* library = dlopen(file, RTLD_NOW | RTLD_NODELETE);
    if (!library) qFatal("%s", dlerror());
    Fake& fake = reinterpret_cast<Fake& (*)()>(dlsym(library, symbol))();
    return *new (&fake) Fake;
}

class SimulatedRig final : public DeviceRig {
public:
    SimulatedRig() { device_ = std::make_unique<SimulatedHand>(std::make_shared<HandTarget>()); }
};

class RecordedRig final : public DeviceRig {
public:
    RecordedRig() {
        device_ = std::make_unique<RecordedHand>(
            std::vector<RecordedPoint>{{0, Vec3::Zero()}, {1, Vec3(0.01, 0, 0)}});
    }
};

class FalconRig final : public DeviceRig {
public:
    FalconRig() {
        bench_.device->startFirmware(true);
        bench_.device->putGrip(Vec3::Zero());
        device_ = bench_.driver();
    }
    ~FalconRig() override { device_.reset(); }
    std::optional<Vec3> pushed() const override { return bench_.device->force(); }
    bool pull() override {
        bench_.pull();
        return true;
    }
    void plug() override { bench_.plug(); }

private:
    FalconBench bench_;
};

/// Leads the arm to its rest.
class AtRest final : public Opening {
public:
    explicit AtRest(EmulatedWoodenHaptics& arm) : arm_(arm) {}
    void begin(std::string_view, std::string_view) override {}
    void progress(double) override {}
    bool cancelled() const override {
        ++time_;
        arm_.hold(time_ < 500 ? Vec3(Vec3(0.3, 0.5, 0.4) * (1 - time_ / 500.0)) : Vec3(Vec3::Zero()));
        arm_.tick();
        return time_ > 10'000;
    }

private:
    EmulatedWoodenHaptics& arm_;
    mutable int time_ = 0;
};

class WoodenRig final : public DeviceRig {
public:
    WoodenRig() {
        arm_->hold({0.3, 0.5, 0.4});
        arm_->restart();
        plug();
        const UsbId wanted[] = {kWoodenHapticsId};
        device_ = std::make_unique<WoodenHaptics>(listUsb(wanted).value().at(0), benchProfile());
    }
    ~WoodenRig() override {
        device_.reset();
        EmulatedBus::the().unplugAll();
    }
    Result<void> open() override {
        AtRest person(*arm_);
        const Result<void> opened = device_->prepare(person).and_then([this] { return device_->open(); });
        if (opened)
            arm_->hold(*jointsAt(arm_->arm, Vec3::Zero())); // off the rest, where it can push all ways
        return opened;
    }
    DeviceSample exchange(const Vec3& force) override {
        arm_->tick();
        return device_->exchange({force}, 1e-3);
    }
    std::optional<Vec3> pushed() const override {
        for (std::size_t motor = 0; motor < 3; ++motor)
            if (arm_->milliamperes(motor) != 0) return arm_->motorForce();
        return Vec3(Vec3::Zero()); // in the rest position no force belongs to the torques
    }
    bool pull() override {
        EmulatedBus::the().unplug(1);
        return true;
    }
    void plug() override { EmulatedBus::the().plug(1, arm_); }

private:
    std::shared_ptr<EmulatedWoodenHaptics> arm_ = std::make_shared<EmulatedWoodenHaptics>();
};

class OpenHapticsRig final : public DeviceRig {
public:
    OpenHapticsRig() {
        qputenv("TACTUM_LIBHD", TACTUM_FAKE_HD);
        device_ = makeOpenHaptics("openhaptics:default", benchFigures).value();
    }
    std::optional<Vec3> pushed() const override {
        return Vec3(fake_.motors[0], fake_.motors[1], fake_.motors[2]);
    }
    bool pull() override {
        fake_.frameError = 0x0301; // a failed communication
        fake_.initError = 0x0302;
        return true;
    }
    void plug() override { fake_.frameError = fake_.initError = 0; }

private:
    FakeHd& fake_ = freshFake<FakeHd>(TACTUM_FAKE_HD, "fakeHd");
};

class ForceDimensionRig final : public DeviceRig {
public:
    ForceDimensionRig() {
        qputenv("TACTUM_LIBDHD", TACTUM_FAKE_DHD);
        device_ = makeForceDimension("forcedimension:0", benchFigures).value();
    }
    std::optional<Vec3> pushed() const override {
        return Vec3(fake_.motors[1], fake_.motors[2], fake_.motors[0]);
    }
    bool pull() override {
        fake_.readError = fake_.sendError = 2;
        fake_.openError = 5;
        for (auto& motor : fake_.motors)
            motor = 0; // its power is the cable's
        return true;
    }
    void plug() override { fake_.readError = fake_.sendError = fake_.openError = 0; }
    bool stops() const override { return false; }

private:
    FakeDhd& fake_ = freshFake<FakeDhd>(TACTUM_FAKE_DHD, "fakeDhd");
};

class HaplyRig final : public DeviceRig {
public:
    HaplyRig() {
        qputenv("TACTUM_HAPLY_PORT", QByteArray::number(service_.port()));
        device_ = makeHaply("haply:049D", benchProfile()).value();
    }
    ~HaplyRig() override { device_.reset(); }
    std::optional<Vec3> pushed() const override {
        return Vec3(service_.motors[0], service_.motors[2], -service_.motors[1]);
    }
    bool pull() override {
        service_.present = false;
        return true;
    }
    void plug() override { service_.present = true; }

private:
    FakeHaply service_;
};

/// Of a device in a process of its own the bench sees the force along z.
class RemoteRig final : public DeviceRig {
public:
    RemoteRig() {
        const QByteArray file = dir_.filePath("served").toLocal8Bit();
        served_ = new (mapServed(file.constData())) Served;
        device_ = makeRemoteDevice(TACTUM_REMOTE_PROGRAM, {"serve", file.toStdString(), ""}).value();
    }
    std::optional<Vec3> pushed() const override { return Vec3(0, 0, served_->push); }

private:
    QTemporaryDir dir_;
    Served* served_ = nullptr;
};

template <class Which> std::unique_ptr<Rig> make() {
    return std::make_unique<Which>();
}

const std::map<std::string, std::function<std::unique_ptr<Rig>()>> kRigs{
    {"simulated hand", make<SimulatedRig>},
    {"recorded hand", make<RecordedRig>},
    {"Falcon", make<FalconRig>},
    {"WoodenHaptics", make<WoodenRig>},
    {"OpenHaptics", make<OpenHapticsRig>},
    {"Force Dimension", make<ForceDimensionRig>},
    {"Haply", make<HaplyRig>},
    {"Polhem, places", make<PolhemRig<FakePolhem::Firmware::Of2020>>},
    {"Polhem, counts", make<PolhemRig<FakePolhem::Firmware::Of2023>>},
    {"2DIY, by a plug-in", make<PluginRig<Fake2diy>>},
    {"Hapkit, by a plug-in", make<PluginRig<FakeHapkit>>},
    {"in another process", make<RemoteRig>},
};

} // namespace

DeviceSample Rig::exchange(const Vec3& force) {
    const DeviceSample sample = device().exchange({force}, 1e-3);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return sample;
}

const std::vector<std::string>& rigNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& [name, maker] : kRigs)
            all.push_back(name);
        return all;
    }();
    return names;
}

std::unique_ptr<Rig> makeRig(const std::string& name) {
    return kRigs.at(name)();
}

} // namespace tactum::test
