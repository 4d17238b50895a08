#include "ui/view/vtk_widget.h"

#include <algorithm>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTimer>

#include <vtkNew.h>

#include "ui/view/gl_window.h"

namespace tactum {

namespace {
// Software rendering takes a fifth of a second for a smooth frame: only a picture that rests gets one.
constexpr int kRestMilliseconds = 250;
constexpr int kSamples = 4;
} // namespace

struct VtkWidget::Impl {
    vtkNew<GlWindow> window;
    QMetaObject::Connection contextGone;
    QTimer rest;
    bool software = false;
    bool resting = false;
    bool grabbing = false;
    bool finished = false;                          ///< nothing better is to come
    PictureQuality quality = PictureQuality::Quick; ///< of the last picture
    std::function<void(const QImage&)> taker;       ///< of the next picture
};

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent), impl_(std::make_unique<Impl>()) {
    impl_->window->connect([this] { makeCurrent(); },
                           [this] { return context() && QOpenGLContext::currentContext() == context(); });
    impl_->window->SetForceMaximumHardwareLineWidth(1); // wide lines are drawn by a shader: core profile
    impl_->window->SetOwnContext(false);
    impl_->window->SetFrameBlitModeToNoBlit();
    impl_->rest.setSingleShot(true);
    impl_->rest.setInterval(kRestMilliseconds);
    connect(&impl_->rest, &QTimer::timeout, this, [this] {
        impl_->resting = true;
        if (impl_->software) {
            impl_->finished = false;
            update();
        }
        rested();
    });
}

// The context dies after this part of the widget is gone; what hangs on it must go first.
VtkWidget::~VtkWidget() {
    disconnect(impl_->contextGone);
    releaseContext();
    impl_->window->connect({}, {});
}

bool VtkWidget::rendersInSoftware() const {
    return impl_->software;
}

PictureQuality VtkWidget::quality() const {
    return impl_->quality;
}

bool VtkWidget::rests() const {
    return impl_->finished && (impl_->resting || !impl_->software);
}

GlWindow& VtkWidget::renderWindow() const {
    return *impl_->window.Get();
}

void VtkWidget::releaseContext() {
    if (!context()) return;
    makeCurrent();
    impl_->window->Finalize();
    impl_->window->SetReadyForRendering(false);
    doneCurrent();
}

void VtkWidget::changed() {
    impl_->resting = impl_->finished = false;
    impl_->rest.start();
    update();
}

// Called again with a new context when the widget moves into another window.
void VtkWidget::initializeGL() {
    disconnect(impl_->contextGone);
    impl_->contextGone =
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { releaseContext(); });
    impl_->software = GlWindow::rendererIsSoftware();
    impl_->window->SetReadyForRendering(true);
    impl_->window->OpenGLInitContext();
}

void VtkWidget::resizeGL(int, int) {
    changed();
}

void VtkWidget::paintGL() {
    const auto wanted = [this] {
        if (!impl_->software || impl_->grabbing) return PictureQuality::Sampled;
        return impl_->resting ? atRest() : PictureQuality::Quick;
    };
    paint(wanted());
    impl_->finished = impl_->quality == wanted();
    if (!impl_->finished) update();
}

void VtkWidget::paint(PictureQuality quality) {
    impl_->quality = quality;
    const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
    impl_->window->SetDPI(int(72 * devicePixelRatioF()));
    impl_->window->SetMultiSamples(quality == PictureQuality::Sampled ? kSamples : 0);
    const std::vector<QRect> places = pictures();
    prepareFrame();
    for (std::size_t i = 0; i < places.size(); ++i)
        paintPicture(i, places[i], pixels.height());
    makeOpaque();
    paintOver();
    if (impl_->taker) givePicture(pixels);
}

// Between whole device pixels: pictures that meet do so without a gap.
void VtkWidget::paintPicture(std::size_t number, const QRect& place, int height) {
    const auto pixel = [this](int logical) { return qRound(logical * devicePixelRatioF()); };
    const int left = pixel(place.x()), top = pixel(place.y());
    const int right = pixel(place.x() + place.width()), bottom = pixel(place.y() + place.height());
    impl_->window->SetSize(std::max(1, right - left), std::max(1, bottom - top));
    preparePicture(number);
    impl_->window->renderFrameAt(left, height - bottom);
}

void VtkWidget::takeNextPicture(std::function<void(const QImage&)> take) {
    impl_->taker = std::move(take);
}

// Here, where the framebuffer is bound: whoever grabs the widget has it drawn once more.
void VtkWidget::givePicture(const QSize& pixels) {
    QImage upsideDown(pixels, QImage::Format_RGB32);
    auto* gl = context()->functions();
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glReadPixels(0, 0, pixels.width(), pixels.height(), GL_BGRA, GL_UNSIGNED_BYTE, upsideDown.bits());
    std::exchange(impl_->taker, {})(upsideDown.mirrored());
}

// Where the window has an alpha channel the compositor would see through the background.
void VtkWidget::makeOpaque() {
    auto* gl = context()->functions();
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

QImage VtkWidget::grabSmooth() {
    impl_->grabbing = true;
    const QImage picture = grabFramebuffer();
    impl_->grabbing = false;
    return picture;
}

} // namespace tactum
