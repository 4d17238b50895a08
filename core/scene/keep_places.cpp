#include "core/scene/keep_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/scene/arrange.h"
#include "core/scene/carry_feel.h"

namespace tactum {
namespace {

/// Of the size of what is compared: more than rounding, less than anybody moves anything.
constexpr double kSame = 1e-6;

/// The k-th object of a name is the partner of the k-th of that name.
class Partners {
public:
    explicit Partners(const Scene& scene) {
        for (const SceneObject& object : scene.objects)
            named_[plainName(object.name)].push_back(&object);
    }

    /// Nobody for those that come late.
    const SceneObject* next(const SceneObject& object) {
        const auto found = named_.find(plainName(object.name));
        if (found == named_.end() || taken_[found->first] == found->second.size()) return nullptr;
        return found->second[taken_[found->first]++];
    }

private:
    std::map<std::string, std::vector<const SceneObject*>> named_;
    std::map<std::string, std::size_t> taken_;
};

/// How much larger a mesh is than it was; nothing where it grew more in one direction than in another.
std::optional<double> growthOf(const SceneObject& was, const SceneObject& now) {
    if (was.geometry == now.geometry) return 1;
    const Bounds before = boundsOf(*was.geometry), after = boundsOf(*now.geometry);
    if (before.diagonal() == 0 && after.diagonal() == 0) return 1; // a point
    if (before.diagonal() == 0 || after.diagonal() == 0) return std::nullopt;
    const double scale = after.diagonal() / before.diagonal();
    const Vec3 low = after.low - scale * before.low, high = after.high - scale * before.high;
    if (std::max(low.norm(), high.norm()) > kSame * after.diagonal()) return std::nullopt;
    return scale;
}

/// What takes an object from where it was to where it is, about the world's origin.
std::optional<Arrangement> changeOf(const SceneObject& was, const SceneObject& now) {
    const auto scale = growthOf(was, now);
    if (!scale) return std::nullopt;
    Arrangement change{.scale = *scale};
    if (!(was.pose.rotation.coeffs() == now.pose.rotation.coeffs()))
        change.turn = unitLength(now.pose.rotation * was.pose.rotation.conjugate());
    if (!(was.pose == now.pose) || *scale != 1)
        change.move = now.pose.translation - *scale * (change.turn * was.pose.translation);
    return change;
}

bool hasOtherTriangles(const SceneObject& was, const SceneObject& now) {
    return was.geometry != now.geometry && was.geometry->triangles != now.geometry->triangles;
}

class Keeper {
public:
    Keeper(const Scene& was, const Scene& now, Scene& onto)
        : now_(now), onto_(onto), partners_(was), size_(std::max(boundsOf(now).diagonal(), 1e-9)) {}

    std::vector<Finding> keep() {
        std::vector<ObjectId> others;
        for (SceneObject& object : onto_.objects) {
            const SceneObject* was = partners_.next(object);
            const SceneObject* now = was ? now_.find(was->id) : nullptr;
            const auto change = now ? changeOf(*was, *now) : std::nullopt;
            if (now) sayWhatIsLost(object, *was, *now, change.has_value());
            if (change)
                groupOf(*change).objects.push_back(object.id);
            else
                others.push_back(object.id);
        }
        if (groups_.empty()) return std::move(findings_);
        Group& most = *std::ranges::max_element(groups_, {}, [](const Group& g) { return g.objects.size(); });
        std::ranges::copy(others, std::back_inserter(most.objects));
        if (!onto_.mechanics.bodies.empty()) return arrangeAll(most.change), std::move(findings_);
        moveFinger(most.change);
        for (const Group& group : groups_)
            arrange(onto_, goingAlong(onto_, group.objects), group.change);
        return std::move(findings_);
    }

private:
    /// Objects that all went the same way.
    struct Group {
        Arrangement change;
        std::vector<ObjectId> objects;
    };

    bool areSame(const Arrangement& a, const Arrangement& b) const {
        return std::abs(a.scale / b.scale - 1) < kSame && (a.move - b.move).norm() < kSame * size_ &&
               1 - std::abs(a.turn.dot(b.turn)) < kSame * kSame;
    }

    Group& groupOf(const Arrangement& change) {
        const auto known =
            std::ranges::find_if(groups_, [&](const Group& group) { return areSame(group.change, change); });
        if (known != groups_.end()) return *known;
        return groups_.emplace_back(Group{change, {}});
    }

    /// Bodies hang together; what was made of each of them is not known.
    void arrangeAll(const Arrangement& change) {
        std::vector<ObjectId> all;
        for (const SceneObject& object : onto_.objects)
            all.push_back(object.id);
        moveFinger(change);
        arrange(onto_, goingAlong(onto_, all), change);
    }

    void moveFinger(const Arrangement& change) {
        if (!onto_.finger || change.changesNothing()) return;
        auto finger = std::make_shared<std::vector<FingerPoint>>(*onto_.finger);
        for (FingerPoint& point : *finger)
            point.position = change.apply(point.position);
        onto_.finger = std::move(finger);
    }

    void sayWhatIsLost(const SceneObject& object, const SceneObject& was, const SceneObject& now,
                       bool isPlaced) {
        if (!isPlaced)
            findings_.push_back({Finding::Severity::Warning, object.name,
                                 "was given another form here; it comes as its file has it",
                                 "scale or cut it again"});
        else if (hasOtherTriangles(was, now))
            findings_.push_back({Finding::Severity::Note, object.name,
                                 "was repaired here; its triangles are those of the file again",
                                 "look at the problems, and repair it again where it needs it"});
    }

    const Scene& now_;
    Scene& onto_;
    Partners partners_;
    double size_; ///< m
    std::vector<Group> groups_;
    std::vector<Finding> findings_;
};

/// `idOf`: of the object that one of `onto` stands for from now on; 0: of none.
template <class IdOf> void giveIds(const Scene& now, Scene& onto, IdOf idOf) {
    ObjectId last = 0;
    for (const SceneObject& object : now.objects)
        last = std::max(last, object.id);
    std::set<ObjectId> given;
    for (SceneObject& object : onto.objects) {
        const ObjectId id = idOf(object);
        object.id = id != 0 && given.insert(id).second ? id : ++last;
    }
}

} // namespace

std::vector<Finding> keepPlaces(const Scene& was, const Scene& now, Scene& onto) {
    std::vector<Finding> findings = Keeper(was, now, onto).keep();
    Partners partners(was);
    giveIds(now, onto, [&](const SceneObject& object) -> ObjectId {
        const SceneObject* partner = partners.next(object);
        return partner && now.find(partner->id) ? partner->id : 0;
    });
    return findings;
}

void keepIds(const Scene& now, Scene& onto) {
    Partners partners(now);
    giveIds(now, onto, [&](const SceneObject& object) -> ObjectId {
        const SceneObject* partner = partners.next(object);
        return partner ? partner->id : 0;
    });
}

} // namespace tactum
