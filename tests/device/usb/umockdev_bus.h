// The emulated bus as umockdev shows it to libusb: attribute files, udev's events, and nodes whose ioctls
// come here. The cross-check of interposed_calls.cpp; linking one of the two is enough.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include <umockdev.h>

#include "tests/device/usb/emulated_kernel.h"
#include "tests/device/usb/pty_node.h"
#include "tests/device/usb/umockdev_file.h"

namespace tactum::test {

/// Threads: whoever plugs in or out; umockdev's own, where the ioctls come in; and one that looks what is
/// complete, because a transfer may wait for time alone and nobody else calls the emulated kernel meanwhile.
class UmockdevBus {
public:
    UmockdevBus();
    ~UmockdevBus();
    UmockdevBus(const UmockdevBus&) = delete;
    UmockdevBus& operator=(const UmockdevBus&) = delete;

private:
    void follow();
    void add(const kernel::UdevEvent& event);
    void describe(const kernel::UdevEvent& event);
    void remove(const kernel::UdevEvent& event);
    void refresh();

    void connect(UMockdevIoctlClient* client);
    void disconnect(UMockdevIoctlClient* client);
    void answer(UMockdevIoctlClient* client);

    UMockdevTestbed* testbed_;
    UMockdevIoctlBase* ioctls_;
    std::string root_;
    std::shared_ptr<kernel::UdevMonitor> monitor_;

    std::mutex mutex_;                     ///< of what follows
    std::map<std::string, PtyNode> nodes_; ///< by the paths that libusb knows
    std::set<std::string> attached_;       ///< paths whose ioctls come here
    std::map<UMockdevIoctlClient*, UmockdevFile> files_;
    std::jthread looker_;
};

} // namespace tactum::test
