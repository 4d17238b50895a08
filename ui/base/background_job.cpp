#include "ui/base/background_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace tactum {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
    ticker_.setInterval(100);
    connect(&ticker_, &QTimer::timeout, this, &BackgroundJob::report);
}

BackgroundJob::~BackgroundJob() {
    cancel();
}

void BackgroundJob::start(std::function<Delivery(const Progress&)> work) {
    cancel();
    run_ = std::make_shared<Run>();
    clock_.start();
    ticker_.start();
    QThreadPool::globalInstance()->start([self = QPointer(this), run = run_, work = std::move(work)] {
        Progress progress;
        progress.report = [run](double fraction) { run->fraction = fraction; };
        progress.cancelled = &run->cancelled;
        Delivery delivery = work(progress);
        // Through the application object: `self` may only be looked at on the ui thread.
        QMetaObject::invokeMethod(qApp, [self, run, delivery = std::move(delivery)] {
            if (self) self->deliver(run, delivery);
        });
    });
}

void BackgroundJob::cancel() {
    if (run_) run_->cancelled = true;
}

void BackgroundJob::deliver(const std::shared_ptr<Run>& run, const Delivery& delivery) {
    if (run != run_) return;
    run_.reset();
    ticker_.stop();
    delivery();
    emit finished();
}

void BackgroundJob::report() {
    const double fraction = run_->fraction;
    const double seconds = 1e-3 * double(clock_.elapsed());
    emit progressed(fraction, fraction > 0.02 ? seconds * (1 - fraction) / fraction : -1.0);
}

} // namespace tactum
