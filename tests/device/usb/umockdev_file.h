// A device node that libusb has open through umockdev: its ioctls, with the memory they point to, given to
// the emulated kernel.
#pragma once

#include <list>
#include <memory>
#include <string>

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include "tests/device/usb/emulated_usb.h"

namespace tactum::test {

/// Memory of the caller that an ioctl points to, as umockdev brings it here and takes it back.
struct DropMemory {
    void operator()(UMockdevIoctlData* memory) const { g_object_unref(memory); }
};
using ClientMemory = std::unique_ptr<UMockdevIoctlData, DropMemory>;

class UmockdevFile {
public:
    /// `node`: a descriptor of kernel::openNode(path).
    UmockdevFile(std::string path, int node) : path_(std::move(path)), node_(node) {}
    ~UmockdevFile();
    UmockdevFile(const UmockdevFile&) = delete;
    UmockdevFile& operator=(const UmockdevFile&) = delete;

    const std::string& path() const { return path_; }
    /// Of the client's present request: 0 or more, or -errno.
    int control(UMockdevIoctlClient* client);
    /// Whether poll() has something to say of it.
    bool isReady() const;

private:
    /// What the caller submitted. umockdev puts the caller's address back into its own copy of the URB, so
    /// the kernel gets one of ours.
    struct Urb {
        ClientMemory theirs, buffer;
        std::unique_ptr<usbdevfs_urb> ours;
        Bytes bytes;
    };

    int submit(UMockdevIoctlData* argument);
    int discard(UMockdevIoctlData* argument);
    int reap(UMockdevIoctlData* argument);
    int bulk(UMockdevIoctlData* argument);
    int plain(unsigned long request, UMockdevIoctlData* argument);

    std::string path_;
    int node_;
    std::list<Urb> urbs_;
};

} // namespace tactum::test
