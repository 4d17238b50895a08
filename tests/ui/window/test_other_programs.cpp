// A scene of five models from five files with ten surfaces, built from nothing by mouse and keys, felt, saved
// and exported: three.js and Blender find its objects where they are here, and as they look here.
#include <algorithm>
#include <set>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>

#include "core/archive/bundle_files.h"
#include "core/scene/object_bounds.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/compare_readings.h"
#include "tests/ui/window/five_models.h"
#include "tests/ui/window/other_readers.h"
#include "tests/ui/window/person.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/panels/outliner.h"
#include "ui/panels/preset_library.h"
#include "ui/view/scene_view.h"

namespace test_other_programs {

using namespace tactum;

namespace {

/// Where and how each model comes to stand, as it is typed: mm and degrees. Of the last one no turn: its
/// handle is dragged.
struct Placed {
    const char *name, *x, *y, *z, *longest, *turnX, *turnY, *turnZ;
};
constexpr Placed kPlaces[] = {{"cup", "-120", "20", "-40", "60", "10", "35", "-5"},
                              {"jug", "-50", "30", "30", "70", "-20", "120", "15"},
                              {"bowl", "15", "25", "-35", "55", "5", "-75", "8"},
                              {"pot", "80", "40", "35", "65", "-12", "20", "170"},
                              {"jar", "140", "15", "-30", "80", "", "", ""}};

} // namespace

class TestOtherPrograms : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<TouchedWindow> program_;
    std::unique_ptr<test::Person> person_;
    QStringList written_; ///< the saved file, and the scene of the bundle

    const Scene& scene() const { return program_->document.scene(); }
    const SceneObject& named(const char* name) const {
        const auto found = std::ranges::find(scene().objects, name, &SceneObject::name);
        if (found == scene().objects.end()) qFatal("no object %s", name);
        return *found;
    }
    const Surface& surface(const char* object, Index i) const { return named(object).surfaces[i]; }
    Outliner& outliner() const { return *program_->window->findChild<Outliner*>(); }
    QTreeWidgetItem* row(const char* name) const {
        return outliner().findItems(QString::fromUtf8(name), Qt::MatchExactly, 0).value(0);
    }
    /// Where a place of an object is in the view: `up` of its box's height above its middle.
    QPoint seen(const char* name, double up = 0) const {
        const Bounds box = boundsOf(named(name));
        const Vec3 p = box.centre() + Vec3(0, up * (box.high - box.low).y(), 0);
        return program_->window->view().camera().project(p).value().toPoint();
    }
    bool has(std::size_t objects) const {
        return test::waitFor([&] {
            return scene().objects.size() == objects && !program_->document.opening() && program_->caughtUp();
        });
    }
    void keep(const char* name) const {
        if (const QString folder = qEnvironmentVariable("TACTUM_KEEP_PICTURES"); !folder.isEmpty()) {
            program_->frames(20);
            program_->window->grab().save(folder + u'/' + QLatin1String(name) + QStringLiteral(".png"));
        }
    }
    void choose(const char* object, Index surface) {
        person_->click(outliner(), row(object)->child(int(surface)));
    }

    void addFive();
    void placeAll();
    void splitTops();
    void turnAll();
    void giveFeels();
    void feelAll();
    void saveAndExport();

private slots:
    static void initMain() { prepareProcess(); }
    void initTestCase();
    void cleanupTestCase();

    void aSceneIsBuiltFromNothing();
    void threeFindsItAsItIsHere();
    void blenderFindsItAsItIsHere();
};

void TestOtherPrograms::initTestCase() {
    useSettingsIn(folder_.path());
    program_ = std::make_unique<TouchedWindow>(QSize(1280, 800));
    person_ = std::make_unique<test::Person>(*program_);
}

void TestOtherPrograms::cleanupTestCase() {
    person_.reset();
    program_.reset();
    QDir::setCurrent(QDir::rootPath()); // or the folder could not be taken away
}

void TestOtherPrograms::addFive() {
    QDir::setCurrent(folder_.path()); // where the dialogs begin
    test::writeFiveModels(folder_);
    person_->menu({"File", "New scene"});
    QTRY_VERIFY_WITH_TIMEOUT(program_->window->view().isVisible(), kPatience);
    QVERIFY(scene().objects.empty());
    test::Person::answerFiles("\"cup.obj\" \"jug.gltf\"");
    person_->menu({"File", "Add", "Models..."});
    QVERIFY(has(2));
    std::size_t count = 2;
    for (const char* name : {"bowl.dae", "pot.stl", "jar.ply"}) {
        test::Person::answerFiles(QString::fromUtf8(name));
        person_->key(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(has(++count));
    }
    for (const Placed& each : kPlaces)
        QVERIFY(row(each.name));
}

void TestOtherPrograms::placeAll() {
    person_->palette("panel place", "Panel Place");
    for (const Placed& each : kPlaces) {
        person_->click(outliner(), row(each.name));
        person_->number("longest-side", each.longest);
        person_->number("place-x", each.x);
        person_->number("place-y", each.y);
        person_->number("place-z", each.z);
        const Bounds box = boundsOf(named(each.name));
        const Vec3 middle(QString(each.x).toDouble(), QString(each.y).toDouble(), QString(each.z).toDouble());
        COMPARE_NEAR(box.centre(), middle * 1e-3, 1e-9, "m");
        COMPARE_NEAR((box.high - box.low).maxCoeff(), QString(each.longest).toDouble() * 1e-3, 1e-9, "m");
    }
}

/// Those of one surface get another one on top.
void TestOtherPrograms::splitTops() {
    person_->key(Qt::Key_7, Qt::ControlModifier); // from above
    person_->menu({"View", "Frame all"});
    person_->menu({"Select", "A click takes all that face the same way"});
    program_->frames(5);
    for (const char* name : {"pot", "jar"}) {
        QCOMPARE(named(name).surfaces.size(), std::size_t(1));
        person_->clickView(seen(name));
        QTRY_COMPARE_WITH_TIMEOUT(program_->document.selectedFaces().faces.size(), std::size_t(2), kPatience);
        person_->menu({"Surface", "Split off"});
        QTRY_COMPARE_WITH_TIMEOUT(named(name).surfaces.size(), std::size_t(2), kPatience);
    }
}

void TestOtherPrograms::turnAll() {
    for (const Placed& each : kPlaces) {
        if (!*each.turnX) continue;
        person_->click(outliner(), row(each.name));
        person_->number("turn-x", each.turnX);
        person_->number("turn-y", each.turnY);
        person_->number("turn-z", each.turnZ);
    }
    person_->click(outliner(), row("jar"));
    person_->menu({"Tools", "Move"});
    const Quat before = named("jar").pose.rotation;
    const SceneView& view = program_->window->view();
    const QPoint from = view.arranging().placeOf(ArrangeHandle::Turn, view.camera()).value().toPoint();
    person_->drag(from, from + QPoint(37, -61));
    QCOMPARE_GT(before.angularDistance(named("jar").pose.rotation), 0.2);
    keep("turned");
}

/// Ten of them, no two alike, in every way that there is.
void TestOtherPrograms::giveFeels() {
    person_->palette("panel surface", "Panel Surface");
    choose("cup", 0);
    person_->number("static-friction", "0.35");
    person_->number("dynamic-friction", "0.2");
    person_->number("stiffness", "500");
    choose("cup", 1);
    person_->palette("static friction 0.6", "Static friction: 0.600 on cup high");
    person_->palette("stiffness 1.2 N/mm", "Stiffness: 1200 N/m on cup high");
    choose("jug", 0);
    person_->number("viscosity", "3");
    choose("jug", 1);
    auto& library = *program_->window->findChild<PresetLibrary*>();
    auto& search = *library.findChild<QLineEdit*>(QStringLiteral("preset-search"));
    person_->palette("panel presets", "Panel Presets");
    person_->click(search);
    person_->write("brick");
    person_->key(Qt::Key_Return);
    choose("bowl", 0);
    person_->click(search);
    person_->key(Qt::Key_A, Qt::ControlModifier);
    person_->write("teflon");
    person_->key(Qt::Key_Return);
    choose("cup", 0);
    person_->key(Qt::Key_C, Qt::ControlModifier);
    choose("bowl", 1);
    person_->key(Qt::Key_V, Qt::ControlModifier);
    person_->number("damping", "1.5");
    choose("pot", 0);
    auto& slider = *program_->window->findChild<QWidget*>(QStringLiteral("stiffness-slider"));
    person_->click(slider, {slider.width() / 4, slider.height() / 2});
    choose("pot", 1);
    person_->number("stiffness", "300");
    choose("jar", 0);
    person_->number("static-friction", "0.1");
    choose("jar", 1);
    person_->number("stiffness", "950");
    keep("feels");
    QCOMPARE_EQ(surface("cup", 0).material.dynamicFriction, 0.2);
    QCOMPARE_EQ(surface("cup", 1).material.stiffness, 1200.0);
    QCOMPARE_EQ(surface("jug", 0).material.viscosity, 3.0);
    QVERIFY(test::hasBumps(named("jug"), surface("jug", 1)));
    QCOMPARE_EQ(surface("bowl", 0).material.staticFriction, 0.04);
    QCOMPARE_EQ(surface("bowl", 1).material.damping, 1.5);
    QCOMPARE_EQ(surface("bowl", 1).material.stiffness, 500.0);
    std::vector<Material> feels;
    for (const SceneObject& object : scene().objects)
        for (const Surface& each : object.surfaces) {
            QVERIFY(std::ranges::find(feels, each.material) == feels.end());
            feels.push_back(each.material);
        }
    QCOMPARE(feels.size(), std::size_t(10));
}

void TestOtherPrograms::feelAll() {
    person_->menu({"Tools", "Touch"});
    QVERIFY(program_->fullForce());
    for (const Placed& each : kPlaces) {
        program_->press(seen(each.name));
        QTRY_COMPARE_GT_WITH_TIMEOUT(program_->engine.servo().force.norm(), 0.1, kPatience);
        QCOMPARE_GT(program_->touch().contacts, 0);
        keep(each.name);
        program_->release(seen(each.name));
        QTRY_COMPARE_EQ_WITH_TIMEOUT(program_->engine.servo().force.norm(), 0.0, kPatience);
    }
}

void TestOtherPrograms::saveAndExport() {
    const QString saved = folder_.filePath("five.glb"), bundle = folder_.filePath("five.tactum");
    test::Person::answerFiles(saved);
    person_->key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!program_->document.modified(), kPatience);
    test::Person::answerFiles(bundle);
    person_->menu({"File", "Export a bundle..."});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(bundle), kPatience);
    QFile zip(bundle);
    QVERIFY(zip.open(QIODevice::ReadOnly));
    const auto files = BundleFiles::open(zip.readAll().toStdString());
    VERIFY_RESULT(files);
    const std::string_view glb = files->file(bundle_name::kScene);
    written_ = {saved, writeFile(folder_, "exported.glb", QByteArray(glb.data(), qsizetype(glb.size())))};
}

void TestOtherPrograms::aSceneIsBuiltFromNothing() {
    for (const auto step :
         {&TestOtherPrograms::addFive, &TestOtherPrograms::placeAll, &TestOtherPrograms::splitTops,
          &TestOtherPrograms::turnAll, &TestOtherPrograms::giveFeels, &TestOtherPrograms::feelAll,
          &TestOtherPrograms::saveAndExport}) {
        (this->*step)();
        if (QTest::currentTestFailed()) return;
    }
}

void TestOtherPrograms::threeFindsItAsItIsHere() {
    if (written_.isEmpty()) QSKIP("the scene was not built");
    const test::Readings readings = test::readByThree(written_);
    if (!readings.missing.isEmpty()) QSKIP(qPrintable(readings.missing));
    test::compareWith(scene(), readings);
}

void TestOtherPrograms::blenderFindsItAsItIsHere() {
    if (written_.isEmpty()) QSKIP("the scene was not built");
    const test::Readings readings = test::readByBlender(written_);
    if (!readings.missing.isEmpty()) QSKIP(qPrintable(readings.missing));
    test::compareWith(scene(), readings);
}

TACTUM_GUI_TEST(TestOtherPrograms)

} // namespace test_other_programs

#include "test_other_programs.moc"
