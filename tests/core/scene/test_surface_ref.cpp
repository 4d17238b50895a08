// Which surfaces of a scene feel alike.
#include <functional>

#include <QTest>

#include "core/scene/surface_ref.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_surface_ref {

using namespace tactum;

class TestSurfaceRef : public QObject {
    Q_OBJECT

private slots:
    void surfacesThatFeelAlikeAreFoundInEveryObject() {
        Scene scene;
        SceneObject object;
        object.geometry = std::make_shared<TriangleSoup>();
        object.surfaces.resize(3);
        object.surfaces[1].name = "red";
        object.surfaces[1].colour = {1, 0, 0};
        object.surfaces[2].material.stiffness = 300;
        const ObjectId first = scene.add(object).id, second = scene.add(object).id;
        using Refs = std::vector<SurfaceRef>;
        const Refs plain{{first, 0}, {first, 1}, {second, 0}, {second, 1}};
        QVERIFY(surfacesLike(scene, {second, 1}) == plain);
        QVERIFY(surfacesLike(scene, {first, 2}) == (Refs{{first, 2}, {second, 2}}));
        Surface& changed = scene.find(second)->surfaces[1];
        const std::vector<std::function<void(Surface&)>> changes{
            [](Surface& s) { s.material.damping = 1; }, [](Surface& s) { s.shading.on = true; },
            [](Surface& s) { s.layers.resize(1); }, [](Surface& s) { s.sides = Sides::Front; }};
        for (const auto& change : changes) {
            const Surface before = changed;
            change(changed);
            QVERIFY(surfacesLike(scene, {second, 1}) == (Refs{{second, 1}}));
            changed = before;
        }
        QVERIFY(surfacesLike(scene, {second, 3}).empty());
        QVERIFY(surfacesLike(scene, {9, 0}).empty());
    }
};

TACTUM_TEST(TestSurfaceRef)

} // namespace test_surface_ref

#include "test_surface_ref.moc"
