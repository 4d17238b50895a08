#include "core/surface/texture_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/realtime.h"

namespace tactum {
namespace {

/// The texels that one texel of the next level covers, and how much of each: begin, count, weights that sum
/// to 1. Halving with rounding up makes it three at most.
struct Cover {
    int begin = 0, count = 0;
    std::array<double, 3> weight{};
};

std::vector<Cover> coversOf(int fine, int coarse) {
    std::vector<Cover> covers;
    const double span = double(fine) / coarse;
    for (int i = 0; i < coarse; ++i) {
        const double from = i * span, to = i + 1 == coarse ? fine : (i + 1) * span;
        Cover cover{int(from), 0, {}};
        for (int x = cover.begin; x < fine && x < to && cover.count < 3; ++x)
            cover.weight[std::size_t(cover.count++)] =
                (std::min(to, x + 1.0) - std::max(from, double(x))) / (to - from);
        covers.push_back(cover);
    }
    return covers;
}

std::size_t texelsWithLevels(int width, int height) {
    std::size_t count = std::size_t(width) * std::size_t(height);
    while (width > 1 || height > 1) {
        width = (width + 1) / 2, height = (height + 1) / 2;
        count += std::size_t(width) * std::size_t(height);
    }
    return count;
}

} // namespace

TextureImage::TextureImage(int width, int height, std::vector<std::uint16_t> texels, std::string name,
                           int bits)
    : name_(std::move(name)), bits_(bits), texels_(std::move(texels)) {
    assertNotRealtime();
    assert(width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide);
    assert(texels_.size() == std::size_t(width) * std::size_t(height));
    texels_.reserve(texelsWithLevels(width, height));
    levels_[0] = {width, height, 0};
    levelCount_ = 1;
    while (levels_[std::size_t(levelCount_ - 1)].width > 1 ||
           levels_[std::size_t(levelCount_ - 1)].height > 1)
        addLevel(levels_[std::size_t(levelCount_ - 1)]);
}

void TextureImage::addLevel(const Level& finer) {
    const Level next{(finer.width + 1) / 2, (finer.height + 1) / 2, texels_.size()};
    const std::vector<Cover> columns = coversOf(finer.width, next.width),
                             rows = coversOf(finer.height, next.height);
    for (const Cover& row : rows)
        for (const Cover& column : columns) {
            double mean = 0;
            for (int y = 0; y < row.count; ++y)
                for (int x = 0; x < column.count; ++x)
                    mean += row.weight[std::size_t(y)] * column.weight[std::size_t(x)] *
                            texel(finer, column.begin + x, row.begin + y);
            texels_.push_back(std::uint16_t(std::lround(65535 * std::clamp(mean, 0.0, 1.0))));
        }
    levels_[std::size_t(levelCount_++)] = next;
}

} // namespace tactum
