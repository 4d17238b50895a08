// Groups of objects: made, named, taken apart, copied, and where their objects stand in the scene.
#include <QTest>

#include "core/scene/bodies.h"
#include "core/scene/compose.h"
#include "core/scene/groups.h"
#include "core/scene/order.h"
#include "core/scene/scene_bytes.h"
#include "tests/core/scene/things.h"
#include "tests/support/test_program.h"

namespace test_groups {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Objects of one letter; those of a group in brackets: "a[bc]d".
std::string shown(const Scene& scene) {
    std::string text, group;
    for (const SceneObject& object : scene.objects) {
        if (object.group != group && !group.empty()) text += ']';
        if (object.group != group && !object.group.empty()) text += '[';
        group = object.group;
        text += object.name;
    }
    return group.empty() ? text : text + ']';
}

struct Row {
    Scene scene;
    explicit Row(const char* objects = "abcdef") {
        int groups = 0;
        std::string group;
        for (const char* c = objects; *c; ++c)
            if (*c == '[')
                group = "Group " + std::to_string(++groups);
            else if (*c == ']')
                group.clear();
            else
                add(scene, std::string(1, *c).c_str(), box({1, 1, 1}), {}),
                    scene.objects.back().group = group;
    }
    std::vector<ObjectId> ids(const std::string& names) const {
        std::vector<ObjectId> all;
        for (const SceneObject& object : scene.objects)
            if (names.find(object.name) != std::string::npos) all.push_back(object.id);
        return all;
    }
};

} // namespace

class TestGroups : public QObject {
    Q_OBJECT

private slots:
    void objectsOfANewGroupStandWhereTheFirstOfThemStood() {
        Row row;
        QCOMPARE(groupTogether(row.scene, row.ids("bdf")), "Group 1");
        QCOMPARE(shown(row.scene), "a[bdf]ce");
        QCOMPARE(groupTogether(row.scene, row.ids("ce")), "Group 2");
        QCOMPARE(shown(row.scene), "a[bdf][ce]");
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"Group 1", "Group 2"}));
        QCOMPARE(groupTogether(row.scene, row.ids("x")), "");
    }

    void whoIsGroupedAnewLeavesItsGroupAndAnEmptyOneGoes() {
        Row row("[abc]d");
        groupTogether(row.scene, row.ids("cd"));
        QCOMPARE(shown(row.scene), "[ab][cd]");
        groupTogether(row.scene, row.ids("ab"));
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"Group 3", "Group 2"}));
    }

    void takenApartAllStayWhereTheyAre() {
        Row row("a[bc]d[ef]");
        ungroup(row.scene, row.ids("c"));
        QCOMPARE(shown(row.scene), "abcd[ef]");
    }

    void theWholeOfAGroupIsFoundFromOneOfIt() {
        const Row row("a[bc]d[ef]");
        QCOMPARE(withTheirGroups(row.scene, row.ids("ac")), row.ids("abc"));
        QCOMPARE(wholeGroups(row.scene, row.ids("abce")), std::set<std::string>{"Group 1"});
    }

    void twoGroupsNeverHaveOneName() {
        Row row("[ab][cd]");
        renameGroup(row.scene, "Group 1", "Lid");
        renameGroup(row.scene, "Group 2", "lid");
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"Lid", "lid 2"}));
        renameGroup(row.scene, "Lid", "LID"); // its own name is free for it
        renameGroup(row.scene, "lid 2", "");
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"LID", "lid 2"}));
    }

    void objectsOfOneBodyAreInAGroupTogether() {
        Row row("abcd");
        row.scene.objects[1].body = row.scene.objects[3].body = 7;
        putInGroup(row.scene, row.ids("d"), "G");
        gatherGroups(row.scene);
        QCOMPARE(shown(row.scene), "a[bd]c");
        row.scene.objects[0].body = 7; // which is in none
        gatherGroups(row.scene);
        QCOMPARE(shown(row.scene), "abdc");
    }

    void aCopyOfAWholeGroupIsAnotherOneAndThatOfAPartJoinsIt() {
        Row row("a[bc]");
        const Scene before = row.scene;
        addCopies(row.scene, before, goingAlong(before, row.ids("bc")));
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"Group 1", "Group 2"}));
        QCOMPARE(objectsOfGroup(row.scene, "Group 2").size(), 2u);
        addCopies(row.scene, before, goingAlong(before, row.ids("b")));
        gatherGroups(row.scene);
        QCOMPARE(objectsOfGroup(row.scene, "Group 1").size(), 3u);
    }

    void aSceneThatComesBringsItsGroupsUnderFreeNames() {
        Row row("[ab]c"), other("x[yz]");
        addScene(row.scene, other.scene);
        QCOMPARE(shown(row.scene), "[ab]cx[yz]");
        QCOMPARE(groupNames(row.scene), (std::vector<std::string>{"Group 1", "Group 2"}));
    }

    void oneUpAndOneDownPassWholeGroups_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("moved");
        QTest::addColumn<bool>("up");
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("over a group")
            << QByteArray("[ab]c") << QByteArray("c") << true << QByteArray("c[ab]");
        QTest::newRow("under a group")
            << QByteArray("a[bc]d") << QByteArray("a") << false << QByteArray("[bc]ad");
        QTest::newRow("inside") << QByteArray("a[bcd]") << QByteArray("d") << true << QByteArray("a[bdc]");
        QTest::newRow("at its top") << QByteArray("a[bc]") << QByteArray("b") << true << QByteArray("a[bc]");
        QTest::newRow("at its foot") << QByteArray("[ab]c") << QByteArray("b") << false
                                     << QByteArray("[ab]c");
        QTest::newRow("a whole one") << QByteArray("a[bc]d") << QByteArray("bc") << true
                                     << QByteArray("[bc]ad");
        QTest::newRow("two") << QByteArray("[ab][cd]") << QByteArray("cd") << true << QByteArray("[cd][ab]");
        QTest::newRow("two down") << QByteArray("[ab][cd]") << QByteArray("ab") << false
                                  << QByteArray("[cd][ab]");
    }
    void oneUpAndOneDownPassWholeGroups() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, moved);
        QFETCH(bool, up);
        QFETCH(QByteArray, after);
        Row row(before.constData());
        (up ? moveUp : moveDown)(row.scene, row.ids(moved.toStdString()));
        gatherGroups(row.scene);
        QCOMPARE(shown(row.scene), after.toStdString());
    }

    void theBytesOfASceneKeepThem() {
        const Row row("a[bc]d[ef]");
        const std::string bytes = bytesOf(row.scene);
        ByteIn in(bytes, "the scene", 0, "send it again");
        QCOMPARE(shown(readScene(in)), "a[bc]d[ef]");
    }
};

TACTUM_TEST(TestGroups)

} // namespace test_groups

#include "test_groups.moc"
