// The list of a surface's layers: names, new ones, targets, order, and the words for them. Wrong itself if
// layers of different patterns compared equal: where a layer went is told by what it is.
#include <QTest>

#include "core/surface/texture_image.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/document/layer_edits.h"

namespace test_layer_edits {

using namespace tactum;

namespace {

TextureLayers named(std::initializer_list<const char*> names) {
    TextureLayers layers;
    for (const char* name : names) {
        layers.emplace_back();
        layers.back().name = name;
    }
    return layers;
}

QString namesOf(const TextureLayers& layers) {
    QString names;
    for (const TextureLayer& layer : layers)
        names += QString::fromStdString(layer.name) + (layer.enabled ? u'+' : u'-');
    return names;
}

} // namespace

class TestLayerEdits : public QObject {
    Q_OBJECT
private slots:
    void freshNames() {
        const TextureLayers some = named({"Noise", "Noise 2", "Dots", "7", " 3"});
        QCOMPARE(freshLayerName(some, "Weave"), "Weave");
        QCOMPARE(freshLayerName(some, "Noise"), "Noise 3");
        QCOMPARE(freshLayerName(some, "Noise 2"), "Noise 3"); // and not "Noise 2 2"
        QCOMPARE(freshLayerName(some, "Noise 9"), "Noise 9");
        QCOMPARE(freshLayerName(some, "Dots"), "Dots 2");
        QCOMPARE(freshLayerName(some, "7"), "7 2"); // nothing but a number is a word
        QCOMPARE(freshLayerName(some, " 3"), " 3 2");
        QCOMPARE(freshLayerName(named({"A2"}), "A2"), "A2 2"); // no blank before it
        QCOMPARE(freshLayerName(named({"A "}), "A "), "A  2");
        QCOMPARE(freshLayerName({}, ""), "");
    }

    void newLayersCanBeSeenAndFollowed() {
        const auto sizeOf = [](TextureSource source) { return newLayer(source, {}).pattern.size; };
        QCOMPARE(sizeOf(TextureSource::Grooves), 2e-3);
        QCOMPARE(sizeOf(TextureSource::Weave), 2e-3);
        QCOMPARE(sizeOf(TextureSource::Dots), 3e-3);
        QCOMPARE(sizeOf(TextureSource::Image), 0.03);
        QCOMPARE(sizeOf(TextureSource::Noise), kTextureSize.initial);
        for (std::size_t i = 0; i < kTextureSources.size(); ++i) {
            const TextureLayer layer = newLayer(TextureSource(i), {});
            QCOMPARE(layer.name, std::string(kTextureSources[i].label));
            QCOMPARE(std::size_t(layer.pattern.source), i);
            QVERIFY(layer.enabled);
            QCOMPARE(layer.target, TextureTarget::Height);
            QCOMPARE(layer.pattern.mapping, TextureMapping::Triplanar);
        }
        QCOMPARE(newLayer(TextureSource::Dots, named({"Dots"})).name, "Dots 2");
        const auto image = [](const char* name) {
            return std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{1}, name, 8);
        };
        const auto bark = image("/somewhere/old.bark.png");
        const TextureLayer picture = newLayer(TextureSource::Image, named({"old.bark"}), true, bark);
        QCOMPARE(picture.name, "old.bark 2");
        QVERIFY(picture.pattern.image == bark);
        QCOMPARE(picture.pattern.mapping, TextureMapping::UvUnit); // where the mesh has coordinates
        QCOMPARE(newLayer(TextureSource::Image, {}, false, image("")).name, "Image");
        QCOMPARE(newLayer(TextureSource::Noise, {}, true).pattern.mapping, TextureMapping::Triplanar);
    }

    /// Metres of height mean nothing as a part of a value.
    void anotherTargetKeepsWhatMeansTheSame() {
        TextureLayer layer;
        layer.strength = -3e-4;
        layer.ownPlane = true;
        TextureLayer other = withTarget(layer, TextureTarget::Height);
        QVERIFY(other == layer);
        other = withTarget(layer, TextureTarget::Viscosity);
        QCOMPARE(other.target, TextureTarget::Viscosity);
        QCOMPARE(other.strength, -kTextureRatio.initial);
        QVERIFY(!other.ownPlane); // a height alone has one
        other.strength = 0.25;
        other = withTarget(other, TextureTarget::Stiffness);
        QCOMPARE(other.strength, 0.25);
        other = withTarget(other, TextureTarget::Height);
        QCOMPARE(other.strength, kTextureHeight.initial);
        QCOMPARE(other.target, TextureTarget::Height);
        QVERIFY(!other.ownPlane);
    }

    void layersMove() {
        const auto moved = [](int from, int to) {
            TextureLayers layers = named({"a", "b", "c", "d"});
            moveLayer(layers, from, to);
            return namesOf(layers).remove(u'+');
        };
        QCOMPARE(moved(0, 3), "bcda");
        QCOMPARE(moved(3, 0), "dabc");
        QCOMPARE(moved(1, 2), "acbd");
        QCOMPARE(moved(2, 1), "acbd");
        QCOMPARE(moved(2, 2), "abcd");
    }

    void aLayerIsFollowed() {
        const TextureLayers before = named({"a", "b", "c"});
        const auto at = [&](const TextureLayers& now, int number) {
            return followed(now, before.size(), number, before[std::size_t(number)]).value_or(-1);
        };
        QCOMPARE(at(before, 1), 1);
        QCOMPARE(at(named({"b", "a", "c"}), 1), 0); // moved
        QCOMPARE(at(named({"a", "c"}), 2), 1);      // another one went
        QCOMPARE(at(named({"a", "x", "c"}), 1), 1); // edited
        QCOMPARE(at(named({"a", "c"}), 1), -1);     // gone
        QCOMPARE(at(named({"a", "x", "c", "d"}), 1), -1);
        QCOMPARE(at({}, 0), -1);
        // Two alike: it stays where it is.
        const TextureLayers twins = named({"a", "a"});
        QCOMPARE(followed(twins, 2, 1, twins[1]).value_or(-1), 1);
    }

    void oneIsFeltAlone() {
        TextureLayers layers = named({"a", "b", "c"});
        layers[1].enabled = false;
        QCOMPARE(namesOf(alone(layers, 1)), "a-b+c-");
        QCOMPARE(namesOf(alone(layers, 0)), "a+b-c-");
        QCOMPARE(namesOf(alone(layers, 3)), "a-b-c-");
        QCOMPARE(namesOf(alone({}, 0)), "");
    }

    void framesAreMovedOfWhatHasOne() {
        TexturePattern pattern;
        for (const auto& [mapping, has] : {std::pair(TextureMapping::Triplanar, true),
                                           {TextureMapping::Planar, true},
                                           {TextureMapping::Cylindrical, true},
                                           {TextureMapping::Spherical, true},
                                           {TextureMapping::Uv, false},
                                           {TextureMapping::UvUnit, false}}) {
            pattern.mapping = mapping;
            pattern.source = TextureSource::Dots;
            QCOMPARE(hasFrame(pattern), has);
            pattern.source = TextureSource::Painted;
            QVERIFY(!hasFrame(pattern));
        }
    }

    void picturesAreKnownByTheirEnding() {
        for (const char* file : {"a.png", "/b/c.JPG", "d.e.jpeg", "f.Tif", "g.TIFF"})
            QVERIFY2(isPicture(QString::fromUtf8(file)), file);
        for (const char* file : {"", "png", "a.pngx", "a.obj", "a.png/b", "a.gif"})
            QVERIFY2(!isPicture(QString::fromUtf8(file)), file);
    }

    void wordsForALayer() {
        QCOMPARE(strengthText(TextureTarget::Height, 2e-4), "0.20 mm");
        QCOMPARE(strengthText(TextureTarget::Height, -1.5e-3), "-1.50 mm");
        QCOMPARE(strengthText(TextureTarget::Viscosity, 0.5), "+50 %");
        QCOMPARE(strengthText(TextureTarget::Stiffness, -0.25), "-25 %");
        QCOMPARE(strengthText(TextureTarget::Stiffness, 0), "0 %");
        TextureLayer layer;
        layer.strength = 3e-4;
        QCOMPARE(targetText(layer), "Height 0.30 mm");
        layer.blend = TextureBlend::Multiply; // takes the bare pattern
        QCOMPARE(targetText(layer), "Height multiplied");
        layer.target = TextureTarget::StaticFriction;
        layer.blend = TextureBlend::Add;
        layer.strength = 0.5;
        QCOMPARE(targetText(layer), "Static friction +50 %");
    }
};

TACTUM_TEST(TestLayerEdits)

} // namespace test_layer_edits

#include "test_layer_edits.moc"
