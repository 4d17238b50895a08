// The feel of a scene on the same model, changed and exported again elsewhere.
#include <QTest>

#include "core/scene/carry_feel.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_carry_feel {

using namespace tactum;
using namespace tactum::test;

namespace {

Surface surface(const std::string& name, double stiffness = kStiffness.initial) {
    Surface made;
    made.name = name;
    made.material.stiffness = stiffness;
    return made;
}

void add(Scene& scene, const std::string& name, std::vector<Surface> surfaces) {
    SceneObject object;
    object.name = name;
    object.geometry = SoupBuilder().quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}).build();
    object.surfaces = std::move(surfaces);
    scene.add(std::move(object));
}

std::string said(const CarriedFeel& carried) {
    std::string text;
    for (const Finding& finding : carried.findings)
        text += finding.object + ": " + finding.sentence + "; " + finding.remedy + "\n";
    return text;
}

} // namespace

class TestCarryFeel : public QObject {
    Q_OBJECT

private slots:
    void everythingThatIsFeltComesAlong() {
        Scene from, onto;
        Surface felt = surface("glaze", 321);
        felt.material.staticFriction = 0.7;
        felt.shading.on = true;
        felt.sides = Sides::Front;
        felt.locked = true;
        felt.colour = {1, 0, 0};
        TextureLayer layer;
        layer.strength = 3e-4;
        felt.layers = {layer};
        add(from, "pot", {felt});
        from.proxyRadius = 0.002;
        from.finger =
            std::make_shared<const std::vector<FingerPoint>>(std::vector<FingerPoint>{{0, {1, 2, 3}}});
        add(onto, "pot", {surface("glaze")});
        const CarriedFeel carried = carryFeel(from, onto);
        QCOMPARE(carried.surfaces, std::size_t(1));
        QCOMPARE(said(carried), std::string());
        const Surface& now = onto.objects[0].surfaces[0];
        QVERIFY(now.material == felt.material);
        QVERIFY(now.shading == felt.shading);
        QVERIFY(now.layers == felt.layers);
        QVERIFY(now.sides == Sides::Front);
        QVERIFY(now.locked);
        QCOMPARE(now.colour, Surface().colour); // how it looks is the model's
        QCOMPARE_EQ(onto.proxyRadius, 0.002);
        QVERIFY(onto.finger == from.finger);
    }

    /// The object's name counts first, then the surface's alone, then that there is only one.
    void partnersFindEachOther() {
        Scene from, onto;
        add(from, "pot", {surface("clay", 100), surface("rim", 150)});
        add(from, "lid", {surface("clay", 200), surface("knob", 300)});
        add(from, "tray", {surface("tin", 400)});
        add(onto, "lid", {surface("clay")});          // of its own object
        add(onto, "handle", {surface("knob.001")});   // moved, and numbered by Blender
        add(onto, "tray.002", {surface("Material")}); // named anew, the only one
        add(onto, "spoon", {surface("clay")});        // which of the two?
        const CarriedFeel carried = carryFeel(from, onto);
        const auto stiffness = [&](std::size_t i) { return onto.objects[i].surfaces[0].material.stiffness; };
        QCOMPARE_EQ(stiffness(0), 200.0);
        QCOMPARE_EQ(stiffness(1), 300.0);
        QCOMPARE_EQ(stiffness(2), 400.0);
        QCOMPARE_EQ(stiffness(3), kStiffness.initial);
        QCOMPARE(carried.surfaces, std::size_t(3));
        COMPARE_CONTAINS(said(carried), "spoon: surface clay has no partner");
        COMPARE_CONTAINS(said(carried), "pot: surface clay of the scene with the feel has no partner");
        COMPARE_CONTAINS(said(carried), "pot: surface rim of the scene with the feel has no partner");
        COMPARE_LACKS(said(carried), "tin");
    }

    void aNameThatIsThereTwiceWithOneFeelIsNoQuestion() {
        Scene from, onto;
        add(from, "a", {surface("wood", 500)});
        add(from, "b", {surface("wood", 500)});
        add(onto, "c", {surface("wood"), surface("other")});
        QCOMPARE(carryFeel(from, onto).surfaces, std::size_t(1));
        QCOMPARE_EQ(onto.objects[0].surfaces[0].material.stiffness, 500.0);
    }

    void layersThatNeedTheOldMeshAreSaid() {
        Scene from, onto;
        Surface felt = surface("skin");
        TextureLayer painted, mapped;
        painted.pattern.source = TextureSource::Painted;
        mapped.pattern.source = TextureSource::Grooves;
        mapped.pattern.mapping = TextureMapping::Uv;
        felt.layers = {painted, mapped};
        add(from, "a", {felt});
        add(onto, "a", {surface("skin")});
        Scene same = onto;
        auto other = std::make_shared<TriangleSoup>(*onto.objects[0].geometry);
        std::swap(other->triangles[0], other->triangles[1]);
        onto.objects[0].geometry = other;
        const CarriedFeel carried = carryFeel(from, onto);
        QCOMPARE(onto.objects[0].surfaces[0].layers.size(), std::size_t(1));
        COMPARE_CONTAINS(said(carried), "1 painted layer of surface skin left out");
        COMPARE_CONTAINS(said(carried), "1 layer of surface skin lies on texture coordinates");
        COMPARE_LACKS(said(carryFeel(from, same)), "painted"); // the mesh is the one that was painted
        QCOMPARE(same.objects[0].surfaces[0].layers.size(), std::size_t(2));
    }

    /// A file of one mesh is called as the person calls it, and so is what is in it.
    void whatIsAloneOnBothSidesNeedsNoName() {
        Scene from, onto;
        add(from, "cup", {surface("cup", 500)});
        add(onto, "cup-2", {surface("cup-2")});
        QCOMPARE(carryFeel(from, onto).surfaces, std::size_t(1));
        QCOMPARE_EQ(onto.objects[0].surfaces[0].material.stiffness, 500.0);
        add(onto, "saucer", {surface("saucer")});
        onto.objects[0].surfaces[0].material.stiffness = kStiffness.initial;
        QCOMPARE(carryFeel(from, onto).surfaces, std::size_t(0));
        QCOMPARE_EQ(onto.objects[0].surfaces[0].material.stiffness, kStiffness.initial);
    }
};

TACTUM_TEST(TestCarryFeel)

} // namespace test_carry_feel

#include "test_carry_feel.moc"
