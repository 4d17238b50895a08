// How a model is taken whose file leaves its unit or its axes open: guessed, or as a person has chosen it.
#pragma once

#include <filesystem>
#include <optional>

#include "core/files/load_scene.h"
#include "core/scene/placing.h"

namespace tactum {

/// What a person wants a file to mean; where nothing, it is guessed.
struct AxesChoice {
    std::optional<double> unit; ///< m
    std::optional<bool> zUp;

    bool operator==(const AxesChoice&) const = default;
};

struct TakenAs {
    enum class By {
        Guess,
        Choice,
        Before, ///< as the file that it was exported to before
        Size    ///< by the unit in which it is about as large as that
    };
    FileAxes axes, guess;
    By by = By::Guess;
    bool unitOpen = false, upOpen = false; ///< what the file does not say
    double across = 0;                     ///< m, by these axes, before it was made to fit a hand
};

/// Takes what the file leaves open by the choice, and no longer says that a metre is a guess. Nothing, and
/// nothing done, where it leaves nothing open. Thread: any but real time.
std::optional<TakenAs> takeAs(LoadedScene& loaded, const AxesChoice& choice);

/// A model that another program has exported again: so many units across, `before` metres when it was read
/// last. The unit in which it is about as large, where it would be far off by the one of before. Nothing
/// where that one is right, or none is.
std::optional<double> unitBySize(double units, double unitBefore, double before);

/// What was chosen last for files of this format, in the settings. Thread: ui.
AxesChoice rememberedAxes(const std::filesystem::path& file);
/// For all files of the format. What the guess is anyway need not be remembered: it is guessed again.
void rememberUnit(const std::filesystem::path& file, double unit, double guess);
void rememberUp(const std::filesystem::path& file, bool zUp, bool guess);

} // namespace tactum
