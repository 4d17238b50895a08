// What a scene keeps under names, sets of triangles and cameras: what the menus offer, what each verb
// changes, which names are refused. And presets that are dropped. Wrong itself if a menu had an entry that
// its line does not name.
#include <QInputDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QRegularExpression>
#include <QTest>
#include <QUndoStack>

#include "core/presets/preset_file.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/document/scene_figures.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/told_window.h"
#include "ui/base/preferences.h"
#include "ui/panels/preset_library.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_kept_names {

using namespace tactum;
using tactum::testing::kFloor, tactum::testing::kLid, tactum::testing::kTop;

namespace {

/// As a person does who opens it: what it offers, with what is in the menus inside.
QString entriesOf(const QMenu& menu, const QString& indent = QStringLiteral("  ")) {
    QString text;
    for (const QAction* each : menu.actions()) {
        if (each->isSeparator()) continue;
        text += indent + each->text() + (each->isEnabled() ? QString() : QStringLiteral(" (off)")) + u'\n';
        if (const QMenu* inside = each->menu()) text += entriesOf(*inside, indent + QStringLiteral("  "));
    }
    return text;
}

/// Without where cameras stand: how large the view is, and how far away all is seen, is up to the fonts.
QStringList namesOf(const Scene& scene) {
    static const QRegularExpression kPlaces(QStringLiteral("/(translation|rotation|znear|yfov|ahead)\\b"));
    QStringList lines = testing::figuresOf(scene);
    lines.removeIf([](const QString& line) {
        return (line.startsWith(QStringLiteral("/nodes")) || line.startsWith(QStringLiteral("/cameras"))) &&
               kPlaces.match(line).hasMatch();
    });
    return lines;
}

/// A menu that is filled when it opens, and the window around it.
struct Desk {
    explicit Desk(const char* menuName) {
        testing::adopt(told.document, testing::knownScene());
        told.catchUp();
        Preferences::instance().set(Preferred::Flight, 1); // the camera jumps
        menu = told.window->findChild<QMenu*>(QLatin1String(menuName));
        if (!menu) qFatal("no menu");
    }
    void note(const QString& words, const std::function<void()>& act,
              std::function<void(QDialog&)> answer = {}) {
        if (answer) effects.answerNext(std::move(answer));
        // What was kept stays: the next step goes on with it.
        const QStringList before = namesOf(told.document.scene());
        act();
        (void)test::waitFor([&] { return !QApplication::activeModalWidget(); });
        text += words + u'\n' + testing::changedLines(before, namesOf(told.document.scene()));
        const auto& notice = *told.window->findChild<NoticeBar*>();
        if (!notice.isHidden() && notice.text() != said)
            text += QStringLiteral("  says: ") + notice.text() + u'\n';
        said = notice.text();
        emit menu->aboutToShow();
        text += entriesOf(*menu);
    }
    /// Of the entry below a verb, or of the menu itself where that is empty.
    void choose(const char* verb, const QString& name, std::function<void(QDialog&)> answer = {}) {
        emit menu->aboutToShow();
        const QMenu& from = *verb ? *menu->findChild<QMenu*>(QLatin1String(verb)) : *menu;
        for (QAction* each : from.actions())
            if (each->text().remove(u'&').section(u'\t', 0, 0) == name)
                return note(
                    QLatin1String(verb) + u' ' + name, [&] { each->trigger(); }, std::move(answer));
        qFatal("no entry %s", qPrintable(name));
    }
    void command(const char* id, std::function<void(QDialog&)> answer = {}) {
        note(
            QLatin1String(id), [&] { told.command(id).trigger(); }, std::move(answer));
    }

    ToldWindow told;
    WindowEffects effects{*told.window, told.document, [] { return true; }, [] {}};
    QMenu* menu = nullptr;
    QString text, said;
};

std::function<void(QDialog&)> named(const QString& name) {
    return [name](QDialog& dialog) {
        auto& input = dynamic_cast<QInputDialog&>(dialog);
        input.setTextValue(name);
        input.accept();
        if (input.isVisible()) input.reject(); // a name that cannot be
    };
}

} // namespace

class TestKeptNames : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() { useSettingsIn(folders_.next()); }

    void setsAreKept() {
        Desk desk("sets");
        Document& document = desk.told.document;
        document.select({});
        desk.command("set-keep"); // nothing is selected
        document.select(SurfaceRefs{kLid});
        desk.command("set-keep", named(QStringLiteral("upper")));
        desk.command("set-keep"); // given up
        document.selectFaces({2, {0}});
        desk.command("set-keep", named(QStringLiteral("upper"))); // has one already
        desk.command("set-keep", named(QStringLiteral("half")));
        desk.choose("set-add", QStringLiteral("upper"));
        desk.choose("", QStringLiteral("half"));
        desk.choose("", QStringLiteral("upper"));
        desk.choose("set-rename", QStringLiteral("upper"), named(QStringLiteral("half")));
        desk.choose("set-rename", QStringLiteral("upper"), named(QStringLiteral("both & more")));
        desk.choose("set-replace", QStringLiteral("half"));
        desk.choose("set-remove", QStringLiteral("half"));
        document.select({});
        document.selectFaces({});
        desk.note(QStringLiteral("nothing selected"), [] {});
        while (document.history().canUndo())
            document.history().undo();
        desk.note(QStringLiteral("undone"), [] {});
        COMPARE_SHOWN(desk.text, "names-sets");
    }

    void camerasAreKept() {
        Desk desk("View/&Camera/&Kept cameras");
        Document& document = desk.told.document;
        SceneView& view = desk.told.window->view();
        desk.command("camera-keep", named(QStringLiteral("home")));
        view.showStandardView(StandardView::Top);
        desk.command("camera-keep", named(QStringLiteral("home"))); // has one already
        desk.command("camera-keep", named(QStringLiteral("above")));
        desk.choose("", QStringLiteral("home"));
        COMPARE_NEAR(view.camera().forward().y(), -0.375, 1e-3, ""); // as it was at first
        desk.choose("camera-rename", QStringLiteral("home"), named(QStringLiteral("above")));
        desk.choose("camera-rename", QStringLiteral("home"), named(QStringLiteral("corner")));
        desk.choose("camera-replace", QStringLiteral("above"));
        desk.choose("camera-remove", QStringLiteral("corner"));
        while (document.history().canUndo())
            document.history().undo();
        desk.note(QStringLiteral("undone"), [] {});
        COMPARE_SHOWN(desk.text, "names-cameras");
    }

    void presetsAreDropped() {
        ToldWindow told;
        testing::adopt(told.document, testing::knownScene());
        told.catchUp();
        auto effects = told.effects([&] { told.document.select({}); });
        Preset preset;
        preset.name = "Clay";
        preset.values[0] = 345; // N/m
        const auto drop = [&](const QString& words, SurfaceRef ref, const QByteArray& text) {
            effects.note(words, [&] {
                QMimeData data;
                data.setData(QString::fromLatin1(kPresetMime), text);
                emit told.window->view().droppedOn(ref, data);
            });
        };
        const QByteArray text = QByteArray::fromStdString(presetText(preset));
        drop(QStringLiteral("onto the lid"), kLid, text);
        drop(QStringLiteral("nothing"), kLid, {});
        drop(QStringLiteral("no preset"), kLid, "{}");
        told.document.setLocked({kFloor}, true);
        drop(QStringLiteral("onto what is locked"), kFloor, text);
        COMPARE_SHOWN(effects.text(), "names-presets");
    }
};

TACTUM_GUI_TEST(TestKeptNames)

} // namespace test_kept_names

#include "test_kept_names.moc"
