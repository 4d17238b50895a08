// What a person does in the view and beside it: a click with each way to select, keys and drags with each
// tool, the fields of the tools, preferences. And what the window is put together of.
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>

#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/window_effects.h"
#include "ui/base/preferences.h"
#include "ui/base/shortcuts.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/tool_strip.h"

namespace test_window_effects {

using namespace tactum;

namespace {

/// The window with the known scene, seen from above.
struct Above {
    Above() {
        tactum::testing::adopt(program.document, tactum::testing::knownScene());
        if (!test::waitFor([&] { return program.caughtUp(); })) qFatal("the scene is not felt");
        Preferences::instance().set(Preferred::Flight, 1); // the camera jumps
        view.showStandardView(StandardView::Top);
        program.frames(30);
    }

    /// Of a place of the scene.
    QPoint pixelOf(const Vec3& p_W) const { return view.camera().project(p_W)->toPoint(); }
    void click(const Vec3& p_W, Qt::KeyboardModifiers keys = {}) const {
        QTest::mouseClick(program.window->windowHandle(), Qt::LeftButton, keys,
                          view.mapTo(program.window.get(), pixelOf(p_W)));
    }
    /// By parts of the view's shorter side.
    void drag(Qt::MouseButton button, QPointF by) const {
        const QPoint from = view.rect().center();
        const QPoint to = from + (by * std::min(view.width(), view.height())).toPoint();
        tactum::testing::mouse(view, QEvent::MouseButtonPress, from, button);
        QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(QPointF(to)), Qt::NoButton, button, {});
        QApplication::sendEvent(&view, &move);
        tactum::testing::mouse(view, QEvent::MouseButtonRelease, to, button);
    }
    /// To the view itself: Qt Test does not know each of them.
    void key(int key, Qt::KeyboardModifiers modifiers = {}) const {
        const QString text = key < 0x80 ? QString(QChar(key)).toLower() : QString();
        for (const auto what : {QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event(what, key, modifiers, text);
            QApplication::sendEvent(&view, &event);
        }
    }

    TouchedWindow program;
    SceneView& view{program.window->view()};
};

/// Without menus, and without what is inside of docks and of what tells what happens, which have tests of
/// their own. How large strips are is up to the fonts.
QString frameOf(const QString& shown) {
    static const QRegularExpression kLeftOut(QStringLiteral("^(QMenu|QTabBar)"));
    static const QRegularExpression kClosed(
        QStringLiteral("^(QDockWidget|StatusStrip|StartPage|SceneView|StudyPage|TouchHint) ?"));
    static const QRegularExpression kSizes(QStringLiteral(" (minimum|maximum)(Width|Height)=\\d+"));
    QStringList lines;
    qsizetype deepest = 1000;
    for (const QString& line : shown.split(u'\n')) {
        const QString words = line.trimmed();
        const qsizetype depth = line.indexOf(words);
        if (depth > deepest) continue;
        const bool leftOut = kLeftOut.match(words).hasMatch(), closed = kClosed.match(words).hasMatch();
        deepest = leftOut || closed ? depth : 1000;
        if (leftOut) continue;
        lines << (closed ? line.section(u':', 0, 0) : line);
        if (words.startsWith(QStringLiteral("ToolStrip"))) lines.back().remove(kSizes);
    }
    return lines.join(u'\n');
}

} // namespace

class TestWindowEffects : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folders_.next()); }

    void aClickTakesWhatIsChosen();
    void keysLeadTheHandles();
    void fieldsOfTheToolsAreStepped();
    void preferencesAreFollowed();
    void strokesPaint();
    void whatHappensIsSaid();
    void theWindowIsPutTogether();
};

void TestWindowEffects::aClickTakesWhatIsChosen() {
    Above above;
    Document& document = above.program.document;
    WindowEffects effects(above.program, [&] { document.select(SurfaceRef{1, 1}); });
    above.program.command("select").trigger();
    const Vec3 lid(0.02, 0.01, 0.01), top(0.22, 0, 0.01), beside(0.1, 0, 0.04);
    for (const Command& command : commands())
        if (QByteArray(command.id).startsWith("take-") && QByteArray(command.menu) == "Select") {
            above.program.command(command.id).trigger();
            effects.note(QString::fromLatin1(command.id), [&] { above.click(lid); });
        }
    above.program.command("take-surface").trigger();
    effects.note(QStringLiteral("another one"), [&] { above.click(top); });
    effects.note(QStringLiteral("another one, with Shift"), [&] { above.click(top, Qt::ShiftModifier); });
    effects.note(QStringLiteral("another one, with Ctrl"), [&] { above.click(top, Qt::ControlModifier); });
    effects.note(QStringLiteral("beside all"), [&] { above.click(beside); });
    effects.note(QStringLiteral("beside all, with Shift"), [&] { above.click(beside, Qt::ShiftModifier); });
    for (const char* region : {"box", "lasso"})
        effects.note(QLatin1String(region), [&] {
            above.program.command(region).trigger();
            above.drag(Qt::LeftButton, {0.3, 0.3});
        });
    const Vec3 corner(0.05, 0.01, 0.05), other(0.15, 0, 0.05), far(0.25, 0, -0.05);
    above.program.command("measure").trigger();
    effects.note(QStringLiteral("measure: a corner"), [&] { above.click(corner); });
    effects.note(QStringLiteral("measure: another one"), [&] { above.click(other); });
    effects.note(QStringLiteral("measure: copied"), [&] { above.program.command("measure-copy").trigger(); });
    effects.note(QStringLiteral("measure: a third one"), [&] { above.click(far); });
    effects.note(QStringLiteral("measure: copied"), [&] { above.program.command("measure-copy").trigger(); });
    effects.note(QStringLiteral("measure: beside all"), [&] { above.click(beside); });
    effects.note(QStringLiteral("measure: Esc"), [&] { above.key(Qt::Key_Escape); });
    effects.note(QStringLiteral("measure: Esc again"), [&] { above.key(Qt::Key_Escape); });
    for (const auto& [tool, place] :
         {std::pair("touch", lid), {"select", top}, {"arrange", top}, {"arrange", beside}}) {
        above.program.command(tool).trigger();
        effects.note(QStringLiteral("%1: right button").arg(QLatin1String(tool)),
                     [&, at = above.pixelOf(place)] {
                         for (const auto what : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease})
                             tactum::testing::mouse(above.view, what, at, Qt::RightButton);
                     });
    }
    COMPARE_SHOWN(effects.text(), "effects-clicks");
}

void TestWindowEffects::keysLeadTheHandles() {
    Above above;
    Document& document = above.program.document;
    WindowEffects effects(above.program, [&] { document.select(SurfaceRef{2, 0}); });
    above.view.setFocus();
    const auto keys = [&](const QString& words, const QList<int>& pressed) {
        effects.note(words, [&] {
            for (const int each : pressed)
                above.key(each);
        });
    };
    for (const char* tool : {"touch", "select", "arrange"}) {
        above.program.command(tool).trigger();
        const QString name = QLatin1String(tool);
        keys(name + QStringLiteral(": G X 2 0 Enter"),
             {Qt::Key_G, Qt::Key_X, Qt::Key_2, Qt::Key_0, Qt::Key_Return});
        keys(name + QStringLiteral(": Esc"), {Qt::Key_Escape});
    }
    using Keys = QList<int>;
    const int g = Qt::Key_G, r = Qt::Key_R, s = Qt::Key_S, x = Qt::Key_X, y = Qt::Key_Y, z = Qt::Key_Z;
    const int enter = Qt::Key_Return, three = Qt::Key_3, zero = Qt::Key_0;
    for (const auto& [words, pressed] :
         {std::pair<const char*, Keys>{"G Y 3 0 Enter", {g, y, three, zero, enter}},
          {"G Z 3 0 Enter", {g, z, three, zero, enter}},
          {"G Z - 3 Enter", {g, z, Qt::Key_Minus, three, enter}},
          {"R X 3 0 Enter", {r, x, three, zero, enter}},
          {"R Y 3 0 Enter", {r, y, three, zero, enter}},
          {"R Z 3 Back 3 0 Enter", {r, z, three, Qt::Key_Backspace, three, zero, enter}},
          {"S 3 Enter", {s, three, enter}},
          {"S 0 . 3 Enter", {s, zero, Qt::Key_Period, three, enter}},
          {"S 0 . 0 0 0 0 0 1 Enter",
           {s, zero, Qt::Key_Period, zero, zero, zero, zero, zero, Qt::Key_1, enter}},
          {"S 3 0 0 0 0 0 0 0 Enter", {s, three, zero, zero, zero, zero, zero, zero, zero, enter}},
          {"G X 3 0 0 0 0 0 0 0 Enter", {g, x, three, zero, zero, zero, zero, zero, zero, zero, enter}},
          {"G X 3 Esc", {g, x, three, Qt::Key_Escape}},
          {"G A 3 Enter", {g, Qt::Key_A, three, enter}},
          {"Home", {Qt::Key_Home}}})
        keys(QLatin1String(words), pressed);
    for (const int pad : {Qt::Key_1, Qt::Key_3, Qt::Key_7, Qt::Key_0, Qt::Key_4, Qt::Key_6, Qt::Key_8,
                          Qt::Key_2, Qt::Key_5, Qt::Key_5, Qt::Key_Plus, Qt::Key_Minus})
        effects.note(QStringLiteral("number pad %1").arg(QChar(pad)),
                     [&] { above.key(pad, Qt::KeypadModifier); });
    document.setLocked({SurfaceRef{2, 0}}, true);
    keys(QStringLiteral("locked: G X 3 Enter"), {g, x, three, enter});
    COMPARE_SHOWN(effects.text(), "effects-keys");
}

void TestWindowEffects::fieldsOfTheToolsAreStepped() {
    Above above;
    WindowEffects effects(above.program, [] {});
    for (const char* tool : {"select", "paint", "arrange", "measure", "section"}) {
        above.program.command(tool).trigger();
        above.program.frames(2);
        for (const auto* strip : above.program.window->findChildren<ToolStrip*>()) {
            if (!strip->isVisible()) continue;
            for (auto* field : strip->findChildren<QDoubleSpinBox*>()) {
                const auto step = [&](int by) {
                    effects.note(QStringLiteral("%1, %2 by %3")
                                     .arg(strip->objectName(), field->accessibleName())
                                     .arg(by),
                                 [&] { field->stepBy(by); });
                };
                step(3);
                step(-1000);
                step(1000);
            }
        }
    }
    COMPARE_SHOWN(effects.text(), "effects-fields");
}

void TestWindowEffects::preferencesAreFollowed() {
    Above above;
    above.view.showStandardView(StandardView::Isometric);
    WindowEffects effects(above.program, [] {});
    const auto gestures = [&](const QString& words) {
        for (const auto& [button, name] : {std::pair(Qt::MiddleButton, "middle"), {Qt::RightButton, "right"}})
            effects.note(QStringLiteral("%1: %2 drag").arg(words, QLatin1String(name)), [&] {
                above.drag(button, {0.1, 0.05});
            });
        effects.note(words + QStringLiteral(": wheel"),
                     [&] { above.program.wheel(above.program.centre(), 2); });
    };
    gestures(QStringLiteral("at first"));
    for (const Preference& each : preferenceTable()) {
        const Parameter& range = each.parameter;
        // A window that comes in another size or language has tests of its own; without flights it stands.
        if (each.id == Preferred::Flight || each.id == Preferred::Language) continue;
        Preferences& all = Preferences::instance();
        const double was = all.value(each.id);
        const QString name = QString::fromUtf8(range.key.data());
        const double other = was + range.step > range.maximum ? range.minimum : was + range.step;
        effects.note(name, [&] { all.set(each.id, other); });
        if (QByteArray(each.page) == preference(Preferred::DragTurns).page) gestures(name);
        effects.note(name + QStringLiteral(" beyond all"), [&] { all.set(each.id, 1e9); });
        effects.note(name + QStringLiteral(" as before"), [&] { all.set(each.id, was); });
    }
    COMPARE_SHOWN(effects.text(), "effects-preferences");
}

void TestWindowEffects::strokesPaint() {
    Above above;
    Document& document = above.program.document;
    WindowEffects effects(above.program, [&] { document.select(SurfaceRef{2, 0}); });
    above.program.command("paint").trigger();
    const auto stroke = [&](const QString& words) {
        effects.note(words, [&] {
            const QPoint from = above.pixelOf({0.18, 0, 0}), to = above.pixelOf({0.22, 0, 0.01});
            tactum::testing::mouse(above.view, QEvent::MouseButtonPress, from);
            QMouseEvent move(QEvent::MouseMove, to, above.view.mapToGlobal(QPointF(to)), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(&above.view, &move);
            tactum::testing::mouse(above.view, QEvent::MouseButtonRelease, to);
        });
    };
    for (const char* what : {"paint-height", "paint-static-friction", "paint-dynamic-friction",
                             "paint-viscosity", "paint-stiffness", "paint-layer", "paint-mask"}) {
        above.program.command(what).trigger();
        stroke(QLatin1String(what));
    }
    above.program.command("paint-height").trigger();
    for (const char* how : {"brush-subtract", "brush-set", "brush-smooth"}) {
        above.program.command(how).trigger();
        stroke(QLatin1String(how));
    }
    document.setLocked({SurfaceRef{2, 0}}, true);
    stroke(QStringLiteral("locked"));
    COMPARE_SHOWN(effects.text(), "effects-strokes");
}

/// The sentences of what comes from elsewhere: another form of the file, models that came in.
void TestWindowEffects::whatHappensIsSaid() {
    Above above;
    Document& document = above.program.document;
    WindowEffects effects(above.program, [] {});
    const auto updated = [&](const char* words, const std::function<void(GeometryUpdate&)>& change) {
        GeometryUpdate update;
        update.file = "/models/pot.obj";
        update.surfaces = update.withFeel = update.surfacesBefore = 3;
        change(update);
        effects.note(QLatin1String(words), [&] { emit document.geometryUpdated(update); });
    };
    updated("all found", [](GeometryUpdate&) {});
    updated("nothing changed", [](GeometryUpdate& update) { update.changed = false; });
    updated("one lost", [](GeometryUpdate& update) { update.surfacesLost = 1; });
    updated("two lost", [](GeometryUpdate& update) { update.surfacesLost = 2; });
    updated("one new", [](GeometryUpdate& update) { update.withFeel = 2; });
    updated("two new", [](GeometryUpdate& update) { update.withFeel = 1; });
    updated("back", [](GeometryUpdate& update) { update.back = 2; });
    updated("back, and one lost", [](GeometryUpdate& update) { update.back = update.surfacesLost = 1; });
    updated("a layer lost", [](GeometryUpdate& update) { update.layersLost = 1; });
    updated("bodies lost", [](GeometryUpdate& update) { update.bodiesLost = 2; });
    updated("larger", [](GeometryUpdate& update) { update.grown = 4; });
    updated("smaller", [](GeometryUpdate& update) { update.grown = 0.1; });
    updated("a little larger", [](GeometryUpdate& update) { update.grown = 2.9; });
    updated("in another unit", [](GeometryUpdate& update) {
        update.grown = 1e-3;
        update.axesBefore = FileAxes{1, false};
        update.axes = FileAxes{1e-3, false};
    });
    const auto added = [&](const char* words, const SceneAddition& addition) {
        effects.note(QLatin1String(words), [&] { emit document.added(addition); });
    };
    const std::filesystem::path pot = "/models/pot.obj", lid = "/models/lid.obj";
    added("one added", {{pot}, {1}, {}, {}});
    added("two added", {{pot, lid}, {1, 2}, {}, {}});
    added("scaled", {{pot}, {1}, {{pot, 0.2}}, {}});
    added("both scaled", {{pot, lid}, {1, 2}, {{pot, 0.2}, {lid, 0.1}}, {}});
    added("one refused", {{pot}, {1}, {}, {"lid.obj is empty"}});
    const auto says = [&](const char* words, const std::function<void()>& act) {
        effects.note(QLatin1String(words), act);
    };
    says("noted", [&] { emit document.noted(QStringLiteral("Something is noted.")); });
    says("not opened", [&] { emit document.openFailed(QStringLiteral("It cannot be opened.")); });
    says("not saved", [&] { emit document.saveFailed(QStringLiteral("It cannot be saved.")); });
    says("saved", [&] { emit document.saved(QStringLiteral("/models/pot.glb")); });
    says("exported", [&] { emit document.exported(QStringLiteral("/models/pot.tactum")); });
    says("an edit ended", [&] { emit document.editEnded(QStringLiteral("It is split.")); });
    says("the button of the palette",
         [&] { above.program.window->findChild<QToolButton*>(QStringLiteral("palette-button"))->click(); });
    above.program.command("present").trigger();
    says("Esc leaves the presentation", [&] { QTest::keyClick(&above.view, Qt::Key_Escape); });
    says("Esc without one", [&] { QTest::keyClick(&above.view, Qt::Key_Escape); });
    COMPARE_SHOWN(effects.text(), "effects-said");
}

void TestWindowEffects::theWindowIsPutTogether() {
    Above above;
    COMPARE_SHOWN(frameOf(test::shownIn(*above.program.window)), "frame");
}

TACTUM_GUI_TEST(TestWindowEffects)

} // namespace test_window_effects

#include "test_window_effects.moc"
