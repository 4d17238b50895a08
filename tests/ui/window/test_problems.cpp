// The list of problems: where they are, and repairing them.
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/panels/problems.h"
#include "ui/panels/sample_gallery.h"
#include "ui/view/scene_view.h"

namespace test_problems {

using namespace tactum;

namespace {

/// A cube of 0.1 m without half of its top, and with a triangle of the front turned over.
QString writeTroubled(const QTemporaryDir& folder) {
    QByteArray text;
    for (int i = 0; i < 8; ++i)
        text += QStringLiteral("v %1 %2 %3\n")
                    .arg(i & 1 ? 0.05 : -0.05)
                    .arg(i & 2 ? 0.05 : -0.05)
                    .arg(i & 4 ? 0.05 : -0.05)
                    .toLatin1();
    text += "f 2 4 8\nf 2 8 6\nf 1 5 7\nf 1 7 3\nf 3 7 8\nf 1 2 6\nf 1 6 5\n"
            "f 5 6 8\nf 5 7 8\nf 1 3 4\nf 1 4 2\n";
    return writeFile(folder, QStringLiteral("box.obj"), text);
}

} // namespace

class TestProblems : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static QTreeWidget& list(const TouchedWindow& program) {
        return *program.window->findChild<QTreeWidget*>(QStringLiteral("problems"));
    }
    static QTreeWidgetItem* row(const TouchedWindow& program, const QString& part) {
        for (int i = 0; i < list(program).topLevelItemCount(); ++i)
            if (list(program).topLevelItem(i)->text(0).contains(part)) return list(program).topLevelItem(i);
        return nullptr;
    }
    static void click(const TouchedWindow& program, const QString& part) {
        QTreeWidget& tree = list(program);
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-problems"))->raise();
        QTRY_VERIFY(!tree.visibleRegion().isEmpty());
        const QRect place = tree.visualItemRect(row(program, part));
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, {place.left() + 30, place.center().y()});
    }
    static void fix(const TouchedWindow& program, const QString& part) {
        auto* button = qobject_cast<QPushButton*>(list(program).itemWidget(row(program, part), 1));
        QVERIFY(button);
        QVERIFY(!button->accessibleName().isEmpty());
        QTest::mouseClick(button, Qt::LeftButton);
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void rowsShowTheirPlace();
    void fixRepairsAndUndoBringsBack();
    void aWrongUnitIsOneStep();
    void noSampleHasProblems();
};

const auto kHole = QStringLiteral("open rim"), kFlipped = QStringLiteral("face opposite ways");

void TestProblems::rowsShowTheirPlace() {
    TouchedWindow program;
    QVERIFY(program.open(writeTroubled(folder_)));
    QTRY_VERIFY_WITH_TIMEOUT(row(program, kHole) && row(program, kFlipped), kPatience);
    SceneView& view = program.window->view();
    QVERIFY(!view.hasMarked());
    program.document.select(std::nullopt);
    click(program, kHole);
    QVERIFY(view.hasMarked());
    QVERIFY(program.document.selection().has_value());
    // The view comes to where most of the triangles show their front: around the hole in the top there are
    // one of the top, one of the right and one of the back.
    const auto looksFrom = [&](const Vec3& way) {
        return -view.camera().forward().dot(way.normalized()) > 0.9999;
    };
    QVERIFY(!looksFrom({1, 1, -1}));
    QTRY_VERIFY_WITH_TIMEOUT(looksFrom({1, 1, -1}), kPatience);
    // Those that disagree about the front: two of the front cancel out, one of the left and one of the top do
    // not.
    click(program, kFlipped);
    QTRY_VERIFY_WITH_TIMEOUT(looksFrom({-1, 1, 0}), kPatience);
    if (qEnvironmentVariableIsSet("TACTUM_PICTURE")) {
        program.frames(60);
        program.window->grab().save(qEnvironmentVariable("TACTUM_PICTURE"));
    }
    // Choosing something else ends it.
    program.document.select(std::nullopt);
    QVERIFY(!view.hasMarked());
}

void TestProblems::fixRepairsAndUndoBringsBack() {
    TouchedWindow program;
    QVERIFY(program.open(writeTroubled(folder_)));
    const Scene before = program.document.scene();
    const int steps = program.document.history().index();
    QTRY_VERIFY_WITH_TIMEOUT(row(program, kHole) && row(program, kFlipped), kPatience);
    click(program, kFlipped);
    // Looked at when it is said: a notice does not stay, and on a busy machine a fault may have one of its
    // own.
    const auto* notice = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    QString said;
    connect(&dynamic_cast<Problems&>(list(program)), &Problems::repaired, program.window.get(),
            [&] { said = notice->text(); });
    fix(program, kFlipped);
    QTRY_VERIFY_WITH_TIMEOUT(!said.isEmpty(), kPatience);
    COMPARE_CONTAINS(said, QStringLiteral("1 triangle turned over"));
    QTRY_VERIFY_WITH_TIMEOUT(!row(program, kFlipped), kPatience);
    QVERIFY(row(program, kHole));
    QVERIFY(!program.window->view().hasMarked());
    fix(program, kHole);
    QTRY_VERIFY_WITH_TIMEOUT(!row(program, kHole), kPatience);
    const TriangleSoup& repaired = *program.document.scene().objects[0].geometry;
    QCOMPARE(repaired.triangles.size(), std::size_t(12));
    QCOMPARE(program.document.history().index(), steps + 2);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
    program.document.history().undo();
    program.document.history().undo();
    QVERIFY(program.document.scene() == before);
    QVERIFY(*program.document.scene().objects[0].geometry == *before.objects[0].geometry);
    QTRY_VERIFY_WITH_TIMEOUT(row(program, kHole) && row(program, kFlipped), kPatience);
    COMPARE_BEGINS(row(program, kHole)->text(0), QStringLiteral("box"));
    program.document.history().redo();
    program.document.history().redo();
    QTRY_VERIFY_WITH_TIMEOUT(!row(program, kHole) && !row(program, kFlipped), kPatience);
}

/// Opened in millimetres it was scaled; with that undone, the list says so and scales it again.
void TestProblems::aWrongUnitIsOneStep() {
    TouchedWindow program;
    program.document.open(writeCube(folder_, 1000).toStdString(), false, {1.0, false}); // not as is guessed
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.empty() && program.caughtUp(), kPatience);
    program.document.history().undo();
    const auto unit = QStringLiteral("looks like another unit");
    QTRY_VERIFY_WITH_TIMEOUT(row(program, unit), kPatience);
    const double large = boundsOf(program.document.scene()).diagonal();
    fix(program, unit);
    COMPARE_NEAR(boundsOf(program.document.scene()).diagonal() / large, 0.001, 1e-12, "");
    QTRY_VERIFY_WITH_TIMEOUT(!row(program, unit), kPatience);
    program.document.history().undo();
    QCOMPARE(boundsOf(program.document.scene()).diagonal(), large);
}

/// Who begins with a sample sees a list that is empty, and nothing over the view.
void TestProblems::noSampleHasProblems() {
    TouchedWindow program;
    const auto* notice = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    const auto* rows = dynamic_cast<const Problems*>(&list(program));
    QSignalSpy counted(rows, &Problems::counted);
    QStringList trouble;
    const QStringList samples = samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes"));
    QCOMPARE_GT(samples.size(), 20);
    for (const QString& sample : samples) {
        counted.clear();
        QVERIFY(program.open(sample));
        QTRY_VERIFY_WITH_TIMEOUT(!counted.empty(), kPatience);
        const QString name = QFileInfo(sample).fileName() + QStringLiteral(": ");
        for (int i = 0; i < rows->topLevelItemCount(); ++i)
            trouble << name + rows->topLevelItem(i)->text(0);
        if (notice->isVisible()) trouble << name + notice->text();
        if (program.document.modified()) trouble << name + QStringLiteral("edited");
    }
    QVERIFY2(trouble.empty(), qPrintable(trouble.join(u'\n')));
}

TACTUM_GUI_TEST(TestProblems)

} // namespace test_problems

#include "test_problems.moc"
