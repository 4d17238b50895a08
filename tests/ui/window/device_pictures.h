// The pictures of the page about devices.
#pragma once

#include <QDir>
#include <QSize>

namespace tactum {

/// In a window of its own, with a device of the tests. Every page of the dock is taken in both themes where
/// `all` is wanted; else only those that the guide shows.
void takeDevicePictures(const QDir& folder, const QString& sample, QSize size, bool all);

} // namespace tactum
