#include "ui/view/collider_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPainter>

#include "core/dynamics/convex.h"
#include "core/scene/bodies.h"
#include "ui/view/handles.h"

namespace tactum {
namespace {

using MarkLines = std::vector<std::vector<Vec3>>;

constexpr int kCapParts = 16;

void addEdges(MarkLines& lines, const Polytope& polytope) {
    for (const Polytope::Edge& edge : polytope.edges)
        lines.push_back({polytope.points[std::size_t(edge.a)], polytope.points[std::size_t(edge.b)]});
}

/// The outline of what is round about y, in the plane of y and another axis; bent out at its ends by caps.
std::vector<Vec3> profile(const ColliderShape& shape, int across, bool capped) {
    std::vector<Vec3> line;
    for (const double end : {1.0, -1.0})
        for (int i = 0; i <= kCapParts; ++i) {
            const double radius = end > 0 ? shape.radius : shape.radiusBottom;
            const double angle = end * (0.5 - double(i) / kCapParts) * std::numbers::pi;
            Vec3 p = Vec3::Zero();
            p[across] = end * radius * std::sin(angle);
            p.y() = 0.5 * end * shape.height + (capped ? end * radius * std::cos(angle) : 0);
            if (capped || i == 0 || i == kCapParts) line.push_back(p);
        }
    line.push_back(line.front());
    return line;
}

MarkLines linesOf(const ColliderShape& shape) {
    MarkLines lines;
    const bool capped = shape.kind == ShapeKind::Capsule;
    if (shape.kind == ShapeKind::Sphere) {
        for (int axis = 0; axis < 3; ++axis)
            lines.push_back(ring({}, axis, shape.radius));
    } else if (capped || shape.kind == ShapeKind::Cylinder) {
        lines = {ring({}, 1, shape.radius, 0.5 * shape.height),
                 ring({}, 1, shape.radiusBottom, -0.5 * shape.height), profile(shape, 0, capped),
                 profile(shape, 2, capped)};
    } else if (shape.kind == ShapeKind::Box) {
        addEdges(lines, boxOf(shape.size));
    } else if (shape.mesh) {
        addEdges(lines, hullOf(shape.mesh->points));
    }
    return lines;
}

} // namespace

std::vector<ColliderMark> colliderMarks(const Scene& scene) {
    std::vector<ColliderMark> marks;
    for (const Collider& collider : scene.mechanics.colliders) {
        ColliderMark mark;
        Pose place = collider.pose;
        if (const RigidBody* body = findBody(scene, collider.body)) {
            place = body->pose * collider.pose;
            const auto carrier = std::ranges::find(scene.objects, body->id, &SceneObject::body);
            if (carrier != scene.objects.end()) {
                mark.carrier = carrier->id;
                place = carrier->pose.inverse() * place;
            }
        }
        mark.lines = linesOf(collider.shape);
        for (auto& line : mark.lines)
            for (Vec3& p : line)
                p = place.apply(p);
        if (!mark.lines.empty()) marks.push_back(std::move(mark));
    }
    return marks;
}

void drawColliders(QPainter& painter, const std::vector<ColliderMark>& marks, const PlaceOfObject& placeOf,
                   const ViewCamera& camera, const Theme& theme) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const ColliderMark& mark : marks) {
        const auto place = mark.carrier == 0 ? std::optional(Pose{}) : placeOf(mark.carrier);
        if (!place) continue;
        painter.setPen(QPen(theme.contact, 1.4, mark.carrier == 0 ? Qt::DotLine : Qt::SolidLine));
        for (std::vector<Vec3> line : mark.lines) {
            for (Vec3& p : line)
                p = place->apply(p);
            painter.drawPolyline(onScreen(line, camera));
        }
    }
    painter.restore();
}

} // namespace tactum
