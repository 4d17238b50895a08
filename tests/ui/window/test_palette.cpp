// Everything by keyboard: the command palette, the way between panels, and a name for whatever takes the
// keys.
#include <QAbstractButton>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/shortcuts.h"
#include "ui/document/recent_files.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/command_palette.h"

namespace test_palette {

using namespace tactum;

namespace {

PaletteEntry entry(const QString& text, const QString& menu = {}, const QString& sentence = {}) {
    return {text, text, menu, {}, sentence, {}, {}};
}

CommandPalette* paletteOf(const TouchedWindow& program) {
    return program.window->findChild<CommandPalette*>();
}

CommandPalette* openPalette(TouchedWindow& program) {
    QTest::keyClick(program.window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    return paletteOf(program);
}

QTreeWidget& listOf(const TouchedWindow& program) {
    return *paletteOf(program)->findChild<QTreeWidget*>(QStringLiteral("palette-list"));
}

QLineEdit& lineOf(const TouchedWindow& program) {
    return *paletteOf(program)->findChild<QLineEdit*>(QStringLiteral("palette-line"));
}

QStringList listed(const TouchedWindow& program) {
    QStringList texts;
    for (int i = 0; i < listOf(program).topLevelItemCount(); ++i)
        texts << listOf(program).topLevelItem(i)->text(0);
    return texts;
}

/// The menus beside the commands.
QStringList menusListed(const TouchedWindow& program) {
    QStringList texts;
    for (int i = 0; i < listOf(program).topLevelItemCount(); ++i)
        texts << listOf(program).topLevelItem(i)->text(1);
    return texts;
}

QString sentenceOf(const TouchedWindow& program) {
    return paletteOf(program)->findChild<QLabel*>(QStringLiteral("palette-sentence"))->text();
}

/// Of what the keys go to, as somebody hears it who does not see it.
QString nameOf(QWidget& widget) {
    QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(&widget);
    return heard ? heard->text(QAccessible::Name).trimmed() : QString();
}

QStringList namelessIn(const QWidget& window) {
    QStringList nameless;
    for (auto* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus || widget->focusProxy()) continue;
        // The line inside of a box has the name of the box.
        auto* box = qobject_cast<QLineEdit*>(widget) ? widget->parentWidget() : nullptr;
        if (!nameOf(*widget).isEmpty() || (box && !nameOf(*box).isEmpty())) continue;
        nameless << QStringLiteral("%1 \"%2\" in %3")
                        .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                             QLatin1String(widget->parentWidget()->metaObject()->className()));
    }
    return nameless;
}

} // namespace

class TestPalette : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void wordsFitInAnyOrder();
    void everyCommandIsInIt();
    void theThemeIsInItAndMenusAreWords();
    void whatIsSwitchedSaysHowItStands();
    void enterRunsWhatWasTyped();
    void whatIsOffSaysWhy();
    void recentOnesComeFirst();
    void surfacesAndFilesAreInIt();
    void valuesAreSetByWords();
    void whatCannotBeSetSaysWhy();
    void escapeLeavesEverythingAsItWas();
    void f6GoesThroughAllPanels();
    void everyMenuCanBeReachedByKey();
    void whateverTakesTheKeysHasAName();
};

void TestPalette::wordsFitInAnyOrder() {
    const std::vector<PaletteEntry> entries{entry("Frame all", "View", "Show the whole scene"),
                                            entry("Front", "View"), entry("Save as", "File"),
                                            entry("Save", "File")};
    const auto order = [&](const char* typed, const QStringList& recent = {}) {
        QStringList texts;
        for (const std::size_t i : paletteOrder(QString::fromLatin1(typed), entries, recent))
            texts << entries[i].text;
        return texts.join(u'|');
    };
    QCOMPARE(order("all frame"), QStringLiteral("Frame all"));
    QCOMPARE(order("FRAME"), QStringLiteral("Frame all"));
    QCOMPARE(order("fal"), QStringLiteral("Frame all"));
    QCOMPARE(order("whole"), QStringLiteral("Frame all"));
    QCOMPARE(order("fr"), QStringLiteral("Frame all|Front"));
    QCOMPARE(order("file s"), QStringLiteral("Save as|Save"));
    QCOMPARE(order("sv", {QStringLiteral("Save")}), QStringLiteral("Save|Save as"));
    QCOMPARE(order("xyz"), QString());
    QCOMPARE(order(""), QStringLiteral("Frame all|Front|Save as|Save"));
    QCOMPARE(order("", {QStringLiteral("Save")}), QStringLiteral("Save|Frame all|Front|Save as"));
}

void TestPalette::theThemeIsInItAndMenusAreWords() {
    TouchedWindow program;
    QVERIFY(openPalette(program));
    for (const QString& menu : menusListed(program))
        QVERIFY2(!menu.contains(u'&') && !menu.contains(u'/'), qPrintable(menu));
    QTest::keyClicks(&lineOf(program), QStringLiteral("light"));
    COMPARE_CONTAINS(listed(program), QStringLiteral("Light"));
}

void TestPalette::whatIsSwitchedSaysHowItStands() {
    TouchedWindow program;
    const auto whereOf = [&] { // of its row in the palette
        if (!openPalette(program)) return QString();
        const auto found = listOf(program).findItems(QStringLiteral("Through the model"), Qt::MatchExactly);
        const QString where = found.size() == 1 ? found[0]->text(1) : QString();
        QTest::keyClick(&lineOf(program), Qt::Key_Escape);
        return test::waitFor([&] { return !paletteOf(program); }) ? where : QString();
    };
    QCOMPARE(whereOf(), QStringLiteral("Select (on)"));
    program.command("through").trigger();
    QCOMPARE(whereOf(), QStringLiteral("Select (off)"));
    QVERIFY(openPalette(program)); // and what is done once has nothing to say
    QCOMPARE(listOf(program).findItems(QStringLiteral("Lasso"), Qt::MatchExactly).value(0)->text(1),
             QStringLiteral("Select"));
}

void TestPalette::everyCommandIsInIt() {
    TouchedWindow program;
    QVERIFY(openPalette(program));
    const QStringList texts = listed(program);
    QList<QAction*> actions;
    for (auto* menu : program.window->menuBar()->findChildren<QMenu*>())
        actions << menu->actions();
    int found = 0;
    for (const Command& command : commands()) {
        if (QLatin1String(command.id) == QLatin1String("palette")) continue;
        for (const QAction* action : actions)
            if (action->objectName() == QLatin1String(command.id)) {
                QString text = action->text().remove(u'&');
                if (text.endsWith(QStringLiteral("..."))) text.chop(3);
                QVERIFY2(texts.contains(text), command.id);
                ++found;
            }
    }
    QCOMPARE(found, int(commands().size()) - 1);
}

void TestPalette::enterRunsWhatWasTyped() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(openPalette(program));
    QTest::keyClicks(&lineOf(program), QStringLiteral("surface hide"));
    QTest::keyClick(&lineOf(program), Qt::Key_Return);
    QTRY_VERIFY(!program.document.scene().objects.front().surfaces[0].visible);
    QTRY_VERIFY(!paletteOf(program));
    // Down and up move in the list while the line keeps the keys.
    QVERIFY(openPalette(program));
    QTest::keyClicks(&lineOf(program), QStringLiteral("show all"));
    QTest::keyClick(&lineOf(program), Qt::Key_Down);
    QCOMPARE_EQ(listOf(program).currentIndex().row(), 1);
    QTest::keyClick(&lineOf(program), Qt::Key_Up);
    QTest::keyClick(&lineOf(program), Qt::Key_Return);
    QTRY_VERIFY(program.document.scene().objects.front().surfaces[0].visible);
}

void TestPalette::whatIsOffSaysWhy() {
    TouchedWindow program;
    QVERIFY(openPalette(program));
    QTest::keyClicks(&lineOf(program), QStringLiteral("undo"));
    COMPARE_CONTAINS(sentenceOf(program), QStringLiteral("There is no edit to take back."));
    const QVariant heard = listOf(program).currentItem()->data(0, Qt::AccessibleTextRole);
    COMPARE_CONTAINS(heard.toString(), QStringLiteral("There is no edit to take back."));
    QTest::keyClick(&lineOf(program), Qt::Key_Return);
    QVERIFY(paletteOf(program));
    QVERIFY(paletteOf(program)->isVisible());
}

void TestPalette::recentOnesComeFirst() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(openPalette(program));
    QCOMPARE_NE(listed(program).first(), QStringLiteral("Frame all"));
    QTest::keyClicks(&lineOf(program), QStringLiteral("frame all"));
    QTest::keyClick(&lineOf(program), Qt::Key_Return);
    QTRY_VERIFY(!paletteOf(program));
    QVERIFY(openPalette(program));
    QCOMPARE(listed(program).first(), QStringLiteral("Frame all"));
}

void TestPalette::surfacesAndFilesAreInIt() {
    TouchedWindow program;
    const QString cube = writeCube(folder_);
    QVERIFY(program.open(cube));
    QVERIFY(openPalette(program));
    QTest::keyClicks(&lineOf(program), QStringLiteral("top surface"));
    QCOMPARE(listed(program).first(), QStringLiteral("Select surface top"));
    QTest::keyClick(&lineOf(program), Qt::Key_Return);
    QTRY_COMPARE(program.document.selection()->surface, Index(2));
    QTRY_VERIFY(!paletteOf(program));
    QVERIFY(openPalette(program));
    QTest::keyClicks(&lineOf(program), QStringLiteral("recent cube"));
    QCOMPARE(listed(program).first(), QStringLiteral("Open recent cube.obj"));
}

void TestPalette::valuesAreSetByWords() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const ObjectId cube = program.document.scene().objects[0].id;
    program.document.select({SurfaceRef{cube, 0}, SurfaceRef{cube, 1}, SurfaceRef{cube, 2}});
    program.document.setLocked(SurfaceRef{cube, 1}, true);
    const auto steps = program.document.history().count();
    const auto set = [&](const char* typed, const char* offered) {
        openPalette(program);
        QTest::keyClicks(&lineOf(program), QString::fromUtf8(typed));
        const QString first = listed(program).value(0);
        QTest::keyClick(&lineOf(program), Qt::Key_Return);
        return test::waitFor([&] { return !paletteOf(program); }) && first == QString::fromUtf8(offered);
    };
    const auto material = [&](Index i) -> const Material& {
        return program.document.surface({cube, i})->material;
    };
    QVERIFY(set("static friction 0.3", "Static friction: 0.300 on 2 surfaces"));
    QTRY_COMPARE(material(2).staticFriction, 0.3);
    QCOMPARE(material(0).staticFriction, 0.3);
    QCOMPARE(material(1).staticFriction, 0.0); // locked
    QCOMPARE(program.document.history().count(), steps + 1);
    QVERIFY(set("dyn ,2", "Dynamic friction: 0.200 on 2 surfaces"));
    QTRY_COMPARE(material(0).dynamicFriction, 0.2);
    QVERIFY(set("Stiff 1.2 N/mm", "Stiffness: 1200 N/m on 2 surfaces"));
    QTRY_COMPARE(material(0).stiffness, 1200.0);
    program.document.history().undo();
    QCOMPARE(material(0).stiffness, 800.0);
    QVERIFY(set("proxy 0.5 mm", "Proxy radius: 0.50 mm"));
    QTRY_COMPARE(program.document.scene().proxyRadius, 0.0005);
}

void TestPalette::whatCannotBeSetSaysWhy() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const SurfaceRef top{program.document.scene().objects[0].id, 2};
    const auto answer = [&](const char* typed) {
        openPalette(program);
        lineOf(program).clear();
        QTest::keyClicks(&lineOf(program), QString::fromUtf8(typed));
        QTest::keyClick(&lineOf(program), Qt::Key_Return); // nothing is done
        const QString sentence = sentenceOf(program);
        QTest::keyClick(&lineOf(program), Qt::Key_Escape);
        (void)test::waitFor([&] { return !paletteOf(program); });
        return sentence;
    };
    program.document.select(std::nullopt);
    COMPARE_CONTAINS(answer("stiffness 500"), QStringLiteral("No surface is selected."));
    program.document.select(top);
    COMPARE_CONTAINS(answer("static friction 5"),
                     QStringLiteral("Static friction goes from 0.000 to 2.000."));
    COMPARE_CONTAINS(answer("stiffness 3 mm"), QStringLiteral("Stiffness is measured in N/m."));
    program.document.setLocked(top, true);
    COMPARE_CONTAINS(answer("stiffness 500"), QStringLiteral("What is selected is locked."));
    QCOMPARE(program.document.surface(top)->material.stiffness, 800.0);
    // What is no value is a command as before.
    QVERIFY(openPalette(program));
    for (const char* typed : {"frame 3", "frame all", "3", "stiffness", ""}) {
        lineOf(program).setText(QString::fromLatin1(typed));
        COMPARE_LACKS(listed(program).join(u'|'), QStringLiteral(": "));
    }
}

void TestPalette::escapeLeavesEverythingAsItWas() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(openPalette(program));
    QTest::keyClick(&lineOf(program), Qt::Key_Escape);
    QTRY_VERIFY(!paletteOf(program));
    QCOMPARE(program.document.history().count(), 0);
    QVERIFY(program.engine.armed());
}

void TestPalette::f6GoesThroughAllPanels() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* seen = program.window->findChild<QAbstractButton*>(QStringLiteral("import-close"));
    QTest::mouseClick(seen, Qt::LeftButton); // the bar over the view has its own test
    program.window->view().setFocus();
    const auto docks = program.window->findChildren<QDockWidget*>();
    const auto dockWithKeys = [&]() -> QDockWidget* {
        for (auto* dock : docks)
            if (dock->isAncestorOf(QApplication::focusWidget())) return dock;
        return nullptr;
    };
    QSet<QDockWidget*> visited;
    QList<QDockWidget*> forward;
    for (int i = 0; i < docks.size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
        QTRY_VERIFY(dockWithKeys() && !visited.contains(dockWithKeys())); // a tab comes to the front first
        QTRY_VERIFY(!dockWithKeys()->visibleRegion().isEmpty());          // not behind a tab
        visited << dockWithKeys();
        forward.prepend(dockWithKeys());
    }
    QCOMPARE(visited.size(), docks.size());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
    QVERIFY(program.window->view().hasFocus());
    for (auto* dock : forward) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QTRY_COMPARE(dockWithKeys(), dock);
    }
}

void TestPalette::everyMenuCanBeReachedByKey() {
    TouchedWindow program;
    QStringList used;
    for (const QAction* menu : program.window->menuBar()->actions()) {
        const qsizetype at = menu->text().indexOf(u'&');
        QVERIFY2(at >= 0, qPrintable(menu->text()));
        const QString key = menu->text().mid(at + 1, 1).toLower();
        QVERIFY2(!used.contains(key), qPrintable(menu->text()));
        used << key;
    }
}

void TestPalette::whateverTakesTheKeysHasAName() {
    TouchedWindow program;
    const auto allNamed = [&] {
        const QStringList nameless = namelessIn(*program.window);
        if (!nameless.isEmpty()) qWarning("%s", qPrintable(nameless.join(u'\n')));
        return nameless.isEmpty();
    };
    QVERIFY(allNamed()); // the page to begin with
    program.window->showFault(QStringLiteral("Something happened."));
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("stiffness"), QStringLiteral("321"));
    for (auto* dock : program.window->findChildren<QDockWidget*>()) {
        dock->raise();
        program.frames(5);
        QVERIFY(allNamed());
    }
    QVERIFY(openPalette(program));
    QCOMPARE(namelessIn(*paletteOf(program)).join(u'\n'), QString());
}

TACTUM_GUI_TEST(TestPalette)

} // namespace test_palette

#include "test_palette.moc"
