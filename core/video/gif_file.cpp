#include "core/video/gif_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include <gif_lib.h>

#include "core/video/palette.h"

namespace tactum {

namespace {

constexpr long kLeastDelay = 2;       // hundredths of a second: players take less for a tenth
constexpr long kLongestDelay = 65535; // what two bytes hold

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

/// More of the pixels of a part than this are far from every colour: it has colours that came later.
constexpr double kForeign = 0.002;
constexpr int kFar = 20; ///< of 255

bool isForeignTo(Palette& palette, const VideoPicture& picture, const Part& part) {
    std::size_t far = 0;
    for (int y = part.top; y < part.top + part.height; ++y)
        for (int x = part.left; x < part.left + part.width; ++x)
            far += palette.distanceOf(shadeAt(picture, x, y)) > kFar;
    return double(far) > kForeign * part.width * part.height;
}

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
    Palette palette_;               ///< of what is shown
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
    const Colours colours(GifMakeMapObject(Palette::kColours, nullptr));
    if (!colours) return false;
    std::ranges::transform(palette_.colours(), colours->Colors, [](const Palette::Colour& each) {
        return GifColorType{each.red, each.green, each.blue};
    });
    if (EGifPutImageDesc(gif_, part.left, part.top, part.width, part.height, false, colours.get()) != GIF_OK)
        return false;
    std::vector<GifByteType> row(std::size_t(part.width));
    for (int y = part.top; y < part.top + part.height; ++y) {
        for (int x = 0; x < part.width; ++x)
            row[std::size_t(x)] = palette_.indexOf(shadeAt(waiting_, part.left + x, y));
        if (EGifPutLine(gif_, row.data(), part.width) != GIF_OK) return false;
    }
    return true;
}

// A part in colours of its own would be seen beside the rest, so the palette stays as long as it can.
bool GifFile::writeWaiting(long until) {
    Part part = changedPart(waiting_, before_);
    if (before_.pixels.empty() || isForeignTo(palette_, waiting_, part)) {
        palette_ = Palette(waiting_);
        part = {0, 0, waiting_.width, waiting_.height};
    }
    if (!writeDelay(std::min(until - since_, kLongestDelay)) || !writePart(part) || !output_.flush())
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
