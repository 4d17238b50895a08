// Taking slivers out of a mesh: needles by one vertex less, caps by an edge turned.
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "core/geometry/filing.h"
#include "core/geometry/repair.h"
#include "core/geometry/repair_parts.h"
#include "core/geometry/sliver.h"
#include "core/geometry/weld.h"

namespace tactum {
namespace {

constexpr double kShort = 2e-6; // of the diagonal: the short edge of a needle

class SliverRepair {
public:
    SliverRepair(TriangleSoup& soup, const Progress& progress)
        : soup_(soup), progress_(progress), isSliver_(soup),
          weld_(weldMap(soup.positions, Progress{{}, progress.cancelled})), kept_(soup.triangles.size(), 1) {}

    /// How many slivers are gone.
    std::size_t run() {
        constexpr int kMaxPasses = 100;
        std::size_t gone = 0;
        for (int pass = 0; pass < kMaxPasses && !progress_.isCancelled(); ++pass) {
            const std::size_t now = onePass();
            gone += now;
            if (now == 0) break;
        }
        return gone;
    }
    const std::vector<char>& kept() const { return kept_; }

private:
    using Around = FiledByVertex<Index>;

    Corners welded(Index t) const {
        const Corners& c = soup_.triangles[t];
        return {weld_[c[0]], weld_[c[1]], weld_[c[2]]};
    }
    const Vec3& at(Index place) const { return soup_.positions[place]; }
    Vec3 normal(const Corners& c) const { return (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])); }
    bool repairable(Index t) const { return kept_[t] && kindOf(welded(t)) == Kind::Triangle && isSliver_(t); }

    /// What one repair has touched is left alone until the next pass, so that `around` stays right.
    std::size_t onePass() {
        std::vector<Index> slivers;
        for (Index t = 0; t < kept_.size(); ++t)
            if (repairable(t)) slivers.push_back(t);
        if (slivers.empty()) return 0;
        Around around(weld_.size());
        for (Index t = 0; t < kept_.size(); ++t)
            if (kept_[t]) eachPlace(t, [&](Index v) { around.count(v); });
        around.allocate();
        for (Index t = 0; t < kept_.size(); ++t)
            if (kept_[t]) eachPlace(t, [&](Index v) { around.place(v, t); });
        locked_.assign(weld_.size(), 0);
        std::size_t gone = 0;
        for (Index t : slivers)
            gone += collapse(around, t) || turnEdge(around, t);
        return gone;
    }

    template <class F> void eachPlace(Index t, F f) const {
        const Corners c = welded(t);
        f(c[0]);
        if (c[1] != c[0]) f(c[1]);
        if (c[2] != c[0] && c[2] != c[1]) f(c[2]);
    }
    static bool has(const Corners& c, Index v) { return c[0] == v || c[1] == v || c[2] == v; }
    static std::span<Index> at(Around& around, Index v) { return {around.begin(v), around.end(v)}; }

    /// All vertices that share a triangle with this one, sorted; itself is not among them.
    std::vector<Index> neighbours(Around& around, Index v) const {
        std::vector<Index> found;
        for (Index t : at(around, v))
            eachPlace(t, [&](Index other) {
                if (other != v) found.push_back(other);
            });
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }
    bool isLocked(const std::vector<Index>& places) const {
        return std::ranges::any_of(places, [&](Index v) { return locked_[v]; });
    }
    void lock(const std::vector<Index>& places) {
        for (Index v : places)
            locked_[v] = 1;
    }
    std::size_t length(const Corners& c, bool longest) const {
        std::array<double, 3> lengths;
        for (std::size_t i = 0; i < 3; ++i)
            lengths[i] = (at(c[(i + 1) % 3]) - at(c[i])).squaredNorm();
        const auto found = longest ? std::ranges::max_element(lengths) : std::ranges::min_element(lengths);
        return std::size_t(found - lengths.begin());
    }

    bool collapse(Around& around, Index sliver) {
        const Corners c = welded(sliver);
        const std::size_t i = length(c, false);
        const Index stays = std::min(c[i], c[(i + 1) % 3]), goes = std::max(c[i], c[(i + 1) % 3]);
        if ((at(stays) - at(goes)).norm() > kShort * isSliver_.diagonal()) return false;
        const std::vector<Index> ring = neighbours(around, stays), other = neighbours(around, goes);
        if (locked_[stays] || locked_[goes] || isLocked(ring) || isLocked(other)) return false;
        if (!keepsTopology(around, stays, goes, ring, other) || !keepsFronts(around, stays, goes))
            return false;
        lock(ring);
        lock(other);
        for (Index t : at(around, goes))
            if (has(welded(t), stays))
                kept_[t] = 0;
            else
                for (Index& v : soup_.triangles[t])
                    if (weld_[v] == goes) v = stays;
        return true;
    }

    /// The link condition (T. K. Dey et al., "Topology Preserving Edge Contraction", 1999): what both ends
    /// are joined to are the apexes of the edge's triangles, of which there are at most two, and nothing lies
    /// on anything else afterwards.
    bool keepsTopology(Around& around, Index stays, Index goes, const std::vector<Index>& ring,
                       const std::vector<Index>& other) const {
        std::vector<Index> common, apexes;
        std::ranges::set_intersection(ring, other, std::back_inserter(common));
        std::size_t along = 0;
        for (Index t : at(around, goes)) {
            const Corners c = welded(t);
            if (kindOf(c) != Kind::Triangle) return false;
            if (!has(c, stays)) continue;
            ++along;
            for (Index v : c)
                if (v != stays && v != goes) apexes.push_back(v);
        }
        std::ranges::sort(apexes);
        if (along > 2 || apexes != common || isRim(around, stays, goes, along)) return false;
        for (Index t : at(around, goes))
            for (Index u : at(around, stays))
                if (!has(welded(t), stays) && sameFace(moved(welded(t), goes, stays), welded(u)))
                    return false;
        return true;
    }
    /// Two places of a border joined across the mesh would pinch it; a border's own edge may go.
    bool isRim(Around& around, Index a, Index b, std::size_t along) const {
        return along == 2 && onBorder(around, a) && onBorder(around, b);
    }
    bool onBorder(Around& around, Index v) const {
        std::vector<Index> ends;
        for (Index t : at(around, v))
            eachPlace(t, [&](Index other) {
                if (other != v) ends.push_back(other);
            });
        std::ranges::sort(ends);
        for (std::size_t i = 0; i < ends.size(); i += 2)
            if (i + 1 == ends.size() || ends[i] != ends[i + 1]) return true;
        return false;
    }
    static Corners moved(Corners c, Index from, Index to) {
        std::ranges::replace(c, from, to);
        return c;
    }
    static bool sameFace(Corners a, Corners b) {
        std::ranges::sort(a);
        std::ranges::sort(b);
        return a == b;
    }
    bool keepsFronts(Around& around, Index stays, Index goes) const {
        return std::ranges::all_of(at(around, goes), [&](Index t) {
            const Corners c = welded(t);
            return has(c, stays) || isSliver_(t) || normal(c).dot(normal(moved(c, goes, stays))) > 0;
        });
    }

    /// The other triangle along an edge, if it is the only one and runs along it the other way.
    std::optional<Index> across(Around& around, Index t, Index from, Index to) const {
        std::optional<Index> found;
        for (Index other : at(around, from)) {
            const Corners c = welded(other);
            if (other == t || !has(c, to)) continue;
            if (found || kindOf(c) != Kind::Triangle) return std::nullopt;
            found = other;
        }
        if (!found) return std::nullopt;
        const Corners c = welded(*found);
        for (std::size_t i = 0; i < 3; ++i)
            if (c[i] == to && c[(i + 1) % 3] == from) return found;
        return std::nullopt;
    }

    /// The sliver (a, b, c), c upon the edge from a to b, and its neighbour (b, a, d) become (a, d, c) and
    /// (d, b, c): the neighbour cut in two.
    bool turnEdge(Around& around, Index sliver) {
        const Corners t = welded(sliver);
        const std::size_t i = length(t, true);
        const Index a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        const std::optional<Index> other = across(around, sliver, a, b);
        if (!other || isSliver_(*other)) return false;
        const Corners u = welded(*other);
        const auto j = std::size_t(std::ranges::find(u, b) - u.begin());
        const Index d = u[(j + 2) % 3];
        const std::vector<Index> ring = neighbours(around, c);
        if (isLocked({a, b, c, d}) || std::ranges::binary_search(ring, d)) return false;
        const Corners one{a, d, c}, two{d, b, c};
        const Vec3 front = normal(u);
        const bool fits =
            !isSliver_(one) && !isSliver_(two) && normal(one).dot(front) > 0 && normal(two).dot(front) > 0;
        if (!fits) return false;
        lock({a, b, c, d});
        cutNeighbour(sliver, *other, i, j);
        return true;
    }

    /// Corners of the sliver from its long edge on, of the neighbour from b on: b, a, d.
    void cutNeighbour(Index sliver, Index other, std::size_t i, std::size_t j) {
        const Index apex = soup_.triangles[sliver][(i + 2) % 3];
        const Corners u = soup_.triangles[other];
        const Index b = u[j], a = u[(j + 1) % 3], d = u[(j + 2) % 3];
        const Vec3 along = at(b) - at(a);
        const double s = std::clamp((at(apex) - at(a)).dot(along) / along.squaredNorm(), 0.0, 1.0);
        soup_.triangles[sliver] = {a, d, apex};
        soup_.triangles[other] = {d, b, apex};
        soup_.surfaceOf[sliver] = soup_.surfaceOf[other];
        const auto carry = [&](auto& values, auto finish) {
            if (values.empty()) return;
            const auto corner = [&](std::size_t k) { return values[3 * std::size_t(other) + (j + k) % 3]; };
            const auto ofB = corner(0), ofA = corner(1), ofD = corner(2);
            const auto between = finish(ofA * float(1 - s) + ofB * float(s), ofA);
            std::copy_n(std::array{ofA, ofD, between}.begin(), 3, &values[3 * std::size_t(sliver)]);
            std::copy_n(std::array{ofD, ofB, between}.begin(), 3, &values[3 * std::size_t(other)]);
        };
        carry(soup_.cornerNormals, [](const Eigen::Vector3f& mean, const Eigen::Vector3f& one) {
            return mean.norm() > 1e-6f ? Eigen::Vector3f(mean.normalized()) : one;
        });
        carry(soup_.cornerUvs,
              [](const Eigen::Vector2f& mean, const Eigen::Vector2f&) { return Eigen::Vector2f(mean); });
    }

    TriangleSoup& soup_;
    const Progress& progress_;
    SliverRule isSliver_;
    std::vector<Index> weld_;
    std::vector<char> kept_, locked_;
};

} // namespace

Result<Repaired> repairSlivers(const SharedSoup& soup, const Progress& progress) {
    TriangleSoup result = *soup;
    SliverRepair repairing(result, progress);
    const std::size_t gone = repairing.run();
    if (progress.isCancelled()) return cancelledError();
    std::string done = sentence(gone, "sliver", "slivers", "taken out");
    if (gone == 0) return Repaired{soup, 0, std::move(done)};
    return Repaired{std::make_shared<const TriangleSoup>(withTriangles(result, repairing.kept())), gone,
                    std::move(done)};
}

} // namespace tactum
