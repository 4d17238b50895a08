#include "core/geometry/seen_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tactum {

namespace {

using Clip = Eigen::Vector4d;
using OnScreen = Eigen::Vector3d; ///< pixels, and the depth from -1 at the near plane

constexpr std::size_t kLookEvery = 1 << 12;
/// Of the depth: with a near plane close to the eye a millimetre is little of it.
constexpr double kDepthNoise = 1e-11;
/// What is farther outside of the view than this is cut to it: a whole number has no more room.
constexpr double kFarOutside = 1e6;

/// The part of a polygon whose product with a plane of clip space is not negative.
struct Polygon {
    std::array<Clip, 5> corners;
    std::size_t count = 0;

    Polygon cut(const Clip& plane) const {
        Polygon kept;
        for (std::size_t i = 0; i < count; ++i) {
            const Clip &a = corners[i], &b = corners[(i + 1) % count];
            const double heightA = plane.dot(a), heightB = plane.dot(b);
            if (heightA >= 0) kept.corners[kept.count++] = a;
            if ((heightA >= 0) != (heightB >= 0))
                kept.corners[kept.count++] = a + heightA / (heightA - heightB) * (b - a);
        }
        return kept;
    }
};

/// A triangle as it shows on the screen: cut at the near plane and the section, three to five corners.
class ScreenFace {
public:
    ScreenFace(const std::array<Clip, 3>& corners, const Clip& kept, int width, int height)
        : width_(width), height_(height) {
        const Clip near(0, 0, 1, 1);
        const Polygon face = Polygon{{corners[0], corners[1], corners[2]}, 3}.cut(near).cut(kept);
        for (std::size_t i = 0; i < face.count; ++i)
            add(face.corners[i]);
        if (count_ > 0) layDepth();
    }

    bool empty() const { return count_ == 0; }
    /// Twice the area in pixels; positive when the front looks to the eye.
    double area() const { return area_; }
    double depthAt(double x, double y) const {
        return std::clamp(depth_ + slope_.x() * x + slope_.y() * y, low_.z(), high_.z());
    }
    /// How much the depth changes within a pixel.
    double steepness() const { return std::abs(slope_.x()) + std::abs(slope_.y()); }
    double depthRange() const { return high_.z() - low_.z(); }

    /// Calls f(x, y) for every pixel whose middle it covers, until f says false; whether there was one.
    template <class F> bool eachCovered(F f) const {
        bool any = false;
        const int last = int(std::ceil(std::clamp(high_.y() - 0.5, 0.0, double(height_))));
        for (int y = int(std::ceil(std::clamp(low_.y() - 0.5, 0.0, double(height_)))); y < last; ++y) {
            double from = kFarOutside, to = -kFarOutside;
            for (std::size_t i = 0; i < count_; ++i)
                cross(corner_[i], corner_[(i + 1) % count_], y + 0.5, from, to);
            const int end = int(std::ceil(std::clamp(to - 0.5, 0.0, double(width_))));
            for (int x = int(std::ceil(std::clamp(from - 0.5, 0.0, double(width_)))); x < end; ++x) {
                any = true;
                if (!f(x, y)) return true;
            }
        }
        return any;
    }

    /// The same of pixels that its middle or its longest edge lies in: for what covers the middle of none.
    template <class F> void eachPassed(F f) const {
        std::size_t longest = 0;
        const auto length = [&](std::size_t i) {
            return (corner_[(i + 1) % count_] - corner_[i]).head<2>().cwiseAbs().maxCoeff();
        };
        for (std::size_t i = 1; i < count_; ++i)
            if (length(i) > length(longest)) longest = i;
        if (length(longest) <= 1) {
            OnScreen middle = OnScreen::Zero();
            for (std::size_t i = 0; i < count_; ++i)
                middle += corner_[i] / double(count_);
            passPixel(middle, f);
            return;
        }
        const OnScreen &a = corner_[longest], &b = corner_[(longest + 1) % count_];
        const int steps = int(std::min(2 * length(longest), 4.0 * (width_ + height_)));
        for (int i = 0; i <= steps; ++i)
            if (!passPixel(a + double(i) / steps * (b - a), f)) return;
    }

private:
    void add(const Clip& p) {
        const double w = std::max(p.w(), 1e-12);
        const auto kept = [](double value) { return std::clamp(value, -kFarOutside, kFarOutside); };
        corner_[count_] = {kept((p.x() / w + 1) / 2 * width_), kept((1 - p.y() / w) / 2 * height_),
                           p.z() / w};
        low_ = count_ == 0 ? corner_[0] : low_.cwiseMin(corner_[count_]);
        high_ = count_ == 0 ? corner_[0] : high_.cwiseMax(corner_[count_]);
        ++count_;
    }

    void layDepth() {
        const OnScreen u = corner_[1 % count_] - corner_[0], v = corner_[2 % count_] - corner_[0];
        const OnScreen normal = u.cross(v);
        area_ = -normal.z(); // y points down
        if (std::abs(normal.z()) > 1e-9) slope_ = -normal.head<2>() / normal.z();
        depth_ = corner_[0].z() - slope_.dot(corner_[0].head<2>());
    }

    static void cross(const OnScreen& a, const OnScreen& b, double y, double& from, double& to) {
        if ((a.y() <= y) == (b.y() <= y)) return;
        const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        from = std::min(from, x);
        to = std::max(to, x);
    }

    template <class F> bool passPixel(const OnScreen& p, F& f) const {
        const bool inside = p.x() >= 0 && p.y() >= 0 && p.x() < width_ && p.y() < height_;
        return !inside || f(int(p.x()), int(p.y()), p.z());
    }

    int width_, height_;
    std::array<OnScreen, 5> corner_;
    std::size_t count_ = 0;
    OnScreen low_, high_;
    double area_ = 0, depth_ = 0;
    Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();
};

/// Calls f(triangle, face) for each that is shown and on the screen; false when cancelled.
template <class F>
bool eachFace(const BodyInView& body, int width, int height, const Progress& progress, F f) {
    const TriangleSoup& soup = *body.soup;
    std::vector<Clip> clip(soup.positions.size());
    for (std::size_t i = 0; i < clip.size(); ++i)
        clip[i] = body.clipFromBody * soup.positions[i].homogeneous();
    ProgressMeter meter(progress, soup.triangles.size(), kLookEvery);
    for (Index t = 0; t < soup.triangles.size(); ++t) {
        if (!meter.goesOn(t)) return false;
        if (!body.shown[soup.surfaceOf[t]]) continue;
        const auto& c = soup.triangles[t];
        const ScreenFace face({clip[c[0]], clip[c[1]], clip[c[2]]}, body.kept, width, height);
        if (!face.empty()) f(t, face);
    }
    return true;
}

} // namespace

Result<TriangleSet> trianglesUnder(const BodyInView& body, const ScreenMask& mask, const Progress& progress) {
    TriangleSet result;
    const bool whole = eachFace(body, mask.width(), mask.height(), progress, [&](Index t, const auto& face) {
        bool met = false;
        const auto look = [&](int x, int y, double = 0) {
            met = mask.has(x, y);
            return !met;
        };
        if (!face.eachCovered(look)) face.eachPassed(look);
        if (met) result.push_back(t);
    });
    if (!whole) return cancelledError();
    return result;
}

class SeenTriangles::Looker {
public:
    Looker(SeenTriangles& seen)
        : seen_(seen), pixels_(std::size_t(seen.width_) * std::size_t(seen.height_)), front_(pixels_),
          edge_(pixels_) {}

    /// Twice over all: the foremost of each pixel first, then what is too small to be one.
    bool look(const Progress& progress) {
        const double bodies = double(std::max<std::size_t>(seen_.bodies_.size(), 1));
        const auto over = [&](double low, auto&& each) {
            for (std::uint32_t b = 0; b < seen_.bodies_.size(); ++b)
                if (!eachFace(seen_.bodies_[b], seen_.width_, seen_.height_,
                              partOf(progress, low + 0.5 * b / bodies, low + 0.5 * (b + 1) / bodies),
                              [&](Index t, const ScreenFace& face) {
                                  each(Face{b, t}, face);
                              }))
                    return false;
            return true;
        };
        seen_.front_.assign(pixels_, {kNobody, 0});
        if (!over(0, [&](Face at, const ScreenFace& face) { drawFront(at, face); })) return false;
        if (!over(0.5, [&](Face at, const ScreenFace& face) { findSmall(at, face); })) return false;
        fileSmall();
        return true;
    }

private:
    struct Front {
        double depth = std::numeric_limits<double>::infinity();
        float steepness = 0;
        bool back = false; ///< its back looks to the eye
    };

    std::size_t pixelOf(int x, int y) const {
        return std::size_t(y) * std::size_t(seen_.width_) + std::size_t(x);
    }

    static bool isNearer(Front& front, double depth, const ScreenFace& face) {
        if (!(depth < front.depth)) return false;
        front = {depth, float(face.steepness()), face.area() < 0};
        return true;
    }

    void drawFront(Face at, const ScreenFace& face) {
        const bool covers = face.eachCovered([&](int x, int y) {
            const std::size_t pixel = pixelOf(x, y);
            if (isNearer(front_[pixel], face.depthAt(x + 0.5, y + 0.5), face)) seen_.front_[pixel] = at;
            return true;
        });
        if (!covers)
            face.eachPassed([&](int x, int y, double depth) {
                isNearer(edge_[pixelOf(x, y)], depth, face);
                return true;
            });
    }

    void findSmall(Face at, const ScreenFace& face) {
        if (face.eachCovered([](int, int) { return false; })) return;
        face.eachPassed([&](int x, int y, double depth) {
            const std::size_t pixel = pixelOf(x, y);
            const Front& front = seen_.front_[pixel].body != kNobody ? front_[pixel] : edge_[pixel];
            const bool turned = face.area() != 0 && (face.area() < 0) != front.back;
            const double room = std::max<double>(front.steepness, face.depthRange()) + kDepthNoise;
            const bool behind = depth > front.depth + room;
            if (!behind && !(turned && depth > front.depth)) found_.push_back({pixel, at});
            return true;
        });
    }

    void fileSmall() {
        seen_.begin_.assign(pixels_ + 1, 0);
        for (const auto& [pixel, at] : found_)
            ++seen_.begin_[pixel + 1];
        for (std::size_t i = 0; i < pixels_; ++i)
            seen_.begin_[i + 1] += seen_.begin_[i];
        std::vector<std::uint32_t> next(seen_.begin_.begin(), seen_.begin_.end() - 1);
        seen_.small_.resize(found_.size());
        for (const auto& [pixel, at] : found_)
            seen_.small_[next[pixel]++] = at;
    }

    struct Found {
        std::size_t pixel;
        Face at;
    };
    SeenTriangles& seen_;
    std::size_t pixels_;
    std::vector<Front> front_;
    std::vector<Front> edge_; ///< the foremost of what covers no middle: at the rim of a body
    std::vector<Found> found_;
};

Result<SeenTriangles> SeenTriangles::look(std::vector<BodyInView> bodies, int width, int height,
                                          const Progress& progress) {
    SeenTriangles seen;
    seen.bodies_ = std::move(bodies);
    seen.width_ = width;
    seen.height_ = height;
    if (!Looker(seen).look(progress)) return cancelledError();
    return seen;
}

} // namespace tactum
