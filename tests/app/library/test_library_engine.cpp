// The whole engine through the library: the simulated hand, an edit that is published, and what cannot be.
#include <limits>

#include <QTest>

#include "tests/app/library/plates.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"

namespace test_library_engine {

using namespace tactum;
using namespace tactum::test;

class TestLibraryEngine : public QObject {
    Q_OBJECT

private slots:
    void anEditIsFeltWhileTheHandPresses();
    void forceIsOffUntilItIsArmed();
    void worksOnAfterItWasClosed();
    void listsTheSimulatedHand();
    void eachOfTwoHandsFeelsWhatItTouches();
    void refusesWhatCannotBe();
};

void TestLibraryEngine::anEditIsFeltWhileTheHandPresses() {
    lib::Scene scene = plate(200);
    lib::Engine engine;
    engine.publish(scene);
    engine.open();
    engine.arm();
    engine.leadHand({0, -0.01, 0}, 0.2);
    lib::EngineState state;
    QTRY_VERIFY((state = engine.state()).gain == 1 && state.contacts == 1 && state.force.y > 1);
    QCOMPARE(state.contact[0].object, 1U);
    QCOMPARE(std::string(state.why), "full force");
    QVERIFY(!state.fault);
    QCOMPARE_LT(state.finger.y, state.proxy.y);
    // Three times as stiff: the hand, a spring of its own, is pushed out of it.
    const double deep = state.finger.y;
    scene.set("stiffness", 600);
    engine.publish(scene);
    QTRY_VERIFY((state = engine.state()).finger.y > deep + 1e-3);
    QCOMPARE(state.contact[0].object, 1U);
    engine.close();
    QVERIFY(!engine.isOpen());
}

void TestLibraryEngine::forceIsOffUntilItIsArmed() {
    lib::Engine engine;
    engine.publish(plate());
    engine.open();
    engine.leadHand({0, -0.01, 0});
    lib::EngineState state;
    QTRY_VERIFY((state = engine.state()).contacts == 1 && state.updates > 0);
    QVERIFY(!engine.armed());
    QCOMPARE(state.force, lib::Vec3());
    QCOMPARE(std::string(state.why), "forces off");
    engine.arm();
    QTRY_VERIFY(engine.state().force.y > 0);
    engine.arm(false);
    QTRY_VERIFY(engine.state().force == lib::Vec3());
}

void TestLibraryEngine::worksOnAfterItWasClosed() {
    lib::Engine engine;
    engine.close(); // nothing
    engine.open();
    QVERIFY(engine.isOpen());
    QTRY_VERIFY(engine.state().ticks > 0);
    engine.close();
    engine.close();
    lib::Engine moved = std::move(engine);
    moved.open();
    moved.place({.scale = 2, .offset = {0.1, 0, 0}});
    moved.leadHand({0.02, 0, 0});
    QTRY_VERIFY(std::abs(moved.state().finger.x - 0.14) < 1e-6);
}

void TestLibraryEngine::listsTheSimulatedHand() {
    const auto all = lib::devices();
    QVERIFY(!all.empty());
    QVERIFY(
        std::ranges::any_of(all, [](const lib::Device& one) { return one.id == "simulated" && one.usable; }));
    for (const lib::Device& one : all)
        QVERIFY(!one.sentence.empty());
    QCOMPARE(lib::Engine().maxForce(), 8.0);
    QVERIFY(!lib::Engine().deviceName().empty());
    QVERIFY(!lib::Engine().priority().empty());
    QCOMPARE(lib::Engine().trouble(), "");
}

// Where they come to rest the plate's spring is in balance with each hand's own, of 250 N/m.
void TestLibraryEngine::eachOfTwoHandsFeelsWhatItTouches() {
    constexpr double kPlate = 200, kHand = 250, kRadius = 1e-3, kExact = 0.02;
    const std::array<double, 2> goals{-0.01, -0.005};
    const lib::Scene scene = plate(kPlate);
    lib::Engine engine;
    engine.addHand("simulated");
    QCOMPARE(engine.hands(), std::size_t(2));
    engine.publish(scene);
    engine.open();
    engine.arm();
    std::array<double, 2> wanted{};
    for (std::size_t i = 0; i < 2; ++i) {
        engine.hand(i).lead({0.01 * double(i), goals[i], 0}, 0.2);
        wanted[i] = kPlate * (kRadius - goals[i]) * kHand / (kHand + kPlate);
    }
    std::array<lib::EngineState, 2> states;
    QTRY_VERIFY(std::ranges::all_of(std::array{0, 1}, [&](int hand) {
        const auto i = std::size_t(hand);
        states[i] = engine.hand(i).state();
        return states[i].gain == 1 && std::abs(states[i].force.y / wanted[i] - 1) < kExact;
    }));
    QCOMPARE(states[1].contacts, 1U);
    QCOMPARE(states[1].contact[0].object, 1U);
    QCOMPARE(std::string(states[1].why), "full force");
    COMPARE_NEAR(states[1].finger.x, 0.01, 1e-4, "m");
    QCOMPARE(engine.hand(1).deviceName(), engine.deviceName());
    engine.hand(1).arm(false);
    QTRY_VERIFY(engine.hand(1).state().force == lib::Vec3());
    QVERIFY(engine.armed() && !engine.hand(1).armed());
    QVERIFY(engine.state().force.y > 0);
    engine.arm(false);
    QTRY_VERIFY(engine.state().force == lib::Vec3());
}

void TestLibraryEngine::refusesWhatCannotBe() {
    COMPARE_CONTAINS(sentenceOf([] { lib::Engine engine("falcon"); }), "falcon");
    COMPARE_CONTAINS(sentenceOf([] { lib::Engine engine("nothing"); }), "There is no device \"nothing\"");
    lib::Engine engine;
    QVERIFY(sentenceOf([&] { engine.place({.scale = 0, .offset = {}}); }) != "nothing was thrown");
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(sentenceOf([&] { engine.push({kNan, 0, 0}); }), "force: is not finite");
    QCOMPARE(sentenceOf([&] {
                 engine.leadHand({0, kNan, 0});
             }),
             "leadHand: wants a place within 1e6 m, and from 0 to 3600 s");
    COMPARE_CONTAINS(sentenceOf([&] { (void)engine.hand(1); }), "there is no hand 1");
    COMPARE_CONTAINS(sentenceOf([&] { engine.addHand("nothing"); }), "There is no device \"nothing\"");
    const lib::Engine elsewhere = std::move(engine);
    COMPARE_BEGINS(sentenceOf([&] { engine.open(); }), "this Engine was moved elsewhere");
    COMPARE_BEGINS(sentenceOf([&] { engine.state(); }), "this Engine was moved elsewhere");
}

TACTUM_TEST(TestLibraryEngine)

} // namespace test_library_engine

#include "test_library_engine.moc"
