// TIFF by libtiff: grey or colour of 8 or 16 bits or 32-bit numbers, in strips or tiles, however compressed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include <tiffio.h>

#include "core/files/images/image_decoders.h"
#include "core/surface/texture_image.h"

namespace tactum {
namespace {

/// What libtiff may allocate at once: a strip or tile of the largest picture that is read.
constexpr tmsize_t kMaxAtOnce = tmsize_t(1) << 29;

/// The bytes of the file as libtiff reads them, and the words of its first fault.
struct TiffInput {
    std::string_view bytes;
    std::uint64_t at = 0;
    char words[160] = "";
};

TiffInput& inputOf(thandle_t handle) {
    return *static_cast<TiffInput*>(handle);
}

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) {
    TiffInput& input = inputOf(handle);
    const std::uint64_t left = input.at < input.bytes.size() ? input.bytes.size() - input.at : 0;
    const std::uint64_t taken = std::min<std::uint64_t>(left, std::uint64_t(std::max<tmsize_t>(count, 0)));
    std::memcpy(to, input.bytes.data() + (taken ? input.at : 0), taken);
    input.at += taken;
    return tmsize_t(taken);
}

toff_t seek(thandle_t handle, toff_t to, int from) {
    TiffInput& input = inputOf(handle);
    const std::uint64_t start = from == SEEK_CUR ? input.at : from == SEEK_END ? input.bytes.size() : 0;
    return input.at = start + to;
}

int noteFault(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& input = *static_cast<TiffInput*>(user);
    if (input.words[0] == 0) std::vsnprintf(input.words, sizeof input.words, format, arguments);
    return 1;
}

using TiffHandle = std::unique_ptr<TIFF, void (*)(TIFF*)>;

TiffHandle openTiff(TiffInput& input) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxAtOnce);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &noteFault, &input);
    TIFFOpenOptionsSetWarningHandlerExtR(
        options.get(), [](TIFF*, void*, const char*, const char*, va_list) { return 1; }, nullptr);
    TIFF* tiff = TIFFClientOpenExt(
        "picture", "rm", &input, &readBytes, [](thandle_t, void*, tmsize_t) { return tmsize_t(0); }, &seek,
        [](thandle_t) { return 0; }, [](thandle_t handle) { return toff_t(inputOf(handle).bytes.size()); },
        nullptr, nullptr, options.get());
    return {tiff, &TIFFClose};
}

class TiffDecoder {
public:
    explicit TiffDecoder(const Source& source)
        : source_(source), input_{source.bytes(), 0, {}}, tiff_(openTiff(input_)) {
        if (!tiff_) failDamaged(source_, input_.words);
    }

    DecodedImage decode() {
        readTags();
        DecodedImage image = emptyImage(source_, width_, height_, bits_);
        TIFFIsTiled(tiff_.get()) ? readTiles(image) : readStrips(image);
        if (clamped_ > 0)
            image.note = std::to_string(clamped_) + " values of " + source_.name() + " lie outside 0 to 1";
        return image;
    }

private:
    void readTags();
    void demandReadable() const;
    void readStrips(DecodedImage& image);
    void readTiles(DecodedImage& image);
    void convert(const unsigned char* samples, std::size_t count, std::uint16_t* to);
    double sample(const unsigned char* at) const;
    std::size_t pixelBytes() const { return std::size_t(samples_) * bits_ / 8; }

    const Source& source_;
    TiffInput input_;
    TiffHandle tiff_;
    std::uint32_t width_ = 0, height_ = 0;
    std::uint16_t bits_ = 1, samples_ = 1, format_ = SAMPLEFORMAT_UINT, planes_ = PLANARCONFIG_CONTIG,
                  photometric_ = PHOTOMETRIC_MINISBLACK, compression_ = COMPRESSION_NONE;
    std::size_t clamped_ = 0;
};

void TiffDecoder::readTags() {
    TIFF* tiff = tiff_.get();
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width_);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planes_);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &compression_);
    demandReadable();
    if (photometric_ == PHOTOMETRIC_YCBCR) TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
}

void TiffDecoder::demandReadable() const {
    const bool whole = format_ == SAMPLEFORMAT_UINT && (bits_ == 8 || bits_ == 16);
    const bool number = format_ == SAMPLEFORMAT_IEEEFP && bits_ == 32;
    const bool colours = photometric_ == PHOTOMETRIC_MINISWHITE || photometric_ == PHOTOMETRIC_MINISBLACK ||
                         photometric_ == PHOTOMETRIC_RGB ||
                         (photometric_ == PHOTOMETRIC_YCBCR && compression_ == COMPRESSION_JPEG);
    if ((!whole && !number) || !colours || samples_ < 1 || samples_ > 16 ||
        (planes_ != PLANARCONFIG_CONTIG && samples_ > 1))
        source_.fail("is a kind of TIFF that is not read; save it grey with 8 or 16 bits");
    if (!TIFFIsCODECConfigured(compression_))
        source_.fail("is compressed in a way that is not read; save it without compression");
}

void TiffDecoder::readStrips(DecodedImage& image) {
    const std::size_t needed = std::size_t(width_) * pixelBytes();
    const std::uint64_t size = TIFFScanlineSize64(tiff_.get());
    if (size < needed || size > std::uint64_t(kMaxAtOnce)) failDamaged(source_, "rows of a wrong length");
    std::vector<unsigned char> row(size);
    for (std::uint32_t y = 0; y < height_; ++y) {
        if (TIFFReadScanline(tiff_.get(), row.data(), y) < 0) failDamaged(source_, input_.words);
        convert(row.data(), width_, image.row(int(y)));
    }
}

void TiffDecoder::readTiles(DecodedImage& image) {
    std::uint32_t wide = 0, high = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &wide);
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &high);
    const std::uint64_t size = TIFFTileSize64(tiff_.get());
    constexpr std::uint32_t kSide = TextureImage::kLargestSide;
    if (wide == 0 || high == 0 || wide > kSide || high > kSide || size > std::uint64_t(kMaxAtOnce) ||
        size < std::uint64_t(wide) * high * pixelBytes())
        failDamaged(source_, "tiles of a wrong size");
    std::vector<unsigned char> tile(size);
    for (std::uint32_t y = 0; y < height_; y += high)
        for (std::uint32_t x = 0; x < width_; x += wide) {
            if (TIFFReadTile(tiff_.get(), tile.data(), x, y, 0, 0) < 0) failDamaged(source_, input_.words);
            for (std::uint32_t line = 0; line < std::min(high, height_ - y); ++line)
                convert(tile.data() + std::size_t(line) * wide * pixelBytes(), std::min(wide, width_ - x),
                        image.row(int(y + line)) + x);
        }
}

/// From 0 to 1 when the file keeps to its range.
double TiffDecoder::sample(const unsigned char* at) const {
    if (bits_ == 8) return *at / 255.0;
    if (bits_ == 16) {
        std::uint16_t value;
        std::memcpy(&value, at, sizeof value);
        return value / 65535.0;
    }
    float value;
    std::memcpy(&value, at, sizeof value);
    return double(value);
}

void TiffDecoder::convert(const unsigned char* samples, std::size_t count, std::uint16_t* to) {
    const std::size_t step = bits_ / 8;
    const bool coloured =
        photometric_ != PHOTOMETRIC_MINISBLACK && photometric_ != PHOTOMETRIC_MINISWHITE && samples_ >= 3;
    for (std::size_t i = 0; i < count; ++i, samples += pixelBytes()) {
        double value = sample(samples);
        if (coloured) value = luminance(value, sample(samples + step), sample(samples + 2 * step));
        if (photometric_ == PHOTOMETRIC_MINISWHITE) value = 1 - value;
        const double inside = value >= 0 ? std::min(value, 1.0) : 0.0; // what is no number is 0
        // Rounding in the sum of three colours is none of the file's faults.
        clamped_ += !(std::abs(inside - value) < 1e-9);
        to[i] = std::uint16_t(std::lround(65535 * inside));
    }
}

} // namespace

DecodedImage decodeTiff(const Source& source) {
    return TiffDecoder(source).decode();
}

} // namespace tactum
