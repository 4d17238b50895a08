// What the rows of the outliner are, for its own files.
#pragma once

#include <string>

#include <QTreeWidgetItem>

#include "core/scene/surface_ref.h"

namespace tactum {

inline constexpr int kName = 0, kEye = 1, kLock = 2;
inline constexpr int kObjectRole = Qt::UserRole, kSurfaceRole = Qt::UserRole + 1,
                     kKindRole = Qt::UserRole + 2, kGroupRole = Qt::UserRole + 3;

enum Kind { kSurface, kObject, kGroup };

inline SurfaceRef refOf(const QTreeWidgetItem* item) {
    return {item->data(kName, kObjectRole).toUInt(), item->data(kName, kSurfaceRole).toUInt()};
}

inline Kind kindOf(const QTreeWidgetItem* item) {
    return Kind(item->data(kName, kKindRole).toInt());
}

inline bool isObject(const QTreeWidgetItem* item) {
    return kindOf(item) == kObject;
}

inline std::string groupOf(const QTreeWidgetItem* item) {
    return item->data(kName, kGroupRole).toString().toStdString();
}

} // namespace tactum
