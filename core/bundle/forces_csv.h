// What a finger must feel along its path, as the table of a bundle that says its units itself.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/haptics/replay.h"

namespace tactum {

/// World frame, SI.
struct FeltRow {
    double t = 0;
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< before any device's limit
};

struct FeltTable {
    std::vector<FeltRow> rows;
    bool whole = true; ///< false: a bundle of version 1.0, which has the forces alone
};

/// Full double precision; reads back as the same bits.
std::string forcesCsv(const TouchTrace& rows);
/// The table of a bundle, also that of version 1.0. Errors: one line with `where`, the line and the column.
Result<FeltTable> readForces(std::string_view text, const std::filesystem::path& where);

} // namespace tactum
