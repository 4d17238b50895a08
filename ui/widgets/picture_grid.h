// Pictures with their names beneath, in as many columns as fit, under headings that fold.
#pragma once

#include <QListWidget>
#include <QSet>

namespace tactum {

/// Arrows lead from picture to picture and over the headings, Enter chooses a picture or folds what is under
/// a heading. Letters lead to a name where the person came by keys; who clicked has the mouse in the hand,
/// and letters are the window's commands. Which groups are folded is kept in the settings. Thread: ui.
class PictureGrid : public QListWidget {
    Q_OBJECT
public:
    static constexpr int kSide = 48; ///< of a picture, logical pixels

    /// `settings`: under which key the folds are kept. `hint`: what is said while nothing is shown.
    PictureGrid(const QString& settings, const QString& hint, QWidget* parent = nullptr);

    /// What is added from now on stands under this heading. The key is the same in every language.
    void beginGroup(const QString& key, const QString& title);
    QListWidgetItem* add(const QString& name, const QPixmap& picture);
    /// While something is searched for everything that was found is seen.
    void setAllOpen(bool open);

    /// In their order, whether they are folded or not.
    QList<QListWidgetItem*> pictures() const;
    QList<QListWidgetItem*> headings() const;
    static bool isHeading(const QListWidgetItem* item);
    bool isFolded(const QListWidgetItem* heading) const;
    void setFolded(QListWidgetItem* heading, bool folded);

    int cellWidth() const;

signals:
    /// Double click or Enter on a picture.
    void pictureActivated(QListWidgetItem* item);

protected:
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override; ///< another font has cells of another height

private:
    void showFolds();
    QListWidgetItem* headingOf(const QListWidgetItem* item) const;
    QModelIndex nextSeen(int step) const;
    QModelIndex nextRow(int step);

    QString settings_, hint_;
    QSet<QString> folded_;
    bool allOpen_ = false;
    bool typesAhead_ = false;
    int column_ = 0; ///< the abscissa that up and down keep to
};

} // namespace tactum
