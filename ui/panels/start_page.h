// What is shown while no scene is open: how to begin.
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace tactum {

class StartPage : public QWidget {
    Q_OBJECT
public:
    /// `sample`: a file to try, empty when there is none.
    explicit StartPage(const QString& sample, QWidget* parent = nullptr);

    void setRecent(const QStringList& files);

signals:
    void openRequested();
    void fileChosen(const QString& file);

private:
    void addHeading();
    void addButtons(const QString& sample);

    QVBoxLayout* column_;
    QWidget* recent_;
};

} // namespace tactum
