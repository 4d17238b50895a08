// A video as another program sees it: ffprobe counts its pictures, ffmpeg decodes them.
#pragma once

#include <cstdint>
#include <vector>

#include <QProcess>
#include <QStandardPaths>
#include <QString>

namespace tactum::test {

inline bool otherPlayerIsHere() {
    return !QStandardPaths::findExecutable(QStringLiteral("ffprobe")).isEmpty() &&
           !QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty();
}
inline constexpr const char* kNoOtherPlayer =
    "ffmpeg is not installed: nobody else looks at the video; apt install ffmpeg";

inline QByteArray outputOf(const QString& program, const QStringList& words) {
    QProcess process;
    process.start(program, words);
    return process.waitForFinished(60000) && process.exitCode() == 0 ? process.readAllStandardOutput()
                                                                     : QByteArray();
}

/// What a player sees of a file.
struct SeenVideo {
    QByteArray codec;
    int width = 0, height = 0;
    double duration = 0;       ///< s, as the file tells; 0: it does not
    std::vector<double> times; ///< of the pictures, s
};

inline SeenVideo seen(const QString& file) {
    const auto ask = [&](const char* what) {
        return outputOf(QStringLiteral("ffprobe"), {"-v", "error", "-select_streams", "v:0", "-show_entries",
                                                    what, "-of", "csv=p=0", file})
            .trimmed();
    };
    const QList<QByteArray> stream = ask("stream=codec_name,width,height").split(',');
    if (stream.size() < 3) return {};
    SeenVideo video{stream[0], stream[1].toInt(), stream[2].toInt(), ask("format=duration").toDouble(), {}};
    for (const QByteArray& time : ask("packet=pts_time").split('\n'))
        video.times.push_back(time.split(',').front().toDouble());
    return video;
}

/// The pixels of its pictures one after the other, 0xffRRGGBB.
inline std::vector<std::vector<std::uint32_t>> decoded(const QString& file, int width, int height) {
    const QByteArray raw =
        outputOf(QStringLiteral("ffmpeg"), {"-v", "error", "-i", file, "-vsync", "passthrough", "-f",
                                            "rawvideo", "-pix_fmt", "bgra", "-"});
    const std::size_t size = std::size_t(width) * std::size_t(height);
    std::vector<std::vector<std::uint32_t>> pictures;
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(raw.constData());
    for (std::size_t at = 0; 4 * (at + size) <= std::size_t(raw.size()); at += size)
        pictures.emplace_back(pixels + at, pixels + at + size);
    return pictures;
}

/// The mean difference of a channel, of 255, of squares of 8 x 8 pixels: what a GIF has too few colours for
/// it mixes of those around.
inline double difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                         int width) {
    constexpr int kSquare = 8;
    if (a.size() != b.size() || a.empty()) return 255;
    const auto squares = [&](const std::vector<std::uint32_t>& pixels, int shift) {
        std::vector<double> sums(pixels.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const int x = int(i) % width / kSquare, y = int(i) / width / kSquare;
            sums[std::size_t(y * width + x)] += int(pixels[i] >> shift & 255) / double(kSquare * kSquare);
        }
        return sums;
    };
    double sum = 0;
    for (const int shift : {0, 8, 16}) {
        const auto seenOfA = squares(a, shift), seenOfB = squares(b, shift);
        for (std::size_t i = 0; i < seenOfA.size(); ++i)
            sum += std::abs(seenOfA[i] - seenOfB[i]);
    }
    return sum * kSquare * kSquare / (3 * double(a.size()));
}

} // namespace tactum::test
