// Where the handle is in the device's workspace: a ball from the front and from above.
#pragma once

#include <optional>

#include <QWidget>

#include "core/base/vec.h"

namespace tactum {

class WorkspacePicture : public QWidget {
public:
    explicit WorkspacePicture(QWidget* parent = nullptr);

    /// Frame D, m. A radius of 0 is not known: the ball is then as large as the farthest place so far.
    void setHandle(const Vec3& handle, double radius);
    /// Where the handle should be, frame D, m: a ring. nullopt: anywhere.
    void setAim(const std::optional<Vec3>& aim);
    QSize sizeHint() const override { return {240, 128}; }
    QSize minimumSizeHint() const override { return {160, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void drawView(QPainter& painter, const QRectF& box, const QString& name, QPointF at, QPointF aim) const;

    Vec3 handle_ = Vec3::Zero();
    std::optional<Vec3> aim_;
    double radius_ = 0, farthest_ = 0.01;
};

} // namespace tactum
