// A bundle: the same bytes for the same scene, the forces that it promises, and no changed file unnoticed.
#include <filesystem>
#include <fstream>
#include <set>

#include <QTemporaryDir>
#include <QTest>

#include "core/archive/bundle_files.h"
#include "core/base/atomic_file.h"
#include "core/bundle/bundle.h"
#include "core/bundle/preview.h"
#include "core/bundle/sample_stroke.h"
#include "core/files/images/read_image.h"
#include "core/files/images/write_png.h"
#include "core/files/load_scene.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "tests/support/compare.h"
#include "tests/support/random_scene.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_bundle {

using namespace tactum;
using namespace tactum::test;

namespace {

/// A plate of 0.2 m at the height 0.
Scene plate() {
    Scene scene;
    SceneObject object;
    object.name = "plate";
    object.geometry =
        SoupBuilder()
            .quad({-0.1, 0, -0.1}, {-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1})
            .quad({-0.1, -0.02, -0.1}, {0.1, -0.02, -0.1}, {0.1, -0.02, 0.1}, {-0.1, -0.02, 0.1})
            .build();
    object.surfaces.resize(1);
    object.surfaces[0].name = "top";
    object.surfaces[0].material.stiffness = 500;
    scene.add(object);
    return scene;
}

/// A plate with one picture of `side` texels, which are all in a bundle.
Scene engraved(int side) {
    Scene scene = plate();
    auto soup = std::make_shared<TriangleSoup>(*scene.objects[0].geometry);
    for (const auto& t : soup->triangles)
        for (const Index corner : t)
            soup->cornerUvs.emplace_back(5 * soup->positions[corner].x() + 0.5,
                                         5 * soup->positions[corner].z() + 0.5);
    scene.objects[0].geometry = std::move(soup);
    TextureLayer layer;
    layer.pattern.source = TextureSource::Image;
    layer.pattern.mapping = TextureMapping::UvUnit;
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < side * side; ++i)
        texels.push_back(std::uint16_t(i * 2654435761U >> 16));
    layer.pattern.image = std::make_shared<const TextureImage>(side, side, std::move(texels), "engraving");
    layer.strength = 1e-4;
    scene.objects[0].surfaces[0].layers = {layer};
    return scene;
}

std::string bytesOf(const Scene& scene) {
    const auto bytes = bundleOf(scene);
    return bytes ? *bytes : throw std::runtime_error(bytes.error().text);
}

std::string bytesIn(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

class TestBundle : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path write(const std::string& bytes) {
        const std::filesystem::path file = folder_.filePath(QStringLiteral("a.zip")).toStdString();
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }

private slots:
    void theSameSceneGivesTheSameBytes() {
        for (unsigned seed = 0; seed < 5; ++seed) {
            Scene scene = SceneDice(seed).scene();
            QCOMPARE_EQ(bytesOf(scene), bytesOf(SceneDice(seed).scene()));
            const auto loaded = loadScene(write(bytesOf(scene)));
            VERIFY_RESULT(loaded);
            QCOMPARE(difference(scene, loaded->scene), std::string());
            QCOMPARE_EQ(bytesOf(loaded->scene), bytesOf(scene));
        }
    }

    void theForcesAreThoseThatAreFelt() {
        const auto bundle = openBundle(write(bytesOf(plate())));
        VERIFY_RESULT(bundle);
        const auto world = compile(bundle->scene);
        const TouchTrace rows = replay(**world, bundle->finger);
        QCOMPARE(rows.size(), bundle->forces.size());
        double most = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QCOMPARE_EQ(rows[i].force, bundle->forces[i]);
            most = std::max(most, rows[i].force.norm());
        }
        // One hundredth of the diagonal deeper than where the proxy first touched, and up to a tick further.
        const double depth = 0.01 * boundsOf(plate()).diagonal();
        QVERIFY2(most >= 500 * depth && most < 500 * (depth + 1e-3), qPrintable(QString::number(most)));
    }

    /// Most of the time goes into flattened pictures. A cancel there ends them at once, with nothing written.
    void flatteningGoesOnAndStops() {
        const Scene scene = engraved(1024);
        std::vector<double> parts;
        std::atomic<bool> cancelled{false};
        Progress progress{[&](double part) { parts.push_back(part); }, &cancelled};
        VERIFY_RESULT(bundleOf(scene, progress));
        QVERIFY(std::ranges::is_sorted(parts));
        const auto inside = [](double part) { return part > 0.31 && part < 0.4; };
        QVERIFY2(std::ranges::count_if(parts, inside) > 20, "no news from the picture of the height");
        parts.clear();
        progress.report = [&](double part) {
            parts.push_back(part);
            if (inside(part)) cancelled = true;
        };
        const std::filesystem::path file = folder_.filePath(QStringLiteral("stopped.zip")).toStdString();
        const auto stopped = saveBundle(scene, file, progress);
        QVERIFY(!stopped);
        QCOMPARE(stopped.error().text, std::string("cancelled"));
        QVERIFY2(inside(parts.back()), qPrintable(QString::number(parts.back())));
        QVERIFY(!std::filesystem::exists(file));
        // Writing a picture takes as long as making it.
        QVERIFY(encodePng(*scene.objects[0].surfaces[0].layers[0].pattern.image, progress).empty());
    }

    void everyFileIsHeldAgainstTheManifest() {
        const auto files = BundleFiles::open(bytesOf(plate()));
        VERIFY_RESULT(files);
        for (const char* name :
             {bundle_name::kScene, bundle_name::kX3d, bundle_name::kDevice, bundle_name::kFinger,
              bundle_name::kForces, bundle_name::kPreview, bundle_name::kReport, bundle_name::kReadme})
            QVERIFY2(!files->file(name).empty(), name);
        const auto zip = readZip(bytesOf(plate()));
        for (std::size_t i = 1; i < zip->size(); ++i) {
            std::vector<ZipEntry> changed = *zip;
            changed[i].bytes[changed[i].bytes.size() / 2] ^= 1;
            COMPARE_CONTAINS(BundleFiles::open(writeZip(changed)).error().text, changed[i].name);
            changed = *zip;
            changed.erase(changed.begin() + int(i));
            QVERIFY(!BundleFiles::open(writeZip(changed)));
        }
        std::vector<ZipEntry> more = *zip;
        more.push_back({"more.txt", "x"});
        QVERIFY(!BundleFiles::open(writeZip(more)));
        QVERIFY(!BundleFiles::open(writeZip(std::vector<ZipEntry>(zip->begin() + 1, zip->end()))));
    }

    /// The limit for H3D is a device's, not the scene's: the report tells what the path needs.
    void theReportComparesTheForceLimit() {
        for (const auto& [stiffness, word] :
             {std::pair{500.0, "| kept | force limit |"}, {2000.0, "| degraded | force limit |"}}) {
            Scene scene = plate();
            scene.objects[0].surfaces[0].material.stiffness = stiffness;
            const auto files = BundleFiles::open(bytesOf(scene));
            const std::string report(files->file(bundle_name::kReport));
            const auto at = report.find(word);
            QVERIFY2(at != std::string::npos, report.c_str());
            double most = 0;
            const auto bundle = openBundle(write(bytesOf(scene)));
            for (const Vec3& force : bundle->forces)
                most = std::max(most, force.norm());
            const std::string line = report.substr(at, report.find('\n', at) - at);
            const std::string number = QString::number(std::round(100 * most) / 100).toStdString();
            COMPARE_CONTAINS(line, "up to " + number + " N");
            COMPARE_CONTAINS(files->file(bundle_name::kDevice), "forceLimit=\"3\"");
        }
    }

    void aBundleOfALaterTactumIsNotReplaced_data() {
        QTest::addColumn<QString>("version");
        QTest::addColumn<bool>("replaced");
        QTest::newRow("ours") << "\"1.0\"" << true;
        QTest::newRow("a later minor") << "\"1.7\"" << true;
        QTest::newRow("a later major") << "\"2.0\"" << false;
        QTest::newRow("a later major of two digits") << "\"10.1\"" << false;
        QTest::newRow("a number") << "2" << false;
    }
    void aBundleOfALaterTactumIsNotReplaced() {
        QFETCH(QString, version);
        QFETCH(bool, replaced);
        auto zip = readZip(bytesOf(plate()));
        std::string& manifest = zip->front().bytes;
        manifest.replace(manifest.find("\"1.1\""), 5, version.toStdString());
        zip->push_back({"later.bin", "what this version does not know"});
        const std::string before = writeZip(*zip);
        const auto file = write(before);
        const auto saved = saveBundle(plate(), file);
        QCOMPARE(bool(saved), replaced);
        QCOMPARE(bytesIn(file) == before, !replaced);
        if (replaced) return;
        COMPARE_CONTAINS(saved.error().text, "choose another name");
    }

    void aBundleWithASceneOfALaterTactumIsNotReplaced() {
        auto files = readZip(bytesOf(plate()));
        files->erase(files->begin()); // the manifest is made anew
        std::string& glb = (*files)[0].bytes;
        const std::string ours = "\"version\":\"1.0\"";
        COMPARE_CONTAINS(glb, ours);
        glb.replace(glb.find(ours), ours.size(), "\"version\":\"2.0\"");
        const auto file = write(packBundle(*files));
        QVERIFY(!saveBundle(plate(), file));
    }

    void onlyAsManyBackupsAsAskedFor() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("b.zip")).toStdString();
        VERIFY_RESULT(saveBundle(plate(), file, {}, 0));
        VERIFY_RESULT(saveBundle(plate(), file, {}, 0));
        QVERIFY(!std::filesystem::exists(backupOf(file, 1)));
        VERIFY_RESULT(saveBundle(plate(), file));
        QVERIFY(std::filesystem::exists(backupOf(file, 1)));
    }

    void aStrokeTouchesWhatLiesBelowTheMiddle() {
        const auto world = compile(plate());
        int touching = 0;
        for (const TouchRow& row : replay(**world, sampleStroke(**world)))
            touching += row.contacts > 0;
        QCOMPARE_GT(touching, 2000); // the two seconds of the circle, and more
    }

    // Of an octahedron four facets are seen, each of one brightness; with the normals of a ball it is round.
    void thePreviewIsRoundWhereTheModelIs() {
        TriangleSoup soup;
        for (const double side : {1.0, -1.0})
            for (int axis = 0; axis < 3; ++axis)
                soup.positions.push_back(0.05 * side * Vec3::Unit(axis));
        for (Index i = 0; i < 8; ++i) {
            const Index x = i & 1 ? 3 : 0, y = i & 2 ? 4 : 1, z = i & 4 ? 5 : 2;
            const bool odd = (i ^ i >> 1 ^ i >> 2) & 1; // all with their front outside
            soup.triangles.push_back({x, odd ? z : y, odd ? y : z});
            soup.surfaceOf.push_back(0);
        }
        const auto shades = [&](const TriangleSoup& of, bool shaded) {
            Scene scene;
            SceneObject object;
            object.geometry = std::make_shared<TriangleSoup>(of);
            object.surfaces.resize(1);
            object.surfaces[0].shading.on = shaded;
            object.surfaces[0].shading.normals = NormalSource::Computed;
            object.surfaces[0].shading.creaseAngle = 3;
            scene.add(object);
            const auto values = Preview(scene, 64, 48).draw(scene);
            return std::set(values.begin(), values.end()).size();
        };
        QCOMPARE_LE(shades(soup, false), std::size_t(3 * 5));
        QCOMPARE_GT(shades(soup, true), std::size_t(100)); // as it is felt
        for (const auto& triangle : soup.triangles)
            for (const Index corner : triangle)
                soup.cornerNormals.push_back(soup.positions[corner].normalized().cast<float>());
        QCOMPARE_GT(shades(soup, false), std::size_t(100)); // as the file has it
    }

    // A flat plate has one brightness; its relief has more, as steep as it feels. What has no height, and
    // what is finer than a pixel, is not to be seen.
    void thePreviewShowsTheReliefThatIsFelt() {
        const auto picture = [](TextureTarget target, double size) {
            Scene scene = plate();
            TextureLayer layer;
            layer.pattern.source = TextureSource::Grooves;
            layer.pattern.size = size;
            layer.target = target;
            layer.strength = target == TextureTarget::Height ? 0.002 : 0.5;
            for (Surface& surface : scene.objects[0].surfaces)
                surface.layers = {layer};
            return Preview(scene, 96, 72).draw(scene);
        };
        const Scene plain = plate();
        const auto without = Preview(plain, 96, 72).draw(plain);
        const auto ridges = picture(TextureTarget::Height, 0.03);
        const auto shades = [](const auto& values) { return std::set(values.begin(), values.end()).size(); };
        QCOMPARE_GT(shades(ridges), 5 * shades(without));
        QVERIFY(picture(TextureTarget::StaticFriction, 0.03) == without);
        QVERIFY(picture(TextureTarget::Height, 0.0005) == without);
    }

    void thePreviewShowsTheScene() {
        const auto picture = readImage(previewOf(plate(), 64, 48), "preview", "memory");
        VERIFY_RESULT(picture);
        const auto& level = picture->image->level(0);
        QCOMPARE_GT(picture->image->texel(level, 32, 24), 2 * picture->image->texel(level, 1, 1));
        Scene hidden = plate();
        hidden.objects[0].visible = false;
        const auto empty = readImage(previewOf(hidden, 64, 48), "preview", "memory");
        QCOMPARE(empty->image->texel(empty->image->level(0), 32, 24),
                 empty->image->texel(empty->image->level(0), 1, 1));
    }
};

TACTUM_TEST(TestBundle)

} // namespace test_bundle

#include "test_bundle.moc"
