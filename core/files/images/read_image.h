// Pictures as haptic textures: PNG, JPEG and TIFF, by what the file is and not by what it is called.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/surface/texture_image.h"

namespace tactum {

struct LoadedImage {
    std::shared_ptr<const TextureImage> image;
    std::string note; ///< which of its values were clamped, empty for none: a sentence for the person
};

/// Reads a picture of 8 or 16 bits (TIFF also of 32-bit numbers, which are clamped to 0 to 1 with a note).
/// The numbers are taken as they are: colour profiles, gamma and transparency are ignored; colours become
/// their luminance 0.299 R + 0.587 G + 0.114 B. 16 bits stay 16. At most TextureImage::kLargestSide texels a
/// side and kMaxTexels in all, checked before anything is allocated for them.
/// Errors: one line that names the file and the remedy. Thread: any but real time.
Result<LoadedImage> readImage(const std::filesystem::path& file);

/// The same of a picture in memory, e.g. one inside a glTF file. `name`: what the image is called; `where`:
/// the file in front of the error.
Result<LoadedImage> readImage(std::string_view bytes, const std::string& name,
                              const std::filesystem::path& where);

} // namespace tactum
