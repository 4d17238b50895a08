#include "tests/device/usb/umockdev_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/device/usb/emulated_kernel.h"

namespace tactum::test {

namespace {

/// What the pointer at `offset` points to; null when there is nothing.
ClientMemory follow(UMockdevIoctlData* from, std::size_t offset, std::size_t length) {
    return ClientMemory(umockdev_ioctl_data_resolve(from, offset, length, nullptr));
}

template <class T> T read(const ClientMemory& memory) {
    T value;
    std::memcpy(&value, memory->data, sizeof value);
    return value;
}

Bytes bytesOf(const ClientMemory& memory) {
    return memory ? Bytes(memory->data, memory->data + memory->data_len) : Bytes{};
}

void write(const ClientMemory& memory, const Bytes& bytes) {
    if (memory) std::copy(bytes.begin(), bytes.end(), memory->data);
}

} // namespace

UmockdevFile::~UmockdevFile() {
    kernel::closeNode(node_);
    close(node_);
}

int UmockdevFile::control(UMockdevIoctlClient* client) {
    UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
    const unsigned long request = umockdev_ioctl_client_get_request(client);
    switch (request) {
    case USBDEVFS_SUBMITURB:
        return submit(argument);
    case USBDEVFS_DISCARDURB:
        return discard(argument);
    case USBDEVFS_REAPURBNDELAY:
        return reap(argument);
    case USBDEVFS_BULK:
        return bulk(argument);
    default:
        return plain(request, argument);
    }
}

bool UmockdevFile::isReady() const {
    pollfd one{node_, POLLOUT, 0};
    return kernel::pollNodes(&one, 1, 0) > 0;
}

int UmockdevFile::submit(UMockdevIoctlData* argument) {
    ClientMemory theirs = follow(argument, 0, sizeof(usbdevfs_urb));
    if (!theirs) return -EFAULT;
    Urb& urb = urbs_.emplace_back();
    urb.ours = std::make_unique<usbdevfs_urb>(read<usbdevfs_urb>(theirs));
    urb.buffer = follow(theirs.get(), offsetof(usbdevfs_urb, buffer),
                        static_cast<std::size_t>(urb.ours->buffer_length));
    urb.bytes = bytesOf(urb.buffer);
    urb.ours->buffer = urb.bytes.data();
    urb.theirs = std::move(theirs);
    const int result = kernel::controlNode(node_, USBDEVFS_SUBMITURB, urb.ours.get());
    if (result < 0) urbs_.pop_back();
    return result;
}

/// The argument is the URB's address itself.
int UmockdevFile::discard(UMockdevIoctlData* argument) {
    gulong address = 0;
    std::memcpy(&address, argument->data, sizeof address);
    const auto urb = std::find_if(urbs_.begin(), urbs_.end(),
                                  [&](const Urb& one) { return one.theirs->client_addr == address; });
    if (urb == urbs_.end()) return -EINVAL;
    return kernel::controlNode(node_, USBDEVFS_DISCARDURB, urb->ours.get());
}

int UmockdevFile::reap(UMockdevIoctlData* argument) {
    const ClientMemory place = follow(argument, 0, sizeof(usbdevfs_urb*));
    if (!place) return -EFAULT;
    usbdevfs_urb* done = nullptr;
    const int result = kernel::controlNode(node_, USBDEVFS_REAPURBNDELAY, &done);
    if (result < 0) return result;
    const auto urb =
        std::find_if(urbs_.begin(), urbs_.end(), [&](const Urb& one) { return one.ours.get() == done; });
    auto* const theirs = reinterpret_cast<usbdevfs_urb*>(urb->theirs->data);
    theirs->status = done->status;
    theirs->actual_length = done->actual_length;
    write(urb->buffer, urb->bytes);
    umockdev_ioctl_data_set_ptr(place.get(), 0, urb->theirs.get());
    urbs_.erase(urb);
    return result;
}

int UmockdevFile::bulk(UMockdevIoctlData* argument) {
    const ClientMemory theirs = follow(argument, 0, sizeof(usbdevfs_bulktransfer));
    if (!theirs) return -EFAULT;
    auto ours = read<usbdevfs_bulktransfer>(theirs);
    const ClientMemory buffer = follow(theirs.get(), offsetof(usbdevfs_bulktransfer, data), ours.len);
    Bytes bytes = bytesOf(buffer);
    ours.data = bytes.data();
    const int result = kernel::controlNode(node_, USBDEVFS_BULK, &ours);
    write(buffer, bytes);
    return result;
}

/// Those whose argument holds no pointer that matters.
int UmockdevFile::plain(unsigned long request, UMockdevIoctlData* argument) {
    const std::size_t size = _IOC_SIZE(request);
    if (size == 0) return kernel::controlNode(node_, request, nullptr);
    const ClientMemory theirs = follow(argument, 0, size);
    return theirs ? kernel::controlNode(node_, request, theirs->data) : -EFAULT;
}

} // namespace tactum::test
