#include "ui/showing/video_frame.h"

#include <algorithm>

#include <QPainter>

namespace tactum {

namespace {

constexpr double kPlotPart = 0.26;   // of the height
constexpr double kUsualHeight = 900; // pixels of a picture whose plot is drawn one to one

int evenSide(double pixels) {
    return std::clamp(2 * int(pixels / 2), kLeastVideoSide, kLargestVideoSide);
}

} // namespace

double VideoLayout::plotScale() const {
    return std::max(0.75, size.height() / kUsualHeight);
}

VideoLayout videoLayout(QSize size, bool plot) {
    const QSize even(evenSide(size.width()), evenSide(size.height()));
    const int below = plot ? evenSide(kPlotPart * even.height()) : 0, above = even.height() - below;
    return {even, {0, 0, even.width(), above}, plot ? QRect(0, above, even.width(), below) : QRect()};
}

VideoLayout videoLayoutAround(QSize view, bool plot) {
    return videoLayout({view.width(), int(view.height() / (plot ? 1 - kPlotPart : 1))}, plot);
}

VideoPicture videoFrame(const VideoLayout& layout, const QImage& view, const QImage& plot,
                        const QColor& around) {
    VideoPicture picture{layout.size.width(), layout.size.height(), {}};
    picture.pixels.resize(std::size_t(picture.width) * std::size_t(picture.height));
    QImage image(reinterpret_cast<uchar*>(picture.pixels.data()), picture.width, picture.height,
                 QImage::Format_RGB32);
    image.fill(around);
    QPainter painter(&image);
    QSize fitted = view.size();
    // One pixel more or less than there is room for is what makes a size even.
    const QSize apart = layout.view.size() - fitted;
    if (std::max(std::abs(apart.width()), std::abs(apart.height())) > 2)
        fitted.scale(layout.view.size(), Qt::KeepAspectRatio);
    QRect place({0, 0}, fitted);
    place.moveCenter(layout.view.center());
    const QImage scaled =
        fitted == view.size() ? view : view.scaled(fitted, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    painter.setClipRect(layout.view);
    painter.drawImage(place.topLeft(), scaled);
    painter.setClipping(false);
    if (!plot.isNull()) painter.drawImage(layout.plot, plot, QRect({0, 0}, plot.size()));
    return picture;
}

} // namespace tactum
