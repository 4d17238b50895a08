#include "core/recording/player.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/base/numbers.h"
#include "core/base/realtime.h"
#include "core/haptics/compile.h"

namespace tactum {
namespace {

/// Rates are those of the last rows: telemetry has them over half a second.
constexpr double kRateTime = 0.5;

bool sameBits(const Triple& a, const Triple& b) {
    return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}
bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string textOf(const Triple& v) {
    std::string text = "(";
    for (const double number : v) {
        if (text.size() > 1) text += ", ";
        appendNumber(text, number);
    }
    return text + ")";
}

std::string compared(const char* what, const Triple& recorded, const Triple& now) {
    return std::string(what) + " was " + textOf(recorded) + " and is now " + textOf(now);
}

/// What is different; empty when nothing is.
std::string difference(const ProxyRow& recorded, const ProxyRow& now) {
    if (!sameBits(recorded.proxy, now.proxy)) return compared("the proxy, in m,", recorded.proxy, now.proxy);
    if (!sameBits(recorded.force, now.force)) return compared("the force, in N,", recorded.force, now.force);
    if (recorded.contacts != now.contacts)
        return "there were " + std::to_string(recorded.contacts) + " contacts and are now " +
               std::to_string(now.contacts);
    return {};
}

std::string difference(const ServoRow& recorded, const ServoRow& now) {
    if (!sameBits(recorded.force, now.force)) return compared("the force, in N,", recorded.force, now.force);
    if (recorded.inhibit != now.inhibit || !sameBits(recorded.gain, now.gain) ||
        recorded.faults != now.faults)
        return "the guard decided otherwise";
    if (recorded.oscillations != now.oscillations) return "oscillations were noticed otherwise";
    return {};
}

/// Events a second at the end of `rows`, up to the index.
template <class Row> double rateAt(const std::vector<Row>& rows, std::size_t next) {
    if (next < 2) return 0;
    std::size_t first = next - 1;
    while (first > 0 && rows[next - 1].time - rows[first].time < kRateTime)
        --first;
    const double span = rows[next - 1].time - rows[first].time;
    return span > 0 ? double(next - 1 - first) / span : 0;
}

tl::unexpected<Error> unusable(const std::string& what) {
    return inputError("the recording: " + what + "; it is damaged, use another one");
}

} // namespace

Player::Player(std::shared_ptr<const RecordedRun> run) : run_(std::move(run)), others_(run_->others.size()) {
    for (std::size_t i = 0; i < run_->hands(); ++i)
        hands_.emplace_back(run_->hand(i));
}

Result<Player> Player::open(std::shared_ptr<const RecordedRun> run, const Progress& progress) {
    assertNotRealtime();
    Player player(std::move(run));
    const RecordedRun& recorded = *player.run_;
    const World* previous = nullptr;
    for (const RecordedScene& scene : recorded.scenes) {
        const double done = double(player.worlds_.size()), all = double(recorded.scenes.size());
        auto world = compileNumbered(*scene.scene, scene.numbers, previous,
                                     partOf(progress, done / all, (done + 1) / all));
        if (!world) return tl::unexpected(world.error());
        previous = (player.worlds_[scene.numbers.revision] = std::move(*world)).get();
    }
    if (auto whole = player.checkRows(); !whole) return tl::unexpected(whole.error());
    if (auto whole = player.checkStates<SimState>(recorded); !whole) return tl::unexpected(whole.error());
    for (const HandRecord& other : recorded.others)
        if (auto whole = player.checkStates<HandState>(other); !whole) return tl::unexpected(whole.error());
    player.begin(player.beginningBefore(recorded.begin()));
    return player;
}

Result<void> Player::checkRows() const {
    const auto has = [](const auto& rows, const auto& states) {
        return rows.rows.empty() || rows.first == 0 || (!states.empty() && states.front().row == rows.first);
    };
    if (run_->hands() > std::size_t(kMaxHands)) return unusable("it has more hands than can be");
    for (const Hand& hand : hands_)
        if (!has(hand.recorded->proxy, hand.recorded->proxyStates) ||
            !has(hand.recorded->servo, hand.recorded->servoStates))
            return unusable("the state that it begins with is missing");
    for (const HandRecord& other : run_->others)
        if (!std::ranges::equal(run_->proxyStates, other.proxyStates, {}, &SimStateBytes::row,
                                &SimStateBytes::row))
            return unusable("the states of its hands are not of the same haptic steps");
    for (const ProxyRow& row : run_->proxy.rows)
        if (!worldOf(row.world)) return unusable("scene " + std::to_string(row.world) + " is missing");
    return {};
}

template <class State> Result<void> Player::checkStates(const HandRecord& recorded) const {
    for (const SimStateBytes& kept : recorded.proxyStates) {
        State state;
        if (!read(kept.used(), state))
            return unusable("the state before haptic step " + std::to_string(kept.row) + " cannot be read");
        for (const auto& [revision, world] : worlds_)
            if (world->shapeRevision == state.shapeRevision && !belongsTo(state, *world))
                return unusable("the state before haptic step " + std::to_string(kept.row) +
                                " touches what its scene does not have");
    }
    for (const ServoStateBytes& kept : recorded.servoStates)
        if (ServoState state(recorded.device); !read(kept.used(), state))
            return unusable("the state before servo tick " + std::to_string(kept.row) + " cannot be read");
    return {};
}

const World* Player::worldOf(std::uint64_t revision) const {
    const auto found = worlds_.find(revision);
    return found == worlds_.end() ? nullptr : found->second.get();
}

const World* Player::world() const {
    const auto& rows = run_->proxy.rows;
    if (rows.empty()) return nullptr;
    return worldOf(rows[nextProxy_ == 0 ? 0 : nextProxy_ - 1].world);
}

std::shared_ptr<const World> Player::sharedWorld() const {
    const World* now = world();
    const auto found = now ? worlds_.find(now->revision) : worlds_.end();
    return found == worlds_.end() ? nullptr : found->second;
}

// The last state of each servo before the time, and the last of the proxy before the models that they
// rendered. Without rows of a servo, the last of the proxy.
Player::Beginning Player::beginningBefore(double time) const {
    Beginning at;
    std::uint64_t model = ~std::uint64_t(0);
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        const auto& servo = hands_[i].recorded->servo;
        for (const ServoStateBytes& kept : hands_[i].recorded->servoStates)
            if (kept.row >= servo.first && kept.row < servo.end() &&
                servo.rows[std::size_t(kept.row - servo.first)].time <= time)
                at.servo[i] = std::size_t(kept.row - servo.first);
        if (!servo.rows.empty()) model = std::min(model, servo.rows[at.servo[i]].model);
    }
    const auto& proxy = run_->proxy;
    for (const SimStateBytes& kept : run_->proxyStates) {
        if (kept.row < proxy.first || kept.row >= proxy.end()) continue;
        const std::size_t index = std::size_t(kept.row - proxy.first);
        const bool early = model == ~std::uint64_t(0) ? proxy.rows[index].time <= time : kept.row <= model;
        if (early) at.proxy = index;
    }
    return at;
}

const ServoRow* Player::servoRow(std::size_t hand) const {
    const std::size_t next = hands_[hand].nextServo;
    return next == 0 ? nullptr : &hands_[hand].recorded->servo.rows[next - 1];
}

void Player::count(const ProxyRow& row) {
    proxy_.stepsDown += row.fidelity() > proxy_.fidelity;
    proxy_.fidelity = row.fidelity();
}

void Player::Hand::count(const ServoRow& row) {
    periods.add(row.time, 1e6 * (row.dt - 1 / recorded->device.rate));
    servo.periods = periods.counted();
    servo.misses += (row.flags & ServoRow::Late) != 0;
}

void Player::begin(const Beginning& at) {
    sim_ = {};
    nextProxy_ = at.proxy;
    modelSteps_ = run_->proxy.first + at.proxy;
    for (const SimStateBytes& kept : run_->proxyStates)
        if (kept.row == modelSteps_) read(kept.used(), sim_);
    for (std::size_t i = 0; i < hands_.size(); ++i)
        begin(i, at.servo[i]);
    time_ = run_->begin();
    proxy_ = {};
    // What only rows tell: no state keeps it.
    for (std::size_t i = 0; i < nextProxy_; ++i)
        count(run_->proxy.rows[i]);
    check_ = {};
}

void Player::begin(std::size_t i, std::size_t servo) {
    Hand& hand = hands_[i] = Hand(run_->hand(i));
    hand.nextServo = servo;
    for (const ServoStateBytes& kept : hand.recorded->servoStates)
        if (kept.row == hand.recorded->servo.first + servo) read(kept.used(), hand.state);
    for (std::size_t k = 0; k < servo; ++k)
        hand.count(hand.recorded->servo.rows[k]);
    if (i == 0) return;
    others_[i - 1] = {};
    for (const SimStateBytes& kept : hand.recorded->proxyStates)
        if (kept.row == modelSteps_) read(kept.used(), others_[i - 1]);
}

void Player::seek(double time, double before) {
    begin(beginningBefore(time - before));
    advanceTo(time);
}

/// Whose tick comes next: that of the oldest model, which later haptic steps write over.
std::size_t Player::nextHand() const {
    std::size_t found = 0;
    for (std::size_t i = 1; i < hands_.size(); ++i) {
        const ServoRow *best = hands_[found].next(), *row = hands_[i].next();
        if (row && (!best || std::tie(row->model, row->time) < std::tie(best->model, best->time))) found = i;
    }
    return found;
}

// A tick of the servo comes after the haptic step whose model it rendered, and before the next one: whatever
// the clocks say, for a step can be over before a tick that began earlier looks at its model.
void Player::advanceTo(double time) {
    const auto& proxy = run_->proxy.rows;
    for (;;) {
        const std::size_t hand = nextHand();
        const ServoRow* tick = hands_[hand].next();
        const bool steps =
            nextProxy_ < proxy.size() && modelSteps_ < (tick ? tick->model : ~std::uint64_t(0));
        if (tick && tick->time <= time) {
            if (steps)
                stepProxy();
            else
                stepServo(hand);
        } else if (steps && proxy[nextProxy_].time <= time) {
            stepProxy();
        } else {
            break;
        }
    }
    time_ = std::clamp(time, run_->begin(), run_->end());
    proxy_.rate = rateAt(proxy, nextProxy_);
    for (Hand& hand : hands_)
        hand.servo.rate = rateAt(hand.recorded->servo.rows, hand.nextServo);
}

void Player::speakOf(std::size_t hand) {
    spoken_ = hand;
    static_cast<TouchTelemetry&>(proxy_) = hands_[hand].touch;
}

void Player::stepProxy() {
    const std::size_t index = nextProxy_++;
    std::array<ProxyRow, std::size_t(kMaxHands)> rows;
    std::array<HapticOutput, std::size_t(kMaxHands)> outputs;
    for (std::size_t i = 0; i < hands_.size(); ++i)
        rows[i] = hands_[i].recorded->proxy.rows[index];
    stepFrom({rows.data(), hands_.size()}, *worldOf(rows[0].world), sim_, others_, outputs);
    modelSteps_ = run_->proxy.first + nextProxy_;
    for (std::size_t i = 0; i < hands_.size(); ++i)
        noteStep(i, outputs[i]);
    speakOf(spoken_);
    proxy_.updates = modelSteps_;
    proxy_.worldRevision = rows[0].world;
    proxy_.time = sim_.time;
    proxy_.bodies = sim_.bodies;
    count(run_->proxy.rows[index]);
}

void Player::noteStep(std::size_t i, const HapticOutput& output) {
    Hand& hand = hands_[i];
    const ProxyRow& row = hand.recorded->proxy.rows[nextProxy_ - 1];
    ProxyRow now = row;
    note(now, output);
    ++check_.proxySteps;
    if (const std::string what = difference(row, now); !what.empty())
        differs(i, "haptic step", modelSteps_ - 1, row.time, what);
    hand.touch = {output, vectorOf(row.finger), stateOf(i).press.coupling};
    hand.touched = touchedPlace(output, *worldOf(row.world));
    proxy_.boundHits += output.report.boundHit;
    proxy_.squeezed += output.report.squeezed;
    proxy_.passed += output.report.passed;
    hand.steps.push_back({&row, output});
}

void Player::stepServo(std::size_t i) {
    Hand& hand = hands_[i];
    const ServoRow& row = *hand.next();
    const LocalContactModel none, &model = modelSteps_ == 0 ? none : stateOf(i).model;
    const std::uint64_t number = hand.recorded->servo.first + hand.nextServo++;
    const ServoOutput output = stepFrom(row, hand.state, model);
    ServoRow now = row;
    note(now, output, hand.state);
    ++check_.servoSteps;
    if (const std::string what = difference(row, now); !what.empty())
        differs(i, "servo tick", number, row.time, what);
    note(hand.servo, output, hand.state);
    hand.count(row);
    hand.trace.push_back(tracePoint(row.time, hand.servo, output, stateOf(i).model, hand.touched));
}

void Player::differs(std::size_t hand, const char* loop, std::uint64_t number, double time,
                     const std::string& what) {
    if (check_.differ++ > 0) return;
    const std::string whose = hands_.size() > 1 ? "hand " + std::to_string(hand + 1) + ": " : std::string();
    check_.first = whose + loop + " " + std::to_string(number) + " at ";
    appendNumber(check_.first, time - run_->begin());
    check_.first += " s: " + what;
}

} // namespace tactum
