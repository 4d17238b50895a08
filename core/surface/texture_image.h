// A texture's image: one channel, linear, with its mip levels. Built once, then only read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/vec.h"

namespace tactum {

/// Texels from 0 (0) to 65535 (1), whatever depth the file had: 8 bits v are 257 v, which is exact. Row 0
/// lies at v = 0, the lower edge of the picture, and the image repeats in both directions. A level is half as
/// wide and high as the one before, rounded up, so that no size needs to be a power of two; it holds what of
/// that one is longer than two of its own texels, which beside hard edges goes beyond black and white: so its
/// texels are floats and nothing is cut, or each level of a sparse picture would be brighter than the one
/// before. Shared through a shared_ptr to const.
class TextureImage {
public:
    static constexpr int kMaxLevels = 16;
    static constexpr int kLargestSide = 1 << 14; ///< texels
    static constexpr std::size_t kMaxTexels = std::size_t(1) << 27;

    struct Level {
        int width = 0, height = 0;
        std::size_t begin = 0; ///< of its first texel among those of its kind
        bool finest = true;    ///< whole numbers, as they were read
    };

    /// `texels`: width x height of them, row by row; sides from 1 to kLargestSide, at most kMaxTexels.
    /// `name`: for the person. `bits`: the depth that the file had. Thread: any but real time.
    TextureImage(int width, int height, std::vector<std::uint16_t> texels, std::string name = {},
                 int bits = 16);

    /// A rectangle of the finest level, inside the image.
    struct Region {
        int x = 0, y = 0, width = 0, height = 0;
    };
    /// This image with other texels in these regions, and of 16 bits: the same as one built of them, for the
    /// cost of a copy and of what lies above the regions in the levels. `texels`: of the whole finest level,
    /// of which nothing but the regions is read. Thread: any but real time.
    std::shared_ptr<const TextureImage> withRegions(std::span<const Region> regions,
                                                    std::span<const std::uint16_t> texels) const;

    int width() const noexcept { return levels_[0].width; }
    int height() const noexcept { return levels_[0].height; }
    int bits() const noexcept { return bits_; }
    const std::string& name() const noexcept { return name_; }
    int levelCount() const noexcept { return levelCount_; }
    const Level& level(int i) const noexcept { return levels_[std::size_t(i)]; }
    /// The texels of a row of the finest level, from 0 to 65535. Thread: real time.
    const std::uint16_t* row(int y) const noexcept {
        return texels_.data() + std::size_t(y) * std::size_t(width());
    }
    /// visit(texels) for those of any level's row, whole numbers or floats, 65535 for white. Thread: real
    /// time.
    template <class Visit> auto visitRow(const Level& at, int y, Visit&& visit) const noexcept {
        if (at.finest) return visit(row(y));
        return visit(coarser_.data() + at.begin + std::size_t(y) * std::size_t(at.width));
    }
    /// From 0 to 1, and a little beyond in a coarser level. Thread: real time.
    double texel(const Level& at, int x, int y) const noexcept {
        return visitRow(at, y, [x](const auto* row) { return double(row[x]); }) / 65535.0;
    }

private:
    void addLevel(const Level& finer);
    void fill(int which, const Region& region);
    void fillAbove(int finer, std::span<Region> regions);

    std::string name_;
    int bits_ = 16;
    int levelCount_ = 0;
    std::array<Level, kMaxLevels> levels_{};
    std::vector<std::uint16_t> texels_; ///< of the finest level
    std::vector<float> coarser_;        ///< of all others, one after the other
};

} // namespace tactum
