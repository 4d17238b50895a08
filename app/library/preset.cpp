#include <tactum/preset.h>

#include <algorithm>

#include "app/library/parts.h"
#include "app/library/support_folder.h"
#include "core/base/text.h"
#include "core/presets/preset_file.h"

namespace tactum::library {
namespace {

namespace fs = std::filesystem;

const std::string kEnding = "." + std::string(kPresetEnding);

/// A word without folder and ending is a name; every other one is a file.
fs::path presetFileOf(const fs::path& given) {
    if (given.has_parent_path() || given.has_extension()) return given;
    const fs::path file = presetFolder() / (given.string() + kEnding);
    std::error_code fault;
    if (!fs::exists(file, fault))
        refuse("there is no preset " + inQuotes(given.string()) + "; presets() lists those that there are");
    return file;
}

} // namespace

Preset::Preset(const fs::path& nameOrFile)
    : state_(std::make_shared<const State>(State{valueOf(readPreset(presetFileOf(nameOrFile)))})) {}

std::string Preset::name() const {
    return state_->loaded.preset.name;
}

std::vector<std::string> Preset::notes() const {
    return state_->loaded.notes;
}

std::vector<std::string> presets() {
    std::vector<std::string> names;
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(presetFolder(), fault))
        if (entry.path().extension() == kEnding) names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    return names;
}

} // namespace tactum::library
