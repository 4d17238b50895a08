// What is said and asked when scenes are saved, left, found changed by others, exported and recovered, and
// when a recording is shown in their place. Wrong itself if a question had a button that its line does not
// name: WindowEffects writes each of them down.
#include <fstream>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>
#include <QUndoStack>

#include "core/recording/recording_file.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/left_journal.h"
#include "tests/ui/window/window_with_files.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/view/scene_view.h"

namespace test_kept_files {

using namespace tactum;

namespace {

void edit(Document& document) {
    document.setProxyRadius(document.scene().proxyRadius + 0.001);
}

/// Types a name into a dialog that asks where; a file that it has chosen itself would come before that.
std::function<void(QDialog&)> into(const QString& file) {
    return [file](QDialog& dialog) {
        for (const auto* view : dialog.findChildren<QAbstractItemView*>())
            if (view->selectionModel()) view->selectionModel()->clearSelection();
        dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
        QMetaObject::invokeMethod(&dialog, "accept");
    };
}

std::function<void(QDialog&)> pressing(QMessageBox::StandardButton which) {
    return [which](QDialog& dialog) { dynamic_cast<QMessageBox&>(dialog).button(which)->click(); };
}

/// The window, its title and which files there are.
class Desk : public WindowWithFiles {
public:
    using WindowWithFiles::WindowWithFiles;
    std::filesystem::path path(const char* name) const { return file(name).toStdString(); }

private:
    bool rests() const override {
        return !told.document.saving() && !told.document.opening() && !told.document.editing();
    }
    QString files() const override {
        const QStringList all = QDir(folder).entryList({QStringLiteral("*.*")}, QDir::Files, QDir::Name);
        return QStringLiteral("\"%1\"%2, %3")
            .arg(told.window->windowTitle(), told.window->isWindowModified() ? " modified" : "",
                 all.join(u' '));
    }
};

} // namespace

class TestKeptFiles : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;
    QTemporaryDir files_;
    QString own_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() {
        test::speakEnglish();
        qputenv("TZ", "UTC"); // hours of journals are shown
    }
    void init() {
        useSettingsIn(folders_.next());
        own_ = files_.filePath(QString::fromLatin1(QTest::currentTestFunction()));
        QDir().mkpath(own_);
    }

    void aSceneIsSaved();
    void whatWouldBeLostIsAskedFor();
    void anotherProgramChangedIt();
    void aRecordingIsShownInItsPlace();
    void whatWasLostIsOffered();
};

void TestKeptFiles::aSceneIsSaved() {
    Desk desk(own_);
    Document& document = desk.told.document;
    desk.command("save"); // it has no file yet: asked, and given up
    desk.command("save", into(desk.file("plates.glb")));
    edit(document);
    desk.command("save");
    desk.note(QStringLiteral("undone"), [&] { document.history().undo(); });
    desk.note(QStringLiteral("redone"), [&] { document.history().redo(); });
    desk.command("save-as", into(desk.file("other.glb")));
    desk.command("export");
    desk.command("export", into(desk.file("bundle.tactum")));
    desk.note(QStringLiteral("opened again"), [&] { desk.told.window->open(desk.file("plates.glb")); });
    desk.note(QStringLiteral("none"), [&] { desk.told.window->open(desk.file("none.glb")); });
    COMPARE_SHOWN(desk.said(), "files-saved");
}

void TestKeptFiles::whatWouldBeLostIsAskedFor() {
    Desk desk(own_);
    Document& document = desk.told.document;
    desk.command("save", into(desk.file("plates.glb")));
    edit(document);
    const auto again = [&] { desk.told.window->open(desk.file("plates.glb")); };
    desk.note(QStringLiteral("another is opened, and not"), again);
    desk.note(QStringLiteral("another is opened: saved"), again, pressing(QMessageBox::Save));
    edit(document);
    desk.note(QStringLiteral("another is opened: thrown away"), again, pressing(QMessageBox::Discard));
    edit(document);
    desk.command("new");
    desk.command("new-ground", pressing(QMessageBox::Discard));
    edit(document);
    desk.note(QStringLiteral("closed, and not"), [&] { desk.told.window->close(); });
    QVERIFY(desk.told.window->isVisible());
    desk.note(
        QStringLiteral("closed: saved, and no name"), [&] { desk.told.window->close(); },
        pressing(QMessageBox::Save));
    QVERIFY(desk.told.window->isVisible());
    document.removeObject(document.scene().objects.front().id);
    desk.note(QStringLiteral("empty, and a new one"), [&] { desk.told.command("new").trigger(); });
    COMPARE_SHOWN(desk.said(), "files-left");
}

void TestKeptFiles::anotherProgramChangedIt() {
    Desk desk(own_);
    Document& document = desk.told.document;
    desk.command("save", into(desk.file("plates.glb")));
    std::filesystem::remove(desk.path("plates.glb"));
    edit(document);
    desk.command("save");
    desk.command("save", [](QDialog& dialog) { // elsewhere, and then nowhere
        for (QAbstractButton* each : dynamic_cast<QMessageBox&>(dialog).buttons())
            if (each->text().contains(QStringLiteral("As"))) return each->click();
    });
    desk.command("save", pressing(QMessageBox::Save));
    std::ofstream(desk.path("plates.glb"), std::ios::app) << "more";
    edit(document);
    desk.command("save", pressing(QMessageBox::Cancel));
    desk.command("save", pressing(QMessageBox::Save));
    COMPARE_SHOWN(desk.said(), "files-changed");
}

void TestKeptFiles::aRecordingIsShownInItsPlace() {
    const QString file = own_ + QStringLiteral("/touch.tactum-recording");
    {
        std::ofstream out(file.toStdString(), std::ios::binary);
        out << recordingBytes({handMadeRun(400), "It was tried.", {}});
    }
    Desk desk(own_);
    edit(desk.told.document);
    Playback& playback = *desk.told.window->findChild<Playback*>();
    auto& bar = *desk.told.window->findChild<PlaybackBar*>();
    QString times;
    const auto note = [&](const char* words, const std::function<void()>& act) {
        desk.note(QLatin1String(words), [&] {
            act();
            desk.told.frames(3);
        });
        times +=
            QStringLiteral("%1: %2, %3\n")
                .arg(QLatin1String(words), bar.findChild<QLabel*>(QStringLiteral("playback-time"))->text(),
                     bar.findChild<QLabel*>(QStringLiteral("playback-event"))->toolTip());
    };
    note("opened", [&] {
        desk.told.window->open(file);
        if (!test::waitFor([&] { return playback.active(); })) qFatal("no recording");
    });
    QCOMPARE(playback.file(), file);
    SceneView& view = desk.told.window->view();
    const auto key = [&](Qt::Key each) { QTest::keyClick(&view, each); };
    note("a hundredth on", [&] { key(Qt::Key_Right); });
    note("and back", [&] { key(Qt::Key_Left); });
    note("somewhere", [&] { playback.seek(0.3, true); });
    note("faster", [&] { key(Qt::Key_Up); });
    note("slower", [&] { key(Qt::Key_Down); });
    note("to its end", [&] { playback.seek(10, true); });
    note("measured", [&] { desk.told.command("measure").trigger(); });
    note("touched", [&] { desk.told.command("select").trigger(); });
    note("saved", [&] { desk.told.command("save").trigger(); });
    note("live again", [&] { playback.end(); });
    note("no recording", [&] {
        std::ofstream(file.toStdString()) << "nothing";
        desk.told.window->open(file);
        if (!test::waitFor([&] { return !playback.opening(); })) qFatal("it does not end");
    });
    COMPARE_SHOWN(desk.said(), "files-recording");
    COMPARE_SHOWN(times, "files-recording-times");
}

void TestKeptFiles::whatWasLostIsOffered() {
    // As a run that ended has left them.
    for (const auto& [title, edited] : {std::pair("pot.glb", 1'000'000), {"lid.glb", 2'000'000}})
        leaveJournal(testing::knownScene(), title, edited);
    Desk desk(own_);
    auto& bar = *desk.told.window->findChild<QWidget*>(QStringLiteral("recovery"));
    QVERIFY(test::waitFor([&] { return !bar.isHidden(); }));
    const auto press = [&](const char* name) {
        const auto away = pressing(QMessageBox::Discard); // what recovering would take the place of
        desk.note(
            QLatin1String(name),
            [&] {
                testing::part<QPushButton>(bar, name).click();
                desk.told.frames(4);
            },
            QByteArray(name).startsWith("recovery-recover") ? away : nullptr);
    };
    testing::States states(test::shownIn(bar));
    for (const char* name :
         {"recovery-throw-1", "recovery-back-1", "recovery-throw-0", "recovery-recover-1"}) {
        press(name);
        states.note(QLatin1String(name), test::shownIn(bar));
    }
    COMPARE_SHOWN(desk.said(), "files-lost");
    COMPARE_SHOWN(states.text(), "files-lost-bar");
}

TACTUM_GUI_TEST(TestKeptFiles)

} // namespace test_kept_files

#include "test_kept_files.moc"
