// A loaded scene as text, value by value, to be held against a file.
#pragma once

#include <QString>
#include <QStringList>

#include "core/files/load_scene.h"

namespace tactum::test {

inline QString number(double value) {
    const double small = std::abs(value) < 1e-15 ? 0 : value;
    return QString::number(small, 'g', 9);
}

template <class Vector> QString vectorText(const Vector& v) {
    QStringList parts;
    for (Eigen::Index i = 0; i < v.size(); ++i)
        parts << number(double(v[i]));
    return u'(' + parts.join(u' ') + u')';
}

inline QString poseText(const Pose& pose) {
    return vectorText(pose.translation) + QStringLiteral(" turned ") + vectorText(pose.rotation.coeffs());
}

inline QString imageText(const TextureImage& image) {
    QString text = QStringLiteral("%1x%2 of %3 bits \"%4\"")
                       .arg(image.width())
                       .arg(image.height())
                       .arg(image.bits())
                       .arg(QString::fromStdString(image.name()));
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            sum += image.row(y)[x] * (1 + x + 3.0 * y);
    return text + QStringLiteral(" sum ") + number(sum);
}

inline QString patternText(const TexturePattern& p) {
    QString text = QString::fromUtf8(kTextureSources[std::size_t(p.source)].key.data()) + u' ' +
                   QString::fromUtf8(kTextureMappings[std::size_t(p.mapping)].key.data()) + u' ' +
                   poseText(p.frame);
    for (const PatternField& field : kPatternFields)
        text += u' ' + QString::fromUtf8(field.parameter->key.data()) + u'=' + number(p.*field.value);
    if (p.image) text += QStringLiteral(" image ") + imageText(*p.image);
    if (p.painted.values) {
        text += QStringLiteral(" painted");
        for (const float value : p.painted.values->all())
            text += u' ' + number(value);
    }
    return text;
}

template <class Value> void addTrack(QStringList& lines, const char* what, const Track<Value>& track) {
    if (track.times.empty()) return;
    lines << QStringLiteral("  %1, kind %2").arg(QLatin1String(what)).arg(int(track.interpolation));
    for (std::size_t i = 0; i < track.times.size(); ++i) {
        QString line = QStringLiteral("    ") + number(track.times[i]) + QStringLiteral(" s ") +
                       vectorText(track.values[i]);
        if (!track.arriving.empty()) line += QStringLiteral(" from ") + vectorText(track.arriving[i]);
        if (!track.leaving.empty()) line += QStringLiteral(" to ") + vectorText(track.leaving[i]);
        lines << line;
    }
}

inline QString sceneText(const LoadedScene& loaded) {
    QStringList lines;
    const Scene& scene = loaded.scene;
    lines << QStringLiteral("proxy %1%2")
                 .arg(number(scene.proxyRadius), loaded.ours ? QStringLiteral(", ours") : QString());
    for (const Finding& f : loaded.findings) {
        const char* words[] = {"note", "warning", "error"};
        lines << QStringLiteral("%1 [%2] %3 | %4")
                     .arg(QLatin1String(words[int(f.severity)]), QString::fromStdString(f.object),
                          QString::fromStdString(f.sentence), QString::fromStdString(f.remedy));
    }
    if (scene.finger)
        for (const FingerPoint& point : *scene.finger)
            lines << QStringLiteral("finger %1 s ").arg(number(point.t)) + vectorText(point.position);
    for (const SceneObject& object : scene.objects) {
        lines << QStringLiteral("object %1 \"%2\" at %3%4")
                     .arg(object.id)
                     .arg(QString::fromStdString(object.name), poseText(object.pose),
                          object.visible ? QString() : QStringLiteral(" hidden"));
        for (const Surface& s : object.surfaces) {
            QString line = QStringLiteral("  surface \"%1\" colour %2 sides %3")
                               .arg(QString::fromStdString(s.name), vectorText(s.colour),
                                    QString::fromUtf8(nameOf(s.sides).data()));
            if (!s.visible) line += QStringLiteral(" hidden");
            if (s.locked) line += QStringLiteral(" locked");
            line += QStringLiteral(" shading %1 %2 %3")
                        .arg(s.shading.on)
                        .arg(int(s.shading.normals))
                        .arg(number(s.shading.creaseAngle));
            for (const MaterialField& field : kMaterialFields)
                line += u' ' + number(s.material.*field.value);
            lines << line;
            for (const TextureLayer& l : s.layers) {
                lines << QStringLiteral("    layer \"%1\"%2 %3 %4 %5 opacity %6%7")
                             .arg(QString::fromStdString(l.name),
                                  l.enabled ? QString() : QStringLiteral(" off"),
                                  QString::fromUtf8(kTextureTargets[std::size_t(l.target)].key.data()),
                                  number(l.strength),
                                  QString::fromUtf8(kTextureBlends[std::size_t(l.blend)].key.data()),
                                  number(l.opacity), l.ownPlane ? QStringLiteral(" own plane") : QString());
                lines << QStringLiteral("      ") + patternText(l.pattern);
                if (l.mask) lines << QStringLiteral("      mask ") + patternText(*l.mask);
            }
        }
        if (object.motion) {
            lines << QStringLiteral("  moves %1 s%2")
                         .arg(number(object.motion->duration),
                              object.motion->jumpsAtEnd ? QStringLiteral(", jumps at its end") : QString());
            for (const double jump : object.motion->jumps)
                lines << QStringLiteral("    jumps at ") + number(jump);
            addTrack(lines, "translation", object.motion->translation);
            addTrack(lines, "rotation", object.motion->rotation);
        }
        const TriangleSoup& soup = *object.geometry;
        for (const Vec3& p : soup.positions)
            lines << QStringLiteral("  p ") + vectorText(p);
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const auto& c = soup.triangles[t];
            QString line =
                QStringLiteral("  t %1 %2 %3 of %4").arg(c[0]).arg(c[1]).arg(c[2]).arg(soup.surfaceOf[t]);
            if (!soup.cornerNormals.empty())
                for (std::size_t k = 0; k < 3; ++k)
                    line += QStringLiteral(" n") + vectorText(soup.cornerNormals[3 * t + k]);
            if (!soup.cornerUvs.empty())
                for (std::size_t k = 0; k < 3; ++k)
                    line += QStringLiteral(" uv") + vectorText(soup.cornerUvs[3 * t + k]);
            lines << line;
        }
    }
    return lines.join(u'\n') + u'\n';
}

} // namespace tactum::test
