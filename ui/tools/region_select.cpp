#include "ui/tools/region_select.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/box_select.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

constexpr double kSmallestBrush = 3, kLargestBrush = 300; // logical pixels

ScreenMask::Point pixelAt(QPointF place) {
    return {place.x(), place.y()};
}

ScreenBox onScreen(const QRectF& box, const QSizeF& size) {
    return {2 * box.left() / size.width() - 1, 1 - 2 * box.bottom() / size.height(),
            2 * box.right() / size.width() - 1, 1 - 2 * box.top() / size.height()};
}

Eigen::Matrix4d matrixOf(const Pose& pose) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = pose.translation;
    return matrix;
}

/// Clip space: what a section leaves, as BodyInView has it.
Eigen::Vector4d keptBy(const std::optional<SectionPlane>& section, const Eigen::Matrix4d& clipFromWorld) {
    if (!section) return Eigen::Vector4d::Zero();
    Eigen::Vector4d kept_W;
    kept_W << -section->normal(), section->normal().dot(section->frame.translation);
    return clipFromWorld.inverse().transpose() * kept_W;
}

/// Exact, where a mask is as fine as its pixels.
TriangleSet inBox(const BodyInView& body, const ScreenBox& box) {
    TriangleSet set = trianglesInBox(*body.soup, body.clipFromBody, box);
    const auto isCutAway = [&](Index corner) {
        return body.kept.dot(body.clipFromBody * body.soup->positions[corner].homogeneous()) < 0;
    };
    std::erase_if(set, [&](Index face) {
        return !body.shown[body.soup->surfaceOf[face]] ||
               std::ranges::all_of(body.soup->triangles[face], isCutAway);
    });
    return set;
}

} // namespace

RegionSelect::RegionSelect(Document& document, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
    connect(&job_, &BackgroundJob::progressed, this, &RegionSelect::progressed);
    connect(&job_, &BackgroundJob::finished, this, &RegionSelect::finished);
}

RegionSelect::Sight RegionSelect::sight() const {
    Sight sight;
    const Eigen::Matrix4d clip = view_.camera().clipFromWorld();
    for (const SceneObject& object : document_.scene().objects) {
        const auto pose = object.visible ? view_.placeOf(object.id) : std::nullopt;
        if (!pose) continue;
        BodyInView body{object.geometry, clip * matrixOf(*pose), {}, keptBy(view_.section(), clip)};
        for (const Surface& surface : object.surfaces)
            body.shown.push_back(surface.visible);
        sight.bodies.push_back(std::move(body));
        sight.objects.push_back(object.id);
    }
    return sight;
}

ScreenMask RegionSelect::emptyMask() const {
    const QSizeF size = view_.camera().size;
    return {int(std::ceil(size.width())), int(std::ceil(size.height()))};
}

void RegionSelect::takeBox(const QRectF& box, SelectMode mode) {
    ScreenMask mask = emptyMask();
    const ScreenMask::Point corners[] = {pixelAt(box.topLeft()), pixelAt(box.topRight()),
                                         pixelAt(box.bottomRight()), pixelAt(box.bottomLeft())};
    mask.addPolygon(corners);
    take(mask, box, mode);
}

void RegionSelect::takeLasso(const QPolygonF& line, SelectMode mode) {
    ScreenMask mask = emptyMask();
    std::vector<ScreenMask::Point> corners;
    for (const QPointF& place : line)
        corners.push_back(pixelAt(place));
    mask.addPolygon(corners);
    take(mask, std::nullopt, mode);
}

void RegionSelect::take(const ScreenMask& mask, const std::optional<QRectF>& box, SelectMode mode) {
    const Sight now = sight();
    if (!through_)
        return whenSeen(now, [this, now, mask, mode](const Seen& seen) {
            std::vector<TriangleMarks> marks;
            for (const BodyInView& body : now.bodies)
                marks.emplace_back(body.soup->triangles.size());
            seen->eachUnder(mask, [&](std::uint32_t body, Index triangle) { marks[body].add(triangle); });
            Taken taken;
            for (const TriangleMarks& each : marks)
                taken.push_back(each.set());
            choose(now, taken, mode);
        });
    const auto screen = box ? std::optional(onScreen(*box, view_.camera().size)) : std::nullopt;
    job_.start([this, now, mask, screen, mode](const Progress& progress) -> BackgroundJob::Delivery {
        Taken taken;
        for (const BodyInView& body : now.bodies) {
            auto set = screen ? inBox(body, *screen) : trianglesUnder(body, mask, progress);
            if (!set) return [] {}; // cancelled
            taken.push_back(std::move(*set));
        }
        return [this, now, taken, mode] { choose(now, taken, mode); };
    });
}

void RegionSelect::whenSeen(const Sight& sight, std::function<void(const Seen&)> use) {
    const ScreenMask mask = emptyMask();
    if (seen_ && seen_->bodies() == sight.bodies && seen_->width() == mask.width() &&
        seen_->height() == mask.height())
        return use(seen_);
    job_.start([this, use, bodies = sight.bodies, width = mask.width(),
                height = mask.height()](const Progress& progress) -> BackgroundJob::Delivery {
        auto seen = SeenTriangles::look(bodies, width, height, progress);
        if (!seen) return [] {}; // cancelled
        return [this, use, seen = std::make_shared<const SeenTriangles>(std::move(*seen))] {
            seen_ = seen;
            use(seen);
        };
    });
}

bool RegionSelect::stillThere(const Sight& sight) const {
    for (std::size_t i = 0; i < sight.objects.size(); ++i) {
        const SceneObject* object = document_.scene().find(sight.objects[i]);
        if (!object || object->geometry != sight.bodies[i].soup) return false;
    }
    return true;
}

void RegionSelect::choose(const Sight& sight, const Taken& taken, SelectMode mode) {
    if (!stillThere(sight)) return; // edited meanwhile
    if (surfaces_) {
        document_.selectFaces({});
        document_.select(surfacesOf(sight, taken), mode);
    } else {
        FaceSelection chosen;
        if (const auto body = bodyOf(sight, taken, mode)) chosen = {sight.objects[*body], taken[*body]};
        if (!chosen.empty() || mode == SelectMode::Replace) document_.selectFaces(chosen, mode);
    }
}

SurfaceRefs RegionSelect::surfacesOf(const Sight& sight, const Taken& taken) const {
    SurfaceRefs chosen;
    for (std::size_t body = 0; body < taken.size(); ++body) {
        const TriangleSoup& soup = *sight.bodies[body].soup;
        std::vector<char> met(sight.bodies[body].shown.size());
        for (const Index face : taken[body])
            met[soup.surfaceOf[face]] = true;
        for (Index i = 0; i < met.size(); ++i)
            if (met[i]) chosen.push_back({sight.objects[body], i});
    }
    return chosen;
}

std::optional<std::size_t> RegionSelect::bodyOf(const Sight& sight, const Taken& taken,
                                                SelectMode mode) const {
    const auto numberOf = [&](ObjectId id) -> std::optional<std::size_t> {
        const auto found = std::ranges::find(sight.objects, id);
        return found == sight.objects.end() ? std::nullopt
                                            : std::optional(std::size_t(found - sight.objects.begin()));
    };
    const FaceSelection& now = document_.selectedFaces();
    if (mode != SelectMode::Replace && !now.empty()) return numberOf(now.object);
    const auto active = document_.selection();
    if (const auto its = active ? numberOf(active->object) : std::nullopt; its && !taken[*its].empty())
        return its;
    const auto most = std::ranges::max_element(taken, {}, &TriangleSet::size);
    if (most == taken.end() || most->empty()) return std::nullopt;
    return std::size_t(most - taken.begin());
}

void RegionSelect::scaleBrush(double factor) {
    radius_ = std::clamp(factor * radius_, kSmallestBrush, kLargestBrush);
}

void RegionSelect::brush(StrokeStep step, QPointF from, QPointF to, SelectMode mode) {
    if (step == StrokeStep::Begin) {
        stroke_ = Stroke{
            mode, document_.selected(), document_.selectedFaces(), emptyMask(), sight(), nullptr, {}, {},
            false};
        for (const BodyInView& body : stroke_->sight.bodies)
            stroke_->taken.emplace_back(body.soup->triangles.size());
        whenSeen(stroke_->sight, [this](const Seen& seen) {
            if (!stroke_) return;
            stroke_->seen = seen;
            brushOn();
        });
    }
    if (!stroke_) return;
    if (step == StrokeStep::Cancel) return giveUp();
    stroke_->ended = step == StrokeStep::End;
    stroke_->waiting.addStroke(pixelAt(from), pixelAt(to), radius_);
    if (stroke_->seen) brushOn();
}

/// Takes what was gone over since it did so last.
void RegionSelect::brushOn() {
    Stroke& stroke = *stroke_;
    if (!stillThere(stroke.sight)) return giveUp(); // edited meanwhile
    bool more = false;
    stroke.seen->eachUnder(stroke.waiting, [&](std::uint32_t body, Index triangle) {
        more |= stroke.taken[body].add(triangle);
    });
    stroke.waiting = ScreenMask(stroke.waiting.width(), stroke.waiting.height());
    if (more) showStroke();
    if (stroke.ended) endStroke();
}

void RegionSelect::showStroke() {
    Stroke& stroke = *stroke_;
    Taken taken;
    for (const TriangleMarks& each : stroke.taken)
        taken.push_back(each.set());
    if (surfaces_) {
        document_.selectFaces({});
        return document_.select(joined(stroke.surfaces, surfacesOf(stroke.sight, taken), stroke.mode));
    }
    if (!stroke.body) stroke.body = bodyOf(stroke.sight, taken, stroke.mode);
    if (stroke.body) view_.setBrushedFaces(stroke.sight.objects[*stroke.body], taken[*stroke.body]);
}

/// Beside the model it takes nothing, as a click there does.
void RegionSelect::endStroke() {
    const Stroke stroke = std::move(*stroke_);
    stroke_.reset();
    view_.setBrushedFaces(0, {});
    const bool nothing =
        std::ranges::all_of(stroke.taken, [](const TriangleMarks& each) { return each.set().empty(); });
    if (surfaces_) {
        if (nothing && stroke.mode == SelectMode::Replace) document_.select(std::nullopt);
    } else if (stroke.body) {
        document_.selectFaces({stroke.sight.objects[*stroke.body], stroke.taken[*stroke.body].set()},
                              stroke.mode);
    } else if (stroke.mode == SelectMode::Replace) {
        document_.selectFaces({});
    }
}

void RegionSelect::giveUp() {
    const Stroke before = std::move(*stroke_);
    stroke_.reset();
    view_.setBrushedFaces(0, {});
    document_.select(before.surfaces);
    document_.selectFaces(before.faces);
}

} // namespace tactum
