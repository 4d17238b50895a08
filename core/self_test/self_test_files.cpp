// What a self-test leaves behind, as files.
#include <array>
#include <ctime>

#include "core/base/atomic_file.h"
#include "core/self_test/self_test.h"

namespace tactum {

std::string selfTestDate() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::tm local{};
    localtime_r(&now, &local);
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
    return text.data();
}

Result<void> writeSelfTest(const SelfTestReport& report, const std::string& date,
                           const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return machineError(folder.string() + ": cannot be made (" + error.message() + "); name another");
    for (const auto& [name, text] :
         {std::pair("profile.json", profileOfReport(report, date)),
          std::pair("report.html", htmlOfReport(report, date)), std::pair("ticks.csv", csvOfReport(report))})
        if (auto written = writeFileAtomically(folder / name, text); !written) return written;
    return {};
}

} // namespace tactum
