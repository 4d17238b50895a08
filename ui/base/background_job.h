// Work that takes longer than a frame: on a thread of its own, with progress, time left and cancel.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/files/load_scene.h"

namespace tactum {

/// Runs one function at a time on the thread pool.
/// Thread: every member on the ui thread; signals arrive there too. A job that is destroyed or started
/// anew cancels its work and forgets it: `finished` then never comes for the old one.
class BackgroundJob : public QObject {
    Q_OBJECT
public:
    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// `work` runs on a worker and must look at progress.isCancelled() now and then. Its result travels in
    /// what it returns: a function that is called on the ui thread, after which `finished` is emitted.
    using Delivery = std::function<void()>;
    void start(std::function<Delivery(const Progress&)> work);
    /// Asks the work to stop. It still delivers, usually an error that says "cancelled".
    void cancel();
    bool running() const { return run_ != nullptr; }

signals:
    /// `secondsLeft` is negative while there is nothing to judge from.
    void progressed(double fraction, double secondsLeft);
    void finished();

private:
    struct Run {
        std::atomic<bool> cancelled{false};
        std::atomic<double> fraction{0};
    };
    void deliver(const std::shared_ptr<Run>& run, const Delivery& delivery);
    void report();

    std::shared_ptr<Run> run_;
    QElapsedTimer clock_;
    QTimer ticker_;
};

} // namespace tactum
