#include "tests/ui/window/window_effects.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QUndoStack>

#include "tests/ui/document/scene_figures.h"
#include "ui/base/shortcuts.h"
#include "ui/tools/paint_tool.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/tool_strip.h"

namespace tactum {

namespace {

QString yesOr(bool yes) {
    return yes ? QStringLiteral("yes") : QStringLiteral("no");
}

QString text(const Vec3& v) {
    const auto figure = [](double x) { return QString::number(std::abs(x) < 5e-4 ? 0 : x, 'f', 3); };
    return QStringLiteral("(%1 %2 %3)").arg(figure(v.x()), figure(v.y()), figure(v.z()));
}

/// What the loops and the machine decide: whether forces are on, a card for sound; and what every edit
/// changes.
bool saysNothing(const QString& command) {
    return QStringList{QStringLiteral("armed"), QStringLiteral("stop"), QStringLiteral("fold-plots"),
                       QStringLiteral("sound"), QStringLiteral("undo"), QStringLiteral("redo")}
        .contains(command);
}

QStringList selectionOf(const Document& document) {
    QStringList refs;
    for (const SurfaceRef& ref : document.selected())
        refs << QStringLiteral("%1.%2").arg(ref.object).arg(ref.surface);
    refs.sort();
    QStringList lines{QStringLiteral("selected: ") + refs.join(u' ')};
    if (const FaceSelection& faces = document.selectedFaces(); !faces.empty())
        lines << QStringLiteral("triangles: %1 of %2").arg(faces.faces.size()).arg(faces.object);
    if (const auto active = document.selection())
        lines << QStringLiteral("active: %1.%2").arg(active->object).arg(active->surface);
    return lines;
}

/// How far away it is, compared with where all of the scene fills the view. Roughly: how large the view is
/// beside its panels is up to the fonts.
double distanceOf(const SceneView& view) {
    const Bounds box = view.bounds();
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back((i & 1 ? box.low : box.high).x(), (i & 2 ? box.low : box.high).y(),
                             (i & 4 ? box.low : box.high).z());
    ViewCamera fitted = view.camera();
    fitted.fit(corners);
    return view.camera().distance / fitted.distance;
}

/// What a file says of shapes lies in its arrays.
QStringList sizesOf(const Scene& scene) {
    QStringList lines;
    for (const SceneObject& object : scene.objects) {
        const Vec3 size = boundsOf(*object.geometry).high - boundsOf(*object.geometry).low;
        lines << QStringLiteral("%1 measures %2 %3 %4 m, %5 triangles")
                     .arg(QString::fromStdString(object.name))
                     .arg(size.x(), 0, 'g', 4)
                     .arg(size.y(), 0, 'g', 4)
                     .arg(size.z(), 0, 'g', 4)
                     .arg(object.geometry->triangles.size());
    }
    return lines;
}

QStringList looksOf(const SceneView& view) {
    const ViewCamera& camera = view.camera();
    const FeltOptions& felt = view.felt();
    QStringList lines{QStringLiteral("looks along %1 at %2, %3 times as far as to see all%4")
                          .arg(text(camera.forward()), text(camera.focus))
                          .arg(distanceOf(view), 0, 'f', 1)
                          .arg(camera.parallel ? QStringLiteral(", parallel") : QString()),
                      QStringLiteral("panes: %1, active %2").arg(view.panes().size()).arg(view.activePane()),
                      QStringLiteral("map: ") +
                          (felt.map ? QString::number(int(*felt.map)) : QStringLiteral("none")),
                      QStringLiteral("bumps: %1, spheres to level %2").arg(felt.bumps).arg(felt.sphereLevel),
                      QStringLiteral("colliders: %1").arg(view.colliders().size()),
                      QStringLiteral("handles: arranging %1, mapping %2")
                          .arg(view.arranging().shown().has_value())
                          .arg(view.mapping().shown().has_value())};
    const std::pair<const char*, bool> switches[] = {
        {"normals", felt.normals},     {"planes", felt.planes},
        {"stylus", felt.stylus},       {"loupe", felt.loupe},
        {"cone", felt.cone},           {"trail", felt.trail},
        {"ground", felt.ground},       {"boundaries", felt.boundaries},
        {"wireframe", felt.wireframe}, {"spheres", felt.spheres},
        {"relief", felt.relief},       {"felt normals", felt.feltNormals}};
    for (const auto& [name, on] : switches)
        lines << QStringLiteral("shows %1: %2").arg(QLatin1String(name), yesOr(on));
    for (const Vec3& point : view.measured())
        lines << QStringLiteral("measures from ") + text(point);
    if (const auto& plane = view.section())
        lines << QStringLiteral("cut at %1 toward %2")
                     .arg(text(plane->frame.translation), text(plane->normal()));
    return lines;
}

QStringList widgetsOf(const QMainWindow& window) {
    QStringList lines;
    for (const auto* dock : window.findChildren<QDockWidget*>())
        lines << dock->objectName() + (dock->isHidden()                  ? QStringLiteral(": hidden")
                                       : dock->visibleRegion().isEmpty() ? QStringLiteral(": behind")
                                                                         : QStringLiteral(": in front"));
    for (const auto* strip : window.findChildren<ToolStrip*>())
        if (strip->isVisible()) {
            lines << strip->objectName() + QStringLiteral(": shown");
            for (const auto* field : strip->findChildren<QDoubleSpinBox*>())
                lines << QStringLiteral("%1: %2").arg(field->accessibleName(), field->text());
        }
    const auto* notice = window.findChild<NoticeBar*>();
    if (!notice->text().isEmpty()) lines << QStringLiteral("says: ") + notice->text();
    return lines;
}

QStringList keysOf() {
    const QWidget* holds = QApplication::focusWidget();
    if (!holds) return {};
    return {QStringLiteral("keys go to ") + (holds->objectName().isEmpty()
                                                 ? QString::fromLatin1(holds->metaObject()->className())
                                                 : holds->objectName())};
}

/// What is kept for the next start; without where windows and panels are.
QStringList settings() {
    QStringList lines;
    const QSettings kept;
    for (const QString& key : kept.allKeys())
        if (const QVariant value = kept.value(key); value.typeId() != QMetaType::QByteArray)
            lines << QStringLiteral("kept %1: %2")
                         .arg(key, value.typeId() == QMetaType::QStringList ? value.toStringList().join(u' ')
                                                                            : value.toString());
    return lines;
}

} // namespace

WindowEffects::WindowEffects(TouchedWindow& program, std::function<void()> prepare)
    : WindowEffects(
          *program.window, program.document,
          [&program] {
              program.frames(1);
              return program.caughtUp();
          },
          std::move(prepare)) {}

WindowEffects::WindowEffects(MainWindow& window, Document& document, std::function<bool()> caughtUp,
                             std::function<void()> prepare)
    : window_(window), document_(document), onScreen_(!window.testAttribute(Qt::WA_DontShowOnScreen)),
      caughtUp_(std::move(caughtUp)), prepare_(std::move(prepare)) {
    for (const Command& command : commands())
        actions_.push_back(&commandOf(window, command.id));
    QObject::connect(&closing_, &QTimer::timeout, &closing_, [this] {
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
            tellOf(*dialog);
            const auto answer = std::exchange(answer_, nullptr);
            if (!answer) return dialog->reject();
            closing_.stop(); // what the answer opens keeps the timer waiting, too
            QTimer::singleShot(0, dialog, [this, dialog, answer] {
                closing_.start();
                answer(*dialog);
            });
        }
    });
    closing_.setInterval(5);
    closing_.start();
}

void WindowEffects::choose(const char* id) {
    QAction& action = commandOf(window_, id);
    const QString words = QLatin1String(id);
    prepare_();
    if (!action.isEnabled()) return;
    note(words, [&] { action.trigger(); });
    if (action.isCheckable() && !(action.actionGroup() && action.actionGroup()->isExclusive()))
        note(words + QStringLiteral(", again"), [&] { action.trigger(); });
}

void WindowEffects::note(const QString& words, const std::function<void()>& act) {
    prepare_();
    auto* notice = window_.findChild<NoticeBar*>();
    notice->takeBack(notice->text());
    windows_.clear();
    QApplication::clipboard()->clear();
    QUndoStack& history = document_.history();
    const int steps = history.index();
    const QStringList before = state();
    act();
    settle();
    closeWindows();
    text_ += words + u'\n' + testing::changedLines(before, state());
    for (const QString& window : windows_)
        text_ += QStringLiteral("  opens ") + window + u'\n';
    if (history.index() > steps) text_ += QStringLiteral("  = \"%1\"\n").arg(history.undoText());
    while (history.index() > steps)
        history.undo();
}

/// Until workers are done and the camera stands.
void WindowEffects::settle() {
    QStringList last;
    const auto& painting = *window_.findChild<PaintTool*>();
    const bool stands = test::waitFor([&] {
        const bool caughtUp = caughtUp_(); // a frame goes by, where there are loops
        const QStringList now = looksOf(window_.view());
        return std::exchange(last, now) == now && !document_.editing() && !painting.working() &&
               !window_.view().makesFelt() && caughtUp;
    });
    if (!stands) qFatal("the window does not come to rest");
}

QStringList WindowEffects::state() {
    const Document& document = document_;
    QStringList lines = testing::figuresOf(document.scene());
    lines << sizesOf(document.scene()) << selectionOf(document) << looksOf(window_.view())
          << widgetsOf(window_) << (onScreen_ ? keysOf() : QStringList()) << settings();
    if (const QString copied = QApplication::clipboard()->text(); !copied.isEmpty())
        lines << QStringLiteral("copied: ") + copied.simplified();
    for (const QAction* action : actions_)
        if (!saysNothing(action->objectName()))
            lines << QStringLiteral("%1 %2%3").arg(
                action->objectName(), action->isEnabled() ? QStringLiteral("on") : QStringLiteral("off"),
                action->isChecked() ? QStringLiteral(", switched on") : QString());
    return lines;
}

void WindowEffects::closeWindows() {
    for (QWidget* window : QApplication::topLevelWidgets())
        if (window->isVisible() && window != &window_ && window->isWindow()) {
            tellOf(*window);
            window->close();
            settle();
        }
}

void WindowEffects::tellOf(QWidget& window) {
    QStringList words{QStringLiteral("%1 \"%2\"")
                          .arg(QLatin1String(window.metaObject()->className()), window.windowTitle())};
    if (const auto* files = qobject_cast<QFileDialog*>(&window))
        words << files->nameFilters();
    else if (const auto* menu = qobject_cast<QMenu*>(&window))
        for (const QAction* entry : menu->actions())
            words << (entry->isSeparator() ? QStringLiteral("--")
                                           : entry->text() + (entry->isEnabled() ? "" : " (off)"));
    else if (const auto* question = qobject_cast<QMessageBox*>(&window);
             question && !question->informativeText().isEmpty()) {
        words << question->text() << question->informativeText();
        for (const QAbstractButton* each : question->buttons())
            words << each->text() + (each == question->defaultButton() ? " (Enter)" : "");
    } else if (const auto* input = qobject_cast<QInputDialog*>(&window))
        words << input->labelText() << input->textValue();
    windows_ << words.join(QStringLiteral("; "));
}

} // namespace tactum
