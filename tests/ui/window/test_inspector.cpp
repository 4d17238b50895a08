// What the inspector takes and shows: units, several surfaces at once, locks; and feels given to others.
#include <cmath>

#include <QAbstractButton>
#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/numbers.h"

namespace test_inspector {

using namespace tactum;

class TestInspector : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static const Surface& surface(const TouchedWindow& program, Index i) {
        return program.document.scene().objects[0].surfaces[i];
    }
    static SurfaceRef ref(const TouchedWindow& program, Index i) {
        return {program.document.scene().objects[0].id, i};
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aTypedUnitCounts();
    void whatIsNoNumberChangesNothing();
    void severalSurfacesShowMixed();
    void lockedSurfacesCannotBeSet();
    void aColourIsChosen();
    void aDialogEndsTheTouch();
    void aFeelIsCopiedAndPasted();
    void othersBecomeTheSameAsTheActiveOne();
    void normalsAreTurnedOver();
};

void TestInspector::aTypedUnitCounts() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("stiffness"), QStringLiteral("0.45 N/mm"));
    QCOMPARE(surface(program, 0).material.stiffness, 450.0);
    QCOMPARE(program.box(QStringLiteral("stiffness")).text(), QStringLiteral("450"));
    program.type(QStringLiteral("proxy-radius"), QStringLiteral("0.2 cm"));
    QCOMPARE(program.document.scene().proxyRadius, 0.002);
}

void TestInspector::whatIsNoNumberChangesNothing() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    program.type(QStringLiteral("stiffness"), QStringLiteral("12 mm"));
    QVERIFY(program.document.scene() == before);
    auto* hint = program.window->findChild<QLabel*>(QStringLiteral("stiffness-hint"));
    QVERIFY(hint->isVisible());
    COMPARE_CONTAINS(hint->text(), QStringLiteral("12 mm"));
    COMPARE_CONTAINS(hint->text(), QStringLiteral("N/m"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("120"));
    QVERIFY(!hint->isVisible());
}

void TestInspector::severalSurfacesShowMixed() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("stiffness"), QStringLiteral("300"));
    program.document.setShading(ref(program, 0), {true, NormalSource::Computed, 0.5});
    program.document.select({ref(program, 0), ref(program, 1), ref(program, 2)});
    QDoubleSpinBox& box = program.box(QStringLiteral("stiffness"));
    QCOMPARE(box.text(), QStringLiteral("mixed"));
    QCOMPARE_NE(program.box(QStringLiteral("viscosity")).text(), QStringLiteral("mixed"));
    auto* shading = program.window->findChild<QCheckBox*>(QStringLiteral("force-shading"));
    QCOMPARE(shading->checkState(), Qt::PartiallyChecked);
    // The value of the active one, typed, is that of all: in one step.
    const int steps = program.document.history().count();
    const double active = surface(program, 2).material.stiffness;
    program.type(QStringLiteral("stiffness"), QString::number(active));
    for (Index i = 0; i < 3; ++i)
        QCOMPARE(surface(program, i).material.stiffness, active);
    QCOMPARE(program.document.history().count(), steps + 1);
    QCOMPARE_NE(box.text(), QStringLiteral("mixed"));
    // What else they have of their own stays.
    shading->click();
    QVERIFY(surface(program, 1).shading.on);
    QVERIFY(surface(program, 2).shading.on);
    QCOMPARE(surface(program, 0).shading.creaseAngle, 0.5);
    QCOMPARE(surface(program, 1).shading.creaseAngle, kCreaseAngle.initial);
}

void TestInspector::lockedSurfacesCannotBeSet() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.box(QStringLiteral("stiffness")).isEnabled());
    program.document.setLocked(ref(program, 0), true);
    QVERIFY(!program.box(QStringLiteral("stiffness")).isEnabled());
    QVERIFY(program.window->findChild<QLabel*>(QStringLiteral("locked-hint"))->isVisible());
    program.document.select({ref(program, 0), ref(program, 1)});
    QVERIFY(program.box(QStringLiteral("stiffness")).isEnabled());
    program.type(QStringLiteral("stiffness"), QStringLiteral("333"));
    QCOMPARE_NE(surface(program, 0).material.stiffness, 333);
    QCOMPARE_EQ(surface(program, 1).material.stiffness, 333);
}

/// By the swatch, in the dialog's own field, seen before it is accepted; two of three, for one is locked.
void TestInspector::aColourIsChosen() {
    TouchedWindow program;
    QVERIFY(program.open(QFINDTESTDATA("../../../resources/scenes/teapot.obj")));
    Document& document = program.document;
    document.setLocked({ref(program, 2)}, true);
    document.select({ref(program, 0), ref(program, 2), ref(program, 1)});
    const Scene before = document.scene();
    const int steps = document.history().count();
    const auto colour = [&](Index i) { return surface(program, i).colour; };
    const auto type = [&](const char* name, const QString& text) -> QColorDialog* {
        auto* swatch = program.window->findChild<QToolButton*>(QString::fromLatin1(name));
        QTest::mouseClick(swatch, Qt::LeftButton);
        auto* dialog = program.window->findChild<QColorDialog*>();
        if (!dialog || !test::waitFor([&] { return dialog->isVisible(); })) return nullptr;
        for (QLineEdit* line : dialog->findChildren<QLineEdit*>())
            if (line->text().startsWith(u'#')) {
                line->setFocus();
                line->selectAll();
                QTest::keyClicks(line, text);
            }
        return dialog;
    };
    const auto hue = [&] { // of the body, in the middle of the picture
        const QImage picture = program.window->view().grabPicture();
        return picture.pixelColor(picture.rect().center()).hue();
    };
    const int cold = hue();
    QCOMPARE_GT(cold, 150);
    const Eigen::Vector3f orange(1, std::pow(128 / 255.0F, 2.2F), 0);
    for (const bool accepted : {false, true}) {
        QPointer<QColorDialog> dialog = type("surface-colour", QStringLiteral("#ff8000"));
        QVERIFY2(dialog, "no dialog");
        for (const Index i : {0, 1}) // while it is open
            COMPARE_NEAR((colour(i) - orange).norm(), 0.0F, 2e-3F, "");
        QVERIFY(colour(2) == before.objects[0].surfaces[2].colour);
        COMPARE_NEAR(hue(), 30, 15, ""); // seen as well
        QTest::keyClick(dialog, accepted ? Qt::Key_Return : Qt::Key_Escape);
        QTRY_VERIFY(!dialog);
        QCOMPARE(document.history().count(), steps + accepted);
        if (!accepted) QVERIFY(document.scene() == before);
    }
    COMPARE_NEAR((colour(0) - orange).norm(), 0.0F, 2e-3F, "");
    document.history().undo();
    QVERIFY(document.scene() == before);
    COMPARE_NEAR(hue(), cold, 5, "");
    document.select({ref(program, 2)});
    program.perform("surface-colour");
    QVERIFY(!program.window->findChild<QColorDialog*>()); // it is locked
}

/// The button is let go over the dialog, and the view never hears of it. The key that closes the dialog is
/// let go where nobody hears it either.
void TestInspector::aDialogEndsTheTouch() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.fullForce());
    program.document.select({ref(program, 0)});
    program.press(program.centre());
    const auto touches = [&] {
        program.frames(2);
        return program.touch().contacts > 0;
    };
    QVERIFY2(test::waitFor(touches), "it never touches");
    program.perform("surface-colour");
    QPointer<QColorDialog> dialog = program.window->findChild<QColorDialog*>();
    QVERIFY2(dialog, "no dialog");
    QVERIFY2(test::waitFor([&] { return !touches(); }), "it goes on touching");
    QTest::keyPress(dialog, Qt::Key_Escape);
    QTRY_VERIFY(!dialog);
    QElapsedTimer clock; // longer than a key is to be held for a stop
    for (clock.start(); clock.elapsed() < 700;)
        program.frames(1);
    QVERIFY2(program.command("stop").isEnabled(), "the forces are off");
}

void TestInspector::aFeelIsCopiedAndPasted() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    TextureLayer noise, painted;
    noise.name = "noise";
    painted.name = "painted";
    painted.pattern.source = TextureSource::Painted;
    painted.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(8, 0.5F));
    program.document.editSurfaces(ref(program, 0), SceneChange::What::Layers, QStringLiteral("Set"),
                                  [&](Surface& each) {
                                      each.layers = {noise, painted};
                                      each.material.viscosity = 3;
                                      each.sides = Sides::Front;
                                      each.shading.on = true;
                                  });
    program.document.select(ref(program, 0));
    program.perform("copy-feel");
    program.document.select({ref(program, 3), ref(program, 4)});
    program.document.setLocked(ref(program, 4), true);
    const Scene before = program.document.scene();
    program.perform("paste-feel");
    const Surface &from = surface(program, 0), &to = surface(program, 3);
    QVERIFY(to.material == from.material);
    QVERIFY(to.layers == from.layers);
    QCOMPARE_EQ(to.sides, from.sides);
    QVERIFY(to.shading == from.shading);
    QCOMPARE_EQ(to.name, before.objects[0].surfaces[3].name);
    QVERIFY(surface(program, 4) == before.objects[0].surfaces[4]);
    program.document.history().undo();
    QVERIFY(program.document.scene() == before);
    // On another mesh what was painted has no meaning.
    while (program.document.history().canUndo())
        program.document.history().undo();
    QVERIFY(program.open(writeCube(folder_, 1.5)));
    program.document.select(ref(program, 1));
    program.perform("paste-feel");
    QCOMPARE(surface(program, 1).layers.size(), std::size_t(1));
    QCOMPARE(surface(program, 1).layers[0].name, std::string("noise"));
}

void TestInspector::othersBecomeTheSameAsTheActiveOne() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.document.select(ref(program, 5));
    program.type(QStringLiteral("dynamic-friction"), QStringLiteral("0"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("222"));
    program.document.select({ref(program, 0), ref(program, 1), ref(program, 5)});
    const int steps = program.document.history().count();
    program.perform("same-feel");
    QCOMPARE(program.document.history().count(), steps + 1);
    QCOMPARE(surface(program, 0).material.stiffness, 222.0);
    QCOMPARE(surface(program, 1).material.stiffness, 222.0);
    QCOMPARE_NE(surface(program, 2).material.stiffness, 222);
}

void TestInspector::normalsAreTurnedOver() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const Scene before = program.document.scene();
    const auto normal = [&](Index triangle) {
        const TriangleSoup& soup = *program.document.scene().objects[0].geometry;
        const auto& t = soup.triangles[triangle];
        const Vec3& a = soup.positions[t[0]];
        return Vec3((soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a));
    };
    std::vector<Vec3> old;
    for (Index t = 0; t < 12; ++t)
        old.push_back(normal(t));
    program.document.select(ref(program, 2));
    program.perform("normals-flip");
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    for (Index t = 0; t < 12; ++t) {
        const bool own = before.objects[0].geometry->surfaceOf[t] == 2;
        QVERIFY(normal(t).isApprox(own ? Vec3(-old[t]) : old[t]));
    }
    program.perform("normals-agree");
    QTRY_VERIFY_WITH_TIMEOUT(!program.document.editing(), kPatience);
    for (Index t = 0; t < 12; ++t)
        QVERIFY(normal(t).isApprox(old[t]));
    program.perform("normals-smooth");
    QVERIFY(surface(program, 2).shading.on);
    QVERIFY(!surface(program, 1).shading.on);
    program.perform("normals-flat");
    QVERIFY(!surface(program, 2).shading.on);
    while (program.document.history().canUndo())
        program.document.history().undo();
    QVERIFY(program.document.scene() == before);
}

TACTUM_GUI_TEST(TestInspector)

} // namespace test_inspector

#include "test_inspector.moc"
