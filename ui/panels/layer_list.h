// The layers of a surface as a list, topmost first: thumbnail, name, eye, solo; dragged into another order.
#pragma once

#include <optional>
#include <vector>

#include <QPixmap>

#include "ui/document/layer_edits.h"
#include "ui/widgets/hinted_tree.h"

namespace tactum {

/// A square of `side` logical pixels: the pattern, or an icon where that cannot be shown.
QPixmap layerThumbnail(const TexturePattern& pattern, int side, qreal ratio);

/// Speaks of layers by their numbers in the scene, where 0 lies at the bottom. Changes nothing itself: it
/// says what a person asked for. Thread: ui.
class LayerList : public HintedTree {
    Q_OBJECT
public:
    static constexpr int kThumbnail = 32; ///< logical pixels

    explicit LayerList(QWidget* parent = nullptr);

    /// Rows that are there already stay, with whoever edits a name in them. `solo`: the layer that is felt
    /// alone.
    void display(const TextureLayers& layers, std::optional<int> current, std::optional<int> solo);
    /// As high as so many rows.
    void setRows(int rows);
    /// The picture of a layer's row.
    QPixmap thumbnail(int layer) const;
    /// Begins to edit the name of a layer.
    void editName(int layer);

signals:
    void chosen(int layer);
    void renameAsked(int layer, const QString& name);
    void showAsked(int layer); ///< the eye: to be felt or not
    void soloAsked(int layer);
    void moveAsked(int layer, int to);
    void removeAsked();
    void duplicateAsked();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override; ///< another theme

private:
    int layerOf(int row) const { return topLevelItemCount() - 1 - row; }
    int currentLayer() const;
    void fill(QTreeWidgetItem& item, const TextureLayer& layer, bool isSolo, bool isFelt);
    void fillIcons();
    QPixmap pictureOf(const TexturePattern& pattern);
    int gapAt(int y) const;
    void click(QTreeWidgetItem* item, int column);

    struct Picture {
        TexturePattern pattern;
        QPixmap pixmap;
    };
    std::vector<Picture> pictures_; ///< of the rows that were shown last
    TextureLayers layers_;
    std::optional<int> solo_;
    bool filling_ = false;
    int pressedRow_ = -1;
    QPoint pressedAt_;
    std::optional<int> gap_; ///< where a dragged row would go: above the row of this number
};

} // namespace tactum
