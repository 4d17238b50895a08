// The pictures of the guide that show what is felt.
#pragma once

#include <QDir>

#include "tests/ui/window/window_fixture.h"

namespace tactum {

/// Writes them into a folder; `scenes` is where the samples are, with a slash.
void takeFeltPictures(TouchedWindow& program, const QDir& folder, const QString& scenes);

} // namespace tactum
