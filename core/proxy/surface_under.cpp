#include "core/proxy/surface_under.h"

#include "core/surface/shaded_normal.h"

namespace tactum {

namespace {

// Slopes below this are flat.
constexpr double kFlat = 1e-12;

// Beside a face its normals go on as they change over it, which is how the next face mostly has them: as far
// as the face is large.
ClosestPoint noFartherThanItself(ClosestPoint foot) noexcept {
    constexpr double kMiddle = 1.0 / 3, kFarthestWeight = -1;
    const double least = foot.weights.minCoeff();
    if (least >= kFarthestWeight) return foot;
    const Vec3 middle = Vec3::Constant(kMiddle);
    foot.weights = middle + (kFarthestWeight - kMiddle) / (least - kMiddle) * (foot.weights - middle);
    return foot;
}

TextureFeel touched(const Obstacle& obstacle, const TextureStack& texture, const Foot& foot, const Vec3& base,
                    const Mat3& turning, const Fineness& fineness) noexcept {
    TexturePoint point = texturePointOn(*obstacle.mesh->soup, foot.triangle, obstacle.triangle(foot.triangle),
                                        foot.point, base);
    point.normalGradient = turning;
    point.passing = fineness.passing;
    return feel(texture, point, fineness.smallestFeature);
}

// A slope that is flat holds nothing back, but beside a tilted one it would hold the finger on that one's.
FeltNormals bumped(const Vec3& base, const Vec3& away, const TextureFeel& touch) noexcept {
    FeltNormals normals;
    const auto add = [&](const Vec3& slope) { normals.push(leaningAtMost(bumpedNormal(base, slope), away)); };
    if (touch.slope.norm() > kFlat) add(touch.slope);
    for (int i = 0; i < touch.ownPlanes; ++i)
        if (touch.ownSlopes[std::size_t(i)].norm() > kFlat) add(touch.ownSlopes[std::size_t(i)]);
    if (normals.size() == 0) add(Vec3::Zero());
    return normals;
}

FeltNormals alone(const Vec3& normal) noexcept {
    FeltNormals normals;
    normals.push(normal);
    return normals;
}

} // namespace

FeltNormals feltNormals(const Obstacle& obstacle, const SurfaceFeel& feel, const Foot& foot, const Vec3& away,
                        const Fineness& fineness, Material& material) noexcept {
    Vec3 base = away;
    Mat3 turning = Mat3::Zero();
    if (feel.normals) {
        const Triangle triangle = obstacle.triangle(foot.triangle);
        const ClosestPoint nearby = noFartherThanItself(foot.point);
        base = shadedNormal(*feel.normals, foot.triangle, triangle, nearby, away);
        if (feel.texture && feel.texture->asksForTurning)
            turning = shadedNormalGradient(*feel.normals, foot.triangle, triangle, nearby, base);
    }
    if (!feel.texture) return alone(base);
    const TextureFeel touch = touched(obstacle, *feel.texture, foot, base, turning, fineness);
    material = modulated(material, touch);
    return bumped(base, away, touch);
}

void rubAsFelt(const Obstacle& obstacle, const SurfaceFeel& feel, const Foot& foot, const Vec3& away,
               const Fineness& fineness, Material& material) noexcept {
    if (!feel.texture) return;
    material = modulated(material, touched(obstacle, *feel.texture, foot, away, Mat3::Zero(), fineness));
}

} // namespace tactum
