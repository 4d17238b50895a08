// The document and the model that its geometry is from: shapes that another program has changed.
#include <algorithm>
#include <iterator>

#include "core/base/text.h"
#include "core/files/source.h"
#include "core/import/import_scene.h"
#include "core/scene/carry_feel.h"
#include "core/scene/keep_places.h"
#include "ui/document.h"

namespace tactum {

namespace {

bool areOfOneKind(const std::filesystem::path& a, const std::filesystem::path& b) {
    return lowerCase(a.extension().string()) == lowerCase(b.extension().string());
}

/// What neither the feel nor the places tell.
void sayWhatTheFileLacks(std::vector<Finding>& findings, const Scene& now, const Scene& onto, bool placed) {
    using Severity = Finding::Severity;
    if (!placed)
        findings.push_back({Severity::Note, "", "objects are where and as large as the file has them",
                            "move them again where you had moved them"});
    if (now.kept.foreign && !onto.kept.foreign)
        findings.push_back({Severity::Note, "",
                            "what other programs had put into the file before is left out",
                            "save under another name, and take it from there"});
}

} // namespace

Result<Document::Updated> Document::updated(const Scene& now, const Source& source,
                                            const std::filesystem::path& file, const AxesChoice& choice,
                                            const Progress& progress) {
    const FileStamp stamp(file);
    auto loaded = importScene(file, progress);
    if (!loaded) return tl::unexpected(loaded.error());
    const bool known = source.as && areOfOneKind(file, source.file.path);
    const AxesChoice axes = known ? AxesChoice{source.axes.unit, source.axes.zUp} : choice;
    const auto taken = takeAs(*loaded, axes);
    Scene& onto = loaded->scene;
    Updated updated;
    updated.source = {stamp, taken ? taken->axes : FileAxes(), onto};
    updated.told.file = file;
    std::vector<Finding>& findings = updated.told.findings;
    if (known)
        findings = keepPlaces(*source.as, now, onto);
    else {
        if (!loaded->ours) onto = fitted(std::move(onto));
        keepIds(now, onto);
    }
    CarriedFeel carried = carryFeel(now, onto);
    if (carried.surfaces == 0)
        return inputError(shownPath(file) +
                          ": no surface has the name of one in the scene; name the materials alike");
    std::ranges::move(carried.findings, std::back_inserter(findings));
    sayWhatTheFileLacks(findings, now, onto, known);
    // Notes about meshes were there before; what is wrong with one is looked for anew, and listed as a
    // problem.
    std::ranges::copy_if(loaded->findings, std::back_inserter(findings), [](const Finding& finding) {
        return finding.severity != Finding::Severity::Note && !saysHealth(finding);
    });
    updated.told.withFeel = carried.surfaces;
    for (const SceneObject& object : onto.objects)
        updated.told.surfaces += object.surfaces.size();
    updated.scene = std::move(onto);
    return updated;
}

void Document::updateGeometry(const std::filesystem::path& file, const AxesChoice& choice) {
    editing_.start([=, this, now = scene_, source = source_,
                    of = scenes_](const Progress& progress) -> BackgroundJob::Delivery {
        auto result = std::make_shared<Result<Updated>>(updated(now, source, file, choice, progress));
        return [=, this] {
            if (!*result) return emit editEnded(QString::fromStdString(result->error().text));
            if (of != scenes_ || !(scene_ == now))
                return emit editEnded(tr("%1 was left out: the scene was edited meanwhile. Update it again.")
                                          .arg(QString::fromStdU16String(file.filename().u16string())));
            const GeometryUpdate told = (*result)->told;
            takeGeometry(std::move(**result));
            emit editEnded({});
            emit geometryUpdated(told);
        };
    });
    emit editProgressed(0, -1);
}

} // namespace tactum
