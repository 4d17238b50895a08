// The verbs of the command line. Each returns its exit code, or the error that main prints as one line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/given_axes.h"
#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/geometry/sides.h"
#include "core/surface/material.h"

namespace tactum {

/// A value that the command line gives to every surface.
struct MaterialOverride {
    const MaterialField* field = nullptr;
    double value = 0;
};

struct TouchOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> paths; ///< a finger for each hand, CSV
    std::vector<std::filesystem::path> outs;  ///< the touch of each, CSV; or none
    std::optional<std::filesystem::path> summary;
    std::optional<std::filesystem::path> picture;   ///< of one hand, as is the vibration
    std::optional<std::filesystem::path> vibration; ///< .wav, .hjif or .haptic
    GivenAxes axes;                                 ///< of the scene
    std::optional<double> fitDiagonal;              ///< m
    std::optional<double> proxyRadius;              ///< m
    std::vector<MaterialOverride> materials;
    std::optional<bool> shading; ///< of every surface
    std::optional<Sides> sides;  ///< from which every surface is felt
};

struct PlayOptions {
    std::filesystem::path recording;
    std::optional<std::filesystem::path> out;     ///< the touch, CSV
    std::optional<std::filesystem::path> summary; ///< JSON
    std::optional<std::filesystem::path> video;   ///< .webm or .gif
    double videoHeight = 0;                       ///< pixels of 16:9; 0: by the ending
    bool plot = false;                            ///< in the video
};

/// A force on the body that is at a point of the world when it begins.
struct PushOption {
    double from = 0, to = 0;   ///< s
    Vec3 point = Vec3::Zero(); ///< m, world frame
    Vec3 force = Vec3::Zero(); ///< N, world frame
};

struct SimulateOptions {
    std::filesystem::path scene;
    double seconds = 0;
    double rate = 2000;  ///< steps a second, at least
    double every = 0.01; ///< s between rows
    std::vector<PushOption> pushes;
    std::optional<Vec3> gravity;              ///< m/s^2; else the scene's
    std::optional<std::filesystem::path> out; ///< the states, CSV
    std::optional<std::filesystem::path> summary;
};

struct ConvertOptions {
    std::filesystem::path in, out;
    std::optional<std::string> to;               ///< the ending of a result that goes to standard output
    std::optional<std::filesystem::path> report; ///< what was kept, degraded and lost, as JSON
    std::optional<double> fitDiagonal;           ///< m
    GivenAxes axes;                              ///< of the input
    std::optional<std::filesystem::path> path;   ///< the finger that shows the scene, CSV
};

/// A feel for a model that was changed elsewhere.
struct FeelOptions {
    std::filesystem::path from, onto, out;
    GivenAxes axes; ///< of `onto`; what is not given is as `from` is
};

/// What the machine keeps.
struct LatencyOptions {
    double seconds = 0; ///< 0: it is not asked for
    double rate = 1000; ///< Hz
};

/// What a device really is, measured with a person at hand.
struct SelfTestOptions {
    std::string device;                      ///< its id; empty: it is not asked for
    std::filesystem::path out = "self-test"; ///< a folder for profile, report and ticks
};

/// A small picture of a scene.
struct ThumbnailOptions {
    std::filesystem::path in, out;
    double size = 256; ///< pixels, both ways
};

/// A scene on one page.
struct ReportOptions {
    std::filesystem::path scene, out;
    GivenAxes axes;
};

struct InfoOptions {
    std::vector<std::filesystem::path> scenes;
    GivenAxes axes; ///< of all of them
    bool json = false;
};

struct CheckOptions {
    std::vector<std::filesystem::path> scenes;
    GivenAxes axes; ///< of all of them
    bool json = false;
    bool strict = false; ///< a warning is an error
};

/// Replays finger paths through hapticStep, one update a row, and writes what they gave.
Result<int> runTouch(const TouchOptions& options);
/// Lets the bodies of a scene move by forces and writes where they were.
Result<int> runSimulate(const SimulateOptions& options);
/// Steps through a recording again; 1 when anything differs.
Result<int> runPlay(const PlayOptions& options);
/// Objects, surfaces, triangles, mesh health, every parameter with its unit, and what the reader found.
Result<int> runInfo(const InfoOptions& options);
/// From any format that is read to any that is written, by the endings; says what is lost on the way.
Result<int> runConvert(const ConvertOptions& options);
/// Every finding with object, sentence and remedy; 1 when there are errors.
Result<int> runCheck(const CheckOptions& options);
/// Whether a bundle feels as its files say; 1 when anything differs.
Result<int> runVerify(const std::filesystem::path& bundle, bool json);
/// Gives a model the feel of a scene, by the names of surfaces.
Result<int> runFeel(const FeelOptions& options);
/// Draws a scene into a PNG without a display, as file managers ask for it.
Result<int> runThumbnail(const ThumbnailOptions& options);
/// What is connected, and why what is not usable is not. `makers`: only what this maker's library knows of.
Result<int> runDevices(const std::optional<std::string>& makers, bool json);
/// Leads a person through the self-test of a device; 1 when something is wrong with it.
Result<int> runSelfTest(const SelfTestOptions& options);
/// How late this machine wakes a loop like the servo's; 3 when a device would lose its force by it.
Result<int> runLatency(const LatencyOptions& options, bool json);
/// Drives a device for another process of this program, which started this one (device/remote).
Result<int> runDeviceServer(const std::string& id);

} // namespace tactum
