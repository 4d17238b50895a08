#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/base/theme.h"
#include "ui/view/surface_format.h"
#include "ui/view/touch_picture.h"

namespace test_touch_picture {

using namespace tactum;
using namespace tactum::testing;

namespace {

/// A finger that goes round inside the ball, the proxy on it.
TouchTrace circle() {
    TouchTrace rows;
    for (int i = 0; i < 1000; ++i) {
        TouchRow row;
        row.t = 1e-3 * i;
        const Vec3 out = Vec3(std::sin(6.28e-3 * i), 0.6, std::cos(6.28e-3 * i)).normalized();
        row.proxy = (kBallRadius + 1e-3) * out;
        row.finger = 0.9 * kBallRadius * out;
        row.force = 3 * out;
        row.contacts = 1;
        rows.push_back(row);
    }
    return rows;
}

bool isNear(const QColor& a, const QColor& b, int tolerance) {
    return std::abs(a.red() - b.red()) < tolerance && std::abs(a.green() - b.green()) < tolerance &&
           std::abs(a.blue() - b.blue()) < tolerance;
}

int count(const QImage& image, const QRect& part, const QColor& colour) {
    int n = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            n += isNear(image.pixelColor(x, y), colour, 40);
    return n;
}

int countBluish(const QImage& image, const QRect& part) {
    int n = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            n += image.pixelColor(x, y).blue() > image.pixelColor(x, y).red() + 40;
    return n;
}

} // namespace

class TestTouchPicture : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void showsBothPathsAndTheForce() {
        QTemporaryDir folder;
        const auto file = std::filesystem::path(folder.path().toStdString()) / "touch.png";
        VERIFY_RESULT(writeTouchPicture(ballScene(), circle(), file, {800, 600}));
        const QImage picture(QString::fromStdString(file.string()));
        QCOMPARE(picture.size(), QSize(800, 600));
        const QRect middle(200, 80, 400, 320), plot(60, 430, 700, 130);
        QCOMPARE_GT(count(picture, middle, kLightTheme.proxy), 200);
        QCOMPARE_GT(countBluish(picture, middle), 100); // dimmed by the ball that it is in
        QCOMPARE_GT(count(picture, plot, kLightTheme.proxy), 500);
        // The ball stands in the middle of a background that is brighter.
        QCOMPARE_LT(picture.pixelColor(400, 260).lightness() + 15, picture.pixelColor(20, 200).lightness());
    }

    void aTraceWithoutRowsIsTheInputsFault() {
        const auto result = writeTouchPicture(ballScene(), {}, "unused.png", {800, 600});
        QVERIFY(!result);
        QCOMPARE_EQ(result.error().kind, Error::Kind::Input);
    }

    void aFolderThatIsNotThereIsNamed() {
        const auto result = writeTouchPicture(ballScene(), circle(), "/nowhere/touch.png", {400, 300});
        QVERIFY(!result);
        QCOMPARE_EQ(result.error().kind, Error::Kind::Machine);
        COMPARE_CONTAINS(result.error().text, "/nowhere/touch.png");
    }

    void anEmptySceneAndAFingerAtRestAreDrawn() {
        QTemporaryDir folder;
        const auto file = std::filesystem::path(folder.path().toStdString()) / "rest.png";
        VERIFY_RESULT(writeTouchPicture(Scene{}, TouchTrace(5), file, {400, 300}));
        QVERIFY(!QImage(QString::fromStdString(file.string())).isNull());
    }
};

TACTUM_GUI_TEST(TestTouchPicture)

} // namespace test_touch_picture

#include "test_touch_picture.moc"
