// The library of presets in the real window: search, apply, drag onto the model, save, rename, remove,
// import.
#include <algorithm>
#include <map>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QScrollBar>
#include <QTest>
#include <QUndoStack>

#include "core/presets/preset_file.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/apply_preset.h"
#include "ui/document/preset_store.h"
#include "ui/panels/preset_form.h"
#include "ui/panels/preset_library.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/picture_grid.h"

namespace test_presets {

using namespace tactum;

namespace {

PresetLibrary& library(const TouchedWindow& program) {
    return *program.window->findChild<PresetLibrary*>();
}
PresetStore& store(const TouchedWindow& program) {
    return *program.window->findChild<PresetStore*>();
}
PictureGrid& list(const TouchedWindow& program) {
    return *library(program).findChild<PictureGrid*>(QStringLiteral("preset-list"));
}
QLineEdit& search(const TouchedWindow& program) {
    return *library(program).findChild<QLineEdit*>(QStringLiteral("preset-search"));
}
QString noticeOf(const TouchedWindow& program) {
    return program.window->findChild<NoticeBar*>()->text();
}

QListWidgetItem* row(const TouchedWindow& program, const QString& name) {
    const auto found = list(program).findItems(name, Qt::MatchExactly);
    return found.isEmpty() ? nullptr : found.front();
}

/// Waits until the library shows what is on the disk.
bool ready(const TouchedWindow& program) {
    return test::waitFor([&] { return !store(program).loading() && !list(program).pictures().isEmpty(); });
}

bool choose(const TouchedWindow& program, const QString& name) {
    if (!ready(program) || !row(program, name)) return false;
    library(program).window()->findChild<QDockWidget*>(QStringLiteral("dock-presets"))->raise();
    list(program).setCurrentItem(row(program, name));
    list(program).scrollToItem(row(program, name));
    list(program).setFocus();
    return library(program).chosen();
}

/// Drags a row's data over the view as a person would, and lets it go at `at`.
bool drop(TouchedWindow& program, const QMimeData& data, QPoint at) {
    SceneView& view = program.window->view();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &enter);
    if (!enter.isAccepted()) return false;
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &move);
    if (!move.isAccepted()) {
        QDragLeaveEvent leave;
        QApplication::sendEvent(&view, &leave);
        return false;
    }
    QDropEvent let(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&view, &let);
    return let.isAccepted();
}

std::unique_ptr<QMimeData> dragged(const TouchedWindow& program, const QString& name) {
    const StoredPreset* stored = store(program).find(row(program, name)->data(Qt::UserRole).toString());
    auto data = std::make_unique<QMimeData>();
    data->setData(QString::fromLatin1(kPresetMime), stored->text.toUtf8());
    return data;
}

const Surface& surfaceOf(const TouchedWindow& program, Index i) {
    return program.document.scene().objects.front().surfaces[i];
}

} // namespace

class TestPresets : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::unique_ptr<TouchedWindow> opened() const {
        auto program = std::make_unique<TouchedWindow>();
        if (!program->open(writeCube(folder_))) qFatal("the cube cannot be opened");
        program->engine.setArmed(false); // what a late machine does to the force takes no notice's place
        return program;
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        QDir(PresetStore::folder()).removeRecursively();
    }

    void shippedOnesAreListedWithPictures();
    void theGridFlowsWithItsWidth();
    void groupsFoldAndAreRemembered();
    void arrowsAndLettersLeadThroughTheGrid();
    void aPictureIsDraggedOut();
    void searchLooksThroughNamesTagsAndSources();
    void applyingIsOneStep();
    void aMaterialLooksLikeItself();
    void lockedSurfacesStay();
    void keysAndDoubleClickApply();
    void aDropChangesTheSurfaceUnderThePointer();
    void rowsCarryTheirText();
    void nonsenseThatIsDroppedChangesNothing();
    void aSurfaceIsSavedAndFoundAgain();
    void ownOnesAreRenamedAndRemoved();
    void filesAreImportedAndApplied();
    void badFilesAreSaidOnce();
    void theFolderIsFollowed();
};

void TestPresets::shippedOnesAreListedWithPictures() {
    const auto program = opened();
    QVERIFY(ready(*program));
    QCOMPARE_GE(list(*program).pictures().size(), 20);
    QListWidgetItem* ice = row(*program, QStringLiteral("Ice on ice"));
    QVERIFY(ice);
    QVERIFY(!ice->data(Qt::DecorationRole).value<QPixmap>().isNull());
    COMPARE_BEGINS(ice->data(Qt::AccessibleDescriptionRole).toString(), QStringLiteral("0.1 / 0.03"));
    COMPARE_CONTAINS(ice->toolTip(), QStringLiteral("Hill"));
    COMPARE_CONTAINS(ice->toolTip(), QStringLiteral("0.030"));
    QVERIFY(choose(*program, QStringLiteral("Honey")));
    const QString details = library(*program).findChild<QLabel*>(QStringLiteral("preset-details"))->text();
    COMPARE_CONTAINS(details, QStringLiteral("8.00 N s/m"));
    COMPARE_CONTAINS(details, QStringLiteral("no source"));
    // A relief is seen: two presets of one colour have different pictures.
    Preset plain;
    Preset rough = plain;
    rough.layers.emplace().emplace_back().strength = 1e-3;
    QCOMPARE_EQ(store(*program).presets().front().picture.size(), QSize(80, 80));
}

/// Pictures of one category side by side, as many as fit, and the heading above them.
void TestPresets::theGridFlowsWithItsWidth() {
    const auto program = opened();
    QVERIFY(choose(*program, QStringLiteral("Brick")));
    PictureGrid& grid = list(*program);
    grid.setParent(nullptr); // as wide as it is made
    const auto perRow = [&](int width) {
        grid.resize(width, 400);
        grid.show();
        if (!QTest::qWaitForWindowExposed(&grid)) qFatal("the grid is not seen");
        std::map<int, int> rows;
        for (QListWidgetItem* each : grid.pictures())
            ++rows[grid.visualItemRect(each).top()];
        return std::ranges::max_element(rows, {}, [](const auto& row) { return row.second; })->second;
    };
    QCOMPARE(perRow(160), 2);
    QCOMPARE(perRow(216), 3);
    QCOMPARE(perRow(480), 5); // stiffness has five
    for (QListWidgetItem* heading : grid.headings()) {
        const QRect place = grid.visualItemRect(heading);
        for (QListWidgetItem* each : grid.pictures())
            QVERIFY(!place.intersects(grid.visualItemRect(each)));
        QCOMPARE_LE(place.right(), grid.viewport()->width());
    }
    QVERIFY(!grid.horizontalScrollBar()->isVisible());
    grid.setParent(&library(*program)); // its owner
}

void TestPresets::groupsFoldAndAreRemembered() {
    {
        const auto program = opened();
        QVERIFY(choose(*program, QStringLiteral("Brick")));
        PictureGrid& grid = list(*program);
        QListWidgetItem* body = grid.headings().front();
        grid.scrollToItem(body);
        QListWidgetItem* first = row(*program, QStringLiteral("Joint cartilage"));
        QVERIFY(!first->isHidden());
        QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, grid.visualItemRect(body).center());
        QVERIFY(first->isHidden());
        QVERIFY(!row(*program, QStringLiteral("Brick"))->isHidden());
        // What is searched for is seen, and folded again after that.
        search(*program).setText(QStringLiteral("cartilage"));
        QVERIFY(!row(*program, QStringLiteral("Joint cartilage"))->isHidden());
        QCOMPARE(grid.headings().size(), 1);
        list(*program).setCurrentItem(nullptr);
        search(*program).clear();
        QVERIFY(row(*program, QStringLiteral("Joint cartilage"))->isHidden());
    }
    const TouchedWindow again;
    QVERIFY(ready(again));
    QVERIFY(row(again, QStringLiteral("Joint cartilage"))->isHidden());
    // By keys: to the heading above the first picture that is seen, and Enter.
    PictureGrid& grid = list(again);
    grid.setCurrentItem(grid.headings().front());
    grid.setFocus();
    QTest::keyClick(&grid, Qt::Key_Return);
    QVERIFY(!row(again, QStringLiteral("Joint cartilage"))->isHidden());
    QTest::keyClick(&grid, Qt::Key_Left);
    QVERIFY(row(again, QStringLiteral("Joint cartilage"))->isHidden());
}

void TestPresets::arrowsAndLettersLeadThroughTheGrid() {
    const auto program = opened();
    QVERIFY(choose(*program, QStringLiteral("Brick")));
    PictureGrid& grid = list(*program);
    const auto now = [&] { return grid.currentItem()->text(); };
    const auto key = [&](Qt::Key pressed) { QTest::keyClick(&grid, pressed); };
    const QRect brick = grid.visualItemRect(grid.currentItem());
    key(Qt::Key_Right);
    QCOMPARE(now(), QStringLiteral("Glass on glass"));
    QCOMPARE(grid.visualItemRect(grid.currentItem()).top(), brick.top()); // beside it
    key(Qt::Key_Left);
    key(Qt::Key_Up);
    QVERIFY(PictureGrid::isHeading(grid.currentItem()));
    QVERIFY(!library(*program).chosen());
    key(Qt::Key_Down);
    QCOMPARE(now(), QStringLiteral("Brick"));
    key(Qt::Key_Down);
    key(Qt::Key_Down);
    const QRect below = grid.visualItemRect(grid.currentItem());
    QCOMPARE(below.left(), grid.visualItemRect(row(*program, QStringLiteral("Brick"))).left());
    QCOMPARE_GT(below.top(), grid.visualItemRect(row(*program, QStringLiteral("Brick"))).top());
    QTest::keyClicks(&grid, QStringLiteral("ho"));
    QCOMPARE(now(), QStringLiteral("Honey"));
    program->document.select(SurfaceRef{program->document.scene().objects.front().id, 2});
    key(Qt::Key_Return);
    QCOMPARE(surfaceOf(*program, 2).material.viscosity, 8.0);
}

/// As a hand does it: pressed, moved, and what comes along is the preset under the pointer.
void TestPresets::aPictureIsDraggedOut() {
    const auto program = opened();
    QVERIFY(choose(*program, QStringLiteral("Brick")));
    PictureGrid& grid = list(*program);
    QCOMPARE(grid.dragDropMode(), QAbstractItemView::DragOnly);
    QVERIFY(grid.dragEnabled());
    QVERIFY(row(*program, QStringLiteral("Brick"))->flags() & Qt::ItemIsDragEnabled);
    QVERIFY(!(grid.headings().front()->flags() & Qt::ItemIsDragEnabled));
    const QPoint at = grid.visualItemRect(row(*program, QStringLiteral("Brick"))).center();
    QCOMPARE(grid.itemAt(at), row(*program, QStringLiteral("Brick")));
    const std::unique_ptr<QMimeData> data(grid.model()->mimeData({grid.indexAt(at)}));
    QVERIFY(data && drop(*program, *data, program->centre()));
    QCOMPARE(program->document.history().undoText(), QStringLiteral("Preset Brick"));
}

void TestPresets::searchLooksThroughNamesTagsAndSources() {
    const auto program = opened();
    QVERIFY(ready(*program));
    const auto found = [&](const char* typed) {
        search(*program).setText(QString::fromLatin1(typed));
        QStringList names;
        for (const QListWidgetItem* each : list(*program).pictures())
            names << each->text();
        return names;
    };
    COMPARE_CONTAINS(found("ICE"), QStringLiteral("Ice on ice"));
    COMPARE_LACKS(found("ice"), QStringLiteral("Brick"));
    QCOMPARE_EQ(found("ptfe"), QStringList{QStringLiteral("Teflon on steel")}); // a tag
    QCOMPARE_EQ(found("penn brick"), QStringList{QStringLiteral("Brick")});     // a source and a name
    QVERIFY(found("nothing like it").isEmpty());
    QCOMPARE_GE(found("").size(), 20);
}

void TestPresets::applyingIsOneStep() {
    const auto program = opened();
    Document& document = program->document;
    const Scene before = document.scene();
    Preset preset;
    preset.name = "all";
    preset.values = {500, 1, 0.75, 0.5, 2};
    preset.shading = Shading{true, NormalSource::Computed, 0.5};
    preset.layers.emplace().emplace_back().name = "grain";
    const ObjectId id = before.objects.front().id;
    document.select({SurfaceRef{id, 1}, SurfaceRef{id, 4}});
    QVERIFY(applyPreset(document, document.selected(), preset));
    QCOMPARE(document.history().count(), 1);
    QCOMPARE(document.history().undoText(), QStringLiteral("Preset all"));
    const Scene after = document.scene();
    for (Index i = 0; i < 6; ++i) {
        const Surface& was = before.objects.front().surfaces[i];
        QVERIFY(surfaceOf(*program, i) == (i == 1 || i == 4 ? applied(was, preset) : was));
    }
    QVERIFY(test::waitFor([&] { return program->caughtUp(); }));
    document.history().undo();
    QVERIFY(document.scene() == before);
    document.history().redo();
    QVERIFY(document.scene() == after);
    QVERIFY(!applyPreset(document, document.selected(), preset)); // they feel like it already
    QCOMPARE(document.history().count(), 1);
}

void TestPresets::aMaterialLooksLikeItself() {
    const auto program = opened();
    Document& document = program->document;
    const SurfaceRef ref{document.scene().objects.front().id, 1};
    document.editSurfaces({ref}, SceneChange::What::Material, QStringLiteral("colour"), [](Surface& each) {
        each.colour = {0.1F, 0.2F, 0.3F};
    }); // as a file may say
    document.select(ref);
    const Surface before = *document.surface(ref);
    const auto given = [&](const char* name) {
        if (!choose(*program, QString::fromLatin1(name))) qFatal("no %s", name);
        program->command("preset-apply").trigger();
        return document.surface(ref)->colour;
    };
    const Eigen::Vector3f brick = given("Brick");
    QVERIFY(brick != before.colour);
    QVERIFY(given("Leather on oak") != brick);
    document.history().undo();
    QVERIFY(document.surface(ref)->colour == brick);
    document.history().undo();
    QVERIFY(*document.surface(ref) == before);
}

void TestPresets::lockedSurfacesStay() {
    const auto program = opened();
    Document& document = program->document;
    const ObjectId id = document.scene().objects.front().id;
    document.setLocked(SurfaceRef{id, 0}, true);
    const Surface before = surfaceOf(*program, 0);
    document.select({SurfaceRef{id, 0}, SurfaceRef{id, 1}});
    QVERIFY(choose(*program, QStringLiteral("Ice on ice")));
    program->command("preset-apply").trigger();
    QVERIFY(surfaceOf(*program, 0) == before);
    QCOMPARE(surfaceOf(*program, 1).material.staticFriction, 0.1);
    document.select(SurfaceRef{id, 0});
    const int steps = document.history().count();
    program->command("preset-apply").trigger();
    QCOMPARE(document.history().count(), steps);
    COMPARE_CONTAINS(noticeOf(*program), QStringLiteral("locked"));
}

void TestPresets::keysAndDoubleClickApply() {
    const auto program = opened();
    Document& document = program->document;
    const ObjectId id = document.scene().objects.front().id;
    document.select(std::nullopt);
    QVERIFY(choose(*program, QStringLiteral("Wood on wood")));
    QVERIFY(!program->command("preset-apply").isEnabled());
    QTest::keyClick(&list(*program), Qt::Key_Return);
    COMPARE_CONTAINS(noticeOf(*program), QStringLiteral("Select the surfaces"));
    document.select(SurfaceRef{id, 2});
    QVERIFY(program->command("preset-apply").isEnabled());
    QTest::keyClick(&list(*program), Qt::Key_Return);
    QCOMPARE(surfaceOf(*program, 2).material.staticFriction, 0.5);
    document.history().undo();
    QTest::qWait(50); // the dock gets its place
    list(*program).scrollToItem(row(*program, QStringLiteral("Wood on wood")));
    const QRect at = list(*program).visualItemRect(row(*program, QStringLiteral("Wood on wood")));
    QVERIFY(list(*program).viewport()->rect().contains(at.center()));
    QTest::mouseClick(list(*program).viewport(), Qt::LeftButton, {}, at.center());
    QTest::mouseDClick(list(*program).viewport(), Qt::LeftButton, {}, at.center());
    QCOMPARE(surfaceOf(*program, 2).material.staticFriction, 0.5);
    document.history().undo();
    search(*program).setFocus();
    QTest::keyClicks(&search(*program), QStringLiteral("teflon"));
    QTest::keyClick(&search(*program), Qt::Key_Return);
    QCOMPARE(surfaceOf(*program, 2).material.staticFriction, 0.04);
}

void TestPresets::aDropChangesTheSurfaceUnderThePointer() {
    const auto program = opened();
    QVERIFY(choose(*program, QStringLiteral("Denim")));
    SceneView& view = program->window->view();
    const QPoint at = program->centre();
    const auto under = view.surfaceAt(at);
    QVERIFY(under);
    program->document.select(std::nullopt);
    const Scene before = program->document.scene();
    const auto data = dragged(*program, QStringLiteral("Denim"));
    std::optional<SurfaceRef> lit;
    connect(&view, &SceneView::surfaceHovered, this, [&](auto surface) {
        if (surface) lit = surface;
    });
    QVERIFY(!drop(*program, *data, {3, 3})); // beside the model
    QVERIFY(program->document.scene() == before);
    QVERIFY(drop(*program, *data, at));
    QCOMPARE(lit, under);
    for (Index i = 0; i < 6; ++i) {
        const Surface& was = before.objects.front().surfaces[i];
        if (i == under->surface) {
            QCOMPARE(surfaceOf(*program, i).material.dynamicFriction, 0.366);
            QCOMPARE(surfaceOf(*program, i).layers.size(), std::size_t(1));
        } else {
            QVERIFY(surfaceOf(*program, i) == was);
        }
    }
    QCOMPARE(program->document.history().count(), 1);
    program->document.history().undo();
    QVERIFY(program->document.scene() == before);
}

void TestPresets::rowsCarryTheirText() {
    const auto program = opened();
    QVERIFY(ready(*program));
    QListWidgetItem* ice = row(*program, QStringLiteral("Ice on ice"));
    const std::unique_ptr<QMimeData> data(
        list(*program).model()->mimeData({list(*program).indexFromItem(ice)}));
    QVERIFY(data);
    const auto read = parsePreset(data->data(QString::fromLatin1(kPresetMime)).toStdString(), "row");
    VERIFY_RESULT(read);
    QCOMPARE(read->preset.name, std::string("Ice on ice"));
}

void TestPresets::nonsenseThatIsDroppedChangesNothing() {
    const auto program = opened();
    const Scene before = program->document.scene();
    QMimeData words;
    words.setText(QStringLiteral("hello"));
    QVERIFY(!drop(*program, words, program->centre()));
    for (const char* bad : {"{}", "hello", R"({"tactumPreset":"1.0","name":"n","feel":{"stiffness":-1}})"}) {
        QMimeData data;
        data.setData(QString::fromLatin1(kPresetMime), bad);
        QVERIFY(drop(*program, data, program->centre()));
        COMPARE_CONTAINS(noticeOf(*program), QStringLiteral("the dropped preset:"));
    }
    QVERIFY(program->document.scene() == before);
    QCOMPARE_EQ(program->document.history().count(), 0);
}

void TestPresets::aSurfaceIsSavedAndFoundAgain() {
    const auto program = opened();
    Document& document = program->document;
    const ObjectId id = document.scene().objects.front().id;
    document.select(SurfaceRef{id, 3});
    program->type(QStringLiteral("static-friction"), QStringLiteral("0.77"));
    program->command("preset-save").trigger();
    auto* form = program->window->findChild<PresetForm*>();
    QVERIFY(form);
    QVERIFY(!form->isModal());
    auto* name = form->findChild<QLineEdit*>(QStringLiteral("preset-name"));
    name->setText(QStringLiteral("Velvet"));
    form->findChild<QLineEdit*>(QStringLiteral("preset-source"))->setText(QStringLiteral("felt by me"));
    QTest::keyClick(name, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Velvet")), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(library(*program).chosen(), kPatience);
    const StoredPreset* stored = library(*program).chosen();
    QVERIFY(stored->own);
    QCOMPARE(stored->preset.name, std::string("Velvet"));
    QCOMPARE(sourceOf(stored->preset, "staticFriction").words, std::string("felt by me"));
    QVERIFY(!stored->preset.layers);
    QVERIFY(!stored->preset.shading);
    QVERIFY(QFile::exists(PresetStore::folder() + QStringLiteral("/velvet.tactum-preset")));
    document.select(SurfaceRef{id, 0});
    program->command("preset-apply").trigger();
    QCOMPARE(surfaceOf(*program, 0).material.staticFriction, 0.77);
    const TouchedWindow again;
    QVERIFY(ready(again));
    QVERIFY(row(again, QStringLiteral("Velvet")));
}

void TestPresets::ownOnesAreRenamedAndRemoved() {
    const auto program = opened();
    Preset preset;
    preset.name = "Mine";
    preset.values[0] = 123;
    const QString file = store(*program).add(preset);
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Mine")), kPatience);
    QVERIFY(!(row(*program, QStringLiteral("Ice on ice"))->flags() & Qt::ItemIsEditable));
    row(*program, QStringLiteral("Mine"))->setText(QStringLiteral("Yours"));
    // A name that comes after the file has gone does not bring it back.
    const QString late = store(*program).add(preset);
    QTRY_VERIFY_WITH_TIMEOUT(store(*program).find(late), kPatience);
    const StoredPreset gone = *store(*program).find(late);
    store(*program).remove(gone);
    store(*program).rename(gone, QStringLiteral("Late"));
    QVERIFY(!QFile::exists(late));
    const auto known = [&] {
        const StoredPreset* stored = store(*program).find(file);
        return stored && stored->preset.name == "Yours" && row(*program, QStringLiteral("Yours"));
    };
    QTRY_VERIFY_WITH_TIMEOUT(known(), kPatience);
    // Del of this list is not the window's, which deletes objects: one that came with the program stays, too.
    const std::size_t objects = program->document.scene().objects.size();
    QVERIFY(choose(*program, QStringLiteral("Ice on ice")));
    QTest::keyClick(&list(*program), Qt::Key_Delete);
    QVERIFY(choose(*program, QStringLiteral("Yours")));
    QTest::keyClick(&list(*program), Qt::Key_Delete);
    QCOMPARE(program->document.scene().objects.size(), objects);
    QTRY_VERIFY_WITH_TIMEOUT(!row(*program, QStringLiteral("Yours")), kPatience);
    QVERIFY(!QFile::exists(file));
    program->window->findChild<QAbstractButton*>(QStringLiteral("notice-act"))->click();
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Yours")), kPatience);
    QVERIFY(choose(*program, QStringLiteral("Ice on ice")));
    QTest::keyClick(&list(*program), Qt::Key_Delete); // what comes with the program stays
    QVERIFY(ready(*program));
    QVERIFY(row(*program, QStringLiteral("Ice on ice")));
}

void TestPresets::filesAreImportedAndApplied() {
    const auto program = opened();
    const QByteArray text = R"({"tactumPreset":"1.0","name":"Given","feel":{"stiffness":321.0}})";
    const QString file = writeFile(folder_, QStringLiteral("given.tactum-preset"), text);
    const auto under = program->window->view().surfaceAt(program->centre());
    const Scene before = program->document.scene();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    // Not the view's: Qt goes on to its parents, up to the window.
    QDragEnterEvent enter(program->centre(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&program->window->view(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent let(program->centre(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&program->window->view(), &let);
    QTRY_COMPARE_WITH_TIMEOUT(surfaceOf(*program, under->surface).material.stiffness, 321.0, kPatience);
    QCOMPARE(program->document.history().count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Given")), kPatience);
    program->document.history().undo();
    QVERIFY(program->document.scene() == before);
    // A texture model of the Penn toolkit, with numbers of our own.
    const QString model = writeFile(folder_, QStringLiteral("model.xml"),
                                    "<modelSet><material>Fur</material><mu>0.5</mu></modelSet>");
    store(*program).importFiles({model, file});
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Fur")), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(list(*program).findItems(QStringLiteral("Given"), Qt::MatchExactly).size(), 2,
                              kPatience);
    QVERIFY(program->document.scene() == before);
}

void TestPresets::badFilesAreSaidOnce() {
    const auto program = opened();
    QVERIFY(ready(*program));
    int said = 0;
    connect(&store(*program), &PresetStore::failed, this, [&] { ++said; });
    store(*program).importFiles({writeFile(folder_, QStringLiteral("bad.tactum-preset"), "hello")});
    QTRY_COMPARE_WITH_TIMEOUT(said, 1, kPatience);
    COMPARE_CONTAINS(noticeOf(*program), QStringLiteral("bad.tactum-preset"));
    QFile lying(PresetStore::folder() + QStringLiteral("/lying.tactum-preset"));
    QVERIFY(lying.open(QIODevice::WriteOnly));
    QCOMPARE_EQ(lying.write("{}"), 2);
    lying.close();
    QTRY_COMPARE_WITH_TIMEOUT(said, 2, kPatience);
    Preset good;
    good.name = "Good";
    store(*program).add(good); // the folder is read again
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("Good")), kPatience);
    QVERIFY(ready(*program));
    QCOMPARE(said, 2);
}

void TestPresets::theFolderIsFollowed() {
    const auto program = opened();
    QVERIFY(ready(*program));
    Preset preset;
    preset.name = "From outside";
    QFile file(PresetStore::folder() + QStringLiteral("/outside.tactum-preset"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(presetText(preset).c_str());
    file.close();
    QTRY_VERIFY_WITH_TIMEOUT(row(*program, QStringLiteral("From outside")), kPatience);
    QVERIFY(file.remove());
    QTRY_VERIFY_WITH_TIMEOUT(!row(*program, QStringLiteral("From outside")), kPatience);
}

TACTUM_GUI_TEST(TestPresets)

} // namespace test_presets

#include "test_presets.moc"
