// A World of the library, step by step and beside a thread that changes what it is made of.
#include <atomic>
#include <limits>
#include <thread>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/keyed_pusher.h"
#include "tests/app/library/plates.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_library_world {

using namespace tactum;
using namespace tactum::test;

namespace {

/// What an animation leads past, and a finger that goes along from t = 1 s on and presses on it.
lib::Scene ledPast(const QTemporaryDir& folder) {
    QFile file(folder.filePath("led.gltf"));
    if (!file.open(QFile::WriteOnly) || file.write(test_program::keyedPusher()) < 0) return {};
    file.close();
    lib::Scene scene = lib::Scene::open(file.fileName().toStdString());
    std::vector<lib::FingerPoint> path;
    for (int i = 0; i < 200; ++i)
        path.push_back({1 + 1e-3 * i, {1e-3 * i + 0.03, 0.03, 0.01 - 6e-5 * i}});
    scene.setPath(path);
    return scene;
}

/// The same path by touch() and by steps.
void compareSteps(const lib::Scene& scene, const std::vector<lib::FingerPoint>& path) {
    const auto rows = scene.touch(path);
    lib::World world(scene);
    world.restart(path.front().t - 1e-3);
    for (std::size_t i = 0; i < path.size(); ++i) {
        const lib::Step step = world.step(path[i].position, i ? path[i].t - path[i - 1].t : 1e-3);
        QCOMPARE(eigen(step.force), eigen(rows[i].force));
        QCOMPARE(eigen(step.proxy), eigen(rows[i].proxy));
        QCOMPARE(step.contacts, rows[i].contacts);
        QCOMPARE(step.touched().size(), std::size_t(step.contacts));
    }
}

lib::Step pressed(lib::World& world) {
    lib::Step last;
    for (const lib::FingerPoint& point : press())
        last = world.step(point.position);
    return last;
}

} // namespace

class TestLibraryWorld : public QObject {
    Q_OBJECT

private slots:
    void stepsAreThoseOfATouch() {
        compareSteps(plate(), press());
        const lib::Scene mill =
            lib::Scene::open(std::filesystem::path(TACTUM_SCENES) / "moving/windmill.glb");
        compareSteps(mill, mill.path());
        const QTemporaryDir folder;
        const lib::Scene led = ledPast(folder);
        compareSteps(led, led.path());
        QCOMPARE(led.touch().back().contacts, 1U); // only where restart() says the time
    }
    void tellsWhatIsTouched();
    void whatCannotBeChangesNothing_data();
    void whatCannotBeChangesNothing();
    void takesTheVelocityThatIsGiven();
    void beginsAnew();
    void anEditIsFeltWithoutAJump();
    void isChangedBesideItsSteps();
    void oneThatWasMovedFromGivesNoForce();
};

void TestLibraryWorld::tellsWhatIsTouched() {
    const lib::Scene scene = plate(500);
    lib::World world(scene);
    const lib::Step step = pressed(world);
    QCOMPARE(step.contacts, 1U);
    QCOMPARE(step.contact[0].object, scene.object("plate").id());
    QCOMPARE(step.contact[0].surface, 0U);
    QVERIFY(step.contact[0].frictionless);
    COMPARE_NEAR(eigen(step.contact[0].normal), Vec3(0, 1, 0), 1e-12, "");
    COMPARE_NEAR(step.contact[0].normalForce, 500 * 0.003, 1e-6, "N");
    COMPARE_NEAR(step.time, 0.2, 1e-12, "s");
    QCOMPARE(world.time(), step.time);
}

void TestLibraryWorld::whatCannotBeChangesNothing_data() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                     kMost = std::numeric_limits<double>::max();
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("dt");
    for (const double height : {kNan, std::numeric_limits<double>::infinity(), -kMost, 1.1e6})
        QTest::addRow("height %g", height) << height << 1e-3;
    for (const double dt : {kNan, 0.0, -1e-3, 1e-7, 2.0})
        QTest::addRow("dt %g", dt) << 0.001 << dt;
}

void TestLibraryWorld::whatCannotBeChangesNothing() {
    QFETCH(double, height);
    QFETCH(double, dt);
    const lib::Scene scene = plate();
    lib::World disturbed(scene), calm(scene);
    pressed(disturbed);
    pressed(calm);
    const lib::Step none = disturbed.step({0, height, 0}, dt);
    QCOMPARE(eigen(none.force), Vec3(0, 0, 0));
    QCOMPARE(none.contacts, 0U);
    QVERIFY(std::isfinite(none.proxy.y));
    QVERIFY(disturbed.step({0.01, -0.001, 0}) == calm.step({0.01, -0.001, 0}));
}

void TestLibraryWorld::takesTheVelocityThatIsGiven() {
    lib::Scene scene = plate(500);
    scene.set("damping", 2);
    lib::World still(scene), fast(scene);
    pressed(still);
    pressed(fast);
    const lib::Vec3 at = press().back().position;
    const double difference =
        fast.step(at, {0, -0.1, 0}, 1e-3).force.y - still.step(at, {0, 0, 0}, 1e-3).force.y;
    COMPARE_NEAR(difference, 2 * 0.1, 1e-9, "N");
    constexpr double kMost = std::numeric_limits<double>::max();
    QCOMPARE(fast.step(at, {0, -kMost, 0}, 1e-3).force, lib::Vec3());
    QCOMPARE(fast.step(at, {0, std::numeric_limits<double>::quiet_NaN(), 0}, 1e-3).force, lib::Vec3());
}

void TestLibraryWorld::beginsAnew() {
    lib::World world(plate());
    const lib::Step first = pressed(world);
    world.restart();
    QCOMPARE(world.time(), 0.0);
    QVERIFY(pressed(world) == first);
}

void TestLibraryWorld::anEditIsFeltWithoutAJump() {
    lib::Scene scene = plate(500);
    scene.set("static-friction", 0.5);
    lib::World world(scene);
    const lib::Step before = pressed(world);
    scene.set("stiffness", 1000);
    world.update(scene);
    world.update(scene); // one that no step saw
    const lib::Step after = world.step(before.finger);
    QCOMPARE(after.contacts, 1U);
    COMPARE_NEAR(after.force.y, 2 * before.force.y, 1e-6, "N");
    COMPARE_NEAR(eigen(after.proxy), eigen(before.proxy), 1e-6, "m");
    lib::Scene moved;
    COMPARE_BEGINS(sentenceOf([&] {
                       const lib::Scene elsewhere = std::move(moved);
                       world.update(moved);
                   }),
                   "this scene was moved elsewhere");
    QVERIFY(world.step(before.finger).contacts == 1); // the one before stays
}

void TestLibraryWorld::isChangedBesideItsSteps() {
    lib::Scene scene = plate(500);
    lib::World world(scene);
    pressed(world);
    std::atomic<double> felt = 0;
    {
        std::jthread loop([&](const std::stop_token& stop) {
            while (!stop.stop_requested())
                felt = world.step({0, -0.001, 0}).force.y;
        });
        for (int i = 0; i < 200; ++i) {
            scene.set("stiffness", 500 + i);
            world.update(scene);
        }
        const double last = 699 * 0.002;
        for (Patience patience; std::abs(felt - last) > 1e-6 && !patience.isOver();)
            std::this_thread::yield();
        COMPARE_NEAR(felt.load(), last, 1e-6, "N");
    }
}

void TestLibraryWorld::oneThatWasMovedFromGivesNoForce() {
    lib::World world(plate());
    const lib::World elsewhere = std::move(world);
    QCOMPARE(world.step({0, -0.001, 0}).force, lib::Vec3());
    world.restart();
    QCOMPARE(world.time(), 0.0);
    COMPARE_BEGINS(sentenceOf([&] { world.update(plate()); }), "this World was moved elsewhere");
}

TACTUM_TEST(TestLibraryWorld)

} // namespace test_library_world

#include "test_library_world.moc"
