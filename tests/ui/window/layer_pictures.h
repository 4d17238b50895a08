// The pictures of the page about layers.
#pragma once

#include <QDir>

#include "tests/ui/window/window_fixture.h"

namespace tactum {

/// `scenes`: the folder of the sample scenes, with a slash at its end.
void takeLayerPictures(TouchedWindow& program, const QDir& folder, const QString& scenes);

} // namespace tactum
