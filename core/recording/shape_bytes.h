// Meshes, images and motions as bytes, and how to tell them apart. For this folder only.
#pragma once

#include <memory>

#include "core/dynamics/motion.h"
#include "core/geometry/triangle_soup.h"
#include "core/recording/file_io.h"
#include "core/surface/texture_image.h"

namespace tactum {

void write(FileOut& out, const TriangleSoup& geometry);
void write(FileOut& out, const TextureImage& image);
void write(FileOut& out, const Motion& moving);

// Throw RecordingFault at everything that the loops could not rely on.
std::shared_ptr<const TriangleSoup> readSoup(FileIn& in);
std::shared_ptr<const TextureImage> readImage(FileIn& in);
std::shared_ptr<const Motion> readMotion(FileIn& in);

/// Geometry and images that a file does not hold are told by the fingerprint of their content.
std::uint64_t fingerprintOf(const TriangleSoup& soup);
std::uint64_t fingerprintOf(const TextureImage& image);

} // namespace tactum
