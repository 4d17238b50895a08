// A video as another program sees it: ffprobe counts its pictures, ffmpeg decodes them.
#pragma once

#include <algorithm>
#include <cmath>
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

/// How much a channel of squares of 8 x 8 pixels differs, of 255: what a GIF has too few colours for it mixes
/// of those around.
struct Difference {
    double mean = 255, worst = 255;
};

inline Difference differenceOf(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                               int width) {
    constexpr int kSquare = 8;
    if (a.size() != b.size() || a.empty()) return {};
    const int across = (width + kSquare - 1) / kSquare, rows = int(a.size()) / width;
    std::vector<double> sums(std::size_t(3 * across * ((rows + kSquare - 1) / kSquare)));
    std::vector<int> pixels(sums.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int square = int(i) / width / kSquare * across + int(i) % width / kSquare;
        for (int c = 0; c < 3; ++c) {
            const auto of = [&](std::uint32_t pixel) { return int(pixel >> (8 * c) & 255); };
            sums[std::size_t(3 * square + c)] += of(a[i]) - of(b[i]);
            ++pixels[std::size_t(3 * square + c)];
        }
    }
    Difference all{0, 0};
    for (std::size_t i = 0; i < sums.size(); ++i) {
        all.mean += std::abs(sums[i]) / double(3 * a.size());
        all.worst = std::max(all.worst, std::abs(sums[i]) / pixels[i]);
    }
    return all;
}

inline double difference(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                         int width) {
    return differenceOf(a, b, width).mean;
}

} // namespace tactum::test
