// The picture of the contact from nearby. Private to this folder.
#pragma once

#include <chrono>

#include <QImage>

#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>

#include "core/geometry/triangle_soup.h"
#include "ui/view/gl_window.h"
#include "ui/view/touch_overlay.h"
#include "ui/view/view_camera.h"

namespace tactum {

class ViewStage;

/// Looks from the same eye at a point, which is in the middle of `size` then and so many times as large.
ViewCamera closeUp(const ViewCamera& camera, const Vec3& p_W, double times, const QSizeF& size);

/// How long to wait after a picture that took so long: at 60 pictures of the view a second every third has
/// one beside it, and where one takes long a fifth of the time goes into them at most.
std::chrono::milliseconds loupePause(std::chrono::duration<double> took);

/// The model of a stage, with what is laid over it, and marks of the touch in their usual size, drawn by the
/// stage's window into a picture of its own. What is on the card is there once; what is seen of the stage
/// stays as it is. Thread: ui.
class ContactLoupe {
public:
    ContactLoupe(GlWindow& window, ViewStage& stage);
    ~ContactLoupe();
    ContactLoupe(const ContactLoupe&) = delete;
    ContactLoupe& operator=(const ContactLoupe&) = delete;

    /// Finger, proxy, force and contacts, to be placed for the camera.
    TouchOverlay& marks() { return marks_; }
    /// With the window's context current; `camera` from closeUp(); `shown`: what must not be clipped away;
    /// `ratio`: device pixels to a logical one; `coarse`: as the view in motion.
    QImage draw(const ViewCamera& camera, const Bounds& shown, double ratio, Coarse coarse);

private:
    /// Blends in the order of the props (see KeptRenderer).
    class Layer : public vtkOpenGLRenderer {
    public:
        static Layer* New();
        vtkTypeMacro(Layer, vtkOpenGLRenderer)

            void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* = nullptr) override {
            UpdateTranslucentPolygonalGeometry();
        }
    };

    void mirrorStage();

    GlWindow& window_;
    ViewStage& stage_;
    vtkNew<Layer> model_, touch_, ghost_;
    TouchOverlay marks_{*touch_, *ghost_};
};

} // namespace tactum
