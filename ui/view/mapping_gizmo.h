// The frame of a texture's mapping in the view: drawn over the model, and dragged by its handles.
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QPolygonF>

#include "core/surface/texture_layer.h"
#include "ui/theme.h"
#include "ui/view/view_camera.h"

class QPainter;

namespace tactum {

/// What of a mapping has a place in the world.
struct MappingFrame {
    TextureMapping mapping = TextureMapping::Triplanar; ///< one that needs no texture coordinates
    Pose pose;                                          ///< X_WM
    double size = kTextureSize.initial;                 ///< m
    double proportion = 1;                              ///< height of a repeat by its width
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();   ///< m
    double rotation = 0;                                ///< rad
    double radius = kTextureRadius.initial;             ///< m, of Cylindrical and Spherical

    bool operator==(const MappingFrame&) const = default;
};

enum class MappingHandle { Size, Radius, Move, MoveX, MoveY, MoveZ, TurnX, TurnY, TurnZ };

/// Arrows move, rings turn, the square at the corner of a repeat scales it, the dot on the circle sets the
/// radius. As large on the screen from any distance. Knows no widget; pixels are logical. Thread: ui.
class MappingGizmo {
public:
    /// Nothing: nothing is drawn and nothing can be grabbed. A drag goes on from where it began.
    void show(const std::optional<MappingFrame>& frame) { frame_ = frame; }
    const std::optional<MappingFrame>& frame() const { return frame_; }

    /// What lies under the cursor.
    std::optional<MappingHandle> at(QPointF cursor, const ViewCamera& camera) const;
    /// Where on the screen a handle can be grabbed; nothing for one that is not there or behind the eye.
    std::optional<QPointF> placeOf(MappingHandle handle, const ViewCamera& camera) const;

    void grab(MappingHandle handle, QPointF cursor);
    /// The frame where the cursor leads it.
    MappingFrame dragged(QPointF cursor, const ViewCamera& camera) const;
    void letGo() { held_.reset(); }
    bool held() const { return held_.has_value(); }

    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const;

private:
    struct Grip {
        MappingHandle handle;
        QPointF from;
        MappingFrame frame; ///< when it was taken
    };
    std::vector<MappingHandle> handles() const;

    std::optional<MappingFrame> frame_;
    std::optional<Grip> held_;
};

} // namespace tactum
