// One scene for several clients: what the device gets when they edit, stop, fall silent or leave.
#include <atomic>
#include <thread>

#include <QTest>

#include "core/scene/bodies.h"
#include "core/session/stage.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/runtime/probe_device.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_stage {

using namespace tactum;

namespace {

constexpr double kRadius = 1e-3, kDepth = 1e-3, kStiffness = 800;

Scene plateScene() {
    Scene scene;
    scene.proxyRadius = kRadius;
    SceneObject object;
    object.geometry = test::sheet(0.1);
    object.surfaces.resize(1);
    object.surfaces[0].material.stiffness = kStiffness;
    scene.add(object);
    return scene;
}

Result<void> setStiffness(Scene& scene, double stiffness) {
    scene.objects[0].surfaces[0].material.stiffness = stiffness;
    return {};
}

/// A stage over a plate, with a finger that rests inside of it, and one client that has the pen.
struct TouchedStage {
    std::shared_ptr<Probe> probe = std::make_shared<Probe>();
    std::mutex mutex;
    StageState newest;
    std::vector<StageEvent> events;
    Stage::Welcome writer;
    Stage stage{std::make_unique<ProbeDevice>(probe), nullptr, plateScene()}; ///< last: it ends first

    bool begin() {
        if (!stage.start()) return false;
        stage.listen([this](const StageState& state, std::span<const StageEvent> told) {
            const std::lock_guard lock(mutex);
            newest = state;
            events.insert(events.end(), told.begin(), told.end());
        });
        auto joined = stage.join("writer", true);
        if (!joined) return false;
        writer = *joined;
        return true;
    }
    /// The finger goes in, the force is on and all there.
    bool press() {
        if (!begin() || !stage.arm(writer.id, true)) return false;
        return beating([&] { return servo().gain == 1; }) && beating([&] {
                   probe->height = kRadius - kDepth;
                   return std::abs(probe->push - kStiffness * kDepth) < 1e-3;
               });
    }
    /// Of the hand, once something was told.
    ServoTelemetry servo() {
        const StageState now = state();
        return now.hands.empty() ? ServoTelemetry{} : now.hands[0].servo;
    }
    StageState state() {
        const std::lock_guard lock(mutex);
        return newest;
    }
    bool said(StageEvent::Kind kind, const std::string& part = {}) {
        const std::lock_guard lock(mutex);
        return std::ranges::any_of(events, [&](const StageEvent& event) {
            return event.kind == kind && event.text.find(part) != std::string::npos;
        });
    }
    /// Waits while the writer's heart beats.
    template <class Condition> bool beating(Condition condition) {
        return test::eventually([&] {
            stage.heard(writer.id);
            return condition();
        });
    }
};

} // namespace

class TestStage : public QObject {
    Q_OBJECT

private slots:
    void anEditIsFelt();
    void aRefusedEditChangesNothing();
    void staleEditsAreRefused();
    void editsOfManyThreadsAreAllMade();
    void onlyThePenHolderEdits();
    void anybodyStopsTheForce();
    void silenceFadesTheForce();
    void leavingFadesTheForce();
    void contactsAndRevisionsAreEvents();
    void aMotorGoesFromDetentToDetent();
};

void TestStage::anEditIsFelt() {
    TouchedStage touched;
    QVERIFY(touched.press());
    const auto before = touched.stage.scenery().revision;
    const auto done =
        touched.stage.change(touched.writer.id, 0, [](Scene& scene) { return setStiffness(scene, 400); });
    VERIFY_RESULT(done);
    QCOMPARE_EQ(done->revision, before + 1);
    QVERIFY(touched.beating([&] { return std::abs(touched.probe->push - 400 * kDepth) < 1e-3; }));
    QCOMPARE_EQ(touched.state().revision, done->revision);
}

void TestStage::aRefusedEditChangesNothing() {
    TouchedStage touched;
    QVERIFY(touched.begin());
    const auto before = touched.stage.scenery();
    const auto done = touched.stage.change(touched.writer.id, 0, [](Scene& scene) {
        scene.objects.clear();
        return Result<void>(inputError("edit 2: is wrong"));
    });
    QCOMPARE(test::refusal(done), std::string("edit 2: is wrong"));
    QVERIFY(touched.stage.scenery().scene == before.scene);
    QCOMPARE_EQ(touched.stage.scenery().revision, before.revision);
}

void TestStage::staleEditsAreRefused() {
    TouchedStage touched;
    QVERIFY(touched.begin());
    const auto seen = touched.stage.scenery().revision;
    const auto edit = [](Scene& scene) { return setStiffness(scene, 500); };
    VERIFY_RESULT(touched.stage.change(touched.writer.id, seen, edit));
    COMPARE_CONTAINS(test::refusal(touched.stage.change(touched.writer.id, seen, edit)), "look at it again");
    VERIFY_RESULT(touched.stage.change(touched.writer.id, 0, edit));
}

// Each adds its share to one number: none may be lost, whoever was quicker.
void TestStage::editsOfManyThreadsAreAllMade() {
    TouchedStage touched;
    QVERIFY(touched.begin());
    constexpr int kThreads = 4, kEdits = 50;
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < kEdits; ++k)
                (void)touched.stage.change(touched.writer.id, 0, [](Scene& scene) {
                    return setStiffness(scene, scene.objects[0].surfaces[0].material.stiffness + 1);
                });
        });
    for (std::thread& thread : threads)
        thread.join();
    QCOMPARE_EQ(touched.stage.scenery().scene->objects[0].surfaces[0].material.stiffness,
                kStiffness + kThreads * kEdits);
}

void TestStage::onlyThePenHolderEdits() {
    TouchedStage touched;
    QVERIFY(touched.begin());
    const auto other = touched.stage.join("other", true).value();
    const auto edit = [](Scene& scene) { return setStiffness(scene, 500); };
    COMPARE_CONTAINS(test::refusal(touched.stage.change(other.id, 0, edit)), "writer has the pen");
    QVERIFY(!touched.stage.arm(other.id, true));
    VERIFY_RESULT(touched.stage.askForPen(other.id));
    QVERIFY(!touched.stage.hasPen(other.id)); // asking is not taking
    VERIFY_RESULT(touched.stage.passPen(touched.writer.id, "other"));
    VERIFY_RESULT(touched.stage.change(other.id, 0, edit));
    QVERIFY(!touched.stage.change(touched.writer.id, 0, edit));
    QVERIFY(test::eventually([&] { return touched.said(StageEvent::Kind::PenAsked, "other"); }));
}

void TestStage::anybodyStopsTheForce() {
    TouchedStage touched;
    QVERIFY(touched.press());
    const auto other = touched.stage.join("other", false).value();
    touched.stage.stop(other.id);
    QVERIFY(touched.beating([&] { return touched.probe->push == 0; }));
    QVERIFY(!touched.stage.armed());
    QVERIFY(touched.beating([&] { return touched.said(StageEvent::Kind::Force, "other has stopped"); }));
}

// Nobody beats: after three heartbeats the force goes down bit by bit, over 0.3 s, and not at once. A machine
// that is busy may take it away before: that is for the gate's tests, and here it still has to stay away.
void TestStage::silenceFadesTheForce() {
    TouchedStage touched;
    QVERIFY(touched.press());
    const std::uint64_t pauses = touched.servo().pauses;
    const std::size_t pressed = touched.probe->log.size();
    QVERIFY(test::eventually([&] { return !touched.stage.armed() && touched.probe->push == 0; }));
    QVERIFY(!touched.stage.hasPen(touched.writer.id));
    const std::size_t gone = touched.probe->log.size();
    QVERIFY(test::eventually([&] {
        const ServoTelemetry servo = touched.servo();
        return servo.inhibit == InhibitReason::NotArmed && servo.gain == 0;
    }));
    if (touched.servo().pauses != pauses) return;
    const double full = kStiffness * kDepth;
    double falling = 0, silent = 0, borders = 0, steepest = 0, last = full;
    for (std::size_t i = pressed; i < gone; ++i) {
        const auto [force, dt] = touched.probe->log[i];
        const bool isFull = force.z() > 0.999 * full, wasFull = last > 0.999 * full;
        if (isFull)
            silent += dt;
        else if (wasFull || (force.z() == 0 && last > 0))
            borders += dt; // the fall began or ended in it
        else if (force.z() > 0)
            falling += dt;
        // Device and servo look at the clock apart: what is late is late for one of them a tick before.
        double length = dt;
        for (const std::size_t beside : {i - 1, i + 1})
            if (beside > pressed && beside < gone) length = std::max(length, touched.probe->log[beside].dt);
        steepest = std::max(steepest, (last - force.z()) / full - length / kFadeAway);
        last = force.z();
    }
    QCOMPARE_GT(silent, 0.9 * kSilence);
    QCOMPARE_LT(falling, kFadeAway + 0.05);
    QCOMPARE_GT(falling + borders, kFadeAway - 0.05);
    QCOMPARE_LT(steepest, 0.02); // of the force in a tick, beyond what its length explains
}

void TestStage::leavingFadesTheForce() {
    TouchedStage touched;
    QVERIFY(touched.press());
    touched.stage.leave(touched.writer.id);
    QVERIFY(test::eventually([&] { return touched.probe->push == 0; }));
    QVERIFY(!touched.stage.armed());
    QCOMPARE_EQ(touched.stage.attending(), std::size_t(0));
}

void TestStage::contactsAndRevisionsAreEvents() {
    TouchedStage touched;
    QVERIFY(touched.press());
    const ObjectId plate = touched.stage.scenery().scene->objects[0].id;
    QVERIFY(touched.beating([&] { return touched.said(StageEvent::Kind::Touch); }));
    touched.probe->height = 0.05;
    QVERIFY(touched.beating([&] { return touched.said(StageEvent::Kind::Leave); }));
    const std::lock_guard lock(touched.mutex);
    for (const StageEvent& event : touched.events)
        if (event.kind == StageEvent::Kind::Touch) QCOMPARE_EQ(event.object, plate);
}

// A dial that its motor turns over its detents, one way: each is told once, in their order, with the dial's
// name. The test is wrong if the dial stands still or jumps, for then no number would follow another.
void TestStage::aMotorGoesFromDetentToDetent() {
    TouchedStage touched;
    QVERIFY(touched.begin());
    ObjectId dial = 0;
    const auto made = touched.stage.change(touched.writer.id, 0, [&](Scene& scene) -> Result<void> {
        SceneObject object;
        object.geometry = test::ball(0.01, 1);
        object.surfaces.resize(1);
        object.pose.translation = {0, 0.5, 0};
        dial = scene.add(object).id;
        const BodyId body = makeBody(scene, dial);
        AxisJoint joint;
        joint.at = object.pose.translation;
        joint.speed = 20, joint.strength = 1; // rad/s, N m
        joint.spacing = 0.5, joint.detent = 1e-5;
        setAxisJoint(scene, body, joint);
        return {};
    });
    VERIFY_RESULT(made);
    const auto told = [&] {
        const std::lock_guard lock(touched.mutex);
        std::vector<StageEvent> found;
        for (const StageEvent& event : touched.events)
            if (event.kind == StageEvent::Kind::Detent) found.push_back(event);
        return found;
    };
    touched.beating([&] { return told().size() >= 10; });
    const std::vector<StageEvent> all = told();
    QCOMPARE_GE(all.size(), std::size_t(10));
    for (std::size_t i = 0; i < all.size(); ++i) {
        QCOMPARE_EQ(all[i].object, dial);
        QCOMPARE_EQ(all[i].detent, all[0].detent + int(i));
    }
}

TACTUM_TEST(TestStage)

} // namespace test_stage

#include "test_stage.moc"
