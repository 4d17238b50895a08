// A bundle beside what its scene feels like: true ones pass, and one changed number is found.
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/archive/bundle_files.h"
#include "core/bundle/bundle.h"
#include "core/bundle/verify_bundle.h"
#include "core/files/load_scene.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_verify_bundle {

using namespace tactum;
using namespace tactum::test;

namespace {

Scene plate() {
    Scene scene;
    SceneObject object;
    object.name = "plate";
    object.geometry =
        SoupBuilder().quad({-0.1, 0, -0.1}, {-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}).build();
    object.surfaces.resize(1);
    object.surfaces[0].name = "top";
    object.surfaces[0].material.staticFriction = 0.5;
    object.surfaces[0].material.dynamicFriction = 0.3;
    scene.add(object);
    return scene;
}

/// From above the plate 4 mm into it and 2 cm along.
std::shared_ptr<const std::vector<FingerPoint>> stroke(double height) {
    std::vector<FingerPoint> path;
    for (int i = 0; i <= 200; ++i)
        path.push_back({i * 1e-3, {i * 1e-4, height + 0.01 - i * 7e-5, 0}});
    return std::make_shared<const std::vector<FingerPoint>>(std::move(path));
}

} // namespace

class TestVerifyBundle : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    /// The verdict on a bundle whose file `name` is changed, under a manifest that knows of it.
    Result<BundleVerdict> verdictOn(const std::string& bytes, const char* name = nullptr,
                                    const std::function<void(std::string&)>& change = {}) {
        std::string changed = bytes;
        if (name) {
            const auto files = BundleFiles::open(bytes);
            if (!files) return tl::unexpected<Error>(files.error());
            std::vector<ZipEntry> all(files->all().begin(), files->all().end());
            for (ZipEntry& file : all)
                if (file.name == name) change(file.bytes);
            changed = packBundle(all);
        }
        const std::filesystem::path file = folder_.filePath(QStringLiteral("a.zip")).toStdString();
        std::ofstream(file, std::ios::binary) << changed;
        const auto loaded = loadScene(file);
        if (!loaded) return tl::unexpected<Error>(loaded.error());
        return verifyBundle(file, loaded->scene);
    }

    static std::string replaced(std::string text, const std::string& what, const std::string& by) {
        const std::size_t at = text.find(what);
        if (at == std::string::npos) qFatal("the file has no %s", what.c_str());
        return text.replace(at, what.size(), by);
    }

private slots:
    void aTrueBundlePasses() {
        Scene scene = plate();
        for (const bool own : {false, true}) {
            if (own) scene.finger = stroke(0);
            const auto verdict = verdictOn(*bundleOf(scene));
            VERIFY_RESULT(verdict);
            QVERIFY2(verdict->differences.empty(),
                     verdict->differences.empty() ? "" : verdict->differences[0].c_str());
            QVERIFY(verdict->touches);
            QCOMPARE_GT(verdict->largestForce, 1.0);
            QCOMPARE_EQ(verdict->largestDifference, 0.0);
        }
    }

    void oneChangedNumberIsFound() {
        Scene scene = plate();
        scene.finger = stroke(0);
        const std::string bytes = *bundleOf(scene);
        const auto upward = [](std::string& text) { // the force of the last row, that is pressed
            text.insert(text.rfind(',', text.rfind(',') - 1) + 1, "9");
        };
        const auto finger = [](std::string& text) { text = replaced(text, ",2e-04,", ",3e-04,"); };
        const auto in = [&](const char* name, const auto& change) {
            const auto verdict = verdictOn(bytes, name, change);
            return verdict ? (verdict->differences.empty() ? "true" : verdict->differences[0])
                           : verdict.error().text;
        };
        COMPARE_CONTAINS(in(bundle_name::kForces, upward), "forces.csv: the force differs in 1 row");
        QCOMPARE_GT(verdictOn(bytes, bundle_name::kForces, upward)->largestDifference, 1.0); // N
        COMPARE_CONTAINS(in(bundle_name::kFinger, finger), "forces.csv: the finger differs in 1 row");
        COMPARE_CONTAINS(in(bundle_name::kX3d,
                            [](std::string& text) {
                                text = replaced(text, "staticFriction=\"0.5\"", "staticFriction=\"0.6\"");
                            }),
                         "scene.x3d: is not what the scene gives");
        COMPARE_CONTAINS(
            in(bundle_name::kDevice,
               [](std::string& text) { text = replaced(text, "forceLimit=\"3\"", "forceLimit=\"9\""); }),
            "deviceinfo.x3d: is not what the scene gives");
        COMPARE_CONTAINS(in(bundle_name::kScene,
                            [](std::string& text) { // and of the physics material, which is its mirror
                                const std::string before = "\"dynamicFriction\":0.3",
                                                  after = "\"dynamicFriction\":0.2";
                                text = replaced(replaced(text, before, after), before, after);
                            }),
                         "forces.csv: the proxy differs in");
    }

    void allRowsAreCountedAndTheFirstIsTold() {
        Scene scene = plate();
        scene.finger = stroke(0);
        const auto larger = [](std::string& text, int line) { // its force across
            std::size_t begin = 0;
            for (int i = 1; i < line; ++i)
                begin = text.find('\n', begin) + 1;
            const std::size_t end = text.find('\n', begin);
            text.insert(text.rfind(',', text.rfind(',', end) - 1) + 1, "9");
        };
        const auto verdict = verdictOn(*bundleOf(scene), bundle_name::kForces, [&](std::string& text) {
            for (const int line : {150, 202, 120})
                larger(text, line);
        });
        VERIFY_RESULT(verdict);
        COMPARE_CONTAINS(verdict->differences.at(0), "the force differs in 3 rows, by up to ");
        COMPARE_CONTAINS(verdict->differences.at(0), "; line 120 (t = ");
    }

    void aRowTooFewIsFound() {
        Scene scene = plate();
        scene.finger = stroke(0);
        const auto verdict = verdictOn(*bundleOf(scene), bundle_name::kForces, [](std::string& text) {
            text.erase(text.rfind('\n', text.size() - 2) + 1);
        });
        VERIFY_RESULT(verdict);
        COMPARE_CONTAINS(verdict->differences.at(0), "has 200 rows, finger.csv 201");
    }

    /// Bundles of version 1.0 have the forces alone.
    void anOlderTableIsReadAsWell() {
        Scene scene = plate();
        scene.finger = stroke(0);
        const auto old = [](std::string& text) {
            std::string made = "t,x,y,z\n";
            for (std::size_t at = text.find('\n') + 1; at < text.size(); at = text.find('\n', at) + 1) {
                const std::string row = text.substr(at, text.find('\n', at) - at);
                std::size_t column = 0;
                for (int i = 0; i < 7; ++i)
                    column = row.find(',', column) + 1;
                made += row.substr(0, row.find(',')) + "," + row.substr(column) + "\n";
            }
            text = made;
        };
        const auto verdict = verdictOn(*bundleOf(scene), bundle_name::kForces, old);
        VERIFY_RESULT(verdict);
        QVERIFY2(verdict->differences.empty(),
                 verdict->differences.empty() ? "" : verdict->differences[0].c_str());
        QCOMPARE_GT(verdict->largestForce, 1.0);
    }

    void whoTouchesNothingIsTold() {
        Scene scene = plate();
        scene.finger = stroke(0.5);
        const auto made = makeBundle(scene);
        VERIFY_RESULT(made);
        QVERIFY(!made->touches);
        const auto files = BundleFiles::open(made->bytes);
        VERIFY_RESULT(files);
        COMPARE_CONTAINS(files->file(bundle_name::kReadme), "touches nothing");
        scene.finger = stroke(0);
        COMPARE_LACKS(BundleFiles::open(*bundleOf(scene))->file(bundle_name::kReadme), "touches nothing");
        QVERIFY(makeBundle(scene)->touches);
    }

    /// Scaling a scene scales what shows it: the same stroke over the same plate, twice as large.
    void theFingerIsScaledWithItsScene() {
        Scene scene = plate();
        scene.finger = stroke(0);
        Scene fitted = scene;
        fitDiagonal(fitted, 2 * boundsOf(scene).diagonal());
        QCOMPARE(fitted.finger->size(), scene.finger->size());
        for (std::size_t i = 0; i < scene.finger->size(); ++i)
            COMPARE_NEAR((*fitted.finger)[i].position, 2 * (*scene.finger)[i].position, 1e-15, "m");
    }
};

TACTUM_TEST(TestVerifyBundle)

} // namespace test_verify_bundle

#include "test_verify_bundle.moc"
