// The picture of the window at a haptic server.
#pragma once

#include <QDir>
#include <QSize>

namespace tactum {

/// A server with the texture wall, a second client, the simulated hand pressing: connected.png.
void takeConnectedPicture(const QDir& folder, const QString& scenes, QSize size);

} // namespace tactum
