// Videos, looked at by ffmpeg: size, times and pixels are what was put in, also when nobody finished the
// file.
#include <algorithm>
#include <cmath>
#include <csignal>

#include <QDir>
#include <QFile>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>
#include <sys/resource.h>

#include "core/video/video_file.h"
#include "tests/core/video/seen_video.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_video {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kWidth = 96, kHeight = 64;

/// Smooth in all three colours, with a square that goes on by four pixels each time.
VideoPicture pictureAt(int step) {
    VideoPicture picture{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const bool square = x / 16 == step % 6 && y / 16 == 1;
            const std::uint32_t r = square ? 240 : unsigned(2 * x), g = square ? 200 : unsigned(3 * y),
                                b = 60;
            picture.pixels.push_back(0xff000000u | r << 16 | g << 8 | b);
        }
    return picture;
}

/// Of a GIF's pictures (GIF89a, 23 and 20): eight bytes of control, then ten that say where the picture is.
std::vector<QByteArray> controlsOf(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray bytes = file.readAll(), begin("\x21\xf9\x04");
    std::vector<QByteArray> controls;
    for (qsizetype at = bytes.indexOf(begin); at >= 0; at = bytes.indexOf(begin, at + 1))
        if (bytes[at + 7] == 0) controls.push_back(bytes.mid(at, 18)); // else bytes of a picture
    return controls;
}

constexpr int kWide = 320, kHigh = 240;

/// As a window shows: a ground that is nearly black, a large body with a soft shadow, and what is small and
/// colourful: the lines of a plot, which go on, and a finger on its way.
VideoPicture windowAt(int step) {
    VideoPicture picture{kWide, kHigh, {}};
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x) {
            const double far = std::hypot(x - 130, 2 * (y - 100)) / 110;
            unsigned r = 40 + unsigned(y) / 12, g = 42 + unsigned(y) / 12, b = 50 + unsigned(y) / 10;
            if (far < 1) {
                const double light = 1 - 0.25 * std::exp(-std::pow((x - 120) / 30.0, 2)) - 0.1 * far;
                r = unsigned(226 * light), g = unsigned(216 * light), b = unsigned(198 * light);
            }
            if (std::hypot(x - 90 - 6 * step, y - 90) < 6) r = 240, g = 150, b = 40;
            if (y > 180 && (y - 180) % 12 < 2 && (x < 20 + 30 * step || x > 300)) {
                r = x % 3 == 0 ? 255 : 20, g = unsigned(37 * (y / 12) % 256), b = unsigned(5 * x % 256);
            }
            picture.pixels.push_back(0xff000000u | r << 16 | g << 8 | b);
        }
    return picture;
}

/// A file that may become so many bytes long, as on a full disk.
class ShortDisk {
public:
    explicit ShortDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~ShortDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    void (*handler_)(int);
    rlimit before_{};
};

} // namespace

class TestVideo : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::string path(const char* name) const {
        return folder_.filePath(QString::fromLatin1(name)).toStdString();
    }

private slots:
    void init() {
        if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    }
    void anotherPlayerSeesWhatWasPutIn_data();
    void anotherPlayerSeesWhatWasPutIn();
    void aBodyKeepsItsShadingBesideAPlot();
    void whatIsNotFinishedCanBePlayed_data() { anotherPlayerSeesWhatWasPutIn_data(); }
    void whatIsNotFinishedCanBePlayed();
    void aPictureIsHeldForMinutes();
    void aGifWaitsForNobody();
    void newColoursComeWithTheWholePicture();
    void timesOnlyGoOn();
    void aFullDiskIsOneSentence_data() { anotherPlayerSeesWhatWasPutIn_data(); }
    void aFullDiskIsOneSentence();
    void whatCannotBeWrittenIsOneSentence();
};

void TestVideo::anotherPlayerSeesWhatWasPutIn_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("codec");
    QTest::addColumn<double>("tick"); // s, as fine as the file counts
    QTest::addColumn<double>("cost"); // of 255, what it may lose
    QTest::newRow("WebM") << "a.webm" << QByteArray("vp8") << 0.001 << 3.0;
    QTest::newRow("GIF") << "a.gif" << QByteArray("gif") << 0.01 << 3.0;
}

void TestVideo::anotherPlayerSeesWhatWasPutIn() {
    QFETCH(QString, name);
    QFETCH(QByteArray, codec);
    QFETCH(double, tick);
    QFETCH(double, cost);
    const QString file = folder_.filePath(name);
    auto video = beginVideo(file.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    // The fourth picture is held for a second.
    const std::vector<double> times{0, 1 / 30.0, 2 / 30.0, 0.1, 1.1, 1.1 + 1 / 30.0};
    for (std::size_t i = 0; i < times.size(); ++i)
        VERIFY_RESULT((*video)->add(pictureAt(int(i)), times[i]));
    VERIFY_RESULT((*video)->finish(1.2));

    const SeenVideo found = seen(file);
    QCOMPARE(found.codec, codec);
    QCOMPARE(found.width, kWidth);
    QCOMPARE(found.height, kHeight);
    COMPARE_NEAR(found.duration, 1.2, 1.5 * tick, "s");
    QVERIFY2(found.times.size() >= times.size(), "a picture is missing");
    for (std::size_t i = 0; i < times.size(); ++i)
        COMPARE_NEAR(found.times[i], times[i], 0.51 * tick, "s");
    const auto pictures = decoded(file, kWidth, kHeight);
    QVERIFY2(pictures.size() >= times.size(), "a picture cannot be decoded");
    for (std::size_t i = 0; i < times.size(); ++i)
        QCOMPARE_LT(difference(pictures[i], pictureAt(int(i)).pixels, kWidth), cost);
    QCOMPARE_GT(difference(pictures[1], pictureAt(2).pixels, kWidth), 2 * cost);
}

// What is large and even has its shading in every picture, whatever is beside it and comes later: no part of
// it has another tint than the rest.
void TestVideo::aBodyKeepsItsShadingBesideAPlot() {
    const QString file = folder_.filePath("window.gif");
    auto video = beginVideo(file.toStdString(), kWide, kHigh);
    VERIFY_RESULT(video);
    constexpr int kSteps = 9;
    for (int i = 0; i < kSteps; ++i)
        VERIFY_RESULT((*video)->add(windowAt(i), i / 10.0));
    VERIFY_RESULT((*video)->finish(1));
    const auto pictures = decoded(file, kWide, kHigh);
    QCOMPARE(pictures.size(), std::size_t(kSteps));
    for (int i = 0; i < kSteps; ++i) {
        const Difference found = differenceOf(pictures[std::size_t(i)], windowAt(i).pixels, kWide);
        QCOMPARE_LT(found.mean, 0.5);
        QCOMPARE_LT(found.worst, 2.0);
    }
}

/// As after a crash: what was handed to the operating system is in the file.
void TestVideo::whatIsNotFinishedCanBePlayed() {
    QFETCH(QString, name);
    const QString file = folder_.filePath(name), copy = folder_.filePath("copy-" + name);
    auto video = beginVideo(file.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    for (int i = 0; i < 10; ++i)
        VERIFY_RESULT((*video)->add(pictureAt(i), i * kVideoPeriod));
    QFile::remove(copy);
    QVERIFY(QFile::copy(file, copy));
    const auto pictures = decoded(copy, kWidth, kHeight);
    QVERIFY2(pictures.size() >= 8, QByteArray::number(qsizetype(pictures.size())));
    QCOMPARE_LT(difference(pictures[5], pictureAt(5).pixels, kWidth), 3.0);
}

/// Longer than a block of WebM can lie behind the beginning of its cluster, and than a GIF's delay.
void TestVideo::aPictureIsHeldForMinutes() {
    const QString file = folder_.filePath("held.webm");
    auto video = beginVideo(file.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    VERIFY_RESULT((*video)->add(pictureAt(0), 0));
    VERIFY_RESULT((*video)->add(pictureAt(1), 200));
    VERIFY_RESULT((*video)->finish(500));
    const SeenVideo found = seen(file);
    COMPARE_NEAR(found.duration, 500, 0.002, "s");
    QCOMPARE(found.times.size(), std::size_t(3));
    COMPARE_NEAR(found.times[1], 200, 0.002, "s");
    COMPARE_NEAR(found.times[2], 500 - kVideoPeriod, 0.002, "s");
    // A player finds the second picture by the index.
    const QByteArray later = outputOf("ffmpeg", {"-v", "error", "-ss", "200", "-i", file, "-frames:v", "1",
                                                 "-f", "rawvideo", "-pix_fmt", "bgra", "-"});
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(later.constData());
    QCOMPARE_LT(difference({pixels, pixels + later.size() / 4}, pictureAt(1).pixels, kWidth), 3.0);
}

/// GIF89a, 23: a player that sees the flag "user input" stands still until somebody clicks.
void TestVideo::aGifWaitsForNobody() {
    const QString name = folder_.filePath("waits.gif");
    auto video = beginVideo(name.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    for (int i = 0; i < 5; ++i)
        VERIFY_RESULT((*video)->add(pictureAt(i), 0.1 * i));
    VERIFY_RESULT((*video)->finish(0.5));
    const std::vector<QByteArray> controls = controlsOf(name);
    for (const QByteArray& control : controls)
        QCOMPARE(control[3] & 2, 0);
    QCOMPARE_GE(controls.size(), std::size_t(5));
}

/// GIF89a, 20: behind the control of each picture the comma, its place and its size. Where colours are new a
/// part of its own would be seen beside the rest, in other colours.
void TestVideo::newColoursComeWithTheWholePicture() {
    const QString name = folder_.filePath("colours.gif");
    auto video = beginVideo(name.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    for (int i = 0; i < 3; ++i) { // a ground; a square of a new colour; the square somewhere else
        VideoPicture picture{kWidth, kHeight, std::vector<std::uint32_t>(kWidth * kHeight, 0xff282a32u)};
        for (int y = 16; i > 0 && y < 32; ++y)
            std::fill_n(picture.pixels.begin() + y * kWidth + 16 * i, 16, 0xffd21414u);
        VERIFY_RESULT((*video)->add(picture, 0.1 * i));
    }
    VERIFY_RESULT((*video)->finish(0.3));
    std::vector<QSize> sizes;
    for (const QByteArray& control : controlsOf(name)) {
        const auto number = [&](int byte) { return quint8(control[byte]) | quint8(control[byte + 1]) << 8; };
        QCOMPARE(control[8], ',');
        sizes.emplace_back(number(13), number(15));
    }
    QCOMPARE_GE(sizes.size(), std::size_t(3));
    QCOMPARE(sizes[0], QSize(kWidth, kHeight));
    QCOMPARE(sizes[1], QSize(kWidth, kHeight));
    QCOMPARE(sizes[2], QSize(32, 16)); // where it was and where it is
}

void TestVideo::timesOnlyGoOn() {
    const QString file = folder_.filePath("back.webm");
    auto video = beginVideo(file.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    for (const double time : {0.0, 0.5, 0.5, 0.2, 0.5004, 0.6})
        VERIFY_RESULT((*video)->add(pictureAt(0), time));
    VERIFY_RESULT((*video)->finish(0.6));
    QCOMPARE(seen(file).times, (std::vector<double>{0, 0.5, 0.6}));
}

void TestVideo::aFullDiskIsOneSentence() {
    QFETCH(QString, name);
    const QString file = folder_.filePath("full-" + name);
    auto video = beginVideo(file.toStdString(), kWidth, kHeight);
    VERIFY_RESULT(video);
    std::string refused;
    {
        const ShortDisk disk(16000);
        for (int i = 0; i < 3000 && refused.empty(); ++i)
            if (const auto added = (*video)->add(pictureAt(i), i * kVideoPeriod); !added)
                refused = test::refusal(added);
    }
    COMPARE_CONTAINS(refused, name.toStdString() + ": the video ends at ");
    COMPARE_CONTAINS(refused, "make room");
    video->reset();
    QVERIFY(decoded(file, kWidth, kHeight).size() > 3); // what came before is there
}

void TestVideo::whatCannotBeWrittenIsOneSentence() {
    const auto sentence = [&](const std::string& file) { return refusal(beginVideo(file, kWidth, kHeight)); };
    COMPARE_CONTAINS(sentence(path("no-folder/a.webm")), "cannot be written");
    COMPARE_CONTAINS(sentence("/dev/null.webm/a.webm"), "cannot be written");
    COMPARE_CONTAINS(sentence(path("a.avi")), "a video is written as .webm or .gif");
    QVERIFY(QDir(folder_.path()).mkdir("folder.webm"));
    COMPARE_CONTAINS(sentence(path("folder.webm")), "is no ordinary file");
}

TACTUM_TEST(TestVideo)

} // namespace test_video

#include "test_video.moc"
