#include "core/files/mesh/read_mtl.h"

#include <array>
#include <cmath>

#include "core/base/text.h"

namespace tactum {
namespace {

std::optional<Eigen::Vector3f> readColour(Fields fields) {
    Eigen::Vector3d colour;
    for (int i = 0; i < 3; ++i)
        if (!parseNumber(fields.next(), colour[i])) return std::nullopt;
    if (!colour.allFinite()) return std::nullopt;
    return colour.cwiseMax(0).cwiseMin(1).cast<float>();
}

/// Options of a picture with this many words after them. The three that place it take one to three numbers.
struct MapOption {
    std::string_view word;
    int arguments;
};
constexpr std::array<MapOption, 8> kMapOptions{{{"-blendu", 1},
                                                {"-blendv", 1},
                                                {"-cc", 1},
                                                {"-clamp", 1},
                                                {"-imfchan", 1},
                                                {"-mm", 2},
                                                {"-texres", 1},
                                                {"-type", 1}}};

void skipOption(std::string_view word, Fields& fields) {
    for (const MapOption& option : kMapOptions)
        for (int i = 0; option.word == word && i < option.arguments; ++i)
            fields.next();
}

/// The numbers of -s, -o or -t; whether one of them says something else than nothing.
bool readPlacement(Fields& fields, double nothing) {
    bool says = false;
    for (int i = 0; i < 3; ++i) {
        Fields ahead = fields;
        double value = 0;
        if (!parseNumber(ahead.next(), value)) break;
        says = says || value != nothing;
        fields = ahead;
    }
    return says;
}

/// The number of -bm; 1, and a finding, where there is none.
double readMultiplier(Fields& fields, const std::string& where, std::vector<Finding>& findings) {
    const std::string_view field = fields.next();
    double multiplier = 0;
    if (parseNumber(field, multiplier) && std::isfinite(multiplier)) return multiplier;
    findings.push_back({Finding::Severity::Warning, "",
                        where + ": -bm " + inQuotes(field) + " is not a number",
                        "taken as 1; write a number there"});
    return 1;
}

std::optional<MtlBump> readBump(Fields fields, std::string where, std::vector<Finding>& findings) {
    MtlBump bump;
    bump.where = std::move(where);
    while (fields.rest().starts_with('-')) {
        const std::string_view word = fields.next();
        if (word == "-bm")
            bump.multiplier = readMultiplier(fields, bump.where, findings);
        else if (word == "-s" || word == "-o" || word == "-t")
            bump.placed = readPlacement(fields, word == "-s" ? 1 : 0) || bump.placed;
        else
            skipOption(word, fields);
    }
    bump.file = fields.rest(); // names may have blanks
    if (!bump.file.empty()) return bump;
    findings.push_back({Finding::Severity::Warning, "", bump.where + ": bump map names no picture",
                        "left out; write the name of one there"});
    return std::nullopt;
}

} // namespace

void readMaterials(const std::filesystem::path& file, MtlMaterials& materials,
                   std::vector<Finding>& findings) {
    constexpr std::uint64_t kLargest = 16 << 20;
    const Source source = Source::open(file, kLargest);
    std::string material;
    Lines lines(source.bytes(), true);
    for (std::string_view line; lines.next(line);) {
        Fields fields(line);
        const std::string word = lowerCase(std::string(fields.next()));
        if (word == "newmtl") material = fields.rest();
        if (word == "kd")
            if (const auto colour = readColour(fields)) materials[material].colour = colour;
        if (word == "bump" || word == "map_bump")
            if (auto bump = readBump(fields, source.name() + ":" + std::to_string(lines.number()), findings))
                materials[material].bump = std::move(bump);
    }
}

} // namespace tactum
