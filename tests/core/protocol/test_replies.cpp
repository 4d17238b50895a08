// What a client is told, field by field: a message says all that the server knows, and each thing in its own
// place. Every number here is another one, so that two that change places show.
// What would show that the test itself is wrong: a field of tactum.proto that stands in none of the texts.
#include <QTest>

#include "core/protocol/replies.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_replies {

using namespace tactum;
using namespace tactum::test;

namespace {

template <class Message> QString textOf(const Message& message) {
    return QString::fromStdString(message.DebugString());
}

StageState everything() {
    StageState state;
    state.at = 1;
    state.revision = 2;
    StageHand hand;
    HapticOutput& output = hand.touch.output;
    output.proxy = {3, 4, 5};
    output.contacts = 2;
    output.contact[0].surface = 6;
    output.contact[0].point = {7, 8, 9};
    output.contact[0].normal = {0, 0.6, 0.8};
    output.contact[0].normalForce = 10;
    output.contact[0].slipping = true;
    output.contact[1].surface = 11;
    hand.objects = {12, 13};
    state.bodies = {{14, {Quat(0.5, -0.5, 0.5, -0.5), {15, 16, 17}}}};
    hand.servo.finger = {18, 19, 20};
    hand.servo.force = {21, 22, 23};
    hand.servo.buttons = 24;
    hand.servo.gain = 0.25;
    hand.servo.inhibit = InhibitReason::DeadMan;
    hand.servo.rate = 26;
    hand.servo.ticks = 27;
    hand.servo.misses = 28;
    hand.servo.machineMisses = 29;
    state.engine.world.rate = 30;
    hand.armed = true;
    hand.trouble = "unplugged";
    state.hands = {hand, hand};
    state.hands[1].servo.finger = {31, 32, 33};
    state.hands[1].touch.output.contacts = 1;
    state.hands[1].objects = {34};
    return state;
}

} // namespace

class TestReplies : public QObject {
    Q_OBJECT

private slots:
    void aStateSaysAllThatIsKnown() {
        v1::State all, none;
        write(all, everything(), true);
        StageState nothing;
        nothing.hands.resize(1);
        write(none, nothing, true);
        COMPARE_SHOWN(textOf(all) + "---\n" + textOf(none), "state");
    }

    void placesOfBodiesAreForThoseWhoAsk() {
        v1::State with, without;
        write(with, everything(), true);
        write(without, everything(), false);
        QCOMPARE(with.body_size(), 1);
        QCOMPARE(without.body_size(), 0);
        with.clear_body();
        QCOMPARE(textOf(without), textOf(with));
    }

    void anEventSaysWhatWhenAndWhere() {
        v1::Event event;
        StageEvent happened{StageEvent::Kind::Pressed};
        happened.at = 1;
        happened.hand = 7;
        happened.object = 2;
        happened.button = 3;
        happened.revision = 4;
        happened.text = "five";
        happened.detent = 6;
        write(event, happened);
        COMPARE_SHOWN(textOf(event), "event");
    }

    void aDeviceSaysWhatItCan() {
        DeviceInfo device;
        device.name = "a device";
        device.real = true;
        device.maxForce = 1;
        device.workspaceRadius = 2;
        device.rate = 3;
        device.buttons = 4;
        v1::Device told;
        write(told, device);
        COMPARE_SHOWN(textOf(told), "device");
    }

    void aSceneSaysHowItsSurfacesFeel() {
        Surface surface;
        surface.name = "skin";
        surface.material.stiffness = 1;
        surface.material.damping = 2;
        surface.material.staticFriction = 3;
        surface.material.dynamicFriction = 4;
        surface.material.viscosity = 5;
        surface.shading.on = true;
        surface.layers.resize(2);
        SceneObject object;
        object.id = 6;
        object.name = "thing";
        object.pose = {Quat(0, 1, 0, 0), {7, 8, 9}};
        object.visible = false;
        object.surfaces = {surface};
        Scene scene;
        scene.proxyRadius = 10;
        scene.objects = {object};
        Stage::Scenery scenery;
        scenery.revision = 11;
        scenery.scene = std::make_shared<const Scene>(scene);
        v1::SceneDescription told;
        write(told, scenery);
        COMPARE_SHOWN(textOf(told), "scene");
    }

    void anErrorSaysWhoseItIs() {
        const grpc::Status ours = statusOf({Error::Kind::Machine, "full"}),
                           theirs = statusOf({Error::Kind::Input, "wrong"});
        QCOMPARE(ours.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
        QCOMPARE(ours.error_message(), std::string("full"));
        QCOMPARE(theirs.error_code(), grpc::StatusCode::FAILED_PRECONDITION);
        QCOMPARE(theirs.error_message(), std::string("wrong"));
    }
};

TACTUM_TEST(TestReplies)

} // namespace test_replies

#include "test_replies.moc"
