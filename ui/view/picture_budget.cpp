#include "ui/view/picture_budget.h"

#include <algorithm>
#include <utility>

namespace tactum {

namespace {
/// Times a picture without samples, from 24,000 triangles to a million (docs/performance.md).
constexpr double kSampledCosts = 3.6;
/// Times a picture with half of the pixels each way, where most of it is shading (docs/performance.md).
constexpr double kHalfSpares = 1.7;
} // namespace

void PictureBudget::took(double seconds, bool sampled) {
    plain_ = sampled ? seconds / kSampledCosts : seconds;
}

void PictureBudget::tookCoarse(double seconds) {
    if (const auto last = std::exchange(coarseLast_, seconds); last && plain_)
        coarsePart_ = std::min(*last, seconds) / *plain_;
}

double PictureBudget::affordedSide(std::size_t pictures) const {
    const double takes = plain_ ? double(pictures) * coarsePart_ * *plain_ : 0;
    if (takes <= limits_.motion) return 1;
    return takes <= kHalfSpares * limits_.motion ? 1.0 / 2 : 1.0 / 3;
}

PictureQuality PictureBudget::atRest(std::size_t pictures) const {
    const bool affordsSamples = plain_ && kSampledCosts * double(pictures) * *plain_ <= limits_.rest;
    return affordsSamples ? PictureQuality::Sampled : PictureQuality::Smoothed;
}

} // namespace tactum
