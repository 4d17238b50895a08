// The dock "Presets": search, pictures by category, and where each value comes from.
#pragma once

#include <QByteArray>
#include <QString>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QListWidgetItem;
class QScrollArea;
class QToolButton;

namespace tactum {

class PresetGrid;
class PresetStore;
struct StoredPreset;

/// Of what is dragged out of the list: the text of the preset's file.
inline constexpr const char* kPresetMime = "application/x-tactum-preset";

/// Thread: ui.
class PresetLibrary : public QWidget {
    Q_OBJECT
public:
    explicit PresetLibrary(PresetStore& store, QWidget* parent = nullptr);

    /// The one that is chosen; null for none.
    const StoredPreset* chosen() const;
    /// Once it has been read.
    void choose(const QString& file);
    /// What is done with the chosen preset, as a menu of the pictures and as buttons.
    void addActions(QAction* apply, QAction* save, const QList<QAction*>& others);

signals:
    void chosenChanged();
    /// Double click or Enter.
    void applyAsked();
    void removed(const QString& name);

protected:
    void changeEvent(QEvent* event) override;                   ///< another theme
    bool eventFilter(QObject* watched, QEvent* event) override; ///< down from the search to the pictures

private:
    void makeDetails();
    void connectAll();
    void fill();
    QListWidgetItem* addPicture(const StoredPreset& stored);
    void showChosen();
    void rename(QListWidgetItem* item);
    void removeChosen();
    void editName();

    PresetStore& store_;
    QLineEdit* search_;
    PresetGrid* grid_;
    QToolButton* unfold_;
    QLabel* details_;
    QScrollArea* scroll_;
    QWidget* buttons_;
    QAction *rename_, *remove_;
    QString wanted_; ///< to be chosen once it is there
    bool filling_ = false;
};

} // namespace tactum
