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

Surface painted(const std::string& name) {
    Surface made = surface(name);
    made.layers.resize(1);
    made.layers[0].pattern.source = TextureSource::Painted;
    return made;
}

/// A square, or another quadrangle; with its lower left corner at `at`.
void add(Scene& scene, const std::string& name, std::vector<Surface> surfaces, const Vec3& at = Vec3::Zero(),
         const Vec3& corner = {1, 1, 0}) {
    SceneObject object;
    object.name = name;
    object.geometry = SoupBuilder().quad({0, 0, 0}, {1, 0, 0}, corner, {0, 1, 0}).build();
    object.pose.translation = at;
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
        QCOMPARE_EQ(onto.proxyRadius, 0.002);
        QVERIFY(onto.finger == from.finger);
    }

    /// How an object looks is its file's, where that says anything; else it looks as it did.
    void coloursComeAlongWhereTheFileSaysNone() {
        const Eigen::Vector3f plain = Surface().colour, red(1, 0, 0), blue(0, 0, 1), green(0, 1, 0);
        const auto coloured = [](const char* name, const Eigen::Vector3f& colour) {
            Surface made = surface(name);
            made.colour = colour;
            return made;
        };
        Scene from, onto;
        add(from, "pot", {coloured("glaze", red), coloured("rim", blue)});
        add(from, "lid", {coloured("knob", red), coloured("top", blue)});
        add(onto, "pot", {surface("rim"), surface("glaze"), surface("foot")});
        add(onto, "lid", {coloured("knob", green), surface("top")}); // one of its surfaces has a colour
        carryFeel(from, onto);
        const auto colour = [&](std::size_t object, std::size_t i) {
            return onto.objects[object].surfaces[i].colour;
        };
        QCOMPARE(colour(0, 0), blue);
        QCOMPARE(colour(0, 1), red);
        QCOMPARE(colour(0, 2), plain); // nobody's
        QCOMPARE(colour(1, 0), green);
        QCOMPARE(colour(1, 1), plain);
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

    /// As many vertices and the same triangles are no proof that it is the same.
    void paintOnAnotherShapeIsSaid() {
        Scene from;
        add(from, "a", {painted("skin")});
        add(from, "b", {surface("other")});
        Scene bent, rounded, larger;
        for (auto* onto : {&bent, &rounded, &larger})
            add(*onto, "b", {surface("other")});
        add(bent, "a", {surface("skin")}, {0, 0, 0}, {1, 0.9, 0});
        add(rounded, "a", {surface("skin")}, {5, 0, 0}, {1, 1 - 1e-6, 0}); // moved, and written to a file
        add(larger, "a", {surface("skin")});
        auto grown = std::make_shared<TriangleSoup>(*larger.objects[1].geometry);
        for (Vec3& p : grown->positions)
            p *= 1000;
        larger.objects[1].geometry = grown;
        const CarriedFeel onBent = carryFeel(from, bent);
        COMPARE_CONTAINS(said(onBent), "a: 1 painted layer of surface skin carried vertex by vertex onto a "
                                       "shape that is not the same; look whether");
        QCOMPARE(onBent.layersLost, std::size_t(0));
        QCOMPARE(bent.objects[1].surfaces[0].layers.size(), std::size_t(1));
        QCOMPARE(said(carryFeel(from, rounded)), std::string());
        QCOMPARE(said(carryFeel(from, larger)), std::string());
    }

    void paintOfAnotherObjectStaysBehind() {
        Scene from;
        add(from, "a", {painted("skin")});
        add(from, "b", {surface("other")});
        Scene elsewhere = from, renamed = from;
        elsewhere.objects[0].name = renamed.objects[0].name = "c";
        elsewhere.objects[0].pose.translation = {3, 0, 0};
        for (auto* onto : {&elsewhere, &renamed})
            onto->objects[0].surfaces = {surface("skin")};
        const CarriedFeel carried = carryFeel(from, elsewhere);
        QCOMPARE(carried.layersLost, std::size_t(1));
        QVERIFY(elsewhere.objects[0].surfaces[0].layers.empty());
        COMPARE_CONTAINS(said(carried), "c: 1 painted layer of surface skin left out, for it was painted on "
                                        "another object; paint it again");
        QCOMPARE(said(carryFeel(from, renamed)), std::string()); // it is where that was
        QCOMPARE(renamed.objects[0].surfaces[0].layers.size(), std::size_t(1));
    }

    /// One part of a model is missing in one export, and back in the next.
    void whatWasGoneComesBackWithItsFeel() {
        Scene from, without, again;
        add(from, "pot", {surface("clay", 100)});
        add(from, "lid", {surface("clay", 200)}); // of the same name, which is not as near
        add(without, "pot", {surface("clay")});
        add(again, "pot", {surface("clay")});
        add(again, "lid", {surface("clay")});
        Scene other = again;
        other.objects[1].name = "tray";
        const std::vector<SceneObject> nothing;
        const CarriedFeel first = carryFeel(from, without, &nothing);
        QCOMPARE(first.surfacesLost, std::size_t(1));
        QCOMPARE(first.gone.size(), std::size_t(1));
        COMPARE_CONTAINS(said(first), "its feel is kept for when the file has it again");
        const CarriedFeel second = carryFeel(without, again, &first.gone);
        QCOMPARE_EQ(again.objects[1].surfaces[0].material.stiffness, 200.0);
        QCOMPARE(second.surfaces, std::size_t(1));
        QCOMPARE(second.back, std::size_t(1));
        QVERIFY(second.gone.empty());
        QCOMPARE(said(second), std::string());
        const CarriedFeel third = carryFeel(without, other, &first.gone); // not its
        QCOMPARE_EQ(other.objects[1].surfaces[0].material.stiffness, 100.0);
        QCOMPARE(third.gone.size(), std::size_t(1)); // it goes on to wait
    }

    void bodiesThatStayBehindAreCounted() {
        Scene from, onto;
        add(from, "pot", {surface("clay")});
        add(onto, "pot", {surface("clay")});
        from.mechanics.bodies.resize(3);
        const CarriedFeel carried = carryFeel(from, onto);
        QCOMPARE(carried.bodiesLost, std::size_t(3));
        COMPARE_CONTAINS(said(carried), "3 bodies left out");
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
