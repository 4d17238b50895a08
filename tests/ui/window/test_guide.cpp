// The guide against the program: its keys, the commands that it names, and that none of its links leads
// nowhere. With TACTUM_WRITE_GUIDE=1 the page of the keys is written anew.
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QRegularExpression>
#include <QTest>
#include <QTextBrowser>
#include <QTextFrame>
#include <QTextTable>
#include <QTreeWidget>

#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/cube_file.h"
#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/window/guide_pages.h"
#include "ui/window/guide_window.h"
#include "ui/window/keyboard_sheet.h"

namespace test_guide {

using namespace tactum;

namespace {

const QDir kGuide(QStringLiteral(TACTUM_DOCS "/guide"));

QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// "View/&At the contact", "&Normals" as "View > At the contact > Normals".
QString plain(QString text) {
    text.remove(u'&');
    if (text.endsWith(QStringLiteral("..."))) text.chop(3);
    return text.replace(u'/', QStringLiteral(" > "));
}

} // namespace

class TestGuide : public QObject {
    Q_OBJECT

private slots:
    void theKeysAreThoseOfTheProgram();
    void linksLeadSomewhere_data();
    void linksLeadSomewhere();
    void commandsExist_data() { linksLeadSomewhere_data(); }
    void commandsExist();
    void everyPageIsListed();
    void theProgramShowsIt();
    void pagesStandInGroups();
    void wordsAreFoundOnAllPages();
    void whatIsFoundHasItsHeading();
    void itLooksLikeTheWindow();
    void theSheetIsSearched();
};

void TestGuide::theKeysAreThoseOfTheProgram() {
    const QString path = kGuide.filePath(QStringLiteral("keyboard.md"));
    if (qEnvironmentVariableIsSet("TACTUM_WRITE_GUIDE")) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE_GT(file.write(keyboardPage().toUtf8()), 0);
    }
    QVERIFY2(contentOf(path) == keyboardPage(), "write it anew: TACTUM_WRITE_GUIDE=1 test_guide");
}

void TestGuide::linksLeadSomewhere_data() {
    QTest::addColumn<QString>("page");
    const QStringList pages = kGuide.entryList({QStringLiteral("*.md")}, QDir::Files);
    QCOMPARE_GE(pages.size(), 10);
    for (const QString& page : pages)
        QTest::newRow(qPrintable(page)) << page;
}

void TestGuide::linksLeadSomewhere() {
    QFETCH(QString, page);
    const QRegularExpression link(QStringLiteral(R"(\]\(([^)#]*)(?:#([^)]*))?\))"));
    for (const auto& match : link.globalMatch(contentOf(kGuide.filePath(page)))) {
        const QString file = match.captured(1), place = match.captured(2);
        if (file.startsWith(QStringLiteral("http"))) continue;
        const QString path = kGuide.filePath(file.isEmpty() ? page : file);
        QVERIFY2(QFile::exists(path), qPrintable(match.captured()));
        if (place.isEmpty()) continue;
        // A heading's name: lower case, words joined by dashes, without signs.
        QStringList headings;
        for (QString line : contentOf(path).split(u'\n'))
            if (line.startsWith(u'#'))
                headings << line.remove(QRegularExpression(QStringLiteral("^#+ |[^\\w\\s-]")))
                                .toLower()
                                .replace(u' ', u'-');
        QVERIFY2(headings.contains(place), qPrintable(match.captured() + headings.join(u' ')));
    }
}

/// What stands in bold with an arrow in it is a command of a menu.
void TestGuide::commandsExist() {
    QFETCH(QString, page);
    QStringList known;
    for (const Command& command : commands())
        known << plain(QString::fromLatin1(command.menu)) + QStringLiteral(" > ") +
                     plain(QString::fromLatin1(command.text));
    const QRegularExpression bold(QStringLiteral(R"(\*\*([^*]+ > [^*]+)\*\*)"));
    for (const auto& match : bold.globalMatch(contentOf(kGuide.filePath(page)))) {
        const QString named = match.captured(1).simplified();
        QVERIFY2(known.contains(named), qPrintable(named));
    }
}

void TestGuide::everyPageIsListed() {
    const QString list = contentOf(kGuide.filePath(QStringLiteral("README.md")));
    for (const QString& page : kGuide.entryList({QStringLiteral("*.md")}, QDir::Files))
        QVERIFY2(page == QLatin1String("README.md") || list.contains(u'(' + page + u')'), qPrintable(page));
}

namespace {

/// The window of the guide, and what is in it.
struct Guide {
    Guide() {
        parent.show();
        showGuide(&parent);
        window = parent.findChild<GuideWindow*>();
        page = window->findChild<QTextBrowser*>();
        list = window->findChild<QTreeWidget*>();
        field = window->findChild<QLineEdit*>();
        window->activateWindow(); // there may be no window manager
        if (!QTest::qWaitForWindowActive(window)) qFatal("the guide is not seen");
    }
    QTreeWidgetItem* item(const char* text) const {
        return list->findItems(QString::fromLatin1(text), Qt::MatchExactly | Qt::MatchRecursive).value(0);
    }
    void click(const QTreeWidgetItem* item) const {
        list->scrollToItem(item);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
    }
    bool shows(const char* file) const { return page->source().fileName() == QLatin1String(file); }

    QWidget parent;
    QPointer<GuideWindow> window;
    QTextBrowser* page;
    QTreeWidget* list;
    QLineEdit* field;
};

} // namespace

void TestGuide::theProgramShowsIt() {
    QCOMPARE(guidePage(), QFileInfo(kGuide.filePath(QStringLiteral("README.md"))).canonicalFilePath());
    const Guide guide;
    COMPARE_CONTAINS(guide.page->toPlainText(), QStringLiteral("Task by task"));
    const QTextCursor link = guide.page->document()->find(QStringLiteral("Giving a feel"));
    QVERIFY(!link.isNull());
    const QPoint at = guide.page->cursorRect(link).center() - QPoint(10, 0);
    QTest::mouseClick(guide.page->viewport(), Qt::LeftButton, {}, at);
    COMPARE_CONTAINS(guide.page->toPlainText(), QStringLiteral("Texture models of the Penn toolkit"));
    QCOMPARE(guide.list->currentItem(), guide.item("Giving a feel")); // a link is followed in the list, too
    const QImage picture =
        guide.page
            ->loadResource(QTextDocument::ImageResource, QUrl(QStringLiteral("../pictures/presets.png")))
            .value<QImage>();
    QVERIFY(!picture.isNull());
    QCOMPARE_LT(picture.width(), guide.page->width());
}

/// The groups are the headings of the first page, and every page stands under one of them.
void TestGuide::pagesStandInGroups() {
    const Guide guide;
    const auto pages = guidePagesIn(guidePage());
    QCOMPARE(qsizetype(pages.size()) + 1, kGuide.entryList({QStringLiteral("*.md")}, QDir::Files).size());
    for (const GuidePage& page : pages) {
        QVERIFY2(QFile::exists(page.file), qPrintable(page.file));
        const QTreeWidgetItem* item = guide.item(qPrintable(page.title));
        QVERIFY2(item && item->parent(), qPrintable(page.title));
        QCOMPARE(item->parent()->text(0), page.group);
    }
    guide.click(guide.item("Safety"));
    QVERIFY(guide.shows("safety.md"));
    QTest::keyClick(guide.list, Qt::Key_Up);
    QVERIFY(guide.shows("real-time.md"));
    guide.click(guide.item("Devices")); // a heading is no page
    QVERIFY(guide.shows("real-time.md"));
}

void TestGuide::wordsAreFoundOnAllPages() {
    const Guide guide;
    guide.list->setFocus();
    QTest::keyClick(guide.window, Qt::Key_F, Qt::ControlModifier);
    QVERIFY(guide.field->hasFocus());
    QTest::keyClicks(guide.field, QStringLiteral("VISCOSITY slide"));
    const auto* page = guide.item("Giving a feel");
    QVERIFY(page && page->childCount() > 0);
    QVERIFY(!guide.item("Saving"));
    for (int i = 0; i < guide.list->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* place = guide.list->topLevelItem(i)->child(0);
        QVERIFY(place);
        QVERIFY(place->toolTip(0).contains(QStringLiteral("viscosity"), Qt::CaseInsensitive) ||
                place->toolTip(0).contains(QStringLiteral("slide"), Qt::CaseInsensitive));
    }
    // The place is seen, and its words are marked.
    guide.click(page->child(page->childCount() - 1));
    QVERIFY(guide.shows("feel.md"));
    const auto marks = guide.page->extraSelections();
    QVERIFY(std::ranges::any_of(marks, [&](const auto& mark) {
        const QRect at = guide.page->cursorRect(mark.cursor);
        return guide.page->viewport()->rect().contains(at.center()) &&
               mark.cursor.selectedText().compare(u"viscosity", Qt::CaseInsensitive) == 0;
    }));
    QTest::keyClick(guide.window, Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(guide.field, QStringLiteral("no such words"));
    QCOMPARE(guide.list->topLevelItemCount(), 0);
    // Esc ends the search, and then closes the guide.
    QTest::keyClick(guide.field, Qt::Key_Escape);
    QVERIFY(guide.window && guide.window->isVisible());
    QVERIFY(guide.field->text().isEmpty());
    QVERIFY(guide.item("Saving"));
    QVERIFY(guide.page->extraSelections().isEmpty());
    QTest::keyClick(guide.field, Qt::Key_Escape);
    QVERIFY(!guide.window || !guide.window->isVisible());
}

/// Its grounds, words and lines are the theme's, also after the person has chosen the other one.
/// Of its own page: the title is none, a row of a table is one place.
void TestGuide::whatIsFoundHasItsHeading() {
    QTemporaryDir folder;
    const QString page =
        writeFile(folder, QStringLiteral("page.md"),
                  "# Title\n\nPlain words.\n\n## First\n\nA paragraph of words.\n\n"
                  "| key | does |\n|---|---|\n| W | words |\n\n### Second\n\nMore words.\n\nNo other.\n");
    GuideIndex index({{QStringLiteral("Group"), QStringLiteral("Title"), page}});
    const auto found = [&](const QStringList& words) {
        QStringList lines;
        for (const GuidePlace& place : index.find(0, words))
            lines << QStringLiteral("%1: %2").arg(place.heading, place.text);
        return lines;
    };
    QCOMPARE(found({QStringLiteral("WORDS")}), (QStringList{": Plain words.", "First: A paragraph of words.",
                                                            "First: W words", "Second: More words."}));
    QCOMPARE(found({QStringLiteral("first"), QStringLiteral("paragraph")}),
             QStringList{"First: A paragraph of words."});
    QCOMPARE(found({QStringLiteral("first"), QStringLiteral("more")}), QStringList());
    QCOMPARE(found({QStringLiteral("second")}), QStringList{"Second: Second"});
}

void TestGuide::itLooksLikeTheWindow() {
    for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
        applyTheme(ThemeChoice::Dark);
        const Guide guide;
        guide.click(guide.item("Keyboard and mouse"));
        applyTheme(choice);
        const QTextTable* table = nullptr;
        for (QTextFrame* frame : guide.page->document()->rootFrame()->childFrames())
            if (!table) table = qobject_cast<QTextTable*>(frame);
        QVERIFY(table);
        const auto cell = table->cellAt(1, 0).format().toTableCellFormat();
        QCOMPARE(cell.bottomBorderBrush().color(), theme().border);
        QCOMPARE(table->format().border(), 0.0);
        const QImage picture = guide.page->viewport()->grab().toImage();
        QCOMPARE(picture.pixelColor(2, 2), theme().panel);
    }
    applyTheme(ThemeChoice::Dark);
}

/// Each row that is left, and its topic.
void TestGuide::theSheetIsSearched() {
    QWidget parent;
    parent.resize(900, 700);
    showKeyboardSheet(&parent);
    auto* sheet = parent.findChild<QDialog*>(QStringLiteral("keyboard-sheet"));
    QVERIFY(sheet);
    QCOMPARE_LE(sheet->height(), parent.height());
    auto* nothing = sheet->findChild<QLabel*>(QStringLiteral("nothing-found"));
    const auto rows = [&](const char* words) {
        sheet->findChild<QLineEdit*>()->setText(QLatin1String(words));
        QStringList texts;
        for (const auto* each : nothing->parentWidget()->findChildren<QLabel*>())
            if (!each->isHidden()) texts << each->text();
        return texts;
    };
    const qsizetype all = rows("").size();
    QCOMPARE_GT(all, 2 * 60);
    COMPARE_SHOWN(rows("panel").join(u'\n'), "sheet-panel");
    COMPARE_SHOWN(rows("view home").join(u'\n'), "sheet-view-home");
    QCOMPARE(rows("no such words"), QStringList{nothing->text()});
    QCOMPARE(rows("").size(), all);
    delete sheet;
}

TACTUM_GUI_TEST(TestGuide)

} // namespace test_guide

#include "test_guide.moc"
