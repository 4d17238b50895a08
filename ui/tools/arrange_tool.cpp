#include "ui/tools/arrange_tool.h"

#include <algorithm>

#include "core/scene/object_bounds.h"
#include "core/scene/standing.h"
#include "ui/base/numbers.h"
#include "ui/view/scene_view.h"

namespace tactum {
namespace {

// Of one drag or number: what is meant by hand is less, and what comes of it stays a thing that can be felt.
constexpr double kMostMove = 10; // m
constexpr double kLeastSize = 1e-5, kMostSize = 10;

} // namespace

ArrangeTool::ArrangeTool(Document& document, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
    connect(&view_, &SceneView::arrangeGrabbed, this, &ArrangeTool::begin);
    connect(&view_, &SceneView::arrangeDragged, this, &ArrangeTool::drag);
    connect(&view_, &SceneView::handlesLeft, this, [this](bool givenUp) {
        document_.endTrial(gesture_, givenUp);
        end();
    });
    connect(&view_, &SceneView::arrangeAsked, this, [this] { emit refused(whyNot()); });
    connect(&document_, &Document::changed, this, [this](const SceneChange& change) {
        // Somebody else's edit in the middle of a drag: what it began from is there no more.
        if (before_ && !applying_ && change.what != SceneChange::What::Selection) view_.dropHandles();
        refresh();
    });
}

void ArrangeTool::setActive(bool active) {
    active_ = active;
    refresh();
}

void ArrangeTool::setPivot(Pivot pivot) {
    pivot_ = pivot;
    refresh();
}

void ArrangeTool::setOwnAxes(bool own) {
    own_ = own;
    refresh();
}

const SceneObject* ArrangeTool::active() const {
    const auto selection = document_.selection();
    return selection ? document_.scene().find(selection->object) : nullptr;
}

bool ArrangeTool::isFree(const GoingAlong& along) const {
    return std::ranges::none_of(along.objects, [&](ObjectId id) {
        const SceneObject* object = document_.scene().find(id);
        return object && std::ranges::any_of(object->surfaces, &Surface::locked);
    });
}

std::vector<ObjectId> ArrangeTool::objects() const {
    std::vector<ObjectId> all = document_.selectedObjects();
    const auto isLocked = [](const SceneObject& object) {
        return std::ranges::any_of(object.surfaces, &Surface::locked);
    };
    if (std::ranges::none_of(document_.scene().objects, isLocked)) return all;
    std::erase_if(all, [&](ObjectId id) { return !isFree(goingAlong(document_.scene(), std::array{id})); });
    return all;
}

const Bounds& ArrangeTool::boxOf(const SceneObject& object) const {
    std::erase_if(boxes_, [](const auto& known) { return known.second.of.expired(); });
    const auto [known, isNew] = boxes_.try_emplace(object.geometry.get());
    if (isNew) known->second = {object.geometry, tactum::boundsOf(*object.geometry)};
    return known->second.box;
}

Vec3 ArrangeTool::middleOf(const SceneObject& object) const {
    const Bounds& box = boxOf(object);
    return box.empty() ? object.pose.translation : object.pose.apply(box.centre());
}

Vec3 ArrangeTool::pivotOf(const std::vector<ObjectId>& objects) const {
    if (pivot_ == Pivot::World) return Vec3::Zero();
    if (const SceneObject* last = active(); last && pivot_ == Pivot::Last) return middleOf(*last);
    Bounds all;
    for (const ObjectId id : objects) {
        const SceneObject& object = *document_.scene().find(id);
        const Bounds& box = boxOf(object);
        for (int corner = 0; corner < 8 && !box.empty(); ++corner)
            all.add(object.pose.apply({(corner & 1 ? box.high : box.low).x(),
                                       (corner & 2 ? box.high : box.low).y(),
                                       (corner & 4 ? box.high : box.low).z()}));
    }
    return all.empty() ? Vec3(Vec3::Zero()) : all.centre();
}

/// One for all, or one for each, but for those that go along with another one anyway.
std::vector<ArrangeTool::Group> ArrangeTool::groups(bool each) const {
    const std::vector<ObjectId> chosen = objects();
    const Scene& scene = document_.scene();
    if (chosen.empty()) return {};
    if (!each) return {{goingAlong(scene, chosen), pivotOf(chosen)}};
    std::vector<Group> all;
    for (const ObjectId id : chosen)
        all.push_back({goingAlong(scene, std::array{id}), middleOf(*scene.find(id))});
    std::vector<Group> own;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool carried = false;
        for (std::size_t other = 0; other < all.size(); ++other) {
            const auto& [along, theirs] = std::pair(all[i].along.objects, all[other].along.objects);
            carried = carried || (other != i && all[other].along.has(chosen[i]) &&
                                  (theirs.size() > along.size() || (theirs == along && other < i)));
        }
        if (!carried) own.push_back(all[i]);
    }
    return own;
}

Arrangement ArrangeTool::bounded(Arrangement by) const {
    if (by.move.norm() > kMostMove) by.move *= kMostMove / by.move.norm();
    if (by.scale == 1) return by;
    for (const Group& group : held_)
        for (const ObjectId id : group.along.objects) {
            const SceneObject* object = before_->find(id);
            const double size = object ? boxOf(*object).diagonal() : 0;
            if (size > 0) by.scale = std::max(std::min(by.scale, kMostSize / size), kLeastSize / size);
        }
    return by;
}

std::vector<GoingAlong> ArrangeTool::partsOf(const std::vector<Group>& groups) {
    std::vector<GoingAlong> parts;
    for (const Group& group : groups)
        parts.push_back(group.along);
    return parts;
}

QString ArrangeTool::textOf(const Arrangement& by) const {
    std::size_t count = 0;
    for (const Group& group : held_)
        count += group.along.objects.size();
    const SceneObject* only = count == 1 ? before_->find(held_[0].along.objects[0]) : active();
    const QString name =
        count == 1 && only ? QString::fromStdString(only->name) : tr("%1 objects").arg(count);
    const bool turns = by.turn.coeffs() != Quat::Identity().coeffs();
    return (by.scale != 1 ? tr("Scale %1") : turns ? tr("Turn %1") : tr("Move %1")).arg(name);
}

void ArrangeTool::begin() {
    before_ = document_.scene();
    held_ = groups(pivot_ == Pivot::Each);
    frame_ = view_.arranging().shown().value_or(Pose{});
    gesture_ = document_.beginTrial();
    if (std::ranges::any_of(held_, [](const Group& group) { return !group.along.bodies.empty(); }))
        emit begun();
}

void ArrangeTool::drag(const Arrangement& by) {
    if (!before_) return;
    const Arrangement safe = bounded(by);
    apply(safe, gesture_);
    frame_ = view_.arranging().before();
    frame_.translation += safe.move;
    if (own_) frame_.rotation = unitLength(safe.turn * frame_.rotation);
    view_.setArranging(frame_);
}

void ArrangeTool::end() {
    before_.reset();
    held_.clear();
    refresh();
}

void ArrangeTool::apply(const Arrangement& by, Gesture gesture) {
    Scene next = *before_;
    for (const Group& group : held_) {
        Arrangement own = by;
        own.about = group.about;
        arrange(next, group.along, own);
    }
    put(textOf(by), std::move(next), gesture);
}

void ArrangeTool::put(const QString& text, Scene next, Gesture gesture) {
    applying_ = true;
    document_.editScene(
        text, SceneChange::What::Objects, [&](Scene& scene) { scene = std::move(next); }, gesture);
    applying_ = false;
}

void ArrangeTool::dropToGround() {
    std::vector<Group> falling = groups(true);
    if (falling.empty()) return emit refused(whyNot());
    Scene next = document_.scene();
    // The lowest first: what stands on it falls onto where it comes to.
    std::ranges::sort(falling, {},
                      [&](const Group& group) { return boundsOf(next, group.along.objects).low.y(); });
    for (const Group& group : falling)
        arrange(next, group.along, {.move = wayToGround(next, group.along) * Vec3::UnitY()});
    if (next == document_.scene()) return emit refused(tr("It stands on the ground already."));
    if (std::ranges::any_of(falling, [](const Group& group) { return !group.along.bodies.empty(); }))
        emit begun();
    put(tr("Drop to the ground"), std::move(next), newGesture());
    refresh();
}

void ArrangeTool::alignWithActive(int axis, BoxSide side) {
    const SceneObject* last = active();
    std::vector<Group> moved = groups(true);
    if (!last || moved.empty()) return emit refused(whyNot());
    // It stays, with all that goes along with it.
    std::erase_if(moved, [&](const Group& group) { return group.along.has(last->id); });
    if (moved.empty())
        return emit refused(tr("Select two or more objects; they are aligned with the one selected last."));
    Scene next = document_.scene();
    align(next, partsOf(moved), tactum::boundsOf(*last), axis, side);
    putInLine(tr("Align"), moved, std::move(next));
}

void ArrangeTool::distributeEvenly(int axis) {
    const std::vector<Group> moved = groups(true);
    if (moved.size() < 3) return emit refused(tr("Select three or more objects that move on their own."));
    Scene next = document_.scene();
    distribute(next, partsOf(moved), axis);
    putInLine(tr("Distribute"), moved, std::move(next));
}

void ArrangeTool::putInLine(const QString& text, const std::vector<Group>& moved, Scene next) {
    if (next == document_.scene()) return emit refused(tr("They are aligned already."));
    if (std::ranges::any_of(moved, [](const Group& group) { return !group.along.bodies.empty(); }))
        emit begun();
    put(text, std::move(next), newGesture());
    refresh();
}

void ArrangeTool::place(const Arrangement& by, Gesture gesture) {
    before_ = document_.scene();
    held_ = groups(pivot_ == Pivot::Each);
    if (held_.empty())
        emit refused(whyNot());
    else
        apply(bounded(by), gesture);
    end();
}

void ArrangeTool::choose(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers) {
    const bool also = modifiers & Qt::ShiftModifier;
    const SceneObject* object = hit ? document_.scene().find(hit->surface.object) : nullptr;
    if (!object) return also ? void() : document_.select(SurfaceRefs{});
    document_.selectFaces({});
    const bool again = also && active() == object;
    document_.selectObjects({object->id}, again  ? SelectMode::Subtract
                                          : also ? SelectMode::Add
                                                 : SelectMode::Replace);
}

QString ArrangeTool::whyNot() const {
    if (!objects().empty()) return {};
    const SceneObject* chosen = active();
    if (!chosen) return tr("Nothing is selected; click an object first.");
    return tr("%1, or what goes along with it, is locked; Surface > Lock unlocks it.")
        .arg(QString::fromStdString(chosen->name));
}

void ArrangeTool::refresh() {
    if (before_) return; // the drag says where the handles are
    const std::vector<ObjectId> chosen = active_ ? objects() : std::vector<ObjectId>();
    if (chosen.empty()) return view_.setArranging(std::nullopt);
    Pose frame;
    frame.translation = pivotOf(chosen);
    if (const SceneObject* last = active(); own_ && last) frame.rotation = last->pose.rotation;
    view_.setArranging(frame);
}

} // namespace tactum
