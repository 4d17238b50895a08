// Finds the journals of runs that died, and brings their scenes back.
#pragma once

#include <filesystem>
#include <vector>

#include <QObject>
#include <QString>

#include "core/files/journal.h"
#include "ui/base/background_job.h"

namespace tactum {

class Document;
class Journal;

/// A scene that somebody edited in a run that ended without a save.
struct LostScene {
    std::filesystem::path folder; ///< its journal
    JournalEntry entry;
    bool thrownAway = false; ///< deleted when the program ends
};

/// Thread: ui. Nothing is deleted before the person has thrown it away and the program has ended, and nothing
/// is written over: a recovered scene is one with unsaved changes.
class Recovery : public QObject {
    Q_OBJECT
public:
    Recovery(Document& document, Journal& journal, QObject* parent = nullptr);
    ~Recovery() override;

    /// On a worker; ends with changed() when there is any.
    void look();
    /// Newest first.
    const std::vector<LostScene>& scenes() const { return scenes_; }
    /// Of one of scenes(), which are fewer afterwards when it ends well. Other unsaved changes are lost: ask
    /// before. Ends with recovered() or failed().
    void recover(std::size_t index);
    void throwAway(std::size_t index);
    void bringBack(std::size_t index);

signals:
    /// scenes() are others.
    void changed();
    void recovered(const QString& title, bool withHistory);
    /// One line for the person.
    void failed(const QString& sentence);
    void progressed(double fraction, double secondsLeft);

private:
    struct Found {
        std::vector<LostScene> scenes;
        QStringList sentences;
    };
    static Found search();
    /// Takes the journal away from every other run; false when one of them was quicker.
    bool claim(LostScene& scene);
    void forget(const std::filesystem::path& folder);
    void take(const LostScene& scene, LoadedScene loaded, const Result<SceneHistory>& history);

    Document& document_;
    Journal& journal_;
    std::vector<LostScene> scenes_;
    BackgroundJob job_;
};

/// "cube.obj was not saved: edited until 14:32 today."
QString sentenceOf(const LostScene& scene);

} // namespace tactum
