// Finger, proxy, the spring between them, the force and the contacts. Private to this folder.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <QPointF>

#include "core/runtime/channels.h"
#include "ui/base/theme.h"
#include "ui/view/touch_shadow.h"
#include "ui/view/view_camera.h"

class vtkRenderer;

namespace tactum {

/// What is shown of the haptics at one moment. World frame, SI.
struct TouchState {
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero();
    double forceLimit = 1;
    bool armed = false;
    Vec3 centre = Vec3::Zero(); ///< of the device's workspace
    double shell = 0;           ///< m, its radius where rate control begins; 0: none is drawn
    bool beyond = false;        ///< the hand is beyond it
    int contacts = 0;
    std::array<ContactReport, kMaxModelPlanes> contact{};

    double load() const { return force.norm() / forceLimit; } ///< 1 at the limit
    bool atLimit() const { return load() > 0.999; }
    bool pushes() const { return force.norm() > 5e-4; }
    /// Whether both look the same where `length`, m, cannot be seen.
    bool looksLike(const TouchState& other, double length) const;
};

/// The newest of what both loops say: the servo's finger and force, the proxy's contacts. Where the forces
/// are off the force is the one that would be sent.
TouchState touchState(const ProxyTelemetry& proxy, const ServoTelemetry& servo, double forceLimit,
                      bool armed);

/// Of a hand beside the first.
TouchState touchState(const TouchTelemetry& touch, const ServoTelemetry& servo, double forceLimit,
                      bool armed);

/// Where the arrow of the force ends. Its length on the screen is proportional to the force.
Vec3 arrowTip(const TouchState& state, const ViewCamera& camera);

/// The actors. Each is drawn twice: solid among the model, and dimmed on a layer above it, so that a finger
/// inside the model is seen. Sizes are in pixels, except that the proxy never shows smaller than it is.
/// Thread: ui.
class TouchOverlay {
public:
    TouchOverlay(vtkRenderer& solid, vtkRenderer& ghost);
    ~TouchOverlay();

    /// `hand`: whose colours finger and proxy have.
    void setTheme(const Theme& theme, std::size_t hand = 0);
    void setVisible(bool visible);
    /// Which of the marks of contacts are shown: their normals, their planes.
    void setMarks(bool normals, bool planes);
    /// A pen whose tip is the proxy: it leads up and toward the eye, whatever is touched.
    void setStylus(bool shown);
    /// Of everything but the length of the force's arrow.
    void setScale(double scale);
    /// Places everything for the camera; pixels are logical ones. proxyRadius in m. `onto`: what the shadow
    /// falls on; nothing: there is none.
    void update(const TouchState& state, const ViewCamera& camera, double proxyRadius, const Drop& onto = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
