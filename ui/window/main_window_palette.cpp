// The command palette of the window, and the way from panel to panel.
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/controllers/selection_sets_menu.h"
#include "ui/document/recent_files.h"
#include "ui/panels/import_bar.h"
#include "ui/showing/playback.h"
#include "ui/widgets/command_palette.h"
#include "ui/window/folds.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_focus.h"
#include "ui/window/value_entries.h"

namespace tactum {

namespace {

QString plain(QString text) {
    if (text.endsWith(QStringLiteral("..."))) text.chop(3);
    return text.remove(u'&');
}

/// "View/&Camera" as "View > Camera".
QString menuPath(const char* menu) {
    QStringList path;
    for (const QString& part : QString::fromLatin1(menu).split(u'/'))
        path << plain(QObject::tr(qPrintable(part)));
    return path.join(QStringLiteral(" > "));
}

/// Why a command can be off, where there is one reason alone.
struct Reason {
    const char* id;
    const char* sentence;
};
constexpr auto kNotOffered =
    QT_TR_NOOP("The file says it, or it could lose edits; see the bar over the view after opening.");
constexpr auto kNothingThere = QT_TR_NOOP("Nothing is open, or the scene is empty.");
constexpr Reason kReasons[] = {
    {"save", kNothingThere},
    {"save-as", kNothingThere},
    {"export", kNothingThere},
    {"update-geometry", kNothingThere},
    {"save-picture", kNothingThere},
    {"taken-m", kNotOffered},
    {"taken-cm", kNotOffered},
    {"taken-mm", kNotOffered},
    {"taken-in", kNotOffered},
    {"up-y", kNotOffered},
    {"up-z", kNotOffered},
    {"undo", QT_TR_NOOP("There is no edit to take back.")},
    {"redo", QT_TR_NOOP("No edit was taken back.")},
    {"stop", QT_TR_NOOP("The forces are off already.")},
    {"dead-man", QT_TR_NOOP("This device has no button that could be held.")},
    {"device-connect", QT_TR_NOOP("No other device is chosen in the dock Device that can be used.")},
    {"device-disconnect", QT_TR_NOOP("No device is connected.")},
    {"workspace-centre", QT_TR_NOOP("The mouse leads the simulated hand in the scene itself.")},
    {"workspace-fit", QT_TR_NOOP("The mouse leads the simulated hand in the scene itself.")},
    {"workspace-axes", QT_TR_NOOP("The mouse leads the simulated hand in the scene itself.")},
    {"trial-end", QT_TR_NOOP("The scene is felt already.")},
    {"preset-apply", QT_TR_NOOP("No preset is chosen in the library, or no surface is selected.")},
    {"preset-save", QT_TR_NOOP("No surface is selected.")},
    {"preset-export", QT_TR_NOOP("No preset is chosen in the library.")},
    {"swap-ab", QT_TR_NOOP("No state was marked as A.")},
    {"compare-now", QT_TR_NOOP("There is no stroke, or no state was marked as A.")},
    {"compare-csv", QT_TR_NOOP("Nothing was compared yet.")},
    {"study-save", QT_TR_NOOP("The study has no condition yet.")},
    {"study-keep", kNothingThere},
    {"study-replace", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-show", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-remove", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-run", QT_TR_NOOP("The study cannot be run yet; the dock Study says why.")},
    {"layer-duplicate", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-remove", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-up", QT_TR_NOOP("No layer lies above the selected one.")},
    {"layer-down", QT_TR_NOOP("No layer lies beneath the selected one.")},
    {"layer-show", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-solo", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"mapping",
     QT_TR_NOOP("No layer is selected whose mapping has a frame; choose Triplanar, Planar or a round one.")},
};

} // namespace

QString MainWindow::whyNot(const QString& id) const {
    if (playback_->active()) return tr("A recording is shown; end it first.");
    for (const Reason& reason : kReasons)
        if (id == QLatin1String(reason.id)) return tr(reason.sentence);
    return tr("It has no effect as things are.");
}

void MainWindow::openPalette() {
    std::vector<PaletteEntry> entries;
    for (const Command& command : commands()) {
        QAction& action = actions_[command.id];
        const QString id = action.objectName();
        if (id == QLatin1String("palette")) continue;
        entries.push_back({id, plain(action.text()), menuPath(command.menu),
                           action.shortcut().toString(QKeySequence::NativeText), tr(command.sentence),
                           action.isEnabled() ? QString() : whyNot(id), [&action] { action.trigger(); }});
    }
    addPanels(entries);
    addSurfaces(entries);
    for (const QString& name : sets_->names())
        entries.push_back({{},
                           tr("Select set %1").arg(name),
                           tr("Select"),
                           {},
                           tr("The triangles that are kept under this name"),
                           playback_->active() ? whyNot({}) : QString(),
                           [this, name] { sets_->select(name); }});
    for (const QString& file : recentFiles())
        entries.push_back({{},
                           tr("Open recent %1").arg(QFileInfo(file).fileName()),
                           tr("File"),
                           {},
                           file,
                           {},
                           [this, file] { open(file); }});
    auto* palette = new CommandPalette(std::move(entries), this);
    palette->setSource([this](const QString& typed) {
        return playback_->active() ? std::vector<PaletteEntry>() : valueEntries(document_, typed);
    });
    palette->open();
}

void MainWindow::addPanels(std::vector<PaletteEntry>& entries) {
    for (auto* dock : findChildren<QDockWidget*>()) {
        const QString title = dock->windowTitle().section(QStringLiteral("  "), 0, 0); // without a count
        entries.push_back({dock->objectName(),
                           tr("Panel %1").arg(title),
                           tr("View"),
                           {},
                           tr("Show the panel and give it the keys"),
                           {},
                           [this, dock] {
                               folds_->bringForward(*dock);
                               dock->widget()->setFocus(Qt::ShortcutFocusReason);
                           }});
    }
}

void MainWindow::addSurfaces(std::vector<PaletteEntry>& entries) {
    const QString reason = playback_->active() ? whyNot({}) : QString();
    for (const SceneObject& object : document_.scene().objects)
        for (Index i = 0; i < Index(object.surfaces.size()); ++i) {
            const SurfaceRef ref{object.id, i};
            entries.push_back({{},
                               tr("Select surface %1").arg(QString::fromStdString(object.surfaces[i].name)),
                               QString::fromStdString(object.name),
                               {},
                               tr("See and set how it feels"),
                               reason,
                               [this, ref] { document_.select(ref); }});
        }
}

void MainWindow::connectPalette() {
    connect(&actions_["palette"], &QAction::triggered, this, &MainWindow::openPalette);
    const auto docks = findChildren<QDockWidget*>(); // now: who comes to the front comes last later
    connect(&actions_["next-panel"], &QAction::triggered, this, [this, docks] {
        focusNextPanel({centre_->currentWidget(), importBar_}, docks, *folds_, true);
    });
    connect(&actions_["previous-panel"], &QAction::triggered, this, [this, docks] {
        focusNextPanel({centre_->currentWidget(), importBar_}, docks, *folds_, false);
    });
    auto* search = new QToolButton;
    search->setObjectName(QStringLiteral("palette-button"));
    search->setText(tr("Search for a command   %1")
                        .arg(actions_["palette"].shortcut().toString(QKeySequence::NativeText)));
    search->setToolTip(actions_["palette"].toolTip());
    search->setProperty("search", true);
    search->setFocusPolicy(Qt::NoFocus); // it has its key
    connect(search, &QToolButton::clicked, this, &MainWindow::openPalette);
    menuBar()->setCornerWidget(search);
}

} // namespace tactum
