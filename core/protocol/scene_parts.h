// Whole scenes as clients send them and fetch them: what both sides have already is only named.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "core/base/result.h"
#include "core/scene/known_parts.h"

namespace tactum {

/// The parts of the scene that is felt, looked at once. Thread: any but real time, several at once.
class SceneParts {
public:
    /// Of a scene on its way to `base`: what it only names is there. Errors: bytes that no scene can have; a
    /// part that is not there.
    Result<Scene> read(std::string_view bytes, const Scene& base);

private:
    std::shared_ptr<const KnownParts> of(const Scene& scene);

    std::mutex mutex_;
    std::shared_ptr<const KnownParts> known_ = std::make_shared<const KnownParts>();
};

} // namespace tactum
