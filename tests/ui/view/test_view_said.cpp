// What the view tells of keys, clicks and drags with each tool, and where the camera looks afterwards. Wrong
// itself if a signal had arguments that text() does not know: they would be left out.
#include <QMetaMethod>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/view/shown_ball.h"
#include "ui/view/surface_format.h"

namespace test_view_said {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

QString figure(double x) {
    return QString::number(std::abs(x) < 5e-5 ? 0 : x, 'g', 3);
}
QString text(const Vec3& v) {
    return QStringLiteral("(%1 %2 %3)").arg(figure(v.x()), figure(v.y()), figure(v.z()));
}

QString text(const QVariant& argument) {
    if (argument.canConvert<Vec3>()) return text(argument.value<Vec3>());
    if (argument.canConvert<std::optional<PickHit>>()) {
        const auto hit = argument.value<std::optional<PickHit>>();
        return hit ? QStringLiteral("surface %1").arg(hit->surface.surface) : QStringLiteral("nothing");
    }
    if (argument.canConvert<Arrangement>()) {
        const auto by = argument.value<Arrangement>();
        return QStringLiteral("move %1 turn %2 scale %3")
            .arg(text(by.move), text(Vec3(2 * by.turn.vec())), figure(by.scale));
    }
    if (argument.typeId() == QMetaType::Bool) return argument.toBool() ? "yes" : "no";
    if (argument.typeId() == QMetaType::Double) return figure(argument.toDouble());
    return {};
}

/// A view of the ball, and all that it tells.
class Heard {
public:
    Heard() {
        CameraManners manners;
        manners.flies = false;
        shown.view.setManners(manners);
        shown.view.grabPicture(); // time for what clicks need
        const QMetaObject& kind = SceneView::staticMetaObject;
        for (int i = kind.methodOffset(); i < kind.methodCount(); ++i)
            if (kind.method(i).methodType() == QMetaMethod::Signal && !isLeftOut(kind.method(i).name()))
                spies_.push_back(std::make_unique<QSignalSpy>(&shown.view, kind.method(i)));
    }

    template <class Act> void note(const QString& what, const Act& act) {
        for (const auto& spy : spies_)
            spy->clear();
        const ViewCamera before = shown.view.camera();
        act();
        QApplication::processEvents();
        text_ += what + u'\n';
        for (const auto& spy : spies_)
            for (const QVariantList& arguments : *spy) {
                QStringList words{QStringLiteral("  ") +
                                  QString::fromLatin1(spy->signal().split('(').front())};
                for (const QVariant& argument : arguments)
                    words << text(argument);
                text_ += words.join(u' ').trimmed().prepend("  ") + u'\n';
            }
        const ViewCamera& now = shown.view.camera();
        if ((now.eye() - before.eye()).norm() > 1e-6 || now.parallel != before.parallel)
            text_ += QStringLiteral("  looks along %1, %2 times as far%3\n")
                         .arg(text(now.forward()), figure(now.distance / before.distance),
                              now.parallel ? QStringLiteral(", parallel") : QString());
    }
    void keys(const QString& what, const QList<int>& pressed, Qt::KeyboardModifiers modifiers = {}) {
        note(what, [&] {
            for (const int key : pressed)
                for (const auto kind : {QEvent::KeyPress, QEvent::KeyRelease}) {
                    QKeyEvent event(kind, key, modifiers, key < 0x80 ? QString(QChar(key)) : QString());
                    QApplication::sendEvent(&shown.view, &event);
                }
        });
    }
    const QString& said() const { return text_; }

    ShownBall shown;

private:
    /// Which comes again and again while something glides, or when the pointer of the screen happens to be
    /// there.
    static bool isLeftOut(const QByteArray& signal) {
        return QByteArrayList{"handGoalMoved", "surfaceHovered", "loupeDrawn", "loupeLeft"}.contains(signal);
    }

    std::vector<std::unique_ptr<QSignalSpy>> spies_;
    QString text_;
};

const std::pair<const char*, ViewTool> kTools[] = {{"touch", ViewTool::Touch},
                                                   {"select", ViewTool::Select},
                                                   {"paint", ViewTool::Paint},
                                                   {"arrange", ViewTool::Arrange},
                                                   {"measure", ViewTool::Measure}};

} // namespace

class TestViewSaid : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void ofClicksAndDrags() {
        Heard heard;
        ShownBall& shown = heard.shown;
        const QPoint upper = kBallCentre - QPoint(0, 60), lower = kBallCentre + QPoint(0, 60), beside(40, 40);
        for (const auto& [name, tool] : kTools) {
            shown.view.setTool(tool);
            const QString with = QLatin1String(name) + QStringLiteral(": ");
            const auto click = [&](const char* what, QPoint at, Qt::MouseButton button,
                                   Qt::KeyboardModifiers keys) {
                heard.note(with + QLatin1String(what),
                           [&] { QTest::mouseClick(&shown.view, button, keys, at); });
            };
            click("a click", upper, Qt::LeftButton, {});
            click("a click with Shift", lower, Qt::LeftButton, Qt::ShiftModifier);
            click("a click with Ctrl", lower, Qt::LeftButton, Qt::ControlModifier);
            click("a click beside", beside, Qt::LeftButton, {});
            click("the right button", upper, Qt::RightButton, {});
            heard.note(with + QStringLiteral("a drag"), [&] { shown.drag(upper, lower); });
            heard.note(with + QStringLiteral("a drag beside"),
                       [&] { shown.drag(beside, beside + QPoint(48, 24)); });
            heard.note(with + QStringLiteral("with Alt"),
                       [&] { shown.drag(upper, upper + QPoint(48, 0), Qt::LeftButton, Qt::AltModifier); });
            heard.note(with + QStringLiteral("the middle button"),
                       [&] { shown.drag(upper, upper + QPoint(0, 48), Qt::MiddleButton); });
            heard.note(with + QStringLiteral("the middle button with Shift"), [&] {
                shown.drag(upper, upper + QPoint(0, 48), Qt::MiddleButton, Qt::ShiftModifier);
            });
            heard.note(with + QStringLiteral("the wheel"), [&] { shown.wheel(beside, 2); });
            shown.waitForHand();
            shown.view.showStandardView(StandardView::Front);
            shown.view.fit();
        }
        for (const auto& [name, shape] :
             {std::pair("a box", RegionShape::Box), {"a lasso", RegionShape::Lasso}}) {
            shown.view.setTool(ViewTool::Select);
            shown.view.beginRegion(shape);
            heard.note(QLatin1String(name), [&] { shown.drag(beside, lower); });
            shown.view.beginRegion(shape);
            heard.keys(QLatin1String(name) + QStringLiteral(", Esc"), {Qt::Key_Escape});
            heard.note(QStringLiteral("given up"), [&] { shown.drag(beside, beside + QPoint(3, 40)); });
        }
        shown.view.setSelectBrush(20);
        heard.note(QStringLiteral("the brush"), [&] { shown.drag(upper, lower); });
        heard.keys(QStringLiteral("the brush, Esc"), {Qt::Key_Escape});
        COMPARE_SHOWN(heard.said(), "said-clicks");
    }

    void ofKeys() {
        Heard heard;
        SceneView& view = heard.shown.view;
        const int enter = Qt::Key_Return, escape = Qt::Key_Escape;
        for (const auto& [name, tool] : kTools) {
            view.setTool(tool);
            heard.keys(QStringLiteral("%1: G, Esc").arg(QLatin1String(name)), {Qt::Key_G, escape});
            heard.keys(QStringLiteral("%1: R, S, Esc").arg(QLatin1String(name)),
                       {Qt::Key_R, Qt::Key_S, escape});
        }
        view.setTool(ViewTool::Arrange);
        view.setArranging(Pose{Quat::Identity(), {0.01, 0, 0}});
        for (const auto& [name, first] : {std::pair("G", Qt::Key_G), {"R", Qt::Key_R}, {"S", Qt::Key_S}}) {
            for (const auto& [axis, second] : {std::pair("X", Qt::Key_X), {"Y", Qt::Key_Y}, {"Z", Qt::Key_Z}})
                heard.keys(QStringLiteral("%1 %2 3 . 5 Enter").arg(QLatin1String(name), QLatin1String(axis)),
                           {first, second, Qt::Key_3, Qt::Key_Period, Qt::Key_5, enter});
            heard.keys(QStringLiteral("%1 - 2 Esc").arg(QLatin1String(name)),
                       {first, Qt::Key_Minus, Qt::Key_2, escape});
            heard.keys(QStringLiteral("%1 X X 2 Enter").arg(QLatin1String(name)),
                       {first, Qt::Key_X, Qt::Key_X, Qt::Key_2, enter});
        }
        view.setTool(ViewTool::Touch);
        for (const int key : {Qt::Key_1, Qt::Key_3, Qt::Key_7, Qt::Key_0, Qt::Key_9}) {
            heard.keys(QStringLiteral("pad ") + QChar(key), {key}, Qt::KeypadModifier);
            heard.keys(QChar(key), {key});
        }
        const Vec3 goal(0, 0, 0.1);
        for (const auto& [name, key] : {std::pair("left", Qt::Key_Left),
                                        {"right", Qt::Key_Right},
                                        {"up", Qt::Key_Up},
                                        {"down", Qt::Key_Down},
                                        {"page up", Qt::Key_PageUp},
                                        {"page down", Qt::Key_PageDown}})
            for (const auto keys : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier)}) {
                view.showStandardView(StandardView::Front);
                view.setHandGoal(goal);
                heard.keys(QLatin1String(name) + (keys ? " with Shift" : ""), {key}, keys);
                nudges_ << QStringLiteral("%1%2: %3")
                               .arg(QLatin1String(name), keys ? QStringLiteral(" fine") : QString(),
                                    text(Vec3(view.handGoal() - goal)));
            }
        heard.keys(QStringLiteral("Home"), {Qt::Key_Home});
        COMPARE_SHOWN(heard.said() + nudges_.join(u'\n'), "said-keys");
    }

    /// Of drags from elsewhere, double clicks, the key for menus and a pointer that leaves.
    void ofWhatComesFromElsewhere() {
        Heard heard;
        SceneView& view = heard.shown.view;
        const QPoint upper = kBallCentre - QPoint(0, 60), beside(40, 40);
        view.setDropTypes({QStringLiteral("text/mine")});
        QMimeData mine, other;
        mine.setData(QStringLiteral("text/mine"), "it");
        other.setData(QStringLiteral("text/other"), "it");
        QString taken;
        const auto send = [&](const char* words, auto&& event) {
            heard.note(QLatin1String(words), [&] {
                event.ignore();
                QApplication::sendEvent(&view, &event);
            });
            taken +=
                QStringLiteral("%1: %2\n").arg(QLatin1String(words), event.isAccepted() ? "taken" : "left");
        };
        send("mine comes in", QDragEnterEvent(upper, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        send("it is over the model", QDragMoveEvent(upper, Qt::MoveAction, &mine, Qt::LeftButton, {}));
        send("it is beside", QDragMoveEvent(beside, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        send("it is let go there", QDropEvent(beside, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        // Qt drops where it has entered.
        send("it comes again", QDragEnterEvent(upper, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        send("it is let go on the model", QDropEvent(upper, Qt::MoveAction, &mine, Qt::LeftButton, {}));
        send("once more", QDragEnterEvent(upper, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        send("it is over the model again", QDragMoveEvent(upper, Qt::CopyAction, &mine, Qt::LeftButton, {}));
        send("it leaves", QDragLeaveEvent());
        send("another kind", QDragEnterEvent(upper, Qt::CopyAction, &other, Qt::LeftButton, {}));
        view.setDropTypes({});
        QVERIFY(!view.acceptDrops());
        for (const auto& [name, tool] : kTools) {
            view.setTool(tool);
            heard.note(QStringLiteral("%1: a double click").arg(QLatin1String(name)),
                       [&] { QTest::mouseDClick(&view, Qt::LeftButton, {}, upper); });
            view.setDoubleClick([](const PickHit&) { return true; });
            heard.note(QStringLiteral("%1: one that is taken").arg(QLatin1String(name)),
                       [&] { QTest::mouseDClick(&view, Qt::LeftButton, {}, upper); });
            view.setDoubleClick([](const PickHit&) { return false; });
            heard.shown.waitForHand();
        }
        view.setTool(ViewTool::Select);
        for (const auto reason : {QContextMenuEvent::Keyboard, QContextMenuEvent::Mouse})
            send(reason == QContextMenuEvent::Mouse ? "a menu by the mouse" : "a menu by its key",
                 QContextMenuEvent(reason, upper, view.mapToGlobal(upper)));
        COMPARE_SHOWN(heard.said() + taken, "said-elsewhere");
    }

private:
    QStringList nudges_;
};

TACTUM_GUI_TEST(TestViewSaid)

} // namespace test_view_said

#include "test_view_said.moc"
