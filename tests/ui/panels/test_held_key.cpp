// A key that is held down, told from a tap by what the window has heard of it.
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QWidget>

#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "ui/engine/held_key.h"

namespace test_held_key {

using namespace tactum;

class TestHeldKey : public QObject {
    Q_OBJECT

    static constexpr int kTime = 200; // ms
    QWidget window_;

    void press() { QTest::keyPress(&window_, Qt::Key_Escape); }
    void release() { QTest::keyRelease(&window_, Qt::Key_Escape); }

private slots:
    void isToldOnceOfAHold() {
        HeldKey key(Qt::Key_Escape, kTime);
        QSignalSpy held(&key, &HeldKey::held);
        press();
        QCOMPARE(held.count(), 0);
        QVERIFY(test::waitFor([&] { return held.count() == 1; }));
        QTest::qWait(2 * kTime);
        release();
        QCOMPARE(held.count(), 1);
    }

    void aTapIsNone() {
        HeldKey key(Qt::Key_Escape, kTime);
        QSignalSpy held(&key, &HeldKey::held);
        press();
        release();
        QTest::qWait(2 * kTime);
        QCOMPARE(held.count(), 0);
    }

    // A menu takes the release with it; that it is held still its repetitions say.
    void aTapThatClosesAMenuIsNone() {
        HeldKey key(Qt::Key_Escape, kTime);
        QSignalSpy held(&key, &HeldKey::held);
        window_.show();
        QMenu menu(&window_);
        menu.addAction(QStringLiteral("one"));
        menu.popup({20, 20});
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        QTest::keyPress(&menu, Qt::Key_Escape);
        QVERIFY(!menu.isVisible());
        QTest::qWait(3 * kTime);
        QCOMPARE(held.count(), 0);
        QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, {}, {}, true);
        QApplication::sendEvent(&window_, &again);
        QVERIFY(test::waitFor([&] { return held.count() == 1; }));
        release();
    }

    // The tap itself may begin what takes long: leaving the full screen for one. Its release waits meanwhile.
    void aTapIsNoneHoweverBusyTheWindowIs() {
        for (const int busy : {kTime - 20, kTime + 100, 5 * kTime}) {
            HeldKey key(Qt::Key_Escape, kTime);
            QSignalSpy held(&key, &HeldKey::held);
            press();
            QThread::msleep(std::uint64_t(busy));
            QTimer::singleShot(1, &key, [&] { release(); }); // heard after what is due by then
            QTest::qWait(2 * kTime);
            QCOMPARE(held.count(), 0);
        }
    }

    void aHoldIsToldAlsoByABusyWindow() {
        HeldKey key(Qt::Key_Escape, kTime);
        QSignalSpy held(&key, &HeldKey::held);
        press();
        QThread::msleep(3 * kTime);
        QVERIFY(test::waitFor([&] { return held.count() == 1; }));
        release();
    }
};

TACTUM_GUI_TEST(TestHeldKey)

} // namespace test_held_key

#include "test_held_key.moc"
