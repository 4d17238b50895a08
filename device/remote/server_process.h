// The process in which a device's driver runs, as the program sees it: started, listened to, ended.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "device/remote/wire.h"

namespace tactum {

/// Thread of its members: one at a time and not real time, where they do not say otherwise.
class ServerProcess {
public:
    /// `arguments`: what follows the program's name.
    ServerProcess(std::filesystem::path program, std::vector<std::string> arguments);
    /// Lets it end by itself, and kills it when it does not.
    ~ServerProcess();
    ServerProcess(const ServerProcess&) = delete;
    ServerProcess& operator=(const ServerProcess&) = delete;

    /// Starts it anew, with a block as new.
    Result<void> start();
    /// Nothing comes from it any more: it is killed if need be.
    void kill();

    bool send(const wire::Packet& packet) const { return wire::send(talk_, packet); }
    wire::News receive(int patience, wire::Packet& packet) const {
        return wire::receive(talk_, patience, packet);
    }

    /// The same at any time after start(). Thread: any.
    wire::Block* block() const noexcept { return block_; }
    /// Whether it runs. Thread: any but real time, any number.
    bool runs() const;
    /// Why it does not, a sentence. Thread: as runs().
    std::string howItEnded() const;

private:
    Result<void> makeBlock();
    int spawn(int talk);
    bool hasEnded(int options) const;
    void end();

    std::filesystem::path program_;
    std::vector<std::string> arguments_;
    wire::Block* block_ = nullptr;
    int memory_ = -1, talk_ = -1; ///< descriptors

    mutable std::mutex mutex_; ///< of the two below
    mutable pid_t pid_ = -1;
    mutable int status_ = 0; ///< of waitpid, when pid_ is gone
};

} // namespace tactum
