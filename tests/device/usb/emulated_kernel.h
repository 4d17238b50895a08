// The kernel under libusb, as far as the emulated bus goes: device nodes, sysfs, poll and udev's events.
//
// Calls from a program that never plugged anything in fall through to the real one.
#pragma once

#include <csignal>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <poll.h>

#include "tests/device/usb/usbfs_file.h"

namespace tactum::test::kernel {

/// Held by whoever is in the emulated kernel. Signals wait until he has left, as they would for the real one:
/// a signal handler may call the kernel too. The lock survives a fork.
class Inside {
public:
    Inside();
    ~Inside();
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

private:
    sigset_t before_;
};

/// `changed` is called after every plugging and unplugging, by the thread that did it, outside the kernel:
/// for who shows the bus to libusb in another way than by defining its calls. Before the first plugging, and
/// once.
void setListener(std::function<void()> changed);

/// Whether this thread is in the emulated kernel: what it allocates there is no program's doing.
bool isInside();

// System calls. Each returns what the real one would, but -errno for -1.

/// nullopt: not a node of the bus.
std::optional<int> openNode(const char* path);
/// The text of a file of sysfs, an empty one when it is not there, nullopt when it is no business of ours.
std::optional<Bytes> sysfsFile(const char* path);
/// Thread: any; waits for nobody.
bool isNode(int descriptor);
void closeNode(int descriptor);
int controlNode(int descriptor, unsigned long request, void* argument);
int pollNodes(pollfd* fds, nfds_t count, int timeout);

// udev.

struct UdevEvent {
    std::string action, name, node;
};

struct UdevMonitor {
    int descriptor = -1; ///< an eventfd that counts the events
    std::deque<UdevEvent> events;
};

std::vector<std::string> deviceNames();
/// "/dev/bus/usb/001/002" of "1-3"; empty when there is none.
std::string nodeOf(const std::string& name);
std::shared_ptr<UdevMonitor> openMonitor();
void closeMonitor(const UdevMonitor* monitor);
std::optional<UdevEvent> nextEvent(UdevMonitor& monitor);

} // namespace tactum::test::kernel
