#include "tests/device/usb/emulated_kernel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <map>
#include <mutex>

#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/device/usb/usb_descriptors.h"

namespace tactum::test {

namespace {

constexpr int kBus = 1;
constexpr int kMaxDescriptors = 4096;
const std::string kSysfs = "/sys/bus/usb/devices/";
const std::string kNodes = "/dev/bus/usb/";

/// All that there is, for the whole program; never destroyed, because libusb's thread may outlive main().
struct State {
    std::mutex mutex;
    std::map<int, std::shared_ptr<PluggedDevice>> sockets;
    std::map<int, std::unique_ptr<UsbfsFile>> files; ///< by their descriptors
    std::vector<std::shared_ptr<kernel::UdevMonitor>> monitors;
    int lastAddress = 1; ///< 1 is the hub's
    int abandoned = 0;   ///< transfers of files that were closed without fetching them
    std::function<void()> listener = [] {};
};

State& state() {
    static State& it = []() -> State& {
        pthread_atfork([] { state().mutex.lock(); }, [] { state().mutex.unlock(); },
                       [] { state().mutex.unlock(); });
        return *new State;
    }();
    return it;
}

std::array<std::atomic<bool>, kMaxDescriptors> nodes{};
thread_local bool insideNow = false;

std::int64_t monotonic() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

std::string nameOf(const PluggedDevice& plugged) {
    return std::to_string(kBus) + "-" + std::to_string(plugged.socket);
}

std::string nodePath(const PluggedDevice& plugged) {
    char text[32];
    std::snprintf(text, sizeof text, "%03d/%03d", kBus, plugged.address);
    return kNodes + text;
}

/// 2 to 127, as the kernel gives them: not one that is in use, nor the one just used.
int freeAddress() {
    State& all = state();
    const auto taken = [&](int address) {
        return std::any_of(all.sockets.begin(), all.sockets.end(),
                           [&](const auto& one) { return one.second->address == address; });
    };
    do
        all.lastAddress = all.lastAddress >= 127 ? 2 : all.lastAddress + 1;
    while (taken(all.lastAddress));
    return all.lastAddress;
}

void announce(const char* action, const PluggedDevice& plugged) {
    for (const auto& monitor : state().monitors) {
        monitor->events.push_back({action, nameOf(plugged), nodePath(plugged)});
        const std::uint64_t one = 1;
        (void)!write(monitor->descriptor, &one, sizeof one);
    }
}

void unplugSocket(int socket) {
    State& all = state();
    const auto found = all.sockets.find(socket);
    if (found == all.sockets.end()) return;
    const std::shared_ptr<PluggedDevice> plugged = found->second;
    plugged->there = false;
    all.sockets.erase(found);
    for (const auto& [descriptor, file] : all.files)
        if (&file->plugged() == plugged.get()) file->endAll();
    announce("remove", *plugged);
}

void plugInto(int socket, std::shared_ptr<EmulatedUsbDevice> device) {
    auto plugged = std::make_shared<PluggedDevice>();
    plugged->description = device->describe();
    plugged->device = std::move(device);
    plugged->socket = socket;
    plugged->address = freeAddress();
    plugged->kernelDriver = plugged->description.interfaceClass == 3;
    state().sockets[socket] = plugged;
    announce("add", *plugged);
}

std::shared_ptr<PluggedDevice> atSocket(int socket) {
    const auto found = state().sockets.find(socket);
    return found == state().sockets.end() ? nullptr : found->second;
}

Bytes text(const std::string& line) {
    return {line.begin(), line.end()};
}

} // namespace

// ---- The bus, as a test sees it.

EmulatedBus& EmulatedBus::the() {
    static EmulatedBus bus;
    return bus;
}

void EmulatedBus::plug(int socket, std::shared_ptr<EmulatedUsbDevice> device) {
    {
        const kernel::Inside inside;
        unplugSocket(socket);
        plugInto(socket, std::move(device));
    }
    state().listener();
}

void EmulatedBus::unplug(int socket) {
    {
        const kernel::Inside inside;
        unplugSocket(socket);
    }
    state().listener();
}

void EmulatedBus::unplugAll() {
    {
        const kernel::Inside inside;
        while (!state().sockets.empty())
            unplugSocket(state().sockets.begin()->first);
    }
    state().listener();
}

void EmulatedBus::setFaults(int socket, const UsbFaults& faults) {
    const kernel::Inside inside;
    if (const auto plugged = atSocket(socket)) plugged->faults = faults;
}

void EmulatedBus::setForbidden(int socket, bool forbidden) {
    const kernel::Inside inside;
    if (const auto plugged = atSocket(socket)) plugged->forbidden = forbidden;
}

bool EmulatedBus::kernelDriverHolds(int socket) const {
    const kernel::Inside inside;
    const auto plugged = atSocket(socket);
    return plugged && plugged->kernelDriver;
}

int EmulatedBus::openDescriptors() const {
    const kernel::Inside inside;
    return static_cast<int>(state().files.size());
}

int EmulatedBus::pendingTransfers() const {
    const kernel::Inside inside;
    int pending = state().abandoned;
    for (const auto& [descriptor, file] : state().files)
        pending += file->pending();
    return pending;
}

// ---- The kernel, as libusb sees it.

namespace kernel {

Inside::Inside() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    state().mutex.lock();
    insideNow = true;
}

Inside::~Inside() {
    insideNow = false;
    state().mutex.unlock();
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool isInside() {
    return insideNow;
}

void setListener(std::function<void()> changed) {
    const Inside inside;
    state().listener = std::move(changed);
}

std::optional<int> openNode(const char* path) {
    if (std::string_view(path).substr(0, kNodes.size()) != kNodes) return std::nullopt;
    const Inside inside;
    for (const auto& [socket, plugged] : state().sockets) {
        if (nodePath(*plugged) != path) continue;
        if (plugged->forbidden) return -EACCES;
        const int descriptor = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
        if (descriptor < 0) return -errno;
        assert(descriptor < kMaxDescriptors);
        state().files[descriptor] = std::make_unique<UsbfsFile>(plugged, descriptor);
        nodes[static_cast<std::size_t>(descriptor)] = true;
        return descriptor;
    }
    return -ENOENT;
}

std::optional<Bytes> sysfsFile(const char* path) {
    const std::string whole = path;
    if (whole.substr(0, kSysfs.size()) != kSysfs) return std::nullopt;
    const Inside inside;
    for (const auto& [socket, plugged] : state().sockets) {
        const std::string folder = kSysfs + nameOf(*plugged) + "/";
        if (whole.substr(0, folder.size()) != folder) continue;
        const std::string file = whole.substr(folder.size());
        if (file == "busnum") return text(std::to_string(kBus) + "\n");
        if (file == "devnum") return text(std::to_string(plugged->address) + "\n");
        if (file == "speed") return text("12\n");
        if (file == "bConfigurationValue") return text("1\n");
        if (file == "descriptors") return descriptorBytes(plugged->description);
    }
    return Bytes{};
}

bool isNode(int descriptor) {
    return descriptor >= 0 && descriptor < kMaxDescriptors && nodes[static_cast<std::size_t>(descriptor)];
}

void closeNode(int descriptor) {
    const Inside inside;
    nodes[static_cast<std::size_t>(descriptor)] = false;
    const auto file = state().files.find(descriptor);
    state().abandoned += file->second->notFetched();
    state().files.erase(file);
}

namespace {

int waitForBulk(int descriptor, const usbdevfs_bulktransfer& transfer) {
    const std::int64_t end = monotonic() + std::int64_t{1'000'000} * transfer.timeout;
    for (;;) {
        {
            const Inside inside;
            const std::int64_t now = monotonic();
            const int result = state().files.at(descriptor)->bulk(transfer, now);
            if (result != -EAGAIN) return result;
            if (now >= end) return -ETIMEDOUT;
        }
        const timespec soon{0, 50'000};
        nanosleep(&soon, nullptr);
    }
}

/// When somebody has to look again, and who is ready: their number.
struct Look {
    int ready = 0;
    std::int64_t next = kNever;
};

Look lookAtNodes(pollfd* fds, nfds_t count) {
    const Inside inside;
    const std::int64_t now = monotonic();
    Look look;
    for (pollfd* one = fds; one != fds + count; ++one) {
        if (!isNode(one->fd)) continue;
        UsbfsFile& file = *state().files.at(one->fd);
        one->revents = static_cast<short>(file.events(now) & (one->events | POLLERR | POLLHUP));
        if (one->revents) ++look.ready;
        look.next = std::min(look.next, file.nextEvent(now));
    }
    return look;
}

/// The others, for real; of the nodes only whether something rang. At most `wait` ns.
int pollOthers(pollfd* fds, nfds_t count, std::int64_t wait) {
    constexpr nfds_t kMax = 64;
    assert(count <= kMax);
    pollfd copies[kMax];
    std::copy_n(fds, count, copies);
    for (nfds_t i = 0; i < count; ++i)
        if (isNode(fds[i].fd)) copies[i].events = POLLIN;
    const timespec most{wait / 1'000'000'000, wait % 1'000'000'000};
    if (ppoll(copies, count, wait == kNever ? nullptr : &most, nullptr) < 0) return -errno;
    int ready = 0;
    for (nfds_t i = 0; i < count; ++i) {
        if (isNode(fds[i].fd)) continue;
        fds[i].revents = copies[i].revents;
        if (fds[i].revents) ++ready;
    }
    return ready;
}

} // namespace

int controlNode(int descriptor, unsigned long request, void* argument) {
    if (request == USBDEVFS_BULK)
        return waitForBulk(descriptor, *static_cast<usbdevfs_bulktransfer*>(argument));
    const Inside inside;
    return state().files.at(descriptor)->control(request, argument, monotonic());
}

int pollNodes(pollfd* fds, nfds_t count, int timeout) {
    const std::int64_t end = timeout < 0 ? kNever : monotonic() + std::int64_t{1'000'000} * timeout;
    for (;;) {
        const Look look = lookAtNodes(fds, count);
        const std::int64_t now = monotonic();
        std::int64_t wait = std::min(end, look.next);
        if (wait != kNever) wait = std::max<std::int64_t>(wait - now, 0);
        const int others = pollOthers(fds, count, look.ready ? 0 : wait);
        if (others < 0) return others;
        if (look.ready + others > 0) return look.ready + others;
        if (monotonic() >= end) return 0;
    }
}

std::vector<std::string> deviceNames() {
    const Inside inside;
    std::vector<std::string> names;
    for (const auto& [socket, plugged] : state().sockets)
        names.push_back(nameOf(*plugged));
    return names;
}

std::string nodeOf(const std::string& name) {
    const Inside inside;
    for (const auto& [socket, plugged] : state().sockets)
        if (nameOf(*plugged) == name) return nodePath(*plugged);
    return {};
}

std::shared_ptr<UdevMonitor> openMonitor() {
    const Inside inside;
    auto monitor = std::make_shared<UdevMonitor>();
    monitor->descriptor = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC | EFD_SEMAPHORE);
    state().monitors.push_back(monitor);
    return monitor;
}

void closeMonitor(const UdevMonitor* monitor) {
    const Inside inside;
    std::erase_if(state().monitors, [&](const auto& one) { return one.get() == monitor; });
}

std::optional<UdevEvent> nextEvent(UdevMonitor& monitor) {
    const Inside inside;
    if (monitor.events.empty()) return std::nullopt;
    std::uint64_t one = 0;
    (void)!read(monitor.descriptor, &one, sizeof one);
    UdevEvent event = std::move(monitor.events.front());
    monitor.events.pop_front();
    return event;
}

} // namespace kernel

} // namespace tactum::test
