#include "core/files/images/read_image.h"

#include "core/base/realtime.h"
#include "core/base/text.h"
#include "core/files/guarded.h"
#include "core/files/images/image_decoders.h"

namespace tactum {
namespace {

constexpr std::uint64_t kLargestPicture = std::uint64_t(1) << 30;

struct ImageFormat {
    std::string_view magic;
    DecodedImage (*decode)(const Source&);
};
constexpr ImageFormat kImageFormats[] = {
    {"\x89PNG\r\n\x1a\n", decodePng},           {"\xff\xd8\xff", decodeJpeg},
    {std::string_view("II*\0", 4), decodeTiff}, {std::string_view("MM\0*", 4), decodeTiff},
    {std::string_view("II+\0", 4), decodeTiff}, // with 64-bit offsets
    {std::string_view("MM\0+", 4), decodeTiff},
};

DecodedImage decode(const Source& source) {
    for (const ImageFormat& format : kImageFormats)
        if (source.bytes().starts_with(format.magic)) return format.decode(source);
    source.fail("is not a PNG, JPEG or TIFF picture; save it as one of them");
}

LoadedImage decode(const Source& source, std::string name) {
    DecodedImage decoded = decode(source);
    return {std::make_shared<const TextureImage>(decoded.width, decoded.height, std::move(decoded.texels),
                                                 std::move(name), decoded.bits),
            decoded.note};
}

constexpr const char* kNoMemoryForPicture = "for the picture; scale it down";

} // namespace

DecodedImage emptyImage(const Source& source, std::uint64_t width, std::uint64_t height, int bits) {
    constexpr std::uint64_t kSide = TextureImage::kLargestSide, kMax = TextureImage::kMaxTexels;
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
    if (width == 0 || height == 0) source.fail("has " + size + "; export it again");
    if (width > kSide || height > kSide || width * height > kMax)
        source.fail("has " + size + ", more than " + std::to_string(kSide) + " a side or " +
                    std::to_string(kMax >> 20) + " million in all; scale it down");
    DecodedImage image{int(width), int(height), bits, {}, {}};
    image.texels.resize(std::size_t(width * height));
    return image;
}

void failDamaged(const Source& source, const char* words) {
    source.fail("is damaged or cut short (" + printable(words) + "); export it again");
}

Result<LoadedImage> readImage(const std::filesystem::path& file) {
    assertNotRealtime();
    return guarded<LoadedImage>(file, kNoMemoryForPicture, [&] {
        return decode(Source::open(file, kLargestPicture), printable(file.filename().string(), 200));
    });
}

Result<LoadedImage> readImage(std::string_view bytes, const std::string& name,
                              const std::filesystem::path& where) {
    assertNotRealtime();
    return guarded<LoadedImage>(where, kNoMemoryForPicture,
                                [&] { return decode(Source::ofBytes(where, bytes), printable(name, 200)); });
}

} // namespace tactum
