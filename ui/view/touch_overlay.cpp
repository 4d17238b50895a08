#include "ui/view/touch_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkDiskSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTrivialProducer.h>
#include <vtkTubeFilter.h>

#include "ui/base/hand_colours.h"
#include "ui/view/shell_bubble.h"
#include "ui/view/touch_shape.h"

namespace tactum {

namespace {

// Sizes in logical pixels.
constexpr double kProxyLeast = 5.5, kFingerLeast = 4.5, kHalo = 13;
constexpr double kCoil = 4, kWire = 1.1, kCoilPitch = 7;
constexpr double kShaft = 2, kHead = 6.5, kArrowHead = 17, kArrowAtLimit = 240, kArrowLeast = 22;
constexpr double kDisc = 30, kNormalLength = 42, kNormalShaft = 1, kNormalHead = 4, kNormalHeadLength = 10;
constexpr double kPen = 4.5, kPenPoint = 26, kPenLength = 130;
constexpr double kPenRight = 0.5, kPenUp = 0.8, kPenNear = 0.45; ///< parts of the way along it
constexpr int kCoilSteps = 14;                                   ///< points of a turn

/// A disc or ring of outer radius 1 across Y.
vtkNew<vtkTransformPolyDataFilter> disc(double inner) {
    vtkNew<vtkDiskSource> source;
    source->SetInnerRadius(inner);
    source->SetOuterRadius(1);
    source->SetCircumferentialResolution(64);
    vtkNew<vtkTransform> lie;
    lie->RotateX(90);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetTransform(lie);
    filter->SetInputConnection(source->GetOutputPort());
    return filter;
}

vtkNew<vtkSphereSource> ball() {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1);
    source->SetThetaResolution(32);
    source->SetPhiResolution(24);
    return source;
}

/// The tangent plane of one contact and its normal.
struct ContactMark {
    ContactMark(vtkRenderer& solid, vtkRenderer& ghost)
        : plane(solid, ghost, *disc(0)), rim(solid, ghost, *disc(0.93)), normal(solid, ghost) {}

    void setVisible(bool normals, bool planes) {
        plane.setVisible(planes);
        rim.setVisible(planes);
        normal.setVisible(normals);
    }

    TouchShape plane, rim;
    TouchArrow normal;
};

/// A coil between two points as a polyline; straight where there is no room for a turn.
void coil(vtkPolyData& line, const Vec3& from, const Vec3& to, double radius, double pitch) {
    const double length = (to - from).norm();
    const Vec3 axis = length > 0 ? Vec3((to - from) / length) : Vec3::UnitY();
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    const int turns = std::clamp(int(length / pitch), 1, 60);
    const int steps = turns * kCoilSteps;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cell;
    cell->InsertNextCell(steps + 1);
    for (int i = 0; i <= steps; ++i) {
        const double part = double(i) / steps, angle = 2 * std::numbers::pi * turns * part;
        // Full radius in the middle, none at the ends.
        const double reach = radius * std::min(1.0, 6 * std::min(part, 1 - part));
        const Vec3 p = from + part * (to - from) + reach * (std::cos(angle) * u + std::sin(angle) * v);
        cell->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
    line.SetPoints(points);
    line.SetLines(cell);
    line.Modified();
}

Vec3 penEnd(const TouchState& state, const ViewCamera& camera, double pixel) {
    const Vec3 along = kPenRight * camera.right() + kPenUp * camera.up() - kPenNear * camera.forward();
    return state.proxy + kPenLength * pixel * along.normalized();
}

} // namespace

TouchState touchState(const ProxyTelemetry& proxy, const ServoTelemetry& servo, double forceLimit,
                      bool armed) {
    TouchState state = touchState(static_cast<const TouchTelemetry&>(proxy), servo, forceLimit, armed);
    if (proxy.updates == 0) state.proxy = state.finger;
    return state;
}

TouchState touchState(const TouchTelemetry& touch, const ServoTelemetry& servo, double forceLimit,
                      bool armed) {
    TouchState state;
    state.finger = servo.ticks > 0 ? servo.finger : touch.finger;
    state.proxy = touch.output.proxy;
    state.force = armed && servo.ticks > 0 ? servo.force : touch.output.force;
    state.forceLimit = forceLimit > 0 ? forceLimit : 1;
    state.armed = armed;
    state.centre = servo.frame.offset;
    state.shell = servo.frame.scale * servo.border;
    state.beyond = servo.border > 0 && servo.handle_D.norm() > servo.border;
    state.contacts = std::clamp(touch.output.contacts, 0, kMaxModelPlanes);
    state.contact = touch.output.contact;
    return state;
}

bool TouchState::looksLike(const TouchState& other, double length) const {
    constexpr double kForce = 5e-3; // N, half of the last digit that is written; less of small forces, which
                                    // turn by as much
    constexpr double kTilt = 2e-3;  // rad, a tenth of a pixel at the tip of a normal
    if (contacts != other.contacts || armed != other.armed || beyond != other.beyond ||
        std::abs(shell - other.shell) > length || (centre - other.centre).norm() > length ||
        forceLimit != other.forceLimit || pushes() != other.pushes() || atLimit() != other.atLimit())
        return false;
    const auto same = [&](const ContactReport& a, const ContactReport& b) {
        return (a.point - b.point).norm() <= length && (a.normal - b.normal).norm() <= kTilt &&
               a.slipping == b.slipping && a.frictionless == b.frictionless;
    };
    if (!std::equal(contact.begin(), contact.begin() + contacts, other.contact.begin(), same)) return false;
    return (finger - other.finger).norm() <= length && (proxy - other.proxy).norm() <= length &&
           (!pushes() || (force - other.force).norm() <= kForce * std::min(1.0, force.norm()));
}

Vec3 arrowTip(const TouchState& state, const ViewCamera& camera) {
    const double pixels = std::max(kArrowLeast, kArrowAtLimit * std::min(1.0, state.load()));
    return state.proxy + pixels * camera.pixelSize(state.proxy) * state.force.normalized();
}

struct TouchOverlay::Impl {
    Impl(vtkRenderer& solid, vtkRenderer& ghost)
        : shadow(solid), spring(solid, ghost, *tube), proxy(solid, ghost, *ball()),
          finger(solid, ghost, *ball()), halo(solid, ghost, *disc(0.84)), arrow(solid, ghost), inSolid(solid),
          inGhost(ghost) {
        for (int i = 0; i < kMaxModelPlanes; ++i)
            contacts.push_back(std::make_unique<ContactMark>(solid, ghost));
        tube->SetInputData(line);
        tube->SetNumberOfSides(8);
        tube->CappingOn();
    }

    void placeSpring(const TouchState& state, double pixel);
    void placePen(const Vec3& end, const TouchState& state, double pixel);
    void placeShell(const TouchState& state);
    void placeArrow(const TouchState& state, const ViewCamera& camera, double pixel);
    void placeContact(ContactMark& mark, const ContactReport& contact, double pixel, double proxyRadius);

    const Theme* theme = &kDarkTheme;
    QColor force, fingerColour; ///< of the proxy, and of what goes with the finger
    double scale = 1;
    bool visible = true, normals = true, planes = true;
    vtkNew<vtkPolyData> line;
    vtkNew<vtkTubeFilter> tube;
    TouchShadow shadow; ///< drawn first
    std::vector<std::unique_ptr<ContactMark>> contacts;
    TouchShape spring, proxy, finger, halo;
    TouchArrow arrow;
    vtkRenderer &inSolid, &inGhost;
    std::unique_ptr<TouchArrow> pen;    ///< null: it is not shown
    std::unique_ptr<ShellBubble> shell; ///< null: rate control is off
};

void TouchOverlay::Impl::placeShell(const TouchState& state) {
    if (!(state.shell > 0)) return shell.reset();
    if (!shell) shell = std::make_unique<ShellBubble>(inSolid);
    shell->setColour(state.beyond ? theme->slip : theme->accent);
    shell->place(state.centre, state.shell);
}

TouchOverlay::TouchOverlay(vtkRenderer& solid, vtkRenderer& ghost)
    : impl_(std::make_unique<Impl>(solid, ghost)) {
    setTheme(kDarkTheme);
    setVisible(false);
}

TouchOverlay::~TouchOverlay() = default;

void TouchOverlay::setTheme(const Theme& theme, std::size_t hand) {
    const HandColours colours = handColours(theme, hand);
    impl_->theme = &theme;
    impl_->force = colours.proxy;
    impl_->fingerColour = colours.finger;
    impl_->finger.setColour(colours.finger);
    if (impl_->pen) impl_->pen->setColour(colours.finger);
    impl_->halo.setColour(colours.finger, 0.55);
    impl_->proxy.setColour(colours.proxy);
    impl_->spring.setColour(theme.dark ? QColor(0xd6, 0xda, 0xe0) : QColor(0x5a, 0x62, 0x6d));
}

void TouchOverlay::setVisible(bool visible) {
    impl_->visible = visible;
    for (TouchShape* shape : {&impl_->spring, &impl_->proxy, &impl_->finger, &impl_->halo})
        shape->setVisible(visible);
    if (impl_->pen) impl_->pen->setVisible(visible);
    if (visible) return;
    impl_->shell.reset();
    impl_->shadow.hide();
    impl_->arrow.setVisible(false);
    for (auto& mark : impl_->contacts)
        mark->setVisible(false, false);
}

void TouchOverlay::setMarks(bool normals, bool planes) {
    impl_->normals = normals;
    impl_->planes = planes;
}

void TouchOverlay::setStylus(bool shown) {
    if (shown == (impl_->pen != nullptr)) return;
    impl_->pen = shown ? std::make_unique<TouchArrow>(impl_->inSolid, impl_->inGhost) : nullptr;
    if (!shown) return;
    impl_->pen->setColour(impl_->fingerColour);
    impl_->pen->setVisible(impl_->visible);
}

void TouchOverlay::setScale(double scale) {
    impl_->scale = scale;
}

void TouchOverlay::update(const TouchState& state, const ViewCamera& camera, double proxyRadius,
                          const Drop& onto) {
    if (!impl_->visible) return;
    const double pixel = impl_->scale * camera.pixelSize(state.proxy);
    const double atFinger = impl_->scale * camera.pixelSize(state.finger);
    const double radius = std::max(proxyRadius, kProxyLeast * pixel);
    const double fingerRadius = std::max(0.6 * proxyRadius, kFingerLeast * atFinger);
    impl_->proxy.place(state.proxy, Vec3::UnitY(), radius, radius);
    impl_->finger.place(state.finger, Vec3::UnitY(), fingerRadius, fingerRadius);
    impl_->halo.place(state.finger, -camera.forward(), std::max(kHalo * atFinger, 1.8 * fingerRadius), 1);
    impl_->placeShell(state);
    impl_->placeSpring(state, pixel);
    impl_->placeArrow(state, camera, pixel);
    TouchCaster caster{.middle = state.proxy, .radius = radius};
    if (impl_->pen) {
        caster.end = penEnd(state, camera, pixel);
        caster.rodRadius = kPen * pixel;
        impl_->placePen(caster.end, state, pixel);
    }
    if (onto)
        impl_->shadow.place(caster, camera, pixel, onto);
    else
        impl_->shadow.hide();
    for (int i = 0; i < kMaxModelPlanes; ++i) {
        const bool there = i < state.contacts;
        impl_->contacts[i]->setVisible(there && impl_->normals, there && impl_->planes);
        if (i < state.contacts)
            impl_->placeContact(*impl_->contacts[i], state.contact[i], pixel, proxyRadius);
    }
}

void TouchOverlay::Impl::placeSpring(const TouchState& state, double pixel) {
    const bool apart = (state.finger - state.proxy).norm() > 2 * pixel;
    spring.setVisible(apart);
    if (!apart) return;
    coil(*line, state.proxy, state.finger, kCoil * pixel, kCoilPitch * pixel);
    tube->SetRadius(kWire * pixel);
}

void TouchOverlay::Impl::placePen(const Vec3& end, const TouchState& state, double pixel) {
    pen->place(end, state.proxy, kPen * pixel, kPen * pixel, kPenPoint * pixel);
}

void TouchOverlay::Impl::placeArrow(const TouchState& state, const ViewCamera& camera, double pixel) {
    arrow.setVisible(state.pushes());
    if (!state.pushes()) return;
    arrow.setColour(state.atLimit() ? theme->fault : force, state.armed ? 1 : 0.35);
    arrow.place(state.proxy, arrowTip(state, camera), kShaft * pixel, kHead * pixel, kArrowHead * pixel);
}

void TouchOverlay::Impl::placeContact(ContactMark& mark, const ContactReport& contact, double pixel,
                                      double proxyRadius) {
    const double radius = std::max(kDisc * pixel, 3 * proxyRadius);
    const Vec3 p = contact.point + 1.2 * pixel * contact.normal; // clear of the surface
    mark.plane.setColour(theme->contact, 0.3);
    mark.rim.setColour(contact.frictionless ? theme->contact
                       : contact.slipping   ? theme->slip
                                            : theme->stick,
                       0.95);
    mark.normal.setColour(theme->contact);
    mark.plane.place(p, contact.normal, radius, 1);
    mark.rim.place(p + 0.6 * pixel * contact.normal, contact.normal, radius, 1);
    mark.normal.place(contact.point, contact.point + kNormalLength * pixel * contact.normal,
                      kNormalShaft * pixel, kNormalHead * pixel, kNormalHeadLength * pixel);
}

} // namespace tactum
