// What of an edit is felt, and when: at once, or from a worker while the window goes on.
//
// What would show that a test here is wrong: an engine that keeps every World it is given is asked for the
// values in them.
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/told_engine.h"
#include "ui/engine/world_publisher.h"

namespace test_world_publisher {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A document with one sheet of cells x cells squares, and who publishes it.
struct Bench {
    explicit Bench(int cells) {
        Scene scene;
        SceneObject object;
        object.name = "sheet";
        object.geometry = sheet(0.1, cells);
        object.surfaces.resize(1);
        scene.add(std::move(object));
        document.begin(std::move(scene));
        QTRY_VERIFY_WITH_TIMEOUT(!publisher.working() && !engine.worlds.empty(), 0);
        surface = {document.scene().objects[0].id, 0};
    }

    void paint(float value) {
        const std::size_t count = document.scene().objects[0].geometry->positions.size();
        const auto values = std::make_shared<const PaintedValues>(std::vector<float>(count, value));
        document.editSurfaces(surface, SceneChange::What::Layers, QStringLiteral("Paint"),
                              [&](Surface& each) {
                                  each.layers.resize(1);
                                  each.layers[0].pattern.source = TextureSource::Painted;
                                  each.layers[0].pattern.painted.values = values;
                              });
    }
    /// At the first position of the newest World; negative: nothing is painted there.
    double felt() const {
        const auto& stack = engine.worlds.back()->bodies[0].textures[0];
        return stack ? (*stack->layers[0].pattern.painted)[0] : -1;
    }
    double feltStiffness() const { return engine.worlds.back()->bodies[0].materials[0].stiffness; }
    void makeStiffer(double stiffness) { document.setMaterialValue(surface, kMaterialFields[0], stiffness); }
    bool rests() {
        return waitFor([this] { return !publisher.working(); });
    }

    Document document;
    ToldEngine engine;
    WorldPublisher publisher{document, engine};
    SurfaceRef surface;
};

constexpr int kSmall = 10, kLarge = 120; // cells: 200 and 28,800 triangles

} // namespace

class TestWorldPublisher : public QObject {
    Q_OBJECT

private slots:
    void whatIsPaintedOnASmallMeshIsFeltAtOnce() {
        Bench bench(kSmall);
        bench.paint(0.25F);
        QVERIFY(!bench.publisher.working());
        QCOMPARE_EQ(bench.felt(), 0.25);
    }

    // To make it smooth takes longer than a frame.
    void whatIsPaintedOnALargeMeshComesFromAWorker() {
        Bench bench(kLarge);
        const std::size_t before = bench.engine.worlds.size();
        QSignalSpy shapes(&bench.publisher, &WorldPublisher::shapesPublished);
        bench.paint(0.25F);
        QVERIFY(bench.publisher.working());
        QCOMPARE(bench.engine.worlds.size(), before);
        QVERIFY(bench.rests());
        QCOMPARE_EQ(bench.felt(), 0.25);
        QCOMPARE(shapes.size(), 0);
        QCOMPARE_EQ(bench.engine.worlds.back()->shapeRevision,
                    bench.engine.worlds[before - 1]->shapeRevision);
    }

    // What is painted stays as it is: nothing has to be made smooth.
    void aMaterialOfAPaintedMeshIsFeltAtOnce() {
        Bench bench(kLarge);
        bench.paint(0.25F);
        QVERIFY(bench.rests());
        bench.makeStiffer(1234);
        QVERIFY(!bench.publisher.working());
        QCOMPARE_EQ(bench.feltStiffness(), 1234);
        QCOMPARE_EQ(bench.felt(), 0.25);
    }

    // A stroke goes on while its beginning is worked out: that is felt meanwhile, and the end at last.
    void whatIsEditedMeanwhileIsCaughtUp() {
        Bench bench(kLarge);
        const std::size_t before = bench.engine.worlds.size();
        bench.paint(0.25F);
        bench.paint(0.5F);
        bench.makeStiffer(1234);
        bench.paint(0.75F);
        QCOMPARE(bench.engine.worlds.size(), before);
        QVERIFY(bench.rests());
        QCOMPARE(bench.engine.worlds.size(), before + 2);
        QCOMPARE_EQ((*bench.engine.worlds[before]->bodies[0].textures[0]->layers[0].pattern.painted)[0],
                    0.25);
        QCOMPARE_EQ(bench.felt(), 0.75);
        QCOMPARE_EQ(bench.feltStiffness(), 1234);
    }

    // One that was taken back while it was worked out is not felt in the end.
    void whatIsUndoneMeanwhileIsNotFelt() {
        Bench bench(kLarge);
        bench.paint(0.25F);
        bench.document.history().undo();
        QVERIFY(bench.rests());
        QCOMPARE_EQ(bench.felt(), -1);
    }
};

TACTUM_TEST(TestWorldPublisher)

} // namespace test_world_publisher

#include "test_world_publisher.moc"
