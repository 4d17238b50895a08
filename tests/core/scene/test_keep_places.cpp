// A model that comes once more: its objects come to where the author has put those of before.
#include <QTest>

#include "core/scene/arrange.h"
#include "core/scene/keep_places.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_keep_places {

using namespace tactum;
using namespace tactum::test;

namespace {

ObjectId add(Scene& scene, const std::string& name, const Vec3& at, double size = 0.1) {
    SceneObject object;
    object.name = name;
    object.pose.translation = at;
    object.geometry = SoupBuilder().quad({0, 0, 0}, {size, 0, 0}, {size, 0, size}, {0, 0, size}).build();
    object.surfaces.resize(1);
    return scene.add(std::move(object)).id;
}

void put(Scene& scene, ObjectId object, const Arrangement& by) {
    const ObjectId objects[] = {object};
    arrange(scene, goingAlong(scene, objects), by);
}

std::string said(const std::vector<Finding>& findings) {
    std::string text;
    for (const Finding& finding : findings)
        text += finding.object + ": " + finding.sentence + "; " + finding.remedy + "\n";
    return text;
}

} // namespace

class TestKeepPlaces : public QObject {
    Q_OBJECT

    Scene was_;
    ObjectId pot_ = 0, lid_ = 0, tray_ = 0;

private slots:
    void init() {
        was_ = {};
        pot_ = add(was_, "pot", {0, 0, 0});
        lid_ = add(was_, "lid", {0, 0.1, 0});
        tray_ = add(was_, "tray", {0.3, 0, 0});
    }

    void whatWasNotMovedStaysToTheBit() {
        Scene onto = was_;
        onto.objects[1].name = "lid.001"; // as Blender writes it
        const Scene before = onto;
        QCOMPARE(said(keepPlaces(was_, was_, onto)), std::string());
        QVERIFY(onto == before);
    }

    /// The scene was made to fit, then the lid was turned, moved and made smaller.
    void objectsComeToWhereTheirPartnersAre() {
        Scene now = was_;
        fitDiagonal(now, 0.2);
        const Scene fitted = now;
        const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
        put(now, lid_, {.about = {0.01, 0.02, 0}, .move = {0, 0, 0.05}, .turn = turn, .scale = 0.5});

        Scene onto;
        add(onto, "knob", {0, 0.2, 0});  // new
        add(onto, "lid", {0, 0.1, 0.1}); // moved in the file by 0.1 m along z, and larger there
        add(onto, "pot", {0, 0, 0}, 0.2);
        add(onto, "tray", {0.3, 0, 0});
        QCOMPARE(said(keepPlaces(was_, now, onto)), std::string());

        const double factor = 0.2 / boundsOf(was_).diagonal();
        const auto place = [](const Scene& scene, std::size_t i, const Vec3& p) {
            return scene.objects[i].pose.apply(p);
        };
        const double tolerance = 1e-9;
        // The pot is where it was, and grew by what the file says.
        COMPARE_NEAR(place(onto, 2, {0, 0, 0}), fitted.objects[0].pose.translation, tolerance, "m");
        COMPARE_NEAR(boundsOf(*onto.objects[2].geometry).high.x(), 0.2 * factor, tolerance, "m");
        // The lid moved in the frame that the author has turned and shrunk.
        const Pose lid = now.objects[1].pose;
        COMPARE_NEAR(place(onto, 1, {0, 0, 0}), lid.apply(Vec3(0, 0, 0.05 * factor)), tolerance, "m");
        COMPARE_NEAR(boundsOf(*onto.objects[1].geometry).high.x(), 0.05 * factor, tolerance, "m");
        // The knob goes with most of the others, as it lies in the file.
        COMPARE_NEAR(place(onto, 0, {0, 0, 0}),
                     Vec3(fitted.objects[0].pose.translation + factor * Vec3(0, 0.2, 0)), tolerance, "m");
        QCOMPARE_EQ(onto.objects[2].id, pot_);
        QCOMPARE_EQ(onto.objects[1].id, lid_);
        QCOMPARE_EQ(onto.objects[3].id, tray_);
        QCOMPARE_GT(onto.objects[0].id, tray_);
    }

    void theFingerGoesWithMostOfTheObjects() {
        Scene now = was_;
        for (const ObjectId each : {pot_, lid_, tray_})
            put(now, each, {.move = {0, 1, 0}, .scale = 2});
        Scene onto = was_;
        onto.finger =
            std::make_shared<const std::vector<FingerPoint>>(std::vector<FingerPoint>{{0, {1, 2, 3}}});
        keepPlaces(was_, now, onto);
        COMPARE_NEAR((*onto.finger)[0].position, Vec3(2, 5, 6), 1e-9, "m");
    }

    void anotherFormIsSaidAndStaysAsInTheFile() {
        Scene now = was_;
        auto stretched = std::make_shared<TriangleSoup>(*now.objects[0].geometry);
        for (Vec3& p : stretched->positions)
            p.x() *= 3;
        now.objects[0].geometry = stretched;
        auto mended = std::make_shared<TriangleSoup>(*now.objects[1].geometry);
        std::swap(mended->triangles[0][1], mended->triangles[0][2]);
        now.objects[1].geometry = mended;
        Scene onto = was_;
        const std::string text = said(keepPlaces(was_, now, onto));
        COMPARE_CONTAINS(text, "pot: was given another form here");
        COMPARE_CONTAINS(text, "lid: was repaired here");
        COMPARE_LACKS(text, "tray");
        QVERIFY(onto == was_);
    }

    void whatIsGoneKeepsNobodysPlace() {
        Scene now = was_;
        std::erase_if(now.objects, [&](const SceneObject& object) { return object.id == tray_; });
        Scene onto = was_;
        QCOMPARE(said(keepPlaces(was_, now, onto)), std::string());
        QCOMPARE_EQ(onto.objects[0].id, pot_);
        QCOMPARE_GT(onto.objects[2].id, lid_); // no object that is known by its id comes back as another
    }

    void idsGoByNamesAlone() {
        Scene now, onto;
        add(now, "spoon", {0, 0, 0});
        const ObjectId cup = add(now, "cup", {1, 0, 0}), second = add(now, "cup", {2, 0, 0});
        add(onto, "cup", {5, 0, 0});
        add(onto, "fork", {6, 0, 0});
        add(onto, "cup.001", {7, 0, 0});
        add(onto, "cup", {8, 0, 0});
        keepIds(now, onto);
        QCOMPARE_EQ(onto.objects[0].id, cup);
        QCOMPARE_GT(onto.objects[1].id, second);
        QCOMPARE_EQ(onto.objects[2].id, second);
        QCOMPARE_GT(onto.objects[3].id, onto.objects[1].id);
        QVERIFY(onto.objects[0].pose.translation == Vec3(5, 0, 0));
    }
};

TACTUM_TEST(TestKeepPlaces)

} // namespace test_keep_places

#include "test_keep_places.moc"
