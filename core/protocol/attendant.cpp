#include "core/protocol/attendant.h"

#include <algorithm>
#include <cmath>

#include "core/base/clock.h"
#include "core/protocol/edits.h"
#include "core/protocol/replies.h"

namespace tactum {
namespace {

constexpr double kLeastRate = 0.1, kMostRate = 1000;        // Hz
constexpr std::size_t kMostEvents = 256, kMostTrace = 4096; // ticks of the servo
constexpr std::int64_t kBeat = std::int64_t(1e9 * kHeartbeat);

} // namespace

Attendant::Attendant(HapticsService& service) : service_(service) {
    StartRead(&word_);
}

void Attendant::OnReadDone(bool ok) {
    const std::lock_guard lock(mutex_);
    if (!ok) return end(grpc::Status::OK);
    if (ended_) return;
    if (client_ == 0) begin();
    if (ended_) return;
    hear();
    if (!ended_) StartRead(&word_);
}

/// The first word: its client attends from here on.
void Attendant::begin() {
    const auto welcome = service_.stage().join(word_.name(), word_.wants_pen());
    if (!welcome) return end(statusOf(welcome.error()));
    client_ = welcome->id;
    bodies_ = word_.bodies();
    telemetry_ = word_.telemetry();
    v1::Welcome& to = *news_.mutable_welcome();
    to.set_key(welcome->key);
    to.set_server(service_.settings().name);
    const auto& devices = service_.stage().devices();
    for (std::size_t hand = 0; hand < devices.size(); ++hand)
        tactum::write(hand == 0 ? *to.mutable_device() : *to.add_other(), devices[hand]);
    to.set_revision(service_.stage().scenery().revision);
    to.set_pen(welcome->pen);
    to.set_push_limit(service_.settings().pushLimit);
    writing_ = true;
    lastWrite_ = monotonicNanoseconds();
    StartWrite(&news_);
}

void Attendant::hear() {
    service_.stage().heard(client_);
    if (const double rate = word_.state_rate(); std::isfinite(rate) && rate != 0)
        rate_ = rate < 0 ? 0 : std::clamp(rate, kLeastRate, kMostRate);
    if (word_.has_push()) push();
    if (word_.has_hand()) lead();
    if (word_.seen() > seen_ && word_.seen() <= sent_) {
        seen_ = word_.seen();
        const double trip = 1e-9 * double(monotonicNanoseconds() - sentAt_[seen_ % sentAt_.size()]);
        roundTrip_ += 0.2 * (trip - roundTrip_);
    }
}

/// No longer than the server allows.
void Attendant::push() {
    const auto force = vectorOf(word_.push().force());
    if (!force) return;
    const double size = force->norm(), limit = service_.settings().pushLimit;
    service_.stage().push(client_, word_.push().hand(), size > limit ? Vec3(limit / size * *force) : *force);
}

/// What cannot be led is left alone.
void Attendant::lead() {
    const v1::HandGoal& goal = word_.hand();
    if (const auto to = vectorOf(goal.position()))
        (void)service_.stage().leadHand(client_, goal.hand(),
                                        {*to, goal.jumps(), goal.number(), goal.held(), goal.time()});
}

/// How many states may be under way: as many as fit into a round trip, and one.
std::uint64_t Attendant::credit() const {
    return std::clamp<std::uint64_t>(1 + std::uint64_t(std::ceil(rate_ * std::min(roundTrip_, 1.0))), 2,
                                     sentAt_.size() / 2);
}

bool Attendant::mayState(std::int64_t now) const {
    // A half of the stage's tick early rather than late.
    constexpr std::int64_t kEarly = 500'000;
    return rate_ > 0 && sent_ - seen_ < credit() && double(now - lastState_ + kEarly) * rate_ >= 1e9;
}

void Attendant::tell(const StageState& state, std::span<const StageEvent> events) {
    const std::lock_guard lock(mutex_);
    if (client_ == 0 || ended_) return;
    for (const StageEvent& event : events) {
        if (event.only != 0 && event.only != client_) continue;
        if (events_.size() < kMostEvents)
            events_.push_back(event);
        else
            lostEvents_ = true;
    }
    if (telemetry_) keepTraces(state.engine);
    if (writing_) return;
    const bool due = mayState(state.at);
    if (due) {
        state_ = state;
        for (std::size_t hand = 0; hand < traces_.size(); ++hand) {
            state_.engine.hands[hand].trace.assign(traces_[hand].begin(), traces_[hand].end());
            traces_[hand].clear();
        }
    }
    write(due);
}

void Attendant::keepTraces(const EngineReport& engine) {
    traces_.resize(engine.hands.size());
    for (std::size_t hand = 0; hand < traces_.size(); ++hand) {
        std::deque<TracePoint>& kept = traces_[hand];
        const std::vector<TracePoint>& told = engine.hands[hand].trace;
        kept.insert(kept.end(), told.begin(), told.end());
        if (kept.size() > kMostTrace) kept.erase(kept.begin(), kept.end() - kMostTrace);
    }
}

/// The next thing to say, if there is any.
void Attendant::write(bool stateIsNew) {
    const std::int64_t now = monotonicNanoseconds();
    news_.Clear();
    if (!events_.empty()) {
        tactum::write(*news_.mutable_event(), events_.front());
        events_.pop_front();
    } else if (lostEvents_) {
        news_.mutable_event()->set_kind(v1::Event::LOST);
        lostEvents_ = false;
    } else if (stateIsNew) {
        tactum::write(*news_.mutable_state(), state_, bodies_);
        news_.mutable_state()->set_pen(state_.pen == client_);
        if (telemetry_) news_.mutable_state()->set_telemetry(bytesOf(state_.engine));
        news_.mutable_state()->set_number(++sent_);
        sentAt_[sent_ % sentAt_.size()] = now;
        lastState_ = now;
    } else if (now - lastWrite_ >= kBeat) {
        news_.mutable_heartbeat();
    } else {
        return;
    }
    writing_ = true;
    lastWrite_ = now;
    StartWrite(&news_);
}

void Attendant::OnWriteDone(bool ok) {
    const std::lock_guard lock(mutex_);
    writing_ = false;
    if (!ok) return end(grpc::Status::CANCELLED);
    if (!ended_) write(false);
}

void Attendant::OnCancel() {
    const std::lock_guard lock(mutex_);
    end(grpc::Status::CANCELLED);
}

void Attendant::end(const grpc::Status& status) {
    if (std::exchange(ended_, true)) return;
    Finish(status);
}

void Attendant::OnDone() {
    service_.forget(this);
    if (client_ != 0) {
        service_.stage().leave(client_);
        service_.uploads().forget(client_);
    }
    delete this;
}

} // namespace tactum
