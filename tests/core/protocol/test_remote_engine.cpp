// An engine at a server, as a window uses it: real sockets on this machine, a plate, a finger that the test
// leads.
//
// What would show that a test here is wrong: forces are those of the spring, K times depth, as the device was
// sent them, and not as they are told.
#include <QTest>

#include "core/recording/player.h"
#include "tests/core/protocol/remote_window.h"
#include "tests/core/protocol/slow_link.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_remote_engine {

using namespace tactum;
using test::eventually;
using test::Guest;
using test::kDepth;
using test::Served;
using test::SlowLink;
using test::Window;

class TestRemoteEngine : public QObject {
    Q_OBJECT

private slots:
    void whatTheServerHasIsSeenAndFelt();
    void anEditIsFeltAndSendsNoShapes();
    void aLargeSceneIsUploaded();
    void whatOthersMakeArrives();
    void whatIsRefusedIsSaidAndGivenBack();
    void stopNeedsNoPen();
    void everyTickIsInTheTrace();
    void ordersArrive();
    void aServerThatDiesIsSaidAndTheNextKeepsItsScene();
    void theFlightRecorderIsTheServers();
    void aNetworkThatSwallowsIsLeft();
    void aSlowLinkOnlyDelays_data();
    void aSlowLinkOnlyDelays();
    void withoutAServerItSaysSo();
};

void TestRemoteEngine::whatTheServerHasIsSeenAndFelt() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QCOMPARE(window.engine.device().name, std::string("Probe"));
    QVERIFY(window.felt());
    QCOMPARE(window.scene.objects.size(), 1u);
    QCOMPARE(window.scene.objects[0].name, std::string("plate"));
    QCOMPARE_EQ(served.stage->scenery().revision, 1u); // looking at it changed nothing
    QVERIFY(window.engine.holdsPen());
    QVERIFY(window.press(served));
    QVERIFY(window.engine.armed());
    QVERIFY(window.sees(
        [&] { return std::abs(window.engine.servo().force.z() - kStiffness.initial * kDepth) < 1e-3; }));
    const HapticOutput& output = window.engine.proxy().output;
    QCOMPARE_EQ(output.contacts, 1);
    QCOMPARE_EQ(output.contact[0].body, 0u);
    COMPARE_NEAR(output.proxy.z(), kProxyRadius.initial, 1e-9, "m");
}

void TestRemoteEngine::anEditIsFeltAndSendsNoShapes() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(window.press(served));
    const auto before = served.stage->scenery();
    window.setStiffness(400);
    QVERIFY(window.felt());
    QVERIFY(window.sees([&] { return std::abs(served.push() - 400 * kDepth) < 1e-3; }));
    const auto after = served.stage->scenery();
    QCOMPARE_EQ(after.revision, before.revision + 1);
    QCOMPARE(after.scene->objects[0].geometry, before.scene->objects[0].geometry); // the very same
    QCOMPARE_EQ(after.world->shapeRevision, before.world->shapeRevision);          // so no contact was lost
    // A drag over a slider: the newest is felt, whatever was too quick to be sent.
    for (int i = 0; i < 200; ++i)
        window.setStiffness(500 + i);
    QVERIFY(window.sees([&] { return std::abs(served.push() - 699 * kDepth) < 1e-3; }));
    QCOMPARE(served.stage->scenery().scene->objects[0].surfaces[0].material.stiffness, 699.0);
}

void TestRemoteEngine::aLargeSceneIsUploaded() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    Scene next = window.scene;
    SceneObject ball;
    ball.name = "ball";
    ball.geometry = test::ball(0.02, 7); // 327,680 triangles, 17 MB
    ball.surfaces.resize(1);
    next.add(ball);
    window.publish(next);
    QVERIFY(window.felt());
    const auto scenery = served.stage->scenery();
    QCOMPARE(scenery.scene->objects.size(), 2u);
    QVERIFY(*scenery.scene->objects[1].geometry == *ball.geometry);
    QCOMPARE(window.refused, std::string());
}

void TestRemoteEngine::whatOthersMakeArrives() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", false).ok());
    QVERIFY(window.sees([&] { return window.engine.attending() == 2; }));
    v1::OrderRequest ask;
    ask.mutable_ask();
    QVERIFY(guest.order(ask).ok());
    std::optional<std::string> asked;
    QVERIFY(window.sees([&] { return (asked = window.engine.penAskedBy()).has_value(); }));
    QCOMPARE(*asked, std::string("guest"));
    window.engine.givePen("guest");
    QVERIFY(window.sees([&] { return window.engine.penHolder() == "guest"; }));
    QVERIFY(!window.engine.holdsPen());
    v1::Edit edit;
    edit.mutable_material()->set_stiffness(345);
    QVERIFY(guest.apply(edit).ok());
    QVERIFY(window.sees([&] { return window.scene.objects[0].surfaces[0].material.stiffness == 345; }));
    QVERIFY(window.felt());
    QCOMPARE_EQ(served.stage->scenery().revision, 2u); // it did not send back what it got
}

void TestRemoteEngine::whatIsRefusedIsSaidAndGivenBack() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Guest guest(served.target());
    QVERIFY(guest.attend("guest", true).ok());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(!window.engine.holdsPen());
    window.setStiffness(456);
    QVERIFY(window.sees([&] { return !window.refused.empty(); }));
    COMPARE_CONTAINS(window.refused, "guest has the pen");
    QVERIFY(window.sees([&] { return window.why == SharedScene::Arrival::Refused; }));
    QCOMPARE(window.scene.objects[0].surfaces[0].material.stiffness, kStiffness.initial);
    QVERIFY(window.felt());
    QCOMPARE_EQ(served.stage->scenery().revision, 1u);
    guest.leave();
    QVERIFY(window.sees([&] { return window.engine.penHolder().empty(); }));
    window.engine.askForPen();
    QVERIFY(window.sees([&] { return window.engine.holdsPen(); }));
    window.setStiffness(456);
    QVERIFY(window.sees(
        [&] { return served.stage->scenery().scene->objects[0].surfaces[0].material.stiffness == 456; }));
}

void TestRemoteEngine::stopNeedsNoPen() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window writer(served.target(), "writer"), reader(served.target(), "reader");
    VERIFY_RESULT(writer.engine.start());
    VERIFY_RESULT(reader.engine.start());
    QVERIFY(writer.felt());
    QVERIFY(writer.press(served));
    QVERIFY(reader.sees([&] { return reader.engine.armed(); }));
    reader.engine.setArmed(false);
    QVERIFY(reader.sees([&] { return served.push() == 0; }));
    QVERIFY(writer.sees([&] { return !writer.engine.armed(); }));
    reader.engine.setArmed(true); // that needs it
    QVERIFY(reader.sees([&] { return !reader.refused.empty(); }));
    QVERIFY(reader.sees([&] { return !reader.engine.armed(); }));
    QCOMPARE(served.push(), 0.0);
}

/// The plots have all that a window here has: states are sixty a second, ticks a thousand.
void TestRemoteEngine::everyTickIsInTheTrace() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    std::vector<TracePoint> trace;
    QVERIFY(window.sees([&] {
        for (TracePoint point; window.engine.popTrace(point);)
            trace.push_back(point);
        return trace.size() > 1000;
    }));
    const double first = trace.front().t, last = trace.back().t;
    for (std::size_t i = 1; i < trace.size(); ++i)
        QCOMPARE_LT(trace[i - 1].t, trace[i].t);
    // The servo puts each tick in: of a late one the time is longer, and none is missing.
    COMPARE_NEAR(last - first, 1e-3 * double(trace.size() - 1), 0.5 * (last - first), "s");
}

void TestRemoteEngine::ordersArrive() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    Workspace workspace;
    workspace.scale = 2.5;
    workspace.axes = {-2, 1, 3};
    workspace.offset = {0.01, 0.02, 0.03};
    VERIFY_RESULT(window.engine.setWorkspace(workspace));
    QVERIFY(window.engine.workspace() == workspace);
    window.engine.setPace(0.25);
    window.engine.setOverrideCeiling(true);
    const auto told = [&] {
        const ServoTelemetry& servo = window.engine.servo();
        return servo.frame.scale == 2.5 && servo.frame.axes == workspace.axes;
    };
    QVERIFY(window.sees(told));
    QTest::qWait(1100); // what was set is told for a second, whatever the server says
    window.frame();
    QCOMPARE(window.engine.pace(), 0.25);
    QVERIFY(window.engine.overridesCeiling());
    QVERIFY(window.engine.workspace() == workspace);
    workspace.axes = {1, 1, 3};
    QVERIFY(!window.engine.setWorkspace(workspace));
    QVERIFY(!window.engine.setDevice(nullptr));
}

void TestRemoteEngine::aServerThatDiesIsSaidAndTheNextKeepsItsScene() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    ServerSettings settings;
    settings.port = served.server->port();
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(window.press(served));
    window.setStiffness(321);
    QVERIFY(window.felt());
    served.server.reset();
    QVERIFY(window.sees([&] { return !window.engine.running(); }));
    COMPARE_CONTAINS(window.engine.trouble(), "It is tried again");
    QVERIFY(!window.engine.armed());
    QCOMPARE(window.engine.servo().gain, 0.0);
    QCOMPARE(window.engine.servo().force, Vec3::Zero().eval());
    Served next(settings); // a plate that somebody chose, with the stiffness that plates have
    QVERIFY(eventually([&] { return next.begin().empty(); })); // the port may be in use for a while
    QVERIFY(window.sees([&] { return window.engine.running(); }));
    QVERIFY(window.sees([&] { return window.why == SharedScene::Arrival::Another; }));
    QVERIFY(window.felt());
    QCOMPARE(window.scene.objects[0].surfaces[0].material.stiffness, kStiffness.initial);
    QCOMPARE_EQ(next.stage->scenery().revision, 1u);
    QVERIFY(!window.engine.armed()); // nobody has switched it on there
}

void TestRemoteEngine::theFlightRecorderIsTheServers() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(window.press(served));
    const RecordedRun run = window.engine.recorded();
    QCOMPARE(run.device.name, std::string("Probe"));
    QCOMPARE_GT(run.servo.rows.size(), 100u);
    QCOMPARE(run.scenes.size(), 1u);
    QCOMPARE(run.scenes[0].scene->objects[0].name, std::string("plate"));
}

/// No call ends there and no packet comes back: the silence is what tells, on both sides.
void TestRemoteEngine::aNetworkThatSwallowsIsLeft() {
    Served served;
    QCOMPARE(served.begin(), std::string());
    SlowLink link(served.server->port(), 0, 0);
    const auto hand = std::make_shared<HandTarget>();
    Window window("127.0.0.1:" + std::to_string(link.port()), "window", hand);
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(window.press(served));
    link.swallow();
    QVERIFY(eventually([&] { return served.push() == 0; })); // nobody answers for it any more
    double x = 0;
    QVERIFY(window.sees([&] { return !window.engine.running(); }));
    QVERIFY(window.sees([&] {
        hand->write({.position = {x += 1e-6, 0, 0}});
        return window.engine.running();
    }));
    QVERIFY(!window.engine.armed());
    window.setStiffness(432);
    QVERIFY(window.felt());
}

void TestRemoteEngine::aSlowLinkOnlyDelays_data() {
    QTest::addColumn<double>("delay"); // s, each way
    QTest::addColumn<double>("jitter");
    QTest::newRow("none") << 0.0 << 0.0;
    QTest::newRow("5 ms") << 0.005 << 0.0;
    QTest::newRow("50 ms") << 0.05 << 0.0;
    QTest::newRow("50 to 70 ms") << 0.05 << 0.02;
}

/// What the device was sent is, bit for bit, what the loops give without any network for the same finger and
/// the same edits, when they came: the recording steps through both again in this process.
void TestRemoteEngine::aSlowLinkOnlyDelays() {
    QFETCH(double, delay);
    QFETCH(double, jitter);
    Served served;
    QCOMPARE(served.begin(), std::string());
    const SlowLink link(served.server->port(), delay, jitter);
    Window window("127.0.0.1:" + std::to_string(link.port()));
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    QVERIFY(window.press(served));
    int lost = 0;
    for (int i = 0; i < 100; ++i) {
        window.setStiffness(300 + 2 * i);
        served.setHeight(kProxyRadius.initial - kDepth * (1 + 0.5 * std::sin(0.1 * i)));
        window.frame();
        lost += !window.engine.running();
        QTest::qWait(16);
    }
    QCOMPARE(lost, 0);
    served.setHeight(kProxyRadius.initial - kDepth);
    QVERIFY(window.sees([&] { return std::abs(served.push() - 498 * kDepth) < 1e-3; }));
    const auto run = std::make_shared<const RecordedRun>(window.engine.recorded());
    QCOMPARE_GT(run->scenes.size(), 4u);
    auto player = Player::open(run);
    VERIFY_RESULT(player);
    player->advanceTo(run->end());
    const ReplayCheck check = player->check();
    QVERIFY2(check.differ == 0, check.first.c_str());
    QCOMPARE_GT(check.servoSteps, 1000u);
    window.engine.setArmed(false);
    QVERIFY(window.sees([&] { return served.push() == 0; }));
}

void TestRemoteEngine::withoutAServerItSaysSo() {
    RemoteEngine engine({.target = "127.0.0.1:1", .patience = 0.3}, nullptr);
    const auto started = engine.start();
    QVERIFY(!started);
    COMPARE_CONTAINS(started.error().text, "No haptic server answers at 127.0.0.1:1");
    QVERIFY(!engine.running());
    QVERIFY(!engine.armed());
    engine.setArmed(true);
    QVERIFY(!engine.armed());
}

TACTUM_TEST(TestRemoteEngine)

} // namespace test_remote_engine

#include "test_remote_engine.moc"
