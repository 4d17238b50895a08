// WebM is a selection of Matroska (RFC 9559), which is made of EBML (RFC 8794): elements of an id, a length
// and a body. The file begins as a stream whose lengths nobody knows, so that it can be played however it
// ends; they, the duration and an index are put in when they are known.
#include "core/video/webm_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/video/vp8_encoder.h"

namespace tactum {

namespace {

enum Id : std::uint32_t {
    kEbml = 0x1A45DFA3,
    kEbmlVersion = 0x4286,
    kEbmlReadVersion = 0x42F7,
    kMaxIdLength = 0x42F2,
    kMaxSizeLength = 0x42F3,
    kDocType = 0x4282,
    kDocTypeVersion = 0x4287,
    kDocTypeReadVersion = 0x4285,
    kVoid = 0xEC,
    kSegment = 0x18538067,
    kSeekHead = 0x114D9B74,
    kSeek = 0x4DBB,
    kSeekId = 0x53AB,
    kSeekPosition = 0x53AC,
    kInfo = 0x1549A966,
    kTimestampScale = 0x2AD7B1,
    kDuration = 0x4489,
    kMuxingApp = 0x4D80,
    kWritingApp = 0x5741,
    kTracks = 0x1654AE6B,
    kTrackEntry = 0xAE,
    kTrackNumber = 0xD7,
    kTrackUid = 0x73C5,
    kTrackType = 0x83,
    kFlagLacing = 0x9C,
    kCodecId = 0x86,
    kVideo = 0xE0,
    kPixelWidth = 0xB0,
    kPixelHeight = 0xBA,
    kCluster = 0x1F43B675,
    kTimestamp = 0xE7,
    kSimpleBlock = 0xA3,
    kCues = 0x1C53BB6B,
    kCuePoint = 0xBB,
    kCueTime = 0xB3,
    kCueTrackPositions = 0xB7,
    kCueTrack = 0xF7,
    kCueClusterPosition = 0xF1,
};

constexpr std::uint64_t kUnknown = (std::uint64_t(1) << 56) - 1; // all ones: a length that nobody knows yet
constexpr std::size_t kLengthBytes = 8, kIndexRoom = 160;
constexpr long kClusterMilliseconds = 5000; // so often a picture stands alone, and playing can begin there

/// The lowest `bytes` of a number, the highest of them first.
std::string bigEndian(std::uint64_t value, std::size_t bytes) {
    std::string text(bytes, '\0');
    for (std::size_t i = bytes; i-- > 0; value >>= 8)
        text[i] = char(value & 255);
    return text;
}

std::string idBytes(std::uint32_t id) {
    return bigEndian(id, std::size_t(4 - std::countl_zero(id) / 8));
}

/// Always in eight bytes, of which the first one says so.
std::string lengthBytes(std::uint64_t length) {
    return bigEndian(length | std::uint64_t(1) << 56, kLengthBytes);
}

std::string element(Id id, const std::string& body) {
    return idBytes(id) + lengthBytes(body.size()) + body;
}
std::string number(Id id, std::uint64_t value) {
    return element(id, bigEndian(value, 8));
}
std::string real(Id id, double value) {
    return element(id, bigEndian(std::bit_cast<std::uint64_t>(value), 8));
}

/// Of so many bytes as a whole; what is in it says nothing.
std::string emptyRoom(std::size_t bytes) {
    return element(kVoid, std::string(bytes - idBytes(kVoid).size() - kLengthBytes, '\0'));
}

std::string header() {
    return element(kEbml, number(kEbmlVersion, 1) + number(kEbmlReadVersion, 1) + number(kMaxIdLength, 4) +
                              number(kMaxSizeLength, 8) + element(kDocType, "webm") +
                              number(kDocTypeVersion, 2) + number(kDocTypeReadVersion, 2));
}

std::string tracks(int width, int height) {
    const std::string video = number(kPixelWidth, unsigned(width)) + number(kPixelHeight, unsigned(height));
    return element(kTracks, element(kTrackEntry, number(kTrackNumber, 1) + number(kTrackUid, 1) +
                                                     number(kTrackType, 1) + number(kFlagLacing, 0) +
                                                     element(kCodecId, "V_VP8") + element(kVideo, video)));
}

std::string seekTo(Id id, std::uint64_t position) {
    return element(kSeek, element(kSeekId, idBytes(id)) + number(kSeekPosition, position));
}

class WebmFile : public VideoFile {
public:
    WebmFile(VideoOutput output, Vp8Encoder encoder)
        : output_(std::move(output)), encoder_(std::move(encoder)) {}

    Result<void> begin(int width, int height);
    Result<void> add(const VideoPicture& picture, double time) override;
    Result<void> finish(double end) override;

private:
    /// The beginning of a cluster.
    struct Cluster {
        std::uint64_t at;
        long milliseconds;
    };

    Result<void> write(long milliseconds, const std::string& packet, bool alone);
    bool standsAlone(long milliseconds) const {
        return clusters_.empty() || milliseconds - clusters_.back().milliseconds >= kClusterMilliseconds;
    }
    Result<void> hold(long milliseconds);
    bool beginCluster(long milliseconds);
    bool endCluster();
    bool writeIndex();
    bool putLength(std::uint64_t at, Id id);
    std::uint64_t position(std::uint64_t at) const { return at - segment_; }
    double seconds() const { return last_ ? double(*last_) / 1000 : 0; }

    VideoOutput output_;
    Vp8Encoder encoder_;
    std::uint64_t segment_ = 0, info_ = 0, duration_ = 0, tracks_ = 0; ///< where they are in the file
    std::vector<Cluster> clusters_;
    std::optional<long> last_; ///< ms
};

Result<void> WebmFile::begin(int width, int height) {
    output_.append(header() + idBytes(kSegment) + lengthBytes(kUnknown));
    segment_ = output_.size();
    output_.append(emptyRoom(kIndexRoom)); // for what writeIndex() puts there
    info_ = output_.size();
    const std::string known =
        number(kTimestampScale, 1'000'000) + element(kMuxingApp, "Tactum") + element(kWritingApp, "Tactum");
    const std::string unknown = emptyRoom(real(kDuration, 0).size());
    output_.append(element(kInfo, known + unknown));
    duration_ = output_.size() - unknown.size();
    tracks_ = output_.size();
    output_.append(tracks(width, height));
    if (output_.flush()) return {};
    return output_.failure(0);
}

/// Of an element that ends where the file does.
bool WebmFile::putLength(std::uint64_t at, Id id) {
    const std::uint64_t body = at + idBytes(id).size() + kLengthBytes;
    return output_.replace(body - kLengthBytes, lengthBytes(output_.size() - body));
}

bool WebmFile::endCluster() {
    return clusters_.empty() || putLength(clusters_.back().at, kCluster);
}

bool WebmFile::beginCluster(long milliseconds) {
    if (!endCluster()) return false;
    clusters_.push_back({output_.size(), milliseconds});
    return output_.append(idBytes(kCluster) + lengthBytes(kUnknown) +
                          number(kTimestamp, std::uint64_t(milliseconds)));
}

Result<void> WebmFile::write(long milliseconds, const std::string& packet, bool alone) {
    if (packet.empty()) return machineError("the encoder of the video has failed; record it again");
    bool written = !alone || beginCluster(milliseconds);
    const auto sinceCluster = std::uint64_t(milliseconds - clusters_.back().milliseconds);
    const std::string head = "\x81" + bigEndian(sinceCluster, 2) + (alone ? '\x80' : '\0');
    written = written && output_.append(element(kSimpleBlock, head + packet)) && output_.flush();
    if (!written) return output_.failure(seconds());
    last_ = milliseconds;
    return {};
}

Result<void> WebmFile::add(const VideoPicture& picture, double time) {
    const long milliseconds = std::lround(1000 * time);
    if (last_ && milliseconds <= *last_) return {};
    const bool alone = standsAlone(milliseconds);
    return write(milliseconds, encoder_.encode(picture, milliseconds, alone), alone);
}

Result<void> WebmFile::hold(long milliseconds) {
    const bool alone = standsAlone(milliseconds);
    return write(milliseconds, encoder_.repeat(milliseconds, alone), alone);
}

bool WebmFile::writeIndex() {
    std::string points;
    for (const Cluster& cluster : clusters_)
        points += element(
            kCuePoint, number(kCueTime, std::uint64_t(cluster.milliseconds)) +
                           element(kCueTrackPositions,
                                   number(kCueTrack, 1) + number(kCueClusterPosition, position(cluster.at))));
    const std::uint64_t cues = output_.size();
    const std::string index =
        element(kSeekHead, seekTo(kInfo, position(info_)) + seekTo(kTracks, position(tracks_)) +
                               seekTo(kCues, position(cues)));
    return output_.append(element(kCues, points)) &&
           output_.replace(segment_, index + emptyRoom(kIndexRoom - index.size()));
}

Result<void> WebmFile::finish(double end) {
    // Players stop at the last picture that is in the file, whatever duration it tells.
    const long shown = std::lround(1000 * (end - kVideoPeriod));
    if (last_ && shown > *last_ + 1000 * kVideoPeriod)
        if (const auto held = hold(shown); !held) return held;
    const double duration = std::max(1000 * end, last_ ? double(*last_ + 1) : 0.0);
    if (endCluster() && writeIndex() && output_.replace(duration_, real(kDuration, duration)) &&
        putLength(segment_ - idBytes(kSegment).size() - kLengthBytes, kSegment) && output_.close())
        return {};
    return output_.failure(seconds());
}

} // namespace

Result<std::unique_ptr<VideoFile>> beginWebm(VideoOutput output, int width, int height) {
    auto encoder = Vp8Encoder::open(width, height);
    if (!encoder) return tl::unexpected(encoder.error());
    auto file = std::make_unique<WebmFile>(std::move(output), std::move(*encoder));
    if (const auto begun = file->begin(width, height); !begun) return tl::unexpected(begun.error());
    return file;
}

} // namespace tactum
