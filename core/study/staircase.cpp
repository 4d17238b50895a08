#include "core/study/staircase.h"

#include <algorithm>
#include <cmath>

namespace tactum {

bool Staircase::answer(bool correct) {
    ++trials_;
    right_ = correct ? right_ + 1 : 0;
    if (correct && right_ < rule_.down) return false;
    const int direction = correct ? -1 : 1;
    const bool turned = direction_ != 0 && direction != direction_;
    if (turned) reversals_.push_back(level_);
    direction_ = direction;
    right_ = 0;
    move(direction);
    return turned;
}

void Staircase::move(int direction) {
    const double step = rule_.steps[std::min(reversals_.size(), rule_.steps.size() - 1)];
    const double next = !rule_.ratio    ? level_ + direction * step
                        : direction > 0 ? level_ * step
                                        : level_ / step;
    level_ = std::clamp(next, rule_.smallest, rule_.largest);
}

std::optional<Threshold> Staircase::threshold() const {
    const std::size_t count = std::min(reversals_.size(), std::size_t(rule_.used));
    if (count == 0) return {};
    const auto first = reversals_.end() - std::ptrdiff_t(count);
    double sum = 0, squares = 0;
    for (auto level = first; level != reversals_.end(); ++level)
        sum += *level;
    const double n = double(count), mean = sum / n;
    for (auto level = first; level != reversals_.end(); ++level)
        squares += (*level - mean) * (*level - mean);
    return Threshold{mean, count > 1 ? std::sqrt(squares / (n - 1) / n) : 0, int(count)};
}

} // namespace tactum
