// Devices of boards that are asked over a serial port, with their boards behind pseudo-terminals.
#pragma once

#include <type_traits>

#include <QByteArray>

#include "device/plugin/plugin.h"
#include "device/polhem/polhem.h"
#include "tests/device/contract/rigs.h"
#include "tests/device/plugin/fake_2diy.h"
#include "tests/device/plugin/fake_hapkit.h"
#include "tests/device/polhem/fake_polhem.h"

namespace tactum::test {

inline DeviceInfo benchProfile() {
    return {.name = "On the bench", .maxForce = 4, .workspaceRadius = 0.05, .buttons = 1};
}
class DeviceRig : public Rig {
public:
    HapticDevice& device() override { return *device_; }
    void destroyDevice() override { device_.reset(); }

protected:
    std::unique_ptr<HapticDevice> device_;
};

/// With a board behind a pseudo-terminal.
template <class Board> class BoardRig : public DeviceRig {
public:
    ~BoardRig() override { device_.reset(); }
    std::optional<Vec3> pushed() const override { return board_.pushed(); }
    bool pull() override {
        board_.unplug();
        return true;
    }
    void plug() override { board_.plug(); }

protected:
    explicit BoardRig(auto... how) : board_(how...) {}
    Board board_;
};

template <FakePolhem::Firmware firmware> class PolhemRig final : public BoardRig<FakePolhem> {
public:
    PolhemRig() : BoardRig(firmware) { device_ = makePolhem(listPolhem().at(0).id, benchProfile()).value(); }
    /// A motor's current is a whole number of milliamperes, and lifts the arm but for a few millinewtons.
    std::optional<Vec3> pushed() const override {
        const Vec3 force = board_.pushed();
        return force.norm() < 0.02 ? Vec3(Vec3::Zero()) : force;
    }
};

/// A driver of other people's: the examples, whose arms lie in a plane, and which is a lever.
template <class Board> class PluginRig final : public BoardRig<Board> {
    static constexpr bool kLever = std::is_same_v<Board, FakeHapkit>;

public:
    PluginRig() {
        qputenv("TACTUM_DRIVERS", kLever ? TACTUM_FOLDER_OF_HAPKIT : TACTUM_DRIVERS_OF_THE_BENCH);
        this->device_ = makePlugin(listPlugins().at(0).id).value();
    }
    bool pushesAlong(int axis) const override { return kLever ? axis == 0 : axis != 1; }
};

} // namespace tactum::test
