#include "ui/panels/layer_chooser.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QKeyEvent>
#include <QScreen>
#include <QVBoxLayout>

#include "ui/base/shortcuts.h"
#include "ui/base/style.h"
#include "ui/base/words.h"
#include "ui/document/preset_picture.h"
#include "ui/document/preset_store.h"
#include "ui/panels/layer_list.h"
#include "ui/widgets/picture_grid.h"

namespace tactum {

namespace {

constexpr QSize kChooser(40 * kRhythm, 52 * kRhythm);
constexpr int kChoiceRole = Qt::UserRole;

} // namespace

LayerChooser::LayerChooser(const Actions& actions, QWidget* parent)
    : QFrame(parent, Qt::Popup), actions_(actions), grid_(new PictureGrid(QStringLiteral("layers"), {})) {
    setObjectName(QStringLiteral("layer-chooser"));
    grid_->setObjectName(QStringLiteral("layer-kinds"));
    grid_->setAccessibleName(tr("Layers to add"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);
    column->addWidget(grid_);
    connect(grid_, &QListWidget::itemClicked, this, &LayerChooser::take);
    connect(grid_, &PictureGrid::pictureActivated, this, &LayerChooser::take);
}

void LayerChooser::fill() {
    grid_->clear();
    choices_.clear();
    grid_->beginGroup(QStringLiteral("patterns"), tr("Patterns"));
    offer("layer-grooves", tr("Grooves"), TextureSource::Grooves);
    offer("layer-dots", tr("Dots"), TextureSource::Dots);
    offer("layer-weave", tr("Weave"), TextureSource::Weave);
    offer("layer-noise", tr("Noise"), TextureSource::Noise);
    grid_->beginGroup(QStringLiteral("pictures"), tr("Pictures"));
    offer("layer-image", tr("From a file..."), TextureSource::Image);
    offer("layer-painted", tr("Painted by you"), TextureSource::Painted);
    offerPresets();
}

void LayerChooser::offer(const char* command, const QString& name, TextureSource source) {
    QAction& action = actions_[command];
    const TexturePattern pattern = newLayer(source, {}).pattern;
    add(name, layerThumbnail(pattern, PictureGrid::kSide, devicePixelRatioF()), action.toolTip(),
        [&action] { action.trigger(); });
}

void LayerChooser::offerPresets() {
    bool any = false;
    const auto offerAll = [&](const std::vector<Preset>& presets, bool shipped) {
        for (const Preset& preset : presets) {
            if (!preset.layers) continue;
            const QString name = shipped ? wordsOf(preset.name) : asIs(preset.name);
            for (const TextureLayer& layer : *preset.layers) {
                if (!std::exchange(any, true)) grid_->beginGroup(QStringLiteral("presets"), tr("Of presets"));
                offerOne(preset, layer, preset.layers->size() == 1 ? name : name + u' ' + asIs(layer.name));
            }
        }
    };
    offerAll(PresetStore::readOwn(), false);
    offerAll(PresetStore::readShipped(), true);
}

void LayerChooser::offerOne(const Preset& preset, const TextureLayer& layer, const QString& name) {
    QImage picture = presetPicture(preset, int(PictureGrid::kSide * devicePixelRatioF()));
    const QString words = asIs(layer.name) + QStringLiteral(": ") + targetText(layer);
    add(name, QPixmap::fromImage(picture), words, [this, layer] { emit layerChosen(layer); });
}

void LayerChooser::add(const QString& name, const QPixmap& picture, const QString& words,
                       std::function<void()> choice) {
    QListWidgetItem* item = grid_->add(name, picture);
    item->setToolTip(words);
    item->setData(Qt::AccessibleDescriptionRole, words);
    item->setData(kChoiceRole, int(choices_.size()));
    choices_.push_back(std::move(choice));
}

void LayerChooser::openUnder(const QWidget& button) {
    fill();
    resize(kChooser);
    const QRect room = button.screen()->availableGeometry();
    const QPoint corner = button.mapToGlobal(QPoint(button.width() - width(), button.height()));
    const int lowest = std::max(room.top(), room.bottom() - height());
    move(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - width())),
         std::clamp(corner.y(), room.top(), lowest));
    grid_->setCurrentItem(grid_->pictures().front());
    show();
    grid_->setFocus();
}

// Later: what is chosen may open a dialog, and the list is still speaking.
void LayerChooser::take(QListWidgetItem* item) {
    if (PictureGrid::isHeading(item) || !isVisible()) return;
    hide();
    QMetaObject::invokeMethod(this, choices_[std::size_t(item->data(kChoiceRole).toInt())],
                              Qt::QueuedConnection);
}

void LayerChooser::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return hide();
    QFrame::keyPressEvent(event);
}

} // namespace tactum
