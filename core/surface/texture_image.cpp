#include "core/surface/texture_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/base/realtime.h"

namespace tactum {
namespace {

constexpr int kLobes = 3;

double lanczos(double x) {
    if (std::abs(x) < 1e-9) return 1;
    if (std::abs(x) >= kLobes) return 0;
    const double angle = std::numbers::pi * x;
    return kLobes * std::sin(angle) * std::sin(angle / kLobes) / (angle * angle);
}

/// What one texel of the next level is made of: texels in a row, which repeats, by Lanczos' kernel of three
/// lobes. Its zeros lie a texel of the next level apart, so that it keeps waves from three of those on and
/// nothing below two, which the level would show as others. Source: Duchon, J. Appl. Meteorology 18 (1979).
struct Cover {
    Cover(int which, int fine, int coarse) {
        const double ratio = double(fine) / coarse, centre = (which + 0.5) * ratio, reach = kLobes * ratio;
        begin = int(std::floor(centre - reach));
        double sum = 0;
        for (int x = begin; x < centre + reach; ++x) {
            weights.push_back(lanczos((x + 0.5 - centre) / ratio));
            sum += weights.back();
        }
        for (double& weight : weights)
            weight /= sum;
    }
    int end() const { return begin + int(weights.size()); }

    int begin = 0;
    std::vector<double> weights;
};

/// The texels of the next level that any of `count` from `begin` on counts for.
std::pair<int, int> above(int begin, int count, int fine, int coarse) {
    const double ratio = double(fine) / coarse;
    const int first = int(std::floor(begin / ratio - kLobes - 1)),
              last = int(std::ceil((begin + count) / ratio + kLobes + 1));
    return last - first >= coarse ? std::pair(0, coarse) : std::pair(first, last - first);
}

int repeated(int i, int size) {
    const int rest = i % size;
    return rest < 0 ? rest + size : rest;
}

/// Adds weight x row[begin ...] to the sums; the row repeats.
template <class Texel>
void addRepeated(std::span<double> sums, double weight, const Texel* row, int begin, int width) {
    std::size_t done = 0;
    for (int at = repeated(begin, width); done < sums.size(); at = 0) {
        const std::size_t count = std::min(sums.size() - done, std::size_t(width - at));
        for (std::size_t i = 0; i < count; ++i)
            sums[done + i] += weight * double(row[std::size_t(at) + i]);
        done += count;
    }
}

std::size_t texelsAbove(int width, int height) {
    std::size_t count = 0;
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
    coarser_.reserve(texelsAbove(width, height));
    levels_[0] = {width, height};
    levelCount_ = 1;
    while (levels_[std::size_t(levelCount_ - 1)].width > 1 ||
           levels_[std::size_t(levelCount_ - 1)].height > 1)
        addLevel(levels_[std::size_t(levelCount_ - 1)]);
}

void TextureImage::addLevel(const Level& finer) {
    const Level next{(finer.width + 1) / 2, (finer.height + 1) / 2, coarser_.size(), false};
    coarser_.resize(next.begin + std::size_t(next.width) * std::size_t(next.height));
    levels_[std::size_t(levelCount_++)] = next;
    fill(levelCount_ - 1, {0, 0, next.width, next.height});
}

/// A part of a level from the one below it, first down the columns and then along the rows.
void TextureImage::fill(int which, const Region& region) {
    const Level &from = level(which - 1), &to = level(which);
    std::vector<Cover> along;
    for (int x = region.x; x < region.x + region.width; ++x)
        along.emplace_back(x, from.width, to.width);
    const int begin = along.front().begin;
    std::vector<double> sums(std::size_t(along.back().end() - begin));
    for (int y = region.y; y < region.y + region.height; ++y) {
        const Cover down(y, from.height, to.height);
        std::ranges::fill(sums, 0.0);
        for (std::size_t k = 0; k < down.weights.size(); ++k)
            visitRow(from, repeated(down.begin + int(k), from.height),
                     [&](const auto* row) { addRepeated(sums, down.weights[k], row, begin, from.width); });
        float* texels =
            coarser_.data() + to.begin + std::size_t(repeated(y, to.height)) * std::size_t(to.width);
        for (std::size_t i = 0; i < along.size(); ++i) {
            const double* first = sums.data() + (along[i].begin - begin);
            texels[repeated(region.x + int(i), to.width)] =
                float(std::inner_product(along[i].weights.begin(), along[i].weights.end(), first, 0.0));
        }
    }
}

/// The texels of the next level that show some of each region, which becomes theirs.
void TextureImage::fillAbove(int finer, std::span<Region> regions) {
    const Level &from = level(finer), &to = level(finer + 1);
    for (Region& region : regions) {
        std::tie(region.x, region.width) = above(region.x, region.width, from.width, to.width);
        std::tie(region.y, region.height) = above(region.y, region.height, from.height, to.height);
        fill(finer + 1, region);
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
