// The one program: a verb runs without any display, a scene or nothing opens the window.

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <unistd.h>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/manual.h"
#include "app/picture.h"
#include "app/results.h"
#include "app/screen.h"
#include "app/window.h"
#include "core/base/child_program.h"
#include "core/base/host_port.h"
#include "core/base/text.h"
#include "core/port/device_check.h"

namespace tactum {

namespace {

constexpr int kUsage = 2;

int fail(const std::string& sentence, int code) {
    return sayError({Error::Kind(code), sentence});
}

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
    addVerify(program, request.bundle, request.json);
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
