#include "app/arguments.h"

#include "core/base/numbers.h"
#include "core/bundle/output_files.h"
#include "core/scene/placing.h"

namespace tactum {

namespace {

// A number in the C locale within a parameter's range. CLI11's own conversion follows the user's locale.
std::string readNumberOption(const std::string& text, const Parameter& range, double& value) {
    const auto number = parseNumber(text);
    if (number && range.allows(*number)) {
        value = *number;
        return {};
    }
    std::string low, high;
    appendNumber(low, range.minimum);
    appendNumber(high, range.maximum);
    return "'" + text + "' is not a number from " + low + " to " + high + (range.unit.empty() ? "" : " ") +
           std::string(range.unit);
}

} // namespace

void addNumber(CLI::App& command, const Parameter& parameter, std::function<void(double)> take) {
    command
        .add_option_function<std::string>(
            "--" + std::string(parameter.key),
            [&parameter, take](const std::string& text) {
                double value = 0;
                const std::string wrong = readNumberOption(text, parameter, value);
                if (!wrong.empty()) throw CLI::ValidationError("--" + std::string(parameter.key), wrong);
                take(value);
            },
            std::string(parameter.sentence))
        ->type_name(parameter.unit.empty() ? "RATIO" : std::string(parameter.unit));
}

CLI::Option* addFiles(CLI::App& command, const char* name, std::vector<std::filesystem::path>& files,
                      const char* help) {
    CLI::Option* option = command.add_option_function<std::vector<std::string>>(
        name,
        [&files, name](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
                if (text.empty()) throw CLI::ValidationError(name, kEmptyName);
                files.emplace_back(text);
            }
        },
        help);
    return name[0] == '-' ? option->type_name("FILE")->expected(1)->take_all() : option;
}

void addWord(CLI::App& command, const char* name, const char* words, const char* help,
             std::function<bool(std::string_view)> take) {
    command
        .add_option_function<std::string>(
            name,
            [=](const std::string& text) {
                if (!take(text)) throw CLI::ValidationError(name, "'" + text + "' is none of " + words);
            },
            help)
        ->type_name(words);
}

void addAxes(CLI::App& command, const std::string& file, GivenAxes& axes) {
    addWord(command, "--unit", "mm|cm|in|m",
            ("What one unit of " + file + " is, where the file does not say").c_str(),
            [&axes](std::string_view word) { return (axes.unit = metresOf(word)).has_value(); });
    addWord(command, "--up", "y|z",
            ("Which axis of " + file + " points up, where the file does not say").c_str(),
            [&axes](std::string_view word) {
                axes.zUp = word == "z";
                return word == "y" || word == "z";
            });
}

void checkOutputs(const std::vector<std::filesystem::path>& inputs, const Outputs& outputs) {
    std::vector<std::filesystem::path> given;
    for (const auto& output : outputs)
        if (output) given.push_back(*output);
    if (const auto clash = clashOf(inputs, given)) throw CLI::ValidationError(clash->string(), kClash);
}

} // namespace tactum
