#include "core/video/gif_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include <gif_lib.h>

namespace tactum {

namespace {

constexpr long kLeastDelay = 2;       // hundredths of a second: players take less for a tenth
constexpr long kLongestDelay = 65535; // what two bytes hold
constexpr int kColours = 256;

/// A part of a picture, pixels.
struct Part {
    int left = 0, top = 0, width = 0, height = 0;
};

/// What of the picture is another than before; one pixel where nothing is.
Part changedPart(const VideoPicture& now, const VideoPicture& before) {
    if (before.pixels.empty()) return {0, 0, now.width, now.height};
    int left = now.width, right = 0, top = now.height, bottom = 0;
    for (int y = 0; y < now.height; ++y) {
        const auto begin = now.pixels.begin() + std::ptrdiff_t(y) * now.width, end = begin + now.width;
        const auto other = before.pixels.begin() + std::ptrdiff_t(y) * now.width;
        const auto first = std::mismatch(begin, end, other).first;
        if (first == end) continue;
        const auto last = std::mismatch(std::make_reverse_iterator(end), std::make_reverse_iterator(first),
                                        std::make_reverse_iterator(other + now.width))
                              .first;
        left = std::min(left, int(first - begin));
        right = std::max(right, int(last.base() - begin));
        top = std::min(top, y);
        bottom = y + 1;
    }
    return bottom == 0 ? Part{0, 0, 1, 1} : Part{left, top, right - left, bottom - top};
}

/// What is added to a value before giflib takes its five upper bits: from 0 to 7, another one at each of 8 x
/// 8 pixels (Bayer's order), so that what is lost of a pixel is found in those around it.
unsigned dither(int x, int y) {
    unsigned order = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const unsigned across = unsigned(x ^ y) >> bit & 1, down = unsigned(y) >> bit & 1;
        order = order << 2 | across << 1 | down;
    }
    return order / 8;
}

GifByteType dithered(unsigned value, unsigned more) {
    return GifByteType(std::min((value & 255) + more, 255u));
}

/// The colours of a part one by one, as giflib wants them.
struct Planes {
    std::vector<GifByteType> red, green, blue, index;

    Planes(const VideoPicture& picture, const Part& part) {
        const std::size_t count = std::size_t(part.width) * std::size_t(part.height);
        for (auto* plane : {&red, &green, &blue, &index})
            plane->reserve(count);
        for (int y = part.top; y < part.top + part.height; ++y)
            for (int x = part.left; x < part.left + part.width; ++x) {
                const std::uint32_t pixel = picture.pixels[std::size_t(y) * std::size_t(picture.width) + x];
                const unsigned more = dither(x, y);
                red.push_back(dithered(pixel >> 16, more));
                green.push_back(dithered(pixel >> 8, more));
                blue.push_back(dithered(pixel, more));
            }
        index.resize(count);
    }
};

struct FreeColours {
    void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using Colours = std::unique_ptr<ColorMapObject, FreeColours>;

class GifFile : public VideoFile {
public:
    explicit GifFile(VideoOutput output) : output_(std::move(output)) {}
    ~GifFile() override {
        int code = 0;
        if (gif_) EGifCloseFile(gif_, &code);
    }

    Result<void> begin(int width, int height);
    Result<void> add(const VideoPicture& picture, double time) override;
    Result<void> finish(double end) override;

private:
    static int take(GifFileType* gif, const GifByteType* bytes, int count);
    bool writeWaiting(long until);
    bool writeDelay(long hundredths);
    bool writePart(const Part& part);
    double seconds() const { return double(written_) / 100; }

    VideoOutput output_;
    GifFileType* gif_ = nullptr;
    VideoPicture before_, waiting_; ///< the last one in the file; and one whose end is not known yet
    long since_ = 0, written_ = 0;  ///< when that one begins, and until when the file goes; 1/100 s
};

int GifFile::take(GifFileType* gif, const GifByteType* bytes, int count) {
    auto& self = *static_cast<GifFile*>(gif->UserData);
    return self.output_.append({reinterpret_cast<const char*>(bytes), std::size_t(count)}) ? count : 0;
}

Result<void> GifFile::begin(int width, int height) {
    int code = 0;
    gif_ = EGifOpen(this, &GifFile::take, &code);
    if (!gif_) return machineError("there is not enough memory for a GIF; close other programs");
    EGifSetGifVersion(gif_, true);
    constexpr std::string_view kLoop = "NETSCAPE2.0";
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    const bool written = EGifPutScreenDesc(gif_, width, height, 8, 0, nullptr) == GIF_OK &&
                         EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
                         EGifPutExtensionBlock(gif_, int(kLoop.size()), kLoop.data()) == GIF_OK &&
                         EGifPutExtensionBlock(gif_, int(kForEver.size()), kForEver.data()) == GIF_OK &&
                         EGifPutExtensionTrailer(gif_) == GIF_OK && output_.flush();
    if (written) return {};
    return output_.failure(0);
}

bool GifFile::writeDelay(long hundredths) {
    const GraphicsControlBlock control{DISPOSE_DO_NOT, false, int(hundredths), NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    return EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, int(bytes.size()), bytes.data()) == GIF_OK;
}

bool GifFile::writePart(const Part& part) {
    Planes planes(waiting_, part);
    const Colours colours(GifMakeMapObject(kColours, nullptr));
    int count = kColours;
    if (!colours || GifQuantizeBuffer(unsigned(part.width), unsigned(part.height), &count, planes.red.data(),
                                      planes.green.data(), planes.blue.data(), planes.index.data(),
                                      colours->Colors) != GIF_OK)
        return false;
    if (EGifPutImageDesc(gif_, part.left, part.top, part.width, part.height, false, colours.get()) != GIF_OK)
        return false;
    for (int y = 0; y < part.height; ++y)
        if (EGifPutLine(gif_, planes.index.data() + std::ptrdiff_t(y) * part.width, part.width) != GIF_OK)
            return false;
    return true;
}

bool GifFile::writeWaiting(long until) {
    if (!writeDelay(std::min(until - since_, kLongestDelay)) || !writePart(changedPart(waiting_, before_)) ||
        !output_.flush())
        return false;
    written_ = until;
    before_ = std::move(waiting_);
    return true;
}

Result<void> GifFile::add(const VideoPicture& picture, double time) {
    const long now = std::lround(100 * time);
    if (!waiting_.pixels.empty()) {
        if (now < since_ + kLeastDelay) return {};
        if (!writeWaiting(now)) return output_.failure(seconds());
    }
    waiting_ = picture;
    since_ = now;
    return {};
}

Result<void> GifFile::finish(double end) {
    bool written =
        waiting_.pixels.empty() || writeWaiting(std::max(std::lround(100 * end), since_ + kLeastDelay));
    int code = 0;
    written = EGifCloseFile(std::exchange(gif_, nullptr), &code) == GIF_OK && written && output_.close();
    if (written) return {};
    return output_.failure(seconds());
}

} // namespace

Result<std::unique_ptr<VideoFile>> beginGif(VideoOutput output, int width, int height) {
    auto file = std::make_unique<GifFile>(std::move(output));
    if (const auto begun = file->begin(width, height); !begun) return tl::unexpected(begun.error());
    return file;
}

} // namespace tactum
