#include "tests/device/usb/umockdev_bus.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace tactum::test {

namespace {

namespace fs = std::filesystem;

constexpr auto kLookEvery = std::chrono::microseconds(500);

std::string taken(gchar* text) {
    std::string copy(text);
    g_free(text);
    return copy;
}

fs::path sysfsFolder(const kernel::UdevEvent& event) {
    return "/sys/devices/" + event.name;
}

std::string sysfsText(const kernel::UdevEvent& event, const char* file) {
    const Bytes text = *kernel::sysfsFile(("/sys/bus/usb/devices/" + event.name + "/" + file).c_str());
    return {text.begin(), text.end()};
}

/// Before main(), as the calls that are defined in the program are there before it.
UmockdevBus theBus;

} // namespace

UmockdevBus::UmockdevBus() {
    // Who opens a terminal may get it as its own, and then the signal when it hangs up.
    std::signal(SIGHUP, SIG_IGN);
    testbed_ = umockdev_testbed_new();
    if (!umockdev_in_mock_environment()) {
        std::fputs("Start this test under umockdev-wrapper.\n", stderr);
        g_object_unref(testbed_);
        std::_Exit(2);
    }
    root_ = taken(umockdev_testbed_get_root_dir(testbed_));
    ioctls_ = umockdev_ioctl_base_new();
    const auto connected =
        +[](UMockdevIoctlBase*, UMockdevIoctlClient* client, UmockdevBus* bus) { bus->connect(client); };
    const auto called = +[](UMockdevIoctlBase*, UMockdevIoctlClient* client, UmockdevBus* bus) -> gboolean {
        bus->answer(client);
        return TRUE;
    };
    g_signal_connect(ioctls_, "client-connected", G_CALLBACK(connected), this);
    g_signal_connect(ioctls_, "handle-ioctl", G_CALLBACK(called), this);
    monitor_ = kernel::openMonitor();
    kernel::setListener([this] { follow(); });
    looker_ = std::jthread([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(kLookEvery);
            const std::lock_guard lock(mutex_);
            refresh();
        }
    });
}

UmockdevBus::~UmockdevBus() {
    looker_ = {};
    kernel::setListener([] {});
    kernel::closeMonitor(monitor_.get());
    close(monitor_->descriptor);
    g_object_unref(testbed_);
    g_object_unref(ioctls_);
}

// ---- What is plugged in.

void UmockdevBus::follow() {
    const std::lock_guard lock(mutex_);
    while (const auto event = kernel::nextEvent(*monitor_))
        event->action == "add" ? add(*event) : remove(*event);
}

void UmockdevBus::add(const kernel::UdevEvent& event) {
    const fs::path node = root_ + event.node;
    fs::create_directories(node.parent_path());
    fs::create_symlink(nodes_[event.node].path(), node);
    // For good: who has it open may still have to fetch something after the unplugging.
    if (attached_.insert(event.node).second)
        umockdev_testbed_attach_ioctl(testbed_, event.node.c_str(), ioctls_, nullptr);
    describe(event);
}

/// All the rest before umockdev makes the device, which tells udev at once.
void UmockdevBus::describe(const kernel::UdevEvent& event) {
    const fs::path folder = sysfsFolder(event);
    fs::create_directories(root_ + folder.string());
    std::string descriptors = sysfsText(event, "descriptors");
    umockdev_testbed_set_attribute_binary(testbed_, folder.c_str(), "descriptors",
                                          reinterpret_cast<guint8*>(descriptors.data()),
                                          static_cast<gint>(descriptors.size()));
    for (const char* file : {"busnum", "devnum", "speed", "bConfigurationValue"})
        umockdev_testbed_set_attribute(testbed_, folder.c_str(), file, sysfsText(event, file).c_str());
    g_free(umockdev_testbed_add_device(testbed_, "usb", event.name.c_str(), nullptr, nullptr, "DEVTYPE",
                                       "usb_device", "DEVNAME", event.node.c_str(), nullptr));
}

void UmockdevBus::remove(const kernel::UdevEvent& event) {
    nodes_.erase(event.node);
    fs::remove(root_ + event.node);
    umockdev_testbed_uevent(testbed_, sysfsFolder(event).c_str(), "remove");
    umockdev_testbed_remove_device(testbed_, sysfsFolder(event).c_str());
}

/// Tells poll() what is complete.
void UmockdevBus::refresh() {
    for (auto& [path, node] : nodes_) {
        bool ready = false;
        for (const auto& [client, file] : files_)
            if (file.path() == path) ready |= file.isReady();
        node.setReady(ready);
    }
}

// ---- What libusb asks. Thread: umockdev's.

void UmockdevBus::connect(UMockdevIoctlClient* client) {
    // umockdev says nothing when somebody closes; but then it drops its client.
    const auto gone = +[](gpointer bus, GObject* one) {
        static_cast<UmockdevBus*>(bus)->disconnect(reinterpret_cast<UMockdevIoctlClient*>(one));
    };
    g_object_weak_ref(G_OBJECT(client), gone, this);
    const std::lock_guard lock(mutex_);
    const std::string path = umockdev_ioctl_client_get_devnode(client);
    const int node = kernel::openNode(path.c_str()).value_or(-1);
    if (node >= 0) files_.try_emplace(client, path, node);
}

void UmockdevBus::disconnect(UMockdevIoctlClient* client) {
    const std::lock_guard lock(mutex_);
    files_.erase(client);
}

void UmockdevBus::answer(UMockdevIoctlClient* client) {
    int result = -ENODEV;
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = files_.find(client); found != files_.end())
            result = found->second.control(client);
        refresh();
    }
    umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
}

} // namespace tactum::test
