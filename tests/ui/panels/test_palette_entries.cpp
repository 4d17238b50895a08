// Commands by a few letters: which fit, in which order, and what happens to the chosen one.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/shortcuts.h"
#include "ui/widgets/command_palette.h"

namespace test_palette_entries {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

PaletteEntry entry(const char* id, const char* text, const char* menu = "", const char* keys = "",
                   const char* sentence = "", const char* whyNot = "") {
    return {QLatin1String(id),
            QLatin1String(text),
            QLatin1String(menu),
            QLatin1String(keys),
            QLatin1String(sentence),
            QLatin1String(whyNot),
            {}};
}

} // namespace

class TestPaletteEntries : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumPalette"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }
    void init() { QSettings().clear(); }
    void cleanup() { QSettings().clear(); }

    /// A command that is off says why instead of what it does; away with the others it comes back as it was.
    void aCommandThatIsOffSaysWhy() {
        Actions actions;
        const auto state = [&](const char* id) {
            const QAction& action = actions[id];
            return QStringLiteral("%1, %2, %3")
                .arg(action.isEnabled() ? QStringLiteral("on") : QStringLiteral("off"),
                     actions.whyNot(QLatin1String(id)), action.toolTip());
        };
        const QString hide = state("hide"), fit = state("fit");
        COMPARE_BEGINS(hide, QStringLiteral("on, , "));
        actions.allow("hide", QStringLiteral("Nothing is there."));
        QCOMPARE(state("hide"), "off, Nothing is there., Nothing is there.");
        actions.setLive(false);
        QCOMPARE(state("hide"), "off, Nothing is there., Nothing is there.");
        QVERIFY(!actions["lock"].isEnabled());
        QCOMPARE(state("fit"), fit); // it changes nothing
        actions.allow("hide", {});
        actions.setLive(true);
        QCOMPARE(state("hide"), hide);
        QVERIFY(actions["lock"].isEnabled());
        actions.allow("hide", QStringLiteral("Nothing is there."));
        actions.setLive(false);
        actions.setLive(true);
        QCOMPARE(state("hide"), "off, Nothing is there., Nothing is there.");
    }

    void howWellAnEntryFits_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<int>("score");
        const auto row = [](const char* typed, int score) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << score;
        };
        row("", 1);
        row("  ", 1);
        row("frame", 17); // a word of the command
        row("FRAME", 17);
        row("fra", 17);
        row("all", 17);
        row("rame", 9);   // inside of one
        row("view", 5);   // of the menu
        row("camera", 3); // of the sentence
        row("home", 3);   // the key itself
        row("hom", 0);    // a part of it is none
        row("fal", 2);    // letters in their order
        row("laf", 0);
        row("frame view", 21); // each word counts
        row("frame all", 97);  // its name
        row("frame xyz", 0);   // and each has to fit
        row("iew", 0);         // inside of a word of the menu
        row("amera", 0);       // or of the sentence
    }

    void howWellAnEntryFits() {
        QFETCH(QString, typed);
        QFETCH(int, score);
        QCOMPARE(paletteScore(typed, entry("a", "Frame all", "View", "Home", "Moves the camera")), score);
    }

    void wordsBeginAfterAnythingButLetters() {
        QCOMPARE(paletteScore(QStringLiteral("box"), entry("a", "x-box")), 17);
        QCOMPARE(paletteScore(QStringLiteral("box"), entry("a", "xbox box")), 17);
        QCOMPARE(paletteScore(QStringLiteral("box"), entry("a", "2box")), 9);
    }

    void theLatestComeFirstAmongEquals() {
        const std::vector<PaletteEntry> entries{entry("a", "Show one"), entry("b", "Show two"),
                                                entry("c", "Hide three"), entry("", "Show four")};
        const auto order = [&](const char* typed, const QStringList& recent) {
            return paletteOrder(QLatin1String(typed), entries, recent);
        };
        using Order = std::vector<std::size_t>;
        QCOMPARE(order("", {}), (Order{0, 1, 2, 3}));
        QCOMPARE(order("", {QStringLiteral("c"), QStringLiteral("b")}), (Order{2, 1, 0, 3}));
        QCOMPARE(order("show", {QStringLiteral("c"), QStringLiteral("b")}), (Order{1, 0, 3}));
        QCOMPARE(order("show two", {QStringLiteral("a")}), (Order{1}));
        QCOMPARE(order("t", {QStringLiteral("a")}), (Order{1, 2})); // fitting better goes before
        QCOMPARE(order("", {QString()}), (Order{0, 1, 2, 3}));      // no id: never remembered
        QCOMPARE(order("xyz", {}), Order{});
    }

    // What can be done now is above what cannot, but for what is asked for by its whole name.
    void whatIsOffComesLast() {
        std::vector<PaletteEntry> entries{entry("a", "Show one"), entry("b", "Show two"), entry("c", "Show")};
        entries[0].whyNot = entries[2].whyNot = QStringLiteral("There is none.");
        using Order = std::vector<std::size_t>;
        QCOMPARE(paletteOrder(QStringLiteral("sho"), entries, {}), (Order{1, 0, 2}));
        QCOMPARE(paletteOrder(QStringLiteral("show"), entries, {}), (Order{2, 1, 0}));
        QCOMPARE(paletteOrder({}, entries, {QStringLiteral("a")}), (Order{1, 0, 2}));
    }

    void theChosenOneIsRunAndRemembered() {
        QWidget window;
        window.resize(1000, 700);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QStringList ran;
        std::vector<PaletteEntry> entries;
        for (int i = 0; i < 12; ++i) {
            const QString id = QStringLiteral("c%1").arg(i);
            entries.push_back({id,
                               QStringLiteral("Command %1").arg(i),
                               QStringLiteral("Menu"),
                               {},
                               QStringLiteral("Does it."),
                               i == 3 ? QStringLiteral("There is none.") : QString(),
                               [&ran, id] { ran << id; }});
        }
        const auto opened = [&] {
            auto* palette = new CommandPalette(entries, &window);
            palette->open();
            return QPointer(palette);
        };
        auto palette = opened();
        QCOMPARE(palette->size(), QSize(608, 416));
        QCOMPARE(palette->pos(), window.mapToGlobal(QPoint((1000 - 608) / 2, 40)));
        COMPARE_SHOWN(shownIn(*palette), "palette");
        auto* line = palette->findChild<QLineEdit*>(QStringLiteral("palette-line"));
        auto* sentence = palette->findChild<QLabel*>(QStringLiteral("palette-sentence"));
        auto* list = palette->findChild<QTreeWidget*>(QStringLiteral("palette-list"));
        for (int i = 0; i < 11; ++i) // what cannot be run is at the end
            QTest::keyClick(line, Qt::Key_Down);
        QCOMPARE(list->currentItem()->text(0), "Command 3");
        QCOMPARE(sentence->text(), "Not now: There is none. Does it.");
        QTest::keyClick(line, Qt::Key_Return); // not now: it stays
        QVERIFY(palette);
        QTest::keyClick(line, Qt::Key_Up);
        QCOMPARE(sentence->text(), "Does it.");
        QTest::keyClick(line, Qt::Key_Enter);
        QTRY_VERIFY(!palette); // it is gone
        QTRY_COMPARE(ran, QStringList{QStringLiteral("c11")});
        // The last eight come first the next time.
        for (int i = 0; i < 10; ++i) {
            if (i == 3) continue;
            palette = opened();
            QTest::keyClicks(palette->findChild<QLineEdit*>(), QStringLiteral("command %1").arg(i));
            QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return);
            QTRY_VERIFY(!palette);
        }
        QCOMPARE(QSettings().value(QStringLiteral("palette/recent")).toStringList().join(u' '),
                 "c9 c8 c7 c6 c5 c4 c2 c1");
        palette = opened();
        list = palette->findChild<QTreeWidget*>();
        QStringList rows;
        for (int i = 0; i < list->topLevelItemCount(); ++i)
            rows << list->topLevelItem(i)->text(0).section(u' ', 1);
        QCOMPARE(rows.join(u' '), "9 8 7 6 5 4 2 1 0 10 11 3");
        line = palette->findChild<QLineEdit*>();
        QTest::keyClicks(line, QStringLiteral("xyz"));
        QCOMPARE(palette->findChild<QLabel*>()->text(), "No command fits; leave some letters out.");
        QCOMPARE(list->topLevelItemCount(), 0);
        QTest::keyClick(line, Qt::Key_Return); // nothing to run
        QVERIFY(palette);
        ran.clear();
        QTest::keyClick(line, Qt::Key_Escape);
        QTRY_VERIFY(!palette);
        QVERIFY(ran.isEmpty());
        window.resize(300, 200); // it fits into a small window
        palette = opened();
        QCOMPARE_LE(palette->width(), std::max(284, palette->minimumSizeHint().width()));
        palette->close();
    }
};

TACTUM_GUI_TEST(TestPaletteEntries)

} // namespace test_palette_entries

#include "test_palette_entries.moc"
