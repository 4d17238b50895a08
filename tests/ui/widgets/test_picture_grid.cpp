// Where keys and clicks lead in a grid of pictures, what is folded and kept, what is painted. Wrong itself if
// the grid had another width: it is five cells wide, whatever the style's scroll bar takes.
#include <QAction>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/as_shown.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/own_folders.h"
#include "ui/base/style.h"
#include "ui/widgets/picture_grid.h"

namespace test_picture_grid {

using namespace tactum;

namespace {

QPixmap plain() {
    QPixmap picture(PictureGrid::kSide, PictureGrid::kSide);
    picture.fill(Qt::gray);
    return picture;
}

/// Seven pictures under a heading, three under the next, one under the last.
struct Filled {
    Filled() {
        grid.resize(5 * 64 + grid.verticalScrollBar()->sizeHint().width() + 2 * grid.frameWidth() + 8, 600);
        int number = 0;
        for (const auto& [key, title, count] : {std::tuple("metal", "Metal", 7),
                                                {"wood", "Wood and what is made of it", 3},
                                                {"own", "Own", 1}}) {
            grid.beginGroup(QLatin1String(key), QLatin1String(title));
            for (int i = 0; i < count; ++i)
                grid.add(QStringLiteral("%1 %2").arg(QLatin1String(title).first(3)).arg(++number), plain());
        }
        QObject::connect(&grid, &PictureGrid::pictureActivated, &grid,
                         [this](QListWidgetItem* item) { activated << item->text(); });
        grid.setAttribute(Qt::WA_DontShowOnScreen);
        grid.show();
        grid.doItemsLayout();
    }
    QString current() const {
        const QListWidgetItem* item = grid.currentItem();
        if (!item) return QStringLiteral("none");
        return PictureGrid::isHeading(item) ? item->data(Qt::AccessibleTextRole).toString() + u':'
                                            : item->text();
    }
    QString state() {
        QStringList folded, hidden;
        for (const QListWidgetItem* each : grid.headings())
            folded << each->data(Qt::AccessibleTextRole).toString() + u' ' +
                          each->data(Qt::AccessibleDescriptionRole).toString();
        for (const QListWidgetItem* each : grid.pictures())
            if (each->isHidden()) hidden << each->text();
        QStringList kept = QSettings().value(QStringLiteral("folded/test")).toStringList();
        kept.sort();
        return QStringLiteral("%1; %2; hidden %3; kept %4; activated %5\n")
            .arg(current(), folded.join(u','), hidden.join(u','), kept.join(u','),
                 std::exchange(activated, {}).join(u','));
    }
    void note(const QString& words, const std::function<void()>& act) {
        act();
        grid.doItemsLayout();
        said += words + QStringLiteral(": ") + state();
    }
    void keys(const char* words, std::initializer_list<int> pressed) {
        note(QLatin1String(words), [&] {
            for (const int key : pressed) {
                QKeyEvent event(QEvent::KeyPress, key, {});
                QApplication::sendEvent(&grid, &event);
            }
        });
    }
    QListWidgetItem* heading(int i) const { return grid.headings().at(i); }
    void press(const QListWidgetItem* item, Qt::MouseButton button = Qt::LeftButton) {
        const QPoint at = grid.visualItemRect(item).center();
        QMouseEvent event(QEvent::MouseButtonPress, at, grid.viewport()->mapToGlobal(QPointF(at)), button,
                          button, {});
        QApplication::sendEvent(grid.viewport(), &event);
    }
    /// Whether the key is the grid's, before any command of the window.
    bool takes(int key, const QString& text, Qt::KeyboardModifiers keys = {}) {
        QKeyEvent event(QEvent::ShortcutOverride, key, keys, text);
        event.ignore();
        QApplication::sendEvent(&grid, &event);
        return event.isAccepted();
    }

    PictureGrid grid{QStringLiteral("test"), QStringLiteral("Nothing is here.")};
    QStringList activated;
    QString said;
};

} // namespace

class TestPictureGrid : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    void init() {
        useFoldersIn(folders_.next());
        applyTheme(ThemeChoice::Dark);
    }

    void keysLead() {
        Filled filled;
        using namespace Qt;
        filled.keys("the first key", {Key_Down});
        filled.keys("down", {Key_Down});
        filled.keys("right, twice", {Key_Right, Key_Right});
        filled.keys("down", {Key_Down});
        filled.keys("down over the heading", {Key_Down, Key_Down});
        filled.keys("up to the column", {Key_Up, Key_Up});
        filled.keys("up", {Key_Up, Key_Up, Key_Up});
        filled.keys("up at the top", {Key_Up});
        filled.keys("left at the top", {Key_Left});
        filled.keys("folded", {Key_Left});
        filled.keys("unfolded", {Key_Right});
        filled.keys("folded by Enter", {Key_Return});
        filled.keys("down to the next heading", {Key_Down});
        filled.keys("folded by the space bar", {Key_Space});
        filled.keys("right on it", {Key_Right});
        filled.keys("right leads on", {Key_Right});
        filled.keys("Enter on a picture", {Key_Return});
        filled.keys("the end", {Key_End});
        filled.keys("right at the end", {Key_Right});
        filled.keys("down at the end", {Key_Down});
        filled.keys("home", {Key_Home});
        COMPARE_SHOWN(filled.said, "grid-keys");
    }

    void groupsAreFolded() {
        Filled filled;
        filled.note(QStringLiteral("a click"), [&] { filled.press(filled.heading(0)); });
        filled.note(QStringLiteral("the right button"),
                    [&] { filled.press(filled.heading(1), Qt::RightButton); });
        filled.note(QStringLiteral("a click on a picture"),
                    [&] { filled.press(filled.grid.pictures().at(8)); });
        filled.note(QStringLiteral("its group is folded"),
                    [&] { filled.grid.setFolded(filled.heading(1), true); });
        filled.note(QStringLiteral("found by its letters"),
                    [&] { filled.grid.setCurrentItem(filled.grid.pictures().at(9)); });
        filled.note(QStringLiteral("all are open"), [&] { filled.grid.setAllOpen(true); });
        filled.note(QStringLiteral("none is folded then"),
                    [&] { filled.grid.setFolded(filled.heading(2), true); });
        filled.note(QStringLiteral("as before"), [&] { filled.grid.setAllOpen(false); });
        filled.note(QStringLiteral("a picture more"), [&] {
            filled.grid.beginGroup(QStringLiteral("metal"), QStringLiteral("Metal"));
            filled.grid.add(QStringLiteral("new"), plain());
        });
        filled.note(QStringLiteral("a double click"), [&] {
            emit filled.grid.itemActivated(filled.grid.pictures().at(7));
            emit filled.grid.itemActivated(filled.heading(1));
        });
        Filled again; // with what was kept
        COMPARE_SHOWN(filled.said + QStringLiteral("again: ") + again.state(), "grid-folds");
    }

    void lettersAreTheGridsForWhoCameByKeys() {
        Filled filled;
        const auto letters = [&](Qt::FocusReason by) {
            QFocusEvent event(QEvent::FocusIn, by);
            QApplication::sendEvent(&filled.grid, &event);
            return QStringLiteral("%1%2%3%4")
                .arg(filled.takes(Qt::Key_M, QStringLiteral("m")))
                .arg(filled.takes(Qt::Key_M, QStringLiteral("M"), Qt::ShiftModifier))
                .arg(filled.takes(Qt::Key_M, QStringLiteral("m"), Qt::ControlModifier))
                .arg(filled.takes(Qt::Key_F5, {}));
        };
        QCOMPARE(letters(Qt::MouseFocusReason), "0000");
        QCOMPARE(letters(Qt::TabFocusReason), "1100");
        QCOMPARE(letters(Qt::PopupFocusReason), "1100"); // as it was
        QCOMPARE(letters(Qt::MouseFocusReason), "0000");
        QCOMPARE(letters(Qt::BacktabFocusReason), "1100");
        filled.press(filled.grid.pictures().at(0));
        QVERIFY(!filled.takes(Qt::Key_M, QStringLiteral("m")));
        QCOMPARE(letters(Qt::OtherFocusReason), "1100");
    }

    void itIsPainted() {
        Filled filled;
        filled.grid.setCurrentItem(filled.grid.pictures().at(1));
        filled.grid.setFolded(filled.heading(1), true);
        filled.grid.doItemsLayout();
        QString places;
        for (const QListWidgetItem* each : filled.grid.headings() + filled.grid.pictures()) {
            const QRect at = filled.grid.visualItemRect(each);
            places +=
                QStringLiteral("%1 %2 %3 %4\n").arg(at.x()).arg(at.y()).arg(at.width()).arg(at.height());
        }
        COMPARE_SHOWN(places + test::drawnBy(*filled.grid.viewport()), "grid-painted");
        filled.grid.resize(2 * 64 + 40, 300); // longer words are cut
        filled.grid.doItemsLayout();
        COMPARE_SHOWN(test::drawnBy(*filled.grid.viewport()), "grid-narrow");
        filled.grid.clear();
        COMPARE_SHOWN(test::drawnBy(*filled.grid.viewport()), "grid-empty");
    }
};

TACTUM_GUI_TEST(TestPictureGrid)

} // namespace test_picture_grid

#include "test_picture_grid.moc"
