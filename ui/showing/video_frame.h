// A picture of a video: the view, and the force plot beneath it.
#pragma once

#include <QColor>
#include <QImage>
#include <QRect>

#include "core/video/video_file.h"

namespace tactum {

/// Where both are in a picture, pixels. Without a plot its rectangle is empty.
struct VideoLayout {
    QSize size;
    QRect view, plot;

    /// Device pixels to a logical one of the plot: letters are as large on any size.
    double plotScale() const;
};

/// A picture of this size, as even as a video has to be.
VideoLayout videoLayout(QSize size, bool plot);
/// A picture that shows a view of this size as it is, with the plot beneath it. Within what a video may be.
VideoLayout videoLayoutAround(QSize view, bool plot);

/// A view of another size is scaled, and stands in the middle of its place. Thread: any but real time.
VideoPicture videoFrame(const VideoLayout& layout, const QImage& view, const QImage& plot,
                        const QColor& around);

} // namespace tactum
