#include "core/bundle/forces_csv.h"

#include <array>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/files/read_finger_path.h"

namespace tactum {
namespace {

constexpr std::string_view kHeader = "t_s,finger_x_m,finger_y_m,finger_z_m,proxy_x_m,proxy_y_m,proxy_z_m,"
                                     "force_x_N,force_y_N,force_z_N";
constexpr std::size_t kColumns = 10;

void append(std::string& out, const Vec3& v) {
    for (const double number : {v.x(), v.y(), v.z()}) {
        out += ',';
        appendNumber(out, number);
    }
}

/// Whether the line is as many finite numbers as there are columns.
bool readRow(std::string_view line, std::array<double, kColumns>& numbers) {
    for (double& number : numbers) {
        const std::size_t comma = line.find(',');
        if (!parseNumber(trimmed(line.substr(0, comma)), number) || !std::isfinite(number)) return false;
        line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
    }
    return line.empty();
}

Result<FeltTable> readForcesAlone(std::string_view text, const std::filesystem::path& where) {
    const auto forces = readFingerPath(text, where);
    if (!forces) return tl::unexpected<Error>(forces.error());
    FeltTable table;
    table.whole = false;
    for (const FingerPoint& force : *forces)
        table.rows.push_back({force.t, Vec3::Zero(), Vec3::Zero(), force.position});
    return table;
}

} // namespace

std::string forcesCsv(const TouchTrace& rows) {
    std::string out(kHeader);
    out += '\n';
    out.reserve(rows.size() * 200);
    for (const TouchRow& row : rows) {
        appendNumber(out, row.t);
        append(out, row.finger);
        append(out, row.proxy);
        append(out, row.force);
        out += '\n';
    }
    return out;
}

Result<FeltTable> readForces(std::string_view text, const std::filesystem::path& where) {
    Lines lines(text);
    std::string_view line;
    if (!lines.next(line) || trimmed(line) != kHeader) return readForcesAlone(text, where);
    FeltTable table;
    while (lines.next(line)) {
        std::array<double, kColumns> n{};
        if (!readRow(line, n))
            return inputError(where.string() + ": line " + std::to_string(lines.number()) + ": is not " +
                              std::to_string(kColumns) +
                              " finite numbers with commas between them; export the bundle again");
        table.rows.push_back({n[0], {n[1], n[2], n[3]}, {n[4], n[5], n[6]}, {n[7], n[8], n[9]}});
    }
    return table;
}

} // namespace tactum
