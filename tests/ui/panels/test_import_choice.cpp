// What a file leaves open: as what it is taken, what is remembered of it, what the bar and the list of
// findings show.
#include <QAbstractButton>
#include <QDialog>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/finding_list.h"
#include "ui/panels/import_bar.h"

namespace test_import_choice {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// The known scene a thousand times as large: millimetres.
LoadedScene loadedScene(bool unitGuessed, bool upGuessed) {
    LoadedScene loaded;
    loaded.scene = knownScene();
    scaleScene(loaded.scene, 1000, Vec3::Zero());
    loaded.findings = {
        {Finding::Severity::Note, "", "has no unit: taken as metres; 300 m across", "scale it"},
        {Finding::Severity::Note, "Box", "has no unit of its own", "nothing"}};
    loaded.unitGuessed = unitGuessed;
    loaded.upGuessed = upGuessed;
    return loaded;
}

double heightOf(const LoadedScene& loaded) {
    const Bounds box = boundsOf(loaded.scene);
    return box.high.y() - box.low.y();
}

} // namespace

class TestImportChoice : public QObject {
    Q_OBJECT

    QTemporaryDir settings_;

public:
    static void initMain() { namePanelTest("TactumImport"); }

private slots:
    void initTestCase() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings_.path());
        applyTheme(ThemeChoice::Dark);
    }

    void whatIsOpenIsGuessedOrChosen() {
        LoadedScene guessed = loadedScene(true, true);
        const double across = boundsOf(knownScene()).diagonal();
        const auto taken = takeAs(guessed, {});
        QVERIFY(taken);
        QVERIFY((taken->axes == FileAxes{1e-3, false}));
        QVERIFY(taken->axes == taken->guess);
        COMPARE_NEAR(taken->across, across, 1e-9, "m");
        COMPARE_NEAR(heightOf(guessed), 0.01, 1e-9, "m");
        QCOMPARE(guessed.findings.size(), std::size_t(1)); // a metre is no guess any more
        QCOMPARE(guessed.findings[0].object, std::string("Box"));

        LoadedScene chosen = loadedScene(true, true);
        const auto as = takeAs(chosen, {0.01, true});
        QVERIFY((as->axes == FileAxes{0.01, true}));
        QVERIFY((as->guess == FileAxes{1e-3, false}));
        COMPARE_NEAR(heightOf(chosen), 1.0, 1e-9, "m"); // what was 0.1 along z, in centimetres
    }

    void whatTheFileSaysIsNotChosen() {
        LoadedScene known = loadedScene(false, false);
        QVERIFY(!takeAs(known, {0.01, true}));
        COMPARE_NEAR(heightOf(known), 10, 1e-9, "m");
        QCOMPARE(known.findings.size(), std::size_t(2));
        LoadedScene upKnown = loadedScene(true, false);
        const auto taken = takeAs(upKnown, {0.01, true});
        QVERIFY((taken->axes == FileAxes{0.01, false}));
        COMPARE_NEAR(heightOf(upKnown), 0.1, 1e-9, "m");
    }

    void aChoiceIsKeptByTheEnding() {
        QVERIFY(rememberedAxes("a.stl") == AxesChoice());
        rememberUnit("a.stl", 0.0254, 1);
        rememberUp("b.STL", true, false);
        QVERIFY((rememberedAxes("folder.obj/c.Stl") == AxesChoice{0.0254, true}));
        QVERIFY(rememberedAxes("a.obj") == AxesChoice());
        rememberUnit("a.stl", 0.5, 1); // no unit
        QVERIFY((rememberedAxes("a.stl") == AxesChoice{0.0254, true}));
        rememberUnit("a.stl", 1e-3, 1e-3); // what is guessed
        QVERIFY((rememberedAxes("a.stl") == AxesChoice{std::nullopt, true}));
        rememberUp("a.stl", false, false);
        QVERIFY(rememberedAxes("a.stl") == AxesChoice());
        rememberUp("a.stl", false, true);
        QVERIFY((rememberedAxes("a.stl") == AxesChoice{std::nullopt, false}));
    }

    void theBarSaysAsWhatAndHowLarge() {
        ImportBar bar;
        TakenAs taken;
        taken.unitOpen = taken.upOpen = true;
        taken.axes.unit = taken.guess.unit = 1e-3;
        taken.across = 0.095;
        bar.display(QStringLiteral("plate.stl"), taken, 0.095);
        COMPARE_SHOWN(shownIn(bar), "import-guessed");
        taken.axes = {0.0254, true};
        taken.across = 2.413;
        bar.display(QStringLiteral("plate.stl"), taken, 0.2);
        COMPARE_SHOWN(shownIn(bar), "import-chosen");
        taken.upOpen = false;
        bar.display(QStringLiteral("plate.fbx"), taken, 0.2);
        COMPARE_SHOWN(shownIn(bar), "import-unit-alone");

        QSignalSpy unit(&bar, &ImportBar::unitChosen), up(&bar, &ImportBar::upChosen);
        part<QAbstractButton>(bar, "import-unit-in").click(); // it is that already
        QCOMPARE(unit.size(), 0);
        part<QAbstractButton>(bar, "import-unit-cm").click();
        QCOMPARE(unit.size(), 1);
        QCOMPARE_EQ(unit[0][0].toDouble(), metresOf("cm").value()); // the very number of the table
        part<QAbstractButton>(bar, "import-up-y").click();
        QCOMPARE(up.size(), 1);
        QCOMPARE(up[0][0].toBool(), false);
    }

    void findingsAreListedWithTheirRemedies() {
        QWidget parent;
        QDialog* list =
            showFindings(QStringLiteral("Geometry of cup.obj"), QStringLiteral("1 of 2 surfaces feel."),
                         {{Finding::Severity::Warning, "lid", "surface <lid> has no partner", "name it"},
                          {Finding::Severity::Note, "", "2 faces were left out.", ""}},
                         &parent);
        COMPARE_SHOWN(shownIn(*list), "findings");
        list->close();
    }
};

TACTUM_GUI_TEST(TestImportChoice)

} // namespace test_import_choice

#include "test_import_choice.moc"
