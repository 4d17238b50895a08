// The window on small screens, in both languages and both themes: nothing that is needed is cut off.
#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/language.h"
#include "ui/base/preferences.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/tool_strip.h"

namespace test_narrow {

using namespace tactum;

namespace {

/// As long as it lives the window that is made is in that language and theme.
class Spoken {
public:
    Spoken(const QString& code, bool dark) {
        if (!language_.begin(code)) qFatal("there is no language %s", qPrintable(code));
        QCoreApplication::installTranslator(&language_);
        Preferences::instance().set(Preferred::Theme, double(dark ? ThemeChoice::Dark : ThemeChoice::Light));
    }
    ~Spoken() { QCoreApplication::removeTranslator(&language_); }

private:
    Language language_;
};

bool isScrolled(const QWidget& widget) {
    for (const QWidget* above = widget.parentWidget(); above; above = above->parentWidget())
        if (qobject_cast<const QAbstractScrollArea*>(above)) return true;
    return false;
}

/// All of it is seen, with its words.
bool isWhole(const QWidget& widget) {
    return widget.isVisible() && widget.visibleRegion().boundingRect() == widget.rect() &&
           widget.width() >= widget.minimumSizeHint().width();
}

/// Buttons of a part of the window of which something is missing, but those that a menu holds or a list
/// scrolls to.
QStringList cutIn(const QWidget& part) {
    QStringList cut;
    for (const auto* button : part.findChildren<QAbstractButton*>())
        if (button->isVisible() && !isScrolled(*button) && !isWhole(*button))
            cut << button->objectName() + u' ' + button->text();
    return cut;
}

QToolButton& moreOf(const QToolBar& bar) {
    return *bar.findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
}

/// What a person can press there: not under something else.
bool isReachable(const TouchedWindow& program, const QWidget& button) {
    const QWidget* seen = program.window->childAt(program.placeOf(button).center());
    return isWhole(button) && program.window->rect().contains(program.placeOf(button)) &&
           (seen == &button || button.isAncestorOf(seen));
}

/// Where somebody wants to look at it.
void photograph(TouchedWindow& program, const QString& name) {
    const QString folder = qEnvironmentVariable("TACTUM_PICTURES");
    if (!folder.isEmpty()) program.window->grab().save(folder + u'/' + name + QStringLiteral(".png"));
}

} // namespace

class TestNarrow : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots();
    }

    void theForcesAreInReach_data();
    void theForcesAreInReach();
    void whatHasNoRoomIsInAMenu();
    void rowsOfToolsGoOnBelow();
    void theRatesGiveWay();
    void thePanelsGetTheirRoomBack();
};

void TestNarrow::theForcesAreInReach_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<QString>("code");
    QTest::addColumn<bool>("dark");
    for (const QSize size : {QSize(900, 600), QSize(1024, 768), QSize(1280, 800)})
        for (const char* code : {"en", "de"})
            for (const bool dark : {true, false})
                QTest::addRow("%dx%d-%s-%s", size.width(), size.height(), code, dark ? "dark" : "light")
                    << size << QString::fromLatin1(code) << dark;
}

void TestNarrow::theForcesAreInReach() {
    QFETCH(const QSize, size);
    QFETCH(const QString, code);
    QFETCH(const bool, dark);
    const Spoken spoken(code, dark);
    TouchedWindow program(size);
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.fullForce());
    QCOMPARE(program.window->size(), size);
    const auto& forces = *program.window->findChild<QToolBar*>(QStringLiteral("forces"));
    QAction& armed = program.command("armed");
    auto& button = static_cast<QToolButton&>(*forces.widgetForAction(&armed));
    auto& stop = *program.window->findChild<QPushButton*>(QStringLiteral("stop"));
    photograph(program, QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(isReachable(program, button));
    QVERIFY(isReachable(program, stop));
    QTest::mouseClick(&stop, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!program.engine.armed(), kPatience);
    QTest::mouseClick(&button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(program.engine.armed(), kPatience);
    for (auto* dock : program.window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        program.frames(3);
        QCOMPARE(program.window->size(), size);
        photograph(program, QLatin1String(QTest::currentDataTag()) + u'-' + dock->objectName());
        QTRY_COMPARE_WITH_TIMEOUT(cutIn(*dock).join(u'\n'), QString(), kPatience);
        QVERIFY(isReachable(program, button));
        QVERIFY(isReachable(program, stop));
    }
    const auto& tools = *program.window->findChild<QToolBar*>(QStringLiteral("tools"));
    if (size.width() >= 1280) QVERIFY(!moreOf(tools).isVisible());
}

void TestNarrow::whatHasNoRoomIsInAMenu() {
    const Spoken spoken(QStringLiteral("de"), true);
    TouchedWindow program({900, 600});
    QVERIFY(program.open(writeCube(folder_)));
    const auto& tools = *program.window->findChild<QToolBar*>(QStringLiteral("tools"));
    QToolButton& more = moreOf(tools);
    QVERIFY(isReachable(program, more));
    // Its arrow is seen on the ground of the bar.
    const QImage picture = more.grab().toImage();
    int seen = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            seen +=
                std::abs(picture.pixelColor(x, y).lightness() - picture.pixelColor(0, 0).lightness()) > 60;
    QCOMPARE_GT(seen, 5);
    QTest::mouseClick(&more, Qt::LeftButton); // the bar opens over the view, with all of it
    for (QAction* action : tools.actions())
        if (!action->isSeparator())
            QTRY_VERIFY2_WITH_TIMEOUT(isWhole(*tools.widgetForAction(action)), qPrintable(action->text()),
                                      kPatience);
    photograph(program, QStringLiteral("more"));
}

void TestNarrow::rowsOfToolsGoOnBelow() {
    for (const char* code : {"en", "de"})
        for (const QSize size : {QSize(900, 600), QSize(1280, 800)}) {
            const Spoken spoken(QLatin1String(code), true);
            TouchedWindow program(size);
            QVERIFY(program.open(writeCube(folder_)));
            program.command("layer-noise").trigger();
            program.document.select(SurfaceRef{program.document.scene().objects[0].id, 0});
            for (const char* id : {"select", "arrange", "paint", "measure", "section"}) {
                program.command(id).trigger();
                program.frames(5);
                photograph(program,
                           QStringLiteral("%1-%2-%3").arg(size.width()).arg(QLatin1String(code), id));
                for (const auto* strip : program.window->findChildren<ToolStrip*>()) {
                    if (!strip->isVisible()) continue;
                    QVERIFY(program.placeOf(program.window->view()).contains(program.placeOf(*strip)));
                    const QString where =
                        QStringLiteral("%1 %2: ").arg(QLatin1String(code), strip->objectName());
                    const auto* content = strip->findChild<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
                    for (const auto* field :
                         content->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
                        QVERIFY2(!field->isVisible() || content->rect().contains(field->geometry()),
                                 qPrintable(where + field->objectName()));
                    QCOMPARE(where + cutIn(*strip).join(u'\n'), where);
                }
            }
        }
}

void TestNarrow::theRatesGiveWay() {
    TouchedWindow program({1500, 800});
    QVERIFY(program.open(writeCube(folder_)));
    const auto shows = [&](const char* name) {
        return program.window->findChild<QWidget*>(QLatin1String(name))->isVisible();
    };
    for (const char* name :
         {"status-device", "force-meter", "status-contacts", "status-servo", "status-proxy"})
        QVERIFY2(shows(name), name);
    program.window->resize(900, 600);
    QTRY_VERIFY_WITH_TIMEOUT(!shows("status-proxy"), kPatience);
    for (const char* name : {"status-device", "force-meter", "status-contacts", "stop"})
        QVERIFY2(shows(name), name);
    program.window->resize(1500, 800);
    QTRY_VERIFY_WITH_TIMEOUT(shows("status-proxy"), kPatience);
}

void TestNarrow::thePanelsGetTheirRoomBack() {
    TouchedWindow program({1280, 800});
    QVERIFY(program.open(writeCube(folder_)));
    const auto widthOf = [&](const char* name) {
        return program.window->findChild<QDockWidget*>(QLatin1String(name))->width();
    };
    const auto resize = [&](const QSize& size) {
        program.window->resize(size);
        QCoreApplication::processEvents(); // of a hand that draws at the window's corner many come
    };
    resize({1280, 800});
    const int left = widthOf("dock-outliner"), right = widthOf("dock-inspector");
    resize({640, 480});
    QTRY_COMPARE_LT_WITH_TIMEOUT(widthOf("dock-inspector"), right, kPatience);
    resize({1280, 800});
    QTRY_COMPARE_WITH_TIMEOUT(widthOf("dock-inspector"), right, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(widthOf("dock-outliner"), left, kPatience);
    // A person draws the line between view and panel, while another tab is in front.
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-layers"))->raise();
    program.frames(5);
    const auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-layers"));
    const QPoint line = dock->mapTo(program.window.get(), QPoint(-2, dock->height() / 2));
    QTest::mousePress(program.window->windowHandle(), Qt::LeftButton, {}, line);
    for (int step = 1; step <= 8; ++step)
        QTest::mouseMove(program.window->windowHandle(), line - QPoint(5 * step, 0));
    QTest::mouseRelease(program.window->windowHandle(), Qt::LeftButton, {}, line - QPoint(40, 0));
    QTRY_COMPARE_WITH_TIMEOUT(dock->width(), right + 40, kPatience);
    resize({640, 480});
    QTRY_COMPARE_LT_WITH_TIMEOUT(dock->width(), right, kPatience);
    resize({1280, 800});
    QTRY_COMPARE_WITH_TIMEOUT(dock->width(), right + 40, kPatience);
    // Also when it was left while it was small.
    resize({640, 480});
    program.window->close();
    TouchedWindow again({1280, 800});
    QVERIFY(again.open(writeCube(folder_)));
    const auto* front = again.window->findChild<QDockWidget*>(QStringLiteral("dock-layers"));
    QTRY_COMPARE_WITH_TIMEOUT(front->width(), right + 40, kPatience);
}

TACTUM_GUI_TEST(TestNarrow)

} // namespace test_narrow

#include "test_narrow.moc"
