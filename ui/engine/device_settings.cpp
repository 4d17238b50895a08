#include "ui/engine/device_settings.h"

#include <cstdlib>

#include <QSettings>
#include <QStringList>
#include <QUrl>

namespace tactum {

namespace {

/// A name without slashes, which would be groups.
QString groupOf(const QString& deviceId) {
    return QStringLiteral("device/of/") + QString::fromLatin1(QUrl::toPercentEncoding(deviceId));
}

AxisMap axesOf(const QStringList& words) {
    if (words.size() != 3) return kSameAxes;
    AxisMap axes;
    for (std::size_t i = 0; i < axes.size(); ++i)
        axes[i] = std::int8_t(words[qsizetype(i)].toInt());
    return axes;
}

constexpr double kUsualRadius = 0.05; // m

} // namespace

double usualRadius(const DeviceInfo& device) {
    return device.workspaceRadius > 0 ? device.workspaceRadius : kUsualRadius;
}

DeviceSettings rememberedSettings(const QString& deviceId) {
    QSettings stored;
    stored.beginGroup(groupOf(deviceId));
    DeviceSettings settings;
    settings.workspace = {.scale = stored.value(QStringLiteral("scale"), 1.0).toDouble(),
                          .axes = axesOf(stored.value(QStringLiteral("axes")).toStringList()),
                          .offset = {stored.value(QStringLiteral("x")).toDouble(),
                                     stored.value(QStringLiteral("y")).toDouble(),
                                     stored.value(QStringLiteral("z")).toDouble()},
                          .clutch = stored.value(QStringLiteral("clutch")).toUInt(),
                          .bump = stored.value(QStringLiteral("bump")).toBool()};
    if (!checkWorkspace(settings.workspace)) settings.workspace = {};
    settings.stopButton = stored.value(QStringLiteral("stop")).toUInt();
    settings.grasped = stored.value(QStringLiteral("grasped")).toBool();
    return settings;
}

void rememberSettings(const QString& deviceId, const DeviceSettings& settings) {
    QSettings stored;
    stored.beginGroup(groupOf(deviceId));
    const Workspace& workspace = settings.workspace;
    QStringList axes;
    for (const int axis : workspace.axes)
        axes << QString::number(axis);
    stored.setValue(QStringLiteral("scale"), workspace.scale);
    stored.setValue(QStringLiteral("axes"), axes);
    stored.setValue(QStringLiteral("x"), workspace.offset.x());
    stored.setValue(QStringLiteral("y"), workspace.offset.y());
    stored.setValue(QStringLiteral("z"), workspace.offset.z());
    stored.setValue(QStringLiteral("clutch"), workspace.clutch);
    stored.setValue(QStringLiteral("bump"), workspace.bump);
    stored.setValue(QStringLiteral("stop"), settings.stopButton);
    stored.setValue(QStringLiteral("grasped"), settings.grasped);
}

AxisMap withAxis(AxisMap axes, std::size_t which, int axis) {
    const std::int8_t before = axes[which];
    for (std::int8_t& each : axes)
        if (std::abs(each) == std::abs(axis)) each = before;
    axes[which] = std::int8_t(axis);
    return axes;
}

} // namespace tactum
