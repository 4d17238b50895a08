// Steps through a recording: the loops' own functions on the recorded inputs, compared with what came out.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/runtime/channels.h"
#include "core/runtime/recorded_run.h"

namespace tactum {

/// What a replay has found so far.
struct ReplayCheck {
    std::uint64_t proxySteps = 0, servoSteps = 0; ///< of all hands
    std::uint64_t differ = 0; ///< steps whose results are other bits than the recorded ones
    std::string first;        ///< a sentence about the first of these
};

/// One haptic step again.
struct ReplayedStep {
    const ProxyRow* row = nullptr;
    HapticOutput output;
};

/// The time of a replay is the recording's: s on the clock of its rows, from run().begin() to run().end().
/// Thread: one, any but real time.
class Player {
public:
    /// Compiles every scene of the recording. Fails when a state or a row names what its scene does not have.
    static Result<Player> open(std::shared_ptr<const RecordedRun> run, const Progress& progress = {});

    const RecordedRun& run() const { return *run_; }
    double time() const { return time_; }
    bool atEnd() const { return time_ >= run_->end(); }

    /// Takes all steps up to a time, in the order in which they depended on each other.
    void advanceTo(double time);
    /// Goes there from the last kept state before it. At most some seconds are stepped through.
    /// `before`: that many seconds before it are stepped through as well, for what shows them.
    void seek(double time, double before = 0);

    // What the last steps gave.
    /// The World of the last haptic step; of the next one before the first. nullptr when there is none.
    const World* world() const;
    /// The same, to keep.
    std::shared_ptr<const World> sharedWorld() const;
    /// The hand that is spoken of, and what all share.
    const ProxyTelemetry& proxy() const { return proxy_; }
    /// Whom proxy() is about from now on, below run().hands(); at first the first.
    void speakOf(std::size_t hand);
    /// With the misses since the recording began; whose they were it does not know.
    const ServoTelemetry& servo(std::size_t hand = 0) const { return hands_[hand].servo; }
    /// What a hand touches. `hand`, here and there: below run().hands().
    const TouchTelemetry& touch(std::size_t hand) const { return hands_[hand].touch; }
    /// Of the last servo tick; nullptr before the first.
    const ServoRow* servoRow(std::size_t hand = 0) const;
    /// Every servo tick and every haptic step of a hand since the last call of these.
    std::vector<TracePoint> takeTrace(std::size_t hand = 0) { return std::exchange(hands_[hand].trace, {}); }
    std::vector<ReplayedStep> takeSteps(std::size_t hand = 0) {
        return std::exchange(hands_[hand].steps, {});
    }
    /// Of all steps since open() or the last seek().
    const ReplayCheck& check() const { return check_; }

private:
    explicit Player(std::shared_ptr<const RecordedRun> run);

    Result<void> checkRows() const;
    template <class State> Result<void> checkStates(const HandRecord& hand) const;
    /// Indices of the rows to go on with.
    struct Beginning {
        std::size_t proxy = 0;
        std::array<std::size_t, std::size_t(kMaxHands)> servo{};
    };
    /// What a replay knows of one hand.
    struct Hand {
        explicit Hand(const HandRecord& hand) : recorded(&hand), state(hand.device) {}

        /// The tick to take next; nullptr after the last.
        const ServoRow* next() const {
            return nextServo < recorded->servo.rows.size() ? &recorded->servo.rows[nextServo] : nullptr;
        }
        void count(const ServoRow& row);

        const HandRecord* recorded;
        ServoState state;
        std::size_t nextServo = 0;
        TouchTelemetry touch;
        TouchedPlace touched; ///< of it
        ServoTelemetry servo;
        RecentPeriods periods;
        std::vector<TracePoint> trace;
        std::vector<ReplayedStep> steps;
    };
    Beginning beginningBefore(double time) const;
    void begin(const Beginning& at);
    void begin(std::size_t hand, std::size_t servo);
    HandState& stateOf(std::size_t hand) { return hand == 0 ? sim_ : others_[hand - 1]; }
    void count(const ProxyRow& row);
    std::size_t nextHand() const;
    void stepProxy();
    void noteStep(std::size_t hand, const HapticOutput& output);
    void stepServo(std::size_t hand);
    void differs(std::size_t hand, const char* loop, std::uint64_t number, double time,
                 const std::string& what);
    const World* worldOf(std::uint64_t revision) const;

    std::shared_ptr<const RecordedRun> run_;
    std::map<std::uint64_t, std::shared_ptr<const World>> worlds_; ///< by revision
    SimState sim_;
    std::vector<HandState> others_; ///< the second hand and so on
    std::vector<Hand> hands_;
    std::size_t spoken_ = 0; ///< whom proxy_ is about
    std::size_t nextProxy_ = 0;
    std::uint64_t modelSteps_ = 0; ///< rows of the proxy that led to the models; 0: there are none
    double time_ = 0;
    ProxyTelemetry proxy_;
    ReplayCheck check_;
};

} // namespace tactum
