#include "ui/controllers/docks.h"

#include <QDockWidget>
#include <QTabBar>

#include "ui/base/style.h"
#include "ui/document/document.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/health_panel.h"
#include "ui/panels/history_list.h"
#include "ui/panels/inspector.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/outliner.h"
#include "ui/panels/problems.h"
#include "ui/widgets/force_plot.h"

namespace tactum {

namespace {

QDockWidget* addDock(QMainWindow& window, const QString& name, const QString& title, QWidget* body,
                     Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name); // saveState() knows docks by it
    dock->setWidget(body);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    window.addDockWidget(area, dock);
    return dock;
}

/// While tabs name a dock it needs no title.
void followTabs(QMainWindow& window, QDockWidget& dock) {
    auto* bare = new QWidget(&dock);
    const auto follow = [&window, &dock, bare] {
        // One that is destroyed while it is shown hides its docks when it is a main window no longer.
        if (!qobject_cast<QMainWindow*>(static_cast<QObject*>(&window))) return;
        const auto plain = [&window] { // the window switches it on whenever it makes one
            for (auto* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
                bar->setDrawBase(false);
        };
        plain();
        dock.setTitleBarWidget(window.tabifiedDockWidgets(&dock).isEmpty() ? nullptr : bare);
        bare->setVisible(dock.titleBarWidget());
        plain(); // one that came with it
    };
    follow();
    // Also when all docks are where they will be: while they come back together, each one comes alone.
    const auto followTwice = [&dock, follow] {
        follow();
        QMetaObject::invokeMethod(&dock, follow, Qt::QueuedConnection);
    };
    QObject::connect(&dock, &QDockWidget::visibilityChanged, &dock, followTwice);
    QObject::connect(&dock, &QDockWidget::dockLocationChanged, &dock, followTwice);
}

/// Two docks in one place, the first on top.
void shareTabs(QMainWindow& window, QDockWidget& first, QDockWidget& second) {
    window.setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::North);
    window.tabifyDockWidget(&first, &second);
    first.raise();
    followTabs(window, first);
    followTabs(window, second);
}

} // namespace

/// As QMainWindow writes it down in its tabs.
QDockWidget* dockOf(const QMainWindow& window, const QTabBar& tabs, int tab) {
    const auto at = tabs.tabData(tab).value<quintptr>();
    for (auto* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (quintptr(dock) == at) return dock;
    return nullptr;
}

QTabBar* tabsOf(const QMainWindow& window, const QDockWidget& dock) {
    for (auto* tabs : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        for (int tab = 0; tab < tabs->count(); ++tab)
            if (dockOf(window, *tabs, tab) == &dock) return tabs;
    return nullptr;
}

QDockWidget* dockInFrontOf(const QMainWindow& window, const QDockWidget& dock) {
    const QTabBar* tabs = tabsOf(window, dock);
    QDockWidget* front = tabs ? dockOf(window, *tabs, tabs->currentIndex()) : nullptr;
    return front == &dock ? nullptr : front;
}

void addTabBeside(QMainWindow& window, QDockWidget& beside, const QString& name, const QString& title,
                  QWidget* body) {
    auto* dock = addDock(window, name, title, body, window.dockWidgetArea(&beside));
    const bool firstTab = window.tabifiedDockWidgets(&beside).isEmpty();
    window.tabifyDockWidget(&beside, dock);
    if (firstTab) followTabs(window, beside);
    followTabs(window, *dock);
    window.tabifiedDockWidgets(dock).first()->raise();
}

void sizeDocks(QMainWindow& window) {
    const auto dock = [&](const char* name) {
        return window.findChild<QDockWidget*>(QString::fromLatin1(name));
    };
    window.resizeDocks({dock("dock-outliner"), dock("dock-inspector")}, {kLeftDocks, kRightDocks},
                       Qt::Horizontal);
    window.resizeDocks({dock("dock-outliner"), dock("dock-presets")}, {300, 360}, Qt::Vertical);
    window.resizeDocks({dock("dock-plot")}, {216}, Qt::Vertical);
}

Docks addDocks(QMainWindow& window, Document& document) {
    Docks docks{new Outliner(document), new Inspector(document),  new Problems(document), new ForcePlot,
                new HealthPanel,        new LayerPanel(document), new BodyPanel(document)};
    addDock(window, QStringLiteral("dock-outliner"), QObject::tr("Scene"), searchable(*docks.outliner),
            Qt::LeftDockWidgetArea);
    auto* problems = addDock(window, QStringLiteral("dock-problems"), QObject::tr("Problems"), docks.problems,
                             Qt::LeftDockWidgetArea);
    auto* inspector = addDock(window, QStringLiteral("dock-inspector"), QObject::tr("Surface"),
                              docks.inspector, Qt::RightDockWidgetArea);
    auto* plot = addDock(window, QStringLiteral("dock-plot"), QObject::tr("Force"), docks.plot,
                         Qt::BottomDockWidgetArea);
    auto* health = addDock(window, QStringLiteral("dock-health"), QObject::tr("Health"), docks.health,
                           Qt::BottomDockWidgetArea);
    auto* layers = addDock(window, QStringLiteral("dock-layers"), QObject::tr("Layers"), docks.layers,
                           Qt::RightDockWidgetArea);
    shareTabs(window, *plot, *health);
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    shareTabs(window, *inspector, *layers);
    addTabBeside(window, *layers, QStringLiteral("dock-body"), QObject::tr("Body"), docks.body);
    addTabBeside(window, *problems, QStringLiteral("dock-history"), QObject::tr("History"),
                 new HistoryList(document.history()));
    window.setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::North);
    // The side docks reach down to the status bar; the plot stands under the view alone.
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QObject::connect(docks.problems, &Problems::counted, problems, [problems](int count) {
        problems->setWindowTitle(count ? QObject::tr("Problems  %1").arg(count) : QObject::tr("Problems"));
    });
    return docks;
}

} // namespace tactum
