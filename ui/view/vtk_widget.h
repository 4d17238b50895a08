// A Qt 6 widget that shows a VTK render window.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QImage>
#include <QOpenGLWidget>
#include <QRect>

#include "ui/view/picture_budget.h"

namespace tactum {

class GlWindow;

/// Owns a generic OpenGL render window and gives it this widget's context, size and framebuffer. Survives
/// being moved into another window (a new context), fractional device pixels and software rendering, where
/// it keeps the expensive settings off. Pointer and key events stay Qt's: a subclass handles them.
/// Thread: ui.
class VtkWidget : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    /// True once a context exists and it draws on the processor.
    bool rendersInSoftware() const;
    /// Of the last picture.
    PictureQuality quality() const;
    /// Whether that is how it stays until something changes.
    bool rests() const;
    /// Gives the next picture that is drawn anyway away, in device pixels and once. The one before is
    /// forgotten when nothing was drawn for it yet.
    void takeNextPicture(std::function<void(const QImage&)> take);

protected:
    GlWindow& renderWindow() const;

    /// How well a picture at rest is drawn where the processor draws; asked before such a picture, and again
    /// after it: another answer brings another picture.
    virtual PictureQuality atRest() const { return PictureQuality::Sampled; }
    /// The pictures that a frame is made of, in logical pixels; one that fills it where nobody says
    /// otherwise.
    virtual std::vector<QRect> pictures() { return {rect()}; }
    /// Brings everything that is drawn up to date; called before each frame, with the context current.
    virtual void prepareFrame() {}
    /// What one of the pictures alone shows; called before each of them.
    virtual void preparePicture(std::size_t) {}
    /// Draws on top with QPainter; called after each frame.
    virtual void paintOver() {}
    /// Nothing has changed for a quarter of a second.
    virtual void rested() {}
    /// Asks for a frame because what it shows has changed.
    void changed();
    /// The widget as it would look at rest, multisampled on every machine.
    QImage grabSmooth();

    void initializeGL() final;
    void resizeGL(int width, int height) final;
    void paintGL() final;

private:
    void releaseContext();
    void paint(PictureQuality quality);
    void paintPicture(std::size_t number, const QRect& place, int height);
    void makeOpaque();
    void givePicture(const QSize& pixels);

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
