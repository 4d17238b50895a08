// What a scene's file says of it in our own words, a line for each figure: what an edit changed is what
// differs. Without arrays and patterns, and without what is said again for programs that do not know our
// words.
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>
#include <QtEndian>

#include "core/files/gltf/write_gltf.h"
#include "tests/ui/panels/panels.h"

namespace tactum::testing {

inline void addFigures(QStringList& lines, const QString& path, const QJsonValue& value) {
    static const QStringList kLeftOut{"accessors",
                                      "bufferViews",
                                      "buffers",
                                      "images",
                                      "textures",
                                      "asset",
                                      "extras",
                                      "indices",
                                      "pattern",
                                      "attributes",
                                      "extensionsUsed",
                                      "MPEG_haptic_material",
                                      "KHR_physics_rigid_bodies"};
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto each = object.begin(); each != object.end(); ++each)
            if (!kLeftOut.contains(each.key())) addFigures(lines, path + u'/' + each.key(), each.value());
    } else if (value.isArray()) {
        const QJsonArray array = value.toArray();
        for (qsizetype i = 0; i < array.size(); ++i)
            addFigures(lines, path + u'/' + QString::number(i), array[i]);
    } else if (value.isDouble()) {
        lines << path + u' ' + QString::number(value.toDouble(), 'g', 6);
    } else {
        lines << path + u' ' + value.toVariant().toString();
    }
}

/// "/materials/0/name lid" and so on, in the order of the keys.
inline QStringList figuresOf(const Scene& scene) {
    const auto glb = glbOf(scene);
    if (!glb) return {QString::fromStdString(glb.error().text)};
    const QByteArray bytes = QByteArray::fromStdString(*glb);
    const auto length = qFromLittleEndian<quint32>(bytes.constData() + 12); // of the first chunk
    QStringList lines;
    addFigures(lines, {}, QJsonDocument::fromJson(bytes.mid(20, length)).object());
    return lines;
}

/// What tells two scenes apart, as `diff` says it; empty where they are equal.
inline QString difference(const Scene& now, const Scene& before) {
    if (now == before) return {};
    const QString lines = changedLines(figuresOf(before), figuresOf(now));
    return lines.isEmpty() ? QStringLiteral("something that figuresOf() leaves out") : lines;
}

} // namespace tactum::testing
