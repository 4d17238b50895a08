// glTF animations as rigid motions: against the node transforms multiplied out, in every place of the tree.
#include <QTest>

#include "core/files/gltf/gltf_file.h"
#include "core/motion/body_motion.h"
#include "core/scene/describe.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_gltf_motion {

using namespace tactum;

namespace {

constexpr double pi = 3.14159265358979323846;
using Affine = Eigen::Affine3d;
using Local = Affine (*)(double t);

TriangleSoup tetrahedron() {
    TriangleSoup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    soup.surfaceOf.assign(4, 0);
    return soup;
}

std::vector<double> turn(double angle, const Vec3& axis = Vec3::UnitZ()) {
    const Quat q(Eigen::AngleAxisd(angle, axis.normalized()));
    return {q.x(), q.y(), q.z(), q.w()};
}

/// From (0, 0, 0) to (2, 0, 1) and back, in two seconds.
WrittenChannel sliding(int node) {
    return {node, "translation", "LINEAR", {0, 1, 2}, {{0, 0, 0}, {2, 0, 1}, {0, 0, 0}}};
}
Affine slidingAt(double t) {
    const double s = t <= 1 ? t : 2 - t;
    return Affine(Eigen::Translation3d(2 * s, 0, s));
}

/// Once around z in two seconds.
WrittenChannel turning(int node) {
    return {node,
            "rotation",
            "LINEAR",
            {0, 0.5, 1, 1.5, 2},
            {turn(0), turn(pi / 2), turn(pi), turn(3 * pi / 2), turn(2 * pi)}};
}
Affine turningAt(double t) {
    return Affine(Eigen::AngleAxisd(pi * t, Vec3::UnitZ()));
}

Vec3 cornerAt(const SceneObject& object, int corner, double t) {
    const Pose pose = object.motion ? object.pose * object.motion->at(t) : object.pose;
    return pose.apply(object.geometry->positions[std::size_t(corner)]);
}

/// How far any corner of the object is from where the transform puts that of the tetrahedron, at any time.
template <class Transform> double error(const SceneObject& object, Transform&& transform) {
    const TriangleSoup soup = tetrahedron();
    double most = 0;
    for (double t = 0; t < 2; t += 0.0137)
        for (int corner = 0; corner < 4; ++corner)
            most = std::max(
                most,
                (cornerAt(object, corner, t) - transform(t) * soup.positions[std::size_t(corner)]).norm());
    return most;
}

} // namespace

class TestGltfMotion : public QObject {
    Q_OBJECT

private slots:
    void aSlidingNodeMoves() {
        const LoadedScene loaded =
            read(R"("nodes":[{"name":"lift","mesh":0,"translation":[5,5,5]}])", {sliding(0)});
        const SceneObject& lift = loaded.scene.objects.at(0);
        QVERIFY(lift.motion != nullptr);
        QCOMPARE(lift.motion->duration, 2.0);
        QCOMPARE(lift.motion->at(0), Pose{}); // relative to the pose, which is that at the beginning
        QCOMPARE_LT(error(lift, slidingAt), 1e-12);
        QVERIFY(loaded.findings.empty());
    }

    // The keys are in the frame of the parent, the motion in that of the body.
    void aTurnedNodeSlidesTheSameWay() {
        const std::string quarter = R"("rotation":[0,0,0.7071067811865476,0.7071067811865476])";
        const LoadedScene loaded = read(R"("nodes":[{"mesh":0,)" + quarter + "}]", {sliding(0)});
        const Affine turned(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()));
        QCOMPARE_LT(error(loaded.scene.objects.at(0), [&](double t) { return slidingAt(t) * turned; }), 1e-9);
    }

    void aNodeWithoutAnimationStaysWhereItIs() {
        const LoadedScene loaded =
            read(R"("nodes":[{"name":"lift","mesh":0},{"mesh":0,"translation":[0,9,0]}])", {sliding(0)});
        QVERIFY(loaded.scene.objects.at(0).motion);
        QVERIFY(!loaded.scene.objects.at(1).motion);
        COMPARE_NEAR(cornerAt(loaded.scene.objects[1], 0, 1), Vec3(0, 9, 0), 1e-12, "m");
    }

    // The body's frame is the moving node, so that a mesh beside the axis goes round on its exact arc.
    void aMeshBelowAMovingNodeMovesExactly() {
        const LoadedScene loaded = read(
            R"("scenes":[{"nodes":[0]}],"nodes":[{"name":"root","translation":[0,0,3],"scale":[2,2,2],"children":[1]},)"
            R"({"name":"axle","children":[2],"scale":[1,3,1]},{"name":"blade","mesh":0,"translation":[4,0,0]}])",
            {turning(1)});
        const Affine root = Eigen::Translation3d(0, 0, 3) * Eigen::Scaling(2.0);
        const Affine blade = Eigen::Scaling(1.0, 3.0, 1.0) * Affine(Eigen::Translation3d(4, 0, 0));
        const SceneObject& object = loaded.scene.objects.at(0);
        QCOMPARE(object.name, std::string("blade"));
        QCOMPARE_LT(error(object, [&](double t) { return root * turningAt(t) * blade; }), 1e-6); // float keys
        QCOMPARE_EQ(object.motion->rotation.times.size(), 5); // not sampled
        QVERIFY(object.motion->translation.times.empty());
    }

    void twoMovingAncestorsAreSampled() {
        const LoadedScene loaded = read(
            R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"children":[2]},{"mesh":0,"translation":[1,0,0]}])",
            {sliding(1), turning(0)});
        const Affine mesh(Eigen::Translation3d(1, 0, 0));
        QCOMPARE_LT(
            error(loaded.scene.objects.at(0), [&](double t) { return turningAt(t) * slidingAt(t) * mesh; }),
            5e-6);
        QVERIFY(loaded.findings.empty());
        QVERIFY(!loaded.scene.objects[0].motion->jumpsAtEnd);
    }

    void aJumpOfAnAncestorStaysAJump() {
        WrittenChannel step = sliding(0);
        step.interpolation = "STEP";
        const LoadedScene loaded =
            read(R"("scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"mesh":0}])", {step, turning(1)});
        const Motion& motion = *loaded.scene.objects.at(0).motion;
        QCOMPARE_LT((motion.at(0.9999).translation).norm(), 1e-12);
        COMPARE_NEAR(motion.at(1).translation, Vec3(2, 0, 1), 1e-12, "m");
        QVERIFY(motion.jumpsBetween(0.9999, 1.0001));
        QVERIFY(!motion.jumpsBetween(0.5, 0.9999));
    }

    // Turned below an uneven scale a mesh shears: not rigid, so it is said, and the rest of it is felt.
    void shearingIsLeftOutWithAWarning() {
        const LoadedScene loaded =
            read(R"("scenes":[{"nodes":[0]}],"nodes":[{"scale":[3,1,1],"children":[1]},{"mesh":0}])",
                 {turning(1)});
        COMPARE_CONTAINS(said(loaded), "is scaled or sheared while it moves");
        const SceneObject& object = loaded.scene.objects.at(0);
        COMPARE_NEAR(cornerAt(object, 1, 0), Vec3(3, 0, 0), 1e-9, "m");
        COMPARE_NEAR((cornerAt(object, 1, 0.77) - cornerAt(object, 0, 0.77)).norm(), 3, 1e-9, "m");
    }

    void cubicTracksKeepTheirSlopes() {
        const WrittenChannel cubic{0,
                                   "translation",
                                   "CUBICSPLINE",
                                   {0, 2},
                                   {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}}};
        const LoadedScene loaded = read(
            R"("scenes":[{"nodes":[1]}],"nodes":[{"mesh":0},{"children":[0],"scale":[2,2,2],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])",
            {cubic});
        const SceneObject& object = loaded.scene.objects.at(0);
        for (double t : {0.0, 0.5, 1.3, 1.9}) {
            const double s = t / 2; // p0 = 0, p1 = 2, slopes 1: the straight line
            COMPARE_NEAR(cornerAt(object, 0, t), Vec3(0, 2 * 2 * s, 0), 1e-12, "m");
        }
    }

    void bakedChannelsThatStandStillAreNoMotion() {
        const LoadedScene loaded = read(R"("nodes":[{"mesh":0,"translation":[9,9,9]}])",
                                        {{0, "translation", "LINEAR", {0, 1}, {{1, 2, 3}, {1, 2, 3}}}});
        QVERIFY(!loaded.scene.objects.at(0).motion);
        COMPARE_NEAR(cornerAt(loaded.scene.objects[0], 0, 0), Vec3(1, 2, 3), 1e-12, "m");
    }

    void whatIsNotRigidIsSaid() {
        const LoadedScene loaded =
            read(R"("nodes":[{"mesh":0}])", {sliding(0),
                                             {0, "scale", "LINEAR", {0, 1}, {{1, 1, 1}, {2, 2, 2}}},
                                             {0, "weights", "LINEAR", {0, 1}, {{0}, {1}}},
                                             sliding(0)});
        COMPARE_CONTAINS(said(loaded), "1 channel that animates a scale");
        COMPARE_CONTAINS(said(loaded), "1 channel that animates morph targets");
        COMPARE_CONTAINS(said(loaded), "1 channel that animates what another one animates already");
        QCOMPARE_LT(error(loaded.scene.objects.at(0), slidingAt), 1e-12);
    }

    void skinsAreSaid() {
        const LoadedScene loaded = read(R"("skins":[{"joints":[0]}],"nodes":[{"mesh":0,"skin":0}])", {});
        COMPARE_CONTAINS(said(loaded), "is deformed by a skin");
    }

    void aScaledSceneMovesAsFar() {
        LoadedScene loaded = read(R"("nodes":[{"mesh":0}])", {sliding(0)});
        const Vec3 way = cornerAt(loaded.scene.objects[0], 1, 1) - cornerAt(loaded.scene.objects[0], 1, 0);
        const double before = boundsOf(loaded.scene).diagonal();
        fitDiagonal(loaded.scene, 0.1);
        const Vec3 scaledWay =
            cornerAt(loaded.scene.objects[0], 1, 1) - cornerAt(loaded.scene.objects[0], 1, 0);
        COMPARE_NEAR(scaledWay, way * (0.1 / before), 1e-12, "");
    }

    void isDescribedAndChecked() {
        LoadedScene loaded = read(R"("nodes":[{"name":"wheel","mesh":0},{"mesh":0}])", {turning(0)});
        const SceneDescription description = describe(loaded.scene);
        QVERIFY(description.objects.at(0).motion.has_value());
        QVERIFY(!description.objects.at(1).motion.has_value());
        COMPARE_NEAR(description.objects[0].motion->topSpeed, pi, 1e-5, "m/s"); // 1 m from the axis
        QVERIFY(!description.objects[0].motion->jumps);
        COMPARE_LACKS(sentences(validate(loaded.scene)), "moves at up to");
        const LoadedScene fast =
            read(R"("nodes":[{"mesh":0}])", {{0, "translation", "LINEAR", {0, 1}, {{0, 0, 0}, {11, 0, 0}}}});
        COMPARE_CONTAINS(sentences(validate(fast.scene)), "moves at up to 11 m/s, faster than 10 m/s");
        COMPARE_CONTAINS(sentences(validate(fast.scene)), "jumps from one pose to another");
    }

    // 1.01 is beyond what rounding to bytes does to a length, 1.001 is not.
    void rotationsAreBroughtToUnitLengthAndSaid() {
        const std::string turned = R"("nodes":[{"mesh":0,"rotation":[0,0,0.7071067811865476,)";
        COMPARE_LACKS(said(read(turned + "0.7071067811865476]}]", {turning(0)})), "unit length");
        const LoadedScene node = read(turned + "0.75]},{\"rotation\":[0,0,0,1.001]}]", {});
        COMPARE_CONTAINS(said(node), "1 node with a rotation that is not of unit length");
        const Quat q = node.scene.objects.at(0).pose.rotation;
        COMPARE_NEAR(q.norm(), 1, 1e-12, "");
        COMPARE_NEAR(q.z() / q.w(), 0.7071067811865476 / 0.75, 1e-9, "");

        WrittenChannel channel = turning(0);
        for (double& component : channel.values[2])
            component *= 1.01;
        for (double& component : channel.values[3])
            component *= 1.001;
        const LoadedScene keys = read(R"("nodes":[{"mesh":0}])", {channel});
        COMPARE_CONTAINS(said(keys), "animation: 1 key with a rotation that is not of unit length");
        QCOMPARE_LT(error(keys.scene.objects.at(0), turningAt), 1e-6);
    }

    void rotationsThatAreNoneAreRefused() {
        for (const char* rotation : {"0,0,0,0", "0,0,0,1e200", "1e-9,0,0,0"}) {
            const std::string nodes = R"("nodes":[{"mesh":0,"rotation":[)" + std::string(rotation) + "]}]";
            const auto loaded = folder_.load("a.glb", asAnimatedGlb(tetrahedron(), nodes, {}));
            QVERIFY2(!loaded, rotation);
            COMPARE_CONTAINS(loaded.error().text, "no usable rotation");
        }
    }

    void whatIsDamagedIsLeftOut_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("error");
        const auto row = [](const char* name, const WrittenChannel& channel, const char* part) {
            QTest::newRow(name) << QByteArray::fromStdString(
                                       asAnimatedGlb(tetrahedron(), R"("nodes":[{"mesh":0}])", {channel}))
                                << QString(part);
        };
        row("no such node", sliding(4), "moves a node that is not there");
        WrittenChannel channel = sliding(0);
        channel.times = {0, 1, 1};
        row("times stand still", channel, "has two keys at the same time");
        channel.times = {0, 1, 0.5};
        row("times fall", channel, "times that do not rise");
        channel.times = {0, NAN, 2};
        row("times are no numbers", channel, "times that do not rise");
        channel.times = {-1, 0, 1};
        row("times before the beginning", channel, "times that do not rise");
        channel = sliding(0);
        channel.values.pop_back();
        row("values run out", channel, "values for its times, which need 3");
        channel.values.resize(5, channel.values[0]);
        row("values without times", channel, "has 5 values for its times, which need 3");
        channel = sliding(0);
        channel.interpolation = "CUBICSPLINE";
        row("slopes run out", channel, "has 3 values for its times, which need 9");
        channel = sliding(0);
        channel.values[1][2] = INFINITY;
        row("values are no numbers", channel, "not a number of at most 1e6");
        channel = turning(0);
        channel.values[2] = {0, 0, 0, 0};
        row("no rotation", channel, "no usable rotation");
        channel = turning(0);
        channel.interpolation = "CATMULLROM";
        row("unknown interpolation", channel, "unknown interpolation \"CATMULLROM\"");
        channel = turning(0);
        channel.values[2] = {NAN, 0, 0, 1};
        row("rotation is no number", channel, "not a number of at most 1e6");
        channel = turning(0);
        channel.path = "translation";
        row("four numbers for three", channel, "has a type that does not fit");
    }
    /// The shape is read, and stands still.
    void whatIsDamagedIsLeftOut() {
        QFETCH(QByteArray, content);
        QFETCH(QString, error);
        const auto loaded = folder_.load("a.glb", content.toStdString());
        QVERIFY2(loaded, loaded ? "" : loaded.error().text.c_str());
        QVERIFY(!loaded->scene.objects.at(0).motion);
        const auto said = std::ranges::find_if(loaded->findings, [](const Finding& finding) {
            return finding.sentence.starts_with("animation: 1 damaged channel left out: ");
        });
        QVERIFY(said != loaded->findings.end());
        COMPARE_CONTAINS(said->sentence, error.toStdString());
        COMPARE_LACKS(said->sentence, "\n");
        COMPARE_LACKS(said->sentence, "a.glb");
    }

    /// Of another form than glTF gives them: the shape is read, and what else moves goes on moving.
    void animationsOfAnotherFormAreLeftOut() {
        const Source whole = Source::ofBytes(
            "a.glb", asAnimatedGlb(tetrahedron(), R"("nodes":[{"mesh":0},{"mesh":0}])", {sliding(0)}));
        const GltfFile file = openGltf(whole);
        const auto loadedWith = [&](const char* place, const Json& wrong) {
            Json json = file.json;
            json[Json::json_pointer(place)] = wrong;
            return folder_.load("a.glb", packGlb(json, file.binary));
        };
        for (const auto& [place, wrong] : {std::pair<const char*, Json>{"/animations", 5},
                                           {"/animations/0", 5},
                                           {"/animations/0/channels", "none"},
                                           {"/animations/0/channels/0", nullptr},
                                           {"/animations/0/channels/0/target", 1},
                                           {"/animations/0/channels/0/target/node", "first"},
                                           {"/animations/0/channels/0/target/node", -1},
                                           {"/animations/0/channels/0/target/path", 7},
                                           {"/animations/0/channels/0/sampler", 1.5},
                                           {"/animations/0/samplers/0/input", "a"},
                                           {"/animations/0/samplers/0/interpolation", 2}}) {
            const auto loaded = loadedWith(place, wrong);
            VERIFY_RESULT(loaded);
            QVERIFY2(!loaded->scene.objects.at(0).motion, place);
            COMPARE_CONTAINS(said(*loaded), "1 animation that is damaged left out");
        }
        const auto beside = loadedWith("/animations/1", 5);
        VERIFY_RESULT(beside);
        QVERIFY(beside->scene.objects.at(0).motion);
        COMPARE_CONTAINS(said(*beside), "1 animation that is damaged left out");
    }

private:
    LoadedScene read(const std::string& nodes, const std::vector<WrittenChannel>& channels) {
        const auto loaded = folder_.load("mesh.glb", asAnimatedGlb(tetrahedron(), nodes, channels));
        if (!loaded) qFatal("%s", loaded.error().text.c_str());
        return std::move(*loaded);
    }

    static std::string sentences(const std::vector<Finding>& findings) {
        std::string all;
        for (const Finding& finding : findings)
            all += finding.sentence + '\n';
        return all;
    }

    FileFolder folder_;
};

TACTUM_TEST(TestGltfMotion)

} // namespace test_gltf_motion

#include "test_gltf_motion.moc"
