// What a file leaves open: as what it is taken, what is remembered of it, what the bar and the list of
// findings show.
#include <QAbstractButton>
#include <QDialog>
#include <QGridLayout>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

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

    void aUnitIsFoundByTheSizeOfBefore() {
        QVERIFY(!unitBySize(140, 1e-3, 0.14));
        QVERIFY(!unitBySize(14, 1e-3, 0.14));   // centimetres, or a smaller part
        QVERIFY(!unitBySize(2000, 1e-3, 0.14)); // a larger part
        QCOMPARE(unitBySize(0.14, 1e-3, 0.14), std::optional(1.0));
        QCOMPARE(unitBySize(0.12, 1e-3, 0.14), std::optional(1.0));
        QCOMPARE(unitBySize(140, 1, 0.14), std::optional(1e-3));
        QCOMPARE(unitBySize(5.5, 1e-3, 0.14), std::optional(0.0254));
        QVERIFY(!unitBySize(1e7, 1e-3, 0.14)); // none fits
        QVERIFY(!unitBySize(0, 1e-3, 0.14));
        QVERIFY(!unitBySize(0.14, 1e-3, 0));
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
        taken.by = TakenAs::By::Choice;
        taken.across = 2.413;
        bar.display(QStringLiteral("plate.stl"), taken, 0.2);
        COMPARE_SHOWN(shownIn(bar), "import-chosen");
        taken.upOpen = false;
        bar.display(QStringLiteral("plate.fbx"), taken, 0.2);
        COMPARE_SHOWN(shownIn(bar), "import-unit-alone");

        QSignalSpy chosen(&bar, &ImportBar::chosen);
        const auto last = [&] { return chosen.back()[0].value<FileAxes>(); };
        part<QAbstractButton>(bar, "import-unit-in").click(); // it is that already
        QCOMPARE(chosen.size(), 0);
        part<QAbstractButton>(bar, "import-unit-cm").click();
        QCOMPARE(chosen.size(), 1);
        QVERIFY((last() == FileAxes{metresOf("cm").value(), true})); // the very number of the table
        part<QAbstractButton>(bar, "import-up-y").click();
        QCOMPARE(chosen.size(), 2);
        QVERIFY((last() == FileAxes{metresOf("cm").value(), false})); // from what was asked for last
    }

    /// Buttons keep their size; words go first.
    void inANarrowPlaceWordsGoBeforeButtons() {
        QWidget place;
        auto* grid = new QGridLayout(&place);
        grid->setContentsMargins(0, 0, 0, 0);
        auto* bar = new ImportBar;
        auto* foot = new QVBoxLayout; // as in the window
        foot->addWidget(bar, 0, Qt::AlignHCenter);
        grid->addLayout(foot, 0, 0, Qt::AlignBottom | Qt::AlignHCenter);
        TakenAs taken;
        taken.unitOpen = taken.upOpen = true;
        taken.across = 2.413;
        place.resize(700, 300);
        place.show();
        bar->display(QStringLiteral("the-plate-of-the-large-machine.stl"), taken, 0.2);
        QTRY_COMPARE(bar->height(), bar->sizeHint().height());
        const int flat = bar->height();
        COMPARE_CONTAINS(part<QLabel>(*bar, "import-text").text(), "says neither unit nor up axis");
        for (const int width : {360, 240}) {
            place.resize(width, 300);
            QTRY_COMPARE_GT(bar->height(), flat);
            QCOMPARE_LE(bar->width(), width);
            QCOMPARE_LT(bar->height(), 2 * flat); // no curtain
            for (const auto* each : bar->findChildren<QToolButton*>()) {
                QVERIFY2(each->width() >= each->sizeHint().width(), qPrintable(each->objectName()));
                const QRect at(each->mapTo(bar, QPoint()), each->size());
                QVERIFY2(bar->rect().contains(at), qPrintable(each->objectName()));
            }
            COMPARE_CONTAINS(part<QLabel>(*bar, "import-text").text(), "guessed");
        }
        place.resize(700, 300);
        QTRY_COMPARE(bar->height(), flat);
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
