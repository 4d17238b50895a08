#include "ui/view/relief_tile.h"

#include <algorithm>
#include <cmath>

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "core/surface/texture_feel.h"

namespace tactum {

namespace {

/// Of formulas: eight to the shortest wave that they have.
constexpr int kFormulaTexels = 128;

/// Texels of the whole picture to a metre, where they lie closest.
double densityOf(const CompiledPattern& pattern) {
    const TextureImage& image = *pattern.image;
    return std::max(image.width() * pattern.repeatsPerMetre.row(0).norm(),
                    image.height() * pattern.repeatsPerMetre.row(1).norm());
}

int levelFor(const CompiledPattern& pattern, double smallestFeature) {
    const TextureImage& image = *pattern.image;
    int level = int(std::lround(std::log2(std::max(1.0, smallestFeature * densityOf(pattern)))));
    level = std::min(level, image.levelCount() - 1);
    while (std::max(image.level(level).width, image.level(level).height) > kLargestReliefTile)
        ++level;
    return level;
}

ReliefTile formulaTile(const CompiledPattern& pattern, double smallestFeature) {
    ReliefTile tile{kFormulaTexels, pattern.source == TextureSource::Grooves ? 1 : kFormulaTexels, {}};
    tile.texels.reserve(3 * std::size_t(tile.width) * std::size_t(tile.height));
    FlatPoint point;
    point.perMetre.leftCols<2>() = pattern.repeatsPerMetre;
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            point.at = {(x + 0.5) / tile.width, (y + 0.5) / tile.height};
            const FlatSample sample = sampleFlat(pattern, point, smallestFeature);
            tile.texels.insert(tile.texels.end(),
                               {float(sample.value), float(sample.slope.x()), float(sample.slope.y())});
        }
    return tile;
}

/// What the cubics of image_sample.cpp are at a texel itself: its value, and the slope by its neighbours.
ReliefTile imageTile(const TextureImage& image, const TextureImage::Level& level) {
    const int width = level.width, height = level.height;
    std::vector<float> values(std::size_t(width) * std::size_t(height));
    for (int y = 0; y < height; ++y)
        image.visitRow(level, y, [&](const auto* row) {
            std::transform(row, row + width, values.begin() + std::ptrdiff_t(y) * width,
                           [](auto texel) { return float(texel) / 65535; });
        });
    const auto at = [&](int x, int y) {
        return values[std::size_t((y + height) % height) * std::size_t(width) +
                      std::size_t((x + width) % width)];
    };
    const auto slope = [](float farLeft, float left, float right, float farRight) {
        return (8 * (right - left) - (farRight - farLeft)) / 12;
    };
    // A row or column may be shorter than the reach of the slopes.
    const int two = 2 % width, twoUp = 2 % height;
    ReliefTile tile{width, height, {}};
    tile.texels.reserve(3 * values.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float u = slope(at(x - two, y), at(x - 1, y), at(x + 1, y), at(x + two, y)),
                        v = slope(at(x, y - twoUp), at(x, y - 1), at(x, y + 1), at(x, y + twoUp));
            tile.texels.insert(tile.texels.end(), {at(x, y), float(width) * u, float(height) * v});
        }
    return tile;
}

vtkSmartPointer<vtkTexture> textureOf(const ReliefTile& tile) {
    vtkNew<vtkFloatArray> texels;
    texels->SetNumberOfComponents(3);
    texels->SetNumberOfTuples(vtkIdType(tile.texels.size() / 3));
    std::ranges::copy(tile.texels, texels->GetPointer(0));
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(tile.width, tile.height, 1);
    picture->GetPointData()->SetScalars(texels);
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(picture);
    texture->SetColorModeToDirectScalars();
    texture->InterpolateOn();
    texture->RepeatOn();
    return texture;
}

} // namespace

bool repeats(const CompiledPattern& pattern) {
    return pattern.source != TextureSource::Noise && pattern.source != TextureSource::Painted;
}

ReliefTile reliefTile(const CompiledPattern& pattern, double smallestFeature) {
    if (pattern.source != TextureSource::Image) return formulaTile(pattern, smallestFeature);
    return imageTile(*pattern.image, pattern.image->level(levelFor(pattern, smallestFeature)));
}

bool ReliefTiles::Key::operator==(const Key& other) const {
    return source == other.source && image == other.image && level == other.level &&
           wave.mean == other.wave.mean && wave.amplitude == other.wave.amplitude && feature == other.feature;
}

ReliefTiles::Key ReliefTiles::keyOf(const CompiledPattern& pattern, double smallestFeature) {
    if (pattern.source == TextureSource::Image)
        return {pattern.source, pattern.image, levelFor(pattern, smallestFeature), {}};
    return {pattern.source, nullptr, 0, pattern.wave,
            smallestFeature * pattern.repeatsPerMetre.rowwise().norm()};
}

vtkSmartPointer<vtkTexture> ReliefTiles::of(const CompiledPattern& pattern, double smallestFeature) {
    Key key = keyOf(pattern, smallestFeature);
    for (const Made& made : made_)
        if (made.key == key) return made.texture;
    made_.push_back({std::move(key), textureOf(reliefTile(pattern, smallestFeature))});
    return made_.back().texture;
}

void ReliefTiles::dropUnused() {
    std::erase_if(made_, [](const Made& made) { return made.texture->GetReferenceCount() == 1; });
}

} // namespace tactum
