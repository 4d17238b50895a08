// The surface node of H3DAPI that comes nearest to one of our surfaces. For write_x3d.cpp only.
#pragma once

#include <string>
#include <vector>

#include "core/files/flatten_layers.h"
#include "core/files/x3d/write_x3d.h"
#include "core/files/x3d/xml_writer.h"

namespace tactum {

/// What a surface becomes.
struct X3dSurface {
    FlatPicture height; ///< with its image: a DepthMapSurface
    FlatPicture stiffness, staticFriction,
        dynamicFriction;           ///< as felt; one with an image: a HapticTexturesSurface
    std::vector<std::string> lost; ///< a sentence each

    /// The rectangle of texture coordinates that its pictures cover.
    const UvCanvas& canvas() const;
    bool hasPictures() const;
};

/// Of no use after a cancel, as the next one.
X3dSurface x3dSurfaceOf(const SceneObject& object, Index surface, const Progress& progress);

/// Where the pictures of a surface go, and how their names begin.
struct X3dPictures {
    std::string stem;
    std::vector<X3dImage>& images;
    const Progress& progress;
};

/// Of a surface that is not felt: its name alone.
void writeUnfeltSurface(XmlElement& appearance, const Surface& surface);

/// Writes the node into an Appearance, and appends its pictures.
void writeSurface(XmlElement& appearance, const X3dSurface& flat, const Surface& surface,
                  const X3dPictures& pictures);

} // namespace tactum
