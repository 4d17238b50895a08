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
    FileAxes axes, guess;
    bool unitOpen = false, upOpen = false; ///< what the file does not say
    double across = 0;                     ///< m, by these axes, before it was made to fit a hand
};

/// Takes what the file leaves open by the choice, and no longer says that a metre is a guess. Nothing, and
/// nothing done, where it leaves nothing open. Thread: any but real time.
std::optional<TakenAs> takeAs(LoadedScene& loaded, const AxesChoice& choice);

/// What was chosen last for files of this format, in the settings. Thread: ui.
AxesChoice rememberedAxes(const std::filesystem::path& file);
/// For all files of the format. What the guess is anyway need not be remembered: it is guessed again.
void rememberUnit(const std::filesystem::path& file, double unit, double guess);
void rememberUp(const std::filesystem::path& file, bool zUp, bool guess);

} // namespace tactum
