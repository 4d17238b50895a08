// What is drawn of a surface's height layers: plain values. Private to this folder.
#pragma once

#include <memory>

#include "core/surface/texture_stack.h"

namespace tactum {

/// The height of a surface as it is felt, for a shader.
struct Relief {
    /// Height layers alone, at most kMostReliefPatterns patterns and masks, none with a plane of its own.
    std::shared_ptr<const TextureStack> stack;
    double smallestFeature = 0; ///< m: finer details are left out, as feel() leaves them out
    double low = 0, high = 0;   ///< m: between these the heights lie, about
    bool corners = false;       ///< needs numbers at the corners of each triangle: UVs, or what is painted
};

/// The shader has room for so many; the layers from there on are felt and not drawn.
inline constexpr int kMostReliefPatterns = 12;

/// The layers of height as the eye takes them: one with a plane of its own is as high as if it were added to
/// the others.
TextureStack asOneHeight(const TextureStack& stack);

/// The relief of a surface of stack.soup; null where no layer of it changes the height. Takes as long as a
/// look at every triangle. Thread: any but real time.
std::shared_ptr<const Relief> reliefOf(const std::shared_ptr<const TextureStack>& stack,
                                       double smallestFeature);

} // namespace tactum
