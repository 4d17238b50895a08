// What each command does: with several objects selected, with one surface and its layers, and what it changes
// of the view. Wrong itself if something that a command changes stood in none of the lines: what it does
// would be nothing.
#include <QTest>
#include <QUndoStack>

#include "tests/support/as_shown.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_effects.h"

#include "ui/base/shortcuts.h"

namespace test_command_effects {

using namespace tactum;

namespace {

/// The known scene, with a third object at another place and another size.
Scene threeObjects() {
    Scene scene = tactum::testing::knownScene();
    SceneObject step;
    step.name = "Step";
    step.geometry = tactum::testing::plates(1);
    step.pose.translation = {0.33, 0.05, 0.12};
    step.surfaces.resize(1);
    step.surfaces[0].name = "tread";
    scene.add(step);
    return scene;
}

/// The window with it.
struct Known {
    Known() {
        tactum::testing::adopt(program.document, threeObjects());
        if (!test::waitFor([&] { return program.caughtUp(); })) qFatal("the scene is not felt");
        program.frames(30);
    }
    TouchedWindow program;
};

bool isOf(const Command& command, const QStringList& menus) {
    return menus.contains(QString::fromLatin1(command.menu).section(u'/', 0, 0).remove(u'&'));
}

/// Those that are no edit, or take the scene away.
bool isElsewhere(const QString& id) {
    static const QStringList elsewhere{
        "new",           "new-ground",  "connect",    "quit",        "save-recording",
        "record-stroke", "take-stroke", "fold-plots", "sound",       "record-video",
        "study-run",     "self-test",   "rumble",     "armed",       "stop",
        "undo",          "redo",        "theme-dark", "theme-light", "theme-system"};
    return elsewhere.contains(id);
}

QString effectsOf(TouchedWindow& program, const QStringList& menus, std::function<void()> prepare) {
    WindowEffects effects(program, std::move(prepare));
    for (const Command& command : commands())
        if (isOf(command, menus) && !isElsewhere(QLatin1String(command.id))) effects.choose(command.id);
    return effects.text();
}

} // namespace

class TestCommandEffects : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folders_.next()); }

    void onSeveralObjects();
    void onOneSurface();
    void onTheView();
    void onAStudy();
};

void TestCommandEffects::onSeveralObjects() {
    Known known;
    const auto all = [&] { known.program.document.select({{1, 0}, {1, 1}, {2, 0}, {3, 0}}); };
    COMPARE_SHOWN(effectsOf(known.program, {"File", "Edit", "Select", "Surface", "Motion"}, all),
                  "effects-objects");
}

void TestCommandEffects::onOneSurface() {
    Known known;
    Document& document = known.program.document;
    document.select(SurfaceRef{1, 0});
    for (const char* layer : {"layer-noise", "layer-grooves", "mark-a"})
        known.program.command(layer).trigger();
    const auto one = [&] { document.select(SurfaceRef{1, 0}); };
    COMPARE_SHOWN(
        effectsOf(known.program, {"Select", "Surface", "Layer", "Tools", "Compare", "Study", "Device"}, one),
        "effects-surface");
}

void TestCommandEffects::onTheView() {
    Known known;
    COMPARE_SHOWN(effectsOf(known.program, {"View", "Help"}, [&] { known.program.document.select({}); }),
                  "effects-view");
}

void TestCommandEffects::onAStudy() {
    Known known;
    for (const char* name : {"soft", "stiff"}) {
        answerTextDialog(QLatin1String(name));
        known.program.command("study-keep").trigger();
        known.program.document.setProxyRadius(known.program.document.scene().proxyRadius + 0.001);
    }
    WindowEffects effects(known.program, [] {});
    for (const char* id : {"study-show", "study-replace", "study-show", "study-remove", "study-show",
                           "study-remove", "study-edit", "study-save", "study-open", "study-new"})
        effects.choose(id);
    COMPARE_SHOWN(effects.text(), "effects-study");
}

TACTUM_GUI_TEST(TestCommandEffects)

} // namespace test_command_effects

#include "test_command_effects.moc"
