// A stroke over two states of the scene, in the window: recorded, marked, edited, compared, swapped, written.
#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/engine/comparison.h"

namespace test_compare {

using namespace tactum;

namespace {

void stiffen(Document& document, double stiffness) {
    const SurfaceRef top{document.scene().objects.front().id, 2};
    for (const MaterialField& field : kMaterialFields)
        if (field.parameter == &kStiffness) document.setMaterialValue(top, field, stiffness);
}

/// Down onto the upper side of the cube, slowly.
std::vector<FingerPoint> press(std::size_t steps = 2000) {
    std::vector<FingerPoint> path;
    for (std::size_t i = 0; i < steps; ++i)
        path.push_back({1e-3 * double(i), Vec3(0.001, 0.055 - 0.008 * double(i) / double(steps), 0.002)});
    return path;
}

/// Waits for a result that an edit, a mark or a swap has led to.
bool isCompared(const Comparison& comparison) {
    return test::waitFor([&] { return comparison.result() && !comparison.working(); });
}

bool isCalled(const TouchedWindow& program, const char* button) {
    auto* found = program.window->findChild<QPushButton*>(QString::fromLatin1(button));
    if (!found || !found->isEnabled()) return false;
    found->click();
    return true;
}

} // namespace

class TestCompare : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void theSameSceneDiffersByNothing();
    void anEditIsComparedByItself();
    void whatTheDeviceCannotGiveIsNotCompared();
    void swappingIsOneStepOfTheHistory();
    void whatTheFingerDidIsAStroke();
    void theNewestEditWins();
    void anotherSceneForgetsA();
    void theFileHasAPointInEveryLocale();
    void aLargeMeshDoesNotHoldTheWindowUp();
};

void TestCompare::theSameSceneDiffersByNothing() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    comparison.setStroke(press());
    QVERIFY(!comparison.result());
    comparison.markA();
    QVERIFY(isCompared(comparison));
    QCOMPARE(comparison.result()->difference.rms, 0.0);
    QCOMPARE(comparison.result()->difference.largest, 0.0);
    QCOMPARE_GT(comparison.result()->difference.workA, 0);
    QCOMPARE(comparison.result()->difference.workA, comparison.result()->difference.workB);
}

void TestCompare::anEditIsComparedByItself() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    stiffen(program.document, 400);
    comparison.setStroke(press());
    comparison.markA();
    QVERIFY(isCompared(comparison));
    stiffen(program.document, 800);
    QVERIFY(comparison.working());
    QVERIFY(isCompared(comparison));
    // Twice the stiffness: the difference is the force of A. Deepest at the end, 3 mm and the proxy's radius.
    const double depth = 0.05 + program.document.scene().proxyRadius - press().back().position.y();
    const double damping = program.document.scene().objects[0].surfaces[2].material.damping;
    QCOMPARE(damping, kDamping.initial);
    const TouchRow& lastA = comparison.result()->a->back();
    COMPARE_NEAR(lastA.force.y(), 400 * depth, 1e-6 + damping * 0.01, "N");
    COMPARE_NEAR(comparison.result()->difference.largest, 400 * depth, 1e-6 + damping * 0.01, "");
    const auto* figures = program.window->findChild<QLabel*>(QStringLiteral("compare-figures"));
    COMPARE_CONTAINS(figures->text(), QStringLiteral("rms"));
    QVERIFY(!figures->text().contains(u',' + QStringLiteral("0")));
    // Without it nothing is compared until somebody asks.
    comparison.setAutomatic(false);
    stiffen(program.document, 400);
    QVERIFY(!comparison.working());
    comparison.compare();
    QVERIFY(isCompared(comparison));
    QCOMPARE(comparison.result()->difference.largest, 0.0);
}

/// 25 mm deep at 800 N/m asks for 20 N; the simulated hand gives eight.
void TestCompare::whatTheDeviceCannotGiveIsNotCompared() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    auto deep = press();
    for (FingerPoint& point : deep)
        point.position.y() = 0.055 - (0.055 - point.position.y()) * 4;
    comparison.setStroke(deep);
    comparison.markA();
    stiffen(program.document, 400);
    QVERIFY(isCompared(comparison));
    const double limit = program.engine.device().maxForce;
    double largest = 0;
    for (const auto& rows : {comparison.result()->a, comparison.result()->b})
        for (const TouchRow& row : *rows)
            largest = std::max(largest, row.force.norm());
    COMPARE_NEAR(largest, limit, 1e-9, "N");
    QCOMPARE_LT(comparison.result()->difference.largest, limit);
    const auto* figures = program.window->findChild<QLabel*>(QStringLiteral("compare-figures"));
    COMPARE_CONTAINS(figures->text(), QStringLiteral("Limited to the device's 8.0 N"));
}

void TestCompare::swappingIsOneStepOfTheHistory() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    const auto stiffness = [&] { return program.document.scene().objects[0].surfaces[2].material.stiffness; };
    stiffen(program.document, 400);
    QVERIFY(!isCalled(program, "compare-swap"));
    QVERIFY(isCalled(program, "compare-mark"));
    stiffen(program.document, 800);
    const int steps = program.document.history().count();
    QVERIFY(isCalled(program, "compare-swap"));
    QCOMPARE(stiffness(), 400.0);
    QCOMPARE(program.document.history().count(), steps + 1);
    QVERIFY(isCalled(program, "compare-swap")); // A was what the scene had been
    QCOMPARE(stiffness(), 800.0);
    program.document.history().undo();
    QCOMPARE(stiffness(), 400.0);
    QTRY_VERIFY_WITH_TIMEOUT(program.caughtUp(), kPatience);
    QVERIFY(comparison.hasA());
}

void TestCompare::whatTheFingerDidIsAStroke() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    QVERIFY(isCalled(program, "compare-record"));
    QVERIFY(comparison.recording());
    program.press(program.centre());
    program.frames(20);
    program.wheel(program.centre(), 4);
    program.frames(20);
    QVERIFY(isCalled(program, "compare-record"));
    QVERIFY(!comparison.recording());
    const auto& stroke = comparison.stroke();
    QCOMPARE_GT(stroke.size(), 100);
    QVERIFY(isFingerPath(stroke));
    QCOMPARE(stroke.front().t, 0.0);
    comparison.markA();
    QVERIFY(isCompared(comparison));
    QCOMPARE_NE(comparison.result()->difference.workA, 0); // it did touch
    // Once more from where it is now, inside: it feels what the finger feels.
    QVERIFY(program.atRest());
    const Vec3 rested = program.touch().force;
    QVERIFY(isCalled(program, "compare-record"));
    program.frames(20);
    QVERIFY(isCalled(program, "compare-record"));
    QVERIFY(isCompared(comparison));
    const Vec3 felt = comparison.result()->b->back().force;
    QCOMPARE_GT(felt.norm(), 0.1);
    COMPARE_NEAR(felt, rested, 0.05 * felt.norm(), "");
    COMPARE_NEAR(felt, program.touch().force, 0.05 * felt.norm(), "");
    program.release(program.centre());
    // From the middle of it on: a finger that is inside at the beginning feels what it felt.
    QVERIFY(isCalled(program, "compare-last"));
    QCOMPARE_LE(comparison.stroke().back().t, 10.0 + 1e-9);
}

void TestCompare::theNewestEditWins() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    stiffen(program.document, 400);
    comparison.setStroke(press(200'000));
    comparison.markA();
    for (int i = 1; i <= 20; ++i)
        stiffen(program.document, 400 + i);
    stiffen(program.document, 800);
    QVERIFY(isCompared(comparison));
    const double last = comparison.result()->b->back().force.y() / comparison.result()->a->back().force.y();
    COMPARE_NEAR(last, 2, 0.01, "");
    comparison.setStroke(press(200'000));
    comparison.cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!comparison.working(), kPatience);
    QVERIFY(!comparison.result());
}

void TestCompare::anotherSceneForgetsA() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    comparison.setStroke(press());
    comparison.markA();
    QVERIFY(isCompared(comparison));
    QVERIFY(program.open(writeCube(folder_, 2)));
    QVERIFY(!comparison.hasA());
    QVERIFY(!comparison.result());
    QVERIFY(!comparison.stroke().empty());
}

void TestCompare::theFileHasAPointInEveryLocale() {
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    Comparison& comparison = program.window->comparison();
    comparison.setStroke(press(50));
    comparison.markA();
    QVERIFY(isCompared(comparison));
    const QString file = folder_.filePath(QStringLiteral("both.csv"));
    answerFileDialog(file);
    QVERIFY(isCalled(program, "compare-export"));
    QLocale::setDefault(QLocale::c());
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = written.readAll().split('\n');
    QCOMPARE(lines.size(), 50 + 2); // the heading, and nothing after the last line
    QCOMPARE(lines[1].count(','), lines[0].count(','));
    QVERIFY(lines[20].contains('.'));
}

/// The window has the processor back before anything was prepared or replayed.
void TestCompare::aLargeMeshDoesNotHoldTheWindowUp() {
    TouchedWindow program;
    QByteArray text;
    constexpr int kSide = 240;
    for (int i = 0; i < kSide * kSide; ++i)
        text += "v " + QByteArray::number(4e-4 * (i % kSide)) + " 0 " +
                QByteArray::number(4e-4 * (i / kSide)) + '\n';
    for (int i = 0; i + kSide + 1 < kSide * kSide; ++i)
        if ((i + 1) % kSide != 0)
            text += "f " + QByteArray::number(i + 1) + ' ' + QByteArray::number(i + 2) + ' ' +
                    QByteArray::number(i + kSide + 1) + '\n';
    QVERIFY(program.open(writeFile(folder_, QStringLiteral("fine.obj"), text)));
    Comparison& comparison = program.window->comparison();
    comparison.setStroke(press(100'000));
    comparison.markA();
    QVERIFY(comparison.working());
    QVERIFY(!comparison.result());
    QVERIFY(isCompared(comparison));
    QCOMPARE_EQ(comparison.result()->a->size(), 100'000);
}

TACTUM_GUI_TEST(TestCompare)

} // namespace test_compare

#include "test_compare.moc"
