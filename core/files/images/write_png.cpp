#include "core/files/images/write_png.h"

#include <algorithm>
#include <new>
#include <vector>

#include <png.h>

namespace tactum {
namespace {

/// A fault inside libpng jumps out of it, so that this frame keeps no objects of its own.
bool writeRows(png_structp png, png_infop info, std::span<png_bytep> rows, const Progress& progress) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_write_info(png, info);
    for (const png_bytep row : rows) {
        if (progress.isCancelled()) return true;
        png_write_row(png, row);
    }
    png_write_end(png, info);
    return true;
}

void appendChunk(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// Most significant byte first, as the format has it.
std::vector<png_byte> packed(std::span<const std::uint16_t> values, int bits) {
    std::vector<png_byte> bytes;
    bytes.reserve(values.size() * std::size_t(bits / 8));
    for (const std::uint16_t value : values) {
        if (bits == 16) bytes.push_back(png_byte(value >> 8));
        bytes.push_back(bits == 16 ? png_byte(value) : png_byte((value * 255u + 32767u) / 65535u));
    }
    return bytes;
}

std::vector<std::uint16_t> fromTheTop(const TextureImage& image) {
    const auto& finest = image.level(0);
    std::vector<std::uint16_t> values;
    values.reserve(std::size_t(finest.width) * std::size_t(finest.height));
    for (int y = finest.height; y-- > 0;) // its first row is the lowest
        values.insert(values.end(), image.row(y), image.row(y) + finest.width);
    return values;
}

} // namespace

std::string encodePng(int width, int height, int channels, int bits, std::span<const std::uint16_t> values,
                      const Progress& progress) {
    std::string file;
    std::vector<png_byte> bytes = packed(values, bits);
    std::vector<png_bytep> rows;
    const std::size_t stride = std::size_t(width) * std::size_t(channels) * std::size_t(bits / 8);
    for (int y = 0; y < height; ++y)
        rows.push_back(bytes.data() + std::size_t(y) * stride);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    bool written = false;
    if (info) {
        png_set_write_fn(png, &file, appendChunk, nullptr);
        png_set_compression_level(png, 6); // said, so that another default does not change the bytes
        png_set_IHDR(png, info, png_uint_32(width), png_uint_32(height), bits,
                     channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        written = writeRows(png, info, rows, progress);
    }
    png_destroy_write_struct(&png, &info);
    if (!written) throw std::bad_alloc(); // nothing else can fail when the sizes are right
    return progress.isCancelled() ? std::string() : file;
}

std::string encodePng(const TextureImage& image, int bits, const Progress& progress) {
    return encodePng(image.width(), image.height(), 1, bits, fromTheTop(image), progress);
}

std::string encodePng(const TextureImage& image, const Progress& progress) {
    const std::vector<std::uint16_t> values = fromTheTop(image);
    const bool eight = std::ranges::all_of(values, [](std::uint16_t value) { return value % 257 == 0; });
    return encodePng(image.width(), image.height(), 1, eight ? 8 : 16, values, progress);
}

} // namespace tactum
