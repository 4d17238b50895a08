#include "core/protocol/remote_engine.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "core/base/text.h"
#include "core/protocol/connection.h"
#include "core/recording/recording_file.h"
#include "core/runtime/engine_report.h"
#include "core/scene/scene_bytes.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using Order = v1::OrderRequest;

constexpr auto kHandTick = std::chrono::milliseconds(2), kRetry = std::chrono::milliseconds(500);
constexpr double kAnswer = 1;                 ///< s, that a try waits
constexpr std::size_t kMostTrace = 8192;      ///< as many as wait in an engine's own queue
constexpr std::size_t kMostFelt = 256;        ///< Worlds on their way
constexpr std::size_t kLongestEdit = 3 << 20; ///< bytes; a longer scene is uploaded

/// What was set, which is told until the server had time to tell it.
template <class T> class Wish {
public:
    void set(const T& value) { value_ = value, until_ = Clock::now() + std::chrono::seconds(1); }
    void forget() { until_ = {}; }
    T over(const T& told) const { return Clock::now() < until_ ? value_ : told; }

private:
    T value_{};
    Clock::time_point until_{};
};

v1::Workspace written(const Workspace& workspace) {
    v1::Workspace to;
    to.set_scale(workspace.scale);
    for (const auto axis : workspace.axes)
        to.add_axis(axis);
    to.mutable_offset()->set_x(workspace.offset.x());
    to.mutable_offset()->set_y(workspace.offset.y());
    to.mutable_offset()->set_z(workspace.offset.z());
    to.set_clutch(workspace.clutch);
    to.set_bump(workspace.bump);
    to.set_centring(workspace.centring);
    return to;
}

bool isSame(const HandGoal& a, const HandGoal& b) {
    return a.position == b.position && a.teleport == b.teleport && a.sequence == b.sequence &&
           a.held == b.held;
}

v1::Word wordOf(const HandGoal& goal) {
    v1::Word word;
    v1::HandGoal& to = *word.mutable_hand();
    to.mutable_position()->set_x(goal.position.x());
    to.mutable_position()->set_y(goal.position.y());
    to.mutable_position()->set_z(goal.position.z());
    to.set_jumps(goal.teleport);
    to.set_number(goal.sequence);
    to.set_held(goal.held);
    return word;
}

/// What a server's contacts name, as far as this World has it.
void keepKnown(HapticOutput& output, const World* world) {
    int kept = 0;
    for (int i = 0; i < output.contacts; ++i) {
        const ContactReport contact = output.contact[std::size_t(i)];
        if (!world || contact.body >= world->bodies.size() ||
            contact.surface >= world->bodies[contact.body].materials.size())
            continue;
        output.contact[std::size_t(kept++)] = contact;
    }
    output.contacts = kept;
}

} // namespace

struct RemoteEngine::Impl {
    Impl(RemoteSettings s, std::shared_ptr<HandTarget> h) : settings(std::move(s)), hand(std::move(h)) {}

    struct Felt {
        std::uint64_t revision = 0; ///< the server's
        std::shared_ptr<const World> world;
    };
    /// The scene of the server as it is known here.
    struct Known {
        std::uint64_t revision = 0; ///< 0: not known
        Scene scene;
        KnownParts parts;
    };

    RemoteSettings settings;
    std::shared_ptr<HandTarget> hand;

    mutable std::mutex mutex; ///< of all below, up to `shown`
    std::condition_variable changed;
    std::shared_ptr<Connection> link; ///< null: not connected
    std::uint64_t connection = 0;     ///< its number: what an older one is still heard to say is nothing
    std::string fault = "no connection was made yet";
    bool ending = false;
    std::deque<Order> orders;
    std::map<int, Order> settled;              ///< what a new connection is told again, by its kind
    std::shared_ptr<const World> wanted, done; ///< published; sent, or refused
    std::uint64_t newestRevision = 0;          ///< of the server's scene, as far as it was told
    std::deque<Felt> felt;
    std::optional<EngineReport> told;
    std::uint64_t feltRevision = 0;
    std::deque<TracePoint> trace;
    bool pen = false;
    std::string penHolder;
    std::size_t attending = 0;
    std::optional<Scene> scene;
    std::optional<std::string> refusal, askedBy;

    // Of the caller's thread.
    EngineReport shown;
    Wish<bool> armed, deadMan, overrides;
    Wish<double> pace;
    Wish<Workspace> workspace;
    Workspace shownWorkspace;

    Known known; ///< of the thread that sends
    std::thread keeper, orderer, sender;

    void keep();
    void connect();
    void lose(const std::string& why);
    void hear(std::uint64_t from, const v1::News& news);
    void hear(std::uint64_t from, const v1::State& state);
    void order(Order order, bool settles = false);
    void sendOrders();
    void sendScenes();
    bool fetch(Connection& with);
    bool isNew() const;
    void send(Connection& with, const std::shared_ptr<const World>& world);
    std::string apply(Connection& with, const Scene& of, v1::Applied& applied) const;
    void feel(std::uint64_t revision, std::shared_ptr<const World> world);
    void end();
};

// ---- the connection ----

/// Makes it, and makes it again; meanwhile leads the hand.
void RemoteEngine::Impl::keep() {
    HandGoal sent;
    std::unique_lock lock(mutex);
    while (!ending) {
        const std::shared_ptr<Connection> now = link;
        lock.unlock();
        if (!now) {
            connect();
        } else if (!now->open()) {
            now->leave();
            lose(now->fault());
        } else if (hand) {
            const HandGoal goal = hand->read();
            if (!isSame(goal, sent)) now->say(wordOf(goal));
            sent = goal;
        }
        lock.lock();
        changed.wait_for(lock, link ? std::chrono::milliseconds(kHandTick) : kRetry,
                         [this] { return ending; });
    }
}

void RemoteEngine::Impl::connect() {
    std::uint64_t mine = 0;
    {
        const std::lock_guard lock(mutex);
        mine = ++connection;
    }
    auto made = std::make_shared<Connection>(
        settings.target, settings.name,
        ConnectionOptions{settings.certificate, settings.token, settings.stateRate, kAnswer, true,
                          [this, mine](const v1::News& news) { hear(mine, news); }});
    const std::lock_guard lock(mutex);
    if (!made->open()) {
        fault = made->fault();
        return;
    }
    link = std::move(made);
    fault.clear();
    done = nullptr; // of whatever server was there before
    orders.clear();
    for (const auto& [kind, each] : settled)
        orders.push_back(each);
    changed.notify_all();
}

void RemoteEngine::Impl::lose(const std::string& why) {
    std::shared_ptr<Connection> gone; // dies after the lock: its thread may be about to be heard
    const std::lock_guard lock(mutex);
    gone = std::move(link);
    link = nullptr;
    ++connection;
    fault = why.empty() ? "it is not heard any more" : why;
    told.reset();
    felt.clear();
    pen = false;
    penHolder.clear();
    attending = 0;
    changed.notify_all();
}

void RemoteEngine::Impl::hear(std::uint64_t from, const v1::News& news) {
    if (news.has_state()) return hear(from, news.state());
    const std::lock_guard lock(mutex);
    if (from != connection) return;
    if (news.has_welcome()) newestRevision = news.welcome().revision();
    if (news.event().kind() == v1::Event::SCENE)
        newestRevision = std::max<std::uint64_t>(newestRevision, news.event().revision());
    if (news.event().kind() == v1::Event::PEN_ASKED) askedBy = printable(news.event().text(), kLongestName);
    changed.notify_all();
}

void RemoteEngine::Impl::hear(std::uint64_t from, const v1::State& state) {
    auto report = readReport(state.telemetry());
    const std::lock_guard lock(mutex);
    if (from != connection) return;
    if (!report) {
        refusal = report.error().text;
        return;
    }
    trace.insert(trace.end(), report->trace.begin(), report->trace.end());
    if (trace.size() > kMostTrace) trace.erase(trace.begin(), trace.end() - kMostTrace);
    report->trace.clear();
    told = std::move(*report);
    feltRevision = state.revision();
    if (state.pen() && !pen) done = nullptr; // what was refused without it is tried again
    pen = state.pen();
    penHolder = printable(state.pen_holder(), kLongestName);
    attending = state.attending();
    changed.notify_all();
}

void RemoteEngine::Impl::end() {
    std::shared_ptr<Connection> gone;
    {
        const std::lock_guard lock(mutex);
        ending = true;
        ++connection;
        gone = std::move(link);
        link = nullptr;
    }
    changed.notify_all();
    if (gone) gone->leave();
    for (std::thread* thread : {&keeper, &orderer, &sender})
        if (thread->joinable()) thread->join();
    const std::lock_guard lock(mutex);
    ending = false;
    told.reset();
}

// ---- orders ----

/// `settles`: stays so until another one of its kind.
void RemoteEngine::Impl::order(Order order, bool settles) {
    const std::lock_guard lock(mutex);
    if (settles) settled[order.what_case()] = order;
    if (link) orders.push_back(std::move(order));
    changed.notify_all();
}

void RemoteEngine::Impl::sendOrders() {
    std::unique_lock lock(mutex);
    while (true) {
        changed.wait(lock, [this] { return ending || (link && !orders.empty()); });
        if (ending) return;
        Order next = std::move(orders.front());
        orders.pop_front();
        const std::shared_ptr<Connection> with = link;
        lock.unlock();
        v1::OrderReply reply;
        const std::string why = with->order(next, reply);
        lock.lock();
        if (!why.empty() && with == link && with->open()) refusal = why;
    }
}

// ---- scenes ----

bool RemoteEngine::Impl::isNew() const {
    return known.revision == 0 || newestRevision > known.revision || (wanted && wanted != done);
}

void RemoteEngine::Impl::sendScenes() {
    std::shared_ptr<Connection> of;
    std::unique_lock lock(mutex);
    while (true) {
        changed.wait(lock, [&] { return ending || (link && (link != of || isNew())); });
        if (ending) return;
        if (link != of) known.revision = 0; // perhaps another server, surely another scene
        of = link;
        const std::shared_ptr<Connection> with = link;
        const std::shared_ptr<const World> world = wanted;
        const bool stale = known.revision == 0 || newestRevision > known.revision;
        lock.unlock();
        if (stale ? !fetch(*with) : false) {
            lock.lock();
            changed.wait_for(lock, kRetry, [this] { return ending; });
            continue;
        }
        if (!stale && world) send(*with, world);
        lock.lock();
    }
}

/// What is there: the person's own scene goes before it when there is one at the beginning, and not when
/// somebody else has made another one since.
bool RemoteEngine::Impl::fetch(Connection& with) {
    std::string bytes;
    std::uint64_t revision = 0;
    std::string why = with.fetch(bytes, revision);
    Scene there;
    if (why.empty()) try {
            ByteIn in(bytes, "the server's scene", 0, "use the same version of Tactum on both sides");
            there = readScene(in, {[this] { return known.parts; }});
        } catch (const ByteFault& wrong) {
            why = wrong.error.text;
        }
    const std::lock_guard lock(mutex);
    if (!why.empty()) {
        if (with.open()) refusal = why;
        return false;
    }
    const bool first = known.revision == 0;
    const bool mine = wanted && !wanted->scene->objects.empty();
    known = {revision, std::move(there), {}};
    known.parts = KnownParts(known.scene);
    newestRevision = std::max(newestRevision, revision);
    if (first && mine) return true;
    if (first && known.scene.objects.empty()) return true;
    scene = known.scene;
    done = wanted; // it is not what is to be felt any more
    return true;
}

std::string RemoteEngine::Impl::apply(Connection& with, const Scene& of, v1::Applied& applied) const {
    const std::string bytes = bytesOf(withoutKept(of), known.parts);
    v1::Transaction transaction;
    transaction.set_base(known.revision);
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

void RemoteEngine::Impl::send(Connection& with, const std::shared_ptr<const World>& world) {
    const Scene& mine = *world->scene;
    v1::Applied applied;
    applied.set_revision(known.revision);
    std::string why;
    if (!(mine == known.scene)) why = apply(with, mine, applied);
    if (why.empty()) {
        known.parts = KnownParts(mine, known.parts);
        known.scene = mine;
        known.revision = applied.revision();
    }
    const std::lock_guard lock(mutex);
    if (!with.open()) return;
    if (newestRevision > std::max<std::uint64_t>(known.revision, applied.revision()))
        return; // another one was quicker
    done = world;
    if (why.empty())
        feel(known.revision, world);
    else
        refusal = why;
}

void RemoteEngine::Impl::feel(std::uint64_t revision, std::shared_ptr<const World> world) {
    if (!felt.empty() && felt.back().revision == revision) felt.pop_back();
    felt.push_back({revision, std::move(world)});
    if (felt.size() > kMostFelt) felt.pop_front();
}

// ---- the engine ----

RemoteEngine::RemoteEngine(RemoteSettings settings, std::shared_ptr<HandTarget> hand)
    : impl_(std::make_unique<Impl>(std::move(settings), std::move(hand))) {}

RemoteEngine::~RemoteEngine() {
    impl_->end();
}

Result<void> RemoteEngine::start() {
    if (!impl_->keeper.joinable()) {
        impl_->keeper = std::thread([this] { impl_->keep(); });
        impl_->orderer = std::thread([this] { impl_->sendOrders(); });
        impl_->sender = std::thread([this] { impl_->sendScenes(); });
    }
    {
        std::unique_lock lock(impl_->mutex);
        impl_->changed.wait_for(lock, std::chrono::duration<double>(impl_->settings.patience),
                                [this] { return impl_->told.has_value(); });
    }
    poll();
    return running() ? Result<void>() : machineError(trouble());
}

Result<void> RemoteEngine::stop() {
    impl_->end();
    poll();
    return {};
}

bool RemoteEngine::running() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->link && impl_->told && impl_->link->open();
}

Result<void> RemoteEngine::setDevice(std::unique_ptr<HapticDevice>) {
    return inputError("the device is the haptic server's: choose it there, with tactum serve --device");
}

std::string RemoteEngine::trouble() const {
    if (running()) return impl_->shown.trouble;
    const std::lock_guard lock(impl_->mutex);
    return "The haptic server at " + impl_->settings.target + " does not answer (" +
           printable(impl_->fault, kLongestName) +
           "). It is tried again: see whether tactum serve runs there.";
}
std::string RemoteEngine::caution() const {
    return impl_->shown.caution;
}

Result<void> RemoteEngine::setWorkspace(const Workspace& workspace) {
    if (Result<void> possible = checkWorkspace(workspace); !possible) return possible;
    impl_->workspace.set(workspace);
    impl_->shownWorkspace = workspace;
    Order order;
    *order.mutable_workspace() = written(workspace);
    impl_->order(std::move(order), true);
    return {};
}
const Workspace& RemoteEngine::workspace() const {
    return impl_->shownWorkspace;
}

void RemoteEngine::publish(std::shared_ptr<const World> world) {
    if (!world) return;
    const std::lock_guard lock(impl_->mutex);
    impl_->wanted = std::move(world);
    impl_->changed.notify_all();
}
std::uint64_t RemoteEngine::publishedAfter() const {
    return impl_->shown.publishedAfter;
}

void RemoteEngine::setArmed(bool armed) {
    impl_->armed.set(armed);
    Order order;
    if (armed)
        order.set_arm(true);
    else
        order.mutable_stop(); // which needs no pen
    impl_->order(std::move(order));
}
void RemoteEngine::fade() {
    impl_->armed.set(false);
    Order order;
    order.mutable_fade();
    impl_->order(std::move(order));
}
bool RemoteEngine::armed() const {
    return running() && impl_->armed.over(impl_->shown.armed);
}

void RemoteEngine::setDeadMan(bool on) {
    impl_->deadMan.set(on);
    Order order;
    order.set_dead_man(on);
    impl_->order(std::move(order), true);
}
bool RemoteEngine::deadMan() const {
    return impl_->deadMan.over(impl_->shown.deadMan);
}

void RemoteEngine::setOverrideCeiling(bool on) {
    impl_->overrides.set(on);
    Order order;
    order.set_override_ceiling(on);
    impl_->order(std::move(order));
}
bool RemoteEngine::overridesCeiling() const {
    return impl_->overrides.over(impl_->shown.overridesCeiling);
}

void RemoteEngine::push(const Vec3& force) {
    std::shared_ptr<Connection> with;
    {
        const std::lock_guard lock(impl_->mutex);
        with = impl_->link;
    }
    if (!with) return;
    v1::Word word;
    v1::Vector& to = *word.mutable_push()->mutable_force();
    to.set_x(force.x()), to.set_y(force.y()), to.set_z(force.z());
    with->say(word);
}

void RemoteEngine::setGrasped(bool on) {
    Order order;
    order.set_grasped(on);
    impl_->order(std::move(order), true);
}
void RemoteEngine::restartProxy() {
    Order order;
    order.mutable_restart();
    impl_->order(std::move(order));
}
void RemoteEngine::setPace(double pace) {
    impl_->pace.set(pace);
    Order order;
    order.set_pace(pace);
    impl_->order(std::move(order), true);
}
double RemoteEngine::pace() const {
    return impl_->pace.over(impl_->shown.pace);
}
void RemoteEngine::beginBodies() {
    Order order;
    order.mutable_begin();
    impl_->order(std::move(order));
}
void RemoteEngine::stepBodies() {
    Order order;
    order.mutable_step();
    impl_->order(std::move(order));
}

void RemoteEngine::poll() {
    std::shared_ptr<const World> world;
    {
        const std::lock_guard lock(impl_->mutex);
        const bool known = impl_->told && impl_->link && impl_->link->open();
        if (known) {
            impl_->shown = *impl_->told;
        } else { // nobody knows what is felt: nothing is shown to be
            ServoTelemetry& servo = impl_->shown.servo;
            servo.gain = servo.rate = impl_->shown.proxy.rate = 0;
            servo.force = Vec3::Zero();
            servo.inhibit = InhibitReason::NotArmed;
            impl_->shown.proxy.output.contacts = 0;
            impl_->shown.proxy.output.force = Vec3::Zero();
            impl_->shown.running = impl_->shown.armed = impl_->shown.standsStill = false;
        }
        std::deque<Impl::Felt>& felt = impl_->felt;
        const auto found = std::ranges::find(felt, impl_->feltRevision, &Impl::Felt::revision);
        if (known && found != felt.end()) {
            world = found->world;
            felt.erase(felt.begin(), found);
        }
    }
    ProxyTelemetry& proxy = impl_->shown.proxy;
    proxy.worldRevision = world ? world->revision : 0;
    proxy.bodies.of = world && world->moving ? world->moving->key() : 0;
    keepKnown(proxy.output, world.get());
    impl_->shownWorkspace = impl_->workspace.over(impl_->shown.workspace);
}

const ProxyTelemetry& RemoteEngine::proxy() const {
    return impl_->shown.proxy;
}
const ServoTelemetry& RemoteEngine::servo() const {
    return impl_->shown.servo;
}
bool RemoteEngine::servoStandsStill() const {
    return impl_->shown.standsStill;
}
bool RemoteEngine::popTrace(TracePoint& point) {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->trace.empty()) return false;
    point = impl_->trace.front();
    impl_->trace.pop_front();
    return true;
}

RecordedRun RemoteEngine::recorded() const {
    std::shared_ptr<Connection> with;
    {
        const std::lock_guard lock(impl_->mutex);
        with = impl_->link;
    }
    std::string bytes;
    if (!with || !with->record(bytes).empty()) return {};
    auto recording = parseRecording(bytes, "recording of the server");
    return recording ? std::move(recording->run) : RecordedRun{};
}

const DeviceInfo& RemoteEngine::device() const {
    return impl_->shown.device;
}
bool RemoteEngine::hasRealtimePriority() const {
    return impl_->shown.realtime;
}
const std::string& RemoteEngine::priorityNote() const {
    return impl_->shown.priorityNote;
}

// ---- the scene that others see ----

std::string RemoteEngine::place() const {
    return impl_->settings.target;
}
std::optional<Scene> RemoteEngine::arrived() {
    const std::lock_guard lock(impl_->mutex);
    return std::exchange(impl_->scene, {});
}
std::optional<std::string> RemoteEngine::refused() {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->refusal) impl_->armed.forget();
    return std::exchange(impl_->refusal, {});
}
bool RemoteEngine::holdsPen() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->pen;
}
std::string RemoteEngine::penHolder() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->penHolder;
}
void RemoteEngine::askForPen() {
    Order order;
    order.mutable_ask();
    impl_->order(std::move(order));
}
std::optional<std::string> RemoteEngine::penAskedBy() {
    const std::lock_guard lock(impl_->mutex);
    return std::exchange(impl_->askedBy, {});
}
void RemoteEngine::givePen(const std::string& to) {
    Order order;
    order.mutable_give()->set_to(to);
    impl_->order(std::move(order));
}
std::size_t RemoteEngine::attending() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->attending;
}

} // namespace tactum
