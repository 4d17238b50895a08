// A row of widgets that goes on below, and a text in lines: every place by addition.
//
// What would show that a test here is wrong: the widgets have sizes that are told apart, and the sums are
// written out.
#include <QLabel>
#include <QTest>
#include <QWidget>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/widgets/text_lines.h"
#include "ui/widgets/wrapping_row.h"

namespace test_wrapping_row {

using namespace tactum;

namespace {

constexpr int kGap = 5;

/// A row with margins of 1, 2, 3, 4 (left, top, right, bottom) and widgets of fixed sizes.
struct Row {
    Row() {
        row->setContentsMargins(1, 2, 3, 4);
        row->setSpacing(kGap);
    }
    template <class Kind = QWidget> Kind* add(int width, int height) {
        auto* widget = new Kind;
        widget->setFixedSize(width, height);
        row->addWidget(widget);
        return widget;
    }
    QList<QPoint> placesIn(int width) {
        row->setGeometry({0, 0, width, row->heightForWidth(width)});
        QList<QPoint> places;
        for (int i = 0; i < row->count(); ++i)
            if (const QWidget* widget = row->itemAt(i)->widget()) places << widget->pos();
        return places;
    }
    QWidget window;
    WrappingRow* row = new WrappingRow(&window);
};

} // namespace

class TestWrappingRow : public QObject {
    Q_OBJECT

private slots:
    void withRoomItIsOneRow() {
        Row of;
        of.add(10, 20), of.add(30, 8), of.add(20, 12);
        QCOMPARE(of.row->sizeHint(), QSize(1 + 10 + kGap + 30 + kGap + 20 + 3, 2 + 20 + 4));
        QCOMPARE(of.row->minimumSize(), QSize(1 + 30 + 3, 26));
        QCOMPARE(of.row->heightForWidth(74), 26);
        // Each in the middle of the row's height.
        QCOMPARE(of.placesIn(74), (QList<QPoint>{{1, 2}, {16, 8}, {51, 6}}));
    }

    void withoutRoomItGoesOnBelow() {
        Row of;
        of.add(10, 20), of.add(30, 8), of.add(20, 12);
        QCOMPARE(of.row->heightForWidth(73), 2 + 20 + kGap + 12 + 4); // one dot is missing
        QCOMPARE(of.placesIn(73), (QList<QPoint>{{1, 2}, {16, 8}, {1, 27}}));
        QCOMPARE(of.row->heightForWidth(40), 2 + 20 + kGap + 8 + kGap + 12 + 4);
        QCOMPARE(of.placesIn(40), (QList<QPoint>{{1, 2}, {1, 27}, {1, 40}}));
    }

    void wordsStayBesideWhatFollowsThem() {
        Row of;
        of.add(10, 20);
        of.add<QLabel>(15, 10);
        of.add(20, 10);
        // All but the last would have room; the words go with it.
        QCOMPARE(of.placesIn(1 + 10 + kGap + 15 + kGap + 19 + 3), (QList<QPoint>{{1, 2}, {1, 27}, {21, 27}}));
        QCOMPARE(of.placesIn(1 + 10 + kGap + 15 + kGap + 20 + 3), (QList<QPoint>{{1, 2}, {16, 7}, {36, 7}}));
        // Where both have no room side by side, each goes where it fits.
        QCOMPARE(of.placesIn(1 + 39 + 3), (QList<QPoint>{{1, 2}, {16, 7}, {1, 27}}));
    }

    void aGapIsTwiceTheSpacing() {
        Row of;
        of.add(10, 10);
        of.row->addGap();
        of.add(10, 10);
        QCOMPARE(of.row->count(), 3);
        QCOMPARE(of.row->sizeHint().width(), 1 + 10 + kGap + 2 * kGap + kGap + 10 + 3);
        QCOMPARE(of.placesIn(200), (QList<QPoint>{{1, 2}, {1 + 10 + kGap + 2 * kGap + kGap, 2}}));
    }

    void whatIsHiddenTakesNoRoom() {
        Row of;
        of.add(10, 10);
        QWidget* hidden = of.add(70, 70);
        of.add(20, 10);
        hidden->hide();
        QCOMPARE(of.row->sizeHint(), QSize(1 + 10 + kGap + 20 + 3, 2 + 10 + 4));
        QCOMPARE(of.placesIn(200)[2], QPoint(16, 2));
    }

    void whatIsTooWideIsCut() {
        Row of;
        QWidget* wide = of.add(100, 10);
        of.add(10, 10);
        const QList<QPoint> places = of.placesIn(54);
        QCOMPARE(places, (QList<QPoint>{{1, 2}, {1, 17}}));
        QCOMPARE(of.row->heightForWidth(54), 2 + 10 + kGap + 10 + 4);
        QCOMPARE(wide->sizeHint(), QSize(-1, -1)); // a plain widget: its fixed size is all that counts
    }

    void anEmptyRowIsItsMargins() {
        Row of;
        QCOMPARE(of.row->sizeHint(), QSize(4, 6));
        QCOMPARE(of.row->heightForWidth(100), 6);
    }

    void whatIsTakenIsGone() {
        Row of;
        of.add(10, 10);
        QWidget* second = of.add(20, 10);
        QCOMPARE(of.row->itemAt(-1), nullptr);
        QCOMPARE(of.row->itemAt(2), nullptr);
        QCOMPARE(of.row->takeAt(2), nullptr);
        delete of.row->takeAt(0);
        QCOMPARE(of.row->count(), 1);
        QCOMPARE(of.row->itemAt(0)->widget(), second);
    }

    // No line is wider than was asked, and together they are the text; what has no room ends with dots.
    void aTextInLines() {
        const QFont font;
        const QFontMetrics metrics(font);
        const QString text = QStringLiteral("stiffness and friction of the lid of a kettle");
        const int width = metrics.horizontalAdvance(QStringLiteral("stiffness and fric"));
        const QStringList all = linesOf(text, font, width, 99);
        QCOMPARE_GT(all.size(), 2);
        QCOMPARE(all.join(QString()), text);
        for (const QString& line : all)
            QCOMPARE_LE(metrics.horizontalAdvance(line.trimmed()), width);
        QCOMPARE(linesOf(text, font, width, int(all.size())).join(QString()), text);
        const QStringList two = linesOf(text, font, width, 2);
        QCOMPARE(two.size(), 2);
        QCOMPARE(two[0], all[0]);
        QVERIFY2(two[1].endsWith(QChar(0x2026)), qPrintable(two[1]));
        QCOMPARE_LE(metrics.horizontalAdvance(two[1]), width);
        QVERIFY2(text.contains(two[1].chopped(1).trimmed()), qPrintable(two[1]));
        QCOMPARE(linesOf(QStringLiteral("lid"), font, 1000, 1), QStringList(QStringLiteral("lid")));
        QCOMPARE(linesOf(QString(), font, 1000, 3).join(QString()), QString());
    }
};

TACTUM_GUI_TEST(TestWrappingRow)

} // namespace test_wrapping_row

#include "test_wrapping_row.moc"
