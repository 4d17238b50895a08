// A tree that says what would be in it, and keeps its keys from the window.
//
// What would show that a test here is wrong: the same picture with rows has no hint, and the same key
// elsewhere is the window's.
#include <QAction>
#include <QImage>
#include <QLineEdit>
#include <QMainWindow>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/base/style.h"
#include "ui/widgets/hinted_tree.h"

namespace test_hinted_tree {

using namespace tactum;

namespace {

class Tree : public HintedTree {
public:
    using HintedTree::HintedTree;
    using HintedTree::setHint;
    using HintedTree::setWrapping;
    using HintedTree::wrapRows;
    bool keeps = true;

protected:
    bool keepsEditKeys() const override { return keeps; }
};

/// How many dots have not the colour of the ground.
int dotsOf(Tree& tree) {
    const QImage picture = tree.viewport()->grab().toImage();
    const QRgb ground = picture.pixel(picture.width() - 2, picture.height() - 2);
    int dots = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            dots += picture.pixel(x, y) != ground;
    return dots;
}

/// A window that deletes, renames and duplicates by key, with a tree in it.
struct Window {
    Window() {
        for (const auto& [key, count] : {std::pair(QKeySequence(Qt::Key_Delete), &deleted),
                                         {QKeySequence(Qt::Key_F2), &renamed},
                                         {QKeySequence(Qt::Key_F7), &other}}) {
            auto* action = new QAction(&window);
            action->setShortcut(key);
            QObject::connect(action, &QAction::triggered, [times = count] { ++*times; });
            window.addAction(action);
        }
        window.setCentralWidget(tree);
        window.show();
    }
    bool ready() {
        window.activateWindow();
        tree->setFocus();
        return QTest::qWaitForWindowActive(&window);
    }
    int deleted = 0, renamed = 0, other = 0;
    QMainWindow window;
    Tree* tree = new Tree(QStringLiteral("Nothing is here yet."));
};

} // namespace

class TestHintedTree : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    void theHintIsThereWhileThereIsNoRow() {
        Tree tree(QStringLiteral("Nothing is here yet. Press the button to add something."));
        tree.resize(200, 100);
        const int hinted = dotsOf(tree);
        QCOMPARE_GT(hinted, 200);
        tree.setHint(QString());
        QCOMPARE(dotsOf(tree), 0);
        tree.setHint(QStringLiteral("Nothing is here yet. Press the button to add something."));
        QCOMPARE(dotsOf(tree), hinted);
        auto* row = new QTreeWidgetItem(&tree, {QString()});
        QCOMPARE(dotsOf(tree), 0);
        row->setHidden(true); // as a search does
        QCOMPARE(dotsOf(tree), hinted);
    }

    // A sentence in a narrow column is as high as its lines.
    void rowsWrap() {
        Tree tree{QString()};
        tree.setWrapping();
        tree.resize(160, 300);
        const QString sentence =
            QStringLiteral("the lid is not closed and has nine holes that are open to its inside");
        for (const QString& text : {QStringLiteral("short"), sentence})
            new QTreeWidgetItem(&tree, {text});
        tree.show();
        tree.wrapRows();
        const int line = tree.fontMetrics().height();
        QCOMPARE(tree.topLevelItem(0)->sizeHint(0).height(), line + kRhythm);
        const int wide = tree.topLevelItem(1)->sizeHint(0).height() - kRhythm;
        QCOMPARE_GE(wide, 3 * line);
        tree.resize(700, 300);
        QCOMPARE(tree.topLevelItem(1)->sizeHint(0).height(), line + kRhythm);
    }

    void editKeysAreItsOwn() {
        Window of;
        QVERIFY(of.ready());
        for (const int key : {Qt::Key_Delete, Qt::Key_F2, Qt::Key_F7})
            QTest::keyClick(of.tree, Qt::Key(key));
        QCOMPARE(of.deleted, 0);
        QCOMPARE(of.renamed, 0);
        QCOMPARE(of.other, 1);
        of.tree->keeps = false;
        QTest::keyClick(of.tree, Qt::Key_Delete);
        QCOMPARE(of.deleted, 1);
    }

    void itsOwnActionComesBeforeTheWindows() {
        Window of;
        QVERIFY(of.ready());
        int own = 0;
        auto* action = new QAction(of.tree);
        action->setShortcut(Qt::Key_F7);
        action->setShortcutContext(Qt::WidgetShortcut);
        connect(action, &QAction::triggered, this, [&own] { ++own; });
        of.tree->addAction(action);
        QTest::keyClick(of.tree, Qt::Key_F7);
        QCOMPARE(own, 1);
        QCOMPARE(of.other, 0);
        action->setEnabled(false); // and then nothing happens
        QTest::keyClick(of.tree, Qt::Key_F7);
        QCOMPARE(own, 1);
        QCOMPARE(of.other, 0);
    }
};

TACTUM_GUI_TEST(TestHintedTree)

} // namespace test_hinted_tree

#include "test_hinted_tree.moc"
