// A World that is made from the one before it, after any edit, is the one that is made anew: the same finger
// feels the same bits.
//
// The judge is compile() itself, which knows of no World before. It would be wrong where both made the same
// mistake: what a World must be is asked elsewhere; here only whether something of an older one was kept that
// should not.

#include <QTest>

#include "core/haptics/replay.h"
#include "tests/core/surface/texture_rig.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/movers.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/support/two_hands.h"

namespace test_random_edits {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kHalf = 0.02; // m: of where bodies and finger are

/// A scene that is edited at random.
class Author {
public:
    explicit Author(std::uint64_t seed) : random_(seed) {
        scene.proxyRadius = 1e-3;
        add();
        add();
    }

    /// One edit; its name.
    const char* edit() {
        static const std::array<std::pair<const char*, void (Author::*)()>, 12> kEdits{
            {{"friction", &Author::rub},
             {"stiffness", &Author::stiffen},
             {"shading", &Author::shade},
             {"crease angle", &Author::crease},
             {"another layer", &Author::layer},
             {"a layer less", &Author::unlayer},
             {"moved", &Author::move},
             {"another mesh", &Author::replace},
             {"an object", &Author::add},
             {"an object less", &Author::remove},
             {"sides", &Author::turn},
             {"radius or motion", &Author::other}}};
        const auto& [name, change] = kEdits[below(kEdits.size())];
        (this->*change)();
        return name;
    }

    /// Three strokes through the middle of the scene.
    FingerPath stroke() {
        FingerPath path;
        Vec3 from(uniform(random_, -kHalf, kHalf), uniform(random_, -kHalf, kHalf), 0.03);
        for (int leg = 0; leg < 3; ++leg) {
            constexpr int kRows = 80;
            const Vec3 to(uniform(random_, -kHalf, kHalf), uniform(random_, -kHalf, kHalf),
                          uniform(random_, -0.01, 0.005));
            for (int i = 0; i < kRows; ++i)
                path.push_back({double(path.size()) * kMillisecond, from + (to - from) * i / kRows});
            from = to;
        }
        return path;
    }

    Scene scene;

private:
    std::size_t below(std::size_t count) { return random_() % count; }
    SceneObject& object() { return scene.objects[below(scene.objects.size())]; }
    Surface& surface() {
        SceneObject& chosen = object();
        return chosen.surfaces[below(chosen.surfaces.size())];
    }

    /// One of four; the last has two surfaces.
    Soup mesh() {
        const std::size_t kind = below(4);
        if (kind == 0) return eggCrate(0.03, 14, 2e-3, 0.02);
        if (kind == 1) return ball(0.015, 2);
        if (kind == 2) return cube(0.01);
        auto two = std::make_shared<TriangleSoup>(*eggCrate(0.03, 9, 1e-3, 0.03));
        for (std::size_t i = 0; i < two->triangles.size(); ++i)
            two->surfaceOf[i] = Index(i % 2);
        return two;
    }

    void rub() { surface().material = rough(uniform(random_, 0.3, 1), uniform(random_, 0, 0.3), 0.5); }
    void stiffen() { surface().material.stiffness = uniform(random_, 100, 2000); }
    void shade() {
        bool& on = surface().shading.on;
        on = !on;
    }
    void crease() { surface().shading.creaseAngle = uniform(random_, 0.2, 2); }
    void layer() {
        const bool grooves = below(2) == 0;
        surface().layers.push_back(heightLayer(grooves ? TextureSource::Grooves : TextureSource::Noise,
                                               grooves ? TextureMapping::Planar : TextureMapping::Triplanar,
                                               5e-3, 2e-4));
    }
    void unlayer() {
        if (auto& layers = surface().layers; !layers.empty()) layers.pop_back();
    }
    void move() { object().pose.translation.x() += uniform(random_, -2e-3, 2e-3); }
    void replace() {
        SceneObject& changed = object();
        changed.geometry = mesh();
        changed.surfaces.resize(surfacesOf(*changed.geometry));
    }
    void add() {
        SceneObject added;
        added.name = "object";
        added.geometry = mesh();
        added.surfaces.resize(surfacesOf(*added.geometry));
        added.pose.translation = {uniform(random_, -kHalf, kHalf), uniform(random_, -kHalf, kHalf), 0};
        scene.add(std::move(added));
    }
    void remove() {
        if (scene.objects.size() > 1) scene.objects.erase(scene.objects.begin());
    }
    void turn() { surface().sides = Sides(below(4)); }
    void other() {
        SceneObject& changed = object();
        if (below(2) == 0)
            scene.proxyRadius = uniform(random_, 5e-4, 3e-3);
        else
            changed.motion = changed.motion ? nullptr : swinging({3e-3, 0, 0}, 1);
    }

    static std::size_t surfacesOf(const TriangleSoup& soup) {
        return 1 + *std::ranges::max_element(soup.surfaceOf);
    }

    Rng random_;
};

} // namespace

class RandomEditsTest : public QObject {
    Q_OBJECT

private slots:
    void aWorldFromTheOneBeforeIsOneMadeAnew();
};

void RandomEditsTest::aWorldFromTheOneBeforeIsOneMadeAnew() {
    int touching = 0;
    for (int trial = 0; trial < longOnly(60); ++trial) {
        Author author{std::uint64_t(trial)};
        std::shared_ptr<const World> world = compile(author.scene).value();
        std::string edits;
        for (int i = 0; i < 25; ++i) {
            edits += std::string(", ") + author.edit();
            const auto next = compile(author.scene, world.get()), anew = compile(author.scene);
            VERIFY_RESULT(next);
            VERIFY_RESULT(anew);
            world = *next;
            const FingerPath path = author.stroke();
            const TouchTrace felt = replay(*world, path), right = replay(**anew, path);
            for (std::size_t row = 0; row < felt.size(); ++row) {
                const std::string where =
                    "trial " + std::to_string(trial) + ", row " + std::to_string(row) + edits;
                QVERIFY2(felt[row].force == right[row].force, where.c_str());
                QVERIFY2(felt[row].proxy == right[row].proxy, where.c_str());
                touching += felt[row].contacts > 0;
            }
        }
    }
    qInfo("%d rows touch", touching);
    QCOMPARE_GT(touching, 2000);
}

TACTUM_TEST(RandomEditsTest)

} // namespace test_random_edits

#include "test_random_edits.moc"
