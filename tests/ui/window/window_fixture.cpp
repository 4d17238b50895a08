#include "tests/ui/window/window_fixture.h"

#include <clocale>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>
#include <QWindow>

#include "device/simulated_hand.h"
#include "tests/ui/own_folders.h"
#include "ui/base/style.h"
#include "ui/document/journal.h"
#include "ui/engine/guard_watch.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"
#include "ui/widgets/command_palette.h"

namespace tactum {

void prepareProcess() {
    useViewSurfaceFormat();
    QCoreApplication::setOrganizationName(QStringLiteral("TactumTest"));
    QCoreApplication::setApplicationName(QStringLiteral("TactumTest"));
}

void useSettingsIn(const QString& folder) {
    useFoldersIn(folder);
}

void unfoldPlots() {
    QSettings().setValue(QStringLiteral("window/folded"), QStringList());
}

QAction& commandOf(const MainWindow& window, const char* id) {
    for (const QMenu* menu : window.findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (action->objectName() == QLatin1String(id)) return *action;
    qFatal("no command %s", id);
    Q_UNREACHABLE();
}

namespace {

std::unique_ptr<HapticDevice> deviceOf(const std::shared_ptr<HandTarget>& hand,
                                       const TouchedWindow::Around& around) {
    std::unique_ptr<HapticDevice> simulated = std::make_unique<SimulatedHand>(hand);
    return around ? around(std::move(simulated)) : std::move(simulated);
}

} // namespace

/// Gives it back to the window when nobody has it, at the latest when the next key comes: what the display
/// server says of a dialog that went may come later than that.
class TouchedWindow::Keyboard : public QObject {
public:
    explicit Keyboard(QWidget& window) : window_(window) {
        connect(qApp, &QGuiApplication::focusWindowChanged, this, [this](const QWindow* now) {
            if (!now) take();
        });
        qApp->installEventFilter(this);
    }

    /// As far as Qt knows: at once, whatever the display server says about it later.
    void take() {
        if (window_.isVisible()) QApplication::setActiveWindow(&window_);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        const QWidget* holds = QApplication::activeWindow();
        if (event->type() == QEvent::ShortcutOverride && (!holds || !holds->isVisible())) take();
        return QObject::eventFilter(watched, event);
    }

private:
    QWidget& window_;
};

TouchedWindow::TouchedWindow(QSize size, const QStringList& samples, const Around& around)
    : hand(std::make_shared<HandTarget>()), engine(deviceOf(hand, around)) {
    std::setlocale(LC_NUMERIC, "C");
    const auto started = engine.start();
    if (!started) qFatal("%s", started.error().text.c_str());
    engine.setArmed(true);
    applyTheme(rememberedTheme());
    window = std::make_unique<MainWindow>(document, engine, hand, samples);
    if (size.isValid()) window->resize(size);
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get(), kPatience)) qFatal("the window does not appear");
    // Without a window manager nobody else gives it the keyboard.
    window->activateWindow();
    keyboard_ = std::make_unique<Keyboard>(*window);
    keyboard_->take();
    if (!window->isActiveWindow()) qFatal("the window does not get the keyboard");
}

TouchedWindow::~TouchedWindow() {
    keyboard_.reset();
    window->journal().discard(); // a test that edits leaves nothing for the next one to recover
    window.reset();
    engine.stop();
}

bool TouchedWindow::fullForce() {
    return test::waitFor([this] {
        if (QAction& armed = command("armed"); !armed.isChecked()) armed.trigger();
        return engine.servo().gain == 1;
    });
}

bool TouchedWindow::open(const QString& file) {
    window->open(file);
    const bool opened = test::waitFor([this] { return !document.opening() && caughtUp(); });
    frames(30); // the jump of the hand, and what the view prepares
    return opened;
}

bool TouchedWindow::caughtUp() {
    const auto& world = window->publisher().world();
    return world && !window->publisher().working() && engine.proxy().worldRevision == world->revision;
}

QPoint TouchedWindow::centre() const {
    return window->view().rect().center();
}

QRect TouchedWindow::placeOf(const QWidget& widget) const {
    return {widget.mapTo(window.get(), QPoint(0, 0)), widget.size()};
}

void TouchedWindow::press(QPoint at) {
    QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, window->view().mapTo(window.get(), at));
}

void TouchedWindow::moveTo(QPoint at) {
    QTest::mouseMove(window->windowHandle(), window->view().mapTo(window.get(), at));
}

void TouchedWindow::release(QPoint at) {
    QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, window->view().mapTo(window.get(), at));
}

void TouchedWindow::stroke() {
    QPoint at = centre();
    press(at);
    frames(20);
    wheel(at, 4);
    for (int i = 0; i < 20; ++i) {
        at += QPoint(3, 1);
        moveTo(at);
        frames(2);
    }
    frames(20);
    release(at);
}

void TouchedWindow::wheel(QPoint at, int notches) {
    SceneView& view = window->view();
    for (int i = 0; i < notches; ++i) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
        frames(4);
    }
}

void TouchedWindow::frames(int count) {
    // Milliseconds of the window and ticks of the servo: on a busy machine neither stands for the other.
    const std::uint64_t until = engine.servo().ticks + std::uint64_t(count) * 16;
    QTest::qWait(count * 16);
    (void)test::waitFor([&] { return !engine.running() || engine.servo().ticks >= until; });
}

bool TouchedWindow::atRest() {
    return test::waitFor([this] {
        const Vec3 before = finger();
        frames(20);
        return (finger() - before).norm() < 1e-6;
    });
}

QDoubleSpinBox& TouchedWindow::box(const QString& key) {
    auto* found = window->findChild<QDoubleSpinBox*>(key);
    if (!found) qFatal("no field %s", qPrintable(key));
    return *found;
}

void TouchedWindow::perform(const char* id) {
    const QAction& action = command(id);
    const auto receiver = [this] {
        QWidget* holds = QApplication::focusWidget();
        return holds ? holds : window.get();
    };
    if (const QKeySequence key = action.shortcut(); !key.isEmpty())
        return QTest::keySequence(receiver(), key);
    QTest::keySequence(receiver(), command("palette").shortcut());
    const auto palette = [this] { return window->findChild<CommandPalette*>(); };
    if (!test::waitFor([&] { return palette() && palette()->isVisible(); })) qFatal("no palette");
    auto* line = palette()->findChild<QLineEdit*>(QStringLiteral("palette-line"));
    QString name = action.text().remove(u'&');
    if (name.endsWith(QStringLiteral("..."))) name.chop(3);
    QTest::keyClicks(line, name);
    // Others may have the name: down to the one of this menu.
    const auto& rows = *palette()->findChild<QTreeWidget*>(QStringLiteral("palette-list"));
    const auto isIt = [&](const QTreeWidgetItem* row) {
        const auto* menu = qobject_cast<QMenu*>(action.associatedObjects().value(0));
        const QString where = row ? row->text(1).section(QStringLiteral(" ("), 0, 0) : QString(); // (on)
        return row && row->text(0) == name && menu && where.endsWith(menu->title().remove(u'&'));
    };
    for (int i = 0; i < rows.topLevelItemCount() && !isIt(rows.currentItem()); ++i)
        QTest::keyClick(line, Qt::Key_Down);
    if (!isIt(rows.currentItem())) qFatal("the palette does not have %s", id);
    QTest::keyClick(line, Qt::Key_Return);
    if (!test::waitFor([&] { return !palette(); })) qFatal("the palette stays: %s", id);
}

QAction& TouchedWindow::command(const char* id) {
    return commandOf(*window, id);
}

void TouchedWindow::type(const QString& key, const QString& value) {
    QDoubleSpinBox& field = box(key);
    QTest::mouseClick(&field, Qt::LeftButton);
    QTest::qWait(50);
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, value);
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace tactum
