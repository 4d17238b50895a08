// The connection behind a context: attends, beats, keeps the newest that comes. For this folder.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/hl/hl.h"
#include "core/protocol/messages.h"

namespace hl {

namespace v1 = tactum::v1;

/// Calls block for as long as the network takes, at most a minute. Thread: the application's; its own read
/// and beat.
class Link {
public:
    Link(const std::string& target, const std::string& name, const Options& options);
    ~Link();

    bool open() const;
    /// Empty; or why it is not open.
    std::string fault() const;

    // Each returns what the server said, empty when it was done.
    std::string apply(v1::Transaction& transaction, v1::Applied& applied);
    std::string order(v1::OrderRequest& request);
    std::string upload(v1::UploadHead head, const std::string& bytes, std::uint64_t& number);
    void say(const v1::Word& word);

    v1::State state() const;
    bool nextEvent(v1::Event& event);

private:
    using Clock = std::chrono::steady_clock;

    std::shared_ptr<grpc::Channel> channel() const;
    void read();
    void hear(const v1::News& news);
    void beat();

    std::string target_;
    std::shared_ptr<grpc::ChannelCredentials> credentials_;
    std::unique_ptr<v1::Haptics::Stub> stub_, uploads_;
    grpc::ClientContext context_;
    std::unique_ptr<grpc::ClientReaderWriter<v1::Word, v1::News>> call_;
    std::mutex writing_;
    mutable std::mutex mutex_; ///< of all below
    std::condition_variable changed_;
    std::string key_, fault_;
    bool leaving_ = false, ended_ = false;
    Clock::time_point heard_ = Clock::now();
    v1::State state_;
    std::deque<v1::Event> events_;
    std::thread reader_, heart_;
};

} // namespace hl
