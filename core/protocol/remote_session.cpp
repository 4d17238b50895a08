#include "core/protocol/remote_session.h"

#include <algorithm>
#include <chrono>

#include "core/base/text.h"
#include "core/scene/scene_bytes.h"

namespace tactum {
namespace {

constexpr auto kHandTick = std::chrono::milliseconds(2), kRetry = std::chrono::milliseconds(500);
constexpr int kTries = 6;
constexpr double kAnswer = 1;            ///< s, that a try waits
constexpr std::size_t kMostTrace = 8192; ///< as many as wait in an engine's own queue
constexpr std::size_t kMostFelt = 256;   ///< Worlds on their way
constexpr std::size_t kLongestSentence = 1000;
constexpr std::size_t kLongestEdit = 3 << 20; ///< bytes; a longer scene is uploaded

bool isSame(const HandGoal& a, const HandGoal& b) {
    return a.position == b.position && a.teleport == b.teleport && a.sequence == b.sequence &&
           a.held == b.held && a.time == b.time;
}

/// Part by part: what came over another connection lies elsewhere in memory.
bool isSame(const Scene& a, const Scene& b) {
    return bytesOf(withoutKept(a), KnownParts(a)) == bytesOf(withoutKept(b), KnownParts(b));
}

v1::Word wordOf(const HandGoal& goal, std::size_t hand) {
    v1::Word word;
    v1::HandGoal& to = *word.mutable_hand();
    to.set_hand(std::uint32_t(hand));
    to.mutable_position()->set_x(goal.position.x());
    to.mutable_position()->set_y(goal.position.y());
    to.mutable_position()->set_z(goal.position.z());
    to.set_jumps(goal.teleport);
    to.set_number(goal.sequence);
    to.set_held(goal.held);
    to.set_time(goal.time);
    return word;
}

} // namespace

RemoteSession::RemoteSession(RemoteSettings settings, std::shared_ptr<HandTarget> hand)
    : settings_(std::move(settings)), hand_(std::move(hand)) {}

void RemoteSession::begin() {
    if (!keeper_.joinable()) {
        keeper_ = std::thread([this] { keep(); });
        orderer_ = std::thread([this] { sendOrders(); });
        sender_ = std::thread([this] { sendScenes(); });
    }
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::duration<double>(settings_.patience),
                      [this] { return told_ && link_; });
}

bool RemoteSession::open() const {
    const std::lock_guard lock(mutex_);
    return link_ && told_ && link_->open();
}

std::string RemoteSession::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

std::shared_ptr<Connection> RemoteSession::link() const {
    const std::lock_guard lock(mutex_);
    return link_;
}

void RemoteSession::say(const v1::Word& word) {
    if (const auto with = link()) with->say(word);
}

bool RemoteSession::record(std::string& bytes) {
    const auto with = link();
    return with && with->record(bytes).empty();
}

void RemoteSession::publish(std::shared_ptr<const World> world) {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(world);
    changed_.notify_all();
}

// ---- what is told ----

bool RemoteSession::read(EngineReport& report, std::shared_ptr<const World>& world) {
    const std::lock_guard lock(mutex_);
    if (!told_ || !link_ || !link_->open()) return false;
    report = *told_;
    const auto found = std::ranges::find(felt_, feltRevision_, &Felt::revision);
    if (found == felt_.end()) return true;
    world = found->world;
    felt_.erase(felt_.begin(), found);
    return true;
}

bool RemoteSession::popTrace(std::size_t hand, TracePoint& point) {
    const std::lock_guard lock(mutex_);
    if (hand >= traces_.size() || traces_[hand].empty()) return false;
    point = traces_[hand].front();
    traces_[hand].pop_front();
    return true;
}

void RemoteSession::dropTrace(std::size_t hand) {
    const std::lock_guard lock(mutex_);
    if (hand < traces_.size()) traces_[hand].clear();
}

std::optional<SharedScene::Arrived> RemoteSession::arrived() {
    const std::lock_guard lock(mutex_);
    return std::exchange(arrived_, {});
}

std::optional<std::string> RemoteSession::refused() {
    const std::lock_guard lock(mutex_);
    return std::exchange(refusal_, {});
}

std::optional<std::string> RemoteSession::forceSaid() {
    const std::lock_guard lock(mutex_);
    return std::exchange(forceSaid_, {});
}

std::optional<std::string> RemoteSession::penAskedBy() {
    const std::lock_guard lock(mutex_);
    return std::exchange(askedBy_, {});
}

RemoteSession::Standing RemoteSession::standing() const {
    const std::lock_guard lock(mutex_);
    return standing_;
}

// ---- the connection ----

/// The simulated hand, which the mouse leads: the first of them.
std::optional<std::size_t> RemoteSession::ledHand() const {
    if (!told_) return std::nullopt;
    const auto found =
        std::ranges::find_if(told_->hands, [](const HandReport& hand) { return !hand.device.real; });
    if (found == told_->hands.end()) return std::nullopt;
    return std::size_t(found - told_->hands.begin());
}

/// Makes it, and makes it again; meanwhile leads the hand.
void RemoteSession::keep() {
    HandGoal sent;
    std::unique_lock lock(mutex_);
    while (!ending_) {
        const std::shared_ptr<Connection> now = link_;
        const std::optional<std::size_t> led = ledHand();
        lock.unlock();
        if (!now) {
            connect();
        } else if (!now->open()) {
            now->leave();
            lose(now->fault());
        } else if (hand_ && led) {
            const HandGoal goal = hand_->read();
            if (!isSame(goal, sent)) now->say(wordOf(goal, *led));
            sent = goal;
        }
        lock.lock();
        changed_.wait_for(lock, link_ ? std::chrono::milliseconds(kHandTick) : kRetry,
                          [this] { return ending_; });
    }
}

void RemoteSession::connect() {
    std::uint64_t mine = 0;
    {
        const std::lock_guard lock(mutex_);
        mine = ++connection_;
        newestRevision_ = 0; // the server before counted its own
    }
    auto made = std::make_shared<Connection>(
        settings_.target, settings_.name,
        ConnectionOptions{settings_.certificate, settings_.token, settings_.stateRate, kAnswer, true,
                          [this, mine](const v1::News& news) { hear(mine, news); }});
    const std::lock_guard lock(mutex_);
    if (!made->open()) {
        fault_ = made->answered() ? printable(made->fault(), kLongestSentence) : std::string();
        return;
    }
    link_ = std::move(made);
    fault_.clear();
    done_ = nullptr; // of whatever server was there before
    orders_.clear();
    settles_ = true;
    changed_.notify_all();
}

void RemoteSession::lose(const std::string& why) {
    std::shared_ptr<Connection> gone; // dies after the lock: its thread may be about to be heard
    const std::lock_guard lock(mutex_);
    gone = std::move(link_);
    link_ = nullptr;
    ++connection_;
    fault_ = why.empty() ? "it is not heard any more" : printable(why, kLongestSentence);
    told_.reset();
    felt_.clear();
    standing_ = {};
    changed_.notify_all();
}

void RemoteSession::hear(std::uint64_t from, const v1::News& news) {
    if (news.has_state()) return hear(from, news.state());
    const std::lock_guard lock(mutex_);
    if (from != connection_) return;
    if (news.has_welcome()) newestRevision_ = news.welcome().revision();
    const v1::Event& event = news.event();
    if (event.kind() == v1::Event::SCENE)
        newestRevision_ = std::max<std::uint64_t>(newestRevision_, event.revision());
    if (event.kind() == v1::Event::PEN_ASKED) askedBy_ = printable(event.text(), kLongestName);
    if (event.kind() == v1::Event::FORCE && !event.client().empty() && event.client() != settings_.name)
        forceSaid_ = printable(event.text(), kLongestSentence);
    changed_.notify_all();
}

void RemoteSession::hear(std::uint64_t from, const v1::State& state) {
    auto report = readReport(state.telemetry());
    const std::lock_guard lock(mutex_);
    if (from != connection_) return;
    if (!report) {
        refusal_ = report.error().text;
        return;
    }
    traces_.resize(report->hands.size());
    if (std::exchange(settles_, false))
        for (const auto& [kind, each] : settled_)
            if (each.of() < report->hands.size()) orders_.push_back(each); // another server may have fewer
    for (std::size_t hand = 0; hand < traces_.size(); ++hand) {
        std::deque<TracePoint>& kept = traces_[hand];
        std::vector<TracePoint>& told = report->hands[hand].trace;
        kept.insert(kept.end(), told.begin(), told.end());
        if (kept.size() > kMostTrace) kept.erase(kept.begin(), kept.end() - kMostTrace);
        told.clear();
    }
    told_ = std::move(*report);
    feltRevision_ = state.revision();
    standing_ = {state.pen(), printable(state.pen_holder(), kLongestName),
                 printable(state.pen_asker(), kLongestName), state.attending()};
    changed_.notify_all();
}

void RemoteSession::end() {
    std::shared_ptr<Connection> gone;
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        ++connection_;
        gone = std::move(link_);
        link_ = nullptr;
    }
    changed_.notify_all();
    if (gone) gone->leave();
    for (std::thread* thread : {&keeper_, &orderer_, &sender_})
        if (thread->joinable()) thread->join();
    const std::lock_guard lock(mutex_);
    ending_ = false;
    told_.reset();
}

// ---- orders ----

void RemoteSession::order(Order order, bool settles) {
    const std::lock_guard lock(mutex_);
    if (settles)
        settled_[{order.what_case(), order.has_of() ? std::optional(order.of()) : std::nullopt}] = order;
    if (link_) orders_.push_back(std::move(order));
    changed_.notify_all();
}

void RemoteSession::sendOrders() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ending_ || (link_ && !orders_.empty()); });
        if (ending_) return;
        Order next = std::move(orders_.front());
        orders_.pop_front();
        const std::shared_ptr<Connection> with = link_;
        lock.unlock();
        v1::OrderReply reply;
        const std::string why = with->order(next, reply);
        lock.lock();
        if (!why.empty() && with == link_ && with->open()) refusal_ = printable(why, kLongestSentence);
    }
}

// ---- scenes ----

bool RemoteSession::isNew() const {
    return known_.revision == 0 || newestRevision_ > known_.revision || (wanted_ && wanted_ != done_);
}

void RemoteSession::sendScenes() {
    std::shared_ptr<Connection> of;
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return ending_ || (link_ && (link_ != of || isNew())); });
        if (ending_) return;
        if (link_ != of) known_.revision = 0; // perhaps another server, surely another scene
        of = link_;
        const std::shared_ptr<Connection> with = link_;
        const std::shared_ptr<const World> world = wanted_;
        const bool stale = known_.revision == 0 || newestRevision_ > known_.revision;
        lock.unlock();
        if (stale && !fetch(*with)) {
            lock.lock();
            changed_.wait_for(lock, kRetry, [this] { return ending_; });
            continue;
        }
        if (!stale && world) send(*with, world);
        lock.lock();
    }
}

bool RemoteSession::fetch(Connection& with) {
    std::string bytes;
    std::uint64_t revision = 0;
    std::string why = with.fetch(bytes, revision);
    Scene there;
    if (why.empty()) try {
            ByteIn in(bytes, "the server's scene", 0, "use the same version of Tactum on both sides");
            there = readScene(in, {[this] { return known_.parts; }});
        } catch (const ByteFault& wrong) {
            why = wrong.error.text;
        }
    const std::lock_guard lock(mutex_);
    if (!why.empty()) {
        if (with.open()) refusal_ = printable(why, kLongestSentence);
        return false;
    }
    meet(std::move(there), revision);
    return true;
}

/// The server has another scene than was thought. Over a connection that was broken what is published goes on
/// where nobody has touched the server's meanwhile; else the server's goes before it.
void RemoteSession::meet(Scene there, std::uint64_t revision) {
    using Arrival = SharedScene::Arrival;
    const bool first = known_.revision == 0, mine = wanted_ && !wanted_->scene->objects.empty();
    const bool untouched = known_.ever && isSame(there, known_.scene);
    const bool empty = there.objects.empty();
    known_ = {revision, true, std::move(there), {}};
    known_.parts = KnownParts(known_.scene);
    newestRevision_ = std::max(newestRevision_, revision);
    if (first && (empty || (mine && untouched))) return;
    arrived_ = {!first ? Arrival::Changed : mine ? Arrival::Another : Arrival::Begun, known_.scene};
    done_ = wanted_; // it is not what is to be felt any more
}

std::string RemoteSession::apply(Connection& with, const Scene& of, v1::Applied& applied) const {
    const std::string bytes = bytesOf(withoutKept(of), known_.parts);
    v1::Transaction transaction;
    transaction.set_base(known_.revision);
    if (bytes.size() <= kLongestEdit) {
        transaction.add_edit()->set_scene(bytes);
        return with.apply(transaction, applied);
    }
    v1::UploadHead head;
    head.set_scene(true);
    std::uint64_t number = 0;
    if (const std::string why = with.upload(head, bytes, number); !why.empty()) return why;
    transaction.add_edit()->mutable_open()->set_upload(number);
    return with.apply(transaction, applied);
}

void RemoteSession::send(Connection& with, const std::shared_ptr<const World>& world) {
    const Scene& mine = *world->scene;
    v1::Applied applied;
    applied.set_revision(known_.revision);
    std::string why;
    if (!(mine == known_.scene)) why = apply(with, mine, applied);
    if (why.empty()) {
        known_.parts = KnownParts(mine, known_.parts);
        known_.scene = mine;
        known_.revision = applied.revision();
    }
    std::unique_lock lock(mutex_);
    if (!with.open()) return;
    if (newestRevision_ > std::max<std::uint64_t>(known_.revision, applied.revision()))
        return; // another one was quicker
    // Its own pen may be still that of a connection before, which the server has not given up yet.
    const bool others = !standing_.pen && !standing_.holder.empty() && standing_.holder != settings_.name;
    if (!why.empty() && !others && refusals_++ < kTries) {
        changed_.wait_for(lock, kRetry, [this] { return ending_; });
        return;
    }
    refusals_ = 0;
    done_ = world;
    if (why.empty()) return feel(known_.revision, world);
    refusal_ = printable(why, kLongestSentence);
    if (wanted_ == world) arrived_ = {SharedScene::Arrival::Refused, known_.scene};
}

void RemoteSession::feel(std::uint64_t revision, std::shared_ptr<const World> world) {
    if (!felt_.empty() && felt_.back().revision == revision) felt_.pop_back();
    felt_.push_back({revision, std::move(world)});
    if (felt_.size() > kMostFelt) felt_.pop_front();
}

} // namespace tactum
