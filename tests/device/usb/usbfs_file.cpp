#include "tests/device/usb/usbfs_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/device/usb/usb_descriptors.h"

namespace tactum::test {

namespace {

constexpr std::size_t kSetupLength = 8;

UsbSetup setupOf(const Bytes& bytes) {
    const auto word = [&](std::size_t at) {
        return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
    };
    return {bytes[0], bytes[1], word(2), word(4), word(6)};
}

void ring(int wake) {
    const std::uint64_t one = 1;
    (void)!write(wake, &one, sizeof one);
}

void silence(int wake) {
    std::uint64_t count = 0;
    (void)!read(wake, &count, sizeof count);
}

} // namespace

UsbfsFile::UsbfsFile(std::shared_ptr<PluggedDevice> plugged, int wake)
    : plugged_(std::move(plugged)), wake_(wake) {}

UsbfsFile::~UsbfsFile() {
    release();
}

int UsbfsFile::control(unsigned long request, void* argument, std::int64_t now) {
    // As in the kernel, what came before the unplugging can still be fetched, and nothing else be done.
    if (request == USBDEVFS_REAPURBNDELAY) return reap(static_cast<usbdevfs_urb**>(argument), now);
    if (!plugged_->there) return -ENODEV;
    switch (request) {
    case USBDEVFS_SUBMITURB:
        return submit(*static_cast<usbdevfs_urb*>(argument), now);
    case USBDEVFS_DISCARDURB:
        return discard(static_cast<usbdevfs_urb*>(argument));
    case USBDEVFS_GET_CAPABILITIES:
        *static_cast<std::uint32_t*>(argument) = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                                 USBDEVFS_CAP_BULK_SCATTER_GATHER |
                                                 USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
        return 0;
    case USBDEVFS_CLAIMINTERFACE:
        return claim(false);
    case USBDEVFS_DISCONNECT_CLAIM:
        return claim(true);
    case USBDEVFS_RELEASEINTERFACE:
        return release();
    case USBDEVFS_CLEAR_HALT:
        return clearHalt(*static_cast<unsigned*>(argument));
    case USBDEVFS_IOCTL:
        return driver(*static_cast<usbdevfs_ioctl*>(argument));
    case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_RESET:
        return 0;
    default:
        return -ENOTTY;
    }
}

int UsbfsFile::claim(bool takeFromKernel) {
    if (plugged_->claimedBy && plugged_->claimedBy != this) return -EBUSY;
    if (plugged_->kernelDriver && !takeFromKernel) return -EBUSY;
    plugged_->kernelDriver = false;
    plugged_->claimedBy = this;
    return 0;
}

int UsbfsFile::release() {
    if (plugged_->claimedBy != this) return -EINVAL;
    plugged_->claimedBy = nullptr;
    return 0;
}

int UsbfsFile::driver(const usbdevfs_ioctl& command) {
    if (static_cast<unsigned>(command.ioctl_code) != USBDEVFS_CONNECT) return -ENOTTY;
    plugged_->kernelDriver = plugged_->description.interfaceClass == 3;
    return plugged_->kernelDriver ? 1 : 0;
}

/// What is still queued then, some controllers never look at again.
int UsbfsFile::clearHalt(unsigned endpoint) {
    for (Urb& urb : pending_)
        if (urb.endpoint == endpoint) urb.stuck = true;
    (endpoint & 0x80 ? plugged_->haltedIn : plugged_->haltedOut) = false;
    return 0;
}

int UsbfsFile::submit(usbdevfs_urb& urb, std::int64_t now) {
    UsbFaults& faults = plugged_->faults;
    if (faults.failSubmits > 0) {
        --faults.failSubmits;
        return -ENOMEM;
    }
    const bool control = urb.type == USBDEVFS_URB_TYPE_CONTROL;
    if (!control && plugged_->claimedBy != this) return -EINVAL;
    if (urb.type == USBDEVFS_URB_TYPE_INTERRUPT && !plugged_->description.interrupt) return -EINVAL;
    const auto* bytes = static_cast<const std::uint8_t*>(urb.buffer);
    const auto length = static_cast<std::size_t>(urb.buffer_length);
    Urb copy{&urb, urb.type, urb.endpoint, {}, length, 0, 0, now + faults.delay};
    if (control || !copy.isIn()) copy.data.assign(bytes, bytes + length);
    pending_.push_back(std::move(copy));
    advance(now);
    return 0;
}

int UsbfsFile::discard(const usbdevfs_urb* urb) {
    const auto found =
        std::find_if(pending_.begin(), pending_.end(), [&](const Urb& one) { return one.user == urb; });
    if (found == pending_.end()) return -EINVAL;
    complete(found, -ENOENT);
    return 0;
}

int UsbfsFile::reap(usbdevfs_urb** urb, std::int64_t now) {
    advance(now);
    if (completed_.empty()) return plugged_->there ? -EAGAIN : -ENODEV;
    const Urb done = std::move(completed_.front());
    completed_.pop_front();
    done.user->status = done.status;
    done.user->actual_length = done.length;
    auto* to = static_cast<std::uint8_t*>(done.user->buffer);
    if (done.type == USBDEVFS_URB_TYPE_CONTROL && done.length > 0)
        std::copy_n(done.data.begin(), done.length, to + kSetupLength);
    else if (done.isIn() && done.length > 0)
        std::copy_n(done.data.begin(), done.length, to);
    *urb = done.user;
    return 0;
}

int UsbfsFile::bulk(const usbdevfs_bulktransfer& transfer, std::int64_t now) {
    if (!plugged_->there) return -ENODEV;
    if (plugged_->claimedBy != this) return -EINVAL;
    advance(now);
    const auto endpoint = static_cast<std::uint8_t>(transfer.ep);
    for (const Urb& before : pending_)
        if (before.endpoint == endpoint) return -EAGAIN;
    auto* bytes = static_cast<std::uint8_t*>(transfer.data);
    Urb urb{nullptr, USBDEVFS_URB_TYPE_BULK, endpoint, {}, transfer.len, 0, 0, now};
    if (!urb.isIn()) urb.data.assign(bytes, bytes + transfer.len);
    if (!carryOut(urb, now)) return -EAGAIN;
    if (urb.isIn()) std::copy_n(urb.data.begin(), urb.length, bytes);
    return urb.status == 0 ? urb.length : urb.status;
}

short UsbfsFile::events(std::int64_t now) {
    silence(wake_);
    advance(now);
    short events = completed_.empty() ? 0 : POLLOUT;
    if (!plugged_->there) events |= POLLERR | POLLHUP;
    return events;
}

std::int64_t UsbfsFile::nextEvent(std::int64_t now) const {
    std::int64_t next = kNever;
    if (plugged_->faults.mute) return next;
    for (const Urb& urb : pending_) {
        const std::int64_t due = urb.due > now || !urb.isIn() ? urb.due : plugged_->device->nextIn(now);
        next = std::min(next, due);
    }
    return next;
}

void UsbfsFile::endAll() {
    // A real controller cannot tell at once why nobody answers any more: the first transfer is a broken one.
    int status = -EPROTO;
    while (!pending_.empty()) {
        complete(pending_.begin(), status);
        status = -ESHUTDOWN;
    }
    ring(wake_);
}

void UsbfsFile::advance(std::int64_t now) {
    if (!plugged_->there || plugged_->faults.mute) return;
    Bytes waiting; // endpoints whose first transfer is not over, so that those behind it wait
    for (auto urb = pending_.begin(); urb != pending_.end();) {
        const auto next = std::next(urb);
        const bool behind = std::find(waiting.begin(), waiting.end(), urb->endpoint) != waiting.end();
        if (!behind && urb->due <= now && carryOut(*urb, now))
            complete(urb, urb->status);
        else
            waiting.push_back(urb->endpoint);
        urb = next;
    }
}

/// Whether it is over, with its status.
bool UsbfsFile::carryOut(Urb& urb, std::int64_t now) {
    UsbFaults& faults = plugged_->faults;
    if (faults.mute) return false;
    if (faults.errors > 0) {
        --faults.errors;
        urb.status = -EPROTO;
        return true;
    }
    if (urb.type == USBDEVFS_URB_TYPE_CONTROL) return controlTransfer(urb, now);
    bool& halted = urb.isIn() ? plugged_->haltedIn : plugged_->haltedOut;
    if (halted || urb.stuck) return false;
    if (urb.isIn() ? faults.stallIn : faults.stallOut) {
        halted = true;
        urb.status = -EPIPE;
        return true;
    }
    return urb.isIn() ? inTransfer(urb, now) : outTransfer(urb, now);
}

bool UsbfsFile::controlTransfer(Urb& urb, std::int64_t now) {
    const UsbSetup setup = setupOf(urb.data);
    const std::span<const std::uint8_t> data(urb.data.begin() + kSetupLength, urb.data.end());
    std::optional<Bytes> answer;
    if (!plugged_->faults.stallControl) {
        answer = standardAnswer(plugged_->description, setup);
        if (!answer) answer = plugged_->device->control(setup, data, now);
    }
    if (!answer) {
        urb.status = -EPIPE;
        return true;
    }
    if (setup.type & 0x80) {
        urb.length = static_cast<int>(std::min<std::size_t>(answer->size(), setup.length));
        urb.data = std::move(*answer);
    } else {
        urb.length = static_cast<int>(data.size());
        urb.data.erase(urb.data.begin(), urb.data.begin() + kSetupLength);
    }
    return true;
}

/// A transfer takes in packets until one is short or there is no room.
bool UsbfsFile::inTransfer(Urb& urb, std::int64_t now) {
    while (urb.data.size() < urb.room) {
        const std::optional<Bytes> packet = plugged_->device->in(now);
        if (!packet) return false;
        const std::size_t largest = plugged_->description.packet;
        const bool babble = packet->size() > largest || urb.data.size() + packet->size() > urb.room;
        urb.data.insert(urb.data.end(), packet->begin(), packet->end());
        urb.data.resize(std::min(urb.data.size(), urb.room));
        urb.length = static_cast<int>(urb.data.size());
        if (babble) urb.status = -EOVERFLOW;
        if (babble || packet->size() < largest) return true;
    }
    return true;
}

bool UsbfsFile::outTransfer(Urb& urb, std::int64_t now) {
    const std::span<const std::uint8_t> bytes(urb.data);
    for (std::size_t at = 0; at < bytes.size(); at += plugged_->description.packet)
        plugged_->device->out(
            bytes.subspan(at, std::min<std::size_t>(plugged_->description.packet, bytes.size() - at)), now);
    urb.length = static_cast<int>(bytes.size());
    return true;
}

void UsbfsFile::complete(std::list<Urb>::iterator urb, int status) {
    urb->status = status;
    completed_.splice(completed_.end(), pending_, urb);
    ring(wake_);
}

} // namespace tactum::test
