// The window elsewhere: other languages, small screens, twice the dots.
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include <clocale>

#include "core/files/load_scene.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/widgets/notice_bar.h"

namespace test_places {

using namespace tactum;

class TestPlaces : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static const Material& materialOf(const TouchedWindow& program) {
        return program.document.scene().objects.front().surfaces[0].material;
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }
    void cleanup() {
        QLocale::setDefault(QLocale::c());
        std::setlocale(LC_ALL, "C");
    }

    void numbersAreTypedAndPastedAnywhere_data();
    void numbersAreTypedAndPastedAnywhere();
    void filesKeepThePoint_data() { numbersAreTypedAndPastedAnywhere_data(); }
    void filesKeepThePoint();
    void theFirstWindowFitsTheScreen();
    void everythingFitsASmallScreen();
};

void TestPlaces::numbersAreTypedAndPastedAnywhere_data() {
    QTest::addColumn<QLocale>("locale");
    QTest::newRow("de_DE") << QLocale(QLocale::German, QLocale::Germany);
    QTest::newRow("ja_JP") << QLocale(QLocale::Japanese, QLocale::Japan);
    QTest::newRow("ar_EG") << QLocale(QLocale::Arabic, QLocale::Egypt);
}

void TestPlaces::numbersAreTypedAndPastedAnywhere() {
    QFETCH(QLocale, locale);
    QLocale::setDefault(locale);
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const auto paste = [&](const char* key, const QString& text) {
        QDoubleSpinBox& box = program.box(QString::fromLatin1(key));
        QTest::mouseClick(&box, Qt::LeftButton);
        QTest::qWait(50);
        QApplication::clipboard()->setText(text);
        auto* line = box.findChild<QLineEdit*>();
        line->selectAll();
        line->paste();
        QTest::keyClick(&box, Qt::Key_Return);
    };
    program.type(QStringLiteral("static-friction"), QStringLiteral("1.5"));
    QCOMPARE(materialOf(program).staticFriction, 1.5);
    program.type(QStringLiteral("static-friction"), QStringLiteral("0,75"));
    QCOMPARE(materialOf(program).staticFriction, 0.75);
    paste("static-friction", QStringLiteral("1,5"));
    QCOMPARE(materialOf(program).staticFriction, 1.5);
    paste("static-friction", QStringLiteral("0.25"));
    QCOMPARE(materialOf(program).staticFriction, 0.25);
    paste("proxy-radius", QStringLiteral(" 2,5 mm "));
    COMPARE_NEAR(program.document.scene().proxyRadius, 0.0025, 1e-12, "m");
    for (const auto* box : program.window->findChildren<QDoubleSpinBox*>())
        for (const QChar c : box->text())
            QVERIFY2(!c.isDigit() || (c >= u'0' && c <= u'9'), qPrintable(box->text()));
    QCOMPARE(program.box(QStringLiteral("static-friction")).text(), QStringLiteral("0.250"));
}

void TestPlaces::filesKeepThePoint() {
    QFETCH(QLocale, locale);
    TouchedWindow program;
    QLocale::setDefault(locale);
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0,375"));
    const QString file = folder_.filePath(QStringLiteral("kept.glb"));
    QSignalSpy saved(&program.document, &Document::saved);
    program.document.save(file.toStdString());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QFile bytes(file);
    QVERIFY(bytes.open(QIODevice::ReadOnly));
    COMPARE_CONTAINS(bytes.readAll(), "0.375");
    const auto loaded = loadScene(file.toStdString());
    VERIFY_RESULT(loaded);
    QCOMPARE(loaded->scene.objects.front().surfaces[0].material.staticFriction, 0.375);
}

void TestPlaces::theFirstWindowFitsTheScreen() {
    QCOMPARE(MainWindow::firstSize({1920, 1080}), QSize(1920, 1040));
    for (const QSize room : {QSize(1280, 800), QSize(1024, 768), QSize(1366, 728), QSize(1440, 900)}) {
        const QSize size = MainWindow::firstSize(room);
        QCOMPARE_LE(size.width(), room.width());
        QCOMPARE_LE(size.height() + 30, room.height());
    }
    TouchedWindow program{QSize()}; // as it comes
    const QSize room = program.window->screen()->availableSize();
    QCOMPARE_LE(program.window->width(), room.width());
    QCOMPARE_LE(program.window->height(), room.height());
}

/// Qt makes a window larger than it was told to be when what is in it has no room.
void TestPlaces::everythingFitsASmallScreen() {
    const QSize small(1280, 760); // of 1280 x 800, without a title bar and a panel
    TouchedWindow program(small);
    program.frames(10);
    QCOMPARE(program.window->size(), small);
    QVERIFY(program.open(writeCube(folder_)));
    const auto fits = [&](const QString& what) {
        program.frames(5);
        const QSize least = program.window->minimumSizeHint();
        if (program.window->size() == small && least.width() <= small.width() &&
            least.height() <= small.height())
            return true;
        qWarning("%s: %d x %d, at least %d x %d", qPrintable(what), program.window->width(),
                 program.window->height(), least.width(), least.height());
        return false;
    };
    QVERIFY(fits(QStringLiteral("opened")));
    for (auto* dock : program.window->findChildren<QDockWidget*>()) {
        dock->raise();
        QVERIFY(fits(dock->objectName()));
    }
    program.window->showFault(QString(400, u'x').replace(20, 1, QStringLiteral(" ")) + QString(60, u'y'));
    QVERIFY(fits(QStringLiteral("a long message")));
    // The model stays the largest thing.
    QCOMPARE_GE(program.window->centralWidget()->width(), small.width() / 2);
}

TACTUM_GUI_TEST(TestPlaces)

} // namespace test_places

#include "test_places.moc"
