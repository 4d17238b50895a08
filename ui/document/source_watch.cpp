#include "ui/document/source_watch.h"

#include <QFileInfo>

namespace tactum {

namespace {
constexpr int kSettled = 1000; // ms: programs write a file in parts, with pauses
}

SourceWatch::SourceWatch(Document& document, QObject* parent)
    : QObject(parent), document_(document), settling_(this) {
    settling_.setSingleShot(true);
    settling_.setInterval(kSettled);
    connect(&settling_, &QTimer::timeout, this, &SourceWatch::look);
    const auto settle = [this] { settling_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, settle);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, settle);
    connect(&document_, &Document::opened, this, &SourceWatch::follow);
    connect(&document_, &Document::saved, this, &SourceWatch::follow);
    connect(&document_.history(), &QUndoStack::indexChanged, this, &SourceWatch::follow);
}

void SourceWatch::follow() {
    const std::filesystem::path& file = document_.source().path;
    std::error_code fault;
    const auto absolute = std::filesystem::absolute(file, fault);
    QStringList wanted;
    if (!file.empty() && !fault)
        for (const auto& path : {absolute, absolute.parent_path()})
            wanted << QString::fromStdU16String(path.u16string());
    const QStringList watched = watcher_.files() + watcher_.directories();
    for (const QString& path : watched)
        if (!wanted.contains(path)) watcher_.removePath(path);
    for (const QString& path : wanted) // one that was replaced has to be looked for again
        if (!watched.contains(path) && QFileInfo::exists(path)) watcher_.addPath(path);
}

void SourceWatch::look() {
    follow();
    const FileStamp& known = document_.source();
    if (known.path.empty()) return;
    const FileStamp now(known.path);
    if (document_.saving() || !(now == seen_)) { // it may be our own hand, or somebody is still writing
        seen_ = now;
        return settling_.start();
    }
    std::error_code fault;
    if (now == known || now == told_ || !std::filesystem::is_regular_file(now.path, fault) || now.bytes == 0)
        return;
    told_ = now;
    emit changed();
}

} // namespace tactum
