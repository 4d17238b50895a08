// The proof that a step of the library neither allocates nor locks: no hit of the interposer.
#include <QTest>

#include "core/base/realtime.h"
#include "tests/app/library/plates.h"
#include "tests/realtime/interposer.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_library_realtime {

using namespace tactum;
using namespace tactum::test;

namespace {

lib::Step stepOf(lib::World& world, const lib::FingerPoint& point) {
    const RealtimeScope scope;
    return world.step(point.position);
}

} // namespace

class TestLibraryRealtime : public QObject {
    Q_OBJECT

private slots:
    void stepsOfASample_data() {
        QTest::addColumn<QString>("sample");
        for (const char* sample : {"teapot", "texture-wall", "moving/windmill"})
            QTest::newRow(sample) << QString(sample);
    }
    void stepsOfASample();
};

void TestLibraryRealtime::stepsOfASample() {
    QFETCH(QString, sample);
    lib::Scene scene =
        lib::Scene::open(std::filesystem::path(TACTUM_SCENES) / (sample.toStdString() + ".glb"));
    const auto path = scene.path();
    lib::World world(scene);
    interposer::reset();
    std::size_t touching = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        touching += stepOf(world, path[i]).contacts > 0;
        if (i % 500 != 250) continue;
        scene.set("stiffness", 400 + double(i % 100));
        world.update(scene); // which the next step takes over
        const RealtimeScope scope;
        world.step({0, std::numeric_limits<double>::quiet_NaN(), 0}, world.time());
        if (i % 1000 == 750) world.restart();
    }
    QVERIFY2(interposer::hits() == 0, interposer::firstHit().c_str());
    QCOMPARE_GT(touching, std::size_t(100));
}

TACTUM_TEST(TestLibraryRealtime)

} // namespace test_library_realtime

#include "test_library_realtime.moc"
