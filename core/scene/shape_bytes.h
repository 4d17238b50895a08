// Meshes, images, painted values and motions as bytes: for recordings and for what the import process hands
// over.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/byte_stream.h"
#include "core/geometry/triangle_soup.h"
#include "core/motion/motion.h"
#include "core/surface/painted_values.h"
#include "core/surface/texture_image.h"

namespace tactum {

void write(ByteOut& out, const TriangleSoup& geometry);
void write(ByteOut& out, const TextureImage& image);
void write(ByteOut& out, const PaintedValues& painted);
void write(ByteOut& out, const Motion& moving);

// Throw ByteFault at everything that the loops could not rely on.
std::shared_ptr<const TriangleSoup> readSoup(ByteIn& in);
std::shared_ptr<const TextureImage> readImage(ByteIn& in);
std::shared_ptr<const PaintedValues> readPainted(ByteIn& in);
std::shared_ptr<const Motion> readMotion(ByteIn& in);

/// The finest level, row by row.
std::vector<std::uint16_t> texelsOf(const TextureImage& image);

} // namespace tactum
