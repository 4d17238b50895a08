#include "core/video/vp8_encoder.h"

#include <algorithm>

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

namespace tactum {

namespace {

constexpr int kQuality = 12;      // of 4, the best, to 63
constexpr int kWorst = 40;        // likewise, where a picture changes as a whole
constexpr int kSpeed = 8;         // of -16 to 16: it has to follow the view on one of two processors
constexpr int kBitsOfAPixel = 12; // at most, of thirty pictures together

struct Colour {
    int r, g, b;
};

Colour colourOf(std::uint32_t pixel) {
    return {int(pixel >> 16 & 255), int(pixel >> 8 & 255), int(pixel & 255)};
}

// ITU-R BT.601 with 16 to 235 for black to white, as decoders of VP8 take it; the factors in parts of 256.
std::uint8_t lumaOf(Colour c) {
    return std::uint8_t((66 * c.r + 129 * c.g + 25 * c.b + 128 + (16 << 8)) >> 8);
}
std::uint8_t blueOf(Colour c) {
    return std::uint8_t((-38 * c.r - 74 * c.g + 112 * c.b + 128 + (128 << 8)) >> 8);
}
std::uint8_t redOf(Colour c) {
    return std::uint8_t((112 * c.r - 94 * c.g - 18 * c.b + 128 + (128 << 8)) >> 8);
}

/// Of four pixels.
Colour meanOf(const std::uint32_t* above, const std::uint32_t* below) {
    Colour sum{2, 2, 2};
    for (const std::uint32_t pixel : {above[0], above[1], below[0], below[1]}) {
        const Colour c = colourOf(pixel);
        sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
    }
    return {sum.r / 4, sum.g / 4, sum.b / 4};
}

/// Into planes of which those of colour have half the width and height.
void convert(const VideoPicture& picture, vpx_image_t& image) {
    const auto rowOf = [&](int plane, int y) {
        return image.planes[plane] + std::ptrdiff_t(y) * image.stride[plane];
    };
    for (int y = 0; y < picture.height; ++y)
        std::transform(picture.pixels.data() + std::size_t(y) * picture.width,
                       picture.pixels.data() + std::size_t(y + 1) * picture.width, rowOf(VPX_PLANE_Y, y),
                       [](std::uint32_t pixel) { return lumaOf(colourOf(pixel)); });
    for (int y = 0; y < picture.height / 2; ++y) {
        const std::uint32_t* above = picture.pixels.data() + std::size_t(2 * y) * picture.width;
        std::uint8_t *u = rowOf(VPX_PLANE_U, y), *v = rowOf(VPX_PLANE_V, y);
        for (int x = 0; x < picture.width; x += 2) {
            const Colour mean = meanOf(above + x, above + picture.width + x);
            *u++ = blueOf(mean);
            *v++ = redOf(mean);
        }
    }
}

vpx_codec_enc_cfg_t configuration(int width, int height) {
    vpx_codec_enc_cfg_t config{};
    vpx_codec_enc_config_default(vpx_codec_vp8_cx(), &config, 0);
    config.g_w = unsigned(width);
    config.g_h = unsigned(height);
    config.g_timebase = {1, 1000};
    config.g_threads = 1;
    config.g_lag_in_frames = 0;
    config.rc_dropframe_thresh = 0;
    config.rc_end_usage = VPX_CQ;
    config.rc_target_bitrate = unsigned(width * height / 1000 * kBitsOfAPixel);
    config.rc_min_quantizer = 4;
    config.rc_max_quantizer = kWorst;
    config.kf_mode = VPX_KF_DISABLED; // who writes the file says where
    return config;
}

} // namespace

struct Vp8Encoder::Impl {
    vpx_codec_ctx_t codec{};
    vpx_image_t image{};
    long last = 0; ///< ms

    ~Impl() {
        vpx_codec_destroy(&codec);
        vpx_img_free(&image);
    }
    std::string encode(long milliseconds, bool alone);
};

std::string Vp8Encoder::Impl::encode(long milliseconds, bool alone) {
    const auto length = unsigned(std::max(1L, milliseconds - last));
    last = milliseconds;
    std::string packet;
    if (vpx_codec_encode(&codec, &image, milliseconds, length, alone ? VPX_EFLAG_FORCE_KF : 0,
                         VPX_DL_REALTIME) != VPX_CODEC_OK)
        return packet;
    vpx_codec_iter_t next = nullptr;
    while (const vpx_codec_cx_pkt_t* part = vpx_codec_get_cx_data(&codec, &next))
        if (part->kind == VPX_CODEC_CX_FRAME_PKT)
            packet.append(static_cast<const char*>(part->data.frame.buf), part->data.frame.sz);
    return packet;
}

Vp8Encoder::Vp8Encoder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Vp8Encoder::~Vp8Encoder() = default;
Vp8Encoder::Vp8Encoder(Vp8Encoder&&) noexcept = default;
Vp8Encoder& Vp8Encoder::operator=(Vp8Encoder&&) noexcept = default;

Result<Vp8Encoder> Vp8Encoder::open(int width, int height) {
    auto impl = std::make_unique<Impl>();
    const vpx_codec_enc_cfg_t config = configuration(width, height);
    if (!vpx_img_alloc(&impl->image, VPX_IMG_FMT_I420, unsigned(width), unsigned(height), 16) ||
        vpx_codec_enc_init(&impl->codec, vpx_codec_vp8_cx(), &config, 0) != VPX_CODEC_OK ||
        vpx_codec_control(&impl->codec, VP8E_SET_CPUUSED, kSpeed) != VPX_CODEC_OK ||
        vpx_codec_control(&impl->codec, VP8E_SET_CQ_LEVEL, kQuality) != VPX_CODEC_OK)
        return machineError("a video of " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels cannot be encoded here; choose a smaller one");
    return Vp8Encoder(std::move(impl));
}

std::string Vp8Encoder::encode(const VideoPicture& picture, long milliseconds, bool alone) {
    convert(picture, impl_->image);
    return impl_->encode(milliseconds, alone);
}

std::string Vp8Encoder::repeat(long milliseconds, bool alone) {
    return impl_->encode(milliseconds, alone);
}

} // namespace tactum
