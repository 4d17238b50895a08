#include <algorithm>

#include "app/arguments.h"
#include "core/haptics/moving_bodies.h"

namespace tactum {

namespace {

inline constexpr Parameter kFitDiagonal{
    "fit-diagonal",
    "Fit diagonal",
    "m",
    1e-6,
    1e6,
    0.01,
    0.2,
    3,
    "Scale the scene about its bounding-box centre to this diagonal and move the centre to the origin."};

// Friction that slides harder than it sticks does not exist: one given coefficient moves the other,
// two contradicting ones are a mistake. Static friction alone means one coefficient for both.
void settleFriction(TouchOptions& options) {
    Material given;
    for (const MaterialOverride& set : options.materials)
        given.*set.field->value = set.value;
    const auto isGiven = [&](const Parameter& parameter) {
        return std::ranges::any_of(options.materials,
                                   [&](const auto& set) { return set.field->parameter == &parameter; });
    };
    if (isGiven(kStaticFriction) && isGiven(kDynamicFriction) && given.dynamicFriction > given.staticFriction)
        throw CLI::ValidationError("--dynamic-friction",
                                   "is above --static-friction; give at most that value");
    if (isGiven(kStaticFriction) && !isGiven(kDynamicFriction))
        for (const MaterialField& field : kMaterialFields)
            if (field.parameter == &kDynamicFriction)
                options.materials.push_back({&field, given.staticFriction});
}

// Whatever is of one finger has one path; what each finger gives has a file of its own.
void checkHands(const TouchOptions& options) {
    const std::size_t hands = std::max<std::size_t>(1, options.paths.size());
    if (hands > kMaxHands)
        throw CLI::ValidationError("--path", "is given " + std::to_string(hands) + " times; " +
                                                 std::to_string(kMaxHands) + " hands are the most");
    if (!options.outs.empty() && options.outs.size() != hands)
        throw CLI::ValidationError("--out", "is given " + std::to_string(options.outs.size()) +
                                                " times for --path " + std::to_string(hands) +
                                                " times; give each path its own, or none");
    if (hands > 1 && (options.picture || options.vibration))
        throw CLI::ValidationError(options.picture ? "--picture" : "--vibration",
                                   "is of one finger; give one --path");
}

} // namespace

void addTouch(CLI::App& program, TouchOptions& options) {
    CLI::App* touch = program.add_subcommand("touch", "Replay a finger path over a scene");
    addFile(*touch, "SCENE", options.scene, "Any file that the program opens; - is standard input")
        ->required();
    addFiles(
        *touch, "--path", options.paths,
        "The finger: CSV with the header t,x,y,z in seconds and metres; once for each hand. Without it the "
        "path that is kept in the scene");
    addFiles(*touch, "--out", options.outs,
             "Write the touch as CSV, one row for each update; - is standard output; once for each --path");
    addFile(*touch, "--summary", options.summary, "Write the summary as JSON");
    addFile(*touch, "--picture", options.picture, "Write a PNG of scene, paths and force; needs a display");
    addFile(*touch, "--vibration", options.vibration,
            "Write what vibrates under the finger, for actuators elsewhere; ends in .wav, .hjif or .haptic");
    addAxes(*touch, "SCENE", options.axes);
    addNumber(*touch, kFitDiagonal, [&](double value) { options.fitDiagonal = value; });
    addNumber(*touch, kProxyRadius, [&](double value) { options.proxyRadius = value; });
    for (const MaterialField& field : kMaterialFields)
        addNumber(*touch, *field.parameter, [&options, &field](double value) {
            options.materials.push_back({&field, value});
        });
    addWord(*touch, "--shading", "on|off",
            "Feel facets as the round surface that they stand for, on every surface or on none",
            [&](std::string_view word) {
                if (word == "on" || word == "off") options.shading = word == "on";
                return word == "on" || word == "off";
            });
    addWord(*touch, "--sides", "both|front|back|none",
            "From which side every surface is felt; the front sees the corners counter-clockwise",
            [&](std::string_view word) { return (options.sides = sidesNamed(word)).has_value(); });
    touch->footer("Without --dynamic-friction, dynamic friction is what --static-friction says.\n"
                  "Forces are those before the device's limit, whichever device that will be.\n"
                  "Of several hands the first path has the times of the steps; the others go straight from "
                  "point to point, and rest before the first and after the last.\n"
                  "Standard output gets the summary, unless - sends the touch there.");
    touch->final_callback([&] {
        settleFriction(options);
        checkHands(options);
        std::vector<std::filesystem::path> inputs{options.paths};
        inputs.push_back(options.scene);
        Outputs outputs{options.summary, options.picture, options.vibration};
        outputs.insert(outputs.begin(), options.outs.begin(), options.outs.end());
        checkOutputs(inputs, outputs);
    });
}

} // namespace tactum
