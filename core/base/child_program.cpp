#include "core/base/child_program.h"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

namespace tactum {
namespace {

class Files {
public:
    explicit Files(const ChildProgram& program) {
        posix_spawn_file_actions_init(&actions_);
        for (const int standard : program.silent)
            posix_spawn_file_actions_addopen(&actions_, standard, "/dev/null", O_RDWR, 0);
        int last = STDERR_FILENO;
        for (const auto& [ours, there] : program.descriptors) {
            posix_spawn_file_actions_adddup2(&actions_, ours, there);
            last = std::max(last, there);
        }
        posix_spawn_file_actions_addclosefrom_np(&actions_, last + 1);
    }
    ~Files() { posix_spawn_file_actions_destroy(&actions_); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

class Attributes {
public:
    explicit Attributes(bool apart) {
        posix_spawnattr_init(&attributes_);
        sigset_t signals;
        sigemptyset(&signals);
        posix_spawnattr_setsigmask(&attributes_, &signals);
        sigfillset(&signals);
        posix_spawnattr_setsigdefault(&attributes_, &signals);
        const int flags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | (apart ? POSIX_SPAWN_SETSID : 0);
        posix_spawnattr_setflags(&attributes_, short(flags));
    }
    ~Attributes() { posix_spawnattr_destroy(&attributes_); }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

} // namespace

int startChild(ChildProgram program, pid_t& child) {
    std::string name = program.program.string();
    std::vector<char*> words{name.data()};
    for (std::string& argument : program.arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    if (program.environment) program.environment->push_back(nullptr);
    const Files files(program);
    const Attributes attributes(program.apart);
    return posix_spawn(&child, name.c_str(), files.get(), attributes.get(), words.data(),
                       program.environment ? program.environment->data() : environ);
}

std::filesystem::path programBeside(const std::string& name) {
    std::error_code fault;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", fault).parent_path();
    if (fault) return {};
    for (const auto& program : {folder / name, folder / "../libexec/tactum" / name})
        if (std::filesystem::exists(program, fault)) return program;
    return {};
}

} // namespace tactum
