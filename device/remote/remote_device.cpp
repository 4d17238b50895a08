#include "device/remote/remote_device.h"

#include <mutex>
#include <utility>

#include "core/base/text.h"
#include "device/remote/server_process.h"

namespace tactum {
namespace {

using wire::Kind;
using wire::News;
using wire::Packet;

constexpr int kMoment = 20;     ///< ms between two looks at whether the person gives up
constexpr int kAnswer = 30'000; ///< ms, for what a person is not needed for
constexpr int kOpening = 5000;  ///< ms, of what is prepared
constexpr int kClosing = 2000;  ///< ms
constexpr int kGivingUp = 5000; ///< ms, after a person did
constexpr double kSilent = 0.1; ///< s without a tick
constexpr std::size_t kLongestSentence = 500;

std::atomic<int> remoteDevices{0};

class RemoteDevice final : public HapticDevice {
public:
    RemoteDevice(const std::filesystem::path& program, const std::vector<std::string>& arguments)
        : process_(program, arguments) {
        ++remoteDevices;
    }
    ~RemoteDevice() override {
        close();
        --remoteDevices;
    }

    /// Starts the process and takes in what it says of the device.
    Result<void> start() {
        if (Result<void> started = process_.start(); !started) return started;
        Result<void> introduced = listen(kAnswer);
        introduced_ = introduced_ || introduced.has_value();
        return introduced;
    }

    DeviceInfo info() const override {
        const std::lock_guard lock(infoMutex_);
        return info_;
    }
    std::vector<std::string> steps() const override { return steps_; }
    Result<void> prepare(Opening& opening) override;
    Result<void> open() override;
    void close() override;
    std::string trouble() const override;
    std::string caution() const override;
    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        const std::int64_t now = monotonicNanoseconds();
        DeviceMailbox& mailbox = process_.block()->mailbox;
        mailbox.command(command.force, now, command.handle);
        return mailbox.newest(now);
    }
    bool awaitFrame(std::int64_t until) noexcept override {
        process_.block()->mailbox.awaitReading(until);
        return true;
    }
    void announce(const DeviceCommand& command) noexcept override {
        process_.block()->mailbox.answer(command.force, monotonicNanoseconds(), command.handle);
    }
    HandleReading handle() noexcept override { return process_.block()->mailbox.handle(); }
    void emergencyStop() noexcept override { process_.block()->mailbox.stop(monotonicNanoseconds()); }

private:
    Result<void> needProcess();
    Result<void> openPrepared(int patience);
    Result<void> ask(Kind kind, int patience);
    Result<void> listen(int patience, Opening* opening = nullptr);
    tl::unexpected<Error> lost();
    void take(const Packet& packet, Opening* opening);

    ServerProcess process_;
    std::vector<std::string> steps_;
    bool introduced_ = false; ///< the steps are complete: they are the same at every start
    mutable std::mutex infoMutex_, troubleMutex_;
    DeviceInfo info_;
    std::atomic<bool> open_{false};
};

Result<void> RemoteDevice::needProcess() {
    return process_.runs() ? Result<void>() : start();
}

Result<void> RemoteDevice::prepare(Opening& opening) {
    if (Result<void> runs = needProcess(); !runs) return runs;
    const bool nobody = opening.cancelled();
    if (!process_.send({.kind = Kind::Prepare, .value = double(nobody)})) return lost();
    Result<void> prepared = listen(nobody ? kAnswer : 0, &opening);
    // Here and not later, when the window would wait for a driver that hangs.
    return prepared && !open_ ? openPrepared(kOpening) : prepared;
}

Result<void> RemoteDevice::open() {
    if (open_ && process_.runs()) return {};
    if (Result<void> runs = needProcess(); !runs) return runs;
    return openPrepared(kAnswer);
}

Result<void> RemoteDevice::openPrepared(int patience) {
    emergencyStop(); // what an earlier use left in the mailbox
    Result<void> opened = ask(Kind::Open, patience);
    open_ = opened.has_value();
    return opened;
}

void RemoteDevice::close() {
    if (!open_.exchange(false)) return;
    emergencyStop();
    if (process_.runs()) ask(Kind::Close, kClosing);
}

Result<void> RemoteDevice::ask(Kind kind, int patience) {
    if (!process_.send({.kind = kind})) return lost();
    return listen(patience);
}

tl::unexpected<Error> RemoteDevice::lost() {
    process_.kill();
    return machineError(process_.howItEnded());
}

/// Until Done. `patience` in ms, 0: as long as the person does not give up.
Result<void> RemoteDevice::listen(int patience, Opening* opening) {
    Packet packet;
    for (int waited = 0;;) {
        switch (process_.receive(kMoment, packet)) {
        case News::Gone:
            return lost();
        case News::None:
            waited += kMoment;
            break;
        case News::Packet:
            if (packet.kind == Kind::Done) return wire::resultOf(packet);
            take(packet, opening);
        }
        if (patience == 0 && opening->cancelled()) {
            process_.send({.kind = Kind::Cancel});
            patience = waited + kGivingUp;
        }
        if (patience > 0 && waited >= patience) {
            process_.kill();
            return machineError(
                "The driver of the device did not answer and was ended: open the device again.");
        }
    }
}

void RemoteDevice::take(const Packet& packet, Opening* opening) {
    if (packet.kind == Kind::Info) {
        const std::lock_guard lock(infoMutex_);
        info_ = wire::infoOf(packet);
    }
    if (packet.kind == Kind::Step && !introduced_) steps_.push_back(wire::stringOf(packet.text));
    if (!opening) return;
    if (packet.kind == Kind::Begin) opening->begin(wire::stringOf(packet.text), wire::stringOf(packet.more));
    if (packet.kind == Kind::Progress) opening->progress(packet.value);
}

std::string RemoteDevice::trouble() const {
    if (!process_.runs()) return process_.howItEnded();
    const std::lock_guard lock(troubleMutex_);
    wire::Block& block = *process_.block();
    if (open_ && 1e-9 * double(monotonicNanoseconds() - block.lastTick) > kSilent)
        return "The driver of the device stands still, and its force was taken away: open the device again.";
    return printable(wire::stringOf(block.trouble.read()), kLongestSentence);
}

std::string RemoteDevice::caution() const {
    if (!process_.runs()) return {};
    const std::lock_guard lock(troubleMutex_);
    return printable(wire::stringOf(process_.block()->caution.read()), kLongestSentence);
}

} // namespace

int countRemoteDevices() {
    return remoteDevices;
}

Result<std::unique_ptr<HapticDevice>> makeRemoteDevice(const std::filesystem::path& program,
                                                       const std::vector<std::string>& arguments) {
    auto device = std::make_unique<RemoteDevice>(program, arguments);
    if (Result<void> started = device->start(); !started) return tl::unexpected(started.error());
    return device;
}

} // namespace tactum
