// A device node that a program has open: what the kernel's usbfs does with its URBs.
//
// There is no thread: transfers go on whenever somebody looks (advance), with the time of that moment. All of
// it happens under the lock of the emulated kernel.
#pragma once

#include <deque>
#include <limits>
#include <list>
#include <memory>

#include <linux/usbdevice_fs.h>

#include "tests/device/usb/emulated_usb.h"

namespace tactum::test {

inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

class UsbfsFile;

/// A device from its plugging to its unplugging.
struct PluggedDevice {
    std::shared_ptr<EmulatedUsbDevice> device;
    UsbDescription description;
    int socket = 0, address = 0;
    bool there = true;
    bool forbidden = false;
    bool kernelDriver = false; ///< as usbhid holds what says that it is an HID device
    UsbFaults faults;
    bool haltedIn = false, haltedOut = false;
    const UsbfsFile* claimedBy = nullptr;
};

class UsbfsFile {
public:
    /// `wake`: an eventfd that is written to when something is complete; owned by the file.
    UsbfsFile(std::shared_ptr<PluggedDevice> plugged, int wake);
    ~UsbfsFile();
    UsbfsFile(const UsbfsFile&) = delete;
    UsbfsFile& operator=(const UsbfsFile&) = delete;

    /// 0 or -errno; `argument` as for the real one. Not for USBDEVFS_BULK.
    int control(unsigned long request, void* argument, std::int64_t now);
    /// Of USBDEVFS_BULK: the number of bytes or -errno once it is over, -EAGAIN before.
    int bulk(const usbdevfs_bulktransfer& transfer, std::int64_t now);
    /// What poll() would say of it.
    short events(std::int64_t now);
    /// When something may happen next without anybody's doing, kNever when nothing will.
    std::int64_t nextEvent(std::int64_t now) const;
    /// The device is gone: whatever is under way ends.
    void endAll();
    const PluggedDevice& plugged() const { return *plugged_; }
    int pending() const { return static_cast<int>(pending_.size()); }

private:
    struct Urb {
        usbdevfs_urb* user = nullptr; ///< where it has to be handed back
        std::uint8_t type = 0, endpoint = 0;
        Bytes data; ///< OUT: what goes; IN: what came so far
        std::size_t room = 0;
        int status = 0, length = 0;
        std::int64_t due = 0; ///< not complete before

        bool isIn() const { return endpoint & 0x80; }
    };

    int submit(usbdevfs_urb& urb, std::int64_t now);
    int discard(const usbdevfs_urb* urb);
    int reap(usbdevfs_urb** urb, std::int64_t now);
    int claim(bool takeFromKernel);
    int release();
    int driver(const usbdevfs_ioctl& command);
    int clearHalt(unsigned endpoint);

    void advance(std::int64_t now);
    bool carryOut(Urb& urb, std::int64_t now);
    bool controlTransfer(Urb& urb, std::int64_t now);
    bool inTransfer(Urb& urb, std::int64_t now);
    bool outTransfer(Urb& urb, std::int64_t now);
    void complete(std::list<Urb>::iterator urb, int status);

    std::shared_ptr<PluggedDevice> plugged_;
    int wake_;
    std::list<Urb> pending_, completed_;
};

} // namespace tactum::test
