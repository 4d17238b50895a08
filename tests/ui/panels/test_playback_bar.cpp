// The time line of a recording: where it is taken to by hand and keys, what it says of a moment.
#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/showing/playback_bar.h"
#include "ui/widgets/scrubber.h"

namespace test_playback_bar {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

void mouse(QWidget& widget, QEvent::Type what, double x, Qt::MouseButton button = Qt::LeftButton) {
    QMouseEvent event(what, QPointF(x, 14), widget.mapToGlobal(QPointF(x, 14)),
                      what == QEvent::MouseMove ? Qt::NoButton : button,
                      what == QEvent::MouseButtonRelease ? Qt::MouseButtons() : button, {});
    QApplication::sendEvent(&widget, &event);
}

QString tipAt(QWidget& widget, int x) {
    QToolTip::hideText();
    QHelpEvent event(QEvent::ToolTip, {x, 14}, widget.mapToGlobal(QPoint(x, 14)));
    QApplication::sendEvent(&widget, &event);
    return QToolTip::text();
}

/// Ten seconds over 200 pixels, from 6 on.
struct Line {
    Line() {
        scrubber.resize(212, 28);
        scrubber.setRecording(10, {{1, false, QStringLiteral("edit")},
                                   {5, true, QStringLiteral("stall")},
                                   {5.1, false, QStringLiteral("armed")}});
        QObject::connect(&scrubber, &Scrubber::moved, &scrubber,
                         [this](double time, bool resting) { told.emplace_back(time, resting); });
    }
    Scrubber scrubber;
    std::vector<std::pair<double, bool>> told;
};

} // namespace

class TestPlaybackBar : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumPlayback"); }

private slots:
    void initTestCase() {
        applyTheme(ThemeChoice::Dark);
        speakEnglish();
    }

    void aTimeIsTakenByHand() {
        Line line;
        Scrubber& s = line.scrubber;
        s.display(3);
        QCOMPARE(s.time(), 3.0);
        QVERIFY(line.told.empty());
        mouse(s, QEvent::MouseMove, 50); // not held
        mouse(s, QEvent::MouseButtonPress, 50, Qt::RightButton);
        QVERIFY(!s.isHeld());
        QVERIFY(line.told.empty());
        mouse(s, QEvent::MouseButtonPress, 106);
        QVERIFY(s.isHeld());
        QCOMPARE(line.told.back(), std::pair(5.0, false));
        s.display(9); // the hand knows better
        QCOMPARE(s.time(), 5.0);
        mouse(s, QEvent::MouseMove, 126);
        QCOMPARE(line.told.back(), std::pair(6.0, false));
        mouse(s, QEvent::MouseButtonRelease, 126, Qt::RightButton);
        QVERIFY(s.isHeld());
        mouse(s, QEvent::MouseMove, 1000);
        QCOMPARE(line.told.back(), std::pair(10.0, false));
        mouse(s, QEvent::MouseButtonRelease, -50);
        QCOMPARE(line.told.back(), std::pair(0.0, true));
        QVERIFY(!s.isHeld());
        const std::size_t count = line.told.size();
        mouse(s, QEvent::MouseButtonRelease, 50); // was not held
        QCOMPARE(line.told.size(), count);
        mouse(s, QEvent::MouseButtonPress, 106);
        s.setRecording(4, {}); // another recording lets go
        QVERIFY(!s.isHeld());
        QCOMPARE(s.time(), 0.0);
    }

    void keysGoByHundredthsAndSeconds() {
        Line line;
        Scrubber& s = line.scrubber;
        s.display(5);
        for (const auto& [key, time] : {std::pair(Qt::Key_Left, 4.99),
                                        {Qt::Key_Right, 5.0},
                                        {Qt::Key_PageUp, 6.0},
                                        {Qt::Key_PageDown, 5.0},
                                        {Qt::Key_End, 10.0},
                                        {Qt::Key_Right, 10.0},
                                        {Qt::Key_PageUp, 10.0},
                                        {Qt::Key_Home, 0.0},
                                        {Qt::Key_Left, 0.0},
                                        {Qt::Key_PageDown, 0.0}}) {
            QTest::keyClick(&s, key);
            COMPARE_NEAR(line.told.back().first, time, 1e-9, "s");
            QCOMPARE(line.told.back().second, true);
            COMPARE_NEAR(s.time(), time, 1e-9, "s");
        }
        const std::size_t count = line.told.size();
        QTest::keyClick(&s, Qt::Key_A);
        QCOMPARE(line.told.size(), count);
    }

    void marksTellWhatHappened() {
        Line line;
        Scrubber& s = line.scrubber;
        QCOMPARE(tipAt(s, 26), "1.00 s: edit"); // the mark is at 26
        QCOMPARE(tipAt(s, 21), "1.00 s: edit");
        QCOMPARE(tipAt(s, 31), "1.00 s: edit");
        QCOMPARE(tipAt(s, 32), "1.30 s");
        QCOMPARE(tipAt(s, 20), "0.70 s");
        QCOMPARE(tipAt(s, 106), "5.00 s: stall");
        QCOMPARE(tipAt(s, 109), "5.00 s: stall"); // a fault among ticks
        QCOMPARE(tipAt(s, 112), "5.10 s: armed");
        QCOMPARE(tipAt(s, 206), "10.00 s");
        s.setRecording(10, {{1, false, QStringLiteral("a")}, {1.3, false, QStringLiteral("b")}});
        QCOMPARE(tipAt(s, 27), "1.00 s: a"); // the nearer one
        QCOMPARE(tipAt(s, 30), "1.30 s: b");
    }

    void theLineIsDrawn() {
        Line line;
        line.scrubber.display(2.5);
        COMPARE_SHOWN(shownIn(line.scrubber) + drawnBy(line.scrubber), "scrubber");
        line.scrubber.setRecording(0, {});
        COMPARE_SHOWN(drawnBy(line.scrubber), "scrubber-empty");
        QCOMPARE(line.scrubber.sizeHint(), QSize(320, 28));
        QCOMPARE(line.scrubber.minimumSizeHint(), QSize(120, 28));
    }

    void theBarTellsTheMoment() {
        PlaybackBar bar;
        bar.resize(1200, 60);
        QVERIFY(bar.isHidden());
        bar.setRecording(12.5, {{101.25, false, "Forces on"}, {103.5, true, "Too fast"}}, 100);
        bar.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bar));
        ReplayCheck check;
        bar.display(0.5, false, check);
        COMPARE_SHOWN(shownIn(bar), "playback-begin");
        bar.display(1.25, true, check);
        COMPARE_SHOWN(shownIn(bar), "playback-event");
        check.differ = 3;
        check.first = "step 7: the force";
        bar.display(4, true, check);
        COMPARE_SHOWN(shownIn(bar), "playback-differs");
        check = {};
        bar.display(3.49, false, check);
        QCOMPARE(bar.findChild<QLabel*>(QStringLiteral("playback-event"))->toolTip(), "1.25 s: Forces on");
        QCOMPARE(bar.findChild<QLabel*>(QStringLiteral("playback-verdict"))->property("fault").toBool(),
                 false);
        QCOMPARE(bar.findChild<QToolButton*>(QStringLiteral("playback-play"))->toolTip(), "Play (Space)");
        auto& scrubber = *bar.findChild<Scrubber*>();
        QCOMPARE(scrubber.time(), 3.49);
        QVERIFY(!bar.isHeld());
        QSignalSpy played(&bar, &PlaybackBar::playToggled), sought(&bar, &PlaybackBar::soughtTo),
            left(&bar, &PlaybackBar::left);
        bar.findChild<QToolButton*>(QStringLiteral("playback-play"))->click();
        bar.findChild<QPushButton*>(QStringLiteral("playback-back"))->click();
        QTest::keyClick(&scrubber, Qt::Key_End);
        QCOMPARE(played.size(), 1);
        QCOMPARE(left.size(), 1);
        QCOMPARE(sought.size(), 1);
        QCOMPARE(sought[0][0].toDouble(), 12.5);
        QCOMPARE(sought[0][1].toBool(), true);
    }

    void theSpeedIsOneOfSix() {
        PlaybackBar bar;
        QCOMPARE(bar.speed(), 1.0);
        std::vector<double> speeds;
        for (int i = 0; i < 4; ++i) {
            bar.changeSpeed(1);
            speeds.push_back(bar.speed());
        }
        for (int i = 0; i < 6; ++i) {
            bar.changeSpeed(-1);
            speeds.push_back(bar.speed());
        }
        QCOMPARE(speeds, (std::vector<double>{2, 4, 4, 4, 2, 1, 0.5, 0.25, 0.1, 0.1}));
        bar.setRecording(1, {}, 0);
        QCOMPARE(bar.speed(), 1.0); // anew with each recording
    }
};

TACTUM_GUI_TEST(TestPlaybackBar)

} // namespace test_playback_bar

#include "test_playback_bar.moc"
