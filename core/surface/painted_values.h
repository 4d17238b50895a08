// What an author has painted onto a mesh: one value for each of its positions. Built once, then only read.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace tactum {

/// Values from 0 to 1 in the order of TriangleSoup::positions. Between them lies a smooth surface
/// (painted_sample.h). Shared through a shared_ptr to const.
class PaintedValues {
public:
    /// Values outside are brought inside; what is no number becomes 0. Thread: any but real time.
    explicit PaintedValues(std::vector<float> values) : values_(std::move(values)) {
        for (float& value : values_)
            value = value > 0 ? std::min(value, 1.0F) : 0.0F;
    }

    std::size_t size() const noexcept { return values_.size(); }
    /// Thread: real time.
    double operator[](std::size_t position) const noexcept { return double(values_[position]); }
    const std::vector<float>& all() const noexcept { return values_; }

    bool operator==(const PaintedValues&) const = default;

private:
    std::vector<float> values_;
};

/// Those of one pattern, shared among scenes and equal where the values are; null: nothing was painted yet.
struct SharedPaint {
    std::shared_ptr<const PaintedValues> values;

    bool operator==(const SharedPaint& other) const {
        return values == other.values || (values && other.values && *values == *other.values);
    }
};

} // namespace tactum
