// The dock "Presets": search, a list with pictures and friction, and where each value comes from.
#pragma once

#include <QByteArray>
#include <QString>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QTreeWidgetItem;

namespace tactum {

class PresetList;
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
    /// What is done with the chosen preset, as a menu of the list and as buttons.
    void addActions(QAction* apply, QAction* save, const QList<QAction*>& others);

signals:
    void chosenChanged();
    /// Double click or Enter.
    void applyAsked();
    void removed(const QString& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< down from the search into the list

private:
    void fill();
    void showChosen();
    void rename(QTreeWidgetItem* item);
    void removeChosen();
    void editName();

    PresetStore& store_;
    QLineEdit* search_;
    PresetList* list_;
    QLabel* details_;
    QWidget* buttons_;
    QAction *rename_, *remove_;
    QString wanted_; ///< to be chosen once it is there
    bool filling_ = false;
};

/// All values of a preset with unit and source, a line each.
QString detailsOf(const StoredPreset& stored);

} // namespace tactum
