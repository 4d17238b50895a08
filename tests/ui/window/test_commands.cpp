// Every command in the states that a person comes through: which are on, which are switched, and why the
// others are off.
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>
#include <QToolBar>
#include <QUndoStack>

#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/layered_window.h"
#include "ui/base/shortcuts.h"
#include "ui/showing/playback.h"
#include "ui/showing/recording_saver.h"

namespace test_commands {

using namespace tactum;

namespace {

/// What is off and on in one state after the other, as a table with a row for each command.
class Table {
public:
    explicit Table(TouchedWindow& program) : program_(program), rows_(qsizetype(commands().size())) {}

    void note(const QString& state) {
        program_.frames(3);
        legend_ << QStringLiteral("%1 %2").arg(QLatin1Char(char('a' + legend_.size()))).arg(state);
        for (std::size_t i = 0; i < commands().size(); ++i)
            rows_[qsizetype(i)] += QLatin1Char(letterOf(commands()[i]));
    }

    QString text() const {
        QString text = QStringLiteral(
            "+ on, v on and switched on, - off, x off and switched on, ? not looked at, in the states\n");
        text += legend_.join(u'\n') + QStringLiteral("\n\n");
        for (std::size_t i = 0; i < commands().size(); ++i)
            text += QStringLiteral("%1 %2\n").arg(rows_[qsizetype(i)], QLatin1String(commands()[i].id));
        text += u'\n';
        for (const QString& reason : reasons_)
            text += reason + u'\n';
        return text;
    }

private:
    char letterOf(const Command& command) {
        const QAction& action = program_.command(command.id);
        if (isUpToTheLoops(command)) return '?';
        noteReason(action, command);
        if (action.isEnabled()) return action.isChecked() ? 'v' : '+';
        return action.isChecked() ? 'x' : '-';
    }

    /// A machine that is late takes the force away; plots unfold when something was felt.
    static bool isUpToTheLoops(const Command& command) {
        return QByteArrayList{"armed", "stop", "fold-plots"}.contains(command.id);
    }

    /// Off, it says why instead of what it does.
    void noteReason(const QAction& action, const Command& command) {
        const QString tip = action.toolTip();
        if (action.isEnabled() || tip.startsWith(QObject::tr(command.sentence))) return;
        const QString reason = QStringLiteral("%1: %2").arg(QLatin1String(command.id), tip);
        if (!reasons_.contains(reason)) reasons_ << reason;
    }

    TouchedWindow& program_;
    QList<QString> rows_;
    QStringList legend_, reasons_;
};

/// What the machine has decides: a card for sound.
QString stateOf(const QAction& entry) {
    if (entry.objectName() == QLatin1String("sound")) return {};
    QString state = entry.isEnabled() ? QString() : QStringLiteral(" (off)");
    if (entry.isCheckable()) state += entry.isChecked() ? " (switch, on)" : " (switch)";
    return state;
}

/// An entry a line, those of a menu inside another two spaces deeper; * has a picture.
void addMenu(const QList<QAction*>& entries, const QString& indent, QString& text) {
    for (const QAction* entry : entries) {
        if (entry->isSeparator()) {
            text += indent + QStringLiteral("--\n");
            continue;
        }
        text += indent + entry->text() + (entry->icon().isNull() ? "" : " *") + stateOf(*entry);
        for (const QKeySequence& key : entry->shortcuts())
            text += QStringLiteral("  ") + key.toString(QKeySequence::PortableText);
        text += u'\n';
        if (!entry->menu()) continue;
        // Some are filled when they are opened, that of the gamepads with those that are there.
        if (!entry->text().contains(QStringLiteral("Gamepad"))) emit entry->menu()->aboutToShow();
        addMenu(entry->menu()->actions(), indent + QStringLiteral("  "), text);
    }
}

} // namespace

class TestCommands : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void standInTheirMenus();
    void areOnWhereTheyDoSomething();
};

void TestCommands::standInTheirMenus() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QString text;
    addMenu(program.window->menuBar()->actions(), {}, text);
    for (const auto* bar : program.window->findChildren<QToolBar*>()) {
        text += u'\n' + bar->windowTitle() + u'\n';
        addMenu(bar->actions(), QStringLiteral("  "), text);
    }
    COMPARE_SHOWN(text.replace(folder_.path(), QStringLiteral("FOLDER")), "menus");
}

void TestCommands::areOnWhereTheyDoSomething() {
    TouchedWindow program;
    Document& document = program.document;
    Table table(program);
    table.note("nothing is open");
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId id = document.scene().objects.front().id;
    document.select(std::nullopt);
    table.note("a cube, nothing selected");
    document.select(SurfaceRef{id, 4});
    table.note("a side selected");
    document.select({SurfaceRef{id, 4}, SurfaceRef{id, 1}});
    table.note("two sides selected");
    document.selectFaces({id, {0}});
    table.note("a triangle selected");
    document.select(SurfaceRef{id, 4});
    program.command("layer-grooves").trigger();
    table.note("a layer on a side");
    program.command("layer-noise").trigger();
    table.note("a second layer, chosen");
    program.command("mark-a").trigger();
    table.note("marked as A");
    document.history().undo();
    table.note("an edit undone");
    program.command("hide").trigger();
    table.note("hidden");
    program.command("show-all").trigger();
    program.command("lock").trigger();
    table.note("locked");
    program.command("lock").trigger();
    program.command("trial-wall").trigger();
    table.note("the wall is tried");
    program.command("trial-end").trigger();

    auto* saver = program.window->findChild<RecordingSaver*>();
    const QString recording = folder_.filePath(QStringLiteral("a.tactum-recording"));
    saver->save(recording, saver->take(QStringLiteral("a test wanted it")));
    QVERIFY(test::waitFor([&] { return QFile::exists(recording); }));
    program.window->open(recording);
    QVERIFY(test::waitFor([&] { return program.window->findChild<Playback*>()->active(); }));
    table.note("a recording is shown");
    program.window->findChild<QPushButton*>(QStringLiteral("playback-back"))->click();
    table.note("and left");
    COMPARE_SHOWN(table.text(), "commands");
}

TACTUM_GUI_TEST(TestCommands)

} // namespace test_commands

#include "test_commands.moc"
