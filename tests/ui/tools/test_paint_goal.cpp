// Where the brush paints: which layer, or which mask, and what it says where it cannot.
//
// What would show that a test here is wrong: each refusal stands beside the same surface with the one thing
// mended.
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/tools/paint_goal.h"

namespace test_paint_goal {

using namespace tactum;

namespace {

TextureLayer layerOf(const char* name, TextureSource source, TextureTarget target = TextureTarget::Height) {
    TextureLayer layer;
    layer.name = name;
    layer.target = target;
    layer.pattern.source = source;
    return layer;
}

/// Noise, then painted friction, then grooves.
Surface leather() {
    Surface surface;
    surface.name = "leather";
    surface.layers = {layerOf("grain", TextureSource::Noise),
                      layerOf("wear", TextureSource::Painted, TextureTarget::StaticFriction),
                      layerOf("seam", TextureSource::Grooves)};
    return surface;
}

TexturePattern image(TextureMapping mapping) {
    TexturePattern pattern;
    pattern.source = TextureSource::Image;
    pattern.mapping = mapping;
    pattern.image = std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{0});
    return pattern;
}

QString whyNot(const Surface& surface, PaintGoal goal, std::optional<int> current = {}) {
    const auto place = paintPlaceOf(surface, goal, current);
    return place ? QString() : QString::fromStdString(place.error().text);
}

} // namespace

class TestPaintGoal : public QObject {
    Q_OBJECT

private slots:
    // A value goes to the topmost painted layer of its own that is on, else to a new one.
    void valuesHaveLayersOfTheirOwn() {
        Surface surface = leather();
        QCOMPARE(paintPlaceOf(surface, PaintGoal::StaticFriction, {}).value(), (PaintPlace{1, false}));
        QCOMPARE(paintPlaceOf(surface, PaintGoal::StaticFriction, 2).value(), (PaintPlace{1, false}));
        QCOMPARE(paintPlaceOf(surface, PaintGoal::DynamicFriction, {}).value(), (PaintPlace{3, false}));
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Height, {}).value(),
                 (PaintPlace{3, false})); // none is painted
        surface.layers.push_back(layerOf("again", TextureSource::Painted, TextureTarget::StaticFriction));
        QCOMPARE(paintPlaceOf(surface, PaintGoal::StaticFriction, {}).value(), (PaintPlace{3, false}));
        surface.layers[3].enabled = false;
        QCOMPARE(paintPlaceOf(surface, PaintGoal::StaticFriction, {}).value(), (PaintPlace{1, false}));
        surface.layers.erase(surface.layers.begin()); // the lowest of all
        QCOMPARE(paintPlaceOf(surface, PaintGoal::StaticFriction, {}).value(), (PaintPlace{0, false}));
    }

    void noMoreLayersThanAreFelt() {
        Surface surface = leather();
        while (int(surface.layers.size()) < kMaxTextureLayers - 1)
            surface.layers.push_back(surface.layers[0]);
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Viscosity, {}).value(),
                 (PaintPlace{kMaxTextureLayers - 1, false}));
        surface.layers.push_back(surface.layers[0]);
        QCOMPARE(whyNot(surface, PaintGoal::Viscosity),
                 QStringLiteral("leather has 16 layers, more are not felt; remove one first."));
        QCOMPARE(whyNot(surface, PaintGoal::StaticFriction), QString()); // that one is there already
    }

    void theChosenLayerIsPaintedElseTheTopmost() {
        Surface surface = leather();
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Layer, 1).value(), (PaintPlace{1, false}));
        for (const std::optional<int> none : {std::optional<int>(), {-1}, {3}, {7}})
            COMPARE_CONTAINS(whyNot(surface, PaintGoal::Layer, none),
                             QStringLiteral("The layer seam is grooves"));
        COMPARE_CONTAINS(
            whyNot(surface, PaintGoal::Layer, 0),
            QStringLiteral("The layer grain is noise, which cannot be painted: make it Painted, or paint "
                           "its mask."));
        surface.layers[2].pattern = image(TextureMapping::Uv);
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Layer, {}).value(), (PaintPlace{2, false}));
        surface.layers[2].pattern = image(TextureMapping::Triplanar); // lies on no coordinates
        COMPARE_CONTAINS(whyNot(surface, PaintGoal::Layer), QStringLiteral("is image"));
        surface.layers[2].pattern = image(TextureMapping::Uv);
        surface.layers[2].pattern.image.reset();
        COMPARE_CONTAINS(whyNot(surface, PaintGoal::Layer), QStringLiteral("is image"));
        surface.layers.clear();
        QCOMPARE(whyNot(surface, PaintGoal::Layer),
                 QStringLiteral("leather has no layer: add one, or let the brush paint a value."));
        QVERIFY(!whyNot(surface, PaintGoal::Mask).isEmpty());
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Height, {}).value(), (PaintPlace{0, false}));
    }

    void aMaskIsMadeWhereThereIsNone() {
        Surface surface = leather();
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Mask, 0).value(), (PaintPlace{0, true}));
        QCOMPARE(patternAt(surface, {0, true}), nullptr);
        surface.layers[0].mask = TexturePattern{};
        surface.layers[0].mask->source = TextureSource::Dots;
        COMPARE_CONTAINS(
            whyNot(surface, PaintGoal::Mask, 0),
            QStringLiteral("The mask of the layer grain is dots, which cannot be painted: make it "
                           "Painted, or take the mask away."));
        surface.layers[0].mask->source = TextureSource::Painted;
        QCOMPARE(paintPlaceOf(surface, PaintGoal::Mask, 0).value(), (PaintPlace{0, true}));
        QCOMPARE(patternAt(surface, {0, true}), &*surface.layers[0].mask);
    }

    void whatLiesThere() {
        const Surface surface = leather();
        QCOMPARE(patternAt(surface, {1, false}), &surface.layers[1].pattern);
        QCOMPARE(patternAt(surface, {0, false}), nullptr); // noise
        QCOMPARE(patternAt(surface, {1, true}), nullptr);
        QCOMPARE(patternAt(surface, {3, false}), nullptr);
        QCOMPARE(patternAt(surface, {-1, false}), nullptr);
    }

    void aPatternIsPut() {
        Surface surface = leather();
        TexturePattern pattern;
        pattern.source = TextureSource::Painted;
        pattern.size = 0.123;
        const Surface before = surface;
        putPattern(surface, {2, false}, PaintGoal::Layer, pattern);
        QVERIFY(surface.layers[2].pattern == pattern);
        QVERIFY(!surface.layers[2].mask);
        putPattern(surface, {0, true}, PaintGoal::Mask, pattern);
        QVERIFY(surface.layers[0].mask == pattern);
        QVERIFY(surface.layers[0].pattern == before.layers[0].pattern);
        QCOMPARE(surface.layers.size(), std::size_t(3));
        // A new layer for a value, with that value's own strength.
        putPattern(surface, {3, false}, PaintGoal::Viscosity, pattern);
        QCOMPARE(surface.layers.size(), std::size_t(4));
        QCOMPARE(surface.layers[3].target, TextureTarget::Viscosity);
        QCOMPARE(surface.layers[3].name, "Painted viscosity");
        QCOMPARE_EQ(surface.layers[3].strength, strengthParameter(TextureTarget::Viscosity).initial);
        QVERIFY(surface.layers[3].pattern == pattern);
        Surface other;
        putPattern(other, {0, false}, PaintGoal::StaticFriction, pattern);
        QCOMPARE(other.layers[0].name, "Painted static friction"); // in words, not by its key
        // Nowhere else.
        Surface same = before;
        putPattern(same, {3, false}, PaintGoal::Layer, pattern);
        putPattern(same, {4, false}, PaintGoal::Viscosity, pattern);
        putPattern(same, {-1, false}, PaintGoal::Layer, pattern);
        QVERIFY(same == before);
    }

    // A factor of nothing is nothing; a height is none.
    void whatScalesNothing() {
        Surface surface;
        surface.material.staticFriction = surface.material.dynamicFriction = surface.material.viscosity = 0;
        for (std::size_t i = 0; i < kPaintGoals.size(); ++i) {
            const auto goal = PaintGoal(i);
            const bool scales = goal == PaintGoal::StaticFriction || goal == PaintGoal::DynamicFriction ||
                                goal == PaintGoal::Viscosity;
            QCOMPARE(scalesNothing(surface, goal), scales);
        }
        surface.material.staticFriction = 0.1;
        QVERIFY(!scalesNothing(surface, PaintGoal::StaticFriction));
        QVERIFY(scalesNothing(surface, PaintGoal::DynamicFriction));
        surface.material.dynamicFriction = 0.1;
        QVERIFY(!scalesNothing(surface, PaintGoal::DynamicFriction));
        surface.material.viscosity = 0.1;
        QVERIFY(!scalesNothing(surface, PaintGoal::Viscosity));
    }
};

TACTUM_TEST(TestPaintGoal)

} // namespace test_paint_goal

#include "test_paint_goal.moc"
