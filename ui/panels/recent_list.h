// The files opened last, with pictures: a click opens one.
#pragma once

#include <QWidget>

#include "ui/document/recent_files.h"

namespace tactum {

class CardGrid;
class PictureCard;
struct RecentLook;

class RecentList : public QWidget {
    Q_OBJECT
public:
    explicit RecentList(QWidget* parent = nullptr);

    /// Nothing is seen where there is none. Who has the keys in the list keeps them at its place.
    void setFiles(const QList<RecentFile>& files);
    /// What was found of some of them.
    void setLooks(const QList<RecentLook>& looks);

signals:
    void fileChosen(const QString& file);
    void removeAsked(const QString& file);

private:
    PictureCard* cardOf(const RecentFile& file);
    int focused() const;

    CardGrid* grid_;
    QList<RecentFile> files_;
    QList<PictureCard*> cards_; ///< as many
};

} // namespace tactum
