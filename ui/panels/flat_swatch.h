// A piece of flat ground on which the layers of a surface can be seen, and read where the mouse points.
#pragma once

#include <QWidget>

#include "ui/base/background_job.h"
#include "ui/document/layer_picture.h"

namespace tactum {

/// Computed on a worker; the last picture stays until the next is there. The wheel chooses how much ground is
/// seen. Thread: ui.
class FlatSwatch : public QWidget {
    Q_OBJECT
public:
    explicit FlatSwatch(QWidget* parent = nullptr);

    /// `soup` and `surface`: whose texture coordinates give their scale.
    void display(const TextureLayers& layers, TextureTarget target, std::shared_ptr<const TriangleSoup> soup,
                 Index surface);
    /// What is seen now; without values before the first picture.
    const FlatGround& ground() const { return ground_; }
    bool working() const { return job_.running(); }
    /// The value at a place of the widget in words, with where it is: "120 um at 3.1, 12.0 mm".
    QString readingAt(QPointF place) const;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void compute();
    QRectF area() const;

    struct Shown {
        TextureLayers layers;
        TextureTarget target = TextureTarget::Height;
        std::shared_ptr<const TriangleSoup> soup;
        Index surface = 0;

        bool operator==(const Shown&) const = default;
    };
    Shown shown_;
    int size_; ///< which of the sizes of ground is seen
    FlatGround ground_;
    std::optional<QPointF> cursor_;
    BackgroundJob job_;
    bool again_ = false; ///< something else is to be shown since the work began
};

/// "120 um" of a height, "x 1.35" of a factor.
QString layerValueText(TextureTarget target, double value);

} // namespace tactum
