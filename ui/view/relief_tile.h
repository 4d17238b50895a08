// A flat pattern as a texture: its values and slopes. Private to this folder.
#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include "core/surface/texture_stack.h"

namespace tactum {

/// One repeat of a pattern. Texel (x, y) lies at ((x + 0.5) / width, (y + 0.5) / height) repeats.
struct ReliefTile {
    int width = 0, height = 0;
    std::vector<float> texels; ///< value, d value / du, d value / dv of each, per repeat; row by row
};

/// Wider and higher pictures are drawn by the level of theirs that is not. Texels.
inline constexpr int kLargestReliefTile = 2048;

/// Whether the pattern repeats, so that one tile is all of it: noise does not, and what is painted is no
/// pattern.
bool repeats(const CompiledPattern& pattern);

/// Of a pattern that repeats, what the touch feels of it at each texel. Details shorter than
/// `smallestFeature` (m) are left out, those of a picture within half an octave. Thread: any but real time.
ReliefTile reliefTile(const CompiledPattern& pattern, double smallestFeature);

/// Textures of tiles, shared by all surfaces that show the same. Thread: ui.
class ReliefTiles {
public:
    vtkSmartPointer<vtkTexture> of(const CompiledPattern& pattern, double smallestFeature);
    /// Drops those that no surface shows any more.
    void dropUnused();

private:
    /// All that a tile depends on.
    struct Key {
        TextureSource source;
        std::shared_ptr<const TextureImage> image;
        int level = 0;                 ///< of the image
        WaveShape wave;                ///< of a formula,
        Eigen::Vector2d feature{0, 0}; ///< and the smallest feature, repeats

        bool operator==(const Key& other) const;
    };
    struct Made {
        Key key;
        vtkSmartPointer<vtkTexture> texture;
    };
    static Key keyOf(const CompiledPattern& pattern, double smallestFeature);

    std::vector<Made> made_;
};

} // namespace tactum
