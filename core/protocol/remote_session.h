// A window's life at a haptic server: keeps the connection, sends orders and scenes, keeps what is told. For
// this folder.
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/port/hand_target.h"
#include "core/protocol/connection.h"
#include "core/protocol/remote_settings.h"
#include "core/runtime/engine_report.h"
#include "core/runtime/shared_scene.h"
#include "core/scene/known_parts.h"

namespace tactum {

/// Three threads of its own: one keeps the connection and leads the hand, one sends orders, one scenes, so
/// that none waits for another. Thread of every member: that of its owner, one.
class RemoteSession {
public:
    using Order = v1::OrderRequest;

    RemoteSession(RemoteSettings settings, std::shared_ptr<HandTarget> hand);
    ~RemoteSession() { end(); }
    RemoteSession(const RemoteSession&) = delete;
    RemoteSession& operator=(const RemoteSession&) = delete;

    const RemoteSettings& settings() const { return settings_; }
    /// Attends, and goes on trying. Waits for the first state, for as long as the settings say.
    void begin();
    /// Leaves.
    void end();
    /// Whether the server is there and was heard of late.
    bool open() const;
    /// Why it is not open, in the server's words; empty where there was no answer.
    std::string fault() const;

    /// `settles`: stays so until another one of its kind, with every new connection.
    void order(Order order, bool settles = false);
    void say(const v1::Word& word);
    /// The newest is sent; what comes in between never is.
    void publish(std::shared_ptr<const World> world);
    /// Of the server's flight recorder; waits for it. False: it does not answer.
    bool record(std::string& bytes);

    /// The newest, and the World that it is of, null when that is none of ours. False: nothing is known of
    /// the server.
    bool read(EngineReport& report, std::shared_ptr<const World>& world);
    /// Of a hand of the report.
    bool popTrace(std::size_t hand, TracePoint& point);
    /// Nothing that was traced of it before comes any more.
    void dropTrace(std::size_t hand);
    std::optional<SharedScene::Arrived> arrived();
    std::optional<std::string> refused();
    std::optional<std::string> forceSaid();
    std::optional<std::string> penAskedBy();
    struct Standing {
        bool pen = false;
        std::string holder, asker;
        std::size_t attending = 0;
    };
    Standing standing() const;

private:
    struct Felt {
        std::uint64_t revision = 0; ///< the server's
        std::shared_ptr<const World> world;
    };
    /// The scene of the server as it is known here.
    struct Known {
        std::uint64_t revision = 0; ///< 0: not of this connection
        bool ever = false;          ///< of an earlier one at least
        Scene scene;
        KnownParts parts;
    };

    void keep();
    void connect();
    void lose(const std::string& why);
    void hear(std::uint64_t from, const v1::News& news);
    void hear(std::uint64_t from, const v1::State& state);
    void sendOrders();
    void sendScenes();
    std::optional<std::size_t> ledHand() const;
    bool isNew() const;
    bool fetch(Connection& with);
    void meet(Scene there, std::uint64_t revision);
    void send(Connection& with, const std::shared_ptr<const World>& world);
    std::string apply(Connection& with, const Scene& of, v1::Applied& applied) const;
    void feel(std::uint64_t revision, std::shared_ptr<const World> world);
    std::shared_ptr<Connection> link() const;

    RemoteSettings settings_;
    std::shared_ptr<HandTarget> hand_;

    mutable std::mutex mutex_; ///< of all below, up to `known_`
    std::condition_variable changed_;
    std::shared_ptr<Connection> link_; ///< null: not connected
    std::uint64_t connection_ = 0;     ///< its number: what an older one is still heard to say is nothing
    std::string fault_;
    bool ending_ = false;
    std::deque<Order> orders_;
    /// What a new connection is told again, by its kind and the hand that it names, or none.
    std::map<std::pair<int, std::optional<std::uint32_t>>, Order> settled_;
    bool settles_ = false;                       ///< with the first state of a connection
    std::shared_ptr<const World> wanted_, done_; ///< published; sent, or refused
    std::uint64_t newestRevision_ = 0;           ///< of the server's scene, as far as it was told
    std::deque<Felt> felt_;                      ///< Worlds on their way, oldest first
    std::optional<EngineReport> told_;
    std::uint64_t feltRevision_ = 0;
    std::vector<std::deque<TracePoint>> traces_; ///< of each hand
    Standing standing_;
    std::optional<SharedScene::Arrived> arrived_;
    std::optional<std::string> refusal_, forceSaid_, askedBy_;

    int refusals_ = 0; ///< one after the other, that nobody else's pen explains
    Known known_;      ///< of the thread that sends scenes
    std::thread keeper_, orderer_, sender_;
};

} // namespace tactum
