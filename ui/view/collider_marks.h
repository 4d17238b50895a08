// As what bodies meet each other, drawn over the model: edges of hulls and boxes, outlines of what is round.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/scene/scene.h"
#include "ui/base/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// One collider.
struct ColliderMark {
    ObjectId carrier = 0;                 ///< an object that it moves with; 0: it stands still
    std::vector<std::vector<Vec3>> lines; ///< frame of the carrier, or world

    bool operator==(const ColliderMark&) const = default;
};

/// Of all but planes. Thread: any but real time.
std::vector<ColliderMark> colliderMarks(const Scene& scene);

/// Where an object is now, X_WB; nothing for one that is hidden.
using PlaceOfObject = std::function<std::optional<Pose>(ObjectId)>;
/// Thread: ui.
void drawColliders(QPainter& painter, const std::vector<ColliderMark>& marks, const PlaceOfObject& placeOf,
                   const ViewCamera& camera, const Theme& theme);

} // namespace tactum
