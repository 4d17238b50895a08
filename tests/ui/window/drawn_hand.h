// Whether the view draws a hand.
#pragma once

#include <QImage>

#include "ui/base/hand_colours.h"
#include "ui/base/style.h"
#include "ui/view/scene_view.h"

namespace tactum {

/// Anything of it: the ring before its name at least is in its very colour. In the dark theme.
inline bool isDrawn(SceneView& view, std::size_t hand) {
    const QImage picture = view.grabPicture().convertToFormat(QImage::Format_RGB32);
    const QRgb colour = handColours(kDarkTheme, hand).finger.rgb();
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixel(x, y) == colour) return true;
    return false;
}

} // namespace tactum
