// The presets that there are: those that come with the program, and the user's own as files in one folder.
#pragma once

#include <vector>

#include <QFileSystemWatcher>
#include <QImage>
#include <QObject>
#include <QTimer>

#include "core/presets/preset.h"
#include "ui/base/background_job.h"

namespace tactum {

struct StoredPreset {
    QString file;     ///< its own; a resource of a preset that comes with the program
    bool own = false; ///< may be renamed and removed
    Preset preset;
    QString text;  ///< of the file
    QString words; ///< what a search looks through, in lower case
    QImage picture;

    // For the person: in the language that is on, where it is one of the program's.
    QString name() const;
    QString category() const;
};

/// What a preset is called for the person: in the language that is on where it is one of the program's.
QString shownName(const Preset& preset, const std::vector<StoredPreset>& library);
/// Whether each word of the search is in the preset's words.
bool matches(const StoredPreset& stored, const QString& search);

/// Reads and draws on a worker; follows the folder. Thread: ui.
class PresetStore : public QObject {
    Q_OBJECT
public:
    explicit PresetStore(QObject* parent = nullptr);

    /// Own ones first, then by category and name.
    const std::vector<StoredPreset>& presets() const { return presets_; }
    /// Null for no file of a preset.
    const StoredPreset* find(const QString& file) const;
    static QString folder();
    /// What there is to be read now, without a store: the presets that come with the program, and the user's
    /// own. Thread: any but real time.
    static std::vector<Preset> readAll();
    /// Those alone, or those that come with the program. Thread: likewise.
    static std::vector<Preset> readOwn();
    static std::vector<Preset> readShipped();
    bool loading() const { return job_.running() || reading_.running(); }

    /// Writes a preset into the folder, under a name that is free. Empty when it fails, which it says.
    QString add(const Preset& preset);
    void rename(const StoredPreset& stored, const QString& name);
    /// Puts the file aside, so that takeBack() can bring it again.
    void remove(const StoredPreset& stored);
    void takeBack();
    bool write(const Preset& preset, const QString& file);
    /// Presets and texture models (.xml) become own presets; ends with imported() or failed() for each.
    void importFiles(const QStringList& files);

signals:
    void changed();
    /// `file`: its own, in the folder.
    void imported(const QString& file, const tactum::LoadedPreset& made);
    /// One line for the person.
    void failed(const QString& sentence);

private:
    void load();

    std::vector<StoredPreset> presets_;
    BackgroundJob job_, reading_;
    QFileSystemWatcher watcher_;
    QTimer later_; ///< a folder changes several times for one file
    QString removed_;
    QStringList waiting_; ///< to be imported
    QStringList complained_;
};

} // namespace tactum
