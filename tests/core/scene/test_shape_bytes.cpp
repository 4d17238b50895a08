// Meshes, images, motions and layers as bytes: what comes back, and what is refused on the way.
#include <cmath>
#include <functional>

#include <QTest>

#include "core/scene/layer_bytes.h"
#include "core/scene/shape_bytes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_shape_bytes {

using namespace tactum;

namespace {

/// Written and read again; what is refused says why.
template <class T, class Read> std::string refusalOf(const T& value, Read read) {
    StringOut out;
    write(out, value);
    ByteIn in(out.bytes, "part", 0, "again");
    try {
        (void)read(in);
        return in.left() == 0 ? "" : "something is left";
    } catch (const ByteFault& fault) {
        return fault.error.text;
    }
}

TriangleSoup mesh() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e6}};
    soup.triangles = {{0, 1, 2}, {1, 2, 3}};
    soup.surfaceOf = {0, 7};
    for (int i = 0; i < 6; ++i) {
        soup.cornerNormals.emplace_back(0.f, 0.f, float(i));
        soup.cornerUvs.emplace_back(float(i), 0.5f);
    }
    return soup;
}

Motion motion(Interpolation how = Interpolation::CubicSpline) {
    Motion m;
    m.translation = {how, {0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}, {}};
    m.rotation = {
        Interpolation::Linear, {0, 2}, {QuatCoefficients(0, 0, 0, 1), QuatCoefficients(1, 0, 0, 0)}, {}, {}};
    if (how == Interpolation::CubicSpline)
        m.translation.arriving = m.translation.leaving = m.translation.values;
    m.duration = 2;
    m.jumps = {1, 1.5};
    m.jumpsAtEnd = true;
    return m;
}

/// A layer through its bytes, with the tables that it names.
TextureLayer copied(TextureLayer layer, LayerTables* tables = nullptr) {
    StringOut out;
    LayerTables written, read;
    layerBytes(out, layer, written);
    read.images.items = written.images.items;
    read.paints.items = written.paints.items;
    if (tables) *tables = written;
    ByteIn in(out.bytes, "layer", 0, "again");
    TextureLayer back;
    back.mask.reset();
    layerBytes(in, back, read);
    if (in.left() != 0) qFatal("something is left");
    return back;
}

} // namespace

class TestShapeBytes : public QObject {
    Q_OBJECT

private slots:
    void aMeshComesBack() {
        StringOut out;
        write(out, mesh());
        ByteIn in(out.bytes, "part", 0, "again");
        QVERIFY(*readSoup(in) == mesh());
        TriangleSoup bare = mesh();
        bare.cornerNormals.clear();
        bare.cornerUvs.clear();
        QCOMPARE(refusalOf(bare, readSoup), "");
        QCOMPARE(refusalOf(TriangleSoup(), readSoup), "");
    }

    void aMeshThatCannotBeIsRefused_data() {
        QTest::addColumn<QByteArray>("refusal");
        QTest::addColumn<int>("which");
        for (const auto& [which, name, refusal] : {std::tuple(0, "surfaces", "as many corners as it says"),
                                                   {1, "normals", "as many corners as it says"},
                                                   {2, "uvs", "as many corners as it says"},
                                                   {3, "far", "not within 1e6 m"},
                                                   {4, "far y", "not within 1e6 m"},
                                                   {5, "far z", "not within 1e6 m"},
                                                   {6, "index", "a corner that there is not"},
                                                   {7, "normal", "a number that is not finite"},
                                                   {8, "uv", "a number that is not finite"}})
            QTest::newRow(name) << QByteArray(refusal) << which;
    }

    void aMeshThatCannotBeIsRefused() {
        QFETCH(QByteArray, refusal);
        QFETCH(int, which);
        TriangleSoup soup = mesh();
        const std::function<void()> changes[] = {
            [&] { soup.surfaceOf.pop_back(); },      [&] { soup.cornerNormals.pop_back(); },
            [&] { soup.cornerUvs.pop_back(); },      [&] { soup.positions[1].x() = 1.1e6; },
            [&] { soup.positions[1].y() = -1.1e6; }, [&] { soup.positions[1].z() = NAN; },
            [&] { soup.triangles[1][2] = 4; },       [&] { soup.cornerNormals[5].y() = INFINITY; },
            [&] { soup.cornerUvs[5].y() = NAN; }};
        changes[which]();
        COMPARE_CONTAINS(refusalOf(soup, readSoup), refusal.toStdString());
    }

    void anImageComesBack() {
        const TextureImage image(3, 2, {1, 2, 3, 4, 5, 65535}, "cloth.png", 8);
        QCOMPARE(texelsOf(image), (std::vector<std::uint16_t>{1, 2, 3, 4, 5, 65535}));
        StringOut out;
        write(out, image);
        ByteIn in(out.bytes, "part", 0, "again");
        const auto read = readImage(in);
        QCOMPARE(read->width(), 3);
        QCOMPARE(read->height(), 2);
        QCOMPARE(read->bits(), 8);
        QCOMPARE(read->name(), "cloth.png");
        QCOMPARE(texelsOf(*read), texelsOf(image));
        QCOMPARE(in.left(), 0u);
    }

    void anImageThatCannotBeIsRefused() {
        const auto refusal = [](int width, int height, std::size_t texels) {
            StringOut out;
            std::string name = "a\nb";
            int bits = 16;
            std::vector<std::uint16_t> values(texels);
            out(name), out(width), out(height), out(bits), out.bulk(values);
            ByteIn in(out.bytes, "part", 0, "again");
            try {
                return readImage(in)->name();
            } catch (const ByteFault& fault) {
                return fault.error.text;
            }
        };
        QCOMPARE(refusal(2, 3, 6), "a?b"); // safe to print
        QCOMPARE(refusal(TextureImage::kLargestSide, 1, std::size_t(TextureImage::kLargestSide)), "a?b");
        for (const auto& [width, height, texels] :
             {std::tuple(0, 3, 0),
              {3, 0, 0},
              {-2, -3, 6},
              {2, 3, 5},
              {2, 3, 7},
              {TextureImage::kLargestSide + 1, 1, TextureImage::kLargestSide + 1},
              {1, TextureImage::kLargestSide + 1, TextureImage::kLargestSide + 1}})
            COMPARE_CONTAINS(refusal(width, height, std::size_t(texels)),
                             "an image has not as many texels as it says");
    }

    void whatIsPaintedComesBack() {
        StringOut out;
        write(out, PaintedValues(std::vector<float>{0, 0.5f, 1}));
        ByteIn in(out.bytes, "part", 0, "again");
        QCOMPARE(readPainted(in)->all(), (std::vector<float>{0, 0.5f, 1}));
        for (const float value : {-0.01f, 1.01f, NAN}) {
            std::vector<float> values{0.5f, value};
            StringOut bad;
            bad.bulk(values);
            ByteIn from(bad.bytes, "part", 0, "again");
            QVERIFY_EXCEPTION_THROWN(readPainted(from), ByteFault);
        }
    }

    void aMotionComesBack() {
        for (const Interpolation how :
             {Interpolation::Step, Interpolation::Linear, Interpolation::CubicSpline}) {
            StringOut out;
            write(out, motion(how));
            ByteIn in(out.bytes, "part", 0, "again");
            QVERIFY(*readMotion(in) == motion(how));
            QCOMPARE(in.left(), 0u);
        }
    }

    void aMotionThatCannotBeIsRefused() {
        const auto refusal = [](const std::function<void(Motion&)>& change) {
            Motion m = motion();
            change(m);
            return refusalOf(m, readMotion);
        };
        QCOMPARE(refusal([](Motion&) {}), "");
        QCOMPARE(refusal([](Motion& m) { m.duration = 0; }), "");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.values.pop_back(); }),
                         "not a value for each key");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.arriving.pop_back(); }),
                         "not a value for each key");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.leaving.pop_back(); }),
                         "not a value for each key");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.rotation.arriving = m.rotation.values; }),
                         "not a value for each key");
        COMPARE_CONTAINS(refusal([](Motion& m) {
                             m.translation.times = {0, 2, 1};
                         }),
                         "not in the order of time");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.times.back() = INFINITY; }), "not finite");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.values[1].y() = NAN; }), "not finite");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.arriving[1].y() = NAN; }), "not finite");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.translation.leaving[1].y() = NAN; }), "not finite");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.duration = -1; }), "times make no sense");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.jumps = {1, 0.5}; }), "times make no sense");
        COMPARE_CONTAINS(refusal([](Motion& m) { m.rotation.values[1] *= 1 + 2e-6; }), "not of unit length");
        QCOMPARE(refusal([](Motion& m) { m.rotation.values[1] *= 1 + 1e-7; }), "");
    }

    void aLayerComesBackWithAllItsNumbers() {
        TextureLayer layer;
        layer.name = "grain";
        layer.enabled = false;
        layer.target = TextureTarget::Viscosity;
        layer.blend = TextureBlend::Minimum;
        layer.strength = -0.5;
        layer.opacity = 0.25;
        layer.ownPlane = true;
        layer.pattern.source = TextureSource::Image;
        layer.pattern.mapping = TextureMapping::Spherical;
        layer.pattern.image = std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{3});
        layer.pattern.frame = {Quat(0, 1, 0, 0), {1, 2, 3}};
        double next = 0.01;
        for (const PatternField& field : kPatternFields)
            layer.pattern.*field.value = next += 0.01;
        QVERIFY(copied(layer) == layer);
        layer.mask = layer.pattern;
        layer.mask->source = TextureSource::Painted;
        layer.mask->painted.values = std::make_shared<const PaintedValues>(std::vector<float>{1});
        LayerTables tables;
        QVERIFY(copied(layer, &tables) == layer);
        QCOMPARE(tables.images.items.size(), 1u); // shared by both, and written once
        QCOMPARE(tables.paints.items.size(), 1u);
    }

    void referencesAreIntoTheTable() {
        SharedTable<TextureImage> table;
        table.items = {std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{1}),
                       std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{2})};
        for (std::uint32_t number = 0; number < 4; ++number) {
            StringOut out;
            out(number);
            ByteIn in(out.bytes, "part", 0, "again");
            std::shared_ptr<const TextureImage> to = table.items[0];
            if (number == 3) {
                QVERIFY_EXCEPTION_THROWN(link(in, to, table), ByteFault);
                continue;
            }
            link(in, to, table);
            QVERIFY(to == (number == 0 ? nullptr : table.items[number - 1]));
        }
    }

    /// A recording outlives a change of the table: what it knows by name is taken, the rest is left.
    void numbersAreFoundByTheirNames() {
        StringOut out;
        std::uint32_t count = 2;
        out(count);
        std::string key = "fill", other = "of another version";
        double value = 0.75, unknown = 9;
        out(other), out(unknown), out(key), out(value);
        ByteIn in(out.bytes, "part", 0, "again");
        TexturePattern pattern;
        const TexturePattern before;
        numbersByKey(in, kPatternFields, pattern);
        QCOMPARE(pattern.fill, 0.75);
        pattern.fill = before.fill;
        QVERIFY(pattern == before);
        QCOMPARE(in.left(), 0u);
    }
};

TACTUM_TEST(TestShapeBytes)

} // namespace test_shape_bytes

#include "test_shape_bytes.moc"
