#include "ui/view/picture_budget.h"

namespace tactum {

namespace {
/// Times a picture without samples, from 24,000 triangles to a million (docs/performance.md).
constexpr double kSampledCosts = 3.6;
} // namespace

void PictureBudget::took(double seconds, bool sampled) {
    plain_ = sampled ? seconds / kSampledCosts : seconds;
}

PictureQuality PictureBudget::atRest(std::size_t pictures) const {
    const bool affordsSamples = plain_ && kSampledCosts * double(pictures) * *plain_ <= limits_.rest;
    return affordsSamples ? PictureQuality::Sampled : PictureQuality::Smoothed;
}

} // namespace tactum
