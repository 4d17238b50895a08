// One piece of work beside the ui thread, looked after from it. Private to this folder.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QThreadPool>

#include "core/base/progress.h"

namespace tactum {

/// Threads of their own: opening a file and compiling a scene must not queue behind a picture.
QThreadPool& asidePool();

/// Work that is started anew, or whose Aside goes, is told to stop and forgotten; nobody waits for it. So it
/// may hold nothing but what it owns itself. Thread: ui.
template <class T> class Aside {
public:
    Aside() = default;
    ~Aside() { forget(); }
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;

    void start(std::function<T(const Progress&)> work) {
        forget();
        run_ = std::make_shared<Run>();
        asidePool().start([run = run_, work = std::move(work)] {
            Progress progress;
            progress.cancelled = &run->cancelled;
            if (!progress.isCancelled()) run->result = std::make_unique<T>(work(progress));
            run->done.store(true, std::memory_order_release);
        });
    }
    void forget() {
        if (run_) run_->cancelled = true;
        run_.reset();
    }
    bool pending() const { return run_ != nullptr; }
    /// What came out, once; null while there is nothing.
    std::unique_ptr<T> take() {
        if (!run_ || !run_->done.load(std::memory_order_acquire)) return nullptr;
        std::unique_ptr<T> result = std::move(run_->result);
        run_.reset();
        return result;
    }

private:
    struct Run {
        std::atomic<bool> cancelled{false}, done{false};
        std::unique_ptr<T> result;
    };
    std::shared_ptr<Run> run_;
};

} // namespace tactum
