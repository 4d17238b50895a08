// JPEG by libjpeg. A fault inside the library jumps out of it: functions that it may jump to keep no objects
// of their own.
#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <jpeglib.h>

#include "core/files/images/image_decoders.h"

namespace tactum {
namespace {

/// A picture of a few kilobytes can claim more passes than anybody waits for.
constexpr int kMaxScans = 200;

class JpegDecoder {
public:
    explicit JpegDecoder(const Source& source) : source_(source) {
        jpeg_.err = jpeg_std_error(&errors_.base);
        errors_.base.error_exit = [](j_common_ptr jpeg) { fail(jpeg); };
        errors_.base.emit_message = &JpegDecoder::noteWarning;
    }
    ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;

    DecodedImage decode() {
        if (!readHeader()) failDamaged(source_, errors_.words);
        if (jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK)
            source_.fail("has printing colours (CMYK); save it as a grey picture");
        DecodedImage image = emptyImage(source_, jpeg_.image_width, jpeg_.image_height, 8);
        row_.resize(std::size_t(image.width));
        if (!start()) failDamaged(source_, errors_.words);
        for (int y = 0; y < image.height; ++y) {
            if (!readRow()) failDamaged(source_, errors_.words);
            for (std::size_t x = 0; x < row_.size(); ++x)
                image.row(y)[x] = std::uint16_t(257 * row_[x]);
        }
        return image;
    }

private:
    struct Errors {
        jpeg_error_mgr base; // first, so that libjpeg's pointer is one to all of it
        std::jmp_buf wayOut;
        char words[JMSG_LENGTH_MAX];
    };

    bool readHeader();
    bool start();
    bool readRow();
    [[noreturn]] static void fail(j_common_ptr jpeg);
    /// libjpeg fills what is missing with grey and warns: for touch that is a fault.
    static void noteWarning(j_common_ptr jpeg, int level) {
        if (level < 0) fail(jpeg);
    }
    static void watchScans(j_common_ptr jpeg);

    const Source& source_;
    jpeg_decompress_struct jpeg_{};
    Errors errors_{};
    jpeg_progress_mgr progress_{};
    std::vector<JSAMPLE> row_;
};

void JpegDecoder::fail(j_common_ptr jpeg) {
    auto* errors = reinterpret_cast<Errors*>(jpeg->err);
    errors->base.format_message(jpeg, errors->words);
    std::longjmp(errors->wayOut, 1);
}

void JpegDecoder::watchScans(j_common_ptr jpeg) {
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMaxScans) return;
    auto* errors = reinterpret_cast<Errors*>(jpeg->err);
    std::strcpy(errors->words, "it has too many passes");
    std::longjmp(errors->wayOut, 1);
}

bool JpegDecoder::readHeader() {
    if (setjmp(errors_.wayOut)) return false;
    jpeg_create_decompress(&jpeg_);
    progress_.progress_monitor = &JpegDecoder::watchScans;
    jpeg_.progress = &progress_;
    const auto* bytes = reinterpret_cast<const unsigned char*>(source_.bytes().data());
    jpeg_mem_src(&jpeg_, bytes, static_cast<unsigned long>(source_.bytes().size()));
    jpeg_read_header(&jpeg_, TRUE);
    return true;
}

bool JpegDecoder::start() {
    if (setjmp(errors_.wayOut)) return false;
    jpeg_.out_color_space = JCS_GRAYSCALE;
    jpeg_.dct_method = JDCT_ISLOW; // the same bits on every machine
    jpeg_start_decompress(&jpeg_);
    return true;
}

bool JpegDecoder::readRow() {
    if (setjmp(errors_.wayOut)) return false;
    JSAMPROW row = row_.data();
    return jpeg_read_scanlines(&jpeg_, &row, 1) == 1;
}

} // namespace

DecodedImage decodeJpeg(const Source& source) {
    return JpegDecoder(source).decode();
}

} // namespace tactum
