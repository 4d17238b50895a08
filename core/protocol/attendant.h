// One client that attends: what it says is heard, and it is told what is new, as fast as it reads.
#pragma once

#include <array>
#include <deque>
#include <mutex>
#include <vector>

#include "core/protocol/service.h"

namespace tactum {

/// The newest state, never an old one that waited: only so many are under way as the client has read of late
/// (credits), for what gRPC has taken can no longer be replaced. Events wait, up to a bound. Deletes itself.
class Attendant final : public grpc::ServerBidiReactor<v1::Word, v1::News> {
public:
    explicit Attendant(HapticsService& service);

    /// Thread: of the stage.
    void tell(const StageState& state, std::span<const StageEvent> events);

    void OnReadDone(bool ok) override;
    void OnWriteDone(bool ok) override;
    void OnCancel() override;
    void OnDone() override;

private:
    void begin();
    void hear();
    void push();
    void lead();
    void end(const grpc::Status& status);
    void write(bool stateIsNew);
    void keepTraces(const EngineReport& engine);
    bool mayState(std::int64_t now) const;
    std::uint64_t credit() const;

    HapticsService& service_;
    std::mutex mutex_; ///< of all below
    v1::Word word_;    ///< of gRPC while it reads
    v1::News news_;    ///< of gRPC while it writes
    ClientId client_ = 0;
    bool writing_ = false, ended_ = false, bodies_ = false, telemetry_ = false;
    double rate_ = 60; ///< Hz
    std::deque<StageEvent> events_;
    bool lostEvents_ = false;
    StageState state_;
    std::vector<std::deque<TracePoint>> traces_; ///< of a window, of each hand, that were not sent yet
    std::uint64_t sent_ = 0, seen_ = 0;
    std::array<std::int64_t, 64> sentAt_{}; ///< ns, by the number of the state
    double roundTrip_ = 0;                  ///< s
    std::int64_t lastState_ = 0, lastWrite_ = 0;
};

} // namespace tactum
