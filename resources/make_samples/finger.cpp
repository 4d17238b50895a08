#include "resources/make_samples/finger.h"

#include <algorithm>
#include <cmath>

namespace tactum::samples {

std::shared_ptr<const std::vector<FingerPoint>> fingerPath(double seconds,
                                                           const std::function<Vec3(double t)>& at) {
    std::vector<FingerPoint> path;
    const auto ticks = std::lround(seconds * 1000);
    for (long i = 0; i <= ticks; ++i) {
        const double t = double(i) / 1000;
        path.push_back({t, (at(t) * 1e7).array().round() / 1e7 + 0.0}); // 0 has no sign then
    }
    return std::make_shared<const std::vector<FingerPoint>>(std::move(path));
}

std::shared_ptr<const std::vector<FingerPoint>> fingerPath(std::span<const FingerKey> keys,
                                                           const std::function<Vec3(const Vec3&)>& place) {
    return fingerPath(keys.back().t, [&](double t) {
        const auto next =
            std::find_if(keys.begin() + 1, keys.end() - 1, [&](const FingerKey& key) { return key.t >= t; });
        const FingerKey &from = *(next - 1), &to = *next;
        const double x = std::clamp((t - from.t) / (to.t - from.t), 0.0, 1.0), s = x * x * (3 - 2 * x);
        return place((1 - s) * from.at + s * to.at);
    });
}

} // namespace tactum::samples
