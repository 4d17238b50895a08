// The connection of a client: attends, beats, keeps the newest that comes, makes the calls.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "core/protocol/messages.h"

namespace tactum {

struct ConnectionOptions {
    std::string certificate, token; ///< of a server on another machine: PEM, and its token
    double stateRate = 60;          ///< Hz
    double patience = 5;            ///< s, that the constructor waits for the server
    bool telemetry = false;         ///< states have all that a window shows
    std::function<void(const v1::News&)>
        heard{}; ///< called with everything that comes, from the connection's thread
};

/// Calls block for as long as the network takes, at most a minute, and each returns what the server said:
/// empty when it was done. Thread: any, several at once; it has two of its own, which read and beat.
class Connection {
public:
    /// Attends, and asks for the pen. Waits until the server has answered, or for `patience`.
    Connection(const std::string& target, const std::string& name, const ConnectionOptions& options);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// Ends the calls that are under way, and every one that comes.
    void leave();
    /// Whether the server is there and was heard of late.
    bool open() const;
    /// Empty; or why it is not open.
    std::string fault() const;
    /// Whether it was the server that said so.
    bool answered() const;

    std::string apply(v1::Transaction& transaction, v1::Applied& applied);
    std::string order(v1::OrderRequest& request, v1::OrderReply& reply);
    std::string upload(v1::UploadHead head, const std::string& bytes, std::uint64_t& number);
    /// All of the scene, and its revision.
    std::string fetch(std::string& bytes, std::uint64_t& revision);
    /// The last minute of the server's flight recorder.
    std::string record(std::string& bytes);
    void say(const v1::Word& word);

    v1::State state() const;
    bool nextEvent(v1::Event& event);

private:
    using Clock = std::chrono::steady_clock;
    class Call;

    std::shared_ptr<grpc::Channel> channel() const;
    void read();
    void hear(const v1::News& news);
    void beat();

    std::string target_;
    std::function<void(const v1::News&)> heardBy_;
    std::shared_ptr<grpc::ChannelCredentials> credentials_;
    std::unique_ptr<v1::Haptics::Stub> stub_, uploads_;
    grpc::ClientContext context_;
    std::unique_ptr<grpc::ClientReaderWriter<v1::Word, v1::News>> call_;
    std::mutex writing_;
    mutable std::mutex mutex_; ///< of all below
    std::condition_variable changed_;
    std::set<grpc::ClientContext*> calls_; ///< that are under way
    std::string key_, fault_;
    bool leaving_ = false, ended_ = false, answered_ = false;
    Clock::time_point heard_ = Clock::now();
    v1::State state_;
    std::deque<v1::Event> events_;
    std::thread reader_, heart_;
};

} // namespace tactum
