// What a layer can be made of, as pictures: what is offered, what a choice does, and where it opens. Wrong
// itself if the preset here had no layers: what is chosen of it is held against them.
#include <QAction>
#include <QApplication>
#include <QPushButton>
#include <QScreen>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/shortcuts.h"
#include "ui/document/preset_store.h"
#include "ui/panels/layer_chooser.h"
#include "ui/widgets/picture_grid.h"

namespace test_layer_chooser {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// Noise, and dots for the friction.
TextureLayers layers() {
    TextureLayers made(2);
    made[0].name = "Noise";
    made[1].name = "Dots";
    made[1].pattern.source = TextureSource::Dots;
    made[1].target = TextureTarget::StaticFriction;
    made[1].strength = 0.5;
    return made;
}

} // namespace

class TestLayerChooser : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void initTestCase() {
        useFoldersIn(folder_.path());
        applyTheme(ThemeChoice::Dark);
    }

    /// Patterns and pictures are commands of the table; a preset's layer is given as it is there.
    void theChooserOffersLayers() {
        Preset own;
        own.name = "Mine";
        own.layers = layers();
        QVERIFY(!PresetStore().add(own).isEmpty());
        Actions actions;
        QStringList told;
        for (const char* id :
             {"layer-grooves", "layer-dots", "layer-weave", "layer-noise", "layer-image", "layer-painted"})
            connect(&actions[id], &QAction::triggered, this, [&told, id] { told << QLatin1String(id); });
        QWidget window;
        QPushButton button(&window);
        window.resize(300, 100), button.setGeometry(200, 20, 60, 24);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        LayerChooser chooser(actions, &window);
        connect(&chooser, &LayerChooser::layerChosen, this, [&](const TextureLayer& layer) {
            told << QString::fromStdString(layer.name) +
                        (layer == layers()[1] ? QStringLiteral(" of Mine") : QString());
        });
        auto& grid = part<PictureGrid>(chooser, "layer-kinds");
        const auto open = [&] {
            chooser.openUnder(button);
            QVERIFY(QTest::qWaitForWindowExposed(&chooser));
        };
        open();
        QString offered;
        for (int i = 0; i < grid.count() && !offered.contains(QStringLiteral("Mine Dots")); ++i) {
            const QListWidgetItem* item = grid.item(i);
            if (PictureGrid::isHeading(item)) {
                offered += item->data(Qt::AccessibleTextRole).toString() + u'\n';
                continue;
            }
            const QSize size =
                item->data(Qt::DecorationRole).value<QPixmap>().deviceIndependentSize().toSize();
            QCOMPARE(size, QSize(PictureGrid::kSide, PictureGrid::kSide));
            offered += QStringLiteral("  %1: %2\n").arg(item->text(), item->toolTip());
        }
        COMPARE_SHOWN(offered, "layer-chooser");
        QVERIFY(grid.hasFocus());
        QCOMPARE(grid.currentItem(), grid.pictures().front());
        const auto told1 = [&] {
            QApplication::processEvents();
            return std::exchange(told, {}).join(u',');
        };
        const auto click = [&](QListWidgetItem* item) {
            grid.scrollToItem(item);
            QTest::mouseClick(grid.viewport(), Qt::LeftButton, {}, grid.visualItemRect(item).center());
        };
        const auto pictureOf = [&](const char* name) {
            return grid.findItems(QString::fromUtf8(name), Qt::MatchExactly).value(0);
        };
        for (const auto& [name, command] : {std::pair("Grooves", "layer-grooves"),
                                            {"Dots", "layer-dots"},
                                            {"Weave", "layer-weave"},
                                            {"Noise", "layer-noise"},
                                            {"From a file...", "layer-image"},
                                            {"Painted by you", "layer-painted"}}) {
            click(pictureOf(name));
            QVERIFY(!chooser.isVisible());
            QCOMPARE(told1(), QLatin1String(command));
            open();
        }
        click(pictureOf("Mine Dots"));
        QCOMPARE(told1(), "Dots of Mine");
        open();
        QTest::keyClick(&grid, Qt::Key_Return); // the first is the current one
        QCOMPARE(told1(), "layer-grooves");
        open();
        click(grid.headings().front()); // folds
        QVERIFY(chooser.isVisible());
        QVERIFY(grid.isFolded(grid.headings().front()));
        click(grid.headings().front());
        QTest::keyClick(&grid, Qt::Key_Escape);
        QVERIFY(!chooser.isVisible());
        emit grid.pictureActivated(grid.pictures().front()); // what is closed chooses nothing
        QCOMPARE(told1(), "");
    }

    /// Under the button, its right edge at the button's, and all of it on the screen.
    void theChooserStaysOnTheScreen() {
        Actions actions;
        QWidget window(nullptr, Qt::FramelessWindowHint);
        QPushButton button(&window);
        window.resize(60, 24), button.resize(60, 24);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        LayerChooser chooser(actions, &window);
        const QRect room = window.screen()->availableGeometry();
        const QSize size(320, 416);
        const auto cornerFor = [&](QPoint at) {
            window.move(at);
            chooser.openUnder(button);
            const QRect box = chooser.geometry();
            chooser.hide();
            return box;
        };
        QCOMPARE(cornerFor({700, 100}), QRect(QPoint(700 + 60 - size.width(), 124), size));
        QCOMPARE(cornerFor({100, 100}), QRect(QPoint(room.left(), 124), size));
        QCOMPARE(cornerFor({700, room.bottom() - 24}),
                 QRect(QPoint(440, room.bottom() - size.height()), size));
    }
};

TACTUM_GUI_TEST(TestLayerChooser)

} // namespace test_layer_chooser

#include "test_layer_chooser.moc"
