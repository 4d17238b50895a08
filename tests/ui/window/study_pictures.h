// The pictures of the page about studies.
#pragma once

#include <QDir>
#include <QSize>

namespace tactum {

/// In a window of its own, with two conditions of the sample: study-dock.png, study-procedure.png,
/// study-trial.png and study-choice.png.
void takeStudyPictures(const QDir& folder, const QString& sample, QSize size);

} // namespace tactum
