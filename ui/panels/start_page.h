// What is shown while no scene is open: how to begin.
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace tactum {

class RecentList;

class StartPage : public QWidget {
    Q_OBJECT
public:
    /// `samples`: scenes to try, each with a picture beside it.
    explicit StartPage(const QStringList& samples, QWidget* parent = nullptr);

    RecentList& recent() { return *recent_; }

signals:
    void openRequested();
    void newRequested();
    void fileChosen(const QString& file);

private:
    void addHeading();
    void addButtons();
    void addSamples(const QStringList& samples);

    QVBoxLayout* column_;
    RecentList* recent_;
};

} // namespace tactum
