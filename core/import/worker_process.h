// One import process as the program holds it: started, limited, listened to, ended. For this folder only.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "core/import/import_scene.h"

namespace tactum {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor();
    int number() const { return number_; }
    bool open() const { return number_ >= 0; }

private:
    int number_;
};

/// Ends its process at the latest when it is destroyed, without waiting for the machine to take the memory
/// back.
class WorkerProcess {
public:
    /// Starts `worker FILE` under the limits.
    static Result<WorkerProcess> start(const std::filesystem::path& worker, const std::filesystem::path& file,
                                       const ImportLimits& limits);
    WorkerProcess(WorkerProcess&& other) noexcept;
    ~WorkerProcess();

    enum class Heard { Nothing, Packet, Silence };
    /// Waits a moment. Silence: it has closed its end, so it is dead or as good as dead.
    Heard listen(std::string& packet);
    /// The first `size` bytes of the scene, which nobody can change any more; empty when they are not there.
    std::string_view scene(std::uint64_t size);
    /// Kills it if need be and waits for its end: why it stopped, for the brackets of a sentence.
    std::string whyItStopped();

private:
    WorkerProcess() = default;
    void unmap();

    pid_t child_ = -1;
    ImportLimits limits_;
    Descriptor talk_, memory_;
    void* mapped_ = nullptr;
    std::size_t mappedSize_ = 0;
};

} // namespace tactum
