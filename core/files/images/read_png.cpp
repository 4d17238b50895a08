// PNG by libpng. A fault inside the library jumps out of it: functions that it may jump to keep no objects of
// their own.
#include <algorithm>
#include <bit>
#include <cstring>

#include <png.h>

#include "core/files/images/image_decoders.h"

namespace tactum {
namespace {

class PngDecoder {
public:
    explicit PngDecoder(const Source& source) : source_(source), rest_(source.bytes()) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngDecoder::noteFault,
                                      [](png_structp, png_const_charp) {});
        if (png_) info_ = png_create_info_struct(png_);
    }
    ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    DecodedImage decode() {
        if (!info_) throw std::bad_alloc();
        if (!readHeader()) failDamaged(source_, fault_);
        DecodedImage image = emptyImage(source_, png_get_image_width(png_, info_),
                                        png_get_image_height(png_, info_), std::max(8, int(depth_)));
        if (!askForGrey()) failDamaged(source_, fault_);
        if (png_get_rowbytes(png_, info_) != std::size_t(image.width) * sizeof(std::uint16_t))
            source_.fail("has a kind of pixel that is not read; save it as a grey picture");
        for (int y = 0; y < image.height; ++y)
            rows_.push_back(reinterpret_cast<png_bytep>(image.row(y)));
        if (!readRows()) failDamaged(source_, fault_);
        return image;
    }

private:
    bool readHeader();
    bool askForGrey();
    bool readRows();
    static void noteFault(png_structp png, png_const_charp words);
    static void readBytes(png_structp png, png_bytep to, std::size_t count);

    const Source& source_;
    std::string_view rest_; ///< not read yet
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    png_byte depth_ = 0;
    std::vector<png_bytep> rows_;
    char fault_[128] = "";
};

void PngDecoder::noteFault(png_structp png, png_const_charp words) {
    auto* decoder = static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::strncpy(decoder->fault_, words, sizeof decoder->fault_ - 1);
    png_longjmp(png, 1);
}

void PngDecoder::readBytes(png_structp png, png_bytep to, std::size_t count) {
    auto* decoder = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (count > decoder->rest_.size()) png_error(png, "the file ends before the picture does");
    std::memcpy(to, decoder->rest_.data(), count);
    decoder->rest_.remove_prefix(count);
}

bool PngDecoder::readHeader() {
    static constexpr png_byte kProfiles[] = "gAMA\0cHRM\0sRGB\0iCCP";
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_read_fn(png_, this, &PngDecoder::readBytes);
    // Sizes are judged by us, with a sentence for the person.
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kProfiles, 4);
    png_read_info(png_, info_);
    depth_ = png_get_bit_depth(png_, info_);
    return true;
}

/// Whatever it is, libpng gives back 16 bits of grey in the processor's byte order.
bool PngDecoder::askForGrey() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_expand_16(png_); // palettes and few bits too; 8 bits v become 257 v
    png_set_strip_alpha(png_);
    if (png_get_color_type(png_, info_) & PNG_COLOR_MASK_COLOR)
        png_set_rgb_to_gray(png_, PNG_ERROR_ACTION_NONE, luminance(1, 0, 0), luminance(0, 1, 0));
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
}

bool PngDecoder::readRows() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_image(png_, rows_.data());
    png_read_end(png_, nullptr);
    return true;
}

} // namespace

DecodedImage decodePng(const Source& source) {
    return PngDecoder(source).decode();
}

} // namespace tactum
