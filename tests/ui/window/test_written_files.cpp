// Presets, reports and videos: what is asked, what is written into the folder, what is said of it. Wrong
// itself if a file were empty or of another kind: of each the beginning is looked at.
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>
#include <QtEndian>

#include "core/presets/preset_file.h"
#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/window/window_with_files.h"
#include "ui/document/preset_store.h"
#include "ui/panels/preset_form.h"
#include "ui/panels/preset_library.h"
#include "ui/widgets/notice_bar.h"

namespace test_written_files {

using namespace tactum;
using tactum::testing::kLid, tactum::testing::kTop;

namespace {

/// Types a name into the dialog that asks where; `kind`: of the file, by its number.
std::function<void(QDialog&)> typed(const QString& file, int kind = 0) {
    return [file, kind](QDialog& dialog) {
        auto& files = static_cast<QFileDialog&>(dialog);
        files.selectNameFilter(files.nameFilters().at(kind));
        emit files.filterSelected(files.nameFilters().at(kind));
        files.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
        QMetaObject::invokeMethod(&dialog, "accept");
    };
}

class Desk : public WindowWithFiles {
public:
    explicit Desk(const QString& theFolder) : WindowWithFiles(theFolder) {
        store = told.window->findChild<PresetStore*>();
        list = told.window->findChild<PresetLibrary*>();
        if (!test::waitFor([this] { return !store->loading() && !store->presets().empty(); }))
            qFatal("no presets");
    }
    QString notice() const { return told.window->findChild<NoticeBar*>()->text(); }

    PresetStore* store = nullptr;
    PresetLibrary* list = nullptr;

private:
    bool rests() const override {
        return !store->loading() && !notice().startsWith(QStringLiteral("Writing"));
    }
    QString files() const override {
        QStringList kinds;
        for (const QString& name : QDir(folder).entryList(QDir::Files, QDir::Name)) {
            QFile written(folder + u'/' + name);
            if (!written.open(QIODevice::ReadOnly)) qFatal("it cannot be read");
            const QByteArray begin = written.read(12);
            kinds << QStringLiteral("%1 %2").arg(name, begin.startsWith("%PDF-")              ? "pdf"
                                                       : begin.startsWith("<!DOCTYPE")        ? "html"
                                                       : begin.startsWith("{")                ? "preset"
                                                       : begin.startsWith("GIF8")             ? "gif"
                                                       : begin.startsWith("\x1a\x45\xdf\xa3") ? "webm"
                                                                                              : "other");
        }
        int own = 0;
        for (const StoredPreset& each : store->presets())
            own += each.own;
        return QStringLiteral("%1; own presets %2, chosen %3")
            .arg(kinds.join(u','))
            .arg(own)
            .arg(list->chosen() ? list->chosen()->name() : QStringLiteral("none"));
    }
};

void write(const QString& file, const QByteArray& text) {
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size()) qFatal("it cannot be written");
}

// As its header has it, after the six letters of its kind.
QSize sizeOfGif(const QString& path) {
    QFile file(path);
    const QByteArray head = file.open(QIODevice::ReadOnly) ? file.read(10) : QByteArray();
    if (head.size() < 10) return {};
    return {qFromLittleEndian<quint16>(head.data() + 6), qFromLittleEndian<quint16>(head.data() + 8)};
}

} // namespace

class TestWrittenFiles : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;
    QTemporaryDir files_;
    QString own_;

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase() { test::speakEnglish(); }
    void init() {
        useSettingsIn(folders_.next());
        own_ = files_.filePath(QString::fromLatin1(QTest::currentTestFunction()));
        QDir().mkpath(own_);
        QDir(PresetStore::folder()).removeRecursively();
    }

    void presets() {
        Desk desk(own_);
        desk.note(QStringLiteral("none is chosen"), [&] { emit desk.list->applyAsked(); });
        desk.list->choose(desk.store->presets().front().file);
        desk.note(QStringLiteral("nothing is selected"), [&] { emit desk.list->applyAsked(); });
        desk.note(QStringLiteral("selected"), [&] { desk.told.document.select({kLid}); });
        desk.command("preset-apply");
        desk.command("preset-export", typed(desk.file("first.tactum-preset")));
        desk.command("preset-export", typed(desk.file("nowhere/it.tactum-preset")));
        desk.note(QStringLiteral("saved"), [&] {
            desk.told.command("preset-save").trigger();
            auto* form = desk.told.window->findChild<PresetForm*>();
            if (!form) qFatal("no form");
            form->accept();
        });
        Preset clay;
        clay.name = "Clay";
        clay.values[0] = 345; // N/m
        write(desk.file("clay.tactum-preset"), QByteArray::fromStdString(presetText(clay)));
        write(desk.file("bad.tactum-preset"), "{}");
        const auto take = [&](const char* file) {
            desk.note(QStringLiteral("dropped %1").arg(QLatin1String(file)), [&] {
                QMimeData data;
                data.setUrls({QUrl::fromLocalFile(desk.file(file))});
                QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
                QApplication::sendEvent(desk.told.window.get(), &enter); // Qt drops where it has entered
                QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
                QApplication::sendEvent(desk.told.window.get(), &drop);
            });
        };
        take("clay.tactum-preset");
        take("bad.tactum-preset");
        take("no.xml");
        desk.note(QStringLiteral("removed"), [&] { emit desk.list->removed(QStringLiteral("Clay")); });
        desk.note(QStringLiteral("locked"), [&] {
            desk.told.document.select({kLid});
            desk.told.command("lock").trigger();
            emit desk.list->applyAsked();
        });
        COMPARE_SHOWN(desk.said(), "written-presets");
    }

    void videos() {
        Desk desk(own_);
        for (const char* size : {"video-720", "video-1080", "video-view", "video-plot"})
            desk.command(size);
        desk.command("record-video", typed(desk.file("nowhere/touch.webm")));
        desk.told.command("video-720").trigger();
        desk.note(
            QStringLiteral("recorded"),
            [&] {
                desk.told.command("record-video").trigger();
                if (!test::waitFor([&] { return desk.told.command("record-video").isChecked(); }))
                    qFatal("it does not begin");
                desk.told.command("record-video").trigger();
                const auto ended = [&] {
                    return desk.notice().startsWith(QStringLiteral("The video was written"));
                };
                if (!test::waitFor(ended)) qFatal("it does not end");
                // How long it was is up to the clock.
                desk.told.window->findChild<NoticeBar*>()->showNote(
                    desk.notice().section(QStringLiteral(": "), 0, 0));
            },
            typed(desk.file("touch.gif"), 1));
        COMPARE_SHOWN(desk.said(), "written-videos");
        QCOMPARE(sizeOfGif(desk.file("touch.gif")), QSize(1280, 720));
    }
};

TACTUM_GUI_TEST(TestWrittenFiles)

} // namespace test_written_files

#include "test_written_files.moc"
