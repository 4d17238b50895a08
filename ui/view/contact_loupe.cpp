#include "ui/view/contact_loupe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include <QOpenGLFramebufferObject>

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>

#include "ui/view/gl_window.h"
#include "ui/view/view_stage.h"

namespace tactum {

namespace {

constexpr int kLoupeSamples = 4;
constexpr std::chrono::milliseconds kLeastPause{40};
constexpr double kPauses = 4; ///< of what a picture took

QOpenGLFramebufferObjectFormat loupeFormat() {
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    format.setSamples(kLoupeSamples);
    return format;
}

} // namespace

vtkStandardNewMacro(ContactLoupe::Layer);

// The same eye: nothing comes before the contact that is not there in the view.
ViewCamera closeUp(const ViewCamera& camera, const Vec3& p_W, double times, const QSizeF& size) {
    ViewCamera close = camera;
    close.focus = p_W;
    close.size = size;
    if (!camera.parallel) {
        const Vec3 back = camera.eye() - p_W;
        close.distance = back.norm();
        close.yaw = std::atan2(back.x(), back.z());
        close.pitch = std::asin(std::clamp(back.y() / close.distance, -1.0, 1.0));
    }
    const double half = 0.5 * size.height() * camera.pixelSize(p_W) / times;
    close.fieldOfView = 2 * std::atan(half / close.distance);
    return close;
}

std::chrono::milliseconds loupePause(std::chrono::duration<double> took) {
    return std::max(kLeastPause, std::chrono::duration_cast<std::chrono::milliseconds>(kPauses * took));
}

// They are no layers of the window: it does not know of them, and draws them only when it is told to.
ContactLoupe::ContactLoupe(GlWindow& window, ViewStage& stage) : window_(window), stage_(stage) {
    vtkNew<vtkCamera> shared;
    int layer = 0;
    for (vtkRenderer* renderer : std::initializer_list<vtkRenderer*>{model_, touch_, ghost_}) {
        renderer->SetLayer(layer++); // all but the first keep the colours beneath
        renderer->SetActiveCamera(shared);
        renderer->SetRenderWindow(&window);
    }
    model_->GradientBackgroundOn();
    touch_->SetPreserveDepthBuffer(true);
}

// The stage's props stay on the card.
ContactLoupe::~ContactLoupe() {
    model_->GetViewProps()->RemoveAllItems();
    for (vtkRenderer* renderer : std::initializer_list<vtkRenderer*>{ghost_, touch_, model_})
        renderer->SetRenderWindow(nullptr);
}

// By the list alone: what is added to a renderer and taken out of it again is taken off the card.
void ContactLoupe::mirrorStage() {
    vtkPropCollection* props = model_->GetViewProps();
    props->RemoveAllItems();
    for (vtkRenderer* from : std::initializer_list<vtkRenderer*>{stage_.solid, stage_.chosen}) {
        vtkCollectionSimpleIterator it;
        from->GetViewProps()->InitTraversal(it);
        while (vtkProp* prop = from->GetViewProps()->GetNextProp(it))
            props->AddItem(prop);
    }
    model_->SetBackground(stage_.solid->GetBackground());
    model_->SetBackground2(stage_.solid->GetBackground2());
}

QImage ContactLoupe::draw(const ViewCamera& camera, const Bounds& shown, double ratio, Coarse coarse) {
    mirrorStage();
    const QSize pixels = (camera.size * ratio).toSize();
    QOpenGLFramebufferObject picture(pixels, loupeFormat());
    if (!picture.bind()) return {};
    aim(*model_->GetActiveCamera(), camera, shown);
    const Coarse before = window_.coarse();
    window_.setCoarse(coarse);
    window_.drawAside([&] {
        const std::array<int, 2> whole{window_.GetSize()[0], window_.GetSize()[1]};
        window_.SetSize(pixels.width(), pixels.height());
        for (vtkRenderer* renderer : std::initializer_list<vtkRenderer*>{model_, touch_, ghost_})
            renderer->Render();
        window_.SetSize(whole[0], whole[1]);
    });
    window_.setCoarse(before);
    QImage image = picture.toImage();
    picture.release();
    image.reinterpretAsFormat(QImage::Format_RGB32); // whatever has been left in its alpha
    image.setDevicePixelRatio(ratio);
    return image;
}

} // namespace tactum
