#include <iostream>
#include <iterator>

#include "app/commands.h"
#include "core/base/numbers.h"
#include "core/port/device_check.h"
#include "core/self_test/device_bench.h"
#include "core/self_test/self_test.h"
#include "device/profile.h"
#include "device/registry.h"

namespace tactum {
namespace {

/// The person at the terminal: Enter is done, s leaves out, q or the end of the input ends.
class AtTerminal final : public TrialPerson, public Opening {
public:
    void begins(TrialPart part) override {
        std::cout << "\nPart " << int(part) + 1 << " of " << std::size(kTrialParts) << ": "
                  << kTrialParts[std::size_t(part)] << std::endl;
    }
    bool does(TrialAsk, const TrialWords& words) override {
        std::cout << words.english() << "\n  [Enter: done, s: leave this out, q: end] " << std::flush;
        return answer().empty() && !leaves_;
    }
    bool leaves() const override { return leaves_; }
    std::optional<double> mass(double heaviest) override {
        std::cout
            << "The mass of what you can hang on the handle by a thread, some coins for instance, in grams "
               "(better 50 than 10, at most "
            << int(1e3 * heaviest) << ")\n  [s: leave this out, q: end] " << std::flush;
        const auto grams = parseNumber(answer());
        return grams ? std::optional(1e-3 * *grams) : std::nullopt;
    }
    void hears(const TrialWords& words) override { std::cout << words.english() << std::endl; }

    // While the device is made ready.
    void begin(std::string_view step, std::string_view request) override {
        std::cout << step << (request.empty() ? "" : ": ") << request << std::endl;
    }
    void progress(double) override {}
    bool cancelled() const override { return false; }

private:
    std::string answer() {
        std::string line;
        if (!std::getline(std::cin, line)) leaves_ = true;
        if (line == "q") leaves_ = true;
        return line;
    }

    bool leaves_ = false;
};

void say(const SelfTestReport& report, const std::filesystem::path& folder) {
    for (const TrialWords& fault : report.faults)
        std::cout << "wrong: " << fault.english() << '\n';
    if (report.faults.empty()) std::cout << "Nothing wrong was found.\n";
    for (const TrialWords& what : report.leftOut)
        std::cout << "left out: " << what.english() << '\n';
    std::cout << "Written: profile.json, report.html and ticks.csv in " << folder.string() << '\n';
    if (const std::string key = profileFor(report.device.name); !key.empty())
        std::cout << "To use what was measured, copy profile.json to "
                  << (personsProfiles() / (key + ".json")).string() << '\n';
}

Result<SelfTestReport> test(HapticDevice& device, AtTerminal& person) {
    DeviceBench bench(device);
    if (const auto started = bench.start(); !started) return tl::unexpected(started.error());
    return selfTest(bench, person, device.info());
}

} // namespace

Result<int> runSelfTest(const SelfTestOptions& options) {
    std::error_code unknown; // then the makers' libraries run here
    DeviceRegistry registry({.hand = {},
                             .profiles = personsProfiles(),
                             .program = std::filesystem::read_symlink("/proc/self/exe", unknown)});
    const auto device = registry.make(options.device);
    if (!device) return tl::unexpected(device.error());
    if (!(*device)->info().real)
        return inputError(options.device + " is no device that pushes a hand: there is nothing to measure.");
    AtTerminal person;
    if (const auto ready = (*device)->prepare(person); !ready) return tl::unexpected(ready.error());
    if (const auto open = (*device)->open(); !open) return tl::unexpected(open.error());
    auto report = checkDevice((*device)->info()).and_then([&] { return test(**device, person); });
    (*device)->close();
    if (!report) return tl::unexpected(report.error());
    if (const auto written = writeSelfTest(*report, selfTestDate(), options.out); !written)
        return tl::unexpected(written.error());
    say(*report, options.out);
    return report->faults.empty() ? 0 : 1;
}

} // namespace tactum
