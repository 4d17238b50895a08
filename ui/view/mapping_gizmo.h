// The frame of a texture's mapping in the view: drawn over the model, and dragged by its handles.
#pragma once

#include <optional>

#include "core/surface/texture_layer.h"
#include "ui/view/handles.h"

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
/// radius. As large on the screen from any distance. Knows no widget. Thread: ui.
class MappingGizmo : public HandlesOf<MappingHandle, MappingFrame> {
public:
    const std::optional<MappingFrame>& frame() const { return shown(); }

    /// Where on the screen a handle can be grabbed; nothing for one that is not there or behind the eye.
    std::optional<QPointF> placeOf(MappingHandle handle, const ViewCamera& camera) const;
    /// The frame where the cursor leads it.
    MappingFrame dragged(QPointF cursor, const ViewCamera& camera) const;
    void draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor) const;

private:
    Shapes shapes(const ViewCamera& camera) const override;
};

} // namespace tactum
