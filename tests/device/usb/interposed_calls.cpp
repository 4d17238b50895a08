// The system calls and the functions of libudev that libusb uses, defined in the test program, which the
// linker asks first. Only libusb gets the emulated bus from them; everybody else gets the real ones.
#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "tests/device/usb/emulated_kernel.h"

using namespace tactum::test;

namespace {

constexpr long kSysfsMagic = 0x62656572;

/// Whether the code that `place` lies in is libusb's.
bool isLibusb(const void* place) {
    Dl_info info{};
    return dladdr(place, &info) && info.dli_fname && std::strstr(info.dli_fname, "libusb-1.0");
}

/// The definition that the linker would have taken without ours; null when there is none.
template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// As a system call: -1 and errno for a negative one.
int asCall(int result) {
    if (result >= 0) return result;
    errno = -result;
    return -1;
}

/// A file of sysfs with this text, which the caller closes as any other.
int openText(const Bytes& text) {
    if (text.empty()) return asCall(-ENOENT);
    const int file = memfd_create("sysfs", MFD_CLOEXEC);
    if (file < 0) return -1;
    (void)!write(file, text.data(), text.size());
    lseek(file, 0, SEEK_SET);
    return file;
}

/// nullopt: for the real one.
std::optional<int> openForLibusb(const char* path, const void* caller) {
    const std::string_view start(path);
    if (!start.starts_with("/dev/") && !start.starts_with("/sys/")) return std::nullopt;
    if (!isLibusb(caller)) return std::nullopt;
    if (const auto node = kernel::openNode(path)) return asCall(*node);
    if (const auto text = kernel::sysfsFile(path)) return openText(*text);
    return std::nullopt;
}

mode_t modeOf(int flags, va_list more) {
    const bool creates = (flags & O_CREAT) || (flags & O_TMPFILE) == O_TMPFILE;
    return creates ? static_cast<mode_t>(va_arg(more, int)) : 0;
}

} // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    if (const auto fake = openForLibusb(path, __builtin_return_address(0))) return *fake;
    va_list more;
    va_start(more, flags);
    const mode_t mode = modeOf(flags, more);
    va_end(more);
    static auto* const real = next<int(const char*, int, ...)>("open");
    return real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    if (const auto fake = openForLibusb(path, __builtin_return_address(0))) return *fake;
    va_list more;
    va_start(more, flags);
    const mode_t mode = modeOf(flags, more);
    va_end(more);
    static auto* const real = next<int(const char*, int, ...)>("open64");
    return real(path, flags, mode);
}

int __open_2(const char* path, int flags) {
    if (const auto fake = openForLibusb(path, __builtin_return_address(0))) return *fake;
    static auto* const real = next<int(const char*, int)>("__open_2");
    return real(path, flags);
}

int close(int descriptor) {
    if (kernel::isNode(descriptor)) kernel::closeNode(descriptor);
    static auto* const real = next<int(int)>("close");
    return real(descriptor);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
    va_list more;
    va_start(more, request);
    void* argument = va_arg(more, void*);
    va_end(more);
    if (kernel::isNode(descriptor)) return asCall(kernel::controlNode(descriptor, request, argument));
    static auto* const real = next<int(int, unsigned long, ...)>("ioctl");
    return real(descriptor, request, argument);
}

int poll(pollfd* fds, nfds_t count, int timeout) {
    for (nfds_t i = 0; i < count; ++i)
        if (kernel::isNode(fds[i].fd)) return asCall(kernel::pollNodes(fds, count, timeout));
    static auto* const real = next<int(pollfd*, nfds_t, int)>("poll");
    return real(fds, count, timeout);
}

int statfs(const char* path, struct statfs* answer) noexcept {
    static auto* const real = next<int(const char*, struct statfs*)>("statfs");
    if (std::strcmp(path, "/sys") != 0 || !isLibusb(__builtin_return_address(0))) return real(path, answer);
    *answer = {};
    answer->f_type = kSysfsMagic;
    return 0;
}

} // extern "C"

// ---- libudev. Its objects are ours from the making to the end, so that only what makes one has to look who
// asks.

struct udev {};
struct udev_monitor {
    std::shared_ptr<kernel::UdevMonitor> inner;
};
struct udev_list_entry {
    std::string name;
    udev_list_entry* after = nullptr;
};
struct udev_enumerate {
    std::deque<udev_list_entry> entries;
};
struct udev_device {
    kernel::UdevEvent event;
};

namespace {

const char kDevices[] = "/sys/bus/usb/devices/";

/// Calls the real libudev where it is loaded: Qt's plug-ins use it too. Nothing (0, null) without it.
template <class Answer, class... Arguments> Answer real(const char* name, Arguments... arguments) {
    auto* const function = next<Answer(Arguments...)>(name);
    if constexpr (!std::is_void_v<Answer>)
        return function ? function(arguments...) : Answer{};
    else if (function)
        function(arguments...);
}

} // namespace

#define FOR_OTHERS(...)                                                                                      \
    if (!isLibusb(__builtin_return_address(0))) return real<__VA_ARGS__>

extern "C" {

udev* udev_new() {
    FOR_OTHERS(udev*)("udev_new");
    return new udev;
}

udev* udev_unref(udev* all) {
    FOR_OTHERS(udev*)("udev_unref", all);
    delete all;
    return nullptr;
}

udev_monitor* udev_monitor_new_from_netlink(udev* all, const char* name) {
    FOR_OTHERS(udev_monitor*)("udev_monitor_new_from_netlink", all, name);
    return new udev_monitor{kernel::openMonitor()};
}

udev_monitor* udev_monitor_unref(udev_monitor* monitor) {
    FOR_OTHERS(udev_monitor*)("udev_monitor_unref", monitor);
    kernel::closeMonitor(monitor->inner.get());
    close(monitor->inner->descriptor);
    delete monitor;
    return nullptr;
}

int udev_monitor_filter_add_match_subsystem_devtype(udev_monitor* monitor, const char* system,
                                                    const char* kind) {
    FOR_OTHERS(int)("udev_monitor_filter_add_match_subsystem_devtype", monitor, system, kind);
    return 0;
}

int udev_monitor_enable_receiving(udev_monitor* monitor) {
    FOR_OTHERS(int)("udev_monitor_enable_receiving", monitor);
    return 0;
}

int udev_monitor_get_fd(udev_monitor* monitor) {
    FOR_OTHERS(int)("udev_monitor_get_fd", monitor);
    return monitor->inner->descriptor;
}

udev_device* udev_monitor_receive_device(udev_monitor* monitor) {
    FOR_OTHERS(udev_device*)("udev_monitor_receive_device", monitor);
    const auto event = kernel::nextEvent(*monitor->inner);
    return event ? new udev_device{*event} : nullptr;
}

udev_enumerate* udev_enumerate_new(udev* all) {
    FOR_OTHERS(udev_enumerate*)("udev_enumerate_new", all);
    return new udev_enumerate;
}

udev_enumerate* udev_enumerate_unref(udev_enumerate* list) {
    FOR_OTHERS(udev_enumerate*)("udev_enumerate_unref", list);
    delete list;
    return nullptr;
}

int udev_enumerate_add_match_subsystem(udev_enumerate* list, const char* system) {
    FOR_OTHERS(int)("udev_enumerate_add_match_subsystem", list, system);
    return 0;
}

int udev_enumerate_add_match_property(udev_enumerate* list, const char* name, const char* value) {
    FOR_OTHERS(int)("udev_enumerate_add_match_property", list, name, value);
    return 0;
}

int udev_enumerate_scan_devices(udev_enumerate* list) {
    FOR_OTHERS(int)("udev_enumerate_scan_devices", list);
    for (const std::string& name : kernel::deviceNames()) {
        list->entries.push_back({kDevices + name});
        const std::size_t count = list->entries.size();
        if (count > 1) list->entries[count - 2].after = &list->entries.back();
    }
    return 0;
}

udev_list_entry* udev_enumerate_get_list_entry(udev_enumerate* list) {
    FOR_OTHERS(udev_list_entry*)("udev_enumerate_get_list_entry", list);
    return list->entries.empty() ? nullptr : &list->entries.front();
}

udev_list_entry* udev_list_entry_get_next(udev_list_entry* entry) {
    FOR_OTHERS(udev_list_entry*)("udev_list_entry_get_next", entry);
    return entry->after;
}

const char* udev_list_entry_get_name(udev_list_entry* entry) {
    FOR_OTHERS(const char*)("udev_list_entry_get_name", entry);
    return entry->name.c_str();
}

udev_device* udev_device_new_from_syspath(udev* all, const char* path) {
    FOR_OTHERS(udev_device*)("udev_device_new_from_syspath", all, path);
    const std::string name = std::string(path).substr(sizeof kDevices - 1);
    return new udev_device{{"", name, kernel::nodeOf(name)}};
}

udev_device* udev_device_unref(udev_device* device) {
    FOR_OTHERS(udev_device*)("udev_device_unref", device);
    delete device;
    return nullptr;
}

const char* udev_device_get_devnode(udev_device* device) {
    FOR_OTHERS(const char*)("udev_device_get_devnode", device);
    return device->event.node.empty() ? nullptr : device->event.node.c_str();
}

const char* udev_device_get_sysname(udev_device* device) {
    FOR_OTHERS(const char*)("udev_device_get_sysname", device);
    return device->event.name.c_str();
}

const char* udev_device_get_action(udev_device* device) {
    FOR_OTHERS(const char*)("udev_device_get_action", device);
    return device->event.action.c_str();
}

} // extern "C"
