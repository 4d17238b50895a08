// The program's own devices with something put in that a maker, or a driver, got wrong.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "device/registry.h"
#include "tests/device/falcon/wrong_falcon.h"

namespace tactum {

class WrongCatalogue final : public DeviceCatalogue {
public:
    WrongCatalogue(RegistrySettings settings, const test::Wrong& wrong)
        : registry_(std::move(settings)), wrong_(wrong) {}

    std::vector<DeviceListing> list() override { return registry_.list(); }
    Result<std::unique_ptr<HapticDevice>> make(const std::string& id) override {
        auto made = registry_.make(id);
        if (!made || !id.starts_with("falcon:")) return made;
        return std::make_unique<test::WrongDevice>(std::move(*made), wrong_);
    }
    Result<std::string> supply(const std::string& id, const std::filesystem::path& file) override {
        return registry_.supply(id, file);
    }
    Result<std::string> keepFigures(const std::string& name, const std::string& profile) override {
        return registry_.keepFigures(name, profile);
    }

private:
    DeviceRegistry registry_;
    test::Wrong wrong_;
};

} // namespace tactum
