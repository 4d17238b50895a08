#include "core/protocol/replies.h"

#include <algorithm>

#include "core/safety/inhibit_words.h"

namespace tactum {
namespace {

void write(v1::Vector* to, const Vec3& v) {
    to->set_x(v.x());
    to->set_y(v.y());
    to->set_z(v.z());
}

void write(v1::Pose* to, const Pose& pose) {
    write(to->mutable_position(), pose.translation);
    v1::Rotation* turn = to->mutable_rotation();
    turn->set_w(pose.rotation.w());
    turn->set_x(pose.rotation.x());
    turn->set_y(pose.rotation.y());
    turn->set_z(pose.rotation.z());
}

void write(v1::Contact* to, const ContactReport& contact, ObjectId object) {
    to->set_object(object);
    to->set_surface(contact.surface);
    write(to->mutable_point(), contact.point);
    write(to->mutable_normal(), contact.normal);
    to->set_force(contact.normalForce);
    to->set_slipping(contact.slipping);
}

/// Into a State or a Hand, which name the same things.
template <class To> void writeHand(To& to, const StageHand& hand) {
    write(to.mutable_finger(), hand.servo.finger);
    write(to.mutable_proxy(), hand.touch.output.proxy);
    write(to.mutable_force(), hand.servo.force);
    to.set_contacts(std::uint32_t(std::max(0, hand.touch.output.contacts)));
    for (std::size_t i = 0; i < hand.objects.size(); ++i)
        write(to.add_contact(), hand.touch.output.contact[i], hand.objects[i]);
    to.set_buttons(hand.servo.buttons);
    to.set_armed(hand.armed);
    to.set_gain(hand.servo.gain);
    if (hand.servo.inhibit != InhibitReason::Nothing) to.set_why(inhibitWords(hand.servo.inhibit).brief);
    to.set_servo_rate(hand.servo.rate);
    to.set_ticks(hand.servo.ticks);
    to.set_missed(hand.servo.misses);
    to.set_machine_missed(hand.servo.machineMisses);
    to.set_trouble(hand.trouble);
}

void write(v1::SurfaceDescription* to, const Surface& surface) {
    to->set_name(surface.name);
    to->set_stiffness(surface.material.stiffness);
    to->set_damping(surface.material.damping);
    to->set_static_friction(surface.material.staticFriction);
    to->set_dynamic_friction(surface.material.dynamicFriction);
    to->set_viscosity(surface.material.viscosity);
    to->set_shading(surface.shading.on);
    to->set_layers(std::uint32_t(surface.layers.size()));
}

} // namespace

void write(v1::State& to, const StageState& state, bool bodies) {
    to.set_time_ns(state.at);
    to.set_revision(state.revision);
    to.set_proxy_rate(state.engine.world.rate);
    for (std::size_t hand = 0; hand < state.hands.size(); ++hand)
        if (hand == 0)
            writeHand(to, state.hands[hand]);
        else
            writeHand(*to.add_other(), state.hands[hand]);
    to.set_attending(std::uint32_t(state.attending));
    to.set_pen_holder(state.penHolder);
    to.set_pen_asker(state.penAsker);
    if (!bodies) return;
    for (const PlacedObject& placed : state.bodies) {
        v1::Placed* body = to.add_body();
        body->set_object(placed.object);
        write(body->mutable_pose(), placed.pose);
    }
}

void write(v1::Event& to, const StageEvent& event) {
    to.set_kind(v1::Event::Kind(event.kind));
    to.set_time_ns(event.at);
    to.set_hand(std::uint32_t(event.hand));
    to.set_object(event.object);
    to.set_button(event.button);
    to.set_revision(event.revision);
    to.set_text(event.text);
    to.set_detent(event.detent);
    to.set_client(event.client);
}

void write(v1::Device& to, const DeviceInfo& device) {
    to.set_name(device.name);
    to.set_real(device.real);
    to.set_max_force(device.maxForce);
    to.set_workspace_radius(device.workspaceRadius);
    to.set_rate(device.rate);
    to.set_buttons(device.buttons);
}

void write(v1::SceneDescription& to, const Stage::Scenery& scenery) {
    to.set_revision(scenery.revision);
    to.set_proxy_radius(scenery.scene->proxyRadius);
    for (const SceneObject& object : scenery.scene->objects) {
        v1::ObjectDescription* one = to.add_object();
        one->set_id(object.id);
        one->set_name(object.name);
        write(one->mutable_pose(), object.pose);
        one->set_visible(object.visible);
        one->set_triangles(object.geometry ? object.geometry->triangles.size() : 0);
        for (const Surface& surface : object.surfaces)
            write(one->add_surface(), surface);
    }
}

grpc::Status statusOf(const Error& error) {
    const auto code = error.kind == Error::Kind::Machine ? grpc::StatusCode::RESOURCE_EXHAUSTED
                                                         : grpc::StatusCode::FAILED_PRECONDITION;
    return {code, error.text};
}

} // namespace tactum
