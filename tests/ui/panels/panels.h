// What tests of panels share: an application with settings of its own, and a scene of a few known values.
#pragma once

#include <algorithm>
#include <vector>

#include <QApplication>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/waiting.h"
#include "ui/base/style.h"
#include "ui/document/document.h"

namespace tactum::testing {

/// Before the application: names under which the settings of the test are kept.
inline void namePanelTest(const char* name) {
    QCoreApplication::setOrganizationName(QStringLiteral("TactumTest"));
    QCoreApplication::setApplicationName(QLatin1String(name));
}

/// The widget of a panel by its name; who asks for one that is not there ends.
template <class T> T& part(QWidget& in, const char* name) {
    auto* found = in.findChild<T*>(QLatin1String(name));
    if (!found) qFatal("no %s", name);
    return *found;
}

/// To the widget itself: with no pointer of the screen, so that nothing comes between.
inline void mouse(QWidget& widget, QEvent::Type what, QPoint at, Qt::MouseButton button = Qt::LeftButton,
                  Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(what, at, widget.mapToGlobal(QPointF(at)),
                      what == QEvent::MouseMove ? Qt::NoButton : button,
                      what == QEvent::MouseButtonRelease ? Qt::MouseButtons() : button, keys);
    QApplication::sendEvent(&widget, &event);
}

/// As `diff` says it: the lines that went and those that came, in their order, around what both have in
/// common.
inline QString changedLines(const QStringList& before, const QStringList& after) {
    const qsizetype m = before.size(), n = after.size();
    std::vector<std::vector<int>> common(std::size_t(m) + 1,
                                         std::vector<int>(std::size_t(n) + 1)); // from i, j on
    const auto at = [&](qsizetype i, qsizetype j) -> int& { return common[std::size_t(i)][std::size_t(j)]; };
    for (qsizetype i = m; i-- > 0;)
        for (qsizetype j = n; j-- > 0;)
            at(i, j) = before[i] == after[j] ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    QString text;
    for (qsizetype i = 0, j = 0; i < m || j < n;) {
        if (i < m && j < n && before[i] == after[j])
            ++i, ++j;
        else if (j == n || (i < m && at(i + 1, j) >= at(i, j + 1)))
            text += QStringLiteral("  - ") + before[i++] + u'\n';
        else
            text += QStringLiteral("  + ") + after[j++] + u'\n';
    }
    return text;
}

/// What is shown in each state otherwise than in the one before.
class States {
public:
    explicit States(const QString& first) : before_(first.split(u'\n')) {}
    void note(const QString& state, const QString& shown) {
        const QStringList now = shown.split(u'\n');
        text_ += state + QStringLiteral(":\n") + changedLines(before_, now);
        before_ = now;
    }
    const QString& text() const { return text_; }

private:
    QStringList before_;
    QString text_;
};

/// A square of two triangles for each of `surfaces`, one above the other, 1 cm apart; with texture
/// coordinates and normals where they are asked for.
inline std::shared_ptr<const TriangleSoup> plates(int surfaces, bool uvs = false, bool normals = false) {
    auto soup = std::make_shared<TriangleSoup>();
    for (int i = 0; i < surfaces; ++i) {
        const auto first = Index(soup->positions.size());
        for (const auto& [x, z] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            soup->positions.emplace_back(0.05 * x, 0.01 * i, 0.05 * z);
        for (const auto& corners : {std::array<Index, 3>{0, 2, 1}, std::array<Index, 3>{0, 3, 2}}) {
            soup->triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
            soup->surfaceOf.push_back(Index(i));
            for (const Index corner : corners) {
                if (uvs) soup->cornerUvs.emplace_back(corner == 1 || corner == 2, corner > 1);
                if (normals) soup->cornerNormals.emplace_back(0.f, 1.f, 0.f);
            }
        }
    }
    return soup;
}

/// Two objects: "Box" with the surfaces "lid" and "floor", which feel different, and "Plate" with "top".
inline Scene knownScene() {
    Scene scene;
    SceneObject box;
    box.name = "Box";
    box.geometry = plates(2);
    box.surfaces.resize(2);
    box.surfaces[0].name = "lid";
    box.surfaces[0].material = {500, 1.5, 0.6, 0.4, 2};
    box.surfaces[0].colour = {1, 0, 0};
    box.surfaces[1].name = "floor";
    box.surfaces[1].sides = Sides::Front;
    scene.add(box);
    SceneObject plate;
    plate.name = "Plate";
    plate.geometry = plates(1, true, true);
    plate.pose.translation = {0.2, 0, 0};
    plate.surfaces.resize(1);
    plate.surfaces[0].name = "top";
    scene.add(plate);
    return scene;
}

inline constexpr SurfaceRef kLid{1, 0}, kFloor{1, 1}, kTop{2, 0}; ///< of the known scene

inline TextureLayer layerOf(const char* name, TextureSource source) {
    TextureLayer layer;
    layer.name = name;
    layer.pattern.source = source;
    return layer;
}

/// A document with a scene that came from no file, of which nothing is selected.
inline void adopt(Document& document, const Scene& scene, std::vector<Finding> findings = {}) {
    document.adoptRecovered({scene, std::move(findings), true}, FileStamp(), true);
    document.select({});
}

} // namespace tactum::testing
