#include "app/arguments.h"
#include "core/report/scene_report.h"
#include "core/video/video_file.h"

namespace tactum {

namespace {

inline constexpr Parameter kThumbnailSize{
    "size", "Size", "pixels", 16, 2048, 16, 256, 0, "Of the picture, both ways; 256 without it"};
inline constexpr Parameter kVideoHeight{
    "height", "Height", "pixels", 90, 2160, 2, 720, 0, "Of the video, 16:9; without it 720, of a GIF 360"};
/// As many files as a person names.
void addScenes(CLI::App& command, std::vector<std::filesystem::path>& scenes) {
    addFiles(command, "SCENE", scenes, "Files that the program opens, one or more; - is standard input")
        ->required()
        ->expected(1, -1);
}

} // namespace

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

void addVerify(CLI::App& program, std::filesystem::path& bundle, bool& json) {
    CLI::App* verify = program.add_subcommand(
        "verify", "Replay the finger of a bundle and compare what it feels; exit 1 when anything differs");
    addFile(*verify, "BUNDLE", bundle, "A .tactum or .zip that was exported")->required();
    verify->add_flag("--json", json, "As one JSON object");
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

} // namespace tactum
