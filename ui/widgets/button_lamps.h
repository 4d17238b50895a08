// The buttons of a device's handle, lit while they are held.
#pragma once

#include <cstdint>

#include <QWidget>

namespace tactum {

class ButtonLamps : public QWidget {
public:
    explicit ButtonLamps(QWidget* parent = nullptr);

    /// `held`: a bit for each, the first button in the lowest.
    void setButtons(int count, std::uint32_t held);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int count_ = 0;
    std::uint32_t held_ = 0;
};

} // namespace tactum
