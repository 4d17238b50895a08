// Pictures as VP8 (RFC 6386), by libvpx. For this folder only.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/video/video_file.h"

namespace tactum {

/// Every picture becomes one packet at once. Thread: one at a time.
class Vp8Encoder {
public:
    static Result<Vp8Encoder> open(int width, int height);
    ~Vp8Encoder();
    Vp8Encoder(Vp8Encoder&&) noexcept;
    Vp8Encoder& operator=(Vp8Encoder&&) noexcept;

    /// `milliseconds`: later than those of the last one. `alone`: it can be shown without any before it. An
    /// empty packet: the encoder has failed.
    std::string encode(const VideoPicture& picture, long milliseconds, bool alone);
    /// The last picture once more.
    std::string repeat(long milliseconds, bool alone);

private:
    struct Impl;
    explicit Vp8Encoder(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
