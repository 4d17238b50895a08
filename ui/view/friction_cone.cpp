#include "ui/view/friction_cone.h"

#include <algorithm>

#include <vtkConeSource.h>
#include <vtkDiskSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

namespace tactum {

namespace {

constexpr double kMinConeHeight = 56; // logical pixels
constexpr double kThinRim = 1e-3;

/// Its tip at the origin, open at Y = 1, where its radius is 1.
vtkNew<vtkConeSource> funnel() {
    vtkNew<vtkConeSource> source;
    source->SetRadius(1);
    source->SetHeight(1);
    source->SetDirection(0, -1, 0);
    source->SetCenter(0, 0.5, 0);
    source->SetResolution(64);
    source->CappingOff();
    return source;
}

vtkNew<vtkTransformPolyDataFilter> hoop(double inner) {
    vtkNew<vtkDiskSource> source;
    source->SetInnerRadius(inner);
    source->SetOuterRadius(1);
    source->SetCircumferentialResolution(64);
    vtkNew<vtkTransform> lie;
    lie->Translate(0, 1, 0);
    lie->RotateX(90);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetTransform(lie);
    filter->SetInputConnection(source->GetOutputPort());
    return filter;
}

} // namespace

FrictionCone::FrictionCone(vtkRenderer& solid, vtkRenderer& ghost)
    : mantle_(solid, ghost, *funnel()), rim_(solid, ghost, *hoop(0.94)), inner_(solid, ghost, *hoop(0.975)) {
    setVisible(false);
}

void FrictionCone::setVisible(bool visible) {
    visible_ = visible;
    for (TouchShape* shape : {&mantle_, &rim_, &inner_})
        shape->setVisible(visible);
}

void FrictionCone::update(const TouchState& state, const ViewCamera& camera) {
    const ContactReport* contact = mainContact(state);
    const double coefficient = !contact            ? 0
                               : contact->slipping ? contact->dynamicFriction
                                                   : contact->staticFriction;
    const bool shown = visible_ && coefficient > 0 && state.pushes();
    for (TouchShape* shape : {&mantle_, &rim_})
        shape->setVisible(shown);
    // The narrower cone that takes over once the contact slips.
    const bool two = shown && !contact->slipping && contact->dynamicFriction < (1 - kThinRim) * coefficient &&
                     contact->dynamicFriction > 0;
    inner_.setVisible(two);
    if (!shown) return;
    const Vec3 arrow = arrowTip(state, camera) - state.proxy;
    const double height =
        std::max(kMinConeHeight * camera.pixelSize(state.proxy), arrow.dot(contact->normal));
    const QColor colour = contact->slipping ? theme_->slip : theme_->stick;
    mantle_.setColour(colour, 0.22);
    rim_.setColour(colour, 0.95);
    for (TouchShape* shape : {&mantle_, &rim_})
        shape->place(state.proxy, contact->normal, coefficient * height, height);
    if (!two) return;
    inner_.setColour(theme_->slip, 0.9);
    inner_.place(state.proxy, contact->normal, contact->dynamicFriction * height, height);
}

const ContactReport* mainContact(const TouchState& state) {
    const auto end = state.contact.begin() + state.contacts;
    const auto most = std::max_element(state.contact.begin(), end, [](const auto& a, const auto& b) {
        return a.normalForce < b.normalForce;
    });
    return most == end ? nullptr : &*most;
}

} // namespace tactum
