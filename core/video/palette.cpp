#include "core/video/palette.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>

namespace tactum {

namespace {

constexpr int kBits = 5, kShades = 1 << (3 * kBits), kMost = (1 << kBits) - 1;

/// Bayer's order: 0 to 63, another one at each of 8 x 8 pixels.
int orderAt(int x, int y) {
    int order = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int across = (x ^ y) >> bit & 1, down = y >> bit & 1;
        order = order << 2 | across << 1 | down;
    }
    return order;
}

/// A channel of a shade: 0 red, 1 green, 2 blue.
int partOf(Shade shade, int channel) {
    return shade >> (kBits * (2 - channel)) & kMost;
}

/// 0 to 255.
int valueOf(Shade shade, int channel) {
    return (partOf(shade, channel) * 255 + kMost / 2) / kMost;
}

struct Counted {
    Shade shade = 0;
    double pixels = 0;
};

/// The pixels of some shades in one channel.
struct Sums {
    double pixels = 0, sum = 0, squares = 0;

    void add(const Counted& each, int channel) {
        const double value = partOf(each.shade, channel);
        pixels += each.pixels;
        sum += each.pixels * value;
        squares += each.pixels * value * value;
    }
    /// Of the squares of the distances from the mean.
    double spread() const { return pixels > 0 ? squares - sum * sum / pixels : 0; }
};

/// Neighbours in the list of shades.
struct Box {
    std::span<Counted> shades;
    int channel = 0;   ///< in which they differ most
    double spread = 0; ///< there

    explicit Box(std::span<Counted> of) : shades(of) {
        for (int c = 0; c < 3; ++c) {
            Sums sums;
            for (const Counted& each : shades)
                sums.add(each, c);
            if (sums.spread() > spread) {
                spread = sums.spread();
                channel = c;
            }
        }
    }

    /// Where both sides together differ least.
    std::pair<Box, Box> parted() const {
        std::ranges::sort(shades, {}, [this](const Counted& each) { return partOf(each.shade, channel); });
        Sums below, above;
        for (const Counted& each : shades)
            above.add(each, channel);
        const Sums all = above;
        std::size_t best = 1;
        double least = all.spread();
        for (std::size_t i = 1; i < shades.size(); ++i) {
            below.add(shades[i - 1], channel);
            above = {all.pixels - below.pixels, all.sum - below.sum, all.squares - below.squares};
            const bool between = partOf(shades[i - 1].shade, channel) != partOf(shades[i].shade, channel);
            if (const double both = below.spread() + above.spread(); between && both < least) {
                least = both;
                best = i;
            }
        }
        return {Box(shades.first(best)), Box(shades.subspan(best))};
    }

    Palette::Colour mean() const {
        std::array<double, 3> sum{};
        double pixels = 0;
        for (const Counted& each : shades) {
            pixels += each.pixels;
            for (int c = 0; c < 3; ++c)
                sum[std::size_t(c)] += each.pixels * valueOf(each.shade, c);
        }
        const auto of = [&](std::size_t c) { return std::uint8_t(sum[c] / pixels + 0.5); };
        return {of(0), of(1), of(2)};
    }
};

std::vector<Counted> shadesOf(const VideoPicture& picture) {
    std::vector<double> pixels(kShades);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            ++pixels[shadeAt(picture, x, y)];
    std::vector<Counted> shades;
    for (int shade = 0; shade < kShades; ++shade)
        if (pixels[std::size_t(shade)] > 0) shades.push_back({Shade(shade), pixels[std::size_t(shade)]});
    return shades;
}

} // namespace

Shade shadeAt(const VideoPicture& picture, int x, int y) {
    const std::uint32_t pixel = picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
    const int more = (2 * orderAt(x, y) + 1) * 255 / 128; // of a step to the next one, half of it in the mean
    const auto part = [&](int shift) { return (int(pixel >> shift & 255) * kMost + more) / 255; };
    return Shade(part(16) << (2 * kBits) | part(8) << kBits | part(0));
}

Palette::Palette(const VideoPicture& picture) : nearest_(kShades) {
    std::vector<Counted> shades = shadesOf(picture);
    std::vector<Box> boxes{Box(shades)};
    while (boxes.size() < kColours) {
        const auto widest = std::ranges::max_element(boxes, {}, &Box::spread);
        if (widest->spread <= 0) break;
        auto [low, high] = widest->parted();
        *widest = low;
        boxes.push_back(high);
    }
    for (const Box& box : boxes)
        colours_.push_back(box.mean());
}

const Palette::Nearest& Palette::nearestTo(Shade shade) {
    Nearest& known = nearest_[shade];
    if (std::exchange(known.known, true)) return known;
    int least = 3 * 256 * 256;
    for (std::size_t i = 0; i < colours_.size(); ++i) {
        const Colour& each = colours_[i];
        const std::array<int, 3> apart{valueOf(shade, 0) - each.red, valueOf(shade, 1) - each.green,
                                       valueOf(shade, 2) - each.blue};
        const int square = apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2];
        if (square >= least) continue;
        least = square;
        known.index = std::uint8_t(i);
        known.distance = std::uint8_t(std::max({std::abs(apart[0]), std::abs(apart[1]), std::abs(apart[2])}));
    }
    return known;
}

std::uint8_t Palette::indexOf(Shade shade) {
    return nearestTo(shade).index;
}

int Palette::distanceOf(Shade shade) {
    return nearestTo(shade).distance;
}

} // namespace tactum
