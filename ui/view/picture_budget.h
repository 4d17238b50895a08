// How well a picture is drawn where the processor draws, by what drawing took.
#pragma once

#include <cstddef>
#include <optional>

namespace tactum {

/// From the quickest to the best.
enum class PictureQuality {
    Quick,    ///< in motion: one sample a pixel, a coarser model where the exact one takes too long
    Smoothed, ///< at rest: one sample a pixel, edges smoothed in the picture
    Sampled,  ///< four samples a pixel
};

/// The longest that a picture may take, s.
struct PictureLimits {
    double motion = 1.0 / 15, rest = 0.25;
};

/// Judges by the last picture of the exact model, and by what coarse ones took beside it. Thread: ui.
class PictureBudget {
public:
    explicit PictureBudget(const PictureLimits& limits = {}) : limits_(limits) {}

    /// Its times are what the window stands for; a picture that also brought something up to date for the
    /// first time says nothing of the next one, and is left out.
    void took(double seconds, bool sampled);
    /// The same of a picture in motion with all its pixels, coarse as it was. The quicker of two in a row
    /// counts, for the first one brings coarse meshes to the card.
    void tookCoarse(double seconds);
    /// What was measured was of another model: nothing is known until the next picture.
    void forget() { *this = PictureBudget(limits_); }
    void setLimits(const PictureLimits& limits) { limits_ = limits; }

    bool known() const { return plain_.has_value(); }
    /// Without samples as long as nothing is known: no model may hold the window to find out.
    /// `pictures`: how many of them a frame has.
    PictureQuality atRest(std::size_t pictures = 1) const;
    /// Whether the exact model is quick enough for what moves; false as long as nothing is known.
    bool affordsMotion(std::size_t pictures = 1) const {
        return plain_ && double(pictures) * *plain_ <= limits_.motion;
    }
    /// How many of the pixels each way the coarse model may have in motion: all, half of them or a third; all
    /// as long as nothing is known.
    double affordedSide(std::size_t pictures = 1) const;

private:
    PictureLimits limits_;
    std::optional<double> plain_;      ///< s, of a picture without samples
    std::optional<double> coarseLast_; ///< s
    double coarsePart_ = 0;            ///< of plain_ that a coarse one takes
};

} // namespace tactum
