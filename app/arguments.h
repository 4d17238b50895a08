// What several verbs say alike on the command line: numbers, files, words, axes. A mistake is thrown as CLI11
// throws its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "core/surface/parameter.h"

namespace tactum {

inline constexpr const char* kEmptyName = "is an empty name; name a file";

/// "--key", in the parameter's unit and range.
void addNumber(CLI::App& command, const Parameter& parameter, std::function<void(double)> take);

/// Every file that a person names, with a dash before the name or by its place alone.
template <class Path>
CLI::Option* addFile(CLI::App& command, const char* name, Path& file, const char* help) {
    CLI::Option* option = command.add_option_function<std::string>(
        name,
        [&file, name](const std::string& text) {
            if (text.empty()) throw CLI::ValidationError(name, kEmptyName);
            file = text;
        },
        help);
    return name[0] == '-' ? option->type_name("FILE") : option;
}

/// The same of as many as a person names.
CLI::Option* addFiles(CLI::App& command, const char* name, std::vector<std::filesystem::path>& files,
                      const char* help);
/// One of a few words; `take` says whether it knows the word.
void addWord(CLI::App& command, const char* name, const char* words, const char* help,
             std::function<bool(std::string_view)> take);
/// Of a file that may leave both open.
void addAxes(CLI::App& command, const std::string& file, GivenAxes& axes);

using Outputs = std::vector<std::optional<std::filesystem::path>>;
/// No output is an input or another output.
void checkOutputs(const std::vector<std::filesystem::path>& inputs, const Outputs& outputs);

// The verbs.
void addTouch(CLI::App& program, TouchOptions& options);
void addSimulate(CLI::App& program, SimulateOptions& options);
void addPlay(CLI::App& program, PlayOptions& options);
void addConvert(CLI::App& program, ConvertOptions& options);
void addInfo(CLI::App& program, InfoOptions& options);
void addCheck(CLI::App& program, CheckOptions& options);
void addVerify(CLI::App& program, std::filesystem::path& bundle, bool& json);
void addFeel(CLI::App& program, FeelOptions& options);
void addReport(CLI::App& program, ReportOptions& options);
void addThumbnail(CLI::App& program, ThumbnailOptions& options);

} // namespace tactum
