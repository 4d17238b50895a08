#include "tests/core/files/image_files.h"

#include <QByteArray>

namespace tactum {
namespace {

std::string number(std::uint32_t value, int bytes, bool bigEndian) {
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += char(value >> 8 * (bigEndian ? bytes - 1 - i : i));
    return text;
}

std::uint32_t crc(const std::string& data) {
    std::uint32_t c = ~0u;
    for (unsigned char byte : data) {
        c ^= byte;
        for (int i = 0; i < 8; ++i)
            c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
    }
    return ~c;
}

/// The rows of every pass of a picture: all of it, or the seven of Adam7.
std::string passesOf(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& pixels,
                     bool interlaced) {
    struct Pass {
        std::uint32_t x, y, dx, dy;
    };
    static const std::vector<Pass> whole{{0, 0, 1, 1}},
        adam7{{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
              {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
    std::string rows;
    for (const Pass& pass : interlaced ? adam7 : whole)
        for (std::uint32_t y = pass.y; y < height && pass.x < width; y += pass.dy) {
            rows += '\0'; // no filter
            for (std::uint32_t x = pass.x; x < width; x += pass.dx)
                rows += pixels[std::size_t(y) * width + x];
        }
    return rows;
}

} // namespace

std::string pngChunk(const std::string& type, const std::string& data) {
    return number(std::uint32_t(data.size()), 4, true) + type + data + number(crc(type + data), 4, true);
}

std::string asPng(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& pixels,
                  const PngForm& form) {
    const std::string rows = pixels.empty() ? "" : passesOf(width, height, pixels, form.interlaced);
    const QByteArray packed =
        qCompress(reinterpret_cast<const uchar*>(rows.data()), qsizetype(rows.size())).mid(4);
    std::string header = number(width, 4, true) + number(height, 4, true);
    for (int value : {form.depth, form.colour, 0, 0, int(form.interlaced)})
        header += char(value);
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + form.extra +
           pngChunk("IDAT", packed.toStdString()) + pngChunk("IEND", "");
}

std::string asTiff(std::uint32_t width, std::uint32_t height, const std::string& data, const TiffForm& form) {
    struct Tag {
        std::uint32_t tag, type, value, count = 1; ///< type 3 short, 4 long
    };
    const bool tiled = form.tile > 0;
    const auto side = std::uint32_t(form.tile), size = std::uint32_t(data.size());
    // One row of tiles at most: two need their offsets and sizes outside the directory.
    const std::uint32_t tiles = tiled && width > side ? 2 : 1, count = tiled ? 11 : 10,
                        lists = 8 + 2 + 12 * count + 4, begin = lists + (tiles > 1 ? 16 : 0);
    std::vector<Tag> tags{{256, 4, width},
                          {257, 4, height},
                          {258, 3, std::uint32_t(form.bits)},
                          {259, 3, 1},
                          {262, 3, std::uint32_t(form.photometric)}};
    if (!tiled) tags.push_back({273, 4, begin});
    tags.push_back({277, 3, std::uint32_t(form.samples)});
    if (!tiled) tags.insert(tags.end(), {{278, 4, height}, {279, 4, size}});
    if (tiled)
        tags.insert(tags.end(), {{322, 4, side},
                                 {323, 4, side},
                                 {324, 4, tiles > 1 ? lists : begin, tiles},
                                 {325, 4, tiles > 1 ? lists + 8 : size, tiles}});
    tags.push_back({339, 3, std::uint32_t(form.format)});
    std::string file =
        std::string("II*\0", 4) + number(8, 4, false) + number(std::uint32_t(tags.size()), 2, false);
    for (const Tag& tag : tags)
        file += number(tag.tag, 2, false) + number(tag.type, 2, false) + number(tag.count, 4, false) +
                number(tag.value, 4, false);
    file += number(0, 4, false);
    if (tiles > 1)
        for (std::uint32_t value : {begin, begin + size / 2, size / 2, size / 2})
            file += number(value, 4, false);
    file.resize(begin, '\0');
    return file + data;
}

} // namespace tactum
