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

std::uint16_t meanOf(const TextureImage& image, const TextureImage::Level& finer, const Cover& column,
                     const Cover& row) {
    double mean = 0;
    for (int y = 0; y < row.count; ++y)
        for (int x = 0; x < column.count; ++x)
            mean += row.weight[std::size_t(y)] * column.weight[std::size_t(x)] *
                    image.texel(finer, column.begin + x, row.begin + y);
    return std::uint16_t(std::lround(65535 * std::clamp(mean, 0.0, 1.0)));
}

/// Narrows a range of fine texels to that of the coarse ones which cover any of them.
void coarsen(const std::vector<Cover>& covers, int& begin, int& count) {
    const int end = begin + count;
    int first = 0, last = int(covers.size());
    while (covers[std::size_t(first)].begin + covers[std::size_t(first)].count <= begin)
        ++first;
    while (covers[std::size_t(last - 1)].begin >= end)
        --last;
    begin = first, count = last - first;
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
        for (const Cover& column : columns)
            texels_.push_back(meanOf(*this, finer, column, row));
    levels_[std::size_t(levelCount_++)] = next;
}

/// The texels of the next level that cover some of each region, which becomes theirs.
void TextureImage::fillAbove(int finer, std::span<Region> regions) {
    const Level &from = level(finer), &to = level(finer + 1);
    const std::vector<Cover> columns = coversOf(from.width, to.width),
                             rows = coversOf(from.height, to.height);
    for (Region& region : regions) {
        coarsen(columns, region.x, region.width);
        coarsen(rows, region.y, region.height);
        for (int y = region.y; y < region.y + region.height; ++y)
            for (int x = region.x; x < region.x + region.width; ++x)
                texels_[to.begin + std::size_t(y) * std::size_t(to.width) + std::size_t(x)] =
                    meanOf(*this, from, columns[std::size_t(x)], rows[std::size_t(y)]);
    }
}

std::shared_ptr<const TextureImage> TextureImage::withRegions(std::span<const Region> regions,
                                                              std::span<const std::uint16_t> texels) const {
    assertNotRealtime();
    assert(texels.size() == std::size_t(width()) * std::size_t(height()));
    auto image = std::make_shared<TextureImage>(*this);
    image->bits_ = 16;
    std::vector<Region> parts;
    for (const Region& region : regions) {
        assert(region.x >= 0 && region.y >= 0 && region.x + region.width <= width() &&
               region.y + region.height <= height());
        if (region.width <= 0 || region.height <= 0) continue;
        parts.push_back(region);
        for (int y = region.y; y < region.y + region.height; ++y) {
            const std::size_t begin = std::size_t(y) * std::size_t(width()) + std::size_t(region.x);
            std::copy_n(texels.data() + begin, region.width, image->texels_.data() + begin);
        }
    }
    for (int finer = 0; finer + 1 < levelCount_; ++finer)
        image->fillAbove(finer, parts);
    return image;
}

} // namespace tactum
