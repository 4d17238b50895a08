// Landlock for the files, seccomp for everything else that a system call can do.
#include "core/import/worker/sandbox.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/base/text.h"
#include "core/files/beside.h"

namespace tactum {
namespace {

// --- Landlock: which files -------------------------------------------------------------------------------

constexpr std::uint64_t kReading = LANDLOCK_ACCESS_FS_READ_FILE;

/// All that this kernel can forbid, by the version of its interface: 13 rights, and those that came later.
std::uint64_t rightsOf(long version) {
    const std::uint64_t first = (std::uint64_t(1) << 13) - 1, refer = 1 << 13, truncate = 1 << 14,
                        devices = 1 << 15;
    return first | (version >= 2 ? refer : 0) | (version >= 3 ? truncate : 0) | (version >= 5 ? devices : 0);
}

void allow(int rules, const std::filesystem::path& place, std::uint64_t rights) {
    const int opened = open(place.c_str(), O_PATH | O_CLOEXEC);
    if (opened < 0) return;
    landlock_path_beneath_attr rule{};
    rule.allowed_access = rights;
    rule.parent_fd = opened;
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(opened);
}

/// What the file may name, and no more of the folder, which may be the person's home. Hidden folders and
/// links are none of its business.
std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& file) {
    constexpr int kDeepest = 3, kMostLooks = 20000;
    constexpr std::size_t kMostFiles = 4000;
    const std::vector<std::string_view> endings = endingsBeside(file);
    std::vector<std::filesystem::path> found;
    if (endings.empty()) return found;
    std::error_code fault;
    using Walk = std::filesystem::recursive_directory_iterator;
    int looks = 0;
    for (Walk at(file.has_parent_path() ? file.parent_path() : ".",
                 std::filesystem::directory_options::skip_permission_denied, fault);
         !fault && at != Walk() && found.size() < kMostFiles && ++looks < kMostLooks; at.increment(fault)) {
        std::error_code unknown;
        const auto kind = at->symlink_status(unknown).type();
        const std::string name = at->path().filename().string(),
                          ending = lowerCase(at->path().extension().string());
        if (kind == std::filesystem::file_type::directory &&
            (name.starts_with('.') || at.depth() >= kDeepest))
            at.disable_recursion_pending();
        if (kind == std::filesystem::file_type::regular && ending.size() > 1 &&
            std::ranges::find(endings, std::string_view(ending).substr(1)) != endings.end())
            found.push_back(at->path());
    }
    return found;
}

bool allowOnly(const std::filesystem::path& file) {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, std::size_t(0), LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) return false;
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = rightsOf(version);
    const int rules = int(syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes, 0));
    if (rules < 0) return false;
    allow(rules, file, kReading); // it may be a link that leads out of the folder
    for (const std::filesystem::path& beside : filesBeside(file))
        allow(rules, beside, kReading);
    const bool done = syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    close(rules);
    return done;
}

// --- seccomp: which calls --------------------------------------------------------------------------------

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0; // unknown: without seccomp
#endif

/// Calls that are harmless whatever their arguments are.
constexpr long kHarmless[] = {
    SYS_read,
    SYS_pread64,
    SYS_readv,
    SYS_write,
    SYS_writev,
    SYS_close,
    SYS_fstat,
    SYS_newfstatat,
    SYS_statx,
    SYS_lseek,
    SYS_faccessat,
#ifdef SYS_faccessat2
    SYS_faccessat2, // without it the folder "." is not found, and with it nothing that lies in it
#endif
    SYS_readlinkat,
    SYS_getcwd,
    SYS_getdents64,
    SYS_munmap,
    SYS_mremap,
    SYS_madvise,
    SYS_brk,
    SYS_futex,
    SYS_set_robust_list,
    SYS_rt_sigaction,
    SYS_rt_sigreturn,
    SYS_rt_sigprocmask,
    SYS_sigaltstack,
    SYS_exit,
    SYS_exit_group,
    SYS_getpid,
    SYS_gettid,
    SYS_clock_gettime,
    SYS_clock_nanosleep,
    SYS_nanosleep,
    SYS_gettimeofday,
    SYS_sched_yield,
    SYS_getrandom,
    SYS_sched_getaffinity,
    SYS_sysinfo,
    SYS_getrusage,
    SYS_set_tid_address,
#ifdef SYS_rseq
    SYS_rseq,
#endif
#ifdef SYS_open // older names of the above, of some machines only
    SYS_stat,
    SYS_lstat,
    SYS_access,
    SYS_readlink,
#endif
};

/// A filter is a small program: each rule answers a call or falls through to the next one.
class Filter {
public:
    void step(std::uint16_t code, std::uint32_t value, std::uint8_t then = 0, std::uint8_t otherwise = 0) {
        steps_.push_back({code, then, otherwise, value});
    }
    void answer(std::uint32_t with) { step(BPF_RET | BPF_K, with); }
    static std::uint32_t refusal(int code) { return SECCOMP_RET_ERRNO | std::uint32_t(code); }
    void load(std::size_t offset) { step(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(offset)); }

    void answer(long call, std::uint32_t with) {
        step(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 1);
        answer(with);
    }
    /// Allowed when the low half of an argument, masked, is `wanted`.
    void allowIf(long call, int argument, std::uint32_t mask, std::uint32_t wanted) {
        step(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 5);
        load(offsetof(seccomp_data, args) + 8 * std::size_t(argument));
        step(BPF_ALU | BPF_AND | BPF_K, mask);
        step(BPF_JMP | BPF_JEQ | BPF_K, wanted, 0, 1);
        answer(SECCOMP_RET_ALLOW);
        answer(refusal(EPERM));
    }

    bool install() {
        const sock_fprog program{static_cast<unsigned short>(steps_.size()), steps_.data()};
        return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
    }

private:
    std::vector<sock_filter> steps_;
};

bool allowOnlyReading() {
    if (kMachine == 0) return false;
    constexpr std::uint32_t kWriting = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;
    Filter filter;
    filter.load(offsetof(seccomp_data, arch));
    filter.step(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0);
    filter.answer(SECCOMP_RET_KILL_PROCESS);
    filter.load(offsetof(seccomp_data, nr));
    for (const long call : kHarmless)
        filter.answer(call, SECCOMP_RET_ALLOW);
    filter.allowIf(SYS_openat, 2, kWriting, O_RDONLY);
#ifdef SYS_open
    filter.allowIf(SYS_open, 1, kWriting, O_RDONLY);
#endif
    filter.allowIf(SYS_mmap, 2, PROT_EXEC, 0);
    filter.allowIf(SYS_mprotect, 2, PROT_EXEC, 0);
    filter.allowIf(SYS_clone, 0, CLONE_THREAD, CLONE_THREAD);
    filter.allowIf(SYS_tgkill, 0, ~std::uint32_t(0), std::uint32_t(getpid())); // abort()
    filter.allowIf(SYS_fcntl, 1, ~std::uint32_t(0), F_GETFL);
    filter.answer(SYS_clone3, Filter::refusal(ENOSYS)); // its flags cannot be seen; glibc then uses clone
    filter.answer(Filter::refusal(EPERM));
    return filter.install();
}

} // namespace

std::vector<std::string> enterSandbox(const std::filesystem::path& file) {
    std::vector<std::string> lacks;
    prctl(PR_SET_DUMPABLE, 0);
    const bool alone = prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    if (alone) return lacks; // sanitizers do much at the end that would be refused
#endif
    if (!alone || !allowOnly(file)) lacks.emplace_back("Landlock");
    if (!alone || !allowOnlyReading()) lacks.emplace_back("seccomp");
    return lacks;
}

} // namespace tactum
