#include "core/recording/player.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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

Player::Player(std::shared_ptr<const RecordedRun> run) : run_(std::move(run)), servoState_(run_->device) {}

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
    if (auto whole = player.checkStates(); !whole) return tl::unexpected(whole.error());
    player.begin(player.beginningBefore(recorded.begin()));
    return player;
}

Result<void> Player::checkRows() const {
    const auto has = [](const auto& rows, const auto& states) {
        return rows.rows.empty() || rows.first == 0 || (!states.empty() && states.front().row == rows.first);
    };
    if (!has(run_->proxy, run_->proxyStates) || !has(run_->servo, run_->servoStates))
        return unusable("the state that it begins with is missing");
    for (const ProxyRow& row : run_->proxy.rows)
        if (!worldOf(row.world)) return unusable("scene " + std::to_string(row.world) + " is missing");
    return {};
}

Result<void> Player::checkStates() const {
    const RecordedRun& recorded = *run_;
    for (const SimStateBytes& kept : recorded.proxyStates) {
        SimState state;
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

// The last state of the servo before the time, and the last of the proxy before the model that it rendered.
// Without rows of the servo, the last of the proxy.
Player::Beginning Player::beginningBefore(double time) const {
    const auto& proxy = run_->proxy;
    const auto& servo = run_->servo;
    Beginning at;
    for (const ServoStateBytes& kept : run_->servoStates)
        if (kept.row >= servo.first && kept.row < servo.end() &&
            servo.rows[std::size_t(kept.row - servo.first)].time <= time)
            at.servo = std::size_t(kept.row - servo.first);
    for (const SimStateBytes& kept : run_->proxyStates) {
        if (kept.row < proxy.first || kept.row >= proxy.end()) continue;
        const std::size_t index = std::size_t(kept.row - proxy.first);
        const bool early =
            servo.rows.empty() ? proxy.rows[index].time <= time : kept.row <= servo.rows[at.servo].model;
        if (early) at.proxy = index;
    }
    return at;
}

const ServoRow* Player::servoRow() const {
    return nextServo_ == 0 ? nullptr : &run_->servo.rows[nextServo_ - 1];
}

void Player::count(const ProxyRow& row) {
    proxy_.stepsDown += row.fidelity() > proxy_.fidelity;
    proxy_.fidelity = row.fidelity();
}

void Player::count(const ServoRow& row) {
    periods_.add(row.time, 1e6 * std::abs(row.dt - 1 / run_->device.rate));
    servo_.periods = periods_.counted();
    servo_.misses += (row.flags & ServoRow::Late) != 0;
}

void Player::begin(const Beginning& at) {
    sim_ = {};
    servoState_ = ServoState(run_->device);
    nextProxy_ = at.proxy;
    nextServo_ = at.servo;
    modelSteps_ = run_->proxy.first + at.proxy;
    for (const SimStateBytes& kept : run_->proxyStates)
        if (kept.row == modelSteps_) read(kept.used(), sim_);
    for (const ServoStateBytes& kept : run_->servoStates)
        if (kept.row == run_->servo.first + at.servo) read(kept.used(), servoState_);
    time_ = run_->begin();
    proxy_ = {};
    servo_ = {};
    periods_ = {};
    // What only rows tell: no state keeps it.
    for (std::size_t i = 0; i < nextProxy_; ++i)
        count(run_->proxy.rows[i]);
    for (std::size_t i = 0; i < nextServo_; ++i)
        count(run_->servo.rows[i]);
    trace_.clear();
    steps_.clear();
    check_ = {};
}

void Player::seek(double time, double before) {
    begin(beginningBefore(time - before));
    advanceTo(time);
}

// A tick of the servo comes after the haptic step whose model it rendered, and before the next one: whatever
// the clocks say, for a step can be over before a tick that began earlier looks at its model.
void Player::advanceTo(double time) {
    const auto& proxy = run_->proxy.rows;
    const auto& servo = run_->servo.rows;
    for (;;) {
        const bool ticks = nextServo_ < servo.size();
        const std::uint64_t wanted = ticks ? servo[nextServo_].model : ~std::uint64_t(0);
        const bool steps = nextProxy_ < proxy.size() && modelSteps_ < wanted;
        if (ticks && servo[nextServo_].time <= time) {
            if (steps)
                stepProxy();
            else
                stepServo();
        } else if (steps && proxy[nextProxy_].time <= time) {
            stepProxy();
        } else {
            break;
        }
    }
    time_ = std::clamp(time, run_->begin(), run_->end());
    proxy_.rate = rateAt(proxy, nextProxy_);
    servo_.rate = rateAt(servo, nextServo_);
}

void Player::stepProxy() {
    const ProxyRow& row = run_->proxy.rows[nextProxy_++];
    const HapticOutput output = stepFrom(row, *worldOf(row.world), sim_);
    modelSteps_ = run_->proxy.first + nextProxy_;
    ProxyRow now = row;
    note(now, output);
    ++check_.proxySteps;
    if (const std::string what = difference(row, now); !what.empty())
        differs("haptic step", modelSteps_ - 1, row.time, what);
    proxy_.output = output;
    proxy_.finger = vectorOf(row.finger);
    proxy_.updates = modelSteps_;
    proxy_.worldRevision = row.world;
    proxy_.time = sim_.time;
    proxy_.bodies = sim_.bodies;
    proxy_.coupling = sim_.press.coupling;
    proxy_.boundHits += output.report.boundHit;
    proxy_.squeezed += output.report.squeezed;
    proxy_.passed += output.report.passed;
    count(row);
    steps_.push_back({&row, output});
}

void Player::stepServo() {
    const ServoRow& row = run_->servo.rows[nextServo_++];
    const LocalContactModel none;
    const ServoOutput output = stepFrom(row, servoState_, modelSteps_ == 0 ? none : sim_.model);
    ServoRow now = row;
    note(now, output, servoState_);
    ++check_.servoSteps;
    const std::uint64_t number = run_->servo.first + nextServo_ - 1;
    if (const std::string what = difference(row, now); !what.empty())
        differs("servo tick", number, row.time, what);
    note(servo_, output, servoState_);
    count(row);
    trace_.push_back(
        tracePoint({.t = row.time, .finger = servo_.finger, .force = servo_.force, .energy = servo_.energy},
                   sim_.model));
}

void Player::differs(const char* loop, std::uint64_t number, double time, const std::string& what) {
    if (check_.differ++ > 0) return;
    check_.first = std::string(loop) + " " + std::to_string(number) + " at ";
    appendNumber(check_.first, time - run_->begin());
    check_.first += " s: " + what;
}

} // namespace tactum
