// Meshes and files on their way in: gathered within bounds, judged as any file is, kept until their client is
// gone.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/base/progress.h"
#include "core/files/load_scene.h"
#include "core/protocol/messages.h"
#include "core/session/attendance.h"

namespace tactum {

struct UploadLimits {
    std::size_t one = std::size_t(2) << 30; ///< bytes of an upload
    std::size_t all = std::size_t(4) << 30; ///< bytes of all that are under way
    std::size_t kept = 16;                  ///< of a client; the oldest goes
};

/// What came in, by client and number. Thread: any but real time, several at once.
class Uploads {
public:
    explicit Uploads(UploadLimits limits = {}) : limits_(limits) {}

    std::uint64_t keep(ClientId client, LoadedScene loaded);
    /// Null when there is none.
    std::shared_ptr<const LoadedScene> find(ClientId client, std::uint64_t number) const;
    void forget(ClientId client);

private:
    friend class Incoming;
    struct Kept {
        std::uint64_t number = 0;
        std::shared_ptr<const LoadedScene> loaded;
    };

    UploadLimits limits_;
    std::atomic<std::size_t> underWay_{0};
    mutable std::mutex mutex_;
    std::uint64_t last_ = 0;
    std::map<ClientId, std::deque<Kept>> kept_;
};

/// One upload as it comes in. Its memory is what has come, whatever its head says. Thread: one at a time.
class Incoming {
public:
    /// What SceneParts::read() makes of the bytes of a scene.
    using SceneOf = std::function<Result<Scene>(std::string_view)>;

    Incoming(Uploads& uploads, SceneOf sceneOf) : uploads_(uploads), sceneOf_(std::move(sceneOf)) {}
    ~Incoming();
    Incoming(const Incoming&) = delete;
    Incoming& operator=(const Incoming&) = delete;

    /// Errors: a head that cannot be, or that asks for too much.
    Result<void> begin(const v1::UploadHead& head);
    Result<void> add(std::string_view bytes);
    std::size_t received() const { return bytes_.size(); }
    bool complete() const { return bytes_.size() == head_.size(); }
    /// Of all its bytes. A file is read by the import process; a mesh is checked here by the same rules.
    Result<LoadedScene> read(const Progress& progress);

private:
    Uploads& uploads_;
    SceneOf sceneOf_;
    v1::UploadHead head_;
    std::string bytes_;
};

/// The bytes of a mesh as MeshHead describes them; a head that does not fit them is refused. `bytes` may be
/// anything.
Result<TriangleSoup> meshOf(const v1::MeshHead& head, std::string_view bytes);

} // namespace tactum
