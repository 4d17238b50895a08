#include "core/base/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/realtime.h"

namespace tactum {

namespace {

namespace fs = std::filesystem;

// The folder is there and open, but is none of a disk, as /proc.
constexpr int kTakesNoFiles = ENOSYS;

// Inside this file a failed call travels as std::system_error; writeFileAtomically() catches it.
[[noreturn]] void fail(int number = errno) {
    throw std::system_error(number, std::generic_category());
}

/// Its answer; what a signal interrupted is called again.
template <class Call> auto retried(Call call) {
    auto answer = call();
    while (answer < 0 && errno == EINTR)
        answer = call();
    return answer;
}

/// The same of what has to succeed.
template <class Call> auto demanded(Call call) {
    const auto answer = retried(call);
    if (answer < 0) fail();
    return answer;
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    operator int() const { return number_; }
    /// Some file systems say only here that they had no room. Never twice: the number may be somebody else's
    /// then.
    void close() {
        if (::close(std::exchange(number_, -1)) != 0 && errno != EINTR) fail();
    }

private:
    int number_;
};

/// Calls with names that nobody else has until one is free, and gives it back.
template <class Call> std::string withFreeName(Call call) {
    static std::atomic<unsigned> count{0};
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::string name = ".tactum-" + std::to_string(getpid()) + '-' + std::to_string(count++);
        if (retried([&] { return call(name.c_str()); }) >= 0) return name;
        if (errno != EEXIST) fail();
    }
    fail(EEXIST);
}

/// A name in a folder that goes when its owner does, unless it became another one before. (It goes then too:
/// where both were names of one file, a rename leaves them as they are.)
class TemporaryName {
public:
    TemporaryName(int folder, std::string name) : folder_(folder), name_(std::move(name)) {}
    TemporaryName(TemporaryName&& other) noexcept
        : folder_(other.folder_), name_(std::exchange(other.name_, {})) {}
    TemporaryName& operator=(TemporaryName&&) = delete;
    ~TemporaryName() {
        if (!name_.empty()) unlinkat(folder_, name_.c_str(), 0);
    }
    void become(const std::string& name) {
        demanded([&] { return renameat(folder_, name_.c_str(), folder_, name.c_str()); });
    }

private:
    int folder_;
    std::string name_;
};

void writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = demanded([&] { return write(file, bytes.data(), bytes.size()); });
        if (written == 0) fail(EIO);
        bytes.remove_prefix(std::size_t(written));
    }
}

std::string readAll(int file) {
    std::string bytes;
    std::string part(1 << 20, '\0');
    while (const ssize_t count = demanded([&] { return read(file, part.data(), part.size()); }))
        bytes.append(part, 0, std::size_t(count));
    return bytes;
}

bool isUnsupported(int number) {
    return number == EPERM || number == EOPNOTSUPP || number == ENOSYS || number == EINVAL;
}

/// Owner and permissions, as far as this person may and the disk can.
void takeAfter(int file, const struct stat& old) {
    const auto attempted = [](auto call) {
        const bool done = retried(call) == 0;
        if (!done && !isUnsupported(errno)) fail();
        return done;
    };
    if (!attempted([&] { return fchown(file, old.st_uid, old.st_gid); }))
        attempted([&] { return fchown(file, uid_t(-1), old.st_gid); });
    attempted([&] { return fchmod(file, old.st_mode & 07777); }); // last: a new owner takes the set-id bits
}

/// The bytes as a file of the folder, safe on the disk. It has no name until it is complete, so that a
/// program that is killed leaves nothing; where the disk knows no such files, it has one from the beginning.
TemporaryName written(int folder, std::string_view bytes, const std::optional<struct stat>& old) {
    const mode_t mode = old ? 0600 : 0666; // until it is complete nobody sees more than before
    const int flags = O_WRONLY | O_CLOEXEC;
    std::optional<TemporaryName> name;
    int number = retried([&] { return openat(folder, ".", flags | O_TMPFILE, mode); });
    if (number < 0 && (isUnsupported(errno) || errno == EISDIR))
        name.emplace(folder, withFreeName([&](const char* free) {
                         number = openat(folder, free, flags | O_CREAT | O_EXCL, mode);
                         if (number < 0 && errno == ENOENT) errno = kTakesNoFiles;
                         return number;
                     }));
    if (number < 0) fail(errno == ENOENT ? kTakesNoFiles : errno);
    Descriptor file(number);
    writeAll(file, bytes);
    if (old) takeAfter(file, *old);
    demanded([&] { return fsync(file); });
    if (!name) {
        const std::string unnamed = "/proc/self/fd/" + std::to_string(file);
        name.emplace(folder, withFreeName([&](const char* free) {
                         return linkat(AT_FDCWD, unnamed.c_str(), folder, free, AT_SYMLINK_FOLLOW);
                     }));
    }
    file.close();
    return std::move(*name);
}

/// A second name for the file, or a copy of it where a file can have only one.
TemporaryName secondName(int folder, const char* file, const struct stat& old) {
    try {
        return {folder,
                withFreeName([&](const char* free) { return linkat(folder, file, folder, free, 0); })};
    } catch (const std::system_error& fault) {
        if (!isUnsupported(fault.code().value()) && fault.code().value() != EMLINK) throw;
    }
    const Descriptor now(demanded([&] { return openat(folder, file, O_RDONLY | O_CLOEXEC | O_NOFOLLOW); }));
    return written(folder, readAll(now), old);
}

/// scene.glb2 becomes scene.glb3 and so on; scene.glb1 is free then, or may be replaced.
void makeBackupsOlder(int folder, const std::string& file, int backups) {
    for (int age = backups - 1; age >= 1; --age) {
        const std::string from = backupOf(file, age), to = backupOf(file, age + 1);
        if (retried([&] { return renameat(folder, from.c_str(), folder, to.c_str()); }) < 0 &&
            errno != ENOENT)
            fail();
    }
}

/// Where the links lead, whether or not there is a file.
fs::path followed(fs::path file) {
    for (int links = 0; fs::is_symlink(fs::symlink_status(file)); ++links) {
        if (links == 40) fail(ELOOP);
        file = file.parent_path() / fs::read_symlink(file);
    }
    return file;
}

/// What is to be replaced, if there is anything. A file that nobody may write is not, though the folder would
/// allow it: somebody made it so on purpose.
std::optional<struct stat> replaceable(int folder, const char* file) {
    struct stat old {};
    if (retried([&] { return fstatat(folder, file, &old, AT_SYMLINK_NOFOLLOW); }) < 0) {
        if (errno == ENOENT) return std::nullopt;
        fail();
    }
    if (S_ISDIR(old.st_mode)) fail(EISDIR);
    if (!S_ISREG(old.st_mode)) fail(ENOTSUP);
    if ((old.st_mode & 0222) == 0) fail(EACCES);
    demanded([&] { return faccessat(folder, file, W_OK, AT_EACCESS); });
    return old;
}

void replace(const fs::path& target, std::string_view bytes, int backups, bool& replaced) {
    const fs::path parent = target.has_parent_path() ? target.parent_path() : ".";
    const std::string name = target.filename();
    if (name.empty()) fail(EISDIR);
    Descriptor folder(demanded([&] { return open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
    const std::optional<struct stat> old = replaceable(folder, name.c_str());
    // Held until the end: a large file takes its time to go, and who is killed meanwhile leaves temporary
    // names.
    const std::string oldestName = backupOf(name, backups);
    const Descriptor oldest(backups > 0 ? openat(folder, oldestName.c_str(), O_PATH | O_CLOEXEC) : -1);
    TemporaryName fresh = written(folder, bytes, old);
    if (old && backups > 0) {
        TemporaryName last = secondName(folder, name.c_str(), *old);
        makeBackupsOlder(folder, name, backups);
        last.become(backupOf(name, 1));
    }
    fresh.become(name);
    replaced = true;
    if (retried([&] { return fsync(folder); }) < 0 && !isUnsupported(errno)) fail();
}

const char* remedy(int number) {
    switch (number) {
    case ENOSPC:
    case EDQUOT:
        return "make room on the disk";
    case EACCES:
    case EPERM:
        return "check the permissions of the file and its folder";
    case EROFS:
        return "choose another disk";
    case ENOENT:
    case ENOTDIR:
        return "check the folder";
    case kTakesNoFiles:
        return "choose another folder";
    case EISDIR:
    case ENOTSUP:
    case ENAMETOOLONG:
        return "choose another name";
    default:
        return "check the disk, or choose another one";
    }
}

std::string reason(int number) {
    if (number == EISDIR) return "it is a folder";
    if (number == kTakesNoFiles) return "its folder takes no files";
    if (number == ENOTSUP) return "it is no ordinary file";
    return std::generic_category().message(number);
}

} // namespace

fs::path backupOf(const fs::path& file, int age) {
    return file.native() + std::to_string(age);
}

Result<void> writeFileAtomically(const fs::path& file, std::string_view bytes, int backups) {
    assertNotRealtime();
    bool replaced = false;
    try {
        replace(followed(file), bytes, backups, replaced);
        return {};
    } catch (const std::system_error& fault) {
        const int number = fault.code().value();
        return machineError(
            file.string() +
            (replaced ? ": was written, but may not outlive a power cut: " : ": cannot be written: ") +
            reason(number) + "; " + remedy(number));
    }
}

} // namespace tactum
