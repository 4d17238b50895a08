#include "tests/realtime/interposer.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <dlfcn.h>
#include <execinfo.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "core/base/realtime.h"

// The C library's own allocator. Finding it by dlsym would not do: dlsym allocates.
extern "C" {
void* __libc_malloc(std::size_t size);
void __libc_free(void* memory);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

constexpr int kDepth = 24;

std::atomic<std::uint64_t> hitCount{0};
std::atomic<const char*> firstName{nullptr};
void* frames[kDepth];
int frameCount = 0;
thread_local bool noting = false; ///< taking the backtrace may itself allocate

void note(const char* name) noexcept {
    if (!tactum::insideRealtime() || noting) return;
    ++hitCount;
    const char* none = nullptr;
    if (!firstName.compare_exchange_strong(none, name)) return;
    noting = true;
    frameCount = backtrace(frames, kDepth);
    noting = false;
}

} // namespace

namespace tactum::interposer {

void reset() {
    hitCount = 0;
    firstName = nullptr;
}

std::uint64_t hits() {
    return hitCount;
}

std::string firstHit() {
    const char* name = firstName;
    if (!name) return "none";
    std::string text = name;
    char** symbols = backtrace_symbols(frames, frameCount);
    for (int i = 0; symbols && i < frameCount; ++i)
        text += std::string("\n    ") + symbols[i];
    std::free(symbols);
    return text;
}

} // namespace tactum::interposer

// --- Allocation ---------------------------------------------------------------------------------------
// operator new and delete, and everything of Qt and the standard library, end in these.

extern "C" {

void* malloc(std::size_t size) noexcept {
    note("malloc");
    return __libc_malloc(size);
}

void free(void* memory) noexcept {
    note("free");
    __libc_free(memory);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
    note("calloc");
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
    note("realloc");
    return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
    note("memalign");
    return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    note("aligned_alloc");
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    note("posix_memalign");
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}

// --- Locks and waits ----------------------------------------------------------------------------------

#define INTERPOSE(name, parameters, arguments, exceptions)                                                   \
    int name parameters exceptions {                                                                         \
        static const auto next = reinterpret_cast<decltype(&name)>(dlsym(RTLD_NEXT, #name));                 \
        note(#name);                                                                                         \
        return next arguments;                                                                               \
    }

INTERPOSE(pthread_mutex_lock, (pthread_mutex_t * m), (m), noexcept)
INTERPOSE(pthread_mutex_trylock, (pthread_mutex_t * m), (m), noexcept)
INTERPOSE(pthread_mutex_timedlock, (pthread_mutex_t * m, const timespec* t), (m, t), noexcept)
INTERPOSE(pthread_mutex_unlock, (pthread_mutex_t * m), (m), noexcept)
INTERPOSE(pthread_spin_lock, (pthread_spinlock_t * s), (s), noexcept)
INTERPOSE(pthread_rwlock_rdlock, (pthread_rwlock_t * l), (l), noexcept)
INTERPOSE(pthread_rwlock_wrlock, (pthread_rwlock_t * l), (l), noexcept)
INTERPOSE(pthread_rwlock_tryrdlock, (pthread_rwlock_t * l), (l), noexcept)
INTERPOSE(pthread_rwlock_trywrlock, (pthread_rwlock_t * l), (l), noexcept)
INTERPOSE(pthread_rwlock_timedrdlock, (pthread_rwlock_t * l, const timespec* t), (l, t), noexcept)
INTERPOSE(pthread_rwlock_timedwrlock, (pthread_rwlock_t * l, const timespec* t), (l, t), noexcept)
INTERPOSE(pthread_cond_wait, (pthread_cond_t * c, pthread_mutex_t* m), (c, m), )
INTERPOSE(pthread_cond_timedwait, (pthread_cond_t * c, pthread_mutex_t* m, const timespec* t), (c, m, t), )
INTERPOSE(pthread_cond_clockwait, (pthread_cond_t * c, pthread_mutex_t* m, clockid_t k, const timespec* t),
          (c, m, k, t), )
INTERPOSE(pthread_cond_signal, (pthread_cond_t * c), (c), noexcept)
INTERPOSE(pthread_cond_broadcast, (pthread_cond_t * c), (c), noexcept)
INTERPOSE(pthread_join, (pthread_t t, void** r), (t, r), )
INTERPOSE(sem_wait, (sem_t * s), (s), )
INTERPOSE(sem_trywait, (sem_t * s), (s), noexcept)
INTERPOSE(sem_timedwait, (sem_t * s, const timespec* t), (s, t), )
INTERPOSE(sem_post, (sem_t * s), (s), noexcept)
INTERPOSE(nanosleep, (const timespec* t, timespec* r), (t, r), )
INTERPOSE(clock_nanosleep, (clockid_t k, int f, const timespec* t, timespec* r), (k, f, t, r), )
INTERPOSE(usleep, (useconds_t t), (t), )
INTERPOSE(sched_yield, (), (), noexcept)

// --- Text and blocking calls --------------------------------------------------------------------------

#define INTERPOSE_AS(type, name, parameters, arguments, exceptions)                                          \
    type name parameters exceptions {                                                                        \
        static const auto next = reinterpret_cast<type(*) parameters>(dlsym(RTLD_NEXT, #name));              \
        note(#name);                                                                                         \
        return next arguments;                                                                               \
    }

INTERPOSE_AS(ssize_t, write, (int f, const void* b, std::size_t n), (f, b, n), )
INTERPOSE_AS(ssize_t, read, (int f, void* b, std::size_t n), (f, b, n), )
INTERPOSE_AS(std::size_t, fwrite, (const void* b, std::size_t s, std::size_t n, FILE* f), (b, s, n, f), )
INTERPOSE(fputs, (const char* s, FILE* f), (s, f), )
INTERPOSE(puts, (const char* s), (s), )
INTERPOSE(vfprintf, (FILE * f, const char* s, va_list a), (f, s, a), )
INTERPOSE(vsnprintf, (char* b, std::size_t n, const char* s, va_list a), (b, n, s, a), noexcept)
INTERPOSE(poll, (pollfd * f, nfds_t n, int t), (f, n, t), )
INTERPOSE(munmap, (void* m, std::size_t n), (m, n), noexcept)
INTERPOSE_AS(void*, mmap, (void* m, std::size_t n, int p, int f, int d, off_t o), (m, n, p, f, d, o),
             noexcept)

int fprintf(FILE* file, const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int written = vfprintf(file, format, list);
    va_end(list);
    return written;
}

int printf(const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int written = vfprintf(stdout, format, list);
    va_end(list);
    return written;
}

int snprintf(char* buffer, std::size_t room, const char* format, ...) noexcept {
    va_list list;
    va_start(list, format);
    const int written = vsnprintf(buffer, room, format, list);
    va_end(list);
    return written;
}

int ioctl(int file, unsigned long request, ...) noexcept {
    static const auto next = reinterpret_cast<int (*)(int, unsigned long, ...)>(dlsym(RTLD_NEXT, "ioctl"));
    note("ioctl");
    va_list list;
    va_start(list, request);
    void* argument = va_arg(list, void*);
    va_end(list);
    return next(file, request, argument);
}

// std::atomic::wait and Qt's mutexes call the kernel's futex without any of the functions above.
long syscall(long number, ...) noexcept {
    static const auto next = reinterpret_cast<decltype(&syscall)>(dlsym(RTLD_NEXT, "syscall"));
    if (number == SYS_futex) note("futex");
    va_list list;
    va_start(list, number);
    long a[6];
    for (long& argument : a)
        argument = va_arg(list, long);
    va_end(list);
    return next(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

} // extern "C"
