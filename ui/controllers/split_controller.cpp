#include "ui/controllers/split_controller.h"

#include <QActionGroup>
#include <QPointF>
#include <QSettings>

#include "ui/view/scene_view.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, ViewSplit> kWays[] = {
    {"split-columns", ViewSplit::Columns}, {"split-rows", ViewSplit::Rows}, {"split-four", ViewSplit::Four}};
const auto kSplitKey = QStringLiteral("view/split"), kDivisionKey = QStringLiteral("view/split-at"),
           kParallelKey = QStringLiteral("view/parallel");

} // namespace

SplitController::SplitController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), ways_(new QActionGroup(this)) {
    const QSettings settings;
    const QString before = settings.value(kSplitKey).toString();
    ways_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (const auto& [id, way] : kWays) {
        QAction& action = bench_.actions[id];
        ways_->addAction(&action);
        action.setChecked(before == QLatin1String(id));
        connect(&action, &QAction::toggled, this, &SplitController::show);
    }
    bench_.on("split-one", this, [this] {
        if (QAction* on = ways_->checkedAction()) on->setChecked(false);
    });
    bench_.view.setDivision(settings.value(kDivisionKey, bench_.view.division()).toPointF());
    connect(&bench_.view, &SceneView::divided, this,
            [this] { QSettings().setValue(kDivisionKey, bench_.view.division()); });
    show();
    followProjection();
}

// The command is about the active pane, and says how that one is drawn; what is chosen for the own view is
// kept.
void SplitController::followProjection() {
    QAction& action = bench_.actions["parallel"];
    bench_.view.setParallel(QSettings().value(kParallelKey, false).toBool());
    action.setChecked(bench_.view.camera().parallel);
    connect(&action, &QAction::triggered, this, [this](bool parallel) {
        bench_.view.setParallel(parallel);
        if (bench_.view.ownIsActive()) QSettings().setValue(kParallelKey, parallel);
    });
    connect(&bench_.view, &SceneView::projectionChanged, this,
            [this, &action] { action.setChecked(bench_.view.camera().parallel); });
}

// Of two that change places, the one that goes may be told of first: what is on is asked of both.
void SplitController::show() {
    QString name;
    ViewSplit split = ViewSplit::One;
    for (const auto& [id, way] : kWays)
        if (bench_.actions[id].isChecked()) {
            name = QLatin1String(id);
            split = way;
        }
    QSettings().setValue(kSplitKey, name);
    bench_.view.setSplit(split);
}

} // namespace tactum
