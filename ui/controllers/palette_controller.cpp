#include "ui/controllers/palette_controller.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/controllers/cameras_menu.h"
#include "ui/controllers/command_reasons.h"
#include "ui/controllers/folds.h"
#include "ui/controllers/panel_focus.h"
#include "ui/controllers/selection_sets_menu.h"
#include "ui/controllers/value_entries.h"
#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/showing/playback.h"
#include "ui/widgets/command_palette.h"

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

} // namespace

PaletteController::PaletteController(const Workbench& bench, Folds& folds, SelectionSetsMenu& sets,
                                     CamerasMenu& cameras, const QStackedWidget& centre, QWidget& importBar)
    : QObject(&bench.window), bench_(bench), folds_(folds), sets_(sets), cameras_(cameras) {
    bench.on("palette", this, [this] { open(); });
    const auto docks =
        bench.window.findChildren<QDockWidget*>(); // now: who comes to the front comes last later
    for (const auto& [id, forward] : {std::pair{"next-panel", true}, {"previous-panel", false}})
        bench.on(id, this, [this, docks, &centre, &importBar, on = forward] {
            focusNextPanel({centre.currentWidget(), &importBar}, docks, folds_, on);
        });
    addButton();
}

void PaletteController::addButton() {
    const QAction& palette = bench_.actions["palette"];
    auto* search = new QToolButton;
    search->setObjectName(QStringLiteral("palette-button"));
    search->setText(
        tr("Search for a command   %1").arg(palette.shortcut().toString(QKeySequence::NativeText)));
    search->setToolTip(palette.toolTip());
    search->setProperty("search", true);
    search->setFocusPolicy(Qt::NoFocus); // it has its key
    connect(search, &QToolButton::clicked, this, &PaletteController::open);
    bench_.window.menuBar()->setCornerWidget(search);
}

QString PaletteController::whyNot(const QAction& action) const {
    if (action.isEnabled()) return {};
    const QString given = bench_.actions.whyNot(action.objectName());
    return given.isEmpty() ? whyOff(action.objectName(), bench_.playback.active()) : given;
}

void PaletteController::open() {
    std::vector<PaletteEntry> entries;
    for (const Command& command : commands()) {
        QAction& action = bench_.actions[command.id];
        const QString id = action.objectName();
        if (id == QLatin1String("palette")) continue;
        entries.push_back({id, plain(action.text()), menuPath(command.menu),
                           action.shortcut().toString(QKeySequence::NativeText), tr(command.sentence),
                           whyNot(action), [&action] { action.trigger(); },
                           action.isCheckable() ? std::optional(action.isChecked()) : std::nullopt});
    }
    addPanels(entries);
    addSurfaces(entries);
    for (const QString& name : sets_.names())
        entries.push_back({{},
                           tr("Select set %1").arg(name),
                           tr("Select"),
                           {},
                           tr("The triangles that are kept under this name"),
                           bench_.playback.active() ? whyOff({}, true) : QString(),
                           [this, name] { sets_.select(name); }});
    addCameras(entries);
    for (const QString& file : recentFiles())
        entries.push_back({{},
                           tr("Open recent %1").arg(QFileInfo(file).fileName()),
                           tr("File"),
                           {},
                           file,
                           {},
                           [this, file] { emit fileChosen(file); }});
    auto* palette = new CommandPalette(std::move(entries), &bench_.window);
    palette->setSource([this](const QString& typed) {
        return bench_.playback.active() ? std::vector<PaletteEntry>() : valueEntries(bench_.document, typed);
    });
    palette->open();
}

void PaletteController::addCameras(std::vector<PaletteEntry>& entries) {
    const QString menu = menuPath("View/&Camera/&Kept cameras");
    const QString reason = bench_.playback.active() ? whyOff({}, true) : QString();
    for (const QString& name : cameras_.names()) {
        entries.push_back({{},
                           tr("Look from %1").arg(name),
                           menu,
                           {},
                           tr("The camera that is kept under this name"),
                           {},
                           [this, name] { cameras_.show(name); }});
        for (const CamerasMenu::Verb& verb : cameras_.verbs())
            entries.push_back({{},
                               tr("%1: %2").arg(verb.text, name),
                               menu,
                               {},
                               verb.sentence,
                               reason,
                               [does = verb.does, name] { does(name); }});
    }
}

void PaletteController::addPanels(std::vector<PaletteEntry>& entries) {
    for (auto* dock : bench_.window.findChildren<QDockWidget*>()) {
        const QString title = dock->windowTitle().section(QStringLiteral("  "), 0, 0); // without a count
        entries.push_back({dock->objectName(),
                           tr("Panel %1").arg(title),
                           tr("View"),
                           {},
                           tr("Show the panel and give it the keys"),
                           {},
                           [this, dock] {
                               folds_.bringForward(*dock);
                               dock->widget()->setFocus(Qt::ShortcutFocusReason);
                           }});
    }
}

void PaletteController::addSurfaces(std::vector<PaletteEntry>& entries) {
    const QString reason = bench_.playback.active() ? whyOff({}, true) : QString();
    for (const SceneObject& object : bench_.document.scene().objects)
        for (Index i = 0; i < Index(object.surfaces.size()); ++i) {
            const SurfaceRef ref{object.id, i};
            entries.push_back({{},
                               tr("Select surface %1").arg(QString::fromStdString(object.surfaces[i].name)),
                               QString::fromStdString(object.name),
                               {},
                               tr("See and set how it feels"),
                               reason,
                               [this, ref] { bench_.document.select(ref); }});
        }
}

} // namespace tactum
