// Boxes as Wavefront OBJ, for windows to open.
#pragma once

#include <array>

#include <QByteArray>

#include "core/base/vec.h"

namespace tactum {

/// Without a name it goes on with the object before. `corner`: of the file, the first that is free; counted
/// on.
inline QByteArray objBox(const char* name, const Vec3& low, const Vec3& high, int& corner) {
    QByteArray text = name ? QByteArray("o ") + name + "\n" : QByteArray();
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3 p((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
        text += QStringLiteral("v %1 %2 %3\n").arg(p.x()).arg(p.y()).arg(p.z()).toUtf8();
    }
    for (const auto& side :
         {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
        text += "f";
        for (const int i : side)
            text += " " + QByteArray::number(corner + i);
        text += "\n";
    }
    corner += 8;
    return text;
}

} // namespace tactum
