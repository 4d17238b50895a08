#include "device/usb/usb_link.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <deque>
#include <optional>

#include <libusb.h>
#include <linux/usbdevice_fs.h>
#include <poll.h>
#include <sys/ioctl.h>

#include "core/base/realtime.h"

namespace tactum {

namespace {

constexpr std::size_t kLargestPacket = 512;
constexpr int kMaxReads = 16;
constexpr std::size_t kRoom = 64;       ///< packets that wait to be taken
constexpr unsigned kSendTimeout = 5;    ///< ms
constexpr unsigned kSendNowTimeout = 5; ///< ms
constexpr int kMaxCancelRounds = 50;    ///< of 10 ms each
/// So many transfers broken in a row, with none that went well between, are not interference any more. A read
/// that broke begins again with the next poll(), so with three of them at 1 kHz this takes 10 ms.
constexpr int kBrokenUntilGone = 30;

const char kHowToPermit[] = "copy resources/udev/70-tactum.rules to /etc/udev/rules.d, run "
                            "'sudo udevadm control --reload' and plug it in again";

/// A view of the bus of one's own.
using Context = std::unique_ptr<libusb_context, decltype(&libusb_exit)>;

Result<Context> makeContext() {
    libusb_context* context = nullptr;
    if (const int error = libusb_init(&context))
        return machineError(std::string("the USB bus cannot be looked at: ") + libusb_strerror(error));
    return Context(context, &libusb_exit);
}

std::string portOf(libusb_device* device) {
    std::array<std::uint8_t, 8> sockets{};
    const int count = libusb_get_port_numbers(device, sockets.data(), sockets.size());
    std::string port = std::to_string(libusb_get_bus_number(device));
    for (int i = 0; i < count; ++i)
        port += (i == 0 ? "-" : ".") + std::to_string(sockets[static_cast<std::size_t>(i)]);
    return port;
}

UsbPlace placeOf(libusb_device* device) {
    libusb_device_descriptor about{};
    libusb_get_device_descriptor(device, &about);
    return {{about.idVendor, about.idProduct},
            libusb_get_bus_number(device),
            libusb_get_device_address(device),
            portOf(device)};
}

template <class Visit> void forEachDevice(libusb_context* context, Visit visit) {
    libusb_device** devices = nullptr;
    const auto count = libusb_get_device_list(context, &devices);
    for (auto i = decltype(count){0}; i < count; ++i)
        visit(devices[i]);
    if (count >= 0) libusb_free_device_list(devices, 1);
}

/// The device node behind the only handle of a context: it alone is asked for POLLOUT.
int nodeDescriptor(libusb_context* context) {
    const libusb_pollfd** list = libusb_get_pollfds(context);
    int node = -1;
    for (const libusb_pollfd** one = list; one && *one; ++one)
        if ((*one)->events & POLLOUT) node = (*one)->fd;
    libusb_free_pollfds(list);
    return node;
}

/// The last packets that came and were not taken yet, without allocation.
class PacketRing {
public:
    void put(std::span<const std::uint8_t> bytes) noexcept {
        if (count_ == kRoom) drop(); // who does not take them wants the newest
        Packet& packet = packets_[(first_ + count_) % kRoom];
        packet.size = std::min(bytes.size(), kLargestPacket);
        std::copy_n(bytes.data(), packet.size, packet.bytes.data());
        ++count_;
    }
    std::span<const std::uint8_t> take() noexcept {
        if (count_ == 0) return {};
        const Packet& packet = packets_[first_];
        drop();
        return {packet.bytes.data(), packet.size};
    }
    void clear() noexcept { count_ = 0; }

private:
    struct Packet {
        std::size_t size = 0;
        std::array<std::uint8_t, kLargestPacket> bytes;
    };
    void drop() noexcept {
        first_ = (first_ + 1) % kRoom;
        --count_;
    }
    std::array<Packet, kRoom> packets_;
    std::size_t first_ = 0, count_ = 0;
};

} // namespace

struct UsbLink::Impl {
    /// Of the stream: one packet's way, used again and again.
    struct Transfer {
        Impl* link = nullptr;
        libusb_transfer* usb = nullptr;
        bool underWay = false;
        std::array<std::uint8_t, kLargestPacket> bytes{};
    };
    /// One direction of the stream.
    struct Side {
        int failures = 0; ///< in a row
        bool halted = false;
    };

    Context context;
    UsbPlace place;
    UsbEndpoints endpoints;
    libusb_device_handle* handle = nullptr;
    int descriptor = -1; ///< for sendNow()
    std::deque<Transfer> reads;
    Transfer writing;
    Side in, out;
    bool streaming = false;
    int broken = 0; ///< transfers in a row, either way
    PacketRing packets;
    std::atomic<bool> gone{false};

    explicit Impl(Context c) : context(std::move(c)) {}
    ~Impl();

    Result<void> claim(libusb_device* device);
    Error failure(const std::string& doing, int error) const;
    Result<int> transferNow(std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size, int timeout);

    Result<void> prepare(Transfer& transfer, std::uint8_t endpoint, unsigned timeout);
    bool submit(Transfer& transfer, Side& side) noexcept;
    void readAll() noexcept;
    void repairHalts() noexcept;
    void cancelReads() noexcept;
    bool anyReadUnderWay() const noexcept;
    bool underWay() const noexcept { return writing.underWay || anyReadUnderWay(); }
    void giveUp() noexcept;
    void wentWell(Side& side) noexcept;
    void wentWrong(Side& side, libusb_transfer_status status) noexcept;
    void handleEvents(int milliseconds) noexcept;
    void endStream() noexcept;
    static void LIBUSB_CALL readDone(libusb_transfer* usb) noexcept;
    static void LIBUSB_CALL writeDone(libusb_transfer* usb) noexcept;
};

// ---- Opening and closing

Result<std::vector<UsbPlace>> listUsb(std::span<const UsbId> wanted) {
    assertNotRealtime();
    auto context = makeContext();
    if (!context) return tl::unexpected(context.error());
    std::vector<UsbPlace> places;
    forEachDevice(context->get(), [&](libusb_device* device) {
        UsbPlace place = placeOf(device);
        if (std::find(wanted.begin(), wanted.end(), place.id) != wanted.end())
            places.push_back(std::move(place));
    });
    return places;
}

Result<std::unique_ptr<UsbLink>> UsbLink::open(const UsbPlace& place, const UsbEndpoints& endpoints) {
    assertNotRealtime();
    assert(endpoints.packet <= kLargestPacket);
    auto context = makeContext();
    if (!context) return tl::unexpected(context.error());
    auto impl = std::make_unique<Impl>(std::move(*context));
    impl->place = place;
    impl->endpoints = endpoints;
    std::optional<Result<void>> claimed;
    forEachDevice(impl->context.get(), [&](libusb_device* device) {
        const UsbPlace here = placeOf(device);
        if (here.id == place.id && here.bus == place.bus && here.address == place.address)
            claimed = impl->claim(device);
    });
    if (!claimed) claimed = tl::unexpected(impl->failure("opened", LIBUSB_ERROR_NO_DEVICE));
    if (!*claimed) return tl::unexpected(claimed->error());
    return std::unique_ptr<UsbLink>(new UsbLink(std::move(impl)));
}

Result<void> UsbLink::Impl::claim(libusb_device* device) {
    int error = libusb_open(device, &handle);
    if (error) return tl::unexpected(failure("opened", error));
    // HID devices belong to usbhid until somebody asks; with this it has them back afterwards.
    libusb_set_auto_detach_kernel_driver(handle, 1);
    error = libusb_claim_interface(handle, endpoints.interface);
    if (error) return tl::unexpected(failure("claimed", error));
    descriptor = nodeDescriptor(context.get());
    return {};
}

Error UsbLink::Impl::failure(const std::string& doing, int error) const {
    const std::string what = "the device in USB socket " + place.port;
    const auto saying = [&](const std::string& text) {
        return Error{Error::Kind::Machine, what + " " + text};
    };
    switch (error) {
    case LIBUSB_ERROR_NO_DEVICE:
        return saying("is not there any more; plug it in and look again");
    case LIBUSB_ERROR_ACCESS:
        return saying("may not be used by you; " + std::string(kHowToPermit));
    case LIBUSB_ERROR_BUSY:
        return saying("is in use by another program; end that one first");
    case LIBUSB_ERROR_TIMEOUT:
        return saying("did not answer when " + doing + "; look at its power supply");
    case LIBUSB_ERROR_PIPE:
        return saying("refused when " + doing);
    default:
        return saying("failed when " + doing + ": " + libusb_strerror(error));
    }
}

UsbLink::UsbLink(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

UsbLink::~UsbLink() = default;

UsbLink::Impl::~Impl() {
    endStream();
    if (handle) {
        if (descriptor >= 0) libusb_release_interface(handle, endpoints.interface);
        libusb_close(handle); // the kernel ends what is still under way, and libusb forgets it
    }
    for (Transfer& read : reads)
        libusb_free_transfer(read.usb);
    libusb_free_transfer(writing.usb);
}

// ---- Setting up

Result<void> UsbLink::request(std::uint8_t request, std::uint16_t value, std::uint16_t index, int timeout) {
    assertNotRealtime();
    constexpr std::uint8_t kVendorToDevice = LIBUSB_REQUEST_TYPE_VENDOR; // ENDPOINT_OUT is 0
    const int error = libusb_control_transfer(impl_->handle, kVendorToDevice, request, value, index, nullptr,
                                              0, static_cast<unsigned>(timeout));
    if (error == LIBUSB_ERROR_NO_DEVICE) impl_->gone = true;
    if (error < 0) return tl::unexpected(impl_->failure("set up", error));
    return {};
}

/// The number of bytes that went or came.
Result<int> UsbLink::Impl::transferNow(std::uint8_t endpoint, std::uint8_t* bytes, std::size_t size,
                                       int timeout) {
    assertNotRealtime();
    assert(!streaming);
    const auto transfer = endpoints.interrupt ? libusb_interrupt_transfer : libusb_bulk_transfer;
    int count = 0;
    const int error =
        transfer(handle, endpoint, bytes, static_cast<int>(size), &count, static_cast<unsigned>(timeout));
    if (error == LIBUSB_ERROR_NO_DEVICE) gone = true;
    if (error == LIBUSB_ERROR_PIPE) libusb_clear_halt(handle, endpoint);
    const bool reading = endpoint & LIBUSB_ENDPOINT_IN;
    if (error && !(reading && error == LIBUSB_ERROR_TIMEOUT))
        return tl::unexpected(failure(reading ? "read from" : "written to", error));
    return count;
}

Result<void> UsbLink::write(std::span<const std::uint8_t> bytes, int timeout) {
    std::vector<std::uint8_t> copy(bytes.begin(), bytes.end()); // libusb wants to be able to change it
    const Result<int> count = impl_->transferNow(impl_->endpoints.out, copy.data(), copy.size(), timeout);
    if (!count) return tl::unexpected(count.error());
    if (*count != static_cast<int>(bytes.size()))
        return tl::unexpected(impl_->failure("written to", LIBUSB_ERROR_IO));
    return {};
}

Result<std::vector<std::uint8_t>> UsbLink::read(int timeout) {
    std::vector<std::uint8_t> bytes(impl_->endpoints.packet);
    const Result<int> count = impl_->transferNow(impl_->endpoints.in, bytes.data(), bytes.size(), timeout);
    if (!count) return tl::unexpected(count.error());
    bytes.resize(static_cast<std::size_t>(*count));
    return bytes;
}

// ---- The stream

/// Reads have no time-out: a device that has nothing to say is not at fault, and whoever expects an answer
/// knows himself how long he waits. Only what is sent has one.
Result<void> UsbLink::startStream(int reads) {
    assertNotRealtime();
    assert(!impl_->streaming && reads > 0 && reads <= kMaxReads);
    while (impl_->reads.size() < static_cast<std::size_t>(reads)) {
        impl_->reads.emplace_back();
        if (auto ready = impl_->prepare(impl_->reads.back(), impl_->endpoints.in, 0); !ready) return ready;
    }
    if (auto ready = impl_->prepare(impl_->writing, impl_->endpoints.out, kSendTimeout); !ready) return ready;
    impl_->in = impl_->out = {};
    impl_->broken = 0;
    impl_->packets.clear();
    impl_->streaming = true;
    impl_->readAll();
    if (impl_->gone) return tl::unexpected(impl_->failure("started", LIBUSB_ERROR_NO_DEVICE));
    return {};
}

Result<void> UsbLink::Impl::prepare(Transfer& transfer, std::uint8_t endpoint, unsigned timeout) {
    if (!transfer.usb) transfer.usb = libusb_alloc_transfer(0);
    if (!transfer.usb) return tl::unexpected(failure("started", LIBUSB_ERROR_NO_MEM));
    transfer.link = this;
    const auto fill = endpoints.interrupt ? libusb_fill_interrupt_transfer : libusb_fill_bulk_transfer;
    const bool reading = endpoint & LIBUSB_ENDPOINT_IN;
    fill(transfer.usb, handle, endpoint, transfer.bytes.data(), static_cast<int>(endpoints.packet),
         reading ? readDone : writeDone, &transfer, timeout);
    return {};
}

void UsbLink::stopStream() {
    assertNotRealtime();
    impl_->endStream();
}

/// Bounded, whatever the device and the kernel do.
void UsbLink::Impl::endStream() noexcept {
    if (!streaming) return;
    streaming = false;
    cancelReads();
    if (writing.underWay) libusb_cancel_transfer(writing.usb);
    for (int round = 0; round < kMaxCancelRounds && underWay(); ++round)
        handleEvents(10);
    packets.clear();
}

bool UsbLink::send(std::span<const std::uint8_t> bytes) noexcept {
    assert(bytes.size() <= impl_->endpoints.packet);
    Impl::Transfer& writing = impl_->writing;
    if (!impl_->streaming || impl_->gone || impl_->out.halted || writing.underWay) return false;
    std::copy(bytes.begin(), bytes.end(), writing.bytes.begin());
    writing.usb->length = static_cast<int>(bytes.size());
    return impl_->submit(writing, impl_->out);
}

void UsbLink::poll() noexcept {
    if (!impl_->streaming || impl_->gone) return;
    impl_->handleEvents(0);
    impl_->repairHalts();
    impl_->readAll();
}

std::span<const std::uint8_t> UsbLink::take() noexcept {
    return impl_->packets.take();
}

int UsbLink::failures() const noexcept {
    return std::max(impl_->in.failures, impl_->out.failures);
}

bool UsbLink::gone() const noexcept {
    return impl_->gone;
}

void UsbLink::Impl::handleEvents(int milliseconds) noexcept {
    timeval wait{0, milliseconds * 1000};
    libusb_handle_events_timeout_completed(context.get(), &wait, nullptr);
}

bool UsbLink::Impl::submit(Transfer& transfer, Side& side) noexcept {
    const int error = libusb_submit_transfer(transfer.usb);
    transfer.underWay = error == 0;
    if (error == LIBUSB_ERROR_NO_DEVICE)
        giveUp();
    else if (error)
        ++side.failures; // no memory: the next time may be better
    return transfer.underWay;
}

/// Begins every read that is not under way; also those that ended with an error, which do not begin again at
/// once: a broken bus shall not hold the servo with a thousand errors.
void UsbLink::Impl::readAll() noexcept {
    for (Transfer& read : reads)
        if (!read.underWay && !in.halted && !gone && streaming) submit(read, in);
}

/// An endpoint that stalled wants to be told to go on, once nothing is queued for it any more. This is the
/// one place where poll() waits, for a control transfer of about a millisecond.
void UsbLink::Impl::repairHalts() noexcept {
    const auto repair = [this](Side& side, std::uint8_t endpoint) {
        const int error = libusb_clear_halt(handle, endpoint);
        if (error == LIBUSB_ERROR_NO_DEVICE) giveUp();
        side.halted = error != 0;
    };
    if (out.halted && !writing.underWay && !gone) repair(out, endpoints.out);
    if (!in.halted || gone) return;
    if (anyReadUnderWay()) cancelReads();
    handleEvents(0);
    if (!anyReadUnderWay() && !gone) repair(in, endpoints.in);
}

void UsbLink::Impl::cancelReads() noexcept {
    for (Transfer& read : reads)
        if (read.underWay) libusb_cancel_transfer(read.usb);
}

bool UsbLink::Impl::anyReadUnderWay() const noexcept {
    return std::any_of(reads.begin(), reads.end(), [](const Transfer& read) { return read.underWay; });
}

void UsbLink::Impl::giveUp() noexcept {
    gone = true;
    packets.clear(); // nobody shall act on what a device said that is not there any more
}

void UsbLink::Impl::wentWell(Side& side) noexcept {
    side.failures = 0;
    broken = 0;
}

void UsbLink::Impl::wentWrong(Side& side, libusb_transfer_status status) noexcept {
    if (status == LIBUSB_TRANSFER_CANCELLED) return; // that was us
    ++side.failures;
    if (status == LIBUSB_TRANSFER_STALL) side.halted = true;
    if (status == LIBUSB_TRANSFER_NO_DEVICE) giveUp();
    // What is unplugged looks like a broken bus until the hub has noticed.
    if (status == LIBUSB_TRANSFER_ERROR && ++broken >= kBrokenUntilGone) giveUp();
}

void UsbLink::Impl::readDone(libusb_transfer* usb) noexcept {
    auto& read = *static_cast<Transfer*>(usb->user_data);
    Impl& link = *read.link;
    read.underWay = false;
    if (usb->status != LIBUSB_TRANSFER_COMPLETED) return link.wentWrong(link.in, usb->status);
    link.wentWell(link.in);
    if (!link.streaming || link.gone) return;
    link.packets.put({usb->buffer, static_cast<std::size_t>(usb->actual_length)});
    if (!link.in.halted) link.submit(read, link.in);
}

void UsbLink::Impl::writeDone(libusb_transfer* usb) noexcept {
    auto& writing = *static_cast<Transfer*>(usb->user_data);
    Impl& link = *writing.link;
    writing.underWay = false;
    const bool whole = usb->actual_length == usb->length;
    if (usb->status == LIBUSB_TRANSFER_COMPLETED && whole)
        link.wentWell(link.out);
    else
        link.wentWrong(link.out,
                       usb->status == LIBUSB_TRANSFER_COMPLETED ? LIBUSB_TRANSFER_ERROR : usb->status);
}

// ---- Past libusb

/// A synchronous transfer of the kernel: one that is only submitted would come back to whoever reaps next,
/// and libusb would take it for its own. The kernel carries it out on interrupt endpoints too.
void UsbLink::sendNow(std::span<const std::uint8_t> bytes) noexcept {
    usbdevfs_bulktransfer transfer{};
    transfer.ep = impl_->endpoints.out;
    transfer.len = static_cast<unsigned>(bytes.size());
    transfer.timeout = kSendNowTimeout;
    transfer.data = const_cast<std::uint8_t*>(bytes.data());
    const int before = errno; // a signal handler has to leave it as it was
    if (impl_->descriptor >= 0) ioctl(impl_->descriptor, USBDEVFS_BULK, &transfer);
    errno = before;
}

} // namespace tactum
