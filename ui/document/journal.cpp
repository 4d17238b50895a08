#include "ui/document/journal.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QPointer>
#include <QStandardPaths>

#include "core/base/process_mark.h"
#include "core/files/journal.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

constexpr int kMostSteps = 100;      // of the history, to each side of the present
constexpr int kMostObjects = 20'000; // in the scenes of all steps: to copy them takes a few milliseconds

int stepsOf(const Scene& scene) {
    return std::clamp(kMostObjects / std::max(1, int(scene.objects.size())), 1, kMostSteps);
}

JournalEntry entryOf(const Document& document) {
    const FileStamp& stamp = document.stamp();
    std::error_code fault;
    const fs::path absolute = stamp.path.empty() ? fs::path() : fs::absolute(stamp.path, fault);
    return {.file = fault ? stamp.path : absolute,
            .fileWritten = stamp.written.time_since_epoch().count(),
            .fileBytes = stamp.bytes,
            .own = document.hasOwnFile(),
            .title = document.title().toStdString(),
            .edited = QDateTime::currentSecsSinceEpoch()};
}

} // namespace

Journal::Journal(Document& document, QObject* parent)
    : QObject(parent), document_(document), folder_(newFolder()) {
    worker_.setMaxThreadCount(1);
    due_.setSingleShot(true);
    connect(&due_, &QTimer::timeout, this, &Journal::write);
    // Not at changed(): the history does not know of the edit then.
    connect(&document_.history(), &QUndoStack::indexChanged, this, &Journal::note);
    connect(&document_.history(), &QUndoStack::cleanChanged, this, &Journal::note);
    connect(&document_, &Document::opened, this, &Journal::note);
    connect(&sign_, &QTimer::timeout, this, [this] { run([folder = folder_] { touchJournal(folder); }); });
    sign_.start(kSignOfLife);
}

Journal::~Journal() {
    if (writing_) *writing_ = true;
    worker_.waitForDone();
}

fs::path Journal::home() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return fs::path(folder.toStdU16String()) / "recovery";
}

fs::path Journal::newFolder() {
    static int count = 0;
    return home() / (nameOf(ownMark()) + '_' + std::to_string(count++));
}

void Journal::note() {
    if (!document_.modified()) return discard();
    const int step = document_.history().index();
    if (std::exchange(step_, step) != step) ++edits_;
    if (edits_ >= pace_.edits)
        write();
    else if (!due_.isActive())
        due_.start(kept_ ? pace_.milliseconds : std::min(pace_.first, pace_.milliseconds));
}

void Journal::writeNow() {
    if (document_.modified()) write();
}

void Journal::write() {
    due_.stop();
    if (document_.empty()) return; // nothing to find again: what was there before is kept
    edits_ = 0;
    if (writing_) {
        again_ = true;
        return;
    }
    writing_ = std::make_shared<std::atomic<bool>>(false);
    run([self = QPointer(this), cancelled = writing_, folder = folder_, entry = entryOf(document_),
         scene = document_.scene(), history = document_.stepsAround(stepsOf(document_.scene()))] {
        Progress progress;
        progress.cancelled = cancelled.get();
        const Result<void> result = writeJournal(folder, entry, scene, history, progress);
        // Through the application object: `self` may only be looked at on the ui thread.
        QMetaObject::invokeMethod(qApp, [self, cancelled, result] {
            if (self && !*cancelled) self->finish(result);
        });
    });
}

void Journal::finish(const Result<void>& result) {
    writing_.reset();
    if (result) {
        said_ = false;
        kept_ = true;
        emit written();
    } else if (!std::exchange(said_, true)) {
        emit failed(tr("What you edit is not kept for the case of a crash: %1")
                        .arg(QString::fromStdString(result.error().text)));
    }
    // What cannot be written is tried again, though no edit may follow.
    if (std::exchange(again_, false))
        write();
    else if (!result && !due_.isActive())
        due_.start(pace_.milliseconds);
}

void Journal::discard() {
    due_.stop();
    edits_ = 0;
    step_ = document_.history().index();
    again_ = kept_ = false;
    if (writing_) *std::exchange(writing_, nullptr) = true;
    run([folder = folder_] { removeJournal(folder); });
}

void Journal::takeOver(const fs::path& folder) {
    discard();
    folder_ = folder;
    kept_ = true;
}

void Journal::run(std::function<void()> work) {
    worker_.start(std::move(work));
}

} // namespace tactum
