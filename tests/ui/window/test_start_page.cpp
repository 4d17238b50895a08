// The start page: the samples as pictures, each of them a click away.
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QTest>
#include <QToolButton>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/panels/sample_gallery.h"

namespace test_start_page {

using namespace tactum;

class TestStartPage : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }

private:
    QTemporaryDir settings_;

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
        QTest::mouseClick(ladder, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(program.document.scene().objects.size(), std::size_t(7), kPatience);
        QVERIFY(!ladder->isVisible()); // the view is there instead
    }
};

TACTUM_GUI_TEST(TestStartPage)

} // namespace test_start_page

#include "test_start_page.moc"
