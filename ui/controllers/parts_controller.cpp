#include "ui/controllers/parts_controller.h"

#include <algorithm>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "core/scene/primitives.h"
#include "core/scene/standing.h"
#include "ui/base/ask_where.h"
#include "ui/base/mnemonics.h"
#include "ui/base/numbers.h"
#include "ui/controllers/edit_notice.h"
#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/document/taken_as.h"
#include "ui/panels/outliner.h"
#include "ui/showing/playback.h"
#include "ui/showing/recording_saver.h"
#include "ui/tools/arrange_tool.h"
#include "ui/tools/hand_link.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, Primitive> kPrimitives[] = {{"add-box", Primitive::Box},
                                                             {"add-sphere", Primitive::Sphere},
                                                             {"add-cylinder", Primitive::Cylinder},
                                                             {"add-plate", Primitive::Plate}};

QString shownName(const std::filesystem::path& file) {
    return QString::fromStdU16String(file.filename().u16string());
}

QString sentenceFor(const SceneAddition& addition, const Scene& scene) {
    const auto& files = addition.files;
    const SceneObject* object = scene.find(addition.objects.empty() ? 0 : addition.objects.front());
    QString text = files.size() > 1 ? QObject::tr("%1 files are in the scene now.").arg(files.size())
                                    : QObject::tr("%1 is in the scene now.")
                                          .arg(files.size() == 1 ? shownName(files.front())
                                               : object          ? QString::fromStdString(object->name)
                                                                 : QString());
    for (const auto& [file, across] : addition.scaled)
        text += QObject::tr(" %1 was %2 across and has been scaled to %3 so that it fits a hand.")
                    .arg(shownName(file), lengthText(across), lengthText(kHandDiagonal));
    for (const std::string& refused : addition.refused)
        text += QObject::tr(" Left out: %1.").arg(QString::fromStdString(refused));
    return text;
}

/// The object of which some surfaces are selected and some are not; null: there is none.
const SceneObject* objectInPart(const Scene& scene, const std::vector<ObjectId>& objects,
                                const SurfaceRefs& selected) {
    for (const ObjectId id : objects) {
        const SceneObject* object = scene.find(id);
        const auto taken = std::ranges::count(selected, id, &SurfaceRef::object);
        if (object && taken < std::ssize(object->surfaces)) return object;
    }
    return nullptr;
}

/// What went with the selected, where that is more than a person sees. `part`: of which not all was selected.
QString sentenceFor(const Removed& removed, const QString& part) {
    if (removed.joints == 0 && part.isEmpty()) return {};
    QString text;
    if (!part.isEmpty()) text = QObject::tr("All of %1 went, not its selected surfaces alone.").arg(part);
    if (removed.joints > 0 && !text.isEmpty()) text += u' ';
    if (removed.joints > 0)
        text += removed.joints == 1 ? QObject::tr("A joint went with it.")
                                    : QObject::tr("%1 joints went with it.").arg(removed.joints);
    QStringList loose;
    for (const std::string& name : removed.loose)
        loose << QString::fromStdString(name);
    if (!loose.isEmpty())
        text += QObject::tr(" Hangs on nothing now: %1.").arg(loose.join(QObject::tr(", ")));
    return text + QObject::tr(" Undo brings all of it back.");
}

/// Whether all of a box is in the picture of every pane.
bool isInPicture(const SceneView& view, const Bounds& box) {
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners.emplace_back((i & 1 ? box.high : box.low).x(), (i & 2 ? box.high : box.low).y(),
                             (i & 4 ? box.high : box.low).z());
    for (std::size_t pane = 0; pane < view.panes().size(); ++pane)
        if (view.cameraOf(pane).filled(corners) > 1) return false;
    return true;
}

} // namespace

PartsController::PartsController(const Workbench& bench, ArrangeTool& arranging, HandLink& hand,
                                 Outliner& outliner, QStringList samples)
    : QObject(&bench.window), bench_(bench), arranging_(arranging), hand_(hand),
      samples_(std::move(samples)) {
    bench.on("add", this, [this] { askToAdd(); });
    for (const auto& [id, primitive] : kPrimitives)
        bench.on(id, this, [this, kind = primitive] {
            bench_.playback.end();
            bench_.document.add(sceneOf(kind));
        });
    bench.on("duplicate", this, [this] { duplicate(); });
    bench.on("remove", this, [this] { removeSelected(); });
    bench.on("drop", &arranging, [&arranging] { arranging.dropToGround(); });
    bench.on("rename", &outliner, [&outliner] { outliner.renameSelected(); });
    connect(&bench.document, &Document::added, this, &PartsController::showAdded);
    connect(&outliner, &Outliner::menuAsked, this,
            [this, &outliner](const QPoint& at) { showMenu(at, outliner); });
    connect(&bench.view, &SceneView::handGrabbed, this, [this](bool grabbed) { grabbed_ = grabbed; });
}

void PartsController::askInView(const std::optional<PickHit>& hit, const QPoint& at) {
    const auto& selected = bench_.document.selected();
    if (hit && std::ranges::find(selected, hit->surface) == selected.end())
        bench_.actions["arrange"].isChecked() ? arranging_.choose(hit, {})
                                              : bench_.document.select(hit->surface);
    showMenu(at, bench_.view);
}

void PartsController::fillSamples(QMenu& menu) {
    for (const QString& sample : samples_)
        menu.addAction(QFileInfo(sample).completeBaseName(), this, [this, sample] { add({sample}); });
    menu.setEnabled(!samples_.isEmpty());
    giveMnemonics(menu);
}

void PartsController::askToAdd() {
    add(QFileDialog::getOpenFileNames(&bench_.window, tr("Add models"), recentFiles().value(0),
                                      modelFilter()));
}

void PartsController::add(const QStringList& files) {
    if (files.isEmpty()) return;
    bench_.playback.end();
    dropped_.clear();
    std::vector<FileToAdd> all;
    for (const QString& file : files) {
        const std::filesystem::path path(file.toStdU16String());
        all.push_back({path, rememberedAxes(path)});
    }
    bench_.document.add(all);
}

void PartsController::drop(const QStringList& files) {
    if (files.size() == 1 && (!bench_.document.isOpen() || isRecording(files[0]))) {
        emit opens(files[0]);
        return;
    }
    add(files);
    if (files.size() == 1) dropped_ = files[0];
}

void PartsController::showAdded(const SceneAddition& addition) {
    const QString sentence = sentenceFor(addition, bench_.document.scene());
    const QString file = std::exchange(dropped_, {});
    bench_.told.keep(sentence);
    const auto undo = [this] { bench_.document.history().undo(); };
    const QString severity = addition.refused.empty() ? QStringLiteral("note") : QStringLiteral("error");
    if (!file.isEmpty()) {
        bench_.notice.offer(sentence, severity, tr("Open it alone"), [this, undo, file] {
            if (bench_.told.isLast()) undo();
            emit opens(file);
        });
        bench_.notice.alsoOffer(tr("Undo"), undo);
    } else if (!addition.refused.empty())
        bench_.notice.showError(sentence);
    else
        bench_.notice.showNote(sentence);
    const bool alone = bench_.document.scene().objects.size() == addition.objects.size();
    if (alone || !isInPicture(bench_.view, boundsOf(bench_.document.scene(), addition.objects)))
        bench_.view.fitAll();
    if (alone || !grabbed_) hand_.placeBeside(); // not inside of what came
    bench_.view.setFocus();
}

void PartsController::duplicate() {
    if (!bench_.document.selection()) return bench_.notice.showNote(arranging_.whyNot());
    bench_.document.duplicate(bench_.document.selectedObjects());
}

void PartsController::removeSelected() {
    const std::vector<ObjectId> chosen = bench_.document.selectedObjects();
    if (chosen.empty()) return bench_.notice.showNote(arranging_.whyNot());
    for (const ObjectId id : chosen) {
        const SceneObject& object = *bench_.document.scene().find(id);
        if (std::ranges::any_of(object.surfaces, &Surface::locked))
            return bench_.notice.showNote(
                tr("%1 is locked; Surface > Lock unlocks it.").arg(QString::fromStdString(object.name)));
    }
    const SceneObject* part = objectInPart(bench_.document.scene(), chosen, bench_.document.selected());
    const QString partName = part ? QString::fromStdString(part->name) : QString();
    const QString more = sentenceFor(bench_.document.removeObjects(chosen), partName);
    if (more.isEmpty()) return;
    bench_.notice.showNote(more);
    bench_.told.keep(more);
}

void PartsController::showMenu(const QPoint& at, QWidget& over) {
    auto* menu = new QMenu(&over);
    menu->setObjectName(QStringLiteral("object-menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool chosen = bench_.document.selection().has_value();
    const std::initializer_list<const char*> ofObjects = {
        "rename",       "duplicate",  "remove",    "drop",           "",         "group",      "ungroup",
        "select-group", "",           "hide",      "isolate",        "show-all", "lock",       "",
        "copy-feel",    "paste-feel", "same-feel", "surface-colour", "",         "select-like"};
    const std::initializer_list<const char*> ofNothing = {
        "add", "add-box", "add-sphere", "add-cylinder", "add-plate", "", "show-all", "select-all", "fit"};
    for (const char* id : chosen ? ofObjects : ofNothing)
        if (*id)
            menu->addAction(&bench_.actions[id]);
        else
            menu->addSeparator();
    menu->popup(at);
}

} // namespace tactum
