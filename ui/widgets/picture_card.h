// A picture with a title and a few words beside it, to be chosen; and cards in as many columns as fit.
#pragma once

#include <memory>

#include <QImage>
#include <QStringList>
#include <QToolButton>

class QGridLayout;
class QMovie;

namespace tactum {

class PictureCard : public QToolButton {
    Q_OBJECT
public:
    static constexpr QSize kPicture{112, 84}; ///< logical pixels

    explicit PictureCard(const QString& title, QWidget* parent = nullptr);
    ~PictureCard() override;

    /// Null: the place stays empty.
    void setPicture(const QPixmap& picture);
    /// The file of what is seen instead while the mouse or the keys are on the card. Still where the desktop
    /// wants nothing to move.
    void setMoving(const QString& file);
    bool moves() const { return movie_ != nullptr; }
    /// One text in as many lines as fit, or several, each in a line of its own. A screen reader says them
    /// too.
    void setDetails(const QStringList& details);
    const QStringList& details() const { return details_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    void paintPicture(QPainter& painter, const QRect& place);
    void paintDetails(QPainter& painter, const QRect& room) const;
    void play(bool on);

    QStringList details_;
    QString moving_;
    std::unique_ptr<QMovie> movie_; ///< null: the still picture
};

class CardGrid : public QWidget {
    Q_OBJECT
public:
    explicit CardGrid(QWidget* parent = nullptr);

    void add(QWidget* card);
    /// They are deleted when the event that is handled now is over: one of them may have asked for it.
    void clear();
    const QList<QWidget*>& cards() const { return cards_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    int columns() const;
    void arrange();

    QGridLayout* grid_;
    QList<QWidget*> cards_;
    int arranged_ = 0; ///< in so many columns
};

} // namespace tactum
