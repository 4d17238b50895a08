#include "device/remote/serve_device.h"

#include <array>
#include <atomic>
#include <csignal>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/loop/device_watchdog.h"
#include "core/loop/metronome.h"
#include "core/loop/realtime_thread.h"
#include "core/port/device_check.h"
#include "core/port/force_limiter.h"
#include "core/port/handle_limit.h"
#include "device/remote/wire.h"

namespace tactum {

const int kServeDescriptor = wire::kTalk;

namespace {

using wire::Kind;
using wire::News;
using wire::Packet;

constexpr int kServerMoment = 20;   ///< ms between two looks at the device's trouble
constexpr int kFarewells = 3;       ///< exchanges with zero, the last acts
constexpr double kAnswerPart = 0.6; ///< of a period, for the answer to a frame
constexpr std::size_t kSignalStack = 64 * 1024;

/// Whom the handler of a crash stops.
std::atomic<HapticDevice*> crashing{nullptr};

void onCrash(int signal) {
    if (HapticDevice* device = crashing) device->emergencyStop();
    std::signal(signal, SIG_DFL);
    raise(signal);
}

void watchForCrashes(HapticDevice& device) {
    crashing = &device;
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK | SA_NODEFER | int(SA_RESETHAND);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
        sigaction(signal, &action, nullptr);
    // What ends the program ends this one in order, by the socket.
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGPIPE})
        std::signal(signal, SIG_IGN);
}

/// For this thread: a crash by a stack that overflows is handled on another.
void standOnTwoStacks(std::array<char, kSignalStack>& second) {
    const stack_t stack{.ss_sp = second.data(), .ss_flags = 0, .ss_size = second.size()};
    sigaltstack(&stack, nullptr);
}

class Server final : public Opening {
public:
    Server(HapticDevice& device, wire::Block& block, int talk)
        : device_(device), block_(block), talk_(talk),
          program_(int(syscall(SYS_pidfd_open, block.program, 0))) {}
    ~Server() override {
        endLoop();
        device_.close();
        if (program_ >= 0) ::close(program_);
    }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    void serve();

    // What a device that is made ready says to the person.
    void begin(std::string_view step, std::string_view request) override {
        wire::send(talk_, {.kind = Kind::Begin, .text = wire::textOf(step), .more = wire::textOf(request)});
    }
    void progress(double part) override { wire::send(talk_, {.kind = Kind::Progress, .value = part}); }
    bool cancelled() const override;

private:
    void introduce();
    void answer(const Packet& request);
    Result<void> prepare(const Packet& request);
    Result<void> open();
    Result<void> startLoop();
    void handOn(ForceLimiter& limiter, const DeviceInfo& info, std::int64_t until) noexcept;
    DeviceCommand commandNow(ForceLimiter& limiter, const DeviceInfo& info) noexcept;
    void loop() noexcept;
    void endLoop();
    static void tell(TripleBuffer<wire::Text>& where, std::string& told, std::string now);
    bool programDied() const;

    HapticDevice& device_;
    wire::Block& block_;
    int talk_, program_; ///< descriptors; the second tells of the program's death, whoever holds its sockets
    mutable bool cancelled_ = false;
    DeviceWatchdog watchdog_;
    RealtimeThread thread_;
    std::atomic<bool> stop_{false};
    bool runs_ = false;
    std::string trouble_, caution_; ///< as they were told
};

// The loop: no step of it waits for anything but its clock, its device and, for so long, the servo's answer.

/// A device that makes its frames itself takes the answer to this one with the next, if it is there by then.
void Server::handOn(ForceLimiter& limiter, const DeviceInfo& info, std::int64_t until) noexcept {
    block_.mailbox.awaitAnswer(until);
    device_.announce(commandNow(limiter, info));
}

DeviceCommand Server::commandNow(ForceLimiter& limiter, const DeviceInfo& info) noexcept {
    const std::int64_t now = monotonicNanoseconds();
    return {limiter(block_.mailbox.force(now)), heldTo(info, block_.mailbox.handleForce(now))};
}

void Server::loop() noexcept {
    static std::array<char, kSignalStack> second;
    standOnTwoStacks(second);
    const DeviceInfo info = device_.info();
    ForceLimiter limiter{.maxForce = info.maxForce};
    Metronome metronome(info.rate);
    const auto patience = std::int64_t(kAnswerPart * 1e9 * metronome.period());
    while (!stop_.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait(device_);
        const DeviceSample sample = device_.exchange(commandNow(limiter, info), tick.elapsed);
        watchdog_.beat();
        const std::int64_t now = monotonicNanoseconds();
        block_.mailbox.measured(sample, tick.framed && sample.at ? sample.at : now, device_.handle());
        block_.lastTick.store(now, std::memory_order_relaxed);
        if (tick.framed) handOn(limiter, info, now + patience);
    }
    watchdog_.rest();
    for (int i = 0; i < kFarewells; ++i)
        device_.exchange({}, metronome.period());
}

Result<void> Server::startLoop() {
    lockPresentMemory();
    stop_ = false;
    block_.lastTick = monotonicNanoseconds();
    // Before the thread: the device watchdog is a fork, which has only the thread that forks.
    if (Result<void> watched = watchdog_.start(device_); !watched) return watched;
    return thread_.start("tactum-device", kServoPriority, [this] { loop(); });
}

void Server::endLoop() {
    if (!runs_) return;
    stop_ = true;
    thread_.join();
    watchdog_.stop();
    runs_ = false;
}

Result<void> Server::open() {
    endLoop();
    if (Result<void> opened = device_.open(); !opened) return opened;
    Result<void> started = checkDevice(device_.info()).and_then([this] { return startLoop(); });
    runs_ = started.has_value();
    if (!started) {
        watchdog_.stop();
        device_.close();
    }
    return started;
}

Result<void> Server::prepare(const Packet& request) {
    endLoop();
    cancelled_ = request.value != 0;
    return device_.prepare(*this);
}

/// While the device is made ready nobody else listens.
bool Server::cancelled() const {
    Packet packet;
    const News news = cancelled_ ? News::None : wire::receive(talk_, 0, packet);
    cancelled_ = cancelled_ || news == News::Gone || programDied() ||
                 (news == News::Packet && packet.kind == Kind::Cancel);
    return cancelled_;
}

void Server::introduce() {
    wire::send(talk_, wire::infoPacket(device_.info()));
    for (const std::string& step : device_.steps())
        wire::send(talk_, {.kind = Kind::Step, .text = wire::textOf(step)});
    wire::send(talk_, {.kind = Kind::Done});
}

void Server::answer(const Packet& request) {
    Result<void> result;
    if (request.kind == Kind::Cancel) return; // it came when nothing was left to give up
    if (request.kind == Kind::Prepare) result = prepare(request);
    if (request.kind == Kind::Open) result = open();
    if (request.kind == Kind::Close) {
        endLoop();
        device_.close();
    }
    wire::send(talk_, wire::infoPacket(device_.info())); // it may know more of itself now
    wire::send(talk_, wire::donePacket(result));
}

void Server::tell(TripleBuffer<wire::Text>& where, std::string& told, std::string now) {
    if (now == told) return;
    told = std::move(now);
    where.write(wire::textOf(told));
}

bool Server::programDied() const {
    pollfd death{.fd = program_, .events = POLLIN, .revents = 0};
    return program_ >= 0 && poll(&death, 1, 0) > 0;
}

void Server::serve() {
    introduce();
    std::array<pollfd, 2> lines{pollfd{.fd = talk_, .events = POLLIN, .revents = 0},
                                pollfd{.fd = program_, .events = POLLIN, .revents = 0}};
    while (true) {
        if (poll(lines.data(), lines.size(), kServerMoment) > 0) {
            if (lines[1].revents != 0) break;
            Packet packet;
            const News news = wire::receive(talk_, 0, packet);
            if (news == News::Gone) break;
            if (news == News::Packet) answer(packet);
        }
        tell(block_.trouble, trouble_, device_.trouble());
        tell(block_.caution, caution_, device_.caution());
    }
    block_.mailbox.stop(monotonicNanoseconds()); // the next tick commands zero
}

wire::Block* mapBlock(int descriptor) {
    void* memory = mmap(nullptr, sizeof(wire::Block), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) return nullptr;
    auto* block = static_cast<wire::Block*>(memory);
    return block->version == wire::kVersion ? block : nullptr;
}

} // namespace

int serveDevice(HapticDevice& device, int descriptor) {
    wire::Block* block = mapBlock(descriptor + (wire::kBlock - wire::kTalk));
    if (!block)
        return refuseToServe({Error::Kind::Machine, "The process of the device is of another version "
                                                    "than the program: install it again."},
                             descriptor);
    watchForCrashes(device);
    Server(device, *block, descriptor).serve();
    return 0;
}

int refuseToServe(const Error& error, int descriptor) {
    wire::send(descriptor, wire::donePacket(tl::unexpected(error)));
    return 1;
}

} // namespace tactum
