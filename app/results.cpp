#include "app/results.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <map>

#include <nlohmann/json.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include "core/base/atomic_file.h"
#include "core/base/numbers.h"

namespace tactum {

namespace {

void appendVector(std::string& out, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
        out += ',';
        appendNumber(out, v[axis]);
    }
}

/// Whether it is where our output goes, by whatever name. If another file took the place of that one,
/// everything else that we say would be lost with the old one.
bool isOurOutput(const struct stat& file) {
    struct stat ours {};
    return fstat(STDOUT_FILENO, &ours) == 0 && file.st_dev == ours.st_dev && file.st_ino == ours.st_ino;
}

/// What a finding says, whatever the object and the numbers are.
std::string kindOf(const Finding& finding) {
    std::string kind =
        std::string(nameOf(finding.severity)) + (": " + finding.sentence + ";" + finding.remedy);
    const auto isOfNumber = [](unsigned char c) { return std::isdigit(c) || c == '.'; };
    std::ranges::replace_if(kind, isOfNumber, '#');
    kind.erase(std::unique(kind.begin(), kind.end(), [](char a, char b) { return a == '#' && b == '#'; }),
               kind.end());
    return kind;
}

Result<void> writeInto(std::ostream& out, const std::filesystem::path& file, const std::string& text) {
    out.write(text.data(), std::streamsize(text.size()));
    out.flush();
    if (!out)
        return machineError(file.string() +
                            ": cannot be written; check the folder, its permissions and the free space");
    return {};
}

} // namespace

std::string touchCsv(const TouchTrace& rows) {
    std::string out = "t,finger_x,finger_y,finger_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,"
                      "contacts,update_ns\n";
    out.reserve(rows.size() * 200);
    for (const TouchRow& row : rows) {
        appendNumber(out, row.t);
        appendVector(out, row.finger);
        appendVector(out, row.proxy);
        appendVector(out, row.force);
        out += ',' + std::to_string(row.contacts) + ',' + std::to_string(row.updateNs) + '\n';
    }
    return out;
}

int sayError(const Error& error) {
    std::cerr << "tactum: " << error.text << '\n';
    return int(error.kind);
}

std::vector<std::string> linesOf(const std::vector<Finding>& findings) {
    constexpr std::size_t kMany = 3;
    std::map<std::string, std::size_t> counts, said;
    for (const Finding& finding : findings)
        ++counts[kindOf(finding)];
    std::vector<std::string> lines;
    for (const Finding& finding : findings) {
        const std::string kind = kindOf(finding);
        const std::size_t count = counts[kind];
        if (said[kind]++ > 0 && count > kMany) continue;
        lines.push_back(lineOf(finding));
        if (count > kMany)
            lines.back() += " (and " + std::to_string(count - 1) + " more like it; --json has each)";
    }
    return lines;
}

nlohmann::ordered_json findingsJson(const std::vector<Finding>& findings) {
    auto json = nlohmann::ordered_json::array();
    for (const Finding& finding : findings)
        json.push_back({{"severity", std::string(nameOf(finding.severity))},
                        {"object", finding.object},
                        {"sentence", finding.sentence},
                        {"remedy", finding.remedy}});
    return json;
}

bool isDash(const std::optional<std::filesystem::path>& file) {
    return file == "-";
}

Result<void> writeFile(const std::filesystem::path& file, const std::string& text) {
    if (isDash(file)) return writeInto(std::cout, "standard output", text);
    struct stat there {};
    const bool isThere = stat(file.c_str(), &there) == 0;
    if (isThere && isOurOutput(there)) return writeInto(std::cout, file, text);
    if (!isThere || S_ISREG(there.st_mode) || S_ISDIR(there.st_mode))
        return writeFileAtomically(file, text, 0);
    std::ofstream stream(file, std::ios::binary); // a pipe, a device
    return writeInto(stream, file, text);
}

} // namespace tactum
