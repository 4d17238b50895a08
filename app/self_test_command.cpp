#include <ctime>
#include <iostream>

#include "app/commands.h"
#include "core/base/atomic_file.h"
#include "core/base/numbers.h"
#include "core/port/device_check.h"
#include "device/profile.h"
#include "device/registry.h"
#include "device/self_test/device_bench.h"
#include "device/self_test/self_test.h"

namespace tactum {
namespace {

/// The person at the terminal: Enter is done, s leaves out, q or the end of the input ends.
class AtTerminal final : public TrialPerson, public Opening {
public:
    bool does(TrialAsk, const std::string& words) override {
        std::cout << words << "\n  [Enter: done, s: leave this out, q: end] " << std::flush;
        return answer().empty() && !leaves_;
    }
    bool leaves() const override { return leaves_; }
    std::optional<double> mass() override {
        std::cout
            << "The mass of what you can hang on the handle by a thread, some coins for instance, in grams "
               "(better 50 than 10)\n  [s: leave this out, q: end] "
            << std::flush;
        const auto grams = parseNumber(answer());
        return grams ? std::optional(1e-3 * *grams) : std::nullopt;
    }
    void hears(const std::string& words) override { std::cout << words << std::endl; }

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

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&now));
    return text;
}

Result<void> write(const SelfTestReport& report, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return machineError(folder.string() + ": cannot be made (" + error.message() + "); name another");
    const std::string date = today();
    for (const auto& [name, text] :
         {std::pair("profile.json", profileOfReport(report, date)),
          std::pair("report.html", htmlOfReport(report, date)), std::pair("ticks.csv", csvOfReport(report))})
        if (auto written = writeFileAtomically(folder / name, text); !written) return written;
    return {};
}

void say(const SelfTestReport& report, const std::filesystem::path& folder) {
    for (const std::string& fault : report.faults)
        std::cout << "wrong: " << fault << '\n';
    if (report.faults.empty()) std::cout << "Nothing wrong was found.\n";
    for (const std::string& what : report.leftOut)
        std::cout << "left out: " << what << '\n';
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
    if (const auto written = write(*report, options.out); !written) return tl::unexpected(written.error());
    say(*report, options.out);
    return report->faults.empty() ? 0 : 1;
}

} // namespace tactum
