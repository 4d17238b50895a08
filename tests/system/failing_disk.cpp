#include "tests/system/failing_disk.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <map>
#include <memory>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using tactum::test::DiskFault;

/// What a power cut leaves of a file: so many bytes.
struct Written {
    int file;         ///< a descriptor of our own, which outlives the program's
    off_t onDisk = 0; ///< brought there by fsync
};

struct Disk {
    DiskFault fault;
    fs::path folder;
    std::vector<std::string> calls;
    std::map<ino_t, Written> written;
    std::map<std::string, int> names; ///< of the folder on the disk, each with a descriptor of its file
    bool signalled = false;           ///< the last call was interrupted
};

thread_local Disk* spoiled = nullptr; ///< null while it is healthy, and while we work ourselves

/// Our own calls are not counted.
class Healthy {
public:
    Healthy() : disk_(std::exchange(spoiled, nullptr)) {}
    ~Healthy() { spoiled = disk_; }
    Disk& operator*() const { return *disk_; }
    Disk* operator->() const { return disk_; }

private:
    Disk* disk_;
};

void bringNamesToDisk(Disk& disk) {
    for (const auto& [name, file] : disk.names)
        ::close(file);
    disk.names.clear();
    if (disk.folder.empty()) return;
    for (const auto& entry : fs::directory_iterator(disk.folder))
        if (entry.is_regular_file() && !entry.is_symlink())
            disk.names[entry.path().filename()] = ::open(entry.path().c_str(), O_RDWR | O_CLOEXEC);
}

/// The folder as it was when it was last brought to the disk; the files under those names keep their bytes.
void loseNames(const Disk& disk) {
    for (const auto& entry : fs::directory_iterator(disk.folder))
        if (entry.is_regular_file() && !entry.is_symlink()) fs::remove(entry.path());
    for (const auto& [name, file] : disk.names) {
        std::string bytes(std::size_t(lseek(file, 0, SEEK_END)), '\0');
        const bool read = ::pread(file, bytes.data(), bytes.size(), 0) == ssize_t(bytes.size());
        const int out = ::open((disk.folder / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        if (!read || ::write(out, bytes.data(), bytes.size()) != ssize_t(bytes.size())) _exit(1);
        ::close(out);
    }
}

void noteWritten(Disk& disk, int file) {
    struct stat now {};
    if (::fstat(file, &now) == 0 && !disk.written.contains(now.st_ino))
        disk.written[now.st_ino] = {::dup(file)};
}

void noteSynced(Disk& disk, int file) {
    struct stat now {};
    if (::fstat(file, &now) != 0) return;
    if (S_ISDIR(now.st_mode)) bringNamesToDisk(disk);
    if (const auto known = disk.written.find(now.st_ino); known != disk.written.end())
        known->second.onDisk = now.st_size;
}

bool isInterruptible(std::string_view call) {
    return call.starts_with("open") || call == "read" || call == "write" || call == "fsync";
}

/// How much of that is read or written by one call.
std::size_t atOnce(std::size_t count) {
    return spoiled && spoiled->fault.stutters ? std::min<std::size_t>(count, 1000) : count;
}

/// 0 when the call may go on, else its errno.
int judge(const char* name) {
    if (!spoiled) return 0;
    Disk& disk = *spoiled;
    const DiskFault& fault = disk.fault;
    const int call = int(disk.calls.size());
    disk.calls.emplace_back(name);
    if (fault.missing == name) return fault.missingError;
    if (fault.stutters && isInterruptible(name) && (disk.signalled = !disk.signalled)) return EINTR;
    using enum DiskFault::Kind;
    if (fault.kind == Stays && call >= fault.call) return fault.error;
    if (call != fault.call) return 0;
    if (fault.kind == Fails) return fault.error;
    if (fault.kind == Killed) kill(getpid(), SIGKILL);
    if (fault.kind == PowerCut) tactum::test::cutPower();
    return 0;
}

} // namespace

namespace tactum::test {

void spoilDisk(const DiskFault& fault, const fs::path& folder) {
    Disk* disk = new Disk{fault, folder, {}, {}, {}};
    bringNamesToDisk(*disk);
    spoiled = disk;
}

std::vector<std::string> healDisk() {
    const std::unique_ptr<Disk> disk(std::exchange(spoiled, nullptr));
    for (const auto& [inode, file] : disk->written)
        ::close(file.file);
    for (const auto& [name, file] : disk->names)
        ::close(file);
    return disk->calls;
}

void cutPower() {
    const Healthy disk;
    for (const auto& [inode, file] : disk->written)
        if (ftruncate(file.file, file.onDisk) != 0) _exit(1);
    if (!disk->fault.namesSurvive) loseNames(*disk);
    _exit(kPowerWasCut);
}

} // namespace tactum::test

// --- The calls ----------------------------------------------------------------------------------------

// Each asks judge() and goes on to the system's own.
#define NEXT(name) static const auto next = reinterpret_cast<decltype(&name)>(dlsym(RTLD_NEXT, #name))
#define JUDGED(words)                                                                                        \
    if (const int fault = judge(words)) return errno = fault, -1
#define INTERPOSE(name, parameters, arguments, exceptions)                                                   \
    int name parameters exceptions {                                                                         \
        NEXT(name);                                                                                          \
        JUDGED(#name);                                                                                       \
        return next arguments;                                                                               \
    }

extern "C" {

INTERPOSE(fchmod, (int f, mode_t m), (f, m), noexcept)
INTERPOSE(fchown, (int f, uid_t u, gid_t g), (f, u, g), noexcept)
INTERPOSE(renameat, (int a, const char* p, int b, const char* q), (a, p, b, q), noexcept)
INTERPOSE(unlinkat, (int d, const char* p, int f), (d, p, f), noexcept)
INTERPOSE(faccessat, (int d, const char* p, int m, int f), (d, p, m, f), noexcept)
INTERPOSE(fstatat, (int d, const char* p, struct stat* s, int f), (d, p, s, f), noexcept)
INTERPOSE(lstat, (const char* p, struct stat* s), (p, s), noexcept)

int linkat(int a, const char* p, int b, const char* q, int flags) noexcept {
    NEXT(linkat);
    JUDGED(flags & AT_SYMLINK_FOLLOW ? "linkat of nameless" : "linkat"); // the other is a second name
    return next(a, p, b, q, flags);
}

int openat(int folder, const char* path, int flags, ...) {
    NEXT(openat);
    JUDGED((flags & O_TMPFILE) == O_TMPFILE ? "openat of nameless" : "openat");
    va_list list;
    va_start(list, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
    va_end(list);
    return next(folder, path, flags, mode);
}

int open(const char* path, int flags, ...) {
    NEXT(open);
    JUDGED("open");
    va_list list;
    va_start(list, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
    va_end(list);
    return next(path, flags, mode);
}

ssize_t read(int file, void* bytes, std::size_t count) {
    NEXT(read);
    JUDGED("read");
    return next(file, bytes, atOnce(count));
}

ssize_t write(int file, const void* bytes, std::size_t count) {
    NEXT(write);
    JUDGED("write");
    if (spoiled) noteWritten(*Healthy(), file);
    return next(file, bytes, atOnce(count));
}

int fsync(int file) {
    NEXT(fsync);
    JUDGED("fsync");
    const int answer = next(file);
    if (spoiled && answer == 0) {
        const Healthy disk;
        noteSynced(*disk, file);
    }
    return answer;
}

int close(int file) {
    NEXT(close);
    const int fault = judge("close");
    const int answer = next(file); // Linux closes it, whatever it says
    return fault ? (errno = fault, -1) : answer;
}

} // extern "C"
