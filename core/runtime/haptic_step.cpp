#include "core/runtime/haptic_step.h"

#include <algorithm>

namespace tactum {

namespace {

// Equation (24), and damping against the finger's way in. Damping only ever adds to the push: a surface
// that pulled the finger inward would be felt as sticky.
Vec3 springForce(const LocalContactModel& model, const Vec3& proxy, const Vec3& finger,
                 const Vec3& velocity) {
    const Vec3 stretch = proxy - finger;
    const double length = stretch.norm();
    if (!(length > 0)) return Vec3::Zero();
    const double inward = std::max(0.0, -velocity.dot(stretch) / length);
    return model.stiffness * stretch + (model.damping * inward / length) * stretch;
}

const Material& materialOf(const World& world, const Contact& contact) {
    return world.obstacles[contact.body].material(contact.triangle);
}

// Stiffness and damping of several contacts: the mean, weighted by how hard each pushes. Without a push the
// last values stay, for a proxy that is still on its way.
void mixMaterials(const World& world, const ProxyState& proxy, LocalContactModel& model) {
    double total = 0, stiffness = 0, damping = 0;
    for (int i = 0; i < proxy.contactCount; ++i) {
        const Contact& contact = proxy.contacts[i];
        const Material& material = materialOf(world, contact);
        total += contact.lambda;
        stiffness += contact.lambda * material.stiffness;
        damping += contact.lambda * material.damping;
    }
    if (!(total > 0)) return;
    model.stiffness = stiffness / total;
    model.damping = damping / total;
}

void describeSurroundings(const World& world, SimState& state) {
    LocalContactModel& model = state.model;
    model.proxy = state.proxy.position;
    model.valid = true;
    model.planes = 0;
    mixMaterials(world, state.proxy, model);
    for (int i = 0; i < state.proxy.contactCount && model.planes < kMaxModelPlanes; ++i) {
        const Contact& contact = state.proxy.contacts[i];
        if (contact.lambda <= 0) continue;
        model.plane[model.planes] = {contact.normal, -contact.gap};
        model.friction[model.planes++] = frictionLimit(materialOf(world, contact), contact.slipping);
    }
}

HapticOutput reportOf(const World& world, const SimState& state) {
    HapticOutput output;
    output.proxy = state.proxy.position;
    for (int i = 0; i < state.proxy.contactCount && output.contacts < kMaxModelPlanes; ++i) {
        const Contact& contact = state.proxy.contacts[i];
        if (contact.lambda <= 0) continue;
        ContactReport& report = output.contact[output.contacts++];
        report.point = contact.point;
        report.normal = contact.normal;
        report.normalForce = state.model.stiffness * contact.lambda;
        report.body = contact.body;
        report.surface = world.obstacles[contact.body].mesh->soup->surfaceOf[contact.triangle];
        report.slipping = contact.slipping;
    }
    return output;
}

} // namespace

HapticOutput hapticStep(const World& world, SimState& state, const HapticInput& input, double dt) noexcept {
    if (!input.finger.allFinite() || !input.fingerVelocity.allFinite()) {
        // Contacts of another shape may name bodies and triangles that this world does not have.
        if (state.shapeRevision == world.shapeRevision) return reportOf(world, state);
        HapticOutput output;
        output.proxy = state.proxy.position;
        return output;
    }
    if (state.shapeRevision != world.shapeRevision) {
        restart(state.proxy, input.finger);
        state.shapeRevision = world.shapeRevision;
    }
    const ProxyReport report =
        moveAndUpdate(state.proxy, world.obstacles, world.proxyRadius, input.finger, dt);
    describeSurroundings(world, state);
    HapticOutput output = reportOf(world, state);
    output.report = report;
    output.force = springForce(state.model, output.proxy, input.finger, input.fingerVelocity);
    return output;
}

Vec3 contactModelForce(const LocalContactModel& model, const Vec3& finger_W,
                       const Vec3& velocity_W) noexcept {
    if (!model.valid || model.planes == 0) return Vec3::Zero();
    // The update stage of section 2.2 on the planes of the last proxy update, held back by their friction.
    const NearestPoint nearest =
        nearestPoint(finger_W - model.proxy, {model.plane.data(), std::size_t(model.planes)});
    const double excess = nearest.x.norm();
    double slide = excess;
    for (int i = 0; i < model.planes; ++i) {
        // A viscous contact moves with the proxy loop, which knows the time: here it stands still.
        const FrictionLimit cone{model.friction[i].coefficient, 0};
        if (nearest.lambda[i] > 0)
            slide = model.friction[i].lag > 0
                        ? 0
                        : std::min(slide, allowedSlide(cone, excess, nearest.lambda[i], 0, 0));
    }
    if (nearest.active == 0) return Vec3::Zero();
    const Vec3 anchor = model.proxy + (excess > 0 ? Vec3(nearest.x * (slide / excess)) : Vec3::Zero());
    return springForce(model, anchor, finger_W, velocity_W);
}

} // namespace tactum
