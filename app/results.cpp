#include "app/results.h"

#include <fstream>

#include "core/base/numbers.h"

namespace tactum {

namespace {

void appendVector(std::string& out, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
        out += ',';
        appendNumber(out, v[axis]);
    }
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

Result<void> writeFile(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out.write(text.data(), std::streamsize(text.size()));
    out.close();
    if (!out)
        return machineError(file.string() +
                            ": cannot be written; check the folder, its permissions and the free space");
    return {};
}

} // namespace tactum
