#include "core/report/scene_report.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>

#include "core/archive/sha256.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/bundle/preview.h"
#include "core/bundle/sample_stroke.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "core/health/examine.h"
#include "core/report/force_chart.h"
#include "core/report/html.h"
#include "core/report/report_layers.h"
#include "core/report/surface_sources.h"
#include "core/scene/describe.h"

namespace tactum {

namespace {

constexpr int kPictureWidth = 640, kPictureHeight = 480; // pixels

// A browser brings the colours for dark and light itself.
constexpr const char* kStyle = R"(:root { color-scheme: light dark; }
body { font-family: sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; }
p, td, th { line-height: 145%; }
p.picture { line-height: 100%; }
table { border-collapse: collapse; margin: 0.5em 0 1.5em; }
th, td { padding: 0.25em 0.6em; font-size: small; text-align: left; vertical-align: top; }
tr, img { break-inside: avoid; }
h1, h2, h3, h4 { break-after: avoid; }
img { max-width: 100%; height: auto; }
)";

std::string head(const std::string& name) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
           escaped(name) + "</title>\n<style>\n" + kStyle + "</style>\n</head>\n<body>\n";
}

std::string sizeOf(const Bounds& box) {
    if (box.empty()) return "nothing";
    const Vec3 size = 1e3 * (box.high - box.low);
    return readable(size.x()) + " x " + readable(size.y()) + " x " + readable(size.z()) + " mm";
}

/// How hands get beyond their device's workspace.
std::string wordsOf(const Reach& reach) {
    if (reach.mode == ReachMode::Position) return "as far as the device's workspace";
    const std::string words(kReachChoices[std::size_t(reach.mode)].label);
    return reach.mode == ReachMode::Rate ? words + ", " + readable(1e3 * reach.shell) + " mm" : words;
}

std::string pictureOf(const ReportSubject& subject) {
    if (const ReportPicture& seen = subject.picture; !seen.png.empty())
        return picture("image/png", seen.png, "The scene, as it was seen", kPictureWidth,
                       kPictureWidth * seen.height / seen.width);
    return picture("image/png", previewOf(subject.scene, kPictureWidth, kPictureHeight),
                   "The scene, seen from the front, the right and above", kPictureWidth);
}

std::string beginning(const ReportSubject& subject, const SceneDescription& scene) {
    const std::string unsaved = "the scene is not saved as it is here";
    return heading(1, subject.name) +
           table({"property", "value"},
                 {{"File's SHA-256", subject.fingerprint.empty() ? unsaved : subject.fingerprint},
                  {"Written by", "Tactum " + subject.version},
                  {"Date", subject.date},
                  {"Objects", std::to_string(scene.objects.size())},
                  {"Triangles", std::to_string(scene.triangles)},
                  {"Size", sizeOf(scene.bounds_W)},
                  {"Proxy radius", readable(1e3 * subject.scene.proxyRadius) + " mm"},
                  {"Reach of the hand", wordsOf(subject.scene.reach)}}) +
           pictureOf(subject);
}

/// Object, surface, and then what is said of it.
Row rowOf(const SceneObject& object, const Surface& surface, Row rest) {
    rest.insert(rest.begin(), {object.name + ": " + surface.name});
    return rest;
}

void appendValues(std::vector<Row>& rows, const SceneObject& object, const Surface& surface,
                  const Preset* preset) {
    const auto source = [&](std::string_view key) {
        return preset ? sourceText(*preset, key) : std::string();
    };
    const std::size_t before = rows.size();
    for (const MaterialField& field : kMaterialFields) {
        const Parameter& parameter = *field.parameter;
        const double value = surface.material.*field.value;
        if (value == parameter.initial) continue;
        const auto [number, unit] = quantity(value, parameter.unit);
        rows.push_back(rowOf(object, surface,
                             {std::string(parameter.label), number, unit,
                              quantity(parameter.initial, parameter.unit).number, source(parameter.key)}));
    }
    if (surface.shading.on) {
        const auto [number, unit] = quantity(surface.shading.creaseAngle, "rad");
        rows.push_back(rowOf(object, surface,
                             {"Force shading", "crease angle " + number, unit, "off", source(kShadingPart)}));
    }
    if (surface.sides != Sides::Both)
        rows.push_back(rowOf(
            object, surface,
            {"Felt from", std::string(nameOf(surface.sides)), "", std::string(nameOf(Sides::Both)), ""}));
    if (!surface.layers.empty())
        rows.push_back(
            rowOf(object, surface,
                  {"Layers", std::to_string(surface.layers.size()), "", "0", source(kLayersPart)}));
    if (rows.size() == before)
        rows.push_back(rowOf(object, surface, {"everything", "by default", "", "", ""}));
}

std::string surfaces(const ReportSubject& subject) {
    std::vector<Row> rows;
    for (const SceneObject& object : subject.scene.objects)
        for (const Surface& surface : object.surfaces)
            appendValues(rows, object, surface, presetOfSurface(surface, subject.presets));
    return heading(2, "Surfaces") + paragraph("Values that are not the default ones.") +
           table({"object: surface", "quantity", "value", "unit", "default", "source"}, rows);
}

std::string bodies(const SceneDescription& scene) {
    std::vector<Row> bodyRows, jointRows;
    for (const BodyDescription& body : scene.bodies)
        bodyRows.push_back({body.name, readable(body.mass), std::to_string(body.colliders),
                            body.kinematic ? "its keys" : "forces"});
    const auto nameOrWorld = [](const std::string& name) { return name.empty() ? "the world" : name; };
    for (const JointDescription& joint : scene.joints)
        jointRows.push_back({joint.name, nameOrWorld(joint.a), nameOrWorld(joint.b)});
    if (bodyRows.empty() && jointRows.empty()) return {};
    return heading(2, "Bodies and joints") + table({"body", "mass, kg", "colliders", "moved by"}, bodyRows) +
           table({"joint", "from", "to"}, jointRows);
}

std::string problems(std::span<const Finding> found, const Examined& examined) {
    std::vector<Finding> all(found.begin(), found.end());
    for (const PlacedFinding& each : examined.findings)
        if (std::ranges::find(all, each.finding) == all.end()) all.push_back(each.finding);
    std::vector<Row> rows;
    for (const Finding& each : all)
        rows.push_back({each.object.empty() ? "the scene" : each.object, std::string(nameOf(each.severity)),
                        each.sentence, each.remedy});
    return heading(2, "Problems") +
           (rows.empty() ? paragraph("None was found.") : table({"of", "is", "what", "what to do"}, rows));
}

std::string deviceSection(const std::optional<ReportDevice>& device) {
    if (!device) return {};
    std::vector<Row> rows{{"Device", device->name}};
    const auto add = [&](const char* what, double value, const char* unit) {
        if (value > 0) rows.push_back({what, readable(value) + unit});
    };
    add("Largest force", device->maxForce, " N");
    add("Stiffness by its maker, at 1 kHz", device->maxStiffness, " N/m");
    add("Stiffness ceiling; stiffer surfaces are clamped to it", device->stiffnessCeiling, " N/m");
    return heading(2, "Device") + table({"property", "value"}, rows);
}

std::string forces(const Scene& scene, const World& world) {
    const std::vector<FingerPoint> finger = scene.finger ? *scene.finger : sampleStroke(world);
    const TouchTrace rows = replay(world, finger);
    const auto most =
        std::ranges::max_element(rows, {}, [](const TouchRow& row) { return row.force.squaredNorm(); });
    const std::string what = scene.finger ? "The scene's own finger path"
                                          : "A press from above the middle, a circle, and up again";
    std::string text = heading(2, "Forces of a stroke");
    if (most == rows.end() || !(most->force.norm() > 0))
        return text + paragraph(what + ". It touches nothing.");
    const std::string largest = "The largest force is " + readable(most->force.norm()) + " N at " +
                                readable(most->t - rows.front().t) + " s, before any device's limit.";
    return text +
           paragraph(what + ", one haptic step for each of its " + std::to_string(rows.size()) + " points. " +
                     largest) +
           picture("image/svg+xml", forceChart(rows), "The force over time. " + largest, kChartWidth);
}

} // namespace

Result<void> checkReportFile(const std::filesystem::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    if (ending == kHtmlEnding || ending == kPdfEnding) return {};
    return inputError(printable(file.string(), 200) +
                      ": a report is written as .html or .pdf; choose one of them");
}

std::string reportDate() {
    std::time_t seconds = std::time(nullptr);
    if (const char* given = std::getenv("SOURCE_DATE_EPOCH"))
        if (const auto number = parseNumber(given)) seconds = std::time_t(*number);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    char text[64];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc)};
}

Result<std::string> sceneReport(const ReportSubject& subject, const Progress& progress) {
    const auto reached = [&](double part) {
        if (progress.report) progress.report(part);
        return !progress.isCancelled();
    };
    const auto world = compile(subject.scene);
    if (!world) return tl::unexpected(world.error());
    if (!reached(0.2)) return cancelledError();
    const auto examined = examine(subject.scene, {}, partOf(progress, 0.2, 0.6));
    if (!examined) return tl::unexpected(examined.error());
    const SceneDescription described = describe(subject.scene);
    if (!reached(0.7)) return cancelledError();
    std::string page = head(subject.name) + beginning(subject, described) + surfaces(subject) +
                       layersSection(subject.scene, described) + bodies(described);
    if (!reached(0.9)) return cancelledError();
    return page + problems(subject.found, *examined) + deviceSection(subject.device) +
           forces(subject.scene, **world) + "</body>\n</html>\n";
}

} // namespace tactum
