// The start page: samples and the files opened last as pictures, each of them a click away.
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProxyStyle>
#include <QStandardPaths>
#include <QTest>
#include <QToolButton>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/recent_files.h"
#include "ui/panels/sample_gallery.h"
#include "ui/panels/start_page.h"
#include "ui/widgets/picture_card.h"

namespace test_start_page {

using namespace tactum;

namespace {

/// Of a desktop where nothing is to move.
class StillStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override {
        return hint == SH_Widget_Animation_Duration ? 0
                                                    : QProxyStyle::styleHint(hint, option, widget, returned);
    }
};

} // namespace

class TestStartPage : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }

private:
    QTemporaryDir settings_, folder_;

    /// A cube that a window has opened, as by a command line, and drawn; the only recent file.
    QString openedOnce() {
        forgetRecentFiles();
        const QString cube = writeCube(folder_);
        TouchedWindow program;
        program.open(QDir::current().relativeFilePath(cube));
        [&] { QTRY_COMPARE_WITH_TIMEOUT(picturesKept(), 1, kPatience); }();
        return cube;
    }
    static PictureCard* cardOf(const QWidget& window) {
        return window.findChild<PictureCard*>(QStringLiteral("recent-cube.obj"));
    }
    static qsizetype picturesKept() {
        return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
                    QStringLiteral("/recent"))
            .entryList({QStringLiteral("*.png")}, QDir::Files)
            .size();
    }
    /// Not one colour all over.
    static bool isDrawn(const QImage& picture) {
        return picture.pixel(0, 0) != picture.pixel(picture.width() / 2, picture.height() / 2);
    }

private slots:
    void initTestCase() { useSettingsIn(settings_.path()); }

    void onlyScenesWithAPictureAreSamples() {
        QTemporaryDir folder;
        for (const char* name : {"b.glb", "b.png", "a-b.glb", "a-b.png", "bare.glb", "c.obj", "c.png"})
            writeFile(folder, QString::fromLatin1(name), "x");
        const QDir there(QFileInfo(folder.path()).canonicalFilePath());
        QCOMPARE(samplesIn(folder.path()), (QStringList{there.filePath(QStringLiteral("a-b.glb")),
                                                        there.filePath(QStringLiteral("b.glb"))}));
        QVERIFY(samplesIn(folder.filePath(QStringLiteral("nowhere"))).isEmpty());
    }

    /// What has nothing to show yet stands beside nothing, and is there with the first scene.
    void thePanelsComeWithWhatIsOpened() {
        TouchedWindow program({1200, 800}, samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes")));
        const auto docks = [&] {
            int seen = 0;
            for (const auto* dock : program.window->findChildren<QDockWidget*>())
                seen += dock->isVisible();
            return seen;
        };
        QCOMPARE(docks(), 0);
        QCOMPARE(program.window->findChild<StartPage*>()->width(), program.window->width());
        QVERIFY(program.open(openedOnce()));
        QVERIFY(docks() > 3);
        QVERIFY(!program.command("panels").isChecked());
        TouchedWindow other; // a person may want them before
        other.command("panels").trigger();
        QVERIFY(docks() > 3);
    }

    void aClickOnAPictureOpensItsScene() {
        const QStringList samples = samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes"));
        QCOMPARE(samples.size(), 22);
        TouchedWindow program({1200, 800}, samples);
        const auto buttons = program.window->findChild<SampleGallery*>()->findChildren<QToolButton*>();
        QCOMPARE(buttons.size(), 9);
        for (const QToolButton* button : buttons) {
            QVERIFY(button->isVisible());
            QVERIFY(!button->icon().isNull());
            QVERIFY(!button->visibleRegion().isEmpty());
        }
        auto* ladder = program.window->findChild<QToolButton*>(QStringLiteral("sample-friction-ladder"));
        QVERIFY(ladder);
        QCOMPARE(ladder->text(), QStringLiteral("Friction ladder"));
        COMPARE_CONTAINS(ladder->accessibleDescription(), QStringLiteral("breaks loose")); // what it teaches
        QTest::mouseClick(ladder, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(program.document.scene().objects.size(), std::size_t(7), kPatience);
        QVERIFY(!ladder->isVisible()); // the view is there instead
    }

    /// Under the mouse or the keys, one at a time; and not for a person whose desktop says that nothing is to
    /// move.
    void aSampleMovesUnderTheMouse() {
        StillStyle restful; // which the window needs to its end
        TouchedWindow program({1200, 800}, samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes")));
        const auto card = [&](const char* name) {
            return program.window->findChild<PictureCard*>(QLatin1String(name));
        };
        PictureCard& coin = *card("sample-relief-coin");
        QTest::mouseMove(program.window.get(), {2, 2}); // from wherever it was
        QTRY_VERIFY_WITH_TIMEOUT(!coin.underMouse(), kPatience);
        const QImage still = coin.grab().toImage();
        coin.setFocus();
        QVERIFY(coin.moves());
        QTRY_VERIFY_WITH_TIMEOUT(coin.grab().toImage().copy(0, 0, 120, 100) != still.copy(0, 0, 120, 100),
                                 kPatience);
        const QImage moved = coin.grab().toImage();
        QTRY_VERIFY_WITH_TIMEOUT(coin.grab().toImage() != moved, kPatience); // and goes on
        card("sample-teapot")->setFocus();
        QVERIFY(!coin.moves());
        QVERIFY(card("sample-teapot")->moves());
        QCOMPARE_EQ(coin.grab().toImage(), still);
        QTest::mouseMove(&coin, coin.rect().center());
        QTRY_VERIFY_WITH_TIMEOUT(coin.moves(), kPatience);
        card("sample-teapot")->clearFocus();
        PictureCard& teapot = *card("sample-teapot");
        teapot.setStyle(&restful);
        teapot.setFocus();
        QVERIFY(!teapot.moves());
    }

    /// What was opened is there at the next start, with its picture, and opens again.
    void whatWasOpenedIsThereWithItsPicture() {
        const QString cube = openedOnce();
        TouchedWindow again;
        PictureCard* card = cardOf(*again.window);
        QTRY_VERIFY_WITH_TIMEOUT(!card->icon().isNull(), kPatience);
        QVERIFY(isDrawn(card->icon().pixmap(PictureCard::kPicture).toImage()));
        COMPARE_CONTAINS(card->accessibleDescription(), folder_.path());
        COMPARE_CONTAINS(card->accessibleDescription(), QStringLiteral("today at "));
        card->setFocus(); // by the keys
        QTest::keyClick(card, Qt::Key_Space);
        QTRY_COMPARE_WITH_TIMEOUT(again.document.scene().objects.size(), std::size_t(1), kPatience);
        QCOMPARE(again.window->windowFilePath(), cube);
    }

    /// Who changes a file elsewhere, or takes it away, reads that on its card.
    void aChangedOrVanishedFileSaysSo() {
        const QString cube = openedOnce();
        writeFile(folder_, QStringLiteral("cube.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        {
            TouchedWindow again;
            PictureCard* card = cardOf(*again.window);
            QTRY_VERIFY_WITH_TIMEOUT(
                card->accessibleDescription().contains(QStringLiteral("another program")), kPatience);
            QVERIFY(!card->icon().isNull());
        }
        QVERIFY(QFile::remove(cube));
        TouchedWindow again;
        PictureCard* card = cardOf(*again.window);
        QTRY_VERIFY_WITH_TIMEOUT(card->accessibleDescription().contains(QStringLiteral("no longer there")),
                                 kPatience);
    }

    /// The file stays, its picture and its card go, and the keys go on at the next card.
    void oneIsTakenFromTheList() {
        const QString cube = openedOnce();
        rememberFile(writeFile(folder_, QStringLiteral("other.obj"), "v 0 0 0\n"));
        TouchedWindow again;
        QTRY_COMPARE_WITH_TIMEOUT(picturesKept(), 1, kPatience);
        auto* away = cardOf(*again.window)->findChild<QToolButton*>(QStringLiteral("recent-remove"));
        QCOMPARE(away->accessibleName(), QStringLiteral("Remove cube.obj from the list"));
        away->setFocus();
        QTest::keyClick(away, Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!cardOf(*again.window), kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(picturesKept(), 0, kPatience);
        QCOMPARE(recentFiles().size(), 1);
        QVERIFY(QFile::exists(cube));
        QCOMPARE(again.window->focusWidget()->objectName(), QStringLiteral("recent-other.obj"));
    }

    /// Whoever types sees only what has the words, under its topic.
    void theSheetOfKeysIsSearched() {
        TouchedWindow program;
        program.command("keyboard").trigger();
        auto* sheet = program.window->findChild<QDialog*>(QStringLiteral("keyboard-sheet"));
        QVERIFY(sheet);
        const auto seen = [&] {
            QStringList texts;
            for (const QLabel* label : sheet->findChildren<QLabel*>())
                if (label->isVisible()) texts << label->text();
            return texts;
        };
        const QString undo = QStringLiteral("Take the last edit back");
        COMPARE_CONTAINS(seen(), undo);
        QVERIFY(seen().size() > 100);
        auto* field = sheet->findChild<QLineEdit*>();
        QCOMPARE(sheet->focusWidget(), field);
        QTest::keyClicks(field, QStringLiteral("BACK last"));
        QCOMPARE(seen(), (QStringList{QStringLiteral("Edit"), QStringLiteral("Ctrl+Z"), undo}));
        QTest::keyClicks(field, QStringLiteral(" xyzzy"));
        QCOMPARE(seen().size(), 1); // that there is none
        field->clear();
        COMPARE_CONTAINS(seen(), undo);
    }
};

TACTUM_GUI_TEST(TestStartPage)

} // namespace test_start_page

#include "test_start_page.moc"
