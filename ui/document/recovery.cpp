#include "ui/document/recovery.h"

#include <algorithm>
#include <utility>

#include <QDateTime>

#include "core/base/process_mark.h"
#include "core/import/import_scene.h"
#include "ui/document/document.h"
#include "ui/document/journal.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

QString shown(const fs::path& path) {
    return QString::fromStdU16String(path.u16string());
}

/// The run that a journal is of; none for what is no journal, or has been put aside.
std::optional<ProcessMark> ownerOf(const fs::path& folder) {
    const std::string name = folder.filename();
    return markNamed(name.substr(0, name.rfind('_')));
}

/// Where damaged ones stay until the person deletes them.
QString putAside(const fs::path& folder) {
    const fs::path aside = folder.parent_path() / ("damaged-" + folder.filename().string());
    std::error_code fault;
    fs::rename(folder, aside, fault);
    return QObject::tr("What was edited when the program last stopped cannot be recovered: its journal is "
                       "damaged. It was kept in %1.")
        .arg(shown(fault ? folder : aside));
}

} // namespace

Recovery::Recovery(Document& document, Journal& journal, QObject* parent)
    : QObject(parent), document_(document), journal_(journal) {
    connect(&job_, &BackgroundJob::progressed, this, &Recovery::progressed);
}

Recovery::~Recovery() {
    for (const LostScene& each : scenes_)
        if (each.thrownAway) removeJournal(each.folder);
}

Recovery::Found Recovery::search() {
    Found found;
    std::error_code fault;
    for (const auto& each : fs::directory_iterator(Journal::home(), fault)) {
        const auto owner = ownerOf(each.path());
        if (!owner || !hasEnded(*owner, lastSignOf(each.path()))) continue;
        if (!holdsJournal(each.path())) {
            removeJournal(each.path()); // its run ended before it had written the first
            continue;
        }
        auto entry = readJournalEntry(each.path());
        if (entry)
            found.scenes.push_back({each.path(), std::move(*entry)});
        else if (entry.error().kind == Error::Kind::Input)
            found.sentences << putAside(each.path());
        else
            found.sentences << QString::fromStdString(entry.error().text);
    }
    std::ranges::sort(found.scenes, std::greater(), [](const auto& scene) { return scene.entry.edited; });
    return found;
}

void Recovery::look() {
    job_.start([this](const Progress&) -> BackgroundJob::Delivery {
        return [this, found = search()] {
            scenes_ = found.scenes;
            if (!scenes_.empty()) emit changed();
            for (const QString& sentence : found.sentences)
                emit failed(sentence);
        };
    });
}

// One system call decides whose it is. The new name says that we live, so nobody offers it a second time.
bool Recovery::claim(LostScene& scene) {
    if (ownerOf(scene.folder) == ownMark()) return true;
    const fs::path ours = Journal::newFolder();
    std::error_code fault;
    fs::rename(scene.folder, ours, fault);
    if (!fault) scene.folder = ours;
    if (fault == std::errc::no_such_file_or_directory) {
        forget(scene.folder);
        emit failed(tr("Another window has taken that scene."));
    } else if (fault) {
        emit failed(tr("%1: cannot be taken over: %2; check the permissions of the folder.")
                        .arg(shown(scene.folder), QString::fromStdString(fault.message())));
    }
    return !fault;
}

void Recovery::forget(const fs::path& folder) {
    if (std::erase_if(scenes_, [&](const LostScene& each) { return each.folder == folder; })) emit changed();
}

void Recovery::recover(std::size_t index) {
    if (job_.running() || !claim(scenes_.at(index))) return;
    job_.start([this, scene = scenes_.at(index)](const Progress& progress) -> BackgroundJob::Delivery {
        const auto file = unpackJournal(scene.folder);
        const auto loaded = std::make_shared<Result<LoadedScene>>(file ? importScene(*file, progress)
                                                                       : tl::unexpected<Error>(file.error()));
        if (*loaded)
            return [=, this, history = readJournalHistory(scene.folder, (*loaded)->scene)] {
                take(scene, std::move(**loaded), history);
            };
        return [this, folder = scene.folder, error = loaded->error()] {
            if (error.kind != Error::Kind::Input) return emit failed(QString::fromStdString(error.text));
            const QString sentence = putAside(folder);
            forget(folder);
            emit failed(sentence);
        };
    });
    emit progressed(0, -1);
}

void Recovery::take(const LostScene& scene, LoadedScene loaded, const Result<SceneHistory>& history) {
    FileStamp file;
    file.path = scene.entry.file;
    file.written = fs::file_time_type(fs::file_time_type::duration(scene.entry.fileWritten));
    file.bytes = scene.entry.fileBytes;
    document_.adoptRecovered(std::move(loaded), file, scene.entry.own, history.value_or(SceneHistory()));
    journal_.takeOver(scene.folder); // only now: opening ends the journal of what was there before
    forget(scene.folder);
    emit recovered(QString::fromStdString(scene.entry.title), history.has_value());
}

void Recovery::throwAway(std::size_t index) {
    if (!claim(scenes_.at(index))) return;
    scenes_[index].thrownAway = true;
    emit changed();
}

void Recovery::bringBack(std::size_t index) {
    scenes_.at(index).thrownAway = false;
    emit changed();
}

QString sentenceOf(const LostScene& scene) {
    const QString title = QString::fromStdString(scene.entry.title);
    const QDateTime edited = QDateTime::fromSecsSinceEpoch(scene.entry.edited);
    const QString time = edited.toString(QStringLiteral("HH:mm"));
    if (edited.date() == QDate::currentDate())
        return QObject::tr("%1 was not saved: edited until %2.").arg(title, time);
    return QObject::tr("%1 was not saved: edited until %2 on %3.")
        .arg(title, time, edited.date().toString(Qt::ISODate));
}

} // namespace tactum
