// The document and its file: opening, saving, and whose the file is.
#include <algorithm>

#include "core/bundle/bundle.h"
#include "core/files/save_scene.h"
#include "core/import/import_scene.h"
#include "core/scene/surface_colours.h"
#include "ui/document/document.h"

namespace tactum {

FileStamp::FileStamp(const std::filesystem::path& file) : path(file) {
    std::error_code fault; // a file that is gone has neither
    written = std::filesystem::last_write_time(file, fault);
    bytes = std::filesystem::file_size(file, fault);
}

void Document::open(const std::filesystem::path& file, bool isSample, const AxesChoice& choice) {
    // As it is remembered.
    openAs(std::filesystem::absolute(file).lexically_normal(), isSample, choice, false);
}

void Document::reopen(const AxesChoice& choice) {
    openAs(path(), false, choice, true);
}

void Document::openAs(const std::filesystem::path& file, bool isSample, const AxesChoice& choice, bool anew) {
    adding_ = false;
    job_.start([=, this](const Progress& progress) -> BackgroundJob::Delivery {
        const FileStamp stamp(file);
        auto loaded = std::make_shared<Result<LoadedScene>>(importScene(file, progress));
        if (!*loaded)
            return [this, loaded] { emit openFailed(QString::fromStdString(loaded->error().text)); };
        const bool ours = (*loaded)->ours;
        if (!ours) tellSurfacesApart((*loaded)->scene);
        const auto taken = takeAs(**loaded, choice);
        return [=, this, fitting = ours ? (*loaded)->scene : fitted((*loaded)->scene)] {
            if (anew && modified())
                return emit openFailed(tr("%1 was not opened anew: the scene was edited meanwhile.")
                                           .arg(QString::fromStdU16String(file.filename().u16string())));
            const Source source{stamp, taken ? taken->axes : FileAxes(), (*loaded)->scene, taken};
            adopt(std::move(**loaded), stamp);
            source_ = source;
            own_ = ours && !isSample;
            fit(fitting);
            history_.setClean(); // nobody has done anything yet that could be lost
            emit opened();
        };
    });
    emit openProgressed(0, -1);
}

void Document::begin(Scene scene) {
    job_.cancel();
    adopt({std::move(scene), {}, true}, {});
    source_ = {};
    own_ = false;
    history_.setClean();
    emit opened();
}

void Document::adoptShared(Scene scene, const std::filesystem::path& file) {
    job_.cancel();
    adopt({std::move(scene), {}, true}, FileStamp(file));
    source_ = {}; // kept elsewhere
    own_ = false;
    emit opened();
}

bool Document::hasOwnFile() const {
    const QString ending = QString::fromStdU16String(path().extension().u16string());
    return own_ && ending.compare(u'.' + QString::fromUtf8(kSceneEnding), Qt::CaseInsensitive) == 0;
}

bool Document::changedOutside() const {
    return FileStamp(path()) != file_;
}

// The copy of the scene shares meshes and images with it.
void Document::write(Writer* writer, const std::filesystem::path& file, std::function<void()> done) {
    saving_.start([=, this, scene = scene_](const Progress& progress) -> BackgroundJob::Delivery {
        const Result<void> written = writer(scene, file, progress);
        if (written) return done;
        return [this, error = written.error()] { emit saveFailed(QString::fromStdString(error.text)); };
    });
}

void Document::save(const std::filesystem::path& file) {
    if (saving_.running()) return nextSaves_.push_back([=, this] { save(file); });
    write(saveScene, file, [this, file, scene = scene_, of = scenes_] {
        if (of == scenes_) {
            file_ = FileStamp(file);
            own_ = true;
            source_.taken.reset();
            if (source_.file.path == file) source_ = {file_, {}, scene, {}, source_.gone};
            // The step of the history may be the same one and hold something else by now.
            if (scene == scene_)
                history_.setClean();
            else
                history_.resetClean();
        }
        emit saved(QString::fromStdU16String(file.u16string()));
    });
}

void Document::exportBundle(const std::filesystem::path& file) {
    if (saving_.running()) return nextSaves_.push_back([=, this] { exportBundle(file); });
    write(saveBundle, file, [this, file] { emit exported(QString::fromStdU16String(file.u16string())); });
}

void Document::adopt(LoadedScene loaded, const FileStamp& file) {
    ++scenes_;
    lastId_ = 0;
    trying_ = 0;
    trial_.reset();
    history_.clear();
    selected_.clear();
    lost_.clear();
    faces_ = {};
    scene_ = std::move(loaded.scene);
    findings_.clear();
    for (Finding& finding : loaded.findings) {
        const auto object = std::ranges::find(scene_.objects, finding.object, &SceneObject::name);
        const bool known = !finding.object.empty() && object != scene_.objects.end();
        findings_.push_back({std::move(finding), known ? object->id : 0});
    }
    file_ = file;
    source_ = {file, {}, std::nullopt};
    announce({SceneChange::What::Everything});
    if (!scene_.objects.empty()) select(SurfaceRef{scene_.objects.front().id, 0});
}

} // namespace tactum
