// The one program: a verb runs without any display, a scene or nothing opens the window.

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <span>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/manual.h"
#include "app/picture.h"
#include "app/results.h"
#include "app/screen.h"
#include "app/window.h"
#include "core/base/child_program.h"
#include "core/base/host_port.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/bundle/output_files.h"
#include "core/haptics/moving_bodies.h"
#include "core/port/device_check.h"
#include "core/report/scene_report.h"
#include "core/scene/placing.h"
#include "core/scene/scene.h"
#include "core/video/video_file.h"

namespace tactum {

namespace {

constexpr int kUsage = 2;
constexpr const char* kEmptyName = "is an empty name; name a file";

int fail(const std::string& sentence, int code) {
    return sayError({Error::Kind(code), sentence});
}

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

inline constexpr Parameter kThumbnailSize{
    "size", "Size", "pixels", 16, 2048, 16, 256, 0, "Of the picture, both ways; 256 without it"};
inline constexpr Parameter kVideoHeight{
    "height", "Height", "pixels", 90, 2160, 2, 720, 0, "Of the video, 16:9; without it 720, of a GIF 360"};
inline constexpr Parameter kLatencySeconds{
    "latency", "Latency", "s",
    0.1,       86400,     1,
    10,        1,         "Measure for so long how late this machine wakes a loop like the servo's"};
inline constexpr Parameter kLatencyRate{"rate",
                                        "Rate",
                                        "Hz",
                                        kSlowestRate,
                                        kFastestRate,
                                        100,
                                        1000,
                                        0,
                                        "Of the loop that --latency measures; 1000 without it"};

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

// One of a few words; `take` says whether it knows the word.
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

using Outputs = std::vector<std::optional<std::filesystem::path>>;

void checkOutputs(const std::vector<std::filesystem::path>& inputs, const Outputs& outputs) {
    std::vector<std::filesystem::path> given;
    for (const auto& output : outputs)
        if (output) given.push_back(*output);
    if (const auto clash = clashOf(inputs, given)) throw CLI::ValidationError(clash->string(), kClash);
}

// Whatever is of one finger has one path; what each finger gives has a file of its own.
void checkHands(const TouchOptions& options) {
    const std::size_t hands = options.paths.size();
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

/// Of a file that may leave both open.
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

void addTouch(CLI::App& program, TouchOptions& options) {
    CLI::App* touch = program.add_subcommand("touch", "Replay a finger path over a scene");
    addFile(*touch, "SCENE", options.scene, "Any file that the program opens; - is standard input")
        ->required();
    addFiles(*touch, "--path", options.paths,
             "The finger: CSV with the header t,x,y,z in seconds and metres; once for each hand")
        ->required();
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

inline constexpr Parameter kSeconds{"seconds", "Seconds", "s", 0, 1e5, 1, 1, 3, "How long to go on."};
inline constexpr Parameter kRate{"rate", "Rate", "Hz", 1, 1e6, 100, 2000, 0, "Steps a second, at least."};
inline constexpr Parameter kEvery{"every", "Every", "s", 1e-6, 1e5, 0.01, 0.01, 3, "Time between two rows."};

/// Of a point, a force or an acceleration, SI: nothing that anybody means is beyond it.
constexpr double kLargestNumber = 1e9;

/// As many numbers as there are, with commas between them.
void readNumbers(const char* name, std::string_view text, std::span<double> numbers) {
    std::size_t count = 0;
    for (std::string_view rest = text; !rest.empty() || count == 0; ++count) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const auto number = parseNumber(rest.substr(0, comma));
        if (!number || std::abs(*number) > kLargestNumber || count == numbers.size())
            throw CLI::ValidationError(name, "'" + std::string(text) + "' is not " +
                                                 std::to_string(numbers.size()) +
                                                 " numbers with commas between them");
        numbers[count] = *number;
        if (comma == rest.size()) {
            ++count;
            break;
        }
        rest.remove_prefix(comma + 1);
        if (rest.empty()) count = numbers.size(); // a comma at the end
    }
    if (count != numbers.size())
        throw CLI::ValidationError(name, "'" + std::string(text) + "' is not " +
                                             std::to_string(numbers.size()) +
                                             " numbers with commas between them");
}

void addSimulate(CLI::App& program, SimulateOptions& options) {
    CLI::App* simulate =
        program.add_subcommand("simulate", "Let the bodies of a scene move by forces and joints");
    addFile(*simulate, "SCENE", options.scene, "Any file with KHR_physics_rigid_bodies; - is standard input")
        ->required();
    addNumber(*simulate, kSeconds, [&](double value) { options.seconds = value; });
    simulate->get_option("--seconds")->required();
    addNumber(*simulate, kRate, [&](double value) { options.rate = value; });
    addNumber(*simulate, kEvery, [&](double value) { options.every = value; });
    simulate
        ->add_option_function<std::vector<std::string>>(
            "--push",
            [&](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    std::array<double, 8> n{};
                    readNumbers("--push", text, n);
                    if (!(n[0] < n[1]))
                        throw CLI::ValidationError("--push", "'" + text + "' ends before it begins");
                    options.pushes.push_back({n[0], n[1], Vec3(n[2], n[3], n[4]), Vec3(n[5], n[6], n[7])});
                }
            },
            "A force from t0 to t1 on the body that is at a point at t0, constant in the world; as often as "
            "wanted")
        ->type_name("T0,T1,X,Y,Z,FX,FY,FZ")
        ->expected(1)
        ->take_all();
    simulate
        ->add_option_function<std::string>(
            "--gravity",
            [&](const std::string& text) {
                Vec3 gravity;
                readNumbers("--gravity", text, {gravity.data(), 3});
                options.gravity = gravity;
            },
            "Instead of the scene's, m/s^2")
        ->type_name("X,Y,Z");
    addFile(*simulate, "--out", options.out,
            "Write the states as CSV, one row for each body and time; - is standard output");
    addFile(*simulate, "--summary", options.summary, "Write the summary as JSON");
    simulate->footer(
        "Columns: t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,kinetic,potential; SI, world frame, at the\n"
        "centre of mass. Gravity is 9.81 m/s^2 along -y where the scene does not say.");
    simulate->final_callback([&] { checkOutputs({options.scene}, {options.out, options.summary}); });
}

void addPlay(CLI::App& program, PlayOptions& options) {
    CLI::App* play =
        program.add_subcommand("play", "Step through a recording again and compare every bit; exit 1 when "
                                       "anything differs");
    addFile(*play, "RECORDING", options.recording, "A file that ends in .tactum-recording")->required();
    addFile(*play, "--out", options.out,
            "Write the touch as CSV, one row for each haptic step; - is standard output");
    addFile(*play, "--summary", options.summary, "Write the summary as JSON");
    CLI::Option* video = addFile(*play, "--video", options.video,
                                 "Draw it as a video, a .webm or .gif, as the window shows it");
    addNumber(*play, kVideoHeight, [&](double value) { options.videoHeight = value; });
    play->get_option("--height")->needs(video);
    play->add_flag("--plot", options.plot, "The force plot beneath the view, in the video")->needs(video);
    play->final_callback([&] {
        if (options.video)
            if (const auto known = checkVideoFile(*options.video); !known)
                throw CLI::ValidationError("--video", known.error().text);
        checkOutputs({options.recording}, {options.out, options.summary, options.video});
    });
}

void addConvert(CLI::App& program, ConvertOptions& options) {
    CLI::App* convert = program.add_subcommand(
        "convert", "Write a scene in another format, by the ending; what is lost goes to standard error");
    addFile(*convert, "IN", options.in, "Any file that the program opens; - is standard input")->required();
    addFile(
        *convert, "OUT", options.out,
        "Ends in .glb or .gltf (everything), .tactum or .zip (a bundle for others), .x3d (for H3D), .obj, "
        ".ply, .stl or .off; - is standard output")
        ->required();
    convert->add_option("--to", options.to, "The format where OUT is -, as its ending would be")
        ->type_name("ENDING");
    addFile(*convert, "--report", options.report, "Write what is kept, degraded and lost as JSON");
    addFile(*convert, "--path", options.path,
            "The finger that shows the scene, kept in .glb and in bundles: CSV with the header t,x,y,z");
    addNumber(*convert, kFitDiagonal, [&](double value) { options.fitDiagonal = value; });
    addAxes(*convert, "IN", options.axes);
    convert->footer(
        "What the import repaired or left out goes to standard error as well.\n"
        "Beside a.x3d come a-deviceinfo.x3d and, for textures, the folder a-maps; beside a.obj a.mtl, beside "
        "a.gltf a.bin. None of these replaces a file that the result before did not name.");
    convert->final_callback([&] {
        std::vector<std::filesystem::path> inputs{options.in};
        if (options.path) inputs.push_back(*options.path);
        checkOutputs(inputs, {options.out, options.report}); // those beside it are known when it is written
    });
}

struct Request {
    TouchOptions touch;
    ConvertOptions convert;
    PlayOptions play;
    SimulateOptions simulate;
    CheckOptions check;
    FeelOptions feel;
    ThumbnailOptions thumbnail;
    ReportOptions report;
    std::filesystem::path bundle;
    std::string device;
    InfoOptions info;
    bool json = false;
    LatencyOptions latency;
    SelfTestOptions selfTest;
    std::optional<std::string> makers;
    std::string manual;
};

/// As many files as a person names.
void addScenes(CLI::App& command, std::vector<std::filesystem::path>& scenes) {
    addFiles(command, "SCENE", scenes, "Files that the program opens, one or more; - is standard input")
        ->required()
        ->expected(1, -1);
}

void addInfo(CLI::App& program, InfoOptions& options) {
    CLI::App* info = program.add_subcommand(
        "info", "Objects, surfaces, triangles, mesh health, every parameter, what the reader found");
    addScenes(*info, options.scenes);
    addAxes(*info, "SCENE", options.axes);
    info->add_flag("--json", options.json, "As one JSON object; of several files as an array of them");
}

void addCheck(CLI::App& program, CheckOptions& options) {
    CLI::App* check =
        program.add_subcommand("check", "Every finding with its remedy; exit 1 when there are errors");
    addScenes(*check, options.scenes);
    addAxes(*check, "SCENE", options.axes);
    check->add_flag("--json", options.json, "As one JSON object");
    check->add_flag("--strict", options.strict, "A warning is an error as well");
}

void addVerify(CLI::App& program, Request& request) {
    CLI::App* verify = program.add_subcommand(
        "verify", "Replay the finger of a bundle and compare what it feels; exit 1 when anything differs");
    addFile(*verify, "BUNDLE", request.bundle, "A .tactum or .zip that was exported")->required();
    verify->add_flag("--json", request.json, "As one JSON object");
}

void addFeel(CLI::App& program, FeelOptions& options) {
    CLI::App* feel =
        program.add_subcommand("feel", "Give a model, exported again elsewhere, the feel that it had");
    addFile(*feel, "FROM", options.from, "The scene with the feel; - is standard input")->required();
    addFile(*feel, "ONTO", options.onto, "The model, any file that the program opens; - is standard input")
        ->required();
    addFile(*feel, "OUT", options.out, "The result, a .glb; it may be FROM or ONTO")->required();
    addAxes(*feel, "ONTO", options.axes);
    feel->footer("Without --unit and --up a model that leaves them open is taken to be like FROM. Surfaces "
                 "find each other by name; what finds no partner goes to standard error.");
}

void addReport(CLI::App& program, ReportOptions& options) {
    CLI::App* report = program.add_subcommand(
        "report", "Write a scene on one page: pictures, values and their sources, problems, forces");
    addFile(*report, "SCENE", options.scene, "Any file that the program opens; - is standard input")
        ->required();
    addFile(*report, "-o,--out", options.out, "The page, a .html or .pdf")->required();
    addAxes(*report, "SCENE", options.axes);
    report->footer("The date in it is SOURCE_DATE_EPOCH, where that is set.");
    report->final_callback([&] {
        if (const auto known = checkReportFile(options.out); !known)
            throw CLI::ValidationError("--out", known.error().text);
        checkOutputs({options.scene}, {options.out});
    });
}

void addThumbnail(CLI::App& program, ThumbnailOptions& options) {
    CLI::App* thumbnail =
        program.add_subcommand("thumbnail", "Draw a scene into a small PNG, without a display");
    addFile(*thumbnail, "SCENE", options.in, "Any file that the program opens; - is standard input")
        ->required();
    addFile(*thumbnail, "OUT", options.out, "The PNG; - is standard output")->required();
    addNumber(*thumbnail, kThumbnailSize, [&](double value) { options.size = value; });
    thumbnail->final_callback([&] { checkOutputs({options.in}, {options.out}); });
}

void addDevices(CLI::App& program, Request& request) {
    CLI::App* devices =
        program.add_subcommand("devices", "What is connected, and why what is not usable is not");
    devices->add_flag("--json", request.json, "As a JSON array");
    addNumber(*devices, kLatencySeconds, [&](double value) { request.latency.seconds = value; });
    addNumber(*devices, kLatencyRate, [&](double value) { request.latency.rate = value; });
    devices->get_option("--rate")->needs("--latency");
    CLI::Option* selfTest = devices
                                ->add_option_function<std::string>(
                                    "--self-test",
                                    [&request](const std::string& id) {
                                        if (id.empty())
                                            throw CLI::ValidationError(
                                                "--self-test", "is an empty id; tactum devices lists them");
                                        request.selfTest.device = id;
                                    },
                                    "Lead a person through the measurement of this device; exit 1 when "
                                    "something is wrong with it")
                                ->type_name("ID");
    addFile(*devices, "--out", request.selfTest.out,
            "The folder for its profile, report and ticks; self-test without it")
        ->needs(selfTest);
    // For this program itself; an empty group is not listed.
    devices->add_option("--makers", request.makers)->group("");
    CLI::App* server = program.add_subcommand("device-server", "Drive a device for another process");
    server->group("")->add_option("ID", request.device)->required();
}

void addConnect(CLI::App& program, WindowRequest& window) {
    CLI::Option* connect =
        program
            .add_option_function<std::string>(
                "--connect",
                [&window](const std::string& text) {
                    const auto place = hostPortOf(text);
                    if (!place || place->port == 0)
                        throw CLI::ValidationError(
                            "--connect", "'" + printable(text) + "' is not HOST:PORT, as in 127.0.0.1:51270");
                    window.connect = text;
                },
                "Open the window on the scene and the device of a tactum serve")
            ->type_name("HOST:PORT");
    program
        .add_option("--credentials", window.credentials,
                    "Where certificate.pem and token of a server on another machine are")
        ->type_name("FOLDER")
        ->needs(connect);
}

/// What an installation brings beside the program; not listed.
void addManual(CLI::App& program, Request& request) {
    program.add_subcommand("manual", "The man page, and what shells complete")
        ->group("")
        ->add_option("FORM", request.manual, kManualForms)
        ->required();
}

Result<int> sayManual(const CLI::App& program, const std::string& form) {
    const auto text = manual(program, form);
    if (!text) return tl::unexpected(Error{Error::Kind::Usage, "'" + form + "' is none of " + kManualForms});
    std::cout << *text;
    return 0;
}

Result<int> run(const CLI::App& program, const Request& request) {
    if (program.got_subcommand("touch")) return runTouch(request.touch);
    if (program.got_subcommand("convert")) return runConvert(request.convert);
    if (program.got_subcommand("simulate")) return runSimulate(request.simulate);
    if (program.got_subcommand("play")) return runPlay(request.play);
    if (program.got_subcommand("info")) return runInfo(request.info);
    if (program.got_subcommand("check")) return runCheck(request.check);
    if (program.got_subcommand("verify")) return runVerify(request.bundle, request.json);
    if (program.got_subcommand("feel")) return runFeel(request.feel);
    if (program.got_subcommand("report")) return runReport(request.report);
    if (program.got_subcommand("thumbnail")) return runThumbnail(request.thumbnail);
    if (program.got_subcommand("manual")) return sayManual(program, request.manual);
    if (program.got_subcommand("device-server")) return runDeviceServer(request.device);
    if (!request.selfTest.device.empty()) return runSelfTest(request.selfTest);
    if (request.latency.seconds > 0) return runLatency(request.latency, request.json);
    return runDevices(request.makers, request.json);
}

bool isVerb(std::string_view word) {
    constexpr std::array<std::string_view, 13> verbs{
        "touch",  "report", "simulate", "convert",       "play",   "info",     "check",
        "verify", "feel",   "devices",  "device-server", "manual", "thumbnail"};
    return std::ranges::find(verbs, word) != verbs.end();
}

int runVerb(int argc, char** argv) {
    CLI::App program{"Tactum: author haptic scenes. Without a verb it opens the window.", "tactum"};
    Request request;
    addTouch(program, request.touch);
    addConvert(program, request.convert);
    addSimulate(program, request.simulate);
    addPlay(program, request.play);
    addInfo(program, request.info);
    addCheck(program, request.check);
    addVerify(program, request);
    addFeel(program, request.feel);
    addReport(program, request.report);
    addThumbnail(program, request.thumbnail);
    program.set_version_flag("--version", "tactum " TACTUM_VERSION);
    addDevices(program, request);
    WindowRequest window;
    addConnect(program, window);
    program.add_subcommand("serve", "A device and a scene for programs elsewhere, without a window");
    addManual(program, request);
    program.require_subcommand(0, 1);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        std::string sentence = error.what();
        std::ranges::replace(sentence, '\n', ' ');
        const std::string verb = argc > 1 && isVerb(argv[1]) ? argv[1] + std::string(" ") : "";
        return fail(sentence + "; see tactum " + verb + "--help", kUsage);
    }
    if (!window.connect.empty()) {
        if (!program.get_subcommands().empty())
            return fail("--connect opens a window, and '" + program.get_subcommands()[0]->get_name() +
                            "' needs none; leave one of them out",
                        kUsage);
        if (const auto screen = reachScreen(argv); !screen) return sayError(screen.error());
        return runWindow(argc, argv, window);
    }
    if (request.touch.picture || request.play.video) // before the work, not after it
        if (const auto screen = reachScreen(argv); !screen) return sayError(screen.error());
    if (program.got_subcommand("report"))
        if (const auto there = reachQt(argv); !there) return sayError(there.error());
    const Result<int> code = run(program, request);
    if (!code) return sayError(code.error());
    std::cout.flush();
    if (!std::cout) return fail("standard output: cannot be written; check where it leads", 3);
    return *code;
}

// The server is a program of its own beside this one: what it needs for the network would make every other
// start slower.
int becomeServer(int argc, char** argv) {
    const auto server = programBeside("tactum-serve");
    std::vector<char*> words(argv + 1, argv + argc);
    words.push_back(nullptr);
    execv(server.c_str(), words.data());
    return fail(std::string("tactum-serve: cannot be started (") + std::strerror(errno) +
                    "); install the program again",
                3);
}

// What is not there and does not look like a file was meant to be a verb.
int failMissing(const std::filesystem::path& scene) {
    const std::string name = scene.string();
    if (name.empty()) return fail(std::string("SCENE: ") + kEmptyName + "; see tactum --help", kUsage);
    if (scene.has_extension() || scene.has_parent_path())
        return fail(name + ": no such file; check the path", int(Error::Kind::Input));
    return fail("'" + name + "' is no verb, and there is no such file; see tactum --help", kUsage);
}

int runProgram(int argc, char** argv) {
    if (argc > 1 && argv[1] == std::string_view("serve")) return becomeServer(argc, argv);
    if (argc > 1 && (isVerb(argv[1]) || argv[1][0] == '-')) return runVerb(argc, argv);
    if (argc > 2)
        return fail("'" + std::string(argv[1]) +
                        "' is no verb, and the window opens one scene; see tactum --help",
                    kUsage);
    std::optional<std::filesystem::path> scene;
    if (argc > 1) scene = argv[1];
    std::error_code unknown; // then the reader says more
    if (scene && std::filesystem::status(*scene, unknown).type() == std::filesystem::file_type::not_found)
        return failMissing(*scene);
    if (const auto screen = reachScreen(argv); !screen) return sayError(screen.error());
    return runWindow(argc, argv, {scene, {}, {}});
}

} // namespace

} // namespace tactum

int main(int argc, char** argv) {
    // A file that grows beyond its limit (ulimit -f) is then a write that fails, with a sentence.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return tactum::runProgram(argc, argv);
    } catch (const std::bad_alloc&) {
        return tactum::fail("not enough memory for this scene; close other programs or reduce the mesh", 3);
    } catch (const std::exception& error) {
        return tactum::fail(
            std::string("stopped by an unexpected failure: ") + error.what() + "; please report it", 3);
    }
}
