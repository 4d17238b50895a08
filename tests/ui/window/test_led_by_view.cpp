// What the view tells, drags of its handles, regions, strokes, leads the tools of the window: what each
// changes, and what given up leaves nothing. Wrong itself if the view told something else than it does here:
// what it tells of clicks, drags and keys stands in test_view_said.
#include <algorithm>
#include <numeric>

#include <QTest>
#include <QUndoStack>

#include "tests/support/as_shown.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/told_window.h"
#include "ui/base/preferences.h"
#include "ui/tools/paint_tool.h"
#include "ui/tools/region_select.h"
#include "ui/view/scene_view.h"

namespace test_led_by_view {

using namespace tactum;
using tactum::testing::kFloor, tactum::testing::kLid, tactum::testing::kTop;

namespace {

QString figures(std::initializer_list<double> values) {
    QStringList texts;
    for (const double each : values)
        texts << QString::number(std::abs(each) < 1e-9 ? 0 : each, 'g', 4);
    return texts.join(u' ');
}

/// A pattern's place, and how much is painted of it.
QString textOf(const TexturePattern& pattern) {
    const Vec3 at = pattern.frame.translation, x = pattern.frame.rotate(Vec3::UnitX());
    QString text = QStringLiteral("mapping %1 size %2 at %3 x along %4")
                       .arg(int(pattern.mapping))
                       .arg(figures({pattern.size, pattern.offsetU, pattern.offsetV, pattern.rotation}),
                            figures({at.x(), at.y(), at.z()}), figures({x.x(), x.y(), x.z()}));
    if (!pattern.painted.values) return text;
    const std::vector<float>& all = pattern.painted.values->all();
    const auto [low, high] = std::ranges::minmax(all);
    return text +
           QStringLiteral(", painted %1 places from %2 to %3, together %4")
               .arg(std::ranges::count_if(all, [](float value) { return value != 0; }))
               .arg(figures({low}), figures({high}), figures({std::accumulate(all.begin(), all.end(), 0.0)}));
}

/// What figuresOf() leaves out: the patterns of the layers.
QStringList patternsOf(const Scene& scene) {
    QStringList lines;
    for (const SceneObject& object : scene.objects)
        for (const Surface& surface : object.surfaces)
            for (const TextureLayer& layer : surface.layers) {
                const QString name =
                    QString::fromStdString(object.name + ", " + surface.name + ", " + layer.name);
                lines << name + QStringLiteral(": ") + textOf(layer.pattern);
                if (layer.mask) lines << name + QStringLiteral(", mask: ") + textOf(*layer.mask);
            }
    return lines;
}

/// The known scene and a step on the ground, seen from above.
struct Above {
    Above() : effects(told.effects([this] { prepare(); })) {
        Scene scene = testing::knownScene();
        SceneObject step;
        step.name = "Step";
        step.geometry = testing::plates(1);
        step.pose.translation = {0.05, 0.05, 0.2};
        step.surfaces.resize(1);
        step.surfaces[0].name = "tread";
        scene.add(step);
        testing::adopt(told.document, scene);
        told.catchUp();
        Preferences::instance().set(Preferred::Flight, 1); // the camera jumps
        view.showStandardView(StandardView::Top);
        told.frames(2);
    }
    QPointF pixelOf(const Vec3& p_W) const { return *view.camera().project(p_W); }
    QRectF boxOf(const Vec3& a, const Vec3& b) const { return QRectF(pixelOf(a), pixelOf(b)).normalized(); }
    void note(const QString& words, const std::function<void()>& act) {
        const QStringList before = patternsOf(told.document.scene());
        QStringList now;
        effects.note(words, [&] {
            act();
            now = patternsOf(told.document.scene());
        });
        if (now != before) patterns += words + u'\n' + testing::changedLines(before, now);
    }
    /// Of a region: until it is known what lies there.
    void region(const QString& words, const std::function<void()>& act) {
        note(words, [&] {
            act();
            const auto& regions = *told.window->findChild<RegionSelect*>();
            if (!test::waitFor([&] { return !regions.working(); })) qFatal("it does not end");
        });
    }
    Document& document() { return told.document; }

    ToldWindow told;
    SceneView& view{told.window->view()};
    std::function<void()> prepare = [] {};
    WindowEffects effects;
    QString patterns; ///< each that a note changed
};

const SurfaceRef kTread{3, 0};

/// Of the middle of a surface of the known scene.
PickHit hitOn(SurfaceRef ref, const Vec3& at) {
    return {ref, ref == kFloor ? Index(2) : Index(0), at, Vec3::UnitY(), 0.5};
}

QString withKeys(const QString& words, Qt::KeyboardModifiers keys) {
    return words + (keys & Qt::ShiftModifier     ? QStringLiteral(", Shift")
                    : keys & Qt::ControlModifier ? QStringLiteral(", Ctrl")
                                                 : QString());
}

constexpr Qt::KeyboardModifiers kKeys[] = {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};

} // namespace

class TestLedByView : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() { useSettingsIn(folders_.next()); }

    void regionsTakeWhatLiesInThem();
    void theBrushSelects();
    void strokesOfThePaintBrush();
    void objectsAreArranged();
    void theCutIsLed();
    void mapsAndJointsAreLed();
};

void TestLedByView::regionsTakeWhatLiesInThem() {
    Above above;
    Document& document = above.document();
    const QRectF left = above.boxOf({-0.07, 0, -0.07}, {0.07, 0, 0.07}),
                 right = above.boxOf({0.13, 0, -0.07}, {0.27, 0, 0.07}),
                 both = above.boxOf({-0.07, 0, -0.07}, {0.27, 0, 0.07}),
                 none = above.boxOf({0.3, 0, 0.1}, {0.4, 0, 0.2}),
                 part = above.boxOf({-0.04, 0, 0.02}, {-0.01, 0, 0.04});
    above.prepare = [&] { document.select(SurfaceRefs{kTop}); };
    for (const bool triangles : {false, true})
        for (const bool through : {true, false}) {
            above.told.command(triangles ? "take-triangle" : "take-surface").trigger();
            above.told.command("through").setChecked(through);
            const QString with = QStringLiteral("%1, %2: ")
                                     .arg(triangles ? "triangles" : "surfaces", through ? "through" : "seen");
            for (const auto& [name, box] :
                 {std::pair("left", left), {"both", both}, {"none", none}, {"part", part}})
                for (const Qt::KeyboardModifiers keys : kKeys)
                    above.region(withKeys(with + QStringLiteral("box ") + QLatin1String(name), keys),
                                 [&, box = box] { emit above.view.boxDrawn(box, keys); });
            const QPolygonF lasso({right.topLeft(), right.topRight(), right.bottomRight()});
            above.region(with + QStringLiteral("lasso right"),
                         [&] { emit above.view.lassoDrawn(lasso, {}); });
        }
    document.setVisible(1, false);
    above.region(QStringLiteral("the left one hidden: box both"),
                 [&] { emit above.view.boxDrawn(both, {}); });
    document.setVisible(1, true);
    document.setSurfacesVisible({kLid}, false);
    above.region(QStringLiteral("the lid hidden: box both"), [&] { emit above.view.boxDrawn(both, {}); });
    COMPARE_SHOWN(above.effects.text(), "led-regions");
}

void TestLedByView::theBrushSelects() {
    Above above;
    Document& document = above.document();
    above.prepare = [&] { document.select(SurfaceRefs{kTread}); };
    const QPointF from = above.pixelOf({-0.03, 0.01, -0.03}), mid = above.pixelOf({0.02, 0.01, -0.02}),
                  far = above.pixelOf({0.2, 0, 0}), away = above.pixelOf({0.4, 0, 0.3});
    const auto stroke = [&](const QString& words, std::initializer_list<QPointF> places,
                            Qt::KeyboardModifiers keys, StrokeStep last) {
        above.region(withKeys(words, keys), [&] {
            QPointF before = *places.begin();
            for (const QPointF& at : places)
                emit above.view.selectBrushed(&at == places.begin() ? StrokeStep::Begin : StrokeStep::Move,
                                              std::exchange(before, at), at, keys);
            emit above.view.selectBrushed(last, before, before, keys);
        });
    };
    for (const bool triangles : {false, true}) {
        above.told.command(triangles ? "take-triangle" : "take-surface").trigger();
        above.told.command("select-brush").setChecked(true);
        const QString with = triangles ? QStringLiteral("triangles: ") : QStringLiteral("surfaces: ");
        for (const Qt::KeyboardModifiers keys : kKeys) {
            stroke(with + QStringLiteral("over one"), {from, mid}, keys, StrokeStep::End);
            stroke(with + QStringLiteral("over two"), {mid, far}, keys, StrokeStep::End);
            stroke(with + QStringLiteral("beside"), {away, away}, keys, StrokeStep::End);
        }
        stroke(with + QStringLiteral("given up"), {mid, far}, {}, StrokeStep::Cancel);
    }
    const auto step = [&](const char* id) {
        above.note(QLatin1String(id), [&] { above.told.command(id).trigger(); });
    };
    QString sizes;
    for (const char* id : {"brush-bigger", "brush-bigger", "brush-smaller"}) {
        step(id);
        sizes += QString::number(above.told.window->findChild<RegionSelect*>()->brushRadius()) + u'\n';
    }
    for (int i = 0; i < 40; ++i)
        above.told.command("brush-bigger").trigger();
    sizes += QString::number(above.told.window->findChild<RegionSelect*>()->brushRadius()) + u'\n';
    above.note(QStringLiteral("the brush is left"), [&] { emit above.view.selectBrushLeft(); });
    COMPARE_SHOWN(above.effects.text() + sizes, "led-brush");
}

void TestLedByView::strokesOfThePaintBrush() {
    Above above;
    Document& document = above.document();
    above.prepare = [&] { document.select({kFloor, kLid}); };
    above.told.command("paint").trigger();
    const auto& tool = *above.told.window->findChild<PaintTool*>();
    const auto stroke = [&](const QString& words, SurfaceRef ref, Qt::KeyboardModifiers keys = {},
                            StrokeStep last = StrokeStep::End) {
        above.note(withKeys(words, keys), [&] {
            // At a corner: what is painted lies at the corners of triangles.
            const Vec3 at(ref == kTop ? 0.15 : -0.05, ref == kFloor ? 0.01 : 0, 0.05);
            emit above.view.stroked(StrokeStep::Begin, hitOn(ref, at), keys);
            emit above.view.stroked(StrokeStep::Move, hitOn(ref, at + Vec3(0.02, 0, -0.01)), keys);
            emit above.view.stroked(StrokeStep::Lift, std::nullopt, keys);
            emit above.view.stroked(StrokeStep::Move, hitOn(ref, at + Vec3(0.1, 0, 0)), keys);
            emit above.view.stroked(last, std::nullopt, keys);
            if (!test::waitFor([&] { return !tool.working(); })) qFatal("the stroke does not end");
        });
    };
    for (const char* how : {"brush-add", "brush-subtract", "brush-set", "brush-smooth"}) {
        above.told.command(how).trigger();
        for (const Qt::KeyboardModifiers keys : kKeys)
            stroke(QLatin1String(how), kFloor, keys);
    }
    above.told.command("brush-add").trigger();
    stroke(QStringLiteral("given up"), kFloor, {}, StrokeStep::Cancel);
    stroke(QStringLiteral("what is not selected"), kTop);
    above.told.command("paint-mask").trigger();
    stroke(QStringLiteral("a mask that is not there"), kFloor);
    above.told.command("paint-static-friction").trigger();
    stroke(QStringLiteral("friction"), kFloor);
    document.setLocked({kLid}, true);
    stroke(QStringLiteral("one of two is locked"), kFloor);
    stroke(QStringLiteral("the locked one"), kLid);
    above.note(QStringLiteral("begun beside all"), [&] {
        emit above.view.stroked(StrokeStep::Begin, std::nullopt, {});
        emit above.view.stroked(StrokeStep::Move, hitOn(kFloor, {0.05, 0.01, 0.05}), {});
        emit above.view.stroked(StrokeStep::End, std::nullopt, {});
    });
    COMPARE_SHOWN(above.effects.text(), "led-strokes");
    COMPARE_SHOWN(above.patterns, "led-strokes-painted");
}

void TestLedByView::objectsAreArranged() {
    Above above;
    Document& document = above.document();
    above.told.command("arrange").trigger();
    const auto keys = [&](const QString& words, const QList<int>& pressed) {
        above.note(words, [&] {
            for (const int key : pressed)
                for (const auto what : {QEvent::KeyPress, QEvent::KeyRelease}) {
                    QKeyEvent event(what, key, {}, key < 0x80 ? QString(QChar(key)).toLower() : QString());
                    QApplication::sendEvent(&above.view, &event);
                }
        });
    };
    const int enter = Qt::Key_Return, nine = Qt::Key_9, zero = Qt::Key_0;
    above.prepare = [&] { document.selectObjects({1, 2}); };
    for (const char* pivot : {"pivot-middle", "pivot-each", "pivot-last", "pivot-world"}) {
        above.told.command(pivot).trigger();
        const QString with = QLatin1String(pivot);
        keys(with + QStringLiteral(": R Y 90"), {Qt::Key_R, Qt::Key_Y, nine, zero, enter});
        keys(with + QStringLiteral(": S 2"), {Qt::Key_S, Qt::Key_2, enter});
    }
    above.told.command("pivot-middle").trigger();
    keys(QStringLiteral("G X 30"), {Qt::Key_G, Qt::Key_X, Qt::Key_3, zero, enter});
    keys(QStringLiteral("G X 30, given up"), {Qt::Key_G, Qt::Key_X, Qt::Key_3, zero, Qt::Key_Escape});
    above.told.command("axes-own").trigger();
    keys(QStringLiteral("along its own axes: G X 30"), {Qt::Key_G, Qt::Key_X, Qt::Key_3, zero, enter});
    for (const char* id : {"drop", "align-y-low", "align-x-middle", "distribute-x"})
        above.note(QLatin1String(id), [&] { above.told.command(id).trigger(); });
    document.setLocked({kTop}, true);
    keys(QStringLiteral("one locked: G X 30"), {Qt::Key_G, Qt::Key_X, Qt::Key_3, zero, enter});
    document.setLocked({kLid}, true);
    keys(QStringLiteral("both locked: G X 30"), {Qt::Key_G, Qt::Key_X, Qt::Key_3, zero, enter});
    for (const char* id : {"drop", "align-y-low"})
        above.note(QLatin1String(id), [&] { above.told.command(id).trigger(); });
    above.note(QStringLiteral("asked for"), [&] { emit above.view.arrangeAsked(); });
    above.prepare = [&] { document.select({}); };
    above.note(QStringLiteral("asked for nothing"), [&] { emit above.view.arrangeAsked(); });
    COMPARE_SHOWN(above.effects.text(), "led-objects");
}

void TestLedByView::theCutIsLed() {
    Above above;
    above.note(QStringLiteral("cut"), [&] { above.told.command("section").trigger(); });
    SectionPlane plane = *above.view.section();
    const auto drag = [&](const QString& words, const Vec3& by, bool givenUp) {
        above.note(words, [&] {
            SectionPlane next = plane;
            next.frame.translation += by;
            emit above.view.sectionDragged(next);
            emit above.view.handlesLeft(givenUp);
        });
    };
    drag(QStringLiteral("led along"), {0.02, 0, 0}, false);
    drag(QStringLiteral("led away"), {5, 0, 0}, false);
    plane = *above.view.section();
    drag(QStringLiteral("given up"), {-0.3, 0, 0}, true);
    for (const char* id : {"section-y", "section-flip", "section-z", "section-x"})
        above.note(QLatin1String(id), [&] { above.told.command(id).trigger(); });
    above.note(QStringLiteral("another scene"),
               [&] { testing::adopt(above.document(), testing::knownScene()); });
    COMPARE_SHOWN(above.effects.text(), "led-cut");
}

void TestLedByView::mapsAndJointsAreLed() {
    Above above;
    Document& document = above.document();
    document.select(kTop);
    above.told.command("layer-noise").trigger();
    above.prepare = [&] { document.select(SurfaceRefs{kTop}); };
    above.note(QStringLiteral("the mapping"), [&] { above.told.command("mapping").trigger(); });
    const auto& shown = above.view.mapping().shown();
    if (shown) {
        MappingFrame frame = *shown;
        for (const bool givenUp : {false, true})
            above.note(givenUp ? QStringLiteral("led and given up") : QStringLiteral("led"), [&] {
                emit above.view.mappingGrabbed();
                frame.pose.translation += Vec3(0.01, 0, 0.02);
                frame.size *= 2;
                emit above.view.mappingDragged(frame);
                emit above.view.handlesLeft(givenUp);
            });
    }
    above.note(QStringLiteral("asked for"), [&] { emit above.view.mappingAsked(); });
    for (const char* hold : {"body-hinge", "body-slider"}) {
        above.told.command(hold).trigger();
        above.told.frames(2);
        const auto mark = above.view.joint().mark();
        if (!mark) qFatal("no joint");
        for (const bool givenUp : {false, true})
            above.note(QLatin1String(hold) +
                           (givenUp ? QStringLiteral(" led and given up") : QStringLiteral(" led")),
                       [&] {
                           emit above.view.jointGrabbed();
                           JointMark next = *mark;
                           next.at += Vec3(0.01, 0, 0);
                           next.low = -0.3;
                           next.hasLow = true;
                           emit above.view.jointDragged(next);
                           emit above.view.handlesLeft(givenUp);
                       });
    }
    COMPARE_SHOWN(above.effects.text() + above.patterns, "led-maps");
}

TACTUM_GUI_TEST(TestLedByView)

} // namespace test_led_by_view

#include "test_led_by_view.moc"
