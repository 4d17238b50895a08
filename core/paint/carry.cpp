#include "core/paint/carry.h"

#include <cmath>
#include <optional>

#include "core/geometry/weld.h"

namespace tactum {

namespace {

constexpr double kCell = 1e-5; // of the diagonal: repairs move vertices by less than half of it

/// The mean of what lies in each cell of a grid.
class MeanOfPlaces {
public:
    MeanOfPlaces(const TriangleSoup& soup, const PaintedValues& values, double cell)
        : cell_(cell), cells_(soup.positions.size()) {
        for (std::size_t i = 0; i < soup.positions.size(); ++i) {
            const Index number = cells_.numberOf(cellOf(soup.positions[i]));
            sums_.resize(cells_.places().size());
            sums_[number].value += values[i];
            ++sums_[number].count;
        }
        known_ = sums_.size();
    }

    /// Of its own cell, else of the cells around it.
    float at(const Vec3& p) {
        const Vec3 own = cellOf(p);
        if (const auto value = meanOf(own)) return *value;
        Sum around;
        for (int i = 0; i < 27; ++i)
            add(own + Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), around);
        return around.count > 0 ? float(around.value / around.count) : 0;
    }

private:
    struct Sum {
        double value = 0;
        int count = 0;
    };
    Vec3 cellOf(const Vec3& p) const {
        return {std::floor(p.x() / cell_), std::floor(p.y() / cell_), std::floor(p.z() / cell_)};
    }
    void add(const Vec3& cell, Sum& sum) {
        const Index number = cells_.numberOf(cell);
        if (number >= known_) return; // a new one: nothing lies there
        sum.value += sums_[number].value;
        sum.count += sums_[number].count;
    }
    std::optional<float> meanOf(const Vec3& cell) {
        Sum sum;
        add(cell, sum);
        return sum.count > 0 ? std::optional(float(sum.value / sum.count)) : std::nullopt;
    }

    double cell_;
    PlaceTable cells_;
    std::vector<Sum> sums_;
    std::size_t known_ = 0;
};

} // namespace

std::shared_ptr<const PaintedValues> carriedPaint(const std::shared_ptr<const PaintedValues>& values,
                                                  const TriangleSoup& before, const TriangleSoup& after) {
    if (!values || values->size() != before.positions.size() ||
        before.positions.size() == after.positions.size())
        return values;
    Bounds box;
    for (const Vec3& p : before.positions)
        box.add(p);
    const double cell = kCell * box.diagonal();
    if (!(cell > 0)) return values;
    MeanOfPlaces places(before, *values, cell);
    std::vector<float> carried;
    carried.reserve(after.positions.size());
    for (const Vec3& p : after.positions)
        carried.push_back(places.at(p));
    return std::make_shared<const PaintedValues>(std::move(carried));
}

} // namespace tactum
