#include "resources/make_samples/height_image.h"

#include <algorithm>
#include <cmath>

namespace tactum::samples {

std::shared_ptr<const TextureImage> heightImage(std::string name, int width, int height,
                                                const std::function<double(double u, double v)>& value) {
    // 4096 steps are finer than any device feels, and pack to half the size of 65536.
    constexpr double kSteps = 4095, kStep = 65535 / kSteps;
    std::vector<std::uint16_t> texels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double h = std::clamp(value((x + 0.5) / width, (y + 0.5) / height), 0.0, 1.0);
            texels.push_back(std::uint16_t(std::lround(std::round(h * kSteps) * kStep)));
        }
    return std::make_shared<const TextureImage>(width, height, std::move(texels), std::move(name));
}

} // namespace tactum::samples
