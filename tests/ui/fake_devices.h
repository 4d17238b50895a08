// A catalogue whose devices are plugged in, made ready and fail as the test wants it.
#pragma once

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/port/device_catalogue.h"
#include "core/port/hand_target.h"
#include "device/simulated_hand.h"

namespace tactum {

/// What a test and a fake device share.
struct FakeDesk {
    std::string name = "Example arm";
    std::atomic<bool> plugged{true};
    std::atomic<int> go{0};      ///< steps that prepare() may end
    std::atomic<int> failAt{-1}; ///< the step that fails
    std::atomic<bool> failOpen{false};
    std::atomic<bool> stubborn{false}; ///< it goes on although it was given up
    std::atomic<bool> broken{false};   ///< its driver: only preparing it anew helps
    std::atomic<int> made{0};          ///< devices that exist
    std::atomic<int> prepared{0};      ///< times that it was prepared to the end
    std::atomic<bool> preparing{false};
    std::atomic<int> halves{0}; ///< steps that told that half of them is done
    std::atomic<std::uint32_t> buttons{0};
    std::atomic<double> x{0}, y{0}, z{0}; ///< where the handle is held, frame D, m
    std::atomic<double> force{0};         ///< N, of the last command
    std::atomic<double> strongest{0};     ///< N, of all of them

    void place(double px, double py, double pz) {
        x = px;
        y = py;
        z = pz;
    }
};

/// Three steps, the second of which wants the person's hand; its handle is where the test holds it.
class FakeDevice final : public HapticDevice {
public:
    explicit FakeDevice(std::shared_ptr<FakeDesk> desk) : desk_(std::move(desk)) { ++desk_->made; }
    ~FakeDevice() override { --desk_->made; }

    DeviceInfo info() const override {
        return {.name = desk_->name,
                .maxForce = 6,
                .continuousForce = 2,
                .workspaceRadius = 0.05,
                .rate = 1000,
                .damping = 4,
                .buttons = 3,
                .tripSpeed = 100};
    }
    std::vector<std::string> steps() const override { return {"Load the firmware", "Find home", "Rest"}; }
    Result<void> prepare(Opening& opening) override {
        desk_->preparing = true;
        const auto result = goThrough(opening);
        desk_->preparing = false;
        return result;
    }
    Result<void> open() override {
        if (desk_->failOpen) return machineError("The arm did not wake: switch it off and on.");
        return {};
    }
    void close() override { desk_->force = 0; }
    std::string trouble() const override {
        return desk_->broken ? "The driver crashed." : desk_->plugged ? "" : "The arm does not answer.";
    }
    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        desk_->force = command.force.norm();
        desk_->strongest = std::max<double>(desk_->strongest, desk_->force);
        return {.position = {desk_->x, desk_->y, desk_->z},
                .buttons = desk_->buttons,
                .valid = desk_->plugged && !desk_->broken};
    }

private:
    Result<void> goThrough(Opening& opening) {
        const auto names = steps();
        for (int i = 0; i < int(names.size()); ++i) {
            opening.begin(names[std::size_t(i)], i == 1 ? "Push the grip in and out." : "");
            opening.progress(0.5);
            ++desk_->halves;
            while (desk_->go <= i) {
                if (opening.cancelled() && !desk_->stubborn) return machineError("It was given up.");
                if (desk_->failAt == i)
                    return machineError("The grip did not move: pull it all the way out.");
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }
        ++desk_->prepared;
        desk_->broken = false;
        return {};
    }

    std::shared_ptr<FakeDesk> desk_;
};

class FakeCatalogue final : public DeviceCatalogue {
public:
    FakeCatalogue(std::shared_ptr<FakeDesk> desk, std::shared_ptr<HandTarget> theHand)
        : hand(std::move(theHand)), desk_(std::move(desk)) {}

    std::vector<DeviceListing> list() override {
        std::vector<DeviceListing> found{
            {"simulated", "Simulated hand", true, "The mouse moves it in the window."}};
        if (desk_->plugged && !hidden)
            found.push_back({.id = "fake:1-2",
                             .name = "Example arm",
                             .usable = true,
                             .sentence = "At USB 1-2; 6 N, three buttons.",
                             .lacks = lacking ? "firmware (*.bin)" : ""});
        if (other && (!otherDesk || otherDesk->plugged))
            found.push_back({"fake:1-4", "Other arm", true, "At USB 1-4."});
        if (locked)
            found.push_back({"locked:1-3", "Locked arm", false,
                             "At USB 1-3; you have no permission to use it: install the udev rule.", true});
        ++lists;
        return found;
    }
    Result<std::unique_ptr<HapticDevice>> make(const std::string& id) override {
        if (id == "simulated") return std::make_unique<SimulatedHand>(hand);
        if (id == "fake:1-4" && otherDesk && otherDesk->plugged)
            return std::make_unique<FakeDevice>(otherDesk);
        if (id.starts_with("fake:") && desk_->plugged) return std::make_unique<FakeDevice>(desk_);
        return inputError("There is no such device: plug it in.");
    }

    Result<std::string> supply(const std::string&, const std::filesystem::path& file) override {
        if (file.extension() != ".bin") return inputError("The file is no firmware.");
        lacking = false;
        return "The firmware " + file.string() + " is kept.";
    }

    Result<std::string> keepFigures(const std::string& name, const std::string& profile) override {
        keptFigures = profile;
        return "The figures of " + name + " are kept.";
    }

    std::shared_ptr<HandTarget> hand; ///< of the simulated one
    std::string keptFigures;          ///< the profile that was kept last
    std::atomic<bool> locked{false};
    std::atomic<bool> hidden{false};     ///< there, but not listed
    std::atomic<bool> other{false};      ///< a second one of the kind is listed
    std::shared_ptr<FakeDesk> otherDesk; ///< where that one is a device of its own; before the window looks
    std::atomic<bool> lacking{false};    ///< the arm has no firmware
    std::atomic<int> lists{0};

private:
    std::shared_ptr<FakeDesk> desk_;
};

} // namespace tactum
