#include "core/video/video_worker.h"

namespace tactum {

VideoWorker::VideoWorker(std::unique_ptr<VideoFile> file, std::size_t room)
    : file_(std::move(file)), room_(room), thread_([this] { work(); }) {}

VideoWorker::~VideoWorker() {
    {
        const std::lock_guard lock(mutex_);
        left_ = !end_;
    }
    changed_.notify_one();
    thread_.join();
}

bool VideoWorker::offer(Make make, double time) {
    {
        const std::lock_guard lock(mutex_);
        if (end_ || state_.ended || waiting_.size() >= room_) {
            ++state_.refused;
            return false;
        }
        waiting_.push_back({std::move(make), time});
    }
    changed_.notify_one();
    return true;
}

void VideoWorker::finish(double end) {
    {
        const std::lock_guard lock(mutex_);
        end_ = end;
    }
    changed_.notify_one();
}

VideoWorker::State VideoWorker::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

/// Nothing when there will be no more.
std::optional<VideoWorker::Waiting> VideoWorker::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return left_ || end_ || !waiting_.empty(); });
    if (left_ || waiting_.empty()) return {};
    Waiting first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
}

void VideoWorker::end(const Result<void>& how) {
    const std::lock_guard lock(mutex_);
    state_.ended = true;
    if (!how) state_.error = how.error();
}

void VideoWorker::work() {
    while (const auto waiting = next()) {
        if (const auto added = file_->add(waiting->make(), waiting->time); !added) return end(added);
        const std::lock_guard lock(mutex_);
        ++state_.written;
    }
    std::unique_lock lock(mutex_);
    const std::optional<double> until = left_ ? std::nullopt : end_;
    lock.unlock();
    end(until ? file_->finish(*until) : Result<void>{});
}

} // namespace tactum
