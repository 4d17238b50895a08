// A video that is written on a thread of its own, so that nobody waits for the encoder.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/video/video_file.h"

namespace tactum {

/// Takes as many pictures as wait in its queue, and refuses more: the video then holds the one before longer.
/// Thread: any but real time, the same for all members.
class VideoWorker {
public:
    /// `room`: pictures that may wait.
    explicit VideoWorker(std::unique_ptr<VideoFile> file, std::size_t room = 8);
    /// Waits until a video that was told its end has it; leaves another one as it is, which can be played.
    ~VideoWorker();

    /// What makes a picture, on the worker: whatever can be done there is.
    using Make = std::function<VideoPicture()>;
    /// `time`: as of VideoFile::add(). Whether it was taken: not when the queue is full, or the video has
    /// ended.
    bool offer(Make make, double time);
    /// Ends the video at a time, s, when everything that waits is written. Comes back at once.
    void finish(double end);

    struct State {
        bool ended = false; ///< nothing more happens
        std::size_t written = 0, refused = 0;
        std::optional<Error> error; ///< why it ended
    };
    State state() const;

private:
    struct Waiting {
        Make make;
        double time;
    };

    void work();
    void end(const Result<void>& how);
    std::optional<Waiting> next();

    std::unique_ptr<VideoFile> file_;
    const std::size_t room_;
    mutable std::mutex mutex_; ///< of all below
    std::condition_variable changed_;
    std::deque<Waiting> waiting_;
    std::optional<double> end_;
    bool left_ = false;
    State state_;
    std::thread thread_;
};

} // namespace tactum
