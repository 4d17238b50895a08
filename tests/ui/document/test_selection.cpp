// What is chosen joins what is selected: sets of triangles and of surfaces, by tables. Wrong itself if a row
// named what it expects by the function that it is about.
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/document/selection.h"

namespace test_selection {

using namespace tactum;

class TestSelection : public QObject {
    Q_OBJECT
private slots:
    void trianglesJoin() {
        using enum SelectMode;
        const FaceSelection now{1, {1, 3, 5}}, same{1, {3, 4}}, other{2, {7}}, none{};
        const auto faces = [](const FaceSelection& of) { return std::pair(of.object, of.faces); };
        const auto is = [](ObjectId object, std::vector<Index> list) {
            return std::pair(object, std::move(list));
        };
        QCOMPARE(faces(joined(now, same, Replace)), is(1, {3, 4}));
        QCOMPARE(faces(joined(now, same, Add)), is(1, {1, 3, 4, 5}));
        QCOMPARE(faces(joined(now, same, Subtract)), is(1, {1, 5}));
        QCOMPARE(faces(joined(now, now, Subtract)), is(1, {}));
        QCOMPARE(faces(joined(now, other, Replace)), is(2, {7}));
        QCOMPARE(faces(joined(now, other, Add)), is(2, {7}));
        QCOMPARE(faces(joined(now, other, Subtract)), is(1, {1, 3, 5}));
        QCOMPARE(faces(joined(none, same, Add)), is(1, {3, 4}));
        QCOMPARE(faces(joined(none, same, Subtract)), is(0, {}));
    }

    void surfacesJoin() {
        using enum SelectMode;
        const SurfaceRef a{1, 0}, b{1, 1}, c{2, 0};
        QCOMPARE(joined(SurfaceRefs{a, b}, SurfaceRefs{c}, Replace), SurfaceRefs{c});
        QCOMPARE(joined(SurfaceRefs{a, b}, SurfaceRefs{c}, Add), (SurfaceRefs{a, b, c}));
        QCOMPARE(joined(SurfaceRefs{a, b, c}, SurfaceRefs{a}, Add), (SurfaceRefs{b, c, a})); // the active one
        QCOMPARE(joined(SurfaceRefs{a, b, c}, SurfaceRefs{b}, Subtract), (SurfaceRefs{a, c}));
        QCOMPARE(joined(SurfaceRefs{a}, SurfaceRefs{b}, Subtract), SurfaceRefs{a});
        QCOMPARE(joined(SurfaceRefs{a}, SurfaceRefs{}, Add), SurfaceRefs{a});
        QCOMPARE(joined(SurfaceRefs{a}, SurfaceRefs{}, Replace), SurfaceRefs{});
    }

    void aSetKnowsWhatIsInIt() {
        SurfaceSet set({{1, 2}, {3, 4}});
        QVERIFY(set.has({1, 2}) && set.has({3, 4}));
        QVERIFY(!set.has({1, 4}) && !set.has({2, 1}) && !set.has({0, 0}));
        for (const int bits : {1, 8, 16, 31}) // of the object beside those of the surface
            QVERIFY(!set.has({0, (1u << bits) + 2}));
        QVERIFY(!set.add({1, 2}));
        QVERIFY(set.add({2, 1}));
        QVERIFY(set.has({2, 1}));
        QVERIFY(set.add({0xFFFFFFFF, 0xFFFFFFFF}) &&
                set.has({0xFFFFFFFF, 0xFFFFFFFF})); // all of the key's bits
        QVERIFY(!set.has({0xFFFFFFFF, 0}) && !set.has({0, 0xFFFFFFFF}));
    }

    void referencesAreMadeOfWhatThereIs() {
        QCOMPARE(SurfaceRefs(std::nullopt).size(), 0u);
        QCOMPARE(SurfaceRefs(std::optional<SurfaceRef>()).size(), 0u);
        QCOMPARE(SurfaceRefs(std::optional(SurfaceRef{1, 2})), (SurfaceRefs{{1, 2}}));
        QCOMPARE(SurfaceRefs(std::vector<SurfaceRef>{{1, 2}, {3, 4}}), (SurfaceRefs{{1, 2}, {3, 4}}));
    }
};

TACTUM_TEST(TestSelection)

} // namespace test_selection

#include "test_selection.moc"
