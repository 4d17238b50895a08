// The force now, as a figure and as a bar against the limit of the device.
#pragma once

#include <QWidget>

namespace tactum {

class ForceMeter : public QWidget {
public:
    explicit ForceMeter(QWidget* parent = nullptr);
    /// N; limit > 0. Draws nothing where both are as before.
    void setForce(double force, double limit);
    QSize sizeHint() const override { return {216, 20}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double force_ = 0, limit_ = 1;
};

} // namespace tactum
