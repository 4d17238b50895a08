// A scene of many small bodies in the window's tests.
#pragma once

#include <filesystem>

#include <QString>
#include <QTemporaryDir>

#include "core/files/save_scene.h"
#include "core/scene/scene.h"
#include "tests/support/movers.h"
#include "tests/support/soups.h"

namespace tactum::test {

/// A box of twelve triangles about its origin; corners are shared.
inline Soup crowdBox(double half) {
    TriangleSoup soup;
    for (int i = 0; i < 8; ++i)
        soup.positions.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    const std::array<Index, 4> sides[] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                          {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    for (const auto& s : sides) {
        soup.triangles.push_back({s[0], s[1], s[2]});
        soup.triangles.push_back({s[0], s[2], s[3]});
    }
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

/// `count` boxes beside each other on a square of 0.2 m in the plane z = 0, row by row; no two of one shape,
/// so that nothing is shared, and each of a colour of its own. Every tenth swings along z.
inline Scene crowdScene(int count) {
    Scene scene;
    const int row = int(std::ceil(std::sqrt(count)));
    const double pitch = 0.2 / row;
    for (int i = 0; i < count; ++i) {
        SceneObject box;
        box.id = ObjectId(i + 1);
        box.name = "box " + std::to_string(i);
        box.geometry = crowdBox(0.35 * pitch * (1 - 1e-5 * i));
        box.pose.translation = Vec3(pitch * (i % row) - 0.1, pitch * (i / row) - 0.1, 0);
        box.surfaces.emplace_back().name = "skin " + std::to_string(i);
        box.surfaces[0].colour = {0.2f + 0.6f * float(i % row) / float(row), 0.5f,
                                  0.2f + 0.6f * float(i / row) / float(row)};
        if (i % 10 == 9) box.motion = swinging(Vec3(0, 0, 0.3 * pitch), 0.5);
        scene.objects.push_back(std::move(box));
    }
    return scene;
}

inline QString writeCrowd(const QTemporaryDir& folder, int count) {
    const QString file = folder.filePath(QStringLiteral("crowd-%1.glb").arg(count));
    const auto saved = saveScene(crowdScene(count), std::filesystem::path(file.toStdU16String()));
    return saved ? file : QString();
}

} // namespace tactum::test
