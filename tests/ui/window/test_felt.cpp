// The commands that show what is felt, in the whole program.
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/sound/sound_output.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace test_felt {

using namespace tactum;

namespace {

struct Opened {
    Opened() {
        if (!program.open(writeCube(folder))) qFatal("the cube cannot be opened");
    }
    const FeltOptions& felt() { return program.window->view().felt(); }
    void settle() {
        if (!test::waitFor([&] { return !program.window->view().makesFelt(); })) qFatal("it is never made");
    }
    QImage picture() {
        settle();
        return program.window->view().grabPicture();
    }

    QTemporaryDir folder;
    TouchedWindow program;
};

double changedShare(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(a.pixelColor(x, y).green() - b.pixelColor(x, y).green()) > 8;
    return double(count) / (double(a.width()) * a.height());
}

} // namespace

class TestFelt : public QObject {
    Q_OBJECT
public:
    static void initMain() { prepareProcess(); }

private slots:
    void initTestCase() {
        QVERIFY(settings_.isValid());
        useSettingsIn(settings_.path());
        unfoldPlots();
    }
    void cleanup() { QSettings().clear(); }

    void everyCommandIsASwitchAndIsRemembered() {
        {
            Opened opened;
            QVERIFY(opened.felt() == FeltOptions{});
            for (const char* id : {"contact-planes", "stylus", "friction-cone", "trail", "spheres",
                                   "felt-normals", "map-viscosity", "bumps-10", "relief", "spheres-finer"})
                opened.program.perform(id);
            opened.settle();
            QVERIFY(!opened.felt().planes);
            QVERIFY(opened.felt().normals);
            QVERIFY(opened.felt().cone);
        }
        Opened again;
        FeltOptions expected;
        expected.planes = expected.relief = false;
        expected.stylus = expected.cone = expected.trail = expected.spheres = expected.feltNormals = true;
        expected.map = FeltValue::Viscosity;
        expected.bumps = 10;
        again.settle();
        FeltOptions found = again.felt();
        found.sphereLevel = expected.sphereLevel; // not deeper than a cube's
        QVERIFY(found == expected);
    }

    void ofMapsAndBumpsOneIsOnOrNone() {
        Opened opened;
        opened.program.perform("map-stiffness");
        opened.program.perform("map-height");
        QCOMPARE_EQ(opened.felt().map, FeltValue::Height);
        QVERIFY(!opened.program.command("map-stiffness").isChecked());
        opened.program.perform("map-height");
        QVERIFY(!opened.felt().map);
        opened.program.perform("bumps-100");
        QCOMPARE(opened.felt().bumps, 100.0);
        opened.program.perform("bumps-100");
        QCOMPARE(opened.felt().bumps, 0.0);
    }

    void levelsGoOnlyWhileSpheresAreShown() {
        Opened opened;
        QVERIFY(!opened.program.command("spheres-finer").isEnabled());
        opened.program.perform("spheres");
        opened.settle();
        opened.program.perform("spheres-coarser");
        opened.program.perform("spheres-coarser");
        opened.program.perform("spheres-coarser");
        QCOMPARE(opened.felt().sphereLevel, 0);
    }

    void whatIsFeltComesWithTheModel() {
        Opened opened;
        const QImage bare = opened.picture();
        opened.program.perform("spheres");
        const QImage spheres = opened.picture();
        QCOMPARE_GT(changedShare(bare, spheres), 0.05);
        QVERIFY(opened.program.open(writeCube(opened.folder, 2)));
        QTRY_VERIFY(!opened.program.window->view().makesFelt());
        opened.program.perform("spheres");
        const QImage larger = opened.picture();
        opened.program.perform("spheres");
        QCOMPARE_GT(changedShare(larger, opened.picture()), 0.05);
    }

    void anEditIsSeenInTheMap() {
        Opened opened;
        opened.program.perform("map-stiffness");
        const QImage before = opened.picture();
        Document& document = opened.program.document;
        document.select({SurfaceRef{document.scene().objects[0].id, 4}}); // the front
        opened.program.type(QStringLiteral("stiffness"), QStringLiteral("100"));
        document.select({});
        QTRY_VERIFY(opened.program.caughtUp());
        QCOMPARE_GT(changedShare(before, opened.picture()), 0.02);
    }

    void thePlotGetsWhatTheServoDoes() {
        Opened opened;
        auto* plot = opened.program.window->findChild<ForcePlot*>();
        QVERIFY(plot);
        opened.program.press(opened.program.centre());
        opened.program.frames(60);
        QTRY_VERIFY_WITH_TIMEOUT(plot->history().samples().back().touching, kPatience);
        const TouchSample& last = plot->history().samples().back();
        QCOMPARE_GT(last.normal, 0.01);
        QCOMPARE_GT(last.lag, 0);
        QCOMPARE_GT(last.proxyRate, 0);
        COMPARE_NEAR(std::hypot(last.normal, last.tangential), last.magnitude, 1e-9, "");
        opened.program.release(opened.program.centre());
    }

    void withoutAnAudioOutputTheSoundSaysWhyItIsOff() {
        if (SoundOutput::whyNot().isEmpty()) QSKIP("this machine has an audio output");
        Opened opened;
        QAction& sound = opened.program.command("sound");
        QVERIFY(!sound.isChecked());
        emit opened.program.window->menuBar()->findChild<QMenu*>(QStringLiteral("View"))->aboutToShow();
        QVERIFY(!sound.isEnabled());
        QCOMPARE(sound.toolTip(), SoundOutput::whyNot());
        sound.setEnabled(true); // as before the menu was ever opened
        sound.trigger();
        QVERIFY(!sound.isChecked());
    }

private:
    QTemporaryDir settings_;
};

TACTUM_GUI_TEST(TestFelt)

} // namespace test_felt

#include "test_felt.moc"
