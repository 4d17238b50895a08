// The document: opening, the one way to edit, undo, and files that are not what they should be.
#include <QSignalSpy>
#include <QTest>

#include "core/scene/surface_colours.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/document/scene_figures.h"
#include "ui/document/document.h"

namespace test_document {

using namespace tactum;
using testing::difference;

namespace {

/// Whether an edit that a worker makes has ended since.
bool endedNow(QSignalSpy& spy) {
    return test::waitFor([&, before = spy.size()] { return spy.size() > before; });
}

} // namespace

class TestDocument : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::unique_ptr<Document> document_;

    bool open(const QString& file);
    SurfaceRef front() const { return {document_->scene().objects.front().id, 4}; }
    const Material& frontMaterial() const { return document_->surface(front())->material; }

private slots:
    void init();

    void surfacesComeFromGroups();
    void aDragIsOneStepAndTwoDragsAreTwo();
    void aDragBackToItsBeginningIsNoStep();
    void everyEditCanBeUndone();
    void severalSurfacesAreOneStep();
    void lockedSurfacesStayAsTheyAre();
    void trianglesSplitOffAndMergeBack();
    void mergingLeavesTheOthersAsTheyWere();
    void surfacesHaveColoursOfTheirOwn();
    void splittingLeavesTheOthersAsTheyWere();
    void mergingOfTooFewOrOfLockedOnesIsRefused();
    void whatIsChangedMeanwhileIsNotChangedAgain();
    void whatIsRemovedComesBackSelected();
    void findingsGoAndComeWithTheirObject();
    void editsOfNothingAreIgnored();
    void aModelThatDoesNotFitTheHandIsScaledAndSaysSo();
    void aBrokenFileLeavesTheSceneAndSaysOneLine_data();
    void aBrokenFileLeavesTheSceneAndSaysOneLine();
    void anOpeningCanBeCancelled();
};

void TestDocument::init() {
    document_ = std::make_unique<Document>();
    QVERIFY(open(writeCube(folder_)));
}

bool TestDocument::open(const QString& file) {
    document_->open(file.toStdString());
    return test::waitFor([this] { return !document_->opening(); });
}

void TestDocument::surfacesComeFromGroups() {
    QCOMPARE(document_->scene().objects.size(), std::size_t(1));
    QCOMPARE(document_->scene().objects[0].surfaces.size(), std::size_t(6));
    QCOMPARE(document_->surface(front())->name, std::string("front"));
    QCOMPARE(document_->history().count(), 0);
}

// The cube's file names no colours: its sides get some, which is no edit.
void TestDocument::surfacesHaveColoursOfTheirOwn() {
    for (Index i = 0; i < 6; ++i)
        for (Index j = 0; j < i; ++j)
            QVERIFY(document_->surface({front().object, i})->colour !=
                    document_->surface({front().object, j})->colour);
    QVERIFY(!document_->modified());
    QCOMPARE(document_->history().count(), 0);
}

void TestDocument::aDragIsOneStepAndTwoDragsAreTwo() {
    const MaterialField& friction = kMaterialFields[2];
    for (int drag = 0; drag < 2; ++drag) {
        const Gesture gesture = newGesture();
        for (int i = 1; i <= 5; ++i)
            document_->setMaterialValue(front(), friction, 0.5 * drag + 0.1 * i, gesture);
    }
    QCOMPARE(document_->history().count(), 2);
    QCOMPARE(frontMaterial().staticFriction, 1.0);
    document_->history().undo();
    QCOMPARE(frontMaterial().staticFriction, 0.5);
    document_->history().undo();
    QCOMPARE(frontMaterial().staticFriction, kStaticFriction.initial);
    document_->history().redo();
    QCOMPARE(frontMaterial().staticFriction, 0.5);
}

void TestDocument::aDragBackToItsBeginningIsNoStep() {
    const Gesture gesture = newGesture();
    document_->setMaterialValue(front(), kMaterialFields[0], 900, gesture);
    document_->setMaterialValue(front(), kMaterialFields[0], kStiffness.initial, gesture);
    QCOMPARE(document_->history().count(), 0);
}

void TestDocument::everyEditCanBeUndone() {
    const Scene before = document_->scene();
    const ObjectId cube = before.objects.front().id;
    document_->setMaterialValue(front(), kMaterialFields[4], 3);
    document_->setShading(front(), {true, NormalSource::Computed, 0.5});
    document_->setSides(front(), Sides::Front);
    document_->setProxyRadius(0.002);
    document_->renameObject(cube, QStringLiteral("dice"));
    document_->renameSurface(front(), QStringLiteral("six"));
    document_->setVisible(cube, false);
    document_->showAll();
    document_->removeObject(cube);
    QCOMPARE(document_->history().count(), 9);
    QVERIFY(document_->scene().objects.empty());
    while (document_->history().canUndo())
        document_->history().undo();
    QCOMPARE(difference(document_->scene(), before), "");
    while (document_->history().canRedo())
        document_->history().redo();
    QVERIFY(document_->scene().objects.empty());
    QVERIFY(!document_->selection());
}

void TestDocument::severalSurfacesAreOneStep() {
    const Scene before = document_->scene();
    const ObjectId cube = front().object;
    document_->select({{cube, 0}, {cube, 2}, {cube, 4}});
    QCOMPARE(document_->selection(), std::optional(front()));
    document_->setMaterialValue(document_->selected(), kMaterialFields[0], 500);
    document_->setSurfacesVisible(document_->selected(), false);
    QCOMPARE(document_->history().count(), 2);
    for (Index i = 0; i < 6; ++i) {
        QCOMPARE(document_->surface({cube, i})->material.stiffness, i % 2 ? kStiffness.initial : 500);
        QCOMPARE(document_->surface({cube, i})->visible, i % 2 == 1);
    }
    document_->isolate(document_->selected());
    for (Index i = 0; i < 6; ++i)
        QCOMPARE(document_->surface({cube, i})->visible, i % 2 == 0);
    document_->select(SurfaceRef{cube, 0}, SelectMode::Subtract);
    QCOMPARE(document_->selected().size(), std::size_t(2));
    while (document_->history().canUndo())
        document_->history().undo();
    QCOMPARE(difference(document_->scene(), before), "");
}

void TestDocument::lockedSurfacesStayAsTheyAre() {
    const ObjectId cube = front().object;
    document_->setLocked(front(), true);
    const Scene locked = document_->scene();
    document_->setMaterialValue(front(), kMaterialFields[0], 500);
    document_->selectFaces({cube, {8, 9}}); // those of the front
    document_->splitSelection();
    QSignalSpy ended(document_.get(), &Document::editEnded);
    QTRY_COMPARE(ended.size(), 1);
    QVERIFY(ended[0][0].toString().contains(QStringLiteral("locked")));
    QCOMPARE(difference(document_->scene(), locked), "");
    document_->setLocked(front(), false);
    document_->setMaterialValue({front(), {cube, 0}}, kMaterialFields[0], 500);
    QCOMPARE(frontMaterial().stiffness, 500.0);
}

void TestDocument::trianglesSplitOffAndMergeBack() {
    const Scene before = document_->scene();
    const ObjectId cube = front().object;
    document_->setMaterialValue(front(), kMaterialFields[0], 500);
    QSignalSpy ended(document_.get(), &Document::editEnded);
    document_->selectFaces({cube, {8}});
    document_->selectFaces({cube, {0, 1}}, SelectMode::Add); // all of the first surface, which vanishes
    document_->selectFaces({cube, {1}}, SelectMode::Subtract);
    document_->selectFaces({cube, {1}}, SelectMode::Add);
    QCOMPARE(document_->selectedFaces().faces, (std::vector<Index>{0, 1, 8}));
    document_->splitSelection();
    QTRY_COMPARE(ended.size(), 1);
    const SceneObject& split = document_->scene().objects[0];
    QCOMPARE(split.surfaces.size(), std::size_t(6));
    QCOMPARE(document_->selection(), std::optional(SurfaceRef{cube, 5}));
    QCOMPARE(split.geometry->surfaceOf[8], Index(5));
    QCOMPARE(split.geometry->surfaceOf[9], Index(3)); // the rest of the front
    QVERIFY(document_->selectedFaces().empty());

    document_->select({{cube, 5}, {cube, 3}});
    document_->mergeSelected();
    QTRY_COMPARE(ended.size(), 2);
    const SceneObject& merged = document_->scene().objects[0];
    QCOMPARE(merged.surfaces.size(), std::size_t(5));
    QCOMPARE(merged.geometry->surfaceOf[0], Index(3));
    QCOMPARE(document_->surface(*document_->selection())->name, std::string("front"));
    QCOMPARE(document_->surface(*document_->selection())->material.stiffness, 500.0);
    while (document_->history().canUndo())
        document_->history().undo();
    QCOMPARE(difference(document_->scene(), before), "");
}

// Each of the six sides with a feel of its own; any two become one, in the place of the lower one and with
// the feel of the one that was chosen last. The four others feel as they did, where they did.
void TestDocument::mergingLeavesTheOthersAsTheyWere() {
    const ObjectId cube = front().object;
    for (Index i = 0; i < 6; ++i)
        document_->setMaterialValue(SurfaceRef{cube, i}, kMaterialFields[0], 300 + 100 * i);
    const Scene before = document_->scene();
    const SceneObject& was = before.objects[0];
    QSignalSpy ended(document_.get(), &Document::editEnded);
    for (Index a = 0; a < 6; ++a)
        for (Index b = 0; b < 6; ++b) {
            if (a == b) continue;
            document_->select({{cube, a}, {cube, b}});
            document_->mergeSelected();
            QVERIFY(endedNow(ended));
            const SceneObject& is = document_->scene().objects[0];
            QCOMPARE(is.surfaces.size(), std::size_t(5));
            QCOMPARE(document_->selection(), std::optional(SurfaceRef{cube, std::min(a, b)}));
            for (std::size_t triangle = 0; triangle < was.geometry->triangles.size(); ++triangle) {
                const Index from = was.geometry->surfaceOf[triangle], to = is.geometry->surfaceOf[triangle];
                const Surface& expected = was.surfaces[from == a ? b : from];
                QVERIFY2(
                    is.surfaces[to] == expected,
                    qPrintable(QString("%1 and %2 merged: triangle %3 is of \"%4\" with %5 N/m instead of "
                                       "\"%6\" with %7 N/m")
                                   .arg(a)
                                   .arg(b)
                                   .arg(triangle)
                                   .arg(QString::fromStdString(is.surfaces[to].name))
                                   .arg(is.surfaces[to].material.stiffness)
                                   .arg(QString::fromStdString(expected.name))
                                   .arg(expected.material.stiffness)));
            }
            QCOMPARE(is.geometry->positions, was.geometry->positions);
            QCOMPARE(is.geometry->triangles, was.geometry->triangles);
            document_->history().undo();
            QCOMPARE(difference(document_->scene(), before), "");
        }
}

// Every triangle by itself: the part feels like what it was split off from, under a name and in a colour that
// nobody has. A
// surface that loses its last triangle goes, one that never had any stays.
void TestDocument::splittingLeavesTheOthersAsTheyWere() {
    const ObjectId cube = front().object;
    for (Index i = 0; i < 6; ++i)
        document_->setMaterialValue(SurfaceRef{cube, i}, kMaterialFields[0], 300 + 100 * i);
    SceneObject emptied = document_->scene().objects[0];
    Surface spare;
    spare.name = "front 2";
    emptied.surfaces.push_back(spare);
    document_->setObject(emptied, QStringLiteral("A spare surface"));
    const Scene before = document_->scene();
    const SceneObject& was = before.objects[0];
    QCOMPARE(was.surfaces.size(), std::size_t(7));
    QSignalSpy ended(document_.get(), &Document::editEnded);
    for (Index face = 0; face < 12; ++face) {
        document_->selectFaces({cube, {face}});
        document_->splitSelection();
        QVERIFY(endedNow(ended));
        const SceneObject& is = document_->scene().objects[0];
        QCOMPARE(is.surfaces.size(), std::size_t(8));
        for (Index triangle = 0; triangle < 12; ++triangle) {
            const Surface& now = is.surfaces[is.geometry->surfaceOf[triangle]];
            Surface expected = was.surfaces[was.geometry->surfaceOf[triangle]];
            if (triangle == face) {
                expected.name += expected.name == "front" ? " 3" : " 2";
                expected.colour = colourApartFrom(was.surfaces);
            }
            QVERIFY2(now == expected,
                     qPrintable(
                         QString("triangle %1 split off: %2 is of \"%3\" instead of \"%4\"")
                             .arg(face)
                             .arg(triangle)
                             .arg(QString::fromStdString(now.name), QString::fromStdString(expected.name))));
        }
        QVERIFY(is.surfaces[6] == spare);
        document_->history().undo();
        QCOMPARE(difference(document_->scene(), before), "");
    }
}

void TestDocument::mergingOfTooFewOrOfLockedOnesIsRefused() {
    const ObjectId cube = front().object;
    document_->setLocked(SurfaceRef{cube, 2}, true);
    const Scene before = document_->scene();
    const int steps = document_->history().count();
    QSignalSpy ended(document_.get(), &Document::editEnded);
    document_->select(SurfaceRefs{});
    document_->mergeSelected();
    QCOMPARE(ended.size(), 0); // of nothing
    const SurfaceRefs refused[] = {{{cube, 1}}, {{cube, 2}, {cube, 1}}, {{cube, 0}, {cube, 1}, {cube, 2}}};
    for (const SurfaceRefs& refs : refused) {
        document_->select(refs);
        ended.clear();
        document_->mergeSelected();
        QCOMPARE(ended.size(), 1);
        QVERIFY(ended[0][0].toString().contains(QStringLiteral("not locked")));
        QVERIFY(!document_->editing());
        QCOMPARE(difference(document_->scene(), before), "");
        QCOMPARE(document_->history().count(), steps);
        QCOMPARE(document_->selected(), refs);
    }
    // A locked one among others stays what it is.
    document_->select({{cube, 0}, {cube, 2}, {cube, 1}});
    document_->mergeSelected();
    QVERIFY(endedNow(ended));
    const SceneObject& is = document_->scene().objects[0];
    QCOMPARE(is.surfaces.size(), std::size_t(5));
    QVERIFY(is.surfaces[0] == before.objects[0].surfaces[1]);
    QVERIFY(is.surfaces[1] == before.objects[0].surfaces[2]);
}

// The worker's answer is for an object that is not there any more in that form: the person's word stays.
void TestDocument::whatIsChangedMeanwhileIsNotChangedAgain() {
    const ObjectId cube = front().object;
    QSignalSpy ended(document_.get(), &Document::editEnded);
    const auto merge = [&] {
        document_->select({{cube, 0}, {cube, 1}});
        document_->mergeSelected();
    };
    merge();
    document_->setMaterialValue(front(), kMaterialFields[0], 500);
    const Scene edited = document_->scene();
    QVERIFY(endedNow(ended));
    QVERIFY(ended[0][0].toString().contains(QStringLiteral("was changed meanwhile")));
    QCOMPARE(difference(document_->scene(), edited), "");
    QCOMPARE(document_->history().count(), 1);
    merge();
    document_->removeObject(cube);
    QVERIFY(endedNow(ended));
    QVERIFY(ended[1][0].toString().contains(QStringLiteral("was changed meanwhile")));
    QVERIFY(document_->scene().objects.empty());
    QCOMPARE(document_->history().count(), 2);
}

void TestDocument::whatIsRemovedComesBackSelected() {
    document_->select(front());
    const SurfaceRef chosen = front();
    document_->removeObject(chosen.object);
    QVERIFY(!document_->selection());
    document_->history().undo();
    QCOMPARE(document_->selection(), std::optional(chosen));
    document_->history().redo();
    document_->select(std::nullopt); // a person who chose nothing since
    document_->history().undo();
    QVERIFY(!document_->selection());
}

void TestDocument::findingsGoAndComeWithTheirObject() {
    const ObjectId cube = front().object;
    const auto names = [&] {
        std::vector<std::string> all;
        for (const Finding& finding : document_->findings())
            all.push_back(finding.object);
        return all;
    };
    QVERIFY(!names().empty()); // its quads were cut
    QCOMPARE(names().front(), std::string("cube"));
    document_->renameObject(cube, QStringLiteral("dice"));
    QCOMPARE(names().front(), std::string("dice"));
    document_->removeObject(cube);
    QVERIFY(names().empty());
    document_->history().undo();
    QCOMPARE(names().front(), std::string("dice"));
}

void TestDocument::editsOfNothingAreIgnored() {
    document_->setMaterialValue(SurfaceRef{99, 0}, kMaterialFields[0], 5);
    document_->setMaterialValue(SurfaceRef{front().object, 77}, kMaterialFields[0], 5);
    document_->setShading(SurfaceRef{99, 0}, {true});
    document_->setShading(front(), {});
    document_->setSides(SurfaceRef{99, 0}, Sides::Back);
    document_->setSides(front(), Sides::Both);
    document_->renameObject(99, QStringLiteral("ghost"));
    document_->removeObject(99);
    document_->setMaterialValue(front(), kMaterialFields[0], kStiffness.initial);
    bool worked = false;
    document_->changeObject(99, QStringLiteral("Nothing"), [&](const SceneObject& object, const Progress&) {
        worked = true;
        return Result<SceneObject>(object);
    });
    QVERIFY(!worked);
    QCOMPARE(document_->history().count(), 0);
}

void TestDocument::aModelThatDoesNotFitTheHandIsScaledAndSaysSo() {
    QSignalSpy noted(document_.get(), &Document::noted);
    QVERIFY(open(writeCube(folder_, 100)));
    COMPARE_NEAR(boundsOf(document_->scene()).diagonal(), 0.2, 1e-9, "m");
    QCOMPARE(noted.size(), 1);
    COMPARE_CONTAINS(noted[0][0].toString(), QStringLiteral("17 m"));
    document_->history().undo();
    COMPARE_NEAR(boundsOf(document_->scene()).diagonal(), 10 * std::sqrt(3.0), 1e-6, "m");
}

void TestDocument::aBrokenFileLeavesTheSceneAndSaysOneLine_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("no PLY") << "broken.ply" << QByteArray("this is not a ply file\n");
    QTest::newRow("truncated STL") << "broken.stl"
                                   << QByteArray(80, ' ') + QByteArray("\x40\x42\x0f\x00", 4) +
                                          QByteArray(50, 'x');
    QTest::newRow("index out of range")
        << "broken.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999\n");
    QTest::newRow("unknown ending") << "broken.xyz" << QByteArray("0 0 0\n");
    QTest::newRow("missing") << "" << QByteArray();
}

void TestDocument::aBrokenFileLeavesTheSceneAndSaysOneLine() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    document_->setProxyRadius(0.003);
    const Scene before = document_->scene();
    const auto path = document_->path();
    QSignalSpy failed(document_.get(), &Document::openFailed), changed(document_.get(), &Document::changed);
    open(name.isEmpty() ? folder_.filePath(QStringLiteral("nowhere.obj"))
                        : writeFile(folder_, name, content));
    QCOMPARE(failed.size(), 1);
    const QString sentence = failed[0][0].toString();
    QVERIFY2(!sentence.isEmpty() && !sentence.contains(u'\n'), qPrintable(sentence));
    QCOMPARE(difference(document_->scene(), before), "");
    QCOMPARE_EQ(document_->path(), path);
    QCOMPARE(changed.size(), 0);
    QCOMPARE(document_->history().count(), 1);
}

void TestDocument::anOpeningCanBeCancelled() {
    QByteArray large;
    for (int i = 0; i < 200000; ++i)
        large += "v " + QByteArray::number(i * 1e-6) + " 0 0\nv 0 " + QByteArray::number(i * 1e-6) +
                 " 1\nv 0 1 0\nf -1 -2 -3\n";
    const QString file = writeFile(folder_, QStringLiteral("large-soup.obj"), large);
    const Scene before = document_->scene();
    QSignalSpy failed(document_.get(), &Document::openFailed), opened(document_.get(), &Document::opened);
    document_->open(file.toStdString());
    QTest::qWait(50);
    document_->cancelOpen();
    QTRY_COMPARE(failed.size(), 1);
    QCOMPARE(opened.size(), 0);
    QCOMPARE(difference(document_->scene(), before), "");
}

TACTUM_TEST(TestDocument)

} // namespace test_document

#include "test_document.moc"
