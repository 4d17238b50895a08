#include <fstream>
#include <iostream>

#include "app/commands.h"
#include "app/results.h"
#include "app/streams.h"
#include "app/terminal_progress.h"
#include "core/base/text.h"
#include "core/bundle/write_scene.h"
#include "core/files/read_finger_path.h"
#include "core/files/source.h"
#include "core/scene/placing.h"

namespace tactum {

namespace {

/// One line for each thing that is not kept as it is.
void sayLosses(const std::vector<Loss>& losses) {
    for (const Loss& loss : losses)
        if (loss.kind != LossKind::Kept) std::cerr << lineOf(loss) << '\n';
}

OutputPlaces placesOf(const ConvertOptions& options) {
    OutputPlaces places{options.out, {options.in}, {}};
    if (options.path) places.inputs.push_back(*options.path);
    if (options.report) places.outputs.push_back(*options.report);
    return places;
}

constexpr const char* kTouchesNothing =
    "warning: the finger path of the bundle touches nothing, so that its forces show nothing; give it "
    "another one with --path\n";

Result<int> convert(const ConvertOptions& options) {
    if (const auto format = formatOf(options.out); !format) return tl::unexpected(format.error());
    if (const auto folder = checkFolder(options.out); !folder) return tl::unexpected(folder.error());
    auto loaded = importGiven(options.in, options.axes);
    if (!loaded) return tl::unexpected(loaded.error());
    Scene& scene = loaded->scene;
    if (options.fitDiagonal) fitDiagonal(scene, *options.fitDiagonal); // the finger of the scene as well
    if (options.path) { // one that is given is where the result is, as it is for `touch`
        auto finger = readFingerPath(*options.path);
        if (!finger) return tl::unexpected(finger.error());
        scene.finger = std::make_shared<const std::vector<FingerPoint>>(std::move(*finger));
    }
    const auto written = [&] {
        const TerminalProgress terminal("writing " + shownPath(options.out));
        return writeScene(scene, placesOf(options), terminal.progress());
    }();
    if (!written) return tl::unexpected(written.error());
    if (!written->touches) std::cerr << kTouchesNothing;
    for (const std::string& line : linesOf(loaded->findings))
        std::cerr << line << '\n';
    sayLosses(written->losses);
    if (options.report)
        if (const auto report = writeFile(*options.report, reportJson(written->losses)); !report)
            return tl::unexpected(report.error());
    return 0;
}

/// By way of a file. A format whose files name each other cannot go through a pipe.
Result<int> convertToOutput(ConvertOptions options) {
    const std::string name = "standard output";
    const auto usage = [&](const std::string& text) {
        return tl::unexpected(Error{Error::Kind::Usage, name + ": " + text});
    };
    std::string bytes;
    Result<int> code = 0;
    { // the folder is gone when the bytes go out, whoever is no longer there to read them
        const ScratchFolder folder("pipe");
        if (folder.path().empty())
            return machineError(name + ": there is no folder for temporary files; set TMPDIR to one");
        options.out = folder.path() / ("standard-output." + options.to.value_or(""));
        const auto format = formatOf(options.out);
        if (!options.to || !format ||
            lowerCase(*options.to) != format->ending) // an ending, and no part of a path
            return usage("needs --to with one of " + writableEndings(true));
        if (!format->alone)
            return usage("." + *options.to + " is several files that name each other; write it to a file");
        code = convert(options);
        if (!code) return tl::unexpected(renamed(code.error(), folder, name));
        std::ifstream in(options.out, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(in), {});
    }
    if (const auto written = writeFile("-", bytes); !written) return tl::unexpected(written.error());
    return code;
}

} // namespace

Result<int> runConvert(const ConvertOptions& options) {
    if (isDash(options.out)) return convertToOutput(options);
    if (options.to)
        return tl::unexpected(
            Error{Error::Kind::Usage, "--to: is for - alone, a file says its format by its ending"});
    return convert(options);
}

} // namespace tactum
