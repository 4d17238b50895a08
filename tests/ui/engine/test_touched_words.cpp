// What is touched, by name and feel.
//
// What would show that a test here is wrong: each name is seen from a scene that differs in one thing from
// the one before.
#include <QTest>

#include "core/runtime/hands.h"
#include "core/scene/primitives.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/told_engine.h"
#include "ui/engine/hand_name.h"
#include "ui/engine/touched.h"

namespace test_touched_words {

using namespace tactum;
using namespace tactum::test;

class TestTouchedWords : public QObject {
    Q_OBJECT

private slots:
    void aSurfaceHasTheNameThatTellsItApart() {
        Scene scene = sceneOf(Primitive::Box);
        SceneObject& box = scene.objects[0];
        box.name = "kettle";
        box.surfaces[0].name = "lid";
        const ObjectId id = box.id;
        QCOMPARE(nameOfSurface(scene, {id, 0}), QStringLiteral("lid"));
        box.surfaces[0].name = "";
        QCOMPARE(nameOfSurface(scene, {id, 0}), QStringLiteral("kettle"));
        // Beside another object it is that object's, and of several surfaces both.
        box.surfaces[0].name = "lid";
        SceneObject other = box;
        other.id = id + 1;
        other.name = "table";
        scene.objects.push_back(other);
        QCOMPARE(nameOfSurface(scene, {id, 0}), QStringLiteral("kettle"));
        scene.objects[0].surfaces.push_back(scene.objects[0].surfaces[0]);
        scene.objects[0].surfaces[1].name = "kettle";
        QCOMPARE(nameOfSurface(scene, {id, 0}), QStringLiteral("kettle: lid"));
        QCOMPARE(nameOfSurface(scene, {id, 1}), QStringLiteral("kettle"));
        QCOMPARE(nameOfSurface(scene, {id + 1, 0}), QStringLiteral("table"));
        // References to nothing.
        QCOMPARE(nameOfSurface(scene, {id, 2}), QString());
        QCOMPARE(nameOfSurface(scene, {id + 7, 0}), QString());
    }

    void itsFeelIsWhatIsFeltFirst() {
        Scene scene = sceneOf(Primitive::Box);
        SceneObject& box = scene.objects[0];
        Surface& lid = box.surfaces[0];
        lid.name = "lid";
        lid.material.stiffness = 812.5;
        lid.material.staticFriction = 0.607;
        lid.material.dynamicFriction = 0.4;
        QCOMPARE(feelText(scene, {box.id, 0}), QStringLiteral("lid: 813 N/m, friction 0.61 / 0.40"));
        lid.sides = Sides::None;
        QCOMPARE(feelText(scene, {box.id, 0}), QStringLiteral("lid: not felt"));
        QCOMPARE(feelText(scene, {box.id, 1}), QString());
        QCOMPARE(feelText(scene, {box.id + 1, 0}), QString());
    }

    void handsOfOneNameAreNumbered() {
        ToldEngine engine(3);
        engine.of[0].device.name = "An arm";
        engine.of[1].device.name = "A wheel";
        engine.of[2].device.name = "A wheel";
        const Hands hands(engine);
        QCOMPARE(handName(hands, 0), QStringLiteral("An arm"));
        QCOMPARE(handName(hands, 1), QStringLiteral("A wheel 2"));
        QCOMPARE(handName(hands, 2), QStringLiteral("A wheel 3"));
    }
};

TACTUM_TEST(TestTouchedWords)

} // namespace test_touched_words

#include "test_touched_words.moc"
