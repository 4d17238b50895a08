// The haptic server, which `tactum serve` becomes: devices and a scene for programs elsewhere, without a
// window.

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <CLI/CLI.hpp>

#include "core/base/host_port.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/import/import_scene.h"
#include "core/protocol/server.h"
#include "device/registry.h"

namespace tactum {
namespace {

constexpr const char* kListen = "127.0.0.1:51270";
constexpr const char* kSimulated = "simulated";

struct Options {
    std::filesystem::path scene, credentials;
    std::string listen = kListen;
    std::vector<std::string> devices{kSimulated};
    std::optional<std::vector<std::string>> certificate;
    double outsideForce = 1; ///< N
    bool untilInputEnds = false;
};

int fail(const Error& error) {
    std::cerr << "tactum: " << error.text << '\n';
    return int(error.kind);
}

std::filesystem::path folderOf(const Options& options) {
    return options.credentials.empty() ? credentialsFolder() : options.credentials;
}

int makeCertificate(const Options& options) {
    const auto folder = folderOf(options);
    if (folder.empty())
        return fail({Error::Kind::Usage, "name a folder with --credentials: there is no HOME"});
    const auto made = makeCredentials(*options.certificate);
    if (!made) return fail(made.error());
    std::error_code unknown;
    if (std::filesystem::exists(folder / "key.pem", unknown))
        return fail({Error::Kind::Input, (folder / "key.pem").string() +
                                             ": is there already, and clients have its certificate; delete "
                                             "it first, or name another folder with --credentials"});
    if (const auto saved = saveCredentials(*made, folder); !saved) return fail(saved.error());
    std::cout << "certificate.pem, key.pem and token are in " << folder.string()
              << "; clients need certificate.pem and token\n";
    return 0;
}

Result<ServerSettings> settingsOf(const Options& options) {
    ServerSettings settings;
    if (const auto at = hostPortOf(options.listen)) settings.host = at->host, settings.port = at->port;
    settings.service.pushLimit = options.outsideForce;
    if (isLoopback(settings.host) && options.credentials.empty()) return settings;
    auto credentials = loadCredentials(folderOf(options));
    if (!credentials) return tl::unexpected(credentials.error());
    settings.credentials = std::move(*credentials);
    return settings;
}

Result<Scene> sceneOf(const std::filesystem::path& file) {
    if (file.empty()) return Scene{};
    auto loaded = importScene(file);
    if (!loaded) return tl::unexpected(loaded.error());
    return std::move(loaded->scene);
}

/// Ours, which knows the verb that drives a device in a process of its own.
std::filesystem::path tactum() {
    std::error_code unknown; // then all drivers run here
    return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "tactum";
}

struct MadeHand {
    std::unique_ptr<HapticDevice> device;
    std::shared_ptr<HandTarget> lead; ///< null: it leads itself
};

/// Each simulated one has a lead of its own.
Result<std::vector<MadeHand>> handsOf(const std::vector<std::string>& devices) {
    std::vector<MadeHand> hands;
    for (const std::string& id : devices) {
        const bool simulated = id == kSimulated;
        if (!simulated && std::ranges::count(devices, id) > 1)
            return inputError("the device " + inQuotes(id) +
                              " is named twice: each hand has a device of its own");
        const auto lead = std::make_shared<HandTarget>();
        auto device =
            DeviceRegistry({.hand = lead, .profiles = personsProfiles(), .program = tactum()}).make(id);
        if (!device) return tl::unexpected(device.error());
        hands.push_back({std::move(*device), simulated ? lead : nullptr});
    }
    return hands;
}

/// Whoever has started it is gone then, however that ended.
void endWithInput() {
    char some[256];
    ssize_t got = 1;
    while (got > 0 || (got < 0 && errno == EINTR))
        got = ::read(STDIN_FILENO, some, sizeof some);
    kill(getpid(), SIGTERM);
}

Result<int> serve(const Options& options) {
    // Before any thread: all of them inherit it, and only sigwait() below hears these.
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaddset(&ends, signal);
    pthread_sigmask(SIG_BLOCK, &ends, nullptr);
    auto settings = settingsOf(options);
    if (!settings) return tl::unexpected(settings.error());
    auto scene = sceneOf(options.scene);
    if (!scene) return tl::unexpected(scene.error());
    auto hands = handsOf(options.devices);
    if (!hands) return tl::unexpected(hands.error());
    Stage stage(std::move(hands->front().device), hands->front().lead, std::move(*scene));
    for (std::size_t i = 1; i < hands->size(); ++i)
        if (auto added = stage.addHand(std::move((*hands)[i].device), (*hands)[i].lead); !added)
            return tl::unexpected(added.error());
    if (auto started = stage.start(); !started) return tl::unexpected(started.error());
    const std::string host =
        settings->host.find(':') == std::string::npos ? settings->host : '[' + settings->host + ']';
    auto server = Server::start(stage, std::move(*settings));
    if (!server) return tl::unexpected(server.error());
    std::cout << "listening on " << host << ':' << (*server)->port() << std::endl;
    if (options.untilInputEnds) std::thread(endWithInput).detach();
    int signal = 0;
    sigwait(&ends, &signal);
    return 0;
}

void addOptions(CLI::App& program, Options& options) {
    program.add_option("SCENE", options.scene,
                       "Any file that the program opens; without one there is nothing to touch");
    program
        .add_option_function<std::string>(
            "--listen",
            [&](const std::string& text) {
                if (!hostPortOf(text))
                    throw CLI::ValidationError("--listen",
                                               "'" + text + "' is not HOST:PORT, as in " + kListen);
                options.listen = text;
            },
            "Where clients find it; 127.0.0.1:51270 unless said otherwise, port 0 is any that is free. Where "
            "others "
            "can reach it, it needs a certificate and a token")
        ->type_name("HOST:PORT");
    program
        .add_option("--device", options.devices,
                    "A name that tactum devices lists; the simulated hand unless said otherwise. Again for "
                    "each further hand")
        ->type_name("NAME")
        ->expected(1)
        ->take_all();
    program
        .add_option("--credentials", options.credentials, "The folder of certificate.pem, key.pem and token")
        ->type_name("FOLDER");
    program
        .add_option_function<std::string>(
            "--outside-force",
            [&](const std::string& text) {
                const auto number = parseNumber(text);
                if (!number || *number < 0 || *number > 100)
                    throw CLI::ValidationError("--outside-force",
                                               "'" + text + "' is not a number from 0 to 100 N");
                options.outsideForce = *number;
            },
            "The most that clients may add to the force; 1 N unless said otherwise, 0: nothing")
        ->type_name("N");
    program.add_flag("--until-input-ends", options.untilInputEnds,
                     "End with standard input, too: with the program that started it");
    program
        .add_option_function<std::vector<std::string>>(
            "--make-certificate",
            [&](const std::vector<std::string>& names) {
                options.certificate = names;
                std::erase(*options.certificate, ""); // what none at all looks like
            },
            "Makes certificate, key and token for these names and addresses of this machine, and ends")
        ->type_name("NAME")
        ->expected(0, 64);
}

int run(int argc, char** argv) {
    constexpr int kUsage = 2;
    CLI::App program{"A device and a scene for programs elsewhere, without a window", "tactum serve"};
    Options options;
    addOptions(program, options);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        std::cerr << "tactum: " << printable(error.what(), 400) << "; see tactum serve --help\n";
        return kUsage;
    }
    if (options.certificate) return makeCertificate(options);
    const auto code = serve(options);
    return code ? *code : fail(code.error());
}

} // namespace
} // namespace tactum

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);
    try {
        return tactum::run(argc, argv);
    } catch (const std::bad_alloc&) {
        return tactum::fail(
            {tactum::Error::Kind::Machine, "not enough memory for this scene; close other programs"});
    }
}
