// One whole job, as an author does it: a bare mesh gets a feel, is felt, taken back, done again, saved, and
// outlives the program.
#include <cmath>
#include <numbers>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/other_run.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/preset_store.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/recovery_bar.h"
#include "ui/tools/paint_tool.h"
#include "ui/view/scene_view.h"

namespace test_one_job {

using namespace tactum;

namespace {

constexpr int kRows = 16, kColumns = 48;
constexpr double kRadius = 0.06; // m

/// Half a ball toward +z, and a ring around it at a right angle: one object without groups.
QString writeDome(const QTemporaryDir& folder) {
    QByteArray text = "o dome\n";
    const auto vertex = [&](double r, double z, int column) {
        const double around = 2 * std::numbers::pi * column / kColumns;
        text += QStringLiteral("v %1 %2 %3\n")
                    .arg(r * std::cos(around), 0, 'g', 9)
                    .arg(r * std::sin(around), 0, 'g', 9)
                    .arg(z, 0, 'g', 9)
                    .toLatin1();
    };
    for (int row = 0; row <= kRows; ++row) // from the rim to beside the pole
        for (int column = 0; column < kColumns; ++column) {
            const double up = 0.5 * std::numbers::pi * row / (kRows + 1);
            vertex(kRadius * std::cos(up), kRadius * std::sin(up), column);
        }
    for (int column = 0; column < kColumns; ++column)
        vertex(1.5 * kRadius, 0, column);
    vertex(0, kRadius, 0);
    const auto face = [&](int a, int b, int c) {
        text += QStringLiteral("f %1 %2 %3\n").arg(a + 1).arg(b + 1).arg(c + 1).toLatin1();
    };
    const auto strip = [&](int lower, int upper) {
        for (int column = 0; column < kColumns; ++column) {
            const int next = (column + 1) % kColumns;
            face(lower + column, lower + next, upper + next);
            face(lower + column, upper + next, upper + column);
        }
    };
    for (int row = 0; row < kRows; ++row)
        strip(row * kColumns, (row + 1) * kColumns);
    const int ring = (kRows + 1) * kColumns, pole = ring + kColumns;
    strip(ring, 0);
    for (int column = 0; column < kColumns; ++column)
        face(kRows * kColumns + column, kRows * kColumns + (column + 1) % kColumns, pole);
    return writeFile(folder, QStringLiteral("dome.obj"), text);
}

} // namespace

class TestOneJob : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }
    static std::optional<int> instead() { return asOtherRun(); }

private:
    QTemporaryDir folder_;
    std::unique_ptr<TouchedWindow> program_;

    const SceneObject& object() const { return program_->document.scene().objects.front(); }
    const Surface& dome() const { return object().surfaces.back(); }
    QByteArray bytes() const { return QByteArray::fromStdString(*glbOf(program_->document.scene())); }
    void click(const char* command) {
        program_->command(command).trigger();
        program_->frames(2);
    }
    void dropPreset(const QString& name);
    void feltStiffness(double& stiffness);

private slots:
    void init() { useSettingsIn(folder_.path()); }
    void cleanup() { program_.reset(); }
    void fromABareMeshToRecovery();
};

/// What the row of the library carries is let go over the middle of the view.
void TestOneJob::dropPreset(const QString& name) {
    auto* store = program_->window->findChild<PresetStore*>();
    auto* list = program_->window->findChild<QListWidget*>(QStringLiteral("preset-list"));
    QTRY_VERIFY_WITH_TIMEOUT(!store->loading() && !list->findItems(name, Qt::MatchExactly).isEmpty(),
                             kPatience);
    const auto row = list->indexFromItem(list->findItems(name, Qt::MatchExactly).front());
    const std::unique_ptr<QMimeData> data(list->model()->mimeData({row}));
    SceneView& view = program_->window->view();
    QDragEnterEvent enter(program_->centre(), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&view, &enter);
    QDragMoveEvent move(program_->centre(), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
    QVERIFY(enter.isAccepted());
    QVERIFY(move.isAccepted());
    QDropEvent drop(program_->centre(), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&view, &drop);
}

/// Presses into the middle of the dome with the mouse: force over the distance of finger and proxy. N/m.
void TestOneJob::feltStiffness(double& stiffness) {
    click("touch");
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    program_->press(program_->centre());
    QTRY_VERIFY_WITH_TIMEOUT(program_->touch().contacts > 0, kPatience);
    program_->frames(60);
    program_->wheel(program_->centre(), 6);
    program_->frames(60);
    const HapticOutput& touch = program_->touch();
    const double apart = (touch.proxy - program_->engine.proxy().finger).norm();
    QCOMPARE_GT(apart, 1e-4);
    stiffness = touch.force.norm() / apart;
    program_->release(program_->centre());
    program_->frames(10);
}

void TestOneJob::fromABareMeshToRecovery() {
    program_ = std::make_unique<TouchedWindow>();
    QVERIFY(program_->open(writeDome(folder_)));
    program_->window->view().showStandardView(StandardView::Front);
    program_->frames(5);
    const QByteArray first = bytes();
    const Scene bare = program_->document.scene();
    QCOMPARE(object().surfaces.size(), std::size_t(1));
    double before = 0, after = 0;
    feltStiffness(before);
    COMPARE_NEAR(before, kStiffness.initial, 0.02 * before, "");

    // The smooth region under the pointer becomes a surface of its own.
    click("take-smooth");
    QTest::mouseClick(&program_->window->view(), Qt::LeftButton, {}, program_->centre());
    constexpr std::size_t kDome = 2 * kRows * kColumns + kColumns;
    QTRY_COMPARE_WITH_TIMEOUT(program_->document.selectedFaces().faces.size(), kDome, kPatience);
    click("split");
    QTRY_COMPARE_WITH_TIMEOUT(object().surfaces.size(), std::size_t(2), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);

    dropPreset(QStringLiteral("Hard as rubber"));
    QCOMPARE(dome().material.stiffness, 400.0);
    QCOMPARE(object().surfaces.front().material.stiffness, kStiffness.initial);
    dropPreset(QStringLiteral("Wood on wood"));
    QCOMPARE(dome().material.staticFriction, 0.5);

    click("layer-noise");
    click("layer-grooves");
    QCOMPARE(dome().layers.size(), std::size_t(2));
    click("paint-mask");
    program_->press(program_->centre() - QPoint(40, 0));
    for (int i = 1; i <= 8; ++i)
        program_->moveTo(program_->centre() + QPoint(-40 + 10 * i, 0));
    program_->release(program_->centre() + QPoint(40, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!program_->window->findChild<PaintTool*>()->working(), kPatience);
    QVERIFY(dome().layers[1].mask);
    QCOMPARE_EQ(dome().layers[1].mask->source, TextureSource::Painted);
    click("normals-smooth");
    QVERIFY(dome().shading.on);
    QCOMPARE_EQ(dome().shading.normals, NormalSource::Computed);

    // All of it is in the World that is felt, and the force is another one.
    QTRY_VERIFY_WITH_TIMEOUT(program_->caughtUp(), kPatience);
    const WorldBody& body = program_->window->publisher().world()->bodies.at(0);
    QCOMPARE(body.textures.at(1)->layers.size(), std::size_t(2));
    QVERIFY(body.textures.at(1)->layers[1].mask.has_value());
    QVERIFY(body.normals.at(1));
    feltStiffness(after);
    COMPARE_NEAR(after, 400, 0.02 * 400, "");

    // Back to the byte, and on again to the byte.
    const QByteArray last = bytes();
    const int steps = program_->document.history().count();
    QCOMPARE_GE(steps, 7);
    QVERIFY(last != first);
    for (int i = 0; i < steps; ++i)
        click("undo");
    QVERIFY(program_->document.scene() == bare);
    QVERIFY(bytes() == first);
    for (int i = 0; i < steps; ++i)
        click("redo");
    QVERIFY(bytes() == last);
    QSignalSpy saved(&program_->document, &Document::saved);
    const QString file = folder_.filePath(QStringLiteral("dome.glb"));
    program_->document.save(file.toStdString());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QVERIFY(!program_->document.modified());
    program_.reset();

    // Opened again, edited, killed, recovered: with everything that was made before.
    {
        OtherRun run(folder_.path(), file, 20);
        QVERIFY(run.waitForJournals(1));
        run.kill();
    }
    const QByteArray edited = read(folder_.filePath(QStringLiteral("edited.glb")));
    program_ = std::make_unique<TouchedWindow>();
    auto* bar = program_->window->findChild<RecoveryBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), kPatience);
    QSignalSpy opened(&program_->document, &Document::opened);
    program_->window->findChild<QPushButton*>(QStringLiteral("recovery-recover-0"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience);
    QVERIFY(!edited.isEmpty());
    QVERIFY(bytes() == edited);
    QCOMPARE(dome().layers.size(), std::size_t(2));
    QVERIFY(dome().layers[1].mask->painted.values);
}

TACTUM_GUI_TEST(TestOneJob)

} // namespace test_one_job

#include "test_one_job.moc"
