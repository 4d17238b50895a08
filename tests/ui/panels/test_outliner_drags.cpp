// Rows of the outliner that are dragged: where they come, which groups they join and leave, what the history
// says. Wrong itself if listOf() did not give the order of the scene: a drag that brings nothing would look
// like one that does.
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidgetItemIterator>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/outliner.h"

namespace test_outliner_drags {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

enum Column { kName, kEye };

/// "A, G(B C), D": the groups with what is in them, in the order of the scene.
QString listOf(const Scene& scene) {
    QString text;
    std::string last;
    for (const SceneObject& object : scene.objects) {
        if (!last.empty() && object.group != last) text += u')';
        const bool within = !object.group.empty() && object.group == last;
        if (!text.isEmpty()) text += within ? QStringLiteral(" ") : QStringLiteral(", ");
        if (!object.group.empty() && !within) text += QString::fromStdString(object.group) + u'(';
        text += QString::fromStdString(object.name);
        last = object.group;
    }
    return last.empty() ? text : text + u')';
}

/// A, the group G of B and C, D, the group H of E; D has two surfaces.
Scene groupedScene() {
    Scene scene;
    for (const auto& [name, group, surfaces] :
         {std::tuple("A", "", 1), {"B", "G", 1}, {"C", "G", 1}, {"D", "", 2}, {"E", "H", 1}}) {
        SceneObject object;
        object.name = name;
        object.group = group;
        object.geometry = plates(surfaces);
        object.surfaces.resize(std::size_t(surfaces));
        for (int i = 0; i < surfaces; ++i)
            object.surfaces[std::size_t(i)].name = object.name + std::to_string(i + 1);
        scene.add(object);
    }
    return scene;
}

/// The scene in an outliner on the screen, all of it open but the surfaces of other objects than D.
struct Listed {
    Listed() {
        adopt(document, groupedScene());
        outliner.resize(300, 500);
        outliner.show();
        if (!QTest::qWaitForWindowExposed(&outliner)) qFatal("no window");
        for (QTreeWidgetItemIterator it(&outliner); *it; ++it)
            (*it)->setExpanded((*it)->text(0) == u'D' || (*it)->text(0) == u'G' || (*it)->text(0) == u'H');
    }
    QTreeWidgetItem* row(const char* name) {
        for (QTreeWidgetItemIterator it(&outliner); *it; ++it)
            if ((*it)->text(0) == QLatin1String(name)) return *it;
        qFatal("no row %s", name);
        return nullptr;
    }
    QWidget& view() { return *outliner.viewport(); }
    QPoint middle(const char* name, int column = kName) {
        return outliner.visualRect(outliner.indexFromItem(row(name), column)).center();
    }
    /// A little above or below the edge between a row and the one above it.
    QPoint above(const char* name, int dy = 0) {
        return {middle(name).x(), outliner.visualItemRect(row(name)).top() + dy};
    }
    QPoint underAll() { return {40, view().height() - 5}; }

    void press(QPoint from, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
        mouse(view(), QEvent::MouseButtonPress, from, button, keys);
    }
    void moveTo(QPoint to, Qt::MouseButton button = Qt::LeftButton) {
        mouse(view(), QEvent::MouseMove, to, button);
    }
    void release(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
        mouse(view(), QEvent::MouseButtonRelease, at, button);
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers keys = {}) {
        press(from, button, keys), moveTo(to, button), release(to, button);
        QApplication::processEvents();
    }
    void drag(const char* name, QPoint to) { drag(middle(name), to); }
    /// By their rows, one after the other.
    void choose(std::initializer_list<const char*> names) {
        document.select({});
        for (const char* name : names)
            QTest::mouseClick(&view(), Qt::LeftButton, Qt::ControlModifier, middle(name));
    }
    QString selected() {
        QStringList names;
        for (const ObjectId id : document.selectedObjects())
            names << QString::fromStdString(document.scene().find(id)->name);
        names.sort();
        return names.join(u' ');
    }
    /// What comes of a drag: the list, what is selected, and how the history calls it. Undo brings back all.
    QString result(const char* what, const char* name, QPoint to) {
        const Scene before = document.scene();
        const int steps = document.history().index();
        drag(name, to);
        const QString step = document.history().index() == steps ? QStringLiteral("no step")
                             : document.history().index() == steps + 1
                                 ? u'"' + document.history().undoText() + u'"'
                                 : QStringLiteral("several steps");
        const QString text = QStringLiteral("%1: %2\n    %3; selected: %4\n")
                                 .arg(QLatin1String(what), listOf(document.scene()), step, selected());
        while (document.history().index() > steps)
            document.history().undo();
        return document.scene() == before ? text : text + QStringLiteral("    undo leaves something\n");
    }

    Document document;
    Outliner outliner{document};
};

} // namespace

class TestOutlinerDrags : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumOutlinerDrags"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    void rowsComeWhereTheyAreDropped() {
        Listed listed;
        QString told = listOf(listed.document.scene()) + u'\n';
        for (const auto& [what, name, to] :
             {std::tuple("A above D", "A", listed.above("D")),
              {"A a little below the edge above D", "A", listed.above("D", 3)},
              {"A between B and C", "A", listed.above("C")},
              {"A above B, in its group", "A", listed.above("B")},
              {"A onto G", "A", listed.middle("G")},
              {"A onto H, the last", "A", listed.middle("H")},
              {"A above G stays", "A", listed.above("G")},
              {"A under all", "A", listed.underAll()},
              {"B above A leaves its group", "B", listed.above("A")},
              {"B above E joins another group", "B", listed.above("E")},
              {"B onto its own group goes behind C", "B", listed.middle("G")},
              {"D above A, with its surfaces", "D", listed.above("A")},
              {"D among its own surfaces", "D", listed.middle("D2")},
              {"E under all leaves its group, which ends", "E", listed.underAll()},
              {"G under all stays a group", "G", listed.underAll()},
              {"G above A", "G", listed.above("A")},
              {"G onto H joins it", "G", listed.middle("H")},
              {"H above C comes into G", "H", listed.above("C")}})
            told += listed.result(what, name, to);
        COMPARE_SHOWN(told, "outliner-drags");
    }

    /// What is pressed takes the others along that are selected with it.
    void severalAreDraggedTogether() {
        Listed listed;
        QString told;
        const auto several = [&](const char* what, std::initializer_list<const char*> chosen,
                                 const char* name, QPoint to) {
            listed.choose(chosen);
            told += listed.result(what, name, to);
        };
        several("A and D under all, by D", {"A", "D"}, "D", listed.underAll());
        several("B and D above A, by B", {"B", "D"}, "B", listed.above("A"));
        several("B alone above A, with A and D chosen", {"A", "D"}, "B", listed.above("A"));
        several("G and A under all, by A: a group stays one", {"G", "A"}, "A", listed.underAll());
        several("G and A under all, by G", {"G", "A"}, "G", listed.underAll());
        several("A and C under all, by A: C leaves its group", {"A", "C"}, "A", listed.underAll());
        several("G above A, with E chosen", {"E"}, "G", listed.above("A"));
        COMPARE_SHOWN(told, "outliner-drags-several");
    }

    void whatIsHiddenIsNoPlace() {
        Listed listed;
        QString told;
        const auto folded = [&](const char* what, const char* name, auto to) {
            listed.row("G")->setExpanded(false); // where D comes up
            told += listed.result(what, name, to());
        };
        folded("A below the folded G", "A", [&] { return listed.above("D"); });
        folded("A onto the folded G", "A", [&] { return listed.middle("G"); });
        folded("the folded G under all", "G", [&] { return listed.underAll(); });
        listed.outliner.search(QStringLiteral("d")); // D, and its surfaces with it
        told += listed.result("D under all, the only one that is found", "D", listed.underAll());
        listed.outliner.search(QStringLiteral("nothing"));
        told += listed.result("nothing from nowhere", "A", listed.underAll());
        COMPARE_SHOWN(told, "outliner-drags-hidden");
    }

    /// Edits that build the rows anew leave groups and objects folded as they are; another scene does not.
    void whatIsFoldedStaysSo() {
        Listed listed;
        listed.row("G")->setExpanded(false);
        const auto open = [&] {
            QString names;
            for (QTreeWidgetItemIterator it(&listed.outliner); *it; ++it)
                if ((*it)->childCount() > 0 && (*it)->isExpanded()) names += (*it)->text(0);
            return names;
        };
        QCOMPARE(open(), "DH");
        listed.drag("A", listed.underAll());
        QCOMPARE(listOf(listed.document.scene()), "G(B C), D, H(E), A");
        QCOMPARE(open(), "DH");
        listed.outliner.search(QStringLiteral("1")); // what is found is seen
        QCOMPARE(open(), "GBCDHEA");
        listed.outliner.search({});
        QCOMPARE(open(), "DH");
        listed.row("D")->setExpanded(false), listed.row("E")->setExpanded(true);
        listed.document.history().undo();
        QCOMPARE(open(), "HE");
        adopt(listed.document, groupedScene());
        QCOMPARE(open(), "AGBCDHE");
    }

    void onlyRowsOfObjectsAreHeld() {
        Listed listed;
        const Scene before = listed.document.scene();
        const auto stays = [&](QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
                               Qt::KeyboardModifiers keys = {}) {
            listed.drag(from, to, button, keys);
            return listed.document.scene() == before;
        };
        const QPoint a = listed.middle("A");
        QVERIFY(stays(listed.middle("D1"), listed.above("A"))); // a surface
        QVERIFY(stays(a, listed.underAll(), Qt::RightButton));
        QVERIFY(stays(a, listed.underAll(), Qt::LeftButton, Qt::ShiftModifier));
        QVERIFY(stays(a, listed.underAll(), Qt::LeftButton, Qt::ControlModifier));
        QVERIFY(stays(listed.underAll(), listed.above("A"))); // no row
        const int near = QApplication::startDragDistance() - 1;
        QVERIFY(stays(a, a + QPoint(0, near)));
        // By its eye it is hidden, and nothing is dragged.
        listed.drag(listed.middle("A", kEye), listed.underAll());
        QCOMPARE(listOf(listed.document.scene()), listOf(before));
        listed.document.history().undo();
        QVERIFY(!stays(a, listed.underAll())); // as it is held otherwise
    }

    void theGapIsDrawn() {
        Listed listed;
        const auto drawn = [&] { return drawnBy(listed.view()); };
        const auto line = [&](int left, int y) {
            return QStringLiteral("rect filled accent (%1.0 %2.0) (%3.0 %4.0)")
                .arg(left)
                .arg(y - 1)
                .arg(listed.view().width())
                .arg(y + 1);
        };
        listed.press(listed.middle("A"));
        listed.moveTo(listed.middle("A") + QPoint(0, 2)); // hardly
        QVERIFY(listed.outliner.cursor().shape() != Qt::ClosedHandCursor);
        listed.moveTo(listed.above("D"));
        QCOMPARE(listed.outliner.cursor().shape(), Qt::ClosedHandCursor);
        COMPARE_CONTAINS(drawn(), line(0, listed.above("D").y()));
        listed.moveTo(listed.above("C"));
        COMPARE_CONTAINS(drawn(), line(2 * listed.outliner.indentation(), listed.above("C").y()));
        COMPARE_LACKS(drawn(), line(0, listed.above("D").y()));
        listed.moveTo(listed.middle("G"));
        const QRect group = listed.outliner.visualItemRect(listed.row("G")).adjusted(1, 1, -1, -1);
        COMPARE_LACKS(drawn(), QStringLiteral("rect filled accent"));
        COMPARE_CONTAINS(drawn(), QStringLiteral("rect accent 2 (%1.0 %2.0) (%3.0 %4.0)")
                                      .arg(group.left())
                                      .arg(group.top())
                                      .arg(group.right() + 1)
                                      .arg(group.bottom() + 1));
        listed.moveTo(listed.underAll());
        COMPARE_CONTAINS(drawn(), line(0, listed.outliner.visualItemRect(listed.row("E")).bottom()));
        listed.moveTo(listed.middle("A")); // back where it comes from
        listed.release(listed.middle("A"));
        QVERIFY(listed.outliner.cursor().shape() != Qt::ClosedHandCursor);
        COMPARE_LACKS(drawn(), QStringLiteral("rect filled accent"));
        listed.moveTo(listed.above("D")); // nothing is held any more
        COMPARE_LACKS(drawn(), QStringLiteral("rect filled accent"));
    }
};

TACTUM_GUI_TEST(TestOutlinerDrags)

} // namespace test_outliner_drags

#include "test_outliner_drags.moc"
