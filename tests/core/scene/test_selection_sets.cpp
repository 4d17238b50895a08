// Selection sets: kept, joined, renamed, removed, and what becomes of them when objects and meshes change.
#include <QTest>

#include "core/scene/carry_feel.h"
#include "core/scene/compose.h"
#include "core/scene/selection_sets.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_selection_sets {

using namespace tactum;
using namespace tactum::test;

namespace {

using Names = std::vector<std::string>;

/// Two boxes of twelve triangles.
struct Pair {
    Scene scene;
    ObjectId left = add(scene, "left", box({1, 1, 1}));
    ObjectId right = add(scene, "right", box({1, 2, 3}));
};

} // namespace

class TestSelectionSets : public QObject {
    Q_OBJECT

private slots:
    void aSetIsKeptAcrossObjects() {
        Pair pair;
        const SceneTriangles rim{{pair.left, {0, 1, 4}}, {pair.right, {11}}};
        putSet(pair.scene, "rim", rim);
        putSet(pair.scene, "a foot", {{pair.right, {2}}});
        QCOMPARE(setNames(pair.scene), (Names{"a foot", "rim"}));
        QCOMPARE(trianglesOfSet(pair.scene, "rim"), rim);
        QCOMPARE(trianglesOfSet(pair.scene, "nothing"), SceneTriangles());
        for (const SceneObject& object : pair.scene.objects)
            QVERIFY2(areSetsOf(object.sets, 12), object.name.c_str());
        putSet(pair.scene, "rim", {{pair.left, {3}}});
        QCOMPARE(trianglesOfSet(pair.scene, "rim"), (SceneTriangles{{pair.left, {3}}}));
    }

    void moreJoinsAndRemovedIsGone() {
        Pair pair;
        const Scene before = pair.scene;
        putSet(pair.scene, "rim", {{pair.left, {0, 4}}});
        addToSet(pair.scene, "rim", {{pair.left, {1, 4}}, {pair.right, {7}}});
        QCOMPARE(trianglesOfSet(pair.scene, "rim"),
                 (SceneTriangles{{pair.left, {0, 1, 4}}, {pair.right, {7}}}));
        removeSet(pair.scene, "rim");
        QVERIFY2(pair.scene == before, "as it was");
    }

    void aNewNameIsTheSameSet() {
        Pair pair;
        putSet(pair.scene, "rim", {{pair.left, {0}}});
        renameSet(pair.scene, "rim", "edge");
        renameSet(pair.scene, "edge", "edge");
        QCOMPARE(setNames(pair.scene), Names{"edge"});
        putSet(pair.scene, "foot", {{pair.left, {5}}});
        renameSet(pair.scene, "foot", "edge");
        QCOMPARE(trianglesOfSet(pair.scene, "edge"), (SceneTriangles{{pair.left, {0, 5}}}));
    }

    void copiesAreInTheSetAndWhatGoesIsNot() {
        Pair pair;
        putSet(pair.scene, "rim", {{pair.left, {0}}, {pair.right, {1}}});
        const Scene from = pair.scene;
        const auto copies = addCopies(pair.scene, from, goingAlong(from, std::array{pair.left}));
        QCOMPARE(copies.size(), 1u);
        QCOMPARE(trianglesOfSet(pair.scene, "rim").at(copies[0]), TriangleSet{0});
        removeObjects(pair.scene, std::array{pair.left, pair.right});
        QCOMPARE(trianglesOfSet(pair.scene, "rim"), (SceneTriangles{{copies[0], {0}}}));
    }

    void aStateThatIsShownAgainHasTheSetsOfNow() {
        Pair pair;
        putSet(pair.scene, "old", {{pair.left, {0}}});
        Scene state = pair.scene;
        putSet(pair.scene, "old", {});
        putSet(pair.scene, "rim", {{pair.left, {1}}, {pair.right, {2}}});
        state.objects[1].geometry = std::make_shared<const TriangleSoup>(box({9, 9, 9}));
        keepSets(pair.scene, state);
        QCOMPARE(trianglesOfSet(state, "rim"), (SceneTriangles{{pair.left, {1}}})); // right is another mesh
        QCOMPARE(setNames(state), Names{"rim"});
    }

    void whatIsNoListOfSetsIsRefused() {
        const NamedTriangles good{"a", {{0, 3}}};
        QVERIFY2(areSetsOf({good, {"b", {{2, 12}}}}, 12), "two sets");
        for (const std::vector<NamedTriangles>& wrong : {std::vector<NamedTriangles>{{"", {{0, 1}}}},
                                                         {{"a", {}}},
                                                         {{"a", {{0, 13}}}},
                                                         {{"a", {{2, 1}}}},
                                                         {good, good},
                                                         {{"b", {{0, 1}}}, good},
                                                         std::vector<NamedTriangles>(kMaxSets + 1, good)})
            QVERIFY2(!areSetsOf(wrong, 12), wrong.front().name.c_str());
    }

    /// Every second triangle is one range each; so many of them that a file would fill the memory.
    void thereIsABoundForAllTogether() {
        std::vector<NamedTriangles> sets;
        TriangleRanges scattered;
        constexpr Index kCount = 100'000;
        for (Index i = 0; i < kCount; i += 2)
            scattered.push_back({i, i + 1});
        for (int i = 0; i < 20; ++i)
            sets.push_back({std::string(std::size_t(i) + 1, 'a'), scattered});
        QVERIFY2(!areSetsOf(sets, kCount), "twenty of them");
        sets.resize(16);
        QVERIFY2(areSetsOf(sets, kCount), "sixteen of them");
    }

    void anUpdateKeepsThemWhereTheTrianglesAreTheSame() {
        Pair from, onto;
        putSet(from.scene, "rim", {{from.left, {0, 1}}, {from.right, {2}}});
        onto.scene.find(onto.right)->geometry =
            std::make_shared<const TriangleSoup>(both(box({1, 2, 3}), box({1, 1, 1}, {5, 0, 0})));
        const CarriedFeel carried = carryFeel(from.scene, onto.scene);
        QCOMPARE(trianglesOfSet(onto.scene, "rim"), (SceneTriangles{{onto.left, {0, 1}}}));
        const auto said = std::ranges::find(carried.findings, "right", &Finding::object);
        QVERIFY2(said != carried.findings.end(), "what is lost is said");
        QCOMPARE(said->sentence, "selection sets left out, for the triangles are others: rim");
    }
};

TACTUM_TEST(TestSelectionSets)

} // namespace test_selection_sets

#include "test_selection_sets.moc"
