// What the view shows of how things feel: its commands, remembered, and what feeds it each frame.
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "ui/base/ask_where.h"
#include "ui/controllers/study_controller.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/layer_panel.h"
#include "ui/showing/playback.h"
#include "ui/sound/sound_link.h"
#include "ui/study/study_session.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

/// Commands that are remembered, and the switch that each of them is.
struct Switch {
    const char* id;
    bool FeltOptions::*on;
};
constexpr Switch kSwitches[] = {{"contact-normals", &FeltOptions::normals},
                                {"contact-planes", &FeltOptions::planes},
                                {"friction-cone", &FeltOptions::cone},
                                {"trail", &FeltOptions::trail},
                                {"felt-normals", &FeltOptions::feltNormals},
                                {"spheres", &FeltOptions::spheres},
                                {"relief", &FeltOptions::relief},
                                {"ground", &FeltOptions::ground},
                                {"boundaries", &FeltOptions::boundaries},
                                {"wireframe", &FeltOptions::wireframe},
                                {"parallel", &FeltOptions::parallel}};
constexpr std::pair<const char*, FeltValue> kMaps[] = {{"map-stiffness", FeltValue::Stiffness},
                                                       {"map-damping", FeltValue::Damping},
                                                       {"map-static-friction", FeltValue::StaticFriction},
                                                       {"map-dynamic-friction", FeltValue::DynamicFriction},
                                                       {"map-viscosity", FeltValue::Viscosity},
                                                       {"map-height", FeltValue::Height}};
constexpr std::pair<const char*, double> kBumps[] = {{"bumps-1", 1}, {"bumps-10", 10}, {"bumps-100", 100}};

QString settingOf(const char* id) {
    return QStringLiteral("view/") + QString::fromLatin1(id);
}

} // namespace

void MainWindow::connectFelt() {
    const QSettings settings;
    const auto remembered = [&](const char* id, bool initial) {
        actions_[id].setChecked(settings.value(settingOf(id), initial).toBool());
        connect(&actions_[id], &QAction::toggled, this, &MainWindow::showFelt);
    };
    // One of each list at most: a click on the one that is on switches it off.
    const auto group = [&](const auto& rows) {
        auto* one = new QActionGroup(this);
        one->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
        for (const auto& [id, value] : rows) {
            one->addAction(&actions_[id]);
            remembered(id, false);
        }
    };
    for (const auto& [id, on] : kSwitches)
        remembered(id, FeltOptions{}.*on);
    group(kMaps);
    group(kBumps);
    FeltOptions options;
    options.sphereLevel = settings.value(QStringLiteral("view/sphere-level"), options.sphereLevel).toInt();
    view_->setFelt(options);
    const auto step = [this](int levels) {
        FeltOptions next = view_->felt();
        next.sphereLevel = std::clamp(next.sphereLevel + levels, 0, kDeepestLevel);
        QSettings().setValue(QStringLiteral("view/sphere-level"), next.sphereLevel);
        view_->setFelt(next);
    };
    connect(&actions_["spheres-finer"], &QAction::triggered, this, [step] { step(1); });
    connect(&actions_["spheres-coarser"], &QAction::triggered, this, [step] { step(-1); });
    connect(&publisher_, &WorldPublisher::published, this, [this] {
        // In a study the view keeps the first one: what is seen does not say what is felt.
        const bool blind = study_->running() && study_->session().run().step() != StudyStep::Instructions;
        if (!playback_->active() && !blind) view_->setWorld(publisher_.world());
    });
    connectSound();
    connect(&actions_["export-plot"], &QAction::triggered, this, &MainWindow::exportPlot);
    connect(docks_.plot, &ForcePlot::exportRequested, this, &MainWindow::exportPlot);
    showFelt();
}

void MainWindow::exportPlot() {
    const QString file = askWhere(this, tr("Export the plot"),
                                  {{tr("Numbers"), QStringLiteral("csv")},
                                   {tr("Pictures"), QStringLiteral("png")},
                                   {tr("Drawings"), QStringLiteral("svg")}},
                                  QStringLiteral("touch.csv"));
    if (file.isEmpty()) return;
    const auto written = docks_.plot->exportTo(file);
    if (written)
        notice_->showNote(tr("The plot was written to %1.").arg(file));
    else
        notice_->showError(QString::fromStdString(written.error().text));
}

void MainWindow::showFelt() {
    QSettings settings;
    const auto on = [&](const char* id) {
        const bool checked = actions_[id].isChecked();
        settings.setValue(settingOf(id), checked);
        return checked;
    };
    FeltOptions options;
    options.sphereLevel = view_->felt().sphereLevel;
    for (const auto& [id, value] : kSwitches)
        options.*value = on(id);
    for (const auto& [id, value] : kMaps)
        if (on(id)) options.map = value;
    for (const auto& [id, value] : kBumps)
        if (on(id)) options.bumps = value;
    for (const char* id : {"spheres-finer", "spheres-coarser"})
        actions_[id].setEnabled(options.spheres);
    view_->setFelt(options);
}

void MainWindow::drawTrace() {
    trace_.clear();
    for (TracePoint point; engine_.popTrace(point);)
        trace_.push_back(point);
    docks_.plot->take(trace_, engine_.proxy().output, engine_.device().maxForce, engine_.proxy().rate,
                      view_->readingOf(engine_.proxy(), docks_.body->body()), touchedName_);
    view_->addTrail(trace_, engine_.proxy().output);
    sound_->play(trace_);
    docks_.layers->take(trace_, engine_.proxy().time);
}

// Whether there is an output is asked when the menu opens: the answer may take a moment, and may change.
void MainWindow::connectSound() {
    QAction& sound = actions_["sound"];
    connect(&sound, &QAction::toggled, this, &MainWindow::setSound);
    auto* menu = menuBar()->findChild<QMenu*>(QStringLiteral("View"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [&sound, usual = sound.toolTip()] {
        const QString why = SoundLink::whyNot();
        sound.setEnabled(why.isEmpty() || sound.isChecked());
        sound.setToolTip(why.isEmpty() ? usual : why);
    });
}

void MainWindow::setSound(bool on) {
    if (!on) return sound_->stop();
    if (sound_->start(engine_.device().rate)) return;
    const QString why = SoundLink::whyNot();
    notice_->showNote(why.isEmpty()
                          ? tr("The audio output could not be opened; is another program holding it?")
                          : tr("%1: nothing can be heard.").arg(why));
    actions_["sound"].setChecked(false);
}

} // namespace tactum
