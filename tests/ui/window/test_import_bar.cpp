// What a file means that says neither its unit nor its up axis: shown, changed by a click, remembered.
#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"

namespace test_import_bar {

using namespace tactum;

namespace {

/// A plate so many units wide in x and three times as long in z, as a mesh file that has nothing else.
QString writePlate(const QTemporaryDir& folder, double wide, const QString& ending = QStringLiteral("off")) {
    const QByteArray x = QByteArray::number(wide), z = QByteArray::number(3 * wide);
    const QByteArray corners = "0 0 0\n" + x + " 0 0\n" + x + " 0 " + z + "\n0 0 " + z + "\n";
    if (ending == QLatin1String("off"))
        return writeFile(folder, QStringLiteral("plate.off"), "OFF\n4 1 0\n" + corners + "4 0 3 2 1\n");
    return writeFile(folder, QStringLiteral("plate.ply"),
                     "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n" +
                         corners + "4 0 3 2 1\n");
}

double across(const TouchedWindow& program) {
    return boundsOf(program.document.scene()).diagonal();
}

QWidget& bar(const TouchedWindow& program) {
    return *program.window->findChild<QWidget*>(QStringLiteral("import"));
}

QString said(const TouchedWindow& program, const char* label) {
    return program.window->findChild<QLabel*>(QLatin1String(label))->text();
}

QAbstractButton& button(const TouchedWindow& program, const char* name) {
    auto* found = program.window->findChild<QAbstractButton*>(QLatin1String(name));
    if (!found) qFatal("no button %s", name);
    return *found;
}

/// By the mouse, and waits until the file is open again.
bool choose(TouchedWindow& program, const char* name) {
    QSignalSpy opened(&program.document, &Document::opened);
    QTest::mouseClick(&button(program, name), Qt::LeftButton);
    return test::waitFor([&] { return opened.size() == 1 && program.caughtUp(); });
}

void setRadius(TouchedWindow& program, double metres) {
    program.document.setProxyRadius(metres);
}

} // namespace

class TestImportBar : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        useSettingsIn(folder_->path());
    }

    void aFileWithoutUnitSaysAsWhatItWasTaken() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30))); // 95 units across
        QVERIFY(bar(program).isVisible());
        QCOMPARE(said(program, "import-text"), "plate.off says neither unit nor up axis: guessed");
        QVERIFY(button(program, "import-unit-mm").isChecked());
        QVERIFY(button(program, "import-up-y").isChecked());
        QCOMPARE(said(program, "import-size"), "95 mm across");
        COMPARE_NEAR(across(program), 0.03 * std::sqrt(10), 1e-9, "m");
        QCOMPARE(program.document.history().count(), 0); // nothing was scaled
        for (const Finding& finding : program.document.findings())
            COMPARE_LACKS(finding.sentence, "taken as metres");
    }

    /// It lies over the view, which a person may be pressing on.
    void itMovesNothing() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        const SceneView& view = program.window->view();
        const QSize with = view.size();
        const QRect place(bar(program).mapTo(program.window.get(), QPoint()), bar(program).size());
        const QRect seen(view.mapTo(program.window.get(), QPoint()), view.size());
        QVERIFY(seen.contains(place));
        QCOMPARE_LT(place.height(), seen.height() / 4);
        QWidget* there = program.window->childAt(place.topLeft() + QPoint(4, 4));
        QVERIFY2(there == &bar(program) || bar(program).isAncestorOf(there), "the view hides it");
        QTest::mouseClick(&button(program, "import-close"), Qt::LeftButton);
        QVERIFY(!bar(program).isVisible());
        program.frames(3);
        QCOMPARE(view.size(), with);
        QVERIFY(program.open(writePlate(*folder_, 31)));
        QVERIFY(bar(program).isVisible()); // another opening is another question
    }

    void aClickOpensTheFileAgainOtherwise() {
        TouchedWindow program;
        const QString file = writePlate(*folder_, 30);
        QVERIFY(program.open(file));
        QVERIFY(choose(program, "import-unit-cm"));
        QVERIFY(bar(program).isVisible());
        QCOMPARE(said(program, "import-size"), "949 mm across, scaled to 200 mm");
        COMPARE_NEAR(across(program), 0.2, 1e-9, "m");
        QCOMPARE(said(program, "import-text"), "plate.off says neither unit nor up axis: as you chose");
        QVERIFY(!program.window->isWindowModified());
        QVERIFY(choose(program, "import-unit-mm"));
        COMPARE_NEAR(across(program), 0.03 * std::sqrt(10), 1e-9, "m");
        QVERIFY(choose(program, "import-up-z"));
        const Bounds box = boundsOf(program.document.scene());
        COMPARE_NEAR(box.high.y() - box.low.y(), 0.09, 1e-9, "m"); // stands on its short side
        QVERIFY(button(program, "import-unit-mm").isChecked());
        QVERIFY(button(program, "import-up-z").isChecked());
    }

    void aChoiceIsRememberedForItsFormat() {
        {
            TouchedWindow program;
            QVERIFY(program.open(writePlate(*folder_, 30)));
            QVERIFY(choose(program, "import-unit-in"));
            QVERIFY(choose(program, "import-up-z"));
        }
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 2)));
        QVERIFY(button(program, "import-unit-in").isChecked());
        QVERIFY(button(program, "import-up-z").isChecked());
        COMPARE_NEAR(across(program), 2 * 0.0254 * std::sqrt(10), 1e-9, "m");
        QVERIFY(program.open(writePlate(*folder_, 30, QStringLiteral("ply"))));
        QVERIFY(button(program, "import-unit-mm").isChecked()); // another format
        QVERIFY(button(program, "import-up-y").isChecked());
        QVERIFY(program.open(writePlate(*folder_, 2)));
        QVERIFY(choose(program, "import-unit-m")); // what would be guessed is no longer remembered
        QVERIFY(program.open(writePlate(*folder_, 30)));
        QVERIFY(button(program, "import-unit-mm").isChecked());
        QVERIFY(button(program, "import-up-z").isChecked());
    }

    void nonsenseInTheSettingsIsNoChoice() {
        QSettings().setValue(QStringLiteral("import/off/unit"), QStringLiteral("parsec"));
        QSettings().setValue(QStringLiteral("import/off/up"), 7);
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        QVERIFY(button(program, "import-unit-mm").isChecked());
        QVERIFY(button(program, "import-up-y").isChecked());
    }

    /// For it begins a new history.
    void itIsThereWhileThereIsNothingToLose() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 1))); // 3.2 units: neither fits, so that it is scaled
        QCOMPARE(program.document.history().count(), 1);
        QVERIFY(bar(program).isVisible());
        setRadius(program, 0.002);
        QVERIFY(!bar(program).isVisible());
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!bar(program).isVisible()); // what can be done again would be lost
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE_EQ(program.document.scene().proxyRadius, 0.002);
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
        QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier); // its own size
        QVERIFY(!bar(program).isVisible());
        setRadius(program, 0.003); // as many steps as after the opening, but not those
        QCOMPARE(program.document.history().index(), 1);
        QVERIFY(!bar(program).isVisible());
    }

    /// The second is asked for while the file is read for the first.
    void twoChoicesAtOnceBothHold() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 3)));
        QSignalSpy opened(&program.document, &Document::opened);
        QTest::mouseClick(&button(program, "import-up-z"), Qt::LeftButton);
        QCOMPARE(said(program, "import-size"), "is being read");
        QTest::mouseClick(&button(program, "import-unit-cm"), Qt::LeftButton);
        QVERIFY(button(program, "import-up-z").isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(!opened.isEmpty() && !program.document.opening() && program.caughtUp(),
                                 kPatience);
        const Bounds box = boundsOf(program.document.scene());
        COMPARE_NEAR(Vec3(box.high - box.low), Vec3(0.03, 0.09, 0), 1e-9, "m");
        QVERIFY(button(program, "import-up-z").isChecked());
        QVERIFY(button(program, "import-unit-cm").isChecked());
        QCOMPARE(said(program, "import-size"), "95 mm across");
    }

    void inASmallWindowItsButtonsCanBeRead() {
        for (const QSize size : {QSize(800, 600), QSize(1280, 800)}) {
            TouchedWindow program(size);
            QVERIFY(program.open(writePlate(*folder_, 30)));
            QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
            const SceneView& view = program.window->view();
            const QRect seen(view.mapTo(program.window.get(), QPoint()), view.size());
            for (const char* name : {"import-unit-m", "import-unit-cm", "import-unit-mm", "import-unit-in",
                                     "import-up-y", "import-up-z", "import-close"}) {
                const QAbstractButton& each = button(program, name);
                QVERIFY2(each.isVisible(), name);
                QCOMPARE_GE(each.width(), each.sizeHint().width());
                QVERIFY2(seen.contains(QRect(each.mapTo(program.window.get(), QPoint()), each.size())), name);
            }
        }
    }

    void theKeysReachIt() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        program.window->view().setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
        QCOMPARE(QApplication::focusWidget(), &button(program, "import-unit-mm"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QCOMPARE(QApplication::focusWidget(), &program.window->view());
        // By name, as any command.
        QVERIFY(program.command("taken-mm").isChecked());
        QSignalSpy opened(&program.document, &Document::opened);
        QTest::keyClick(program.window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("Taken as centi"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
        QVERIFY(button(program, "import-unit-cm").isChecked());
        program.command("up-z").trigger();
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 2, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
        QVERIFY(button(program, "import-unit-cm").isChecked());
        QVERIFY(button(program, "import-up-z").isChecked());
        program.command("up-z").trigger(); // it is that
        QVERIFY(!program.document.opening());
        QVERIFY(program.command("up-z").isChecked());
        setRadius(program, 0.002);
        QVERIFY(!program.command("up-z").isEnabled());
        QVERIFY(!program.command("taken-cm").isEnabled());
    }

    void whatItSaidOfTheSizeGoes_data() {
        QTest::addColumn<bool>("anew");
        QTest::newRow("with another unit") << false;
        QTest::newRow("with another scene") << true;
    }
    void whatItSaidOfTheSizeGoes() {
        QFETCH(bool, anew);
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 1))); // 3.2 m
        COMPARE_CONTAINS(said(program, "notice-text"), "has been scaled");
        if (anew)
            program.document.begin({});
        else
            QVERIFY(choose(program, "import-unit-cm")); // 32 mm
        program.frames(3);
        auto* notice = program.window->findChild<QWidget*>(QStringLiteral("notice"));
        QVERIFY2(!notice->isVisible(), qPrintable(said(program, "notice-text")));
    }

    void aDragThatIsNoStepYetHidesIt() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        const Gesture drag = program.document.beginTrial();
        program.document.setProxyRadius(0.002, drag);
        QTRY_VERIFY_WITH_TIMEOUT(!bar(program).isVisible(), kPatience);
        program.document.giveUpTrial(drag);
        QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
    }

    void anEditMeanwhileIsKept() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        QSignalSpy failed(&program.document, &Document::openFailed);
        QTest::mouseClick(&button(program, "import-unit-m"), Qt::LeftButton);
        setRadius(program, 0.002);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        COMPARE_CONTAINS(failed[0][0].toString(), "edited meanwhile");
        QCOMPARE_EQ(program.document.scene().proxyRadius, 0.002);
        COMPARE_NEAR(across(program), 0.03 * std::sqrt(10), 1e-9, "m");
    }

    void aFileThatIsBrokenByNowLeavesEverything() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        const Scene before = program.document.scene();
        writeFile(*folder_, QStringLiteral("plate.off"), "OFF\nnothing");
        QSignalSpy failed(&program.document, &Document::openFailed);
        QTest::mouseClick(&button(program, "import-unit-m"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(program.document.scene() == before);
        QVERIFY(bar(program).isVisible());
        QVERIFY(button(program, "import-unit-mm").isChecked());
        QVERIFY(!button(program, "import-unit-m").isChecked());
    }

    void itCanBeCancelled() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        const Scene before = program.document.scene();
        QByteArray large = "OFF\n3 400000 0\n0 0 0\n1 0 0\n0 1 0\n"; // takes longer than a click
        for (int i = 0; i < 400000; ++i)
            large += "3 0 1 2\n";
        writeFile(*folder_, QStringLiteral("plate.off"), large);
        QSignalSpy failed(&program.document, &Document::openFailed);
        QTest::mouseClick(&button(program, "import-unit-m"), Qt::LeftButton);
        QVERIFY(button(program, "notice-cancel").isVisible());
        QTest::mouseClick(&button(program, "notice-cancel"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(program.document.scene() == before);
        QVERIFY(button(program, "import-unit-mm").isChecked());
    }

    void whatSaysItsUnitHasNoBar() {
        TouchedWindow program;
        QVERIFY(program.open(writePlate(*folder_, 30)));
        const QString file = folder_->filePath(QStringLiteral("own.glb"));
        QSignalSpy saved(&program.document, &Document::saved);
        program.document.save(file.toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
        QVERIFY(!bar(program).isVisible()); // opening its file again is another thing now
        QVERIFY(program.open(file));
        QVERIFY(!bar(program).isVisible());
    }
};

TACTUM_GUI_TEST(TestImportBar)

} // namespace test_import_bar

#include "test_import_bar.moc"
