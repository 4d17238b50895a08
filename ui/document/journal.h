// Keeps what is edited and not saved yet in a recovery journal, for the case that the program dies.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "ui/document/document.h"

namespace tactum {

/// Thread: ui. Writing costs it copies of the scene and of those that its history leads to, which share
/// meshes and images; all else is done on a worker, one thing after the other. Each run has its own journal;
/// there is one while something is unsaved.
class Journal : public QObject {
    Q_OBJECT
public:
    explicit Journal(Document& document, QObject* parent = nullptr);
    /// Leaves the journal: who has thrown away what is unsaved calls discard() before.
    ~Journal() override;

    /// An edit is in the journal after this time, or after so many of them. A second or five are for writing.
    struct Pace {
        int milliseconds = 25'000;
        int edits = 20;
        int first = 1'000; ///< ms, while none of it is in a journal yet; no more than the others have
    };
    void setPace(Pace pace) { pace_ = pace; }

    void writeNow();
    /// Nothing is unsaved, or the person wants none of it.
    void discard();
    /// From now on this folder, which already holds the scene, is the journal.
    void takeOver(const std::filesystem::path& folder);

    /// Where the journals of all runs are.
    static std::filesystem::path home();
    /// A folder in there that says whose it is; another one at each call.
    static std::filesystem::path newFolder();

signals:
    void written();
    /// One line for the person; once until a journal could be written again.
    void failed(const QString& sentence);

private:
    void note();
    void write();
    void finish(const Result<void>& result);
    void run(std::function<void()> work);

    Document& document_;
    std::filesystem::path folder_;
    Pace pace_;
    QTimer due_, sign_;
    int step_ = 0;                               ///< of the history, when it was last looked at
    int edits_ = 0;                              ///< that no write has begun with
    std::shared_ptr<std::atomic<bool>> writing_; ///< its cancelled; null: none is under way
    bool again_ = false, said_ = false;
    bool kept_ = false;  ///< there is a journal of what is unsaved
    QThreadPool worker_; ///< last: what it does ends before the rest goes
};

} // namespace tactum
