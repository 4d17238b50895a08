// Pictures as textures: every format, exact values, and an answer to whatever is wrong with a file.
#include <random>

#include <QBuffer>
#include <QImage>
#include <QTest>

#include "core/files/images/read_image.h"
#include "core/files/images/write_png.h"
#include "tests/core/files/image_files.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_read_image {

using namespace tactum;

namespace {

std::string bytes(std::initializer_list<int> values) {
    std::string text;
    for (int value : values)
        text += char(value);
    return text;
}

/// Two rows of three: 0 51 102 above 153 204 255.
std::vector<std::string> sixGreys() {
    std::vector<std::string> pixels;
    for (int i = 0; i < 6; ++i)
        pixels.push_back(bytes({51 * i}));
    return pixels;
}

std::string asJpeg(const QImage& image) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "JPG", 100);
    return buffer.data().toStdString();
}

QImage slope(QImage::Format format) {
    QImage image(32, 16, QImage::Format_RGB32);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            image.setPixel(x, y, qRgb(7 * x, 7 * x, 7 * x));
    return image.convertToFormat(format);
}

std::vector<std::pair<std::string, std::string>> soundFiles() {
    const TiffForm tiled{16, 1, 1, 1, 16};
    return {{"grey.png", asPng(3, 2, sixGreys())},
            {"interlaced.png", asPng(3, 2, sixGreys(), {8, 0, true, {}})},
            {"slope.jpg", asJpeg(slope(QImage::Format_Grayscale8))},
            {"colour.jpg", asJpeg(slope(QImage::Format_RGB32))},
            {"strip.tif", asTiff(3, 2, bytes({0, 51, 102, 153, 204, 255}))},
            {"tiled.tif", asTiff(9, 5, std::string(512, 'x'), tiled)}};
}

bool isOneLine(const std::string& text) {
    return !text.empty() && text.size() < 300 && text.find('\n') == std::string::npos;
}

} // namespace

class TestReadImage : public QObject {
    Q_OBJECT

private slots:
    void writtenTexelsComeBack() {
        std::mt19937 random(7);
        for (const int step : {1, 257})
            for (int trial = 0; trial < 20; ++trial) {
                const int width = 1 + int(random() % 40), height = 1 + int(random() % 40);
                std::vector<std::uint16_t> texels(std::size_t(width * height));
                for (auto& texel : texels)
                    texel = std::uint16_t(random() % 256 * unsigned(step));
                const TextureImage image(width, height, texels, "a");
                const std::string file = encodePng(image);
                QCOMPARE(file, encodePng(image));
                const auto again = readImage(file, "a", "memory");
                VERIFY_RESULT(again);
                QCOMPARE(again->image->width(), width);
                for (int y = 0; y < height; ++y)
                    QVERIFY(std::equal(texels.begin() + y * width, texels.begin() + (y + 1) * width,
                                       again->image->row(y)));
            }
    }

    void greysOfEightBitsAreExactAndTheLowestRowIsTheFirst() {
        for (bool interlaced : {false, true}) {
            const auto image = read("a.png", asPng(3, 2, sixGreys(), {8, 0, interlaced, {}}));
            QVERIFY(image);
            QCOMPARE(image->bits(), 8);
            QCOMPARE(image->name(), std::string("a.png"));
            QCOMPARE(rowsOf(*image), (std::vector<int>{153, 204, 255, 0, 51, 102}));
        }
    }

    void sixteenBitsStaySixteen() {
        std::vector<std::string> pixels;
        for (int i = 0; i < 4 * 4; ++i)
            pixels.push_back(bytes({0x12, i}));
        for (bool interlaced : {false, true}) {
            const auto image = read("a.png", asPng(4, 4, pixels, {16, 0, interlaced, {}}));
            QVERIFY(image);
            QCOMPARE(image->bits(), 16);
            for (int i = 0; i < 16; ++i)
                QCOMPARE(std::lround(65535 * image->texel(image->level(0), i % 4, 3 - i / 4)),
                         long(0x1200 + i));
        }
    }

    void coloursBecomeLuminanceAndAlphaIsLeftAside() {
        const auto rgb =
            read("a.png", asPng(3, 1, {bytes({255, 0, 0}), bytes({0, 255, 0}), bytes({0, 0, 255})},
                                {8, 2, false, {}}));
        QVERIFY(rgb);
        const std::vector<int> luminances = rowsOf(*rgb), expected{76, 150, 29};
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE_LE(std::abs(luminances[i] - expected[i]), 1);
        const auto alpha =
            read("a.png", asPng(2, 1, {bytes({100, 0}), bytes({200, 255})}, {8, 4, false, {}}));
        QCOMPARE(rowsOf(*alpha), (std::vector<int>{100, 200}));
        const std::string palette = pngChunk("PLTE", bytes({10, 10, 10, 90, 90, 90}));
        const auto indexed = read("a.png", asPng(2, 1, {bytes({1}), bytes({0})}, {8, 3, false, palette}));
        QCOMPARE(rowsOf(*indexed), (std::vector<int>{90, 10}));
    }

    void profilesAreIgnored() {
        const std::string gamma = pngChunk("gAMA", bytes({0, 0, 0xB1, 0x8F})) + pngChunk("sRGB", bytes({0}));
        QCOMPARE(rowsOf(*read("a.png", asPng(3, 2, sixGreys(), {8, 0, false, gamma}))),
                 (std::vector<int>{153, 204, 255, 0, 51, 102}));
        const auto rgb = read("a.png", asPng(1, 1, {bytes({200, 50, 0})}, {8, 2, false, gamma}));
        QCOMPARE(rowsOf(*rgb), std::vector<int>{89}); // in linear light it would be 121
    }

    void jpegsAreRead() {
        for (QImage::Format format : {QImage::Format_Grayscale8, QImage::Format_RGB32}) {
            const auto image = read("a.jpg", asJpeg(slope(format)));
            QVERIFY(image);
            QCOMPARE(image->width(), 32);
            for (int x = 0; x < 32; ++x)
                COMPARE_NEAR(255 * image->texel(image->level(0), x, 3), 7 * x, 3, "");
        }
        QImage halves(16, 16, QImage::Format_Grayscale8);
        halves.fill(0);
        std::fill_n(halves.scanLine(0), 8 * halves.bytesPerLine(), uchar(255));
        const auto image = read("a.jpg", asJpeg(halves));
        QCOMPARE_LT(image->texel(image->level(0), 3, 1), 0.1);
        QCOMPARE_GT(image->texel(image->level(0), 3, 14), 0.9);
    }

    void tiffsOfEveryKindAreRead() {
        const std::string greys = bytes({0, 51, 102, 153, 204, 255});
        QCOMPARE(rowsOf(*read("a.tif", asTiff(3, 2, greys))), (std::vector<int>{153, 204, 255, 0, 51, 102}));
        QCOMPARE(rowsOf(*read("a.tif", asTiff(3, 2, greys, {8, 1, 1, 0, 0}))),
                 (std::vector<int>{102, 51, 0, 255, 204, 153}));
        const auto deep = read("a.tif", asTiff(2, 1, bytes({0x34, 0x12, 0xff, 0xff}), {16, 1, 1, 1, 0}));
        QCOMPARE(deep->bits(), 16);
        QCOMPARE(std::lround(65535 * deep->texel(deep->level(0), 0, 0)), 0x1234L);
        const auto rgb = read("a.tif", asTiff(1, 1, bytes({255, 0, 0}), {8, 3, 1, 2, 0}));
        QCOMPARE(rowsOf(*rgb), std::vector<int>{76});
        std::string tile(16 * 16, '\0');
        tile[0] = 10, tile[16 + 2] = 20;
        const auto tiled = read("a.tif", asTiff(3, 2, tile, {8, 1, 1, 1, 16}));
        QCOMPARE(rowsOf(*tiled), (std::vector<int>{0, 0, 20, 10, 0, 0}));
        std::vector<int> expected(16, 7);
        expected.resize(20, 9); // the second of two tiles begins there
        const auto two =
            read("a.tif", asTiff(20, 1, std::string(256, 7) + std::string(256, 9), {8, 1, 1, 1, 16}));
        QCOMPARE(rowsOf(*two), expected);
    }

    void numbersOutsideTheRangeAreClampedAndCounted() {
        std::string data;
        for (float value : {0.5f, -1.f, 2.f, std::nanf("")})
            data.append(reinterpret_cast<const char*>(&value), sizeof value);
        const auto loaded = readImage(folder_.write("a.tif", asTiff(4, 1, data, {32, 1, 3, 1, 0})));
        VERIFY_RESULT(loaded);
        COMPARE_BEGINS(loaded->note, "3 values of ");
        QVERIFY(loaded->note.ends_with("a.tif lie outside 0 to 1"));
        const TextureImage& image = *loaded->image;
        COMPARE_NEAR(image.texel(image.level(0), 0, 0), 0.5, 1e-5, "");
        QCOMPARE(image.texel(image.level(0), 1, 0), 0.0);
        QCOMPARE(image.texel(image.level(0), 2, 0), 1.0);
        QCOMPARE(image.texel(image.level(0), 3, 0), 0.0);
        const auto rgb =
            readImage(folder_.write("b.tif", asTiff(1, 1, bytes({255, 255, 255}), {8, 3, 1, 2, 0})));
        VERIFY_RESULT(rgb);
        QVERIFY(rgb->note.empty());
    }

    void sizesAreJudgedBeforeRoomIsMade_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const std::string& content, const char* said) {
            QTest::newRow(name) << QByteArray::fromStdString(content) << said;
        };
        std::string jpeg = asJpeg(slope(QImage::Format_Grayscale8));
        const std::size_t frame = jpeg.find("\xff\xc0");
        QCOMPARE_NE(frame, std::string::npos);
        jpeg.replace(frame + 5, 4, "\xff\xdc\xff\xdc"); // 65500 x 65500
        row("bomb", asPng(0x7fffffff, 0x7fffffff, {}), "2147483647 x 2147483647 texels, more than 16384");
        row("wide", asPng(16385, 1, {}), "16385 x 1 texels, more than");
        row("all", asPng(16384, 16384, {}), "16384 x 16384 texels, more than");
        row("tiff", asTiff(100000, 100000, ""), "100000 x 100000 texels, more than");
        row("jpeg", jpeg, "65500 x 65500 texels, more than");
        row("no width", asPng(0, 4, {}), "is damaged or cut short");
        row("no tiff", asTiff(3, 0, ""), "a.bin: ");
        row("claims more than it has", asPng(9000, 9000, {}), "is damaged or cut short");
    }
    void sizesAreJudgedBeforeRoomIsMade() {
        QFETCH(QByteArray, content);
        QFETCH(QString, said);
        const auto loaded = readImage(folder_.write("a.bin", content.toStdString()));
        QVERIFY(!loaded);
        QVERIFY2(QString::fromStdString(loaded.error().text).contains(said), loaded.error().text.c_str());
        QVERIFY2(isOneLine(loaded.error().text), loaded.error().text.c_str());
    }

    void whatIsNoPictureSaysSo() {
        for (const char* content : {"GIF89a", "hello", "\x89PNG", "P5 2 2 255 abcd"}) {
            const auto loaded = readImage(folder_.write("a.png", content));
            QVERIFY(!loaded);
            COMPARE_CONTAINS(loaded.error().text, "PNG, JPEG or TIFF");
        }
        COMPARE_CONTAINS(readImage(folder_.path() / "gone.png").error().text, "no such file");
        const auto lab = readImage(folder_.write("a.tif", asTiff(1, 1, bytes({0}), {8, 1, 1, 8, 0})));
        QVERIFY(!lab);
        COMPARE_CONTAINS(lab.error().text, "save it grey");
        const auto few = readImage(folder_.write("a.tif", asTiff(8, 1, bytes({0}), {1, 1, 1, 1, 0})));
        QVERIFY(!few);
        COMPARE_CONTAINS(few.error().text, "8 or 16 bits");
    }

    /// Cut anywhere, a picture is a fault; a JPEG may lack its two last bytes, which say nothing.
    void truncatedPicturesAreFaults() {
        for (const auto& [name, content] : soundFiles())
            for (std::size_t length = 1; length + 2 < content.size(); length += 1 + content.size() / 97) {
                const auto loaded = readImage(folder_.write(name, content.substr(0, length)));
                QVERIFY2(!loaded, (name + " of " + std::to_string(length)).c_str());
                QVERIFY2(isOneLine(loaded.error().text), loaded.error().text.c_str());
            }
    }

    void mutatedPicturesAreAnswered() {
        std::mt19937 random(42);
        for (const auto& [name, content] : soundFiles())
            for (int i = 0; i < 400; ++i) {
                std::string changed = content;
                for (unsigned n = 1 + random() % 4; n > 0; --n)
                    changed[random() % std::min<std::size_t>(changed.size(), 700)] = char(random());
                const auto loaded = readImage(folder_.write(name, changed));
                if (loaded)
                    QCOMPARE_LE(loaded->image->width(), TextureImage::kLargestSide);
                else
                    QVERIFY2(isOneLine(loaded.error().text), loaded.error().text.c_str());
            }
    }

private:
    std::shared_ptr<const TextureImage> read(const std::string& name, const std::string& content) {
        const auto loaded = readImage(folder_.write(name, content));
        if (!loaded) qWarning("%s", loaded.error().text.c_str());
        return loaded ? loaded->image : nullptr;
    }
    /// All texels as 8 bits, the lowest row first.
    static std::vector<int> rowsOf(const TextureImage& image) {
        std::vector<int> values;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                values.push_back(int(std::lround(255 * image.texel(image.level(0), x, y))));
        return values;
    }

    FileFolder folder_;
};

TACTUM_TEST(TestReadImage)

} // namespace test_read_image

#include "test_read_image.moc"
