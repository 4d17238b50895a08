// Objects that come into the scene, are doubled, renamed, and go: commands, dropped files, and what is told.
#include "ui/window/main_window.h"

#include <algorithm>

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QStandardPaths>

#include "core/scene/primitives.h"
#include "core/scene/standing.h"
#include "ui/base/ask_where.h"
#include "ui/base/mnemonics.h"
#include "ui/base/numbers.h"
#include "ui/controllers/edit_notice.h"
#include "ui/controllers/save_controller.h"
#include "ui/controllers/study_controller.h"
#include "ui/document/recent_files.h"
#include "ui/panels/outliner.h"
#include "ui/panels/start_page.h"
#include "ui/showing/playback.h"
#include "ui/showing/recording_saver.h"
#include "ui/study/study_session.h"
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
    QString text = files.size() > 1 ? MainWindow::tr("%1 files are in the scene now.").arg(files.size())
                                    : MainWindow::tr("%1 is in the scene now.")
                                          .arg(files.size() == 1 ? shownName(files.front())
                                               : object          ? QString::fromStdString(object->name)
                                                                 : QString());
    for (const auto& [file, across] : addition.scaled)
        text += MainWindow::tr(" %1 was %2 across and has been scaled to %3 so that it fits a hand.")
                    .arg(shownName(file), lengthText(across), lengthText(kHandDiagonal));
    for (const std::string& refused : addition.refused)
        text += MainWindow::tr(" Left out: %1.").arg(QString::fromStdString(refused));
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
    if (!part.isEmpty()) text = MainWindow::tr("All of %1 went, not its selected surfaces alone.").arg(part);
    if (removed.joints > 0 && !text.isEmpty()) text += u' ';
    if (removed.joints > 0)
        text += removed.joints == 1 ? MainWindow::tr("A joint went with it.")
                                    : MainWindow::tr("%1 joints went with it.").arg(removed.joints);
    QStringList loose;
    for (const std::string& name : removed.loose)
        loose << QString::fromStdString(name);
    if (!loose.isEmpty())
        text += MainWindow::tr(" Hangs on nothing now: %1.").arg(loose.join(MainWindow::tr(", ")));
    return text + MainWindow::tr(" Undo brings all of it back.");
}

/// Whether all of a box is in the picture.
bool isInPicture(const SceneView& view, const Bounds& box) {
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3 corner((i & 1 ? box.high : box.low).x(), (i & 2 ? box.high : box.low).y(),
                          (i & 4 ? box.high : box.low).z());
        const auto at = view.camera().project(corner);
        if (!at || !QRectF(view.rect()).contains(*at)) return false;
    }
    return true;
}

} // namespace

void MainWindow::connectParts() {
    for (const auto& [id, ground] : {std::pair{"new", false}, {"new-ground", true}})
        connect(&actions_[id], &QAction::triggered, this, [this, onGround = ground] {
            save_->leave(tr("beginning a new scene"), [this, onGround] {
                playback_->end();
                document_.begin(onGround ? sceneOf(Primitive::Ground) : Scene());
            });
        });
    connect(start_, &StartPage::newRequested, &actions_["new-ground"], &QAction::trigger);
    connect(&actions_["add"], &QAction::triggered, this, &MainWindow::askToAdd);
    for (const auto& [id, primitive] : kPrimitives)
        connect(&actions_[id], &QAction::triggered, this, [this, kind = primitive] {
            playback_->end();
            document_.add(sceneOf(kind));
        });
    connect(&document_, &Document::added, this, &MainWindow::showAdded);
    connect(&actions_["duplicate"], &QAction::triggered, this, [this] {
        if (!document_.selection()) return notice_->showNote(arranging_->whyNot());
        document_.duplicate(document_.selectedObjects());
    });
    connect(&actions_["remove"], &QAction::triggered, this, &MainWindow::removeSelected);
    connect(&actions_["drop"], &QAction::triggered, arranging_, &ArrangeTool::dropToGround);
    connect(&actions_["rename"], &QAction::triggered, docks_.outliner, &Outliner::renameSelected);
    connect(docks_.outliner, &Outliner::menuAsked, this,
            [this](const QPoint& at) { showObjectMenu(at, *docks_.outliner); });
    connect(view_, &SceneView::menuAsked, this, [this](const std::optional<PickHit>& hit, const QPoint& at) {
        if (playback_->active() || study_->running()) return;
        const bool chosen =
            hit && std::ranges::find(document_.selected(), hit->surface) != document_.selected().end();
        if (hit && !chosen)
            actions_["arrange"].isChecked() ? arranging_->choose(hit, {}) : document_.select(hit->surface);
        showObjectMenu(at, *view_);
    });
}

void MainWindow::fillSamples(QMenu* menu) {
    for (const QString& sample : samples_)
        menu->addAction(QFileInfo(sample).completeBaseName(), this, [this, sample] { addFiles({sample}); });
    menu->setEnabled(!samples_.isEmpty());
    giveMnemonics(*menu);
}

void MainWindow::askToAdd() {
    addFiles(QFileDialog::getOpenFileNames(this, tr("Add models"), recentFiles().value(0), modelFilter()));
}

void MainWindow::addFiles(const QStringList& files) {
    if (files.isEmpty()) return;
    playback_->end();
    dropped_.clear();
    std::vector<FileToAdd> all;
    for (const QString& file : files) {
        const std::filesystem::path path(file.toStdU16String());
        all.push_back({path, rememberedAxes(path)});
    }
    document_.add(all);
}

/// What is dropped on a scene comes into it; alone, and on the start page, it is opened.
void MainWindow::dropModels(const QStringList& files) {
    if (files.size() == 1 && (!document_.isOpen() || isRecording(files[0]))) return open(files[0]);
    addFiles(files);
    if (files.size() == 1) dropped_ = files[0];
}

void MainWindow::showAdded(const SceneAddition& addition) {
    const QString sentence = sentenceFor(addition, document_.scene());
    const QString file = std::exchange(dropped_, {});
    told_->keep(sentence);
    const auto undo = [this] { document_.history().undo(); };
    const QString severity = addition.refused.empty() ? QStringLiteral("note") : QStringLiteral("error");
    if (!file.isEmpty()) {
        notice_->offer(sentence, severity, tr("Open it alone"), [this, undo, file] {
            if (told_->isLast()) undo();
            open(file);
        });
        notice_->alsoOffer(tr("Undo"), undo);
    } else if (!addition.refused.empty())
        notice_->showError(sentence);
    else
        notice_->showNote(sentence);
    const bool alone = document_.scene().objects.size() == addition.objects.size();
    if (alone || !isInPicture(*view_, boundsOf(document_.scene(), addition.objects))) view_->fit();
    if (alone || !grabbed_) hand_->placeBeside(); // not inside of what came
    view_->setFocus();
}

void MainWindow::removeSelected() {
    const std::vector<ObjectId> chosen = document_.selectedObjects();
    if (chosen.empty()) return notice_->showNote(arranging_->whyNot());
    for (const ObjectId id : chosen) {
        const SceneObject& object = *document_.scene().find(id);
        if (std::ranges::any_of(object.surfaces, &Surface::locked))
            return notice_->showNote(
                tr("%1 is locked; Surface > Lock unlocks it.").arg(QString::fromStdString(object.name)));
    }
    const SceneObject* part = objectInPart(document_.scene(), chosen, document_.selected());
    const QString partName = part ? QString::fromStdString(part->name) : QString();
    const QString more = sentenceFor(document_.removeObjects(chosen), partName);
    if (more.isEmpty()) return;
    notice_->showNote(more);
    told_->keep(more);
}

void MainWindow::showObjectMenu(const QPoint& at, QWidget& over) {
    auto* menu = new QMenu(&over);
    menu->setObjectName(QStringLiteral("object-menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool chosen = document_.selection().has_value();
    const std::initializer_list<const char*> ofObjects = {
        "rename",       "duplicate",  "remove",    "drop",    "",           "group", "ungroup",
        "select-group", "",           "hide",      "isolate", "show-all",   "lock",  "",
        "copy-feel",    "paste-feel", "same-feel", "",        "select-like"};
    const std::initializer_list<const char*> ofNothing = {
        "add", "add-box", "add-sphere", "add-cylinder", "add-plate", "", "show-all", "select-all", "fit"};
    for (const char* id : chosen ? ofObjects : ofNothing)
        if (*id)
            menu->addAction(&actions_[id]);
        else
            menu->addSeparator();
    menu->popup(at);
}

} // namespace tactum
