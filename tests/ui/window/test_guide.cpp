// The guide against the program: its keys, the commands that it names, and that none of its links leads
// nowhere. With TACTUM_WRITE_GUIDE=1 the page of the keys is written anew.
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QTextBrowser>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/base/shortcuts.h"
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

void TestGuide::theProgramShowsIt() {
    QCOMPARE(guidePage(), QFileInfo(kGuide.filePath(QStringLiteral("README.md"))).canonicalFilePath());
    QWidget parent;
    showGuide(&parent);
    auto* pages = parent.findChild<QTextBrowser*>();
    QVERIFY(pages);
    COMPARE_CONTAINS(pages->toPlainText(), QStringLiteral("Task by task"));
    pages->setSource(QUrl(QStringLiteral("feel.md")));
    COMPARE_CONTAINS(pages->toPlainText(), QStringLiteral("Texture models of the Penn toolkit"));
    const QImage picture =
        pages->loadResource(QTextDocument::ImageResource, QUrl(QStringLiteral("../pictures/presets.png")))
            .value<QImage>();
    QVERIFY(!picture.isNull());
    QCOMPARE_LT(picture.width(), pages->window()->width());
}

TACTUM_GUI_TEST(TestGuide)

} // namespace test_guide

#include "test_guide.moc"
