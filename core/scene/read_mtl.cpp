#include "core/scene/read_mtl.h"

#include "core/scene/text.h"

namespace tactum {

void readMaterialColours(const std::filesystem::path& file, MaterialColours& colours) {
    constexpr std::uint64_t kLargest = 16 << 20;
    const Source source = Source::open(file, kLargest);
    std::string material;
    Lines lines(source.bytes(), true);
    for (std::string_view line; lines.next(line);) {
        Fields fields(line);
        const std::string_view word = fields.next();
        if (word == "newmtl") material = fields.rest();
        if (word != "Kd") continue;
        Eigen::Vector3d colour;
        bool usable = true;
        for (int i = 0; i < 3; ++i)
            usable = usable && parseNumber(fields.next(), colour[i]);
        if (usable && colour.allFinite()) colours[material] = colour.cwiseMax(0).cwiseMin(1).cast<float>();
    }
}

} // namespace tactum
