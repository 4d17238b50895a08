#include "ui/panels/problems.h"

#include <algorithm>

#include <QHeaderView>
#include <QPushButton>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/panels/finding_list.h"

namespace tactum {

namespace {

QString problemWordsOf(const PlacedFinding& found) {
    switch (found.repair) {
    case Repair::FillHoles:
        return Problems::tr("Close the holes whose rim is simple; wide openings stay.");
    case Repair::AgreeOnFronts:
        return Problems::tr("Turn triangles over until neighbours agree, with the front outside.");
    case Repair::RemoveDuplicates:
        return Problems::tr("Remove triangles that repeat another one of the same surface and front.");
    case Repair::RepairSlivers:
        return Problems::tr("Take these triangles out without opening the mesh.");
    case Repair::Scale:
        return Problems::tr("Scale the scene by %1.").arg(numberText(found.factor, 4));
    case Repair::None:
        break;
    }
    return {};
}

/// The surface that a finding concerns first.
Index surfaceOf(const SceneObject& object, const PlacedFinding& found) {
    if (!found.problem || found.problem->triangles.empty()) return 0;
    const Index first = found.problem->triangles.front();
    const auto& surfaceOf = object.geometry->surfaceOf;
    return first < surfaceOf.size() ? surfaceOf[first] : 0;
}

} // namespace

Problems::Problems(Document& document, QWidget* parent)
    : HintedTree(tr("No problems found. What is doubtful about a mesh or a value will be listed here."),
                 parent),
      document_(document) {
    setObjectName(QStringLiteral("problems"));
    setAccessibleName(tr("Problems"));
    setRootIsDecorated(false);
    setWrapping();
    setColumnCount(2);
    header()->setSectionResizeMode(1, QHeaderView::Fixed); // a column does not ask its widgets
    header()->resizeSection(1, 7 * kRhythm);
    connect(this, &QTreeWidget::itemActivated, this, &Problems::show);
    connect(this, &QTreeWidget::itemClicked, this, &Problems::show);
    connect(&repairing_, &BackgroundJob::progressed, this, &Problems::repairProgressed);
    connect(&document_, &Document::changed, this, [this](const SceneChange& change) {
        using What = SceneChange::What;
        if (change.touchesShape() || change.what == What::Sides || change.what == What::Names) check();
        if (change.what == What::Selection && !showing_) emit placeGone();
    });
}

void Problems::check() {
    emit placeGone();
    job_.start([this, scene = document_.scene(),
                known = known_](const Progress& progress) -> BackgroundJob::Delivery {
        auto examined = std::make_shared<Result<Examined>>(examine(scene, known, progress));
        return [this, examined] {
            if (*examined) fill(std::move(**examined));
        };
    });
}

void Problems::fill(Examined examined) {
    clear();
    rows_.clear();
    known_ = std::move(examined.meshes);
    // What the reader said of a mesh may be repaired by now, or is said again with its place.
    for (const Finding& finding : document_.findings())
        if (!saysHealth(finding)) add({finding, 0, {}, Repair::None, 1});
    for (const PlacedFinding& found : examined.findings) {
        const auto isSame = [&](const PlacedFinding& row) { return row.finding == found.finding; };
        if (found.problem || std::ranges::none_of(rows_, isSame)) add(found);
    }
    wrapRows();
    emit counted(topLevelItemCount());
}

void Problems::add(const PlacedFinding& found) {
    auto* item = addFindingRow(*this, found.finding);
    rows_.push_back(found);
    if (found.repair != Repair::None) addButton(item, found);
}

void Problems::addButton(QTreeWidgetItem* item, const PlacedFinding& found) {
    auto* button = new QPushButton(tr("Fix"), this);
    button->setProperty("inRow", true);
    button->setObjectName(QStringLiteral("fix"));
    button->setAccessibleName(tr("Fix %1").arg(findingLine(found.finding)));
    button->setToolTip(problemWordsOf(found));
    connect(button, &QPushButton::clicked, this, [this, found] { repair(found); });
    setItemWidget(item, 1, button);
}

void Problems::show(QTreeWidgetItem* item) {
    const PlacedFinding& found = rows_[std::size_t(indexOfTopLevelItem(item))];
    const std::string& name = found.finding.object;
    showing_ = true;
    for (const SceneObject& object : document_.scene().objects)
        if (found.object == 0 ? object.name == name : object.id == found.object) {
            document_.select(SurfaceRef{object.id, surfaceOf(object, found)});
            break;
        }
    showing_ = false;
    if (found.problem)
        emit placeAsked(found.object, *found.problem);
    else
        emit placeGone();
}

void Problems::repair(const PlacedFinding& found) {
    if (found.repair == Repair::Scale) return document_.scaleScene(found.factor);
    const SceneObject* object = document_.scene().find(found.object);
    if (!object || repairing_.running()) return;
    if (std::ranges::any_of(object->surfaces, &Surface::locked))
        return emit repaired(
            tr("%1 has a locked surface. Unlock it first.").arg(QString::fromStdString(object->name)));
    repairing_.start(
        [this, before = *object, how = found.repair](const Progress& progress) -> BackgroundJob::Delivery {
            const Result<Repaired> result = tactum::repair(before.geometry, how, progress);
            const SceneObject after = result ? withGeometry(before, result->soup) : before;
            return [this, before, after, result] { finishRepair(before, after, result); };
        });
}

void Problems::finishRepair(const SceneObject& before, const SceneObject& after,
                            const Result<Repaired>& result) {
    const SceneObject* object = document_.scene().find(before.id);
    if (!result || !object || !(*object == before)) // cancelled, or edited meanwhile
        return emit repaired(tr("Nothing was changed."));
    const QString name = QString::fromStdString(object->name);
    const QString done = QString::fromStdString(result->done);
    document_.setObject(after, tr("Repair %1").arg(name));
    emit repaired(result->changes > 0
                      ? tr("%1: %2. Undo takes it back.").arg(name, done)
                      : tr("%1: %2; repair this one in the modelling program.").arg(name, done));
}

} // namespace tactum
